"""Designs whose shafts have bearings, for the tests of built shafts."""

from gearwright.sizing import Sizing, size
from gearwright.spec import parse

PAIR = """
schema = 1
name = "helical pair in bearings"
shafts = ["input", "output"]
[turbines.engine]
shaft = "input"
power_kw = 322
speed_rpm = 6000
[propellers.rotor]
shaft = "output"
speed_rpm = 1514
diameter_m = 4
thrust_n = 0
in_plane_force_n = 0
hub_moment_nm = 0
[pairs.helical]
pinion = "input"
wheel = "output"
pinion_teeth = 27
wheel_teeth = 107
[gears]
rating = "iso6336"
material = "carburised-9310"
helix_angle_deg = 12
[service]
bearing_life_h = 5000
[layout.input]
length_mm = 160
places = { engine = { position_mm = 0 }, "helical.pinion" = { position_mm = 90 } }
[layout.output]
length_mm = 300
places = { rotor = { position_mm = 260 }, "helical.wheel" = { position_mm = 90 } }
[bearings.1x]
shaft = "input"
position_mm = 15
kind = "four-point"
locates = "both"
radial = false
[bearings.1a]
shaft = "input"
position_mm = 40
[bearings.1b]
shaft = "input"
position_mm = 138
[bearings.2a]
shaft = "output"
position_mm = 32
kind = "taper"
locates = "first"
[bearings.2b]
shaft = "output"
position_mm = 170
kind = "taper"
locates = "second"
[joints."helical.pinion"]
kind = "integral"
[joints."helical.wheel"]
kind = "spline"
"""

ROTOR = PAIR.replace(
    "diameter_m = 4\nthrust_n = 0\nin_plane_force_n = 0\nhub_moment_nm = 0\n",
    "diameter_m = 4\nthrust_kn = 8\nin_plane_force_kn = 0.5\nhub_moment_nm = 300\n",
)
"""The same with the loads of a rotor."""

HELICOPTER = """
schema = 1
name = "helical and bevel pair in bearings"
shafts = ["input", "middle", "mast"]
[turbines.engine]
shaft = "input"
power_kw = 322
speed_rpm = 6000
[propellers.rotor]
shaft = "mast"
speed_rpm = 598.6
diameter_m = 10
thrust_kn = 16.8
in_plane_force_kn = 0.5
hub_moment_nm = 1400
[pairs.helical]
pinion = "input"
wheel = "middle"
pinion_teeth = 27
wheel_teeth = 107
[pairs.bevel]
kind = "bevel"
axis_angle_deg = 90
spiral_angle_deg = 35
pinion = "middle"
wheel = "mast"
pinion_teeth = 17
wheel_teeth = 43
wheel_apex = "first"
gears = { helix_angle_deg = 0 }
[gears]
rating = "iso6336"
material = "carburised-9310"
helix_angle_deg = 12
[service]
mean_load = 0.8
[overrides]
"helical.module_mm" = 2.5
"helical.face_width_mm" = 45
"bevel.outer_module_mm" = 8.5
"bevel.face_width_mm" = 51
[layout.input]
length_mm = 190
places = { engine = { position_mm = 0 }, "helical.pinion" = { position_mm = 118 } }
[layout.middle]
length_mm = 360
bore_ratio = 0.5
places = { "helical.wheel" = { position_mm = 115 }, "bevel.pinion" = { position_mm = 245 } }
[layout.mast]
length_mm = 620
bore_ratio = 0.6
places = { "bevel.wheel" = { position_mm = 120 }, rotor = { position_mm = 620 } }
[bearings.1x]
shaft = "input"
position_mm = 20
kind = "four-point"
locates = "both"
radial = false
[bearings.1a]
shaft = "input"
position_mm = 65
[bearings.1b]
shaft = "input"
position_mm = 165
[bearings.2x]
shaft = "middle"
position_mm = 20
kind = "four-point"
locates = "both"
radial = false
[bearings.2a]
shaft = "middle"
position_mm = 60
[bearings.2b]
shaft = "middle"
position_mm = 320
[bearings.3a]
shaft = "mast"
position_mm = 40
kind = "taper"
locates = "first"
[bearings.3b]
shaft = "mast"
position_mm = 340
kind = "taper"
locates = "second"
[joints."helical.wheel"]
kind = "spline"
[joints."bevel.wheel"]
kind = "spline"
"""
"""Teeth, modules, widths and loads of the sound design of a student project's helicopter; places of our own."""
SPLIT_PATH = """
schema = 1
name = "split path in bearings"
shafts = ["input", "left", "right", "output"]
[turbines.gas-turbine]
shaft = "input"
power_kw = 1046.0
speed_rpm = 20000.0
[motors.electric]
shaft = "input"
power_kw = 1005.0
speed_rpm = 20000.0
[propellers.propeller]
thrust_kn = 25
hub_moment_nm = 8000
shaft = "output"
speed_rpm = 1212.0
diameter_mm = 3930.0
blades = 6
[pairs.first]
pinion = "input"
wheel = ["left", "right"]
pinion_teeth = 62
wheel_teeth = 146
halves = 2
module_mm = 1.5
face_width_mm = 22.0
[pairs.first.gears.iso6336]
least_dynamic_factor = 1.076
[pairs.second]
pinion = ["left", "right"]
wheel = "output"
pinion_teeth = 50
wheel_teeth = 351
halves = 2
module_mm = 2.25
face_width_mm = 25.0
[pairs.second.gears.iso6336]
least_dynamic_factor = 1.104
[gears]
rating = "iso6336"
helix_angle_deg = 20.0
[layout.input]
length_mm = 170
[layout.input.places]
gas-turbine.position_mm = 5
"first.pinion".position_mm = 85
electric.position_mm = 165
[layout.left]
length_mm = 260
[layout.left.places]
"first.wheel".position_mm = 90
"second.pinion".position_mm = 162
[bearings.left-a]
shaft = "left"
position_mm = 45
[bearings.left-b]
shaft = "left"
position_mm = 220
[bearings.left-ax]
shaft = "left"
position_mm = 12
kind = "deep-groove"
locates = "both"
radial = false
[layout.right]
length_mm = 260
[layout.right.places]
"first.wheel".position_mm = 90
"second.pinion".position_mm = 162
[bearings.right-a]
shaft = "right"
position_mm = 45
[bearings.right-b]
shaft = "right"
position_mm = 220
[bearings.right-ax]
shaft = "right"
position_mm = 12
kind = "deep-groove"
locates = "both"
radial = false
[layout.output]
length_mm = 480
[layout.output.places]
"second.wheel".position_mm = 135
propeller.position_mm = 470
[bearings.in-a]
shaft = "input"
position_mm = 40
kind = "deep-groove"
locates = "both"
[bearings.in-b]
shaft = "input"
position_mm = 130
[bearings.out-a]
shaft = "output"
position_mm = 50
[bearings.out-b]
shaft = "output"
position_mm = 240
[bearings.out-thrust]
shaft = "output"
position_mm = 340
kind = "four-point"
locates = "both"
radial = false
[joints]
"first.pinion".kind = "integral"
"second.pinion".kind = "integral"
[service]
life_s = 72000000.0
bearing_life_s = 72000000.0
[shafting]
bore_ratio = 0.7
[bearing_rules]
limits = true
"""
"""Double-helical split path of a turbine and a motor, whose solid wheels outweigh the gearbox as manufactured."""


def sized(text: str) -> Sizing:
    """Return the sized transmission of a design's text."""
    return size(parse(text))


def given(text: str, name: str, line: str) -> str:
    """Return a design with one more line in one of its bearings."""
    head = f"[bearings.{name}]\n"
    assert head in text, name
    return text.replace(head, f"{head}{line}\n", 1)
