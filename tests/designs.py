"""Small design files that the tests start from, and what is wrong with a text."""

import pytest

from gearwright.errors import DesignError, Problem
from gearwright.sizing import size
from gearwright.spec import parse

PAIR = """\
schema = 1
name = "one pair"
shafts = ["fast", "slow"]
level = "concept"
[turbines.turbine]
shaft = "fast"
power_kw = 100
speed_rpm = 6000

[propellers.propeller]
shaft = "slow"
speed_rpm = 2000
diameter_m = 2

[pairs.stage]
pinion = "fast"
wheel = "slow"
"""
"""A turbine, a pair, a propeller."""

HYBRID = """\
schema = 1
name = "two planetary stages in line"
shafts = ["input", "middle", "output"]
level = "concept"
[turbines.turbine]
shaft = "input"
power_kw = 1046
speed_rpm = 20000

[motors.electric]
shaft = "middle"
power_kw = 1005
speed_rpm = 4500

[propellers.propeller]
shaft = "output"
speed_rpm = 1212
diameter_m = 3.93
blades = 6

[planetaries.first]
sun = "input"
ring = "ground"
carrier = "middle"
planets = 3

[planetaries.second]
sun = "middle"
ring = "ground"
carrier = "output"
planets = 5

[cases.cruise.turbine]
power_kw = 1046
[cases.cruise.electric]
power_kw = 470.7
[cases.rated.turbine]
rating = 1
[cases.rated.electric]
rating = 1
[cases.rated]
share = 1
[cases.cruise]
share = 0
"""
"""In-Line hybrid 2 of Pulvirenti 2023."""
BRAKED = """\
schema = 1
name = "one set, two gears"
level = "concept"
shafts = ["in", "ring", "out"]
[motors.m]
shaft = "in"
power_kw = 100
speed_rpm = 4000
[loads.wheel]
shaft = "out"
[planetaries.set]
sun = "in"
ring = "ring"
carrier = "out"
sun_teeth = 33
planet_teeth = 18
planets = 3
[clutches.brake]
driving = "ring"
driven = "ground"
kind = "open"
[clutches.lock]
driving = "in"
driven = "ring"
kind = "open"
"""
"""One set with a brake and a clutch, which cases engage; z_r/z_s = 69/33."""
ONE_SET = """\
schema = 1
name = "one set"
level = "concept"
shafts = ["fast", "slow"]
[turbines.turbine]
shaft = "fast"
power_kw = 500
speed_rpm = 6000
[propellers.propeller]
shaft = "slow"
speed_rpm = {speed}
diameter_m = 2
[planetaries.set]
"""
"""The start of one planetary set between a turbine and a propeller of a speed that is open."""


def changed(text: str, old: str, new: str) -> str:
    """Return a text with one passage replaced; the passage must stand in it."""
    assert old in text, old
    return text.replace(old, new, 1)


def problems(text: str, *, sized: bool = False) -> tuple[Problem, ...]:
    """Return what the reader (and the sizing) finds wrong with a text."""
    with pytest.raises(DesignError) as caught:
        design = parse(text)
        if sized:
            size(design)
    return caught.value.problems


def problem(text: str, *, sized: bool = False) -> Problem:
    """Return the one thing that is wrong with a text."""
    (only,) = problems(text, sized=sized)
    return only
