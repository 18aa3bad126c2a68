"""Masses and stiffnesses of an assembled design, computed once more by hand."""

import math

import pytest

from designs import PAIR, changed
from gearwright.catalogue import materials
from gearwright.dynamics.assembly import assemble
from gearwright.sizing import size
from gearwright.spec import parse
from gearwright.units import RPM

MOVING = PAIR + "halves = 2\n[gears]\nhelix_angle_deg = 20\n[supports.slow]\nradial_n_um = 200\n"


def test_a_shaft_on_springs_moves_with_its_own_mass_and_that_of_its_gears():
    sizing = size(parse(MOVING))
    arrays, labels = assemble(sizing).arrays, assemble(sizing).labels
    shaft = next(shaft for shaft in sizing.shafts if shaft.name == "slow")
    wheel = next(gear for gear in sizing.gears if gear.name == "stage.wheel")
    assert wheel.bodies == 2
    across = [mass for mass, unit in zip(arrays.mass, labels.coordinate_units, strict=True) if unit == "m"]
    assert across == [pytest.approx(shaft.mass + 2 * wheel.mass)] * 2


TWO = '[motors.boost]\nshaft = "fast"\npower_kw = 50\nspeed_rpm = 6000\n'
"""A second machine on the fast shaft: each then turns on a stub of its own."""


@pytest.mark.parametrize("hollow", [0.0, 0.6])
def test_a_machine_beside_another_turns_on_a_stub_that_bears_its_torque(hollow):
    """Tresca: 16 T/(π d³ (1 − q⁴)) = R_p0.2/(2 S); K = π G d⁴ (1 − q⁴)/(32 L)."""
    rules = f"[shafting]\nsafety = 1.7\nbore_ratio = {hollow}\nend_length_mm = 80\n"
    sizing = size(parse(changed(PAIR, "[pairs.stage]", f"{TWO}{rules}[pairs.stage]")))
    system = assemble(sizing)
    steel, wall = materials()["nitriding-steel-785"], 1.0 - hollow**4
    stiffness = dict(zip(system.labels.lines, system.arrays.stiffness, strict=True))
    for machine, torque in (("turbine", 100e3 / (6000 * RPM)), ("boost", 50e3 / (6000 * RPM))):
        diameter = (16.0 * torque * 2.0 * 1.7 / (math.pi * wall * steel.yield_strength)) ** (1.0 / 3.0)
        expected = math.pi * steel.shear_modulus * diameter**4 * wall / (32.0 * 0.080)
        assert stiffness[f"{machine} shaft"] == pytest.approx(expected, rel=1e-9)
