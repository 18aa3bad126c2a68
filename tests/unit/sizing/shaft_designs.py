"""Designs with gear pairs of every kind, for the tests of shafts."""

from gearwright.sizing import Sizing, size
from gearwright.spec import parse

OFF_SET = """
schema = 1
name = "off-set"
level = "concept"
shafts = ["input", "left", "right", "output"]
[turbines.turbine]
shaft = "input"
power_kw = 2051
speed_rpm = 20000
[propellers.propeller]
shaft = "output"
speed_rpm = 1212
diameter_m = 3.93
[pairs.first]
pinion = "input"
wheel = ["left", "right"]
halves = 2
pinion_teeth = 15
wheel_teeth = 61
[pairs.second]
pinion = ["left", "right"]
wheel = "output"
pinion_teeth = 15
wheel_teeth = 61
[gears]
helix_angle_deg = 20
"""

SINGLE_HELIX = OFF_SET.replace("halves = 2\n", "")
SPUR = OFF_SET.replace("helix_angle_deg = 20", "helix_angle_deg = 0").replace("= 15", "= 18").replace("= 61", "= 73")
ASKEW = OFF_SET + "[layout.left]\nangle_deg = -30\n[layout.right]\nangle_deg = 200\n"

WITH_MOTOR = (
    OFF_SET.replace('["input", ', '["input", "motor", ').replace("power_kw = 2051", "power_kw = 1046")
    + """
[pairs.boost]
pinion = "motor"
wheel = ["left", "right"]
halves = 2
pinion_teeth = 15
[motors.electric]
shaft = "motor"
power_kw = 1005
speed_rpm = 15000
"""
)

INTERNAL = """
schema = 1
name = "internal"
level = "concept"
shafts = ["input", "output"]
[turbines.turbine]
shaft = "input"
power_kw = 300
speed_rpm = 6000
[propellers.propeller]
shaft = "output"
speed_rpm = 2000
diameter_m = 2.0
[pairs.only]
pinion = "input"
wheel = "output"
internal = true
pinion_teeth = 25
wheel_teeth = 75
[gears]
helix_angle_deg = 15
"""


def sized(text: str) -> Sizing:
    """Return the sized transmission of a design's text."""
    return size(parse(text))
