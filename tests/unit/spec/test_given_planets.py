"""Planetary sets whose teeth are given: whether they can be put together is known before anything is sized."""

import pytest

from designs import HYBRID, changed, problem
from gearwright.spec import parse


def given(planets: int, sun: int, planet: int) -> str:
    return changed(HYBRID, "planets = 3", f"planets = {planets}\nsun_teeth = {sun}\nplanet_teeth = {planet}")


def test_four_planets_between_33_and_69_teeth_cannot_be_assembled():
    """33 + 69 = 102 is no multiple of 4, but one of 2, 3 and 6 (VDI 2157)."""
    found = problem(given(4, 33, 18))
    assert found.path == "planetaries.first.planets"
    assert found.message == (
        "4 planets cannot be assembled at equal places: z_s + z_r = 33 + 69 = 102 is no multiple of 4; give 2 or 3 or 6"
        " planets, unequal_places = true, or other teeth, such as 32/18/68"
    )
    assert parse(given(3, 33, 18)).planetaries["first"].planets == 3


def test_planets_that_touch_are_refused_with_how_many_fit():
    """(30 + 66) sin 45° = 67.9 is below 66 + 2; with 64 teeth, 66.5 is above 66."""
    found = problem(given(4, 30, 66))
    assert found.path == "planetaries.first.planets"
    assert found.message.startswith("4 planets of 66 teeth stand into each other")
    assert found.message.endswith("must be above their tip diameter of 68 modules; give 3 or fewer, or smaller planets")
    assert parse(given(4, 32, 64)).planetaries["first"].planets == 4


@pytest.mark.parametrize("pair", [("sun_teeth", "ring_teeth"), ("planet_teeth", "ring_teeth")])
def test_two_of_three_tooth_numbers_are_enough_to_judge(pair: tuple[str, str]):
    values = {"sun_teeth": 33, "planet_teeth": 18, "ring_teeth": 69}
    teeth = "".join(f"\n{key} = {values[key]}" for key in pair)
    assert "cannot be assembled" in problem(changed(HYBRID, "planets = 3", f"planets = 4{teeth}")).message
