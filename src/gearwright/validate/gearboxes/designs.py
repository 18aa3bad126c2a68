"""Published gearboxes as designs: their power, torque, ratio and kind of stages; what is not published is assumed.

All wind gearboxes: ISO 6336 with 18CrNiMo7-6, S_H = 1.25 and S_F = 1.56 (IEC 61400-4), 200 000 h at 1.1 times the rated
load (WindPACT). Which stages a catalogue's gearbox has is not published: below 1 MW one planetary set and two helical
pairs, as the 750 kW gearbox of the Gearbox Reliability Collaborative; above two sets and a pair, as the 5 MW reference
gearbox. WindPACT's have one set and two pairs. Masses are dry: no oil is in them. The propeller gear of a piston engine
has its published teeth; its life of 2000 h and K_A = 1.25 behind a flexible coupling are assumed.
"""

from __future__ import annotations

import math

from gearwright.catalogue import PublishedGearbox
from gearwright.spec import Design, parse
from gearwright.units import RPM

_HEAD = """schema = 1
name = "{name}"
level = "concept"
"""
_WIND = """shafts = ["main", "second", "third", "fast"]
[rotors.blades]
shaft = "main"
speed_rpm = {slow!r}
diameter_m = 80
blades = 3
[generators.generator]
shaft = "fast"
power_kw = {power!r}
speed_rpm = {fast!r}
[cases.rated]
blades = {{ power_kw = {power!r}, drives = true }}
{stages}
[gears]
material = "18CrNiMo7-6"
rating = "iso6336"
mesh_load_factor = 1.1
[gears.iso6336]
pitting_safety = 1.25
bending_safety = 1.56
tolerance_class = 6
oil_viscosity = 320
oil_temperature = 70
widest_modules = 25
widest_diameters = 1.2
standard_modules = false
[teeth]
split = "optimal"
[shafting]
bore_ratio = 0.4
end_length_mm = {end!r}
middle_length_mm = {middle!r}
bearing_length_mm = {bearing!r}
[service]
life_h = 200000
bearing_life_h = 200000
mean_load = 0.7
application_factor = 1.1
[housing]
material = "cast-iron"
oil_system = "shared"
"""
_SET = """
[planetaries.{name}]
sun = "{sun}"
ring = "ground"
carrier = "{carrier}"
planets = {planets}
{own}"""
_PAIR = """
[pairs.{name}]
pinion = "{pinion}"
wheel = "{wheel}"
{own}
[pairs.{name}.gears]
helix_angle_deg = 10
{rules}"""
_FIRST = _SET.format(name="first", sun="second", carrier="main", planets=3, own="")
_LAST = _PAIR.format(name="last", pinion="fast", wheel="third", own="", rules="")
_SMALL = _FIRST + _PAIR.format(name="middle", pinion="third", wheel="second", own="", rules="") + _LAST
_LARGE = _FIRST + _SET.format(name="middle", sun="third", carrier="second", planets=3, own="") + _LAST
_TEETH = "sun_teeth = {}\nplanet_teeth = {}\nring_teeth = {}\nmodule_mm = {}\nface_width_mm = {}\n{}"
_SIMPACK = (
    # Shifts and centre distances are not published: rings of 93 and 97 teeth close half-way between both references.
    _SET.format(name="first", sun="second", carrier="main", planets=4, own=_TEETH.format(
        23, 34, 93, 25, 520, "centre_distance_mm = 725\n[planetaries.first.gears]\nrim_thickness_ratio = 7.1"))
    + _SET.format(name="middle", sun="third", carrier="second", planets=3, own=_TEETH.format(
        20, 37, 97, 18, 390, "centre_distance_mm = 526\n[planetaries.middle.gears]\nrim_thickness_ratio = 6.9"))
    + _PAIR.format(name="last", pinion="fast", wheel="third",
        own="pinion_teeth = 19\nwheel_teeth = 63\nmodule_mm = 16\nface_width_mm = 280\n", rules="")
)  # fmt: skip
_FAN = """shafts = ["low-pressure", "fan"]
[turbines.turbine]
shaft = "low-pressure"
power_kw = {power!r}
speed_rpm = {fast!r}
[loads.rotor]
shaft = "fan"
speed_rpm = {slow!r}
[planetaries.star]
sun = "low-pressure"
ring = "fan"
carrier = "ground"
planets = 5
[planetaries.star.planet_bearing]
kind = "plain"
largest_pressure_mpa = 14
[gears]
material = "Pyrowear-53"
rating = "iso6336"
mesh_load_factor = 1.1
[gears.iso6336]
pitting_safety = 1.0
bending_safety = 1.2
tolerance_class = 4
standard_modules = false
[shafting]
bore_ratio = 0.8
[service]
life_h = 10000
application_factor = 1.0
[housing]
own = false
oil_system = "shared"
"""
_PROPELLER = """shafts = ["fast", "slow"]
[turbines.engine]
shaft = "fast"
power_kw = {power!r}
speed_rpm = {fast!r}
[loads.propeller]
shaft = "slow"
speed_rpm = {slow!r}
[pairs.only]
pinion = "fast"
wheel = "slow"
pinion_teeth = 29
wheel_teeth = 66
module_mm = 4.2333333333
[gears]
material = "AISI-9310"
rating = "iso6336"
[gears.iso6336]
pitting_safety = 1.0
bending_safety = 1.2
tolerance_class = 5
standard_modules = false
[shafting]
bore_ratio = 0.5
[service]
life_h = 2000
application_factor = 1.25
[housing]
material = "aluminium"
oil_system = "shared"
"""


def design_of(gearbox: PublishedGearbox) -> Design:
    """Return a published gearbox as a design.

    Args:
        gearbox: Its requirement.
    """
    slow = gearbox.power / gearbox.torque / RPM
    size = math.cbrt(gearbox.torque / 1e6)  # lengths of a gearbox grow as the cube root of its torque
    form, stages = _FAN, ""
    if gearbox.kind == "propeller-pair":
        form = _PROPELLER
    elif gearbox.kind != "geared-fan":
        form, stages = _WIND, {"wind-small": _SMALL, "wind-large": _LARGE, "simpack-5mw": _SIMPACK}[gearbox.kind]
    return parse(
        (_HEAD + form).format(
            name=gearbox.name, power=gearbox.power / 1e3, slow=slow, fast=slow * gearbox.ratio, stages=stages,
            end=600.0 * size, middle=250.0 * size, bearing=90.0 * size,
        )
    )  # fmt: skip
