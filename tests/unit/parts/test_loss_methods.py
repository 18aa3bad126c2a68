"""Losses of meshes, bearings, gears and seals by every method: by hand in the units of the sources, and limits."""

import math

import numpy as np
import pytest
from hypothesis import given, strategies as st

from gearwright.parts.bearings import BearingKind
from gearwright.parts.losses import (
    NITRILE,
    LossDuty,
    MeshLaw,
    OilState,
    RunningBearing,
    SeriesFriction,
    anderson_loewenthal_part,
    bearing_torque_skf,
    iso_tr_14179_1_part,
    load_intensity,
    mesh_friction,
    mesh_loss_part,
    seal_power_14179_1,
    seal_power_14179_2,
    seal_power_oil,
    tooth_contact,
    windage_power_dawson,
)
from gearwright.units import RPM

DEGREE = math.pi / 180.0
CONTACT = tooth_contact((30, 90), 3e-3, pressure_angle=20 * DEGREE)
OIL = OilState(8e-3, 950.0, 0.4e-6)
DUTY = LossDuty(300e3, 0.04, 15.0)
near = pytest.approx


def test_the_first_part_of_the_report_by_hand():
    """30/90, m 3, 20°, F_bt/b 300 N/mm, 15 m/s, 8.42 mm²/s: all in mm, N/mm² and m/s as ISO/TR 14179-1 writes them."""
    r_1, r_2, cos, sin = 45.0, 135.0, math.cos(20 * DEGREE), math.sin(20 * DEGREE)
    ratio = 3.0
    start = (ratio + 1.0) * (math.sqrt((138.0 / r_2) ** 2 - cos**2) - sin)
    end = (ratio + 1.0) / ratio * (math.sqrt((48.0 / r_1) ** 2 - cos**2) - sin)
    advantage = 2.0 * cos * (start + end) / (start**2 + end**2)
    torque = 300.0 * 40.0 * cos * r_1 * 1e-3
    intensity = 1000.0 * torque * (30 + 90) / (2.0 * 40.0 * r_1**2 * 90)
    friction = (8e-3 / 950.0 * 1e6) ** -0.223 * intensity**-0.40 / (3.239 * 15.0**0.70)
    assert load_intensity(CONTACT, 300e3) == near(intensity * 1e6, rel=1e-12)
    assert iso_tr_14179_1_part(CONTACT, DUTY, OIL) == near(friction / advantage, rel=1e-12)


def test_outside_its_range_the_first_part_stays_at_the_nearest_end():
    """V from 2 to 25 m/s, K from 1.4 to 14 N/mm²."""
    for slow, fast in ((DUTY._replace(velocity=0.5), DUTY._replace(velocity=2.0)),
                       (DUTY._replace(velocity=60.0), DUTY._replace(velocity=-25.0))):  # fmt: skip
        assert iso_tr_14179_1_part(CONTACT, slow, OIL) == iso_tr_14179_1_part(CONTACT, fast, OIL)
    light, lighter = (DUTY._replace(line_load=load) for load in (1e3, 1e2))
    assert iso_tr_14179_1_part(CONTACT, light, OIL) == iso_tr_14179_1_part(CONTACT, lighter, OIL)
    unit = load_intensity(CONTACT, 1e3) / 1e3
    for end, inside in ((1.4e6, 1.45e6), (14e6, 13.5e6)):
        beyond = end + (end - inside)
        part = [iso_tr_14179_1_part(CONTACT, DUTY._replace(line_load=k / unit), OIL) for k in (beyond, end, inside)]
        assert part[0] == near(part[1], rel=1e-12) and part[2] != near(part[1], rel=1e-4)


def test_schlenks_part_is_his_friction_times_ohlendorfs_factor():
    friction = mesh_friction(CONTACT, 300e3, 15.0, viscosity=8e-3, roughness=0.4e-6)
    assert mesh_loss_part(CONTACT, DUTY, OIL) == friction * CONTACT.loss_factor
    slippery = OIL._replace(lubricant_factor=0.75)
    assert mesh_loss_part(CONTACT, DUTY, slippery) == near(0.75 * friction * CONTACT.loss_factor)


def test_anderson_and_loewenthal_by_their_own_means_come_near_the_path_point_by_point():
    """Their report takes sliding at its mean over the path, which two pairs at its ends share: the integral is less."""
    sum_of_paths, closing = sum(CONTACT.path), CONTACT.closing
    velocity, load, oil = 15.0, 300e3 * 0.04, 8.0
    slide = velocity * closing * sum_of_paths / 4.0
    roll = 2.0 * velocity * math.sin(20 * DEGREE)
    pairs = sum_of_paths / CONTACT.base_pitch
    friction = 0.0127 * math.log10(29.66 * load / 0.04 / pairs / (oil * slide * roll**2))
    film = 2.051e-7 * (roll * oil) ** 0.67 * (load / pairs) ** -0.067 * CONTACT.curvature**0.464
    power = friction * load * slide + 9e7 * film * 0.04 * roll * pairs
    by_hand = power / (load * math.cos(20 * DEGREE) * velocity)
    assert 0.8 * by_hand < anderson_loewenthal_part(CONTACT, DUTY, OIL) < by_hand


def test_the_film_of_anderson_and_loewenthal_is_hamrocks_and_dowsons():
    """2.69 U^0.67 G^0.53 W^-0.067 of line-like ellipses, steel, 2e-8 1/Pa: 2.035e-7 in their units for 2.051e-7."""
    modulus, pressing = 2.28e11, 2e-8
    found = 2.69 * (0.5e-3) ** 0.67 * modulus ** (-0.67 + 0.067) * (pressing * modulus) ** 0.53
    assert found == near(2.051e-7, rel=0.01)


@given(st.sampled_from(list(MeshLaw)), st.floats(2.5, 24.0), st.floats(60e3, 600e3), st.sampled_from((90, -90)))
def test_no_law_loses_more_than_the_sliding_of_full_friction_and_an_internal_mesh_slides_less(
    law, velocity, load, teeth
):
    contact = tooth_contact((30, teeth), 3e-3, pressure_angle=20 * DEGREE)
    part = mesh_loss_part(contact, LossDuty(load, 0.04, velocity), OIL, law=law)
    assert 0.0 < part < 0.2 * CONTACT.loss_factor
    assert mesh_loss_part(contact, LossDuty(-load, 0.04, -velocity), OIL, law=law) == near(part)


@given(st.floats(3.0, 20.0))
def test_part_one_schlenk_and_niemann_lose_less_of_fast_teeth(velocity):
    for law in (MeshLaw.SCHLENK, MeshLaw.NIEMANN_WINTER, MeshLaw.ISO_TR_14179_1):
        slow, fast = (
            mesh_loss_part(CONTACT, DUTY._replace(velocity=v), OIL, law=law) for v in (velocity, 1.2 * velocity)
        )
        assert fast < slow


def test_the_loss_of_every_point_sums_to_the_friction_of_the_path_where_friction_is_constant():
    """With f held at 0.2 (a load beyond all) sliding alone is 0.2 H_V up to the points that stand for the path."""
    heavy = LossDuty(1e26, 0.04, 15.0)
    assert anderson_loewenthal_part(CONTACT, heavy, OIL) == near(0.2 * CONTACT.loss_factor, rel=5e-3)


BALL = SeriesFriction(2.3, 2e-4, (3.7e-7, 1.7, 0.0), (2.84e-3, 92.8, 0.0))
NU = SeriesFriction(2.0, 3e-4, (1.09e-6, 0.0, 0.0), (0.16, 0.0015, 0.0))
TAPER = SeriesFriction(3.0, 4e-4, (1.76e-6, 10.9, 0.0), (0.017, 2.0, 0.0))
QJ = SeriesFriction(3.0, 3.7e-4, (4.78e-7, 2.42, 1.4e-12), (1.2e-2, 0.9, 1.4e-12))


def running(kind, radial, axial=0.0):
    return RunningBearing(kind, 0.045, 0.1, 31.5e3, math.radians(14.0), radial, axial)


def factors(turns, oil, spread):
    heated = 1.0 / (1.0 + 1.84e-9 * (turns * 72.5) ** 1.28 * oil**0.64)
    starved = 1.0 / math.exp(3e-8 * oil * turns * 145.0 * math.sqrt(spread / (2.0 * 55.0)))
    return heated * starved * (oil * turns) ** 0.6


def sliding(turns, oil, full):
    boundary = 1.0 / math.exp(2.6e-8 * (turns * oil) ** 1.4 * 72.5)
    return boundary * 0.12 + (1.0 - boundary) * full


@pytest.mark.parametrize(("radial", "axial"), [(3000.0, 0.0), (3000.0, 1200.0)])
def test_a_deep_groove_bearing_rubs_as_skf_writes_it(radial, axial):
    """6309, 3000/min, 20 mm²/s, in mm, N and N mm, with α_F = 24.6° (F_a/C_0)^0.24."""
    if axial:
        angle = math.sin(math.radians(24.6 * (axial / 31.5e3) ** 0.24))
        rolling = 3.7e-7 * 72.5**1.96 * (radial + 1.7 / angle * axial) ** 0.54
        slides = 2.84e-3 * 72.5**-0.145 * (radial**5 + 92.8 * 72.5**1.5 / angle * axial**4) ** (1.0 / 3.0)
    else:
        rolling = 3.7e-7 * 72.5**1.96 * radial**0.54
        slides = 2.84e-3 * 72.5**-0.26 * radial ** (5.0 / 3.0)
    by_hand = factors(3000.0, 20.0, 3.1) * rolling + slides * sliding(3000.0, 20.0, 0.05)
    bearing = running(BearingKind.DEEP_GROOVE, radial, axial)
    assert bearing_torque_skf(bearing, BALL, -3000 * RPM, viscosity=20e-6) == near(1e-3 * by_hand, rel=1e-12)


def test_roller_and_four_point_bearings_rub_as_skf_writes_them():
    """The same sizes with the constants of NU 2, 302 and QJ 3; Y = 0.4 cot α."""
    cylinder = factors(3000.0, 20.0, 5.1) * 1.09e-6 * 72.5**2.41 * 3000**0.31
    cylinder += 0.0015 * 72.5 * 3000.0 * sliding(3000.0, 20.0, 0.02)
    found = bearing_torque_skf(running(BearingKind.CYLINDRICAL, 3000.0), NU, 3000 * RPM, viscosity=20e-6)
    assert found == near(1e-3 * cylinder, rel=1e-12)
    slope = 0.4 / math.tan(math.radians(14.0))
    taper = factors(3000.0, 20.0, 6.0) * 1.76e-6 * 72.5**2.38 * (3000 + 10.9 * slope * 1200) ** 0.31
    taper += 0.017 * 72.5**0.82 * (3000 + 2 * slope * 1200) * sliding(3000.0, 20.0, 0.002)
    found = bearing_torque_skf(running(BearingKind.TAPER, 3000.0, 1200.0), TAPER, 3000 * RPM, viscosity=20e-6)
    assert found == near(1e-3 * taper, rel=1e-12)
    flung = 1.4e-12 * 72.5**4 * 3000.0**2
    four = factors(3000.0, 20.0, 3.1) * 4.78e-7 * 72.5**1.97 * (flung + 2.42 * 1200) ** 0.54
    four += 1.2e-2 * 72.5**0.26 * (flung ** (4 / 3) + 0.9 * 1200 ** (4 / 3)) * sliding(3000.0, 20.0, 0.05)
    found = bearing_torque_skf(running(BearingKind.FOUR_POINT, 0.0, 1200.0), QJ, 3000 * RPM, viscosity=20e-6)
    assert found == near(1e-3 * four, rel=1e-12)


def test_a_bearing_starts_with_the_friction_of_rest():
    """μ_bl = 0.15 at rest, and no rolling: G_sl μ_bl."""
    still = bearing_torque_skf(running(BearingKind.CYLINDRICAL, 3000.0), NU, 0.0, viscosity=20e-6)
    assert still == near(1e-3 * 0.15 * 0.0015 * 72.5 * 3000.0)


@given(st.floats(100.0, 20e3), st.floats(50.0, 8000.0))
def test_friction_of_bearings_grows_with_the_load(radial, rpm):
    for kind, series in ((BearingKind.DEEP_GROOVE, BALL), (BearingKind.CYLINDRICAL, NU), (BearingKind.TAPER, TAPER)):
        light, heavy = (
            bearing_torque_skf(running(kind, load), series, rpm * RPM, viscosity=20e-6)
            for load in (radial, 1.1 * radial)
        )
        assert heavy > light


def test_dawsons_windage_by_hand():
    """n^2.9 (0.16 D^3.9 + D^2.9 F^0.75 M^1.15) 1e-20 kW, root diameter 300 mm, 40 mm wide, module 4, 6000/min."""
    by_hand = 1e-20 * 6000**2.9 * (0.16 * 300**3.9 + 300**2.9 * 40**0.75 * 4**1.15) * 1e3
    assert windage_power_dawson(0.3, 0.04, -6000 * RPM, module=4e-3) == near(by_hand, rel=1e-12)
    boxed = windage_power_dawson(0.3, 0.04, 6000 * RPM, module=4e-3, enclosure=0.6)
    assert boxed == near(0.6 * by_hand)


def test_seals_by_hand():
    """Ø 60 at 3000/min, Viton: 3.737e-3 · 60 N m; 7.69e-6 d² n W; (145 − 1.6·80 + 350 lg lg 100.8) d² n 1e-7 W."""
    turning = 3000 * RPM
    assert seal_power_14179_1(0.06, turning) == near(3.737e-3 * 60 * turning)
    assert seal_power_14179_1(0.06, turning, torque_per_mm=NITRILE) == near(2.429e-3 * 60 * turning)
    assert seal_power_14179_2(0.06, -turning) == near(7.69e-6 * 3600 * 3000)
    factor = 145 - 1.6 * 80 + 350 * math.log10(math.log10(100.8))
    assert seal_power_oil(0.06, turning, temperature=353.15, viscosity_40=100e-6) == near(factor * 3600 * 3000 * 1e-7)
    hot, thin = ((473.15, 10e-6), (313.15, 1.5e-6))
    for temperature, viscosity in (hot, thin):  # held at half of ISO/TR 14179-2
        held = seal_power_oil(0.06, turning, temperature=temperature, viscosity_40=viscosity)
        assert held == near(0.5 * seal_power_14179_2(0.06, turning))


def test_the_points_of_the_path_share_the_load_of_the_pairs_in_contact():
    """ε_α between 1 and 2: the mean number of pairs over the path, each counted, is what keeps F the same."""
    from gearwright.parts.losses import _pairs_in_contact

    place, pairs = _pairs_in_contact(CONTACT)
    ratio = sum(CONTACT.path) / CONTACT.base_pitch
    assert set(pairs) == {1.0, 2.0}
    assert np.mean(1.0 / pairs) * ratio == near(1.0, abs=0.01)
    assert place[0] > -CONTACT.path[0] and place[-1] < CONTACT.path[1]
