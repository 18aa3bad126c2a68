"""A design that no freedom closes is told with the nearest variant that does, and with what was tried before it."""

from functools import cache
from io import StringIO

import pytest
from rich.console import Console
from test_planet_bearings_chosen import QUICK, SET

from designs import PAIR
from gearwright.closure import Outcome, Wishes, close, nearest_variant
from gearwright.render.answers.review import close_answer
from gearwright.render.words.review import variants_text
from gearwright.reviews import Verdict, review
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import design_text, edited, parse, read

HOUR = 3600.0
VARIANTS = ("in-line-star", "in-line-h1-star", "in-line-h2-star", "off-set-h1-free")
"""Designs that are shipped as they were closed."""
SIZES = ("module_mm", "face_width_mm", "pin_diameter_mm", "plate_thickness_mm", "diameter_mm")
BY_OVERLAP = ("off-set-h1-free", "pairs.motor-stage.face_width_mm")
"""The one width that no strength governs: its overlap ratio is the least that the search takes, 1.15 at 55.24 mm."""
LONG = Wishes(20000 * HOUR, separate=False, lighten=False)


@cache
def fast():
    """The first stage of the thesis's hybrid, whose carrier turns at 4500 rpm, and its variants."""
    design = edited(parse(SET), QUICK | {"propellers.propeller.diameter_m": 1.2})
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


@pytest.mark.parametrize("name", VARIANTS)
def test_the_variants_that_are_shipped_pass_their_review_at_20000_hours(name):
    """Written by ``gearwright close DESIGN --life-h 20000 --variants --out FILE``."""
    design = read(shipped_design(name))
    assert (design.service.life, design.service.bearing_life) == (20000 * HOUR, 20000 * HOUR)
    judged = review(design)
    assert [check.name for check in judged.failing] == []
    assert judged.verdict is Verdict.PASSES_SO_FAR


@cache
def sizes_of(name):
    """Return a shipped variant, and its sizes by their paths [mm]."""
    design = read(shipped_design(name))
    sizes, table = {}, ""
    for line in design_text(design).splitlines():
        table = line.strip("[]") if line.startswith("[") else table
        key, _, value = line.partition(" = ")
        if key in SIZES and not table.startswith("propellers"):
            sizes[f"{table}.{key}"] = float(value)
    return design, sizes


GOVERNED = [row for name in VARIANTS for path in sizes_of(name)[1] if (row := (name, path)) != BY_OVERLAP]


@pytest.mark.parametrize(("name", "path"), GOVERNED)
def test_any_size_of_a_shipped_variant_made_2_percent_less_fails(name, path):
    """Face widths by the next whole millimetre: 1.1 to 3.7 % of them."""
    design, sizes = sizes_of(name)
    less = sizes[path] - 1.0 if path.endswith("face_width_mm") else 0.98 * sizes[path]
    assert failing(edited(design, {path: less})) != []


def failing(design):
    """Return what the sizing of a design says fails."""
    return [check.name for check in size(design).checks if check.fails]


@pytest.mark.parametrize("name", VARIANTS)
def test_every_stage_and_shaft_of_a_shipped_variant_has_its_size_written(name):
    design, sizes = sizes_of(name)
    widths = [path for path in sizes if path.endswith("face_width_mm")]
    assert len(widths) == len(design.simple_stages)
    assert len([path for path in sizes if path.startswith("layout")]) == len(design.shafts)
