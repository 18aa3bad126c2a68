"""Designs at equal life: closed, judged by a review of what was written, those that meet everything first."""

from functools import cache

from designs import PAIR
from gearwright.closure import Wishes
from gearwright.render.tables.study.equal_life import equal_life_table
from gearwright.reviews import Verdict, review
from gearwright.spec import edited, parse
from gearwright.study import equal_life

HOUR = 3600.0
GOOD = edited(parse(PAIR), {"gears.rating": "iso6336"})


@cache
def rows():
    """A pair, the same with a width that does not do, and one whose speeds cannot be had."""
    designs = {
        "narrow": edited(GOOD, {"pairs.stage.module_mm": 2, "pairs.stage.face_width_mm": 12}),
        "impossible": edited(GOOD, {"pairs.stage.pinion_teeth": 20, "pairs.stage.wheel_teeth": 21}),
        "good": GOOD,
    }
    return equal_life(designs, wishes=Wishes(300 * HOUR))


def test_what_meets_everything_comes_first_and_what_cannot_be_last():
    assert [row.design for row in rows()] == ["good", "narrow", "impossible"]
    good, narrow, impossible = rows()
    assert (good.verdict, narrow.verdict) == (str(Verdict.PASSES_SO_FAR), str(Verdict.FAILS))
    assert impossible.verdict == "refused"
    assert impossible.fails
    assert impossible.complete_mass is None


def test_the_written_design_has_the_verdict_of_its_row():
    good, narrow, _ = rows()
    assert str(review(parse(good.file)).verdict) == good.verdict
    assert "stage.pinion pitting" in narrow.fails
    assert good.fails == ""


def test_masses_are_complete_and_stand_in_their_band():
    good, _, _ = rows()
    assert good.lightest < good.complete_mass < good.heaviest
    assert good.life >= 300 * HOUR


def test_the_table_has_a_row_for_each():
    shown = equal_life_table(rows(), "Closed")
    assert [row[0].text for row in shown.rows] == ["good", "narrow", "impossible"]
