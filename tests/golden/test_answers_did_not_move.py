"""Every verb answers about every design what it answered when ``answers.py`` wrote the files in ``answers``."""

import pytest
from answers import FOLDER, answered, differences, stored
from record import designs, sized
from told import FULL, SHOWN, condensed, groups

DESIGNS = designs()


@pytest.mark.parametrize("name", DESIGNS)
def test_answers_did_not_move(name):
    moved = differences(stored(name), answered(sized(name)))
    assert not moved, moved.message()


def test_no_design_is_stored_that_is_gone():
    assert {file.stem for file in FOLDER.glob("*.json")} == set(DESIGNS)


def test_numbers_words_and_signs_all_count():
    """Two records that differ in one value differ; sentences do not count."""
    was, now = {"a": {"kind": True}, "b": [1.5, 2j]}, {"a": {"kind": False}, "b": [1.5, 2j]}
    assert groups(was) != groups(now)
    assert groups("sun") != groups("ring")
    assert groups("a sentence") == {}


def test_a_value_that_moved_is_told_by_its_path_and_part():
    was, now = (groups({"sun": {"mass": mass}, "ring": {"mass": 2.0}}) for mass in (1.0, 1.01))
    assert differences(was, was).message() == ""
    assert "[sun, mass]: 1 -> 1.01" in differences(was, now).message()
    gone = differences(was, groups({"ring": {"mass": 2.0}})).message()
    assert "1 gone" in gone and "moved" not in gone


def test_a_long_list_tells_how_it_moved():
    """Ends, extremes and mean are kept of it, and one value where all are equal; a message stays short."""
    long, other = ({"x": [float(k) * factor for k in range(1, FULL + 2)]} for factor in (1.0, 1.01))
    kept = {path: condensed(group) for path, group in groups(long).items()}
    assert set(kept[""]) == {"count", "first", "last", "least", "greatest", "mean"}
    assert not differences(kept, groups(long))
    assert "[mean]: 21 -> 21.21" in differences(kept, groups(other)).message()
    equal = {path: condensed(group) for path, group in groups([2.0] * 30).items()}
    assert equal == {"": {"all 30": 2.0}}
    assert not differences(equal, groups([2.0] * 30))
    assert f"and {30 - SHOWN} more" in differences(equal, groups([2.02] * 30)).message()
