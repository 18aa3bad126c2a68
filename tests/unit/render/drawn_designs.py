"""Designs of every kind that a schematic must show."""

from gearwright.sizing import Sizing, size
from gearwright.spec import parse

OFF_SET = """
name = "Off-set"
level = "concept"
shafts = ["input", "left", "right", "output"]
turbines.gas-turbine = { shaft = "input", power_kw = 2051, speed_rpm = 20000 }
propellers.propeller = { shaft = "output", speed_rpm = 1212, diameter_m = 3.93 }
gears.helix_angle_deg = 20
pairs.first = { pinion = "input", wheel = ["left", "right"], halves = 2 }
pairs.second = { pinion = ["left", "right"], wheel = "output", halves = 2 }
"""
MIXED = """
name = "Mixed hybrid"
level = "concept"
shafts = ["input", "lay", "output"]
turbines.gas-turbine = { shaft = "input", power_kw = 1046, speed_rpm = 20000 }
motors.electric = { shaft = "lay", power_kw = 500, speed_rpm = 5000, inertia_kg_m2 = 0.1 }
propellers.propeller = { shaft = "output", speed_rpm = 1250, diameter_m = 3.9 }
pairs.first = { pinion = "input", wheel = "lay" }
planetaries.second = { sun = "lay", ring = "ground", carrier = "output", planets = 5 }
cases.rated = { gas-turbine = { power_kw = 1046 }, electric = { power_kw = 500 } }
cases.charge = { gas-turbine = { power_kw = 1046 }, electric = { power_kw = -200 } }
"""
TWIN = """
name = "Twin engine"
level = "concept"
shafts = ["one", "two", "first-in", "second-in", "output"]
turbines.engine-one = { shaft = "one", power_kw = 700, speed_rpm = 20000 }
turbines.engine-two = { shaft = "two", power_kw = 700, speed_rpm = 20000 }
propellers.rotor = { shaft = "output", speed_rpm = 5000, diameter_m = 10 }
clutches.sprag-one = { driving = "one", driven = "first-in" }
clutches.sprag-two = { driving = "two", driven = "second-in" }
pairs.a = { pinion = "first-in", wheel = "output", pinion_teeth = 20, wheel_teeth = 80 }
pairs.b = { pinion = "second-in", wheel = "a.wheel", pinion_teeth = 20 }
cases.rated = { engine-one = { power_kw = 700 }, engine-two = { power_kw = 700 } }
cases.engine-two-out.engine-one.power_kw = 700
"""
STAR = """
name = "Star"
level = "concept"
shafts = ["input", "output"]
turbines.gas-turbine = { shaft = "input", power_kw = 1046, speed_rpm = 20000 }
propellers.propeller = { shaft = "output", speed_rpm = 6000, diameter_m = 3.9 }
planetaries.only = { sun = "input", ring = "output", carrier = "ground", sun_teeth = 30, planet_teeth = 36 }
"""


def sized(text: str) -> Sizing:
    return size(parse(text))
