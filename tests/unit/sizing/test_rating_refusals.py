"""What no method rates is told by its place in the file, with what is allowed."""

import pytest

from designs import PAIR, problem

BASE = f'{PAIR}pinion_teeth = 24\nwheel_teeth = 71\n\n[gears]\nrating = "iso6336"\n'


@pytest.mark.parametrize(
    ("rules", "path", "told"),
    [
        ("iso6336 = { flank_roughness_um = 0 }", "gears.iso6336.flank_roughness", "0"),
        ("iso6336 = { root_roughness_um = 0 }", "gears.iso6336.root_roughness", "0"),
        ('iso6336 = { steel = "case-hardened", hardness_hv = 300 }', "gears.iso6336.hardness_hv", "ISO 6336-5 covers"),
        ("iso6336 = { tolerance_class = 12 }", "gears.iso6336.tolerance_class", "11"),
        ("helix_angle_deg = 50", "gears.helix_angle", "45"),
        ("agma2001 = { grade = 2 }", "gears.agma2001", "has no effect with ISO 6336"),
        ("profile_shift = -1.5", "gears.profile_shift", "to 1"),
        ("pressure_angle_deg = 40", "gears.pressure_angle", "14 to 30"),
    ],
)
def test_values_outside_a_method_are_named(rules, path, told):
    found = problem(BASE + rules, sized=True)
    assert path in found.path
    assert told in found.message


@pytest.mark.parametrize("name", ["iso6336-2019", "din3990-1987", "ISO6336", "agma2101"])
def test_an_edition_that_there_is_not_is_told_with_those_that_there_are(name):
    found = problem(BASE.replace("iso6336", name))
    assert found.path == "gears.rating"
    assert f"'{name}' is not known" in found.message
    assert all(f"'{known}'" in found.message for known in ("iso6336", "iso6336-2006", "din3990", "agma2001"))
