"""Wishes that contradict each other are refused, each with the other."""

import pytest

from designs import ONE_SET, PAIR, problem
from gearwright.spec import parse

SET = ONE_SET.format(speed=1900) + 'sun = "fast"\nring = "ground"\ncarrier = "slow"\nplanets = 3\n'


def test_one_pin_has_one_diameter():
    text = SET + '[planetaries.set.planet_bearing]\nkind = "needle"\ndiameter_mm = 40\n[overrides]\n'
    found = problem(text + "set.pin_diameter_mm = 50\n")
    assert found.path == "planetaries.set.planet_bearing.diameter_mm"
    assert found.message == "40 mm, but set.pin_diameter_mm gives the same pin 50 mm; keep one of them"
    assert parse(text + "set.pin_diameter_mm = 40\n")


@pytest.mark.parametrize(("helix", "overlap", "widest"), [(8, 1.5, 20), (20, 1.15, 8)])
def test_an_overlap_that_is_asked_for_has_room_in_the_widest_face(helix, overlap, widest):
    """8°: 1.5 π/sin β = 33.9 modules; 20°: 10.6."""
    rules = f'[gears]\nrating = "iso6336"\nhelix_angle_deg = {helix}\n'
    text = PAIR + rules + f"overlap_ratio = {overlap}\n[gears.iso6336]\nwidest_modules = {widest}\n"
    found = problem(text)
    assert found.path == "gears.overlap_ratio"
    assert f"gears.iso6336.widest_modules allows {widest}" in found.message
    assert parse(text.replace(f"= {widest}\n", "= 40\n"))
    assert parse(text.replace(f"overlap_ratio = {overlap}\n", "")), "the usual overlap yields by itself"
