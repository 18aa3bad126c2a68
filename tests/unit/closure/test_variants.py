"""A design that no freedom closes is told with the nearest variant that does, and with what was tried before it."""

from functools import cache
from io import StringIO

import pytest
from rich.console import Console
from test_planet_bearings_chosen import QUICK, SET

from designs import PAIR
from gearwright.closure import Outcome, Wishes, close, nearest_variant
from gearwright.render.answers.closure import close_answer
from gearwright.render.words.review import variants_text
from gearwright.reviews import Verdict, review
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import design_text, edited, parse, read

HOUR = 3600.0
LONG = Wishes(20000 * HOUR, separate=False, lighten=False)


@cache
def fast():
    """The first stage of the thesis's hybrid, whose carrier turns at 4500 rpm, and its variants."""
    design = edited(parse(SET), QUICK)
    closed = close(design, wishes=LONG)
    return design, closed, nearest_variant(design, closed)


def test_planets_that_live_on_no_bearing_do_where_their_carrier_stands_still():
    _, closed, found = fast()
    assert closed.outcome is Outcome.OPEN
    assert found.nearest.changes == {"planetaries.set.ring": "slow", "planetaries.set.carrier": "ground"}
    assert found.nearest.closed.outcome is Outcome.CLOSED
    lives = [check.name for check in review(parse(design_text(found.nearest.closed.design))).failing]
    assert "set.planet life" not in lives


def test_what_was_tried_before_is_told_with_its_best_margin():
    _, _, found = fast()
    assert [row.what for row in found.tried] == ["4 planets in set", "2 planets in set"]
    assert all("set.planet" in row.why for row in found.tried)
    screen = Console(width=80, file=StringIO())
    screen.print(variants_text(found))
    shown = screen.file.getvalue()
    assert "4 planets in set" in shown and "planetaries.set.carrier = ground" in " ".join(shown.split())


def test_the_answer_has_the_closed_variant_as_a_file():
    _, closed, found = fast()
    answer = close_answer(closed, found)
    assert answer.variant.design_file == design_text(found.nearest.closed.design)
    assert answer.tried == found.tried
    assert close_answer(closed).variant is None


def test_a_design_that_closes_has_no_variant():
    design = edited(parse(PAIR), {"gears.rating": "iso6336"})
    found = nearest_variant(design, close(design, wishes=Wishes(separate=False, lighten=False)))
    assert (found.nearest, found.tried) == (None, ())


@pytest.mark.parametrize("name", ["in-line-star", "in-line-h1-star", "in-line-h2-star", "off-set-h1-free"])
def test_the_variants_that_are_shipped_pass_their_review_at_20000_hours(name):
    """Written by ``gearwright close DESIGN --life-h 20000 --variants --out FILE``."""
    design = read(shipped_design(name))
    assert (design.service.life, design.service.bearing_life) == (20000 * HOUR, 20000 * HOUR)
    judged = review(design)
    assert [check.name for check in judged.failing] == []
    assert judged.verdict is Verdict.PASSES_SO_FAR


@cache
def shipped_star():
    """The lightest of them, and the paths of its sizes [mm]."""
    design = read(shipped_design("in-line-h2-star"))
    lines = design_text(design).splitlines()
    paths, table = {}, ""
    for line in lines:
        if line.startswith("["):
            table = line.strip("[]")
        key, _, value = line.partition(" = ")
        if key in ("module_mm", "face_width_mm", "diameter_mm") and not table.startswith("propellers"):
            paths[f"{table}.{key}"] = float(value)
    return design, paths


@pytest.mark.parametrize("place", range(7))
def test_any_size_of_a_shipped_variant_made_2_percent_less_fails(place):
    """Face widths by the next whole millimetre: 1.5 to 3.4 % of them."""
    design, paths = shipped_star()
    assert len(paths) == 7
    path, value = list(paths.items())[place]
    less = value - 1.0 if path.endswith("face_width_mm") else 0.98 * value
    assert [check.name for check in size(design).checks if check.fails] == []
    assert [check.name for check in size(edited(design, {path: less})).checks if check.fails] != []
