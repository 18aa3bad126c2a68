"""Designs with changed keys are sized and assembled as when ``keys.json`` was written by ``keys.py``."""

import json

import pytest
from keys import FILE, compare
from told import Moved

AT_ONCE = 8
"""Changes that one test looks at."""

STORED = json.loads(FILE.read_text(encoding="utf-8"))
PLACED = list(enumerate(STORED))
BATCHES = [PLACED[start : start + AT_ONCE] for start in range(0, len(STORED), AT_ONCE)]


@pytest.mark.parametrize(
    "batch", BATCHES, ids=lambda batch: f"{batch[0][1]['design']}-{next(iter(batch[0][1]['change']))}"
)
def test_every_key_moves_what_it_moved(batch):
    moved = Moved()
    for place, row in batch:
        compare(moved, row, place)
    assert not moved, moved.message()


def test_a_result_that_moved_is_told_by_its_name():
    """Of a mass a hundredth larger and a result of another name, nothing else is told."""
    row = STORED[0]
    (_, value), *others = row["moves"].items()
    other = row | {
        "results": row["results"] | {"mass": row["results"]["mass"] / 1.01},
        "moves": {"renamed": value, **dict(others)},
    }
    compare(moved := Moved(), other, 0)
    assert [line.rpartition("[")[2].partition("]")[0] for line in moved.changed + moved.removed] == ["mass", "renamed"]
    assert moved.added == []


def test_a_key_that_is_gone_is_told_and_stops_nothing():
    compare(moved := Moved(), STORED[0] | {"change": {"gears.no_such_key": 1}}, 0)
    assert len(moved.removed) == 1 and not moved.changed
