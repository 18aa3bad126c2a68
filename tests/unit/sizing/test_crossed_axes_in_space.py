"""Where crossed shafts stand, whichever of them is placed first: bevel pairs and face gears, by hand."""

import math

import numpy as np
import pytest

import gearwright as gw

BEVEL = """schema = 1
name = "a bevel pair at an angle"
level = "concept"
shafts = ["{first}", "{second}"]
turbines.turbine = {{ shaft = "{driving}", power_kw = 300, speed_rpm = 6000 }}
propellers.propeller = {{ shaft = "{driven}", speed_rpm = 2000, diameter_m = 3 }}
[pairs.bevel]
kind = "bevel"
axis_angle_deg = {angle}
pinion = "p"
wheel = "w"
pinion_teeth = 19
wheel_teeth = 57
gears.rating = "iso6336"
"""


def vector(place):
    return np.array(place, dtype=float)


def gears_of(sizing, stage):
    """Return frame, gear and the middle of its face on the axis, pinion first."""
    found = []
    for role, shaft in (("pinion", "p"), ("wheel", "w")):
        gear = next(gear for gear in sizing.gears if gear.name == f"{stage}.{role}")
        frame, plan = sizing.arrangement.frames[shaft], sizing.arrangement.plans[shaft]
        found.append((frame, gear, vector(frame.origin) + plan.places[gear.name] * vector(frame.along)))
    return found


@pytest.mark.parametrize("order", [("p", "w"), ("w", "p")])
def test_bevel_shafts_meet_where_both_cones_end(order):
    """R_m cos δ from the middle of each face, tan δ_1 = sin Σ/(u + cos Σ); the angle between both ways is Σ."""
    text = BEVEL.format(first=order[0], second=order[1], driving="p", driven="w", angle=90)
    sizing = gw.size(gw.parse(text))
    shaft_angle = math.radians(90.0)
    small = math.atan(math.sin(shaft_angle) / (3.0 + math.cos(shaft_angle)))
    (one, pinion, first), (two, wheel, second) = gears_of(sizing, "bevel")
    assert abs(vector(one.along) @ vector(two.along)) == pytest.approx(abs(math.cos(shaft_angle)), abs=1e-9)
    mean = 0.5 * pinion.pitch_diameter / math.sin(small)
    assert mean == pytest.approx(0.5 * wheel.pitch_diameter / math.sin(shaft_angle - small))
    reaches = mean * math.cos(small), mean * math.cos(shaft_angle - small)
    ends = [
        [middle + sign * reach * vector(frame.along) for sign in (1.0, -1.0)]
        for (frame, middle), reach in zip(((one, first), (two, second)), reaches, strict=True)
    ]
    apart = {(i, j): np.linalg.norm(ends[0][i] - ends[1][j]) for i in (0, 1) for j in (0, 1)}
    (i, j), least = min(apart.items(), key=lambda item: item[1])
    assert least == pytest.approx(0.0, abs=1e-9)
    apex = ends[0][i]
    ways = [(apex - middle) / np.linalg.norm(apex - middle) for middle in (first, second)]
    assert ways[0] @ ways[1] == pytest.approx(math.cos(shaft_angle), abs=1e-9)
    assert j in (0, 1)


FACE = """schema = 1
name = "a face gear"
level = "concept"
shafts = ["{first}", "{second}"]
turbines.turbine = {{ shaft = "p", power_kw = 300, speed_rpm = 6000 }}
propellers.propeller = {{ shaft = "w", speed_rpm = 2000, diameter_m = 3 }}
[pairs.face]
kind = "face"
axis_angle_deg = 90
pinion = "p"
wheel = "w"
pinion_teeth = 25
wheel_teeth = 75
"""


@pytest.mark.parametrize("order", [("p", "w"), ("w", "p")])
def test_the_pinion_of_a_face_gear_rolls_on_the_wheels_pitch_circle(order):
    """Its axis cuts the wheel's at a right angle, a pitch radius beside the teeth; its middle is r_2 off."""
    sizing = gw.size(gw.parse(FACE.format(first=order[0], second=order[1])))
    (one, pinion, first), (two, wheel, second) = gears_of(sizing, "face")
    along, across = vector(two.along), vector(one.along)
    assert along @ across == pytest.approx(0.0, abs=1e-12)
    off = first - second
    beside = off - (off @ along) * along
    assert np.linalg.norm(beside) == pytest.approx(0.5 * wheel.pitch_diameter, abs=1e-9)
    assert abs(off @ along) == pytest.approx(0.5 * pinion.pitch_diameter, abs=1e-9)
    assert np.linalg.norm(np.cross(beside, across)) == pytest.approx(0.0, abs=1e-9)
