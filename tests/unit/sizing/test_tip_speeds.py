"""Tips of rotors against the fastest that fly."""

import math

import pytest

from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import read


def tips(name):
    """Return the checks of tip speeds of a shipped design."""
    return [check for check in size(read(shipped_design(name))).checks if check.mode == "tip speed"]


def test_the_rotor_of_the_report_turns_too_fast():
    """10 m at 593 rpm, which the report's teeth make of its 600: 311 m/s, Mach 0.91."""
    (tip,) = tips("ec120b-as-reported")
    assert tip.fails
    assert str(tip.part) == "main-rotor"
    assert tip.value == pytest.approx(math.pi / 60.0 * 10.0 * 6000.0 * 15 / 60 * 17 / 43, rel=1e-12)
    assert tip.value / 340.3 > 0.9


def test_rotors_that_fly_pass():
    """The UH-60A has 221 m/s and the EC120B 212 (5 m at 404.9 rpm); wind turbines are far below."""
    (tip,) = tips("ec120b")
    assert not tip.fails
    assert tip.value == pytest.approx(212.0, rel=0.002)
    (tip,) = tips("twin-engine-helicopter")
    assert not tip.fails
    (tip,) = tips("wind-turbine-5mw")
    assert tip.value == pytest.approx(math.pi / 60.0 * 126.0 * 12.1, rel=0.001)
