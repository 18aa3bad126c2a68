"""What no check says of a sizing: teeth that nobody cuts, planets of which a bearing leaves nothing, given masses."""

import io

import pytest
from rich.console import Console

from designs import HYBRID, PAIR
from gearwright.particulars import particulars
from gearwright.render.answers.design import size_answer
from gearwright.render.pages.report import warnings
from gearwright.render.tables.weights import summary
from gearwright.render.words.sizing import sizing_text
from gearwright.sizing import remarks, size
from gearwright.spec import edited, parse

PLANET = "planetaries.first.planet_bearing"


def test_a_tiny_power_gives_modules_that_nobody_cuts_and_says_so_with_the_path():
    tiny = size(edited(parse(PAIR), {"turbines.turbine.power_kw": 0.0002}))
    (said,) = remarks(tiny)
    assert "Modules below 0.2 mm, which nobody cuts: stage 0.03917 mm" in said
    assert "pairs.stage.module_mm" in said
    assert said in warnings(particulars(tiny), {})
    assert remarks(size(parse(PAIR))) == ()


@pytest.mark.parametrize("kind", ["integral", "plain"])
def test_a_planet_bearing_larger_than_its_planet_is_told_with_its_path(kind):
    sizing = size(edited(parse(HYBRID), {f"{PLANET}.kind": kind, f"{PLANET}.diameter_mm": 500}))
    said = remarks(sizing)
    assert any(words.startswith(PLANET) and "nothing is left of the planet" in words for words in said)
    shown = io.StringIO()
    Console(file=shown, width=4000).print(sizing_text(particulars(sizing)))
    assert all(words in shown.getvalue() for words in said)


def test_a_planet_bearing_that_fits_is_told_by_its_checks_alone():
    assert remarks(size(edited(parse(HYBRID), {f"{PLANET}.designation": "NU 2205"}))) == ()


def test_a_given_mass_of_the_gearbox_stands_for_its_parts_and_not_beside_them():
    sizing = size(parse(PAIR + '\n[overrides]\n"gearbox.mass_kg" = 5\n'))
    assert summary(particulars(sizing)).startswith("5 kg, given, in place of the 6.108 kg of gears 5.805 kg")


def test_the_mass_of_bearings_counts_those_of_planets():
    sizing = size(edited(parse(HYBRID), {f"{PLANET}.designation": "NU 2205"}))
    assert sizing.planet_bearing_mass > 0.0
    assert size_answer(particulars(sizing)).bearing_mass == sizing.planet_bearing_mass
