"""Closures that are broken off and go on, that are closed again, and whose requirement is eased."""

import json

import pytest

from designs import PAIR, changed
from gearwright.closure import Course, Outcome, Source, Wishes, best_so_far, close
from gearwright.errors import DesignError
from gearwright.reviews import review
from gearwright.spec import design_text, edited, parse
from gearwright.study.closing import course_of, digest_of, keep_in

RATED = edited(parse(PAIR), {"gears.rating": "iso6336"})
TEXT = (
    PAIR.replace("diameter_m = 2\n", "diameter_m = 2   # as flown\n")
    + '[gears]\nrating = "iso6336" # against fatigue\n'
)
SET = """\
schema = 1
name = "a set"
shafts = ["fast", "slow"]
[motors.motor]
shaft = "fast"
power_kw = 60
speed_rpm = 6000
[propellers.propeller]
shaft = "slow"
speed_rpm = 1200
diameter_m = 2
[planetaries.set]
sun = "fast"
ring = "ground"
carrier = "slow"
planets = 3
[gears]
rating = "iso6336"
[service]
life_h = 2000
bearing_life_h = 2000
"""
STEPPED = """\
schema = 1
name = "stepped planets"
shafts = ["a", "b"]
[turbines.engine]
shaft = "a"
power_kw = 405
speed_rpm = 19000
[propellers.propeller]
shaft = "b"
speed_rpm = 1423.2
diameter_m = 3
[epicyclics.e]
carrier = "b"
sets = 3
[epicyclics.e.suns.sun]
shaft = "a"
teeth = 24
[epicyclics.e.rings.ring]
shaft = "ground"
teeth = 114
[epicyclics.e.planets.wide]
teeth = 65
meshes = ["sun"]
[epicyclics.e.planets.narrow]
teeth = 25
meshes = ["ring"]
in_one_piece_with = "wide"
[gears]
helix_angle_deg = 0
material = "carburised-9310"
"""


class Broken(Exception):
    """What breaks a closure off, as a signal does."""


def broken_off(after, course, **asked):
    """Run a closure until something lighter has been looked for so often."""
    heard = []

    def tell(words):
        heard.append(words)
        if len(heard) > after:
            raise Broken

    with pytest.raises(Broken):
        close(course=course, tell=tell, **asked)


@pytest.mark.parametrize("after", [2, 3])
def test_a_closure_that_was_broken_off_goes_on_to_the_same_answer(tmp_path, after):
    journal, asked = tmp_path / "journal", digest_of(RATED, Wishes())
    whole = close(RATED)
    first = course_of(journal, asked, RATED)
    broken_off(after, first, design=RATED)
    assert parse(best_so_far(first.best, None, RATED).text)
    keep_in(journal, asked, RATED, first.known)
    again = close(RATED, course=course_of(journal, asked, RATED))
    assert again.text == whole.text
    assert again.effort.from_journal == len(first.known) > 0
    assert again.effort.sizings < whole.effort.sizings


def test_the_journal_of_another_closure_is_refused_with_what_to_do(tmp_path):
    journal = tmp_path / "journal"
    course_of(journal, digest_of(RATED, Wishes()), RATED)
    for other, wishes in ((edited(RATED, {"service.life_h": 9}), Wishes()), (RATED, Wishes(free=("shifts",)))):
        with pytest.raises(DesignError, match=r"begun with another design, wishes or version.*take it away"):
            course_of(journal, digest_of(other, wishes), other)


@pytest.mark.parametrize("damage", [lambda text: text[: len(text) // 2], lambda text: "[]", lambda text: ""])
def test_a_damaged_journal_is_refused_with_what_to_do(tmp_path, damage):
    journal, asked = tmp_path / "journal", digest_of(RATED, Wishes())
    course_of(journal, asked, RATED)
    journal.write_text(damage(journal.read_text(encoding="utf-8")), encoding="utf-8")
    with pytest.raises(DesignError, match=r"cannot be gone on with: .*take it away, or name another file"):
        course_of(journal, asked, RATED)


def test_a_journal_where_none_can_be_is_refused_before_anything_is_sized(tmp_path):
    with pytest.raises(DesignError, match="cannot be written"):
        course_of(tmp_path / "no-such" / "journal", "", RATED)


@pytest.mark.parametrize("text", [TEXT, SET, STEPPED], ids=["pair", "set", "stepped"])
def test_a_closed_design_is_closed_as_it_stands(text):
    closed = close(parse(text), source=Source(text))
    again = close(parse(closed.text), source=Source(closed.text))
    assert not closed.changes_nothing
    assert again.changes_nothing and again.text == closed.text
    assert again.outcome is closed.outcome is Outcome.CLOSED


@pytest.mark.parametrize("text", [TEXT, SET, STEPPED], ids=["pair", "set", "stepped"])
@pytest.mark.parametrize("ease", ["life", "power"])
def test_what_is_asked_less_is_never_heavier_from_what_was_closed_but_for_resonances(text, ease):
    """Less load moves modes: what was clear of a mesh may run in it then, and a closure has to leave it."""
    design = parse(text)
    machine = next(f"{kind}.{name}" for kind in ("turbines", "motors") for name in getattr(design, kind))
    changes = {
        "life": {"service.life_h": 0.5 * design.service.life / 3600.0},
        "power": {f"{machine}.power_kw": 0.8e-3 * next(iter(design.machines.values())).power},
    }[ease]
    before = close(edited(design, {"gears.rating": "iso6336"}))
    eased = close(edited(design, {"gears.rating": "iso6336", **changes}), start=before.design)
    assert eased.outcome is Outcome.CLOSED
    if eased.whole.total > before.whole.total * (1.0 + 1e-9):
        kept = [check.mode for check in review(edited(before.design, changes)).failing]
        assert kept and all(mode.startswith("resonance") for mode in kept)


def test_a_closed_file_is_written_as_a_person_would():
    closed = close(parse(TEXT), source=Source(TEXT), wishes=Wishes(life=5000 * 3600.0))
    assert "diameter_m = 2   # as flown" in closed.text
    assert 'rating = "iso6336" # against fatigue' in closed.text
    assert "life_h = 5000\n" in closed.text
    shafts = [shaft.diameter * 1e3 for shaft in closed.sizing.shafts]
    assert all(abs(2.0 * diameter - round(2.0 * diameter)) < 1e-9 for diameter in shafts)
    digits = [word for word in closed.text.split() if "." in word and word.replace(".", "").isdigit()]
    assert max(map(len, digits)) <= 8
    assert parse(closed.text) == closed.design


def test_modules_of_compound_sets_are_searched_where_their_speeds_are_critical():
    closed = close(parse(STEPPED))
    assert closed.outcome is Outcome.CLOSED
    assert "module of e" in closed.effort.searched
    fixed = close(edited(parse(STEPPED), {"epicyclics.e.suns.sun.module_mm": 2.25}))
    assert fixed.outcome is Outcome.OPEN
    assert {row.searched for row in fixed.unmet} == {"nothing: the design gives all that a closure may change"}


def test_free_teeth_of_pairs_that_share_a_wheel_change_together():
    text = changed(PAIR, 'shafts = ["fast", "slow"]', 'shafts = ["fast", "other", "slow"]')
    text += 'pinion_teeth = 18\n[motors.motor]\nshaft = "other"\npower_kw = 100\nspeed_rpm = 6000\n'
    text += '[pairs.second]\npinion = "other"\nwheel = "stage.wheel"\n[gears]\nrating = "iso6336"\n'
    closed = close(parse(text), wishes=Wishes(free=("teeth",)))
    first, second = closed.sizing.teeth["stage.pinion"], closed.sizing.teeth["second.pinion"]
    assert first == second != 18
    assert "teeth of stage and second" in closed.effort.searched


def test_what_is_counted_is_told():
    course = Course()
    closed = close(RATED, course=course)
    assert closed.effort.sizings == course.sizings > closed.effort.looked_at > closed.effort.confirmed > 0
    assert closed.effort.starts == 1
    assert json.dumps(list(closed.effort.searched))
    assert design_text(closed.design)
