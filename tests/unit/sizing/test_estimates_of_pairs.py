"""What holds the gears of a pair, as sizes are ranked by it: shafts, bearings and bosses, against hand calculations."""

import math

import numpy as np
import pytest

from designs import PAIR
from gearwright import complete_mass, edited, parse, size
from gearwright.catalogue.materials import housing_materials
from gearwright.sizing.rough_mass import GearSeat, ShaftBasis, around_stage, boss_share, held_mass

RATED = edited(parse(PAIR), {"gears.rating": "iso6336", "pairs.stage.pinion_teeth": 30, "pairs.stage.wheel_teeth": 90})
TIED = """\
schema = 1
name = "two pairs in line"
level = "concept"
shafts = ["in", "lay", "out"]
[turbines.turbine]
shaft = "in"
power_kw = 400
speed_rpm = 6000
[propellers.propeller]
shaft = "out"
speed_rpm = 1333.333
diameter_m = 3
[pairs.first]
pinion = "in"
wheel = "lay"
pinion_teeth = 24
wheel_teeth = 54
[pairs.second]
pinion = "lay"
wheel = "out"
pinion_teeth = 26
wheel_teeth = 52
coaxial_with = "first"
[gears]
rating = "iso6336"
[service]
life_h = 2000
"""


def estimated(sizing, stage):
    """Return what holds a pair by the estimate, and the radii and width of its gears."""
    held = around_stage(stage, sizing.design, sizing.train, sizing.flows, 0.0).held
    gears = [gear for gear in sizing.gears if gear.stage == stage]
    return held, [np.asarray(gear.pitch_diameter / 2.0) for gear in gears], np.asarray(gears[0].face_width)


def masses(sizing):
    """Return part -> what all of it weighs complete."""
    return {item.part: item.total for item in complete_mass(sizing).parts}


def test_a_boss_weighs_over_its_bearing_what_it_does_in_the_complete_gearbox():
    sizing = size(RATED)
    complete = complete_mass(sizing)
    share = boss_share(housing_materials()[RATED.housing.material])
    assert masses(sizing)["housing bosses"] == pytest.approx(share * complete.of("bearings"), rel=1e-9)


def test_shafts_and_bearings_by_hand():
    """A force of 10 kN at 0.1 m: M = 10⁴ (0.05 + 0.03)/4 = 200 N m, d³ = 32 √(200² + 1000²)/(π 400e6), l = 0.11 m."""
    held = ShaftBasis((GearSeat(0, 2, 1000.0, 1.0, 1e-6),), 1e4, allowable=400e6, density=8000.0, end=0.03)
    cube = 32.0 * math.hypot(200.0, 1000.0) / (math.pi * 400e6)
    shaft = 8000.0 * math.pi / 4.0 * cube ** (2.0 / 3.0) * 0.11
    by_load = held_mass(held, [np.asarray(0.1)], np.asarray(0.05))
    assert float(by_load) == pytest.approx(2.0 * (1e-6 * 1e4**1.5 + shaft), rel=1e-12)
    by_bore = held_mass(held._replace(per_bore=1e6), [np.asarray(0.1)], np.asarray(0.05))
    assert float(by_bore) == pytest.approx(2.0 * (1e6 * cube + shaft), rel=1e-12)


def test_bearings_and_bosses_are_those_of_the_complete_gearbox():
    """In the middle between bearings; the force along the line of action is 1/cos 20° of that along the circle."""
    sizing = size(RATED)
    held, radii, width = estimated(sizing, "stage")
    alone = held._replace(density=0.0)
    parts = masses(sizing)
    whole = complete_mass(sizing).of("bearings") + parts["housing bosses"]
    assert float(held_mass(alone, radii, width)) == pytest.approx(whole, rel=0.01)


def test_mates_on_both_sides_push_no_shaft():
    text = PAIR.replace('shafts = ["fast", "slow"]', 'shafts = ["fast", "other", "slow"]')
    text = text.replace('pinion = "fast"', 'pinion = ["fast", "other"]')
    text += '[motors.motor]\nshaft = "other"\npower_kw = 100\nspeed_rpm = 6000\n[gears]\nrating = "iso6336"\n'
    held, _, _ = estimated(size(parse(text)), "stage")
    pinion, wheel = held.seats
    assert pinion.push > 0.0 and wheel.push == 0.0


def test_pairs_on_common_axes_are_completed_with_several_modules():
    """Wider faces and smaller modules load bearings and bosses more, which the lightest gears do not tell."""
    sizing = size(parse(TIED))
    assert sizing.search is None or sizing.search.sized >= 1
    best = complete_mass(sizing).total
    modules = {gear.stage: gear.module for gear in sizing.gears}
    for factor in (0.94, 0.97, 1.03, 1.06):
        other = {f"pairs.{name}.module_mm": 1e3 * factor * module for name, module in modules.items()}
        changed = size(edited(parse(TIED), other))
        assert any(check.fails for check in changed.checks) or complete_mass(changed).total > 0.995 * best
