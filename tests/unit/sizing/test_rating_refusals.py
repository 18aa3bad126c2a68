"""What no method rates is told by its place in the file, with what is allowed."""

import pytest

from designs import PAIR, problem
from gearwright.sizing import size
from gearwright.spec import parse

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


FEW = """
name = "few teeth"
{level}
shafts = ["fast", "slow"]
motors.m = {{ shaft = "fast", power_kw = 0.5, speed_rpm = 3000 }}
loads.out = {{ shaft = "slow" }}
{stage}
"""
SET = (
    'planetaries.p = { sun = "fast", ring = "ground", carrier = "slow", planets = 3, sun_teeth = 8, planet_teeth = 22 }'
)
SPUR = 'pairs.p = { pinion = "fast", wheel = "slow", pinion_teeth = 10, wheel_teeth = 20 }'


@pytest.mark.parametrize(
    ("level", "stage", "path"),
    [
        ('level = "concept"', SET, "planetaries.p.gears"),
        ('level = "concept"', SPUR, "pairs.p.gears"),
        ('gears.rating = "agma2001"', SPUR, "pairs.p.gears"),
    ],
)
def test_fewer_teeth_than_lewis_tabulated_are_refused_by_the_methods_that_read_his_table(level, stage, path):
    """Lewis's table begins at 12 teeth, of spur gears; AGMA 2001 takes its size factor from it."""
    found = problem(FEW.format(level=level, stage=stage), sized=True)
    assert found.path == path
    assert "tabulated from 12 teeth on" in found.message and 'rating = "iso6336"' in found.message


@pytest.mark.parametrize(
    ("level", "stage", "gear"),
    [
        ('level = "preliminary"', SET, "p.sun"),
        ('level = "preliminary"', SPUR, "p.pinion"),
        ('level = "concept"\ngears.rating = "iso6336"', SET, "p.sun"),
        ('level = "concept"\ngears.helix_angle_deg = 30', SPUR, "p.pinion"),
    ],
)
def test_few_teeth_are_sized_where_nothing_reads_that_table(level, stage, gear):
    """ISO 6336 knows them, and 10 teeth on a helix of 30° are like 14.7 of a spur gear; undercut is a check."""
    sizing = size(parse(FEW.format(level=level, stage=stage)))
    assert next(each.teeth for each in sizing.gears if each.name == gear) in (8, 10)
