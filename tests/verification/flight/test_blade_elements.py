"""Blade elements against momentum, the actuator disc, symmetry, and limits that can be told by hand."""

import math

import numpy as np
import pytest

from gearwright.machines import Blades, ideal_power
from gearwright.machines.propellers import SectionLoads, generic_blade, loads, section_loads

FOUR = generic_blade(Blades(4, 150.0, 0.5))
SPAN = np.radians(np.linspace(-60.0, 90.0, 151))
RATIOS = np.array([0.0, 0.02, 0.3, 1.0, 2.0, 4.0, 8.0])


def test_every_state_has_an_answer():
    """Standstill to a dead-slow rotor, reversed to feathered: every number finite, the equations met (below)."""
    found = loads(FOUR, RATIOS[:, None], SPAN)
    assert np.isfinite(found.thrust).all()
    assert np.isfinite(found.power).all()
    assert np.isfinite(found.swirl).all()


def test_thrust_and_torque_are_the_streams_change_of_momentum():
    """dT = 4 F ρ 2πr (V+u) u, dQ = 4 F ρ 2πr² (V+u) v without tip loss and turbulence: rounding, 1e-6."""
    shape = FOUR._replace(losses=False)
    ratio = np.array([0.3, 1.0, 2.0])
    found = loads(shape, ratio, np.radians([20.0, 30.0, 45.0]))
    through = found.axial + ratio[:, None] / math.pi
    # In units of the tip speed: T/(ρ n² D⁴) = π² 4π x (V+u) u/4 dx, P likewise times 2π · x/2.
    thrust = math.pi**3 * shape.radius * through * found.axial
    power = math.pi**4 * shape.radius**2 * through * found.swirl
    assert found.element_thrust == pytest.approx(thrust, rel=1e-6, abs=1e-9)
    assert found.element_power == pytest.approx(power, rel=1e-6, abs=1e-9)


def test_no_propeller_beats_the_actuator_disc():
    """Froude's power bounds every driving point, with losses and even with a section that has no drag."""

    def slick(angle, design_lift, thickness, mach):
        found = section_loads(angle, design_lift, thickness, mach)
        return SectionLoads(found.lift, 0.0 * found.drag)

    for shape in (FOUR, FOUR._replace(polar=slick, losses=False)):
        for ratio in RATIOS:
            found = loads(shape, ratio, SPAN)
            driving = found.thrust > 0.0
            least = [ideal_power(float(ratio), float(thrust)) for thrust in found.thrust[driving]]
            assert (found.power[driving] >= np.array(least) * (1.0 - 1e-9)).all()


def test_a_windmill_takes_less_than_betz():
    """A windmill's power stays below 16/27 of the stream's, π/8 · 16/27 J³ in coefficients."""
    for ratio in (1.0, 2.0, 4.0):
        found = loads(FOUR, ratio, SPAN)
        assert -found.power.min() <= 16.0 / 27.0 * math.pi / 8.0 * ratio**3
        assert found.power.min() < 0.0


def test_a_flat_blade_reversed_gives_its_thrust_backwards_in_hover():
    """Untwisted symmetric sections: C_T is odd and C_P even in the blade angle at standstill; rounding, 1e-6."""
    shape = FOUR._replace(twist=0.0 * FOUR.twist, design_lift=0.0 * FOUR.design_lift)
    shape = shape._replace(polar=_symmetric)
    ahead, back = (loads(shape, 0.0, np.radians(sign * np.array([5.0, 12.0, 25.0]))) for sign in (1.0, -1.0))
    assert back.thrust == pytest.approx(-ahead.thrust, rel=1e-6)
    assert back.power == pytest.approx(ahead.power, rel=1e-6)


def _symmetric(angle, design_lift, thickness, mach):
    del design_lift, thickness, mach
    return SectionLoads(2.0 * np.sin(2.0 * angle), 0.01 + 1.2 * np.sin(angle) ** 2)


def test_hover_is_the_limit_of_slow_flight():
    """J = 1e-6 beside J = 0: 1e-4 of the thrust."""
    still, slow = (loads(FOUR, ratio, np.radians([10.0, 20.0, 30.0])) for ratio in (0.0, 1e-6))
    assert slow.thrust == pytest.approx(still.thrust, rel=1e-4)
    assert slow.power == pytest.approx(still.power, rel=1e-4)


def test_feathered_blades_hardly_drag():
    """Where a blade at J = 8 takes no power, its drag is below a tenth of the flat blades'."""
    angles = np.radians(np.linspace(60.0, 90.0, 301))
    row = loads(FOUR, 8.0, angles)
    feathered = row.thrust[np.argmin(np.abs(row.power))]
    flat = loads(FOUR, 8.0, math.radians(20.0)).thrust
    assert flat < feathered < 0.0
    assert feathered / flat < 0.1


def test_mach_number_raises_lift_then_drag():
    """Prandtl-Glauert at a tip Mach of 0.5, drag rise at 0.95: less thrust for more power at one angle."""
    slow, middle, fast = (loads(FOUR, 0.5, math.radians(20.0), mach) for mach in (0.0, 0.5, 0.95))
    assert middle.thrust > slow.thrust
    assert fast.thrust / fast.power < 0.97 * middle.thrust / middle.power
