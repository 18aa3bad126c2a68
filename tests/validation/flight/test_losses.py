"""Published losses of gears, and limits that a loss model must keep."""

import math

import pytest

from gearwright.parts.gears import ToothShift
from gearwright.parts.losses import (
    HIGHEST_FRICTION,
    bearing_torque_constant,
    bearing_torque_palmgren,
    churning_power,
    cooler_conductance,
    mesh_efficiency,
    mesh_friction,
    oil_flow,
    oil_viscosity,
    tip_contact_ratio,
    tooth_contact,
    tooth_loss_factor,
    windage_power,
)

DEGREE = math.pi / 180.0


def test_the_fzg_type_c_gears_have_their_published_loss_factor():
    """Fernandes et al. (2014), C40 gears: H_V 0.1949 and ε_α 1.44; 1 % and half a unit of the printed digit."""
    module, teeth, centre = 4.5e-3, (16, 24), 91.5e-3
    radii = [0.5 * module * z * math.cos(20 * DEGREE) for z in teeth]
    angle = math.acos(sum(radii) / centre)
    ratios = [
        tip_contact_ratio(z, tip, base, angle) for z, tip, base in zip(teeth, (41.23e-3, 59.18e-3), radii, strict=True)
    ]
    assert sum(ratios) == pytest.approx(1.44, abs=0.005)
    assert tooth_loss_factor(teeth, 0.0, approach=ratios[1], recess=ratios[0]) == pytest.approx(0.195, rel=0.01)


@pytest.mark.parametrize(("shift", "factor"), [(0.0, 0.1670), (0.4, 0.1769)])
def test_profile_shift_changes_the_loss_factor_as_by_hand(shift, factor):
    """18/54, 20°, module 1: ε = z/2π (√(r_a²/r_b² − 1) − tan 20°) with r_a = 9 + 1 + x and 27 + 1 − x, r_b = r cos 20°;
    H_V = π (1/18 + 1/54)(1 − ε_α + ε_1² + ε_2²); rounded to the fourth digit.
    """
    contact = tooth_contact((18, 54), 1.0, pressure_angle=20 * DEGREE, shifts=(ToothShift(shift), ToothShift(-shift)))
    assert contact.loss_factor == pytest.approx(factor, abs=5e-5)


def test_an_internal_mesh_loses_less_than_an_external_one():
    """The sliding is that of the difference of the curvatures: (1/z_1 - 1/|z_2|)."""
    outer = tooth_contact((30, 90), 3e-3, pressure_angle=20 * DEGREE)
    inner = tooth_contact((30, -90), 3e-3, pressure_angle=20 * DEGREE)
    assert 0.4 < inner.loss_factor / outer.loss_factor < 0.7


def test_a_well_lubricated_mesh_loses_less_than_a_hundredth():
    """FZG tests: friction of ground gears in oil lies between 0.03 and 0.08 (Niemann and Winter 2003, fig. 21.6)."""
    contact = tooth_contact((30, 90), 3e-3, pressure_angle=20 * DEGREE)
    friction = mesh_friction(contact, 300e3, 20.0, viscosity=8e-3, roughness=0.4e-6)
    assert 0.015 < friction < 0.08
    assert 0.99 < mesh_efficiency(contact, friction) < 1.0


def test_friction_stays_finite_at_rest():
    contact = tooth_contact((30, 90), 3e-3, pressure_angle=20 * DEGREE)
    assert mesh_friction(contact, 300e3, 0.0, viscosity=8e-3, roughness=0.4e-6) <= HIGHEST_FRICTION
    assert mesh_friction(contact, 0.0, 20.0, viscosity=8e-3, roughness=0.4e-6) == 0.0


FACTORS = {"oil_factor": 2.0, "load_factor": 3e-4}


def test_palmgrens_torque_is_the_sum_of_its_two_parts_by_hand():
    """d_m 65 mm, 1500/min, 40 mm²/s, f_0 = 2, f_1 = 3e-4, 5 kN: 1e-7·2·60000^(2/3)·65³ + 3e-4·5000·65 N mm."""
    by_hand = 1e-7 * 2 * 60000 ** (2 / 3) * 65**3 + 3e-4 * 5000 * 65
    found = bearing_torque_palmgren(5000.0, 0.065, 1500 * math.pi / 30, viscosity=40e-6, **FACTORS)
    assert found == pytest.approx(by_hand * 1e-3, rel=1e-12)
    assert bearing_torque_palmgren(0.0, 0.065, 0.0, viscosity=40e-6, **FACTORS) == 0.0
    assert bearing_torque_constant(2000.0, 0.05) == pytest.approx(0.5 * 0.0011 * 2000 * 0.05)


def test_windage_and_churning_have_the_exponents_of_their_sources():
    """Anderson and Loewenthal: n^2.8; ISO/TR 14179-1: n³; exact powers."""
    slow, fast = (windage_power(0.1, 0.04, speed, viscosity=5e-3) for speed in (1000.0, 2000.0))
    assert fast / slow == pytest.approx(2**2.8, rel=1e-12)
    slow, fast = (churning_power(0.2, 0.04, speed, viscosity=5e-6, dip=0.2, module=3e-3) for speed in (100.0, 200.0))
    assert fast / slow == pytest.approx(8.0, rel=1e-12)
    assert churning_power(0.2, 0.04, 100.0, viscosity=5e-6, dip=0.0, module=3e-3) == 0.0


def test_oil_carries_the_heat_that_it_is_given():
    assert oil_flow(19e3, 20.0) == pytest.approx(5e-4)
    assert cooler_conductance(10e3, 380.0, 280.0) == 100.0
    assert oil_viscosity(313.15) == pytest.approx(26e-6, rel=1e-9)
    assert oil_viscosity(353.15) > oil_viscosity(373.15)
