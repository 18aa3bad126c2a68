"""A small helicopter train whose shafts, bearings and joints are given by hand, for tests of drawings."""

from dataclasses import replace

from gearwright.catalogue import bearing
from gearwright.sizing import BearingSizing, BuiltShaft, JointSizing, ShaftStep, size
from gearwright.spec import parse

DESIGN = """\
schema = 1
name = "Helical and bevel pair"
shafts = ["engine", "middle", "mast"]
level = "concept"
[turbines.turbine]
shaft = "engine"
power_kw = 322
speed_rpm = 6000

[propellers.rotor]
shaft = "mast"
speed_rpm = 600
diameter_m = 10
blades = 3

[pairs.helical]
pinion = "engine"
wheel = "middle"
pinion_teeth = 27
wheel_teeth = 107

[pairs.bevel]
kind = "bevel"
pinion = "middle"
wheel = "mast"
pinion_teeth = 17
wheel_teeth = 43
axis_angle_deg = 90
spiral_angle_deg = 35

[pairs.bevel.gears]
helix_angle_deg = 0

[gears]
helix_angle_deg = 12
rating = "iso6336"
material = "carburised-9310"

[layout.engine]
length_mm = 190
places = {"helical.pinion" = {position_mm = 119}}

[layout.middle]
length_mm = 240
places = {"helical.wheel" = {position_mm = 63}, "bevel.pinion" = {position_mm = 209}}

[layout.mast]
length_mm = 420
places = {"bevel.wheel" = {position_mm = 120}}
"""

STEPS = {
    "engine": (
        *((0, 60, 40, "turbine"), (60, 83, 45, "1a"), (83, 88, 52, ""), (88, 150, 58, "helical.pinion")),
        *((150, 155, 52, ""), (155, 178, 45, "1b"), (178, 190, 40, "")),
    ),
    "middle": (
        *((0, 28, 60, "2a"), (28, 36, 72, ""), (36, 90, 66, "helical.wheel"), (90, 150, 62, "")),
        *((150, 178, 60, "2b"), (178, 240, 50, "bevel.pinion")),
    ),
    "mast": (
        *((0, 36, 80, "3a"), (36, 60, 92, ""), (60, 170, 100, "bevel.wheel"), (170, 200, 105, "")),
        *((200, 245, 90, "3b"), (245, 420, 80, "rotor")),
    ),
}
"""Shaft -> steps: from, to, diameter [mm], what sits there."""
BORES = {"engine": 15, "middle": 30, "mast": 40}
"""Shaft -> bore [mm]."""
BEARINGS = (
    *(("1a", "engine", 71.5, "NU 2209"), ("1b", "engine", 166.5, "6209"), ("2a", "middle", 14, "QJ 312")),
    *(("2b", "middle", 164, "NU 2212"), ("3a", "mast", 18, "33016"), ("3b", "mast", 222.5, "33118")),
)
JOINTS = (
    ("turbine", "engine", 30, "spline", "DIN 5480 - W 40 x 2 x 18", 40, 32, "", 2),
    ("helical.pinion", "engine", 119, "integral", "", 58, 45),
    ("helical.wheel", "middle", 63, "key", "DIN 6885 - A 20 x 12 x 50", 66, 50, "A"),
    ("bevel.pinion", "middle", 209, "integral", "", 50, 50),
    ("bevel.wheel", "mast", 115, "spline", "DIN 5480 - W 100 x 3 x 32", 100, 60, "", 3),
)


def _built(name):
    steps = tuple(ShaftStep(start / 1e3, end / 1e3, across / 1e3, seat) for start, end, across, seat in STEPS[name])
    return BuiltShaft(name, steps, BORES[name] / 1e3, (), (), (), None, 0.0)


def _seated(name, shaft, position, designation):
    return BearingSizing(name, shaft, position / 1e3, bearing(designation), "rated", 1e3, 0.0, 1e3, 1e7, 1e7, 2.0, 1.5)


def _joined(part, shaft, position, kind, designation, diameter, length, form="", module=0):
    sized = (part, shaft, position / 1e3, kind, designation, 500.0, diameter / 1e3, length / 1e3, 1e7, 1e8)
    return JointSizing(*sized, form=form, module=module / 1e3)


def built_sizing():
    """Return the train with shafts as a workshop would get them."""
    return replace(
        size(parse(DESIGN)),
        built_shafts=tuple(_built(name) for name in STEPS),
        bearings=tuple(_seated(*row) for row in BEARINGS),
        joints=tuple(_joined(*row) for row in JOINTS),
    )
