"""Keys, splines, fatigue and stiffness of shafts against printed tables and worked examples."""

import math

import numpy as np
import pytest

from gearwright.catalogue import key_for_shaft, standard_keys
from gearwright.parts.shaft_fatigue import (
    Concentration,
    FatigueStrength,
    SectionLoad,
    ShaftSection,
    ShaftSteel,
    Shoulder,
    SteelGroup,
    asme_safety,
    endurance_limit,
    fatigue_notch_factor,
    felt_concentration,
    goodman_safety,
    notch_sensitivity,
    section_factor,
    section_stress,
    stress_concentration,
    surface_factors,
    yield_limits,
    yield_safety,
)
from gearwright.parts.shafts import (
    MODULES,
    KeySection,
    Sections,
    critical_speed,
    influence,
    key_length,
    key_pressure,
    spline,
    spline_length,
)
from gearwright.units import GRAVITY, INCH, POUND, POUND_FORCE

POUND_INCH = POUND_FORCE * INCH
KSI = 1000.0 * POUND_FORCE / INCH**2

DIN_6885 = [
    (6, 8, 2, 2, 1.2, 1.0), (8, 10, 3, 3, 1.8, 1.4), (10, 12, 4, 4, 2.5, 1.8), (12, 17, 5, 5, 3.0, 2.3),
    (17, 22, 6, 6, 3.5, 2.8), (22, 30, 8, 7, 4.0, 3.3), (30, 38, 10, 8, 5.0, 3.3), (38, 44, 12, 8, 5.0, 3.3),
    (44, 50, 14, 9, 5.5, 3.8), (50, 58, 16, 10, 6.0, 4.3), (58, 65, 18, 11, 7.0, 4.4), (65, 75, 20, 12, 7.5, 4.9),
    (75, 85, 22, 14, 9.0, 5.4), (85, 95, 25, 14, 9.0, 5.4), (95, 110, 28, 16, 10.0, 6.4),
]  # fmt: skip
"""DIN 6885-1: shaft diameter over and to, b, h, t_1, t_2 in mm."""


@pytest.mark.parametrize("row", DIN_6885)
def test_keys_of_din_6885(row):
    """Every printed number, exactly; both ends of the range of diameters belong to the right key."""
    over, to, *section = row
    for diameter in (over + 0.01, to):
        key = key_for_shaft(diameter / 1e3)
        assert key.section == KeySection(*(value / 1e3 for value in section))
        assert (key.over, key.to) == (over / 1e3, to / 1e3)


def test_key_ranges_leave_no_gap():
    """Every diameter above 6 and up to 230 mm has one key."""
    keys = standard_keys()
    assert [key.to for key in keys[:-1]] == [key.over for key in keys[1:]]


def test_key_pressure_of_din_6892():
    """d = 50, 14 x 9, t_1 = 5.5, l_tr = 56 mm, 500 N m: 102.04 MPa."""
    section = KeySection(14e-3, 9e-3, 5.5e-3, 3.8e-3)
    assert key_pressure(500.0, 0.05, section, bearing_length=0.056) == pytest.approx(102.04e6, rel=1e-4)


@pytest.mark.parametrize(
    ("torque", "diameter", "length"),
    [(512.5166667, 32.0, 71.0), (2050.0666668, 70.0, 87.0), (5185.4627464, 60.0, 288.0)],
)
def test_keys_that_the_colibri_report_should_have(torque, diameter, length):
    """The report's three shafts at 150 MPa, DIN 6885-1 depths; the report prints 4.7, 5.8 and 18.6 mm."""
    section = key_for_shaft(diameter / 1e3).section
    needed = key_length(torque, diameter / 1e3, section, allowable=150e6)
    assert 1e3 * needed == pytest.approx(length, abs=0.5)


@pytest.mark.parametrize(
    ("diameter", "module", "teeth"), [(120, 3, 38), (50, 2, 24), (40, 2, 18), (60, 2, 28), (45, 2, 21)]
)
def test_spline_teeth_of_din_5480(diameter, module, teeth):
    """Designations of the standard: N 120 × 3 × 38, N 50 × 2 × 24, N 40 × 2 × 18, N 60 × 2 × 28, N 45 × 2 × 21."""
    assert spline(diameter / 1e3, module / 1e3).teeth == teeth


def test_modules_of_din_5480():
    """DIN 5480-1, 0.5 to 10 mm."""
    printed = [0.5, 0.6, 0.75, 0.8, 1, 1.25, 1.5, 1.75, 2, 2.5, 3, 4, 5, 6, 8, 10]
    assert [1e3 * module for module in MODULES] == pytest.approx(printed)


def test_spline_of_the_rotor_mast_is_short():
    """5137 N m on 80 mm with module 2 at 100 MPa: some 26 mm, a tenth of the key's 288 mm."""
    length = spline_length(5137.4, spline(0.08, 0.002), allowable=100e6)
    assert 0.02 < length < 0.03


SHIGLEY_7_1 = Shoulder(1.1 * INCH, 1.65 * INCH, 0.11 * INCH)
"""Example 7-1: d = 1.1 in, D = 1.65 in, r = 0.11 in; S_ut = 105, S_y = 82 ksi."""
LOAD_7_1 = SectionLoad(bending_amplitude=1260.0 * POUND_INCH, torque_mean=1100.0 * POUND_INCH)


def test_endurance_limit_of_shigley_example_7_1():
    """k_a = 0.787, k_b = 0.870, k_e = 0.814 (99 %): 29.3 ksi by the printed factors' product, 0.5 % of rounding."""
    limit = endurance_limit(105.0 * KSI, 1.1 * INCH, surface="machined", reliability=0.99)
    assert limit / KSI == pytest.approx(0.787 * 0.870 * 0.814 * 52.5, rel=0.005)


def test_endurance_limits_of_shigley_problems():
    """Problem 7-2: machined, 1226 MPa, 22 mm: 375 MPa (1.24 is rounded by 0.2 %). Ground, 690 MPa: k_a = 0.9065."""
    assert endurance_limit(1226e6, 0.022, surface="machined") == pytest.approx(375e6, rel=4e-3)
    ground = endurance_limit(690e6, 0.032, surface="ground") / (1.24 * 32.0**-0.107 * 345e6)
    assert ground == pytest.approx(0.906473, rel=1e-5)


def test_safeties_of_shigley_example_7_1():
    """K_f = 1.58, K_fs = 1.37 as printed, S_e = 29.3 ksi: Goodman 1.62, ASME 1.88, yield 4.50 (last digit, 1 %)."""
    stress = section_stress(LOAD_7_1, 1.1 * INCH, Concentration(1.58, 1.37))
    strength = FatigueStrength(29.3 * KSI, 105.0 * KSI, 82.0 * KSI)
    assert goodman_safety(stress, strength) == pytest.approx(1.62, rel=0.01)
    assert asme_safety(stress, strength) == pytest.approx(1.88, rel=0.01)
    assert yield_safety(stress, strength) == pytest.approx(4.50, rel=0.01)


def test_notch_sensitivity_of_shigley_example_7_1():
    """q = 0.85 and 0.88 as read from the figures; K_f = 1.58, K_fs = 1.37 with K_t = 1.68 and 1.42."""
    sensitivity = notch_sensitivity(0.11 * INCH, 105.0 * KSI)
    assert sensitivity == pytest.approx((0.85, 0.88), abs=0.01)
    assert felt_concentration(Concentration(1.68, 1.42), sensitivity) == pytest.approx((1.58, 1.37), rel=0.01)


def test_concentration_by_din_743_is_near_petersons_chart():
    """The same shoulder in Shigley's figures A-15-9 and A-15-8: 1.68 and 1.42; the two sources differ by up to 4 %."""
    assert stress_concentration(SHIGLEY_7_1) == pytest.approx((1.68, 1.42), rel=0.04)


def test_diameters_of_shigley_problem_7_1():
    """M_a, M_m, T_a, T_m = 600, 500, 400, 300 lbf in; K_f = 2.2, K_fs = 1.8; S_e, S_y, S_ut = 30, 80, 100 ksi; n = 2.

    Solutions manual of the eighth edition: ASME elliptic 1.012 in, Goodman 1.073 in.
    """
    load = SectionLoad(*(value * POUND_INCH for value in (600.0, 500.0, 400.0, 300.0)))
    strength = FatigueStrength(30.0 * KSI, 100.0 * KSI, 80.0 * KSI)
    notch = Concentration(2.2, 1.8)
    stress = section_stress(load, INCH, notch)
    assert math.cbrt(2.0 / goodman_safety(stress, strength)) == pytest.approx(1.073, abs=6e-4)
    assert math.cbrt(2.0 / asme_safety(stress, strength)) == pytest.approx(1.012, abs=6e-4)


def test_notch_and_size_factors_of_din_743():
    """d = 40, D = 50, r = 2 mm, σ_S = 490 MPa: evaluated independently to 1e-6; no printed example was at hand."""
    shoulder = Shoulder(0.040, 0.050, 0.002)
    assert stress_concentration(shoulder) == pytest.approx((2.0205994638923057, 1.5138689153985025), rel=1e-6)
    assert fatigue_notch_factor(shoulder, 490e6) == pytest.approx((1.8222676509935758, 1.4112481915772264), rel=1e-6)
    assert section_factor(0.040) == pytest.approx(0.8882425877406096, rel=1e-6)
    assert section_factor(0.100) == pytest.approx(0.8270695156364651, rel=1e-6)
    surface = surface_factors(10e-6, 700e6)
    assert surface.bending == pytest.approx(0.8803050302429394, rel=1e-6)
    assert surface.torsion == pytest.approx(0.575 * surface.bending + 0.425)


def test_din_743_against_a_public_program():
    """42CrMo4, d = 42, D = 50, r = 5 mm: β = 1.5286109, 1.2673985; σ_bFK = 943.2056256, τ_tFK = 518.6285923 MPa.

    Printed by ME_Wellennachweis (Huss & Schulz 2023), which takes the larger diameter as the blank.
    """
    notch = fatigue_notch_factor(Shoulder(0.042, 0.050, 0.005), 900e6)
    assert notch == pytest.approx((1.5286109, 1.2673985), abs=1e-6)
    steel = ShaftSteel(1100e6, 900e6, 550e6, 330e6, SteelGroup.TEMPERED)
    limits = yield_limits(ShaftSection(0.042, 0.050, notch), steel)
    assert limits == pytest.approx((943.2056256e6, 518.6285923e6), rel=1e-8)


@pytest.fixture
def shigley_7_5():
    """Return influence coefficients and masses of example 7-5: 1 in shaft, 31 in span, 35 and 55 lbf at 7 and 20 in."""
    shaft = Sections(np.array([0.0, 31.0 * INCH]), np.array([INCH]), np.zeros(1))
    places = np.array([7.0, 20.0]) * INCH
    return influence(shaft, [0.0, 31.0 * INCH], places, elastic_modulus=30e3 * KSI), np.array([35.0, 55.0]) * POUND


def test_influence_coefficients_of_shigley_example_7_5(shigley_7_5):
    """Printed: 2.061, 2.224, 3.534 in 1e-4 in/lbf (four digits)."""
    shown = shigley_7_5[0] / INCH * POUND_FORCE * 1e4
    assert shown == pytest.approx(np.array([[2.061, 2.224], [2.224, 3.534]]), rel=3e-4)


def test_critical_speeds_of_shigley_example_7_5(shigley_7_5):
    """Each mass alone: 231.4 and 140.9 rad/s by the printed coefficients; Dunkerley below, Rayleigh above the root."""
    coefficients, masses = shigley_7_5
    alone = [math.sqrt(GRAVITY / INCH / (weight * delta)) for weight, delta in ((35.0, 2.061e-4), (55.0, 3.534e-4))]
    sagging = coefficients @ masses
    low, high = (masses @ np.diag(coefficients)) ** -0.5, (masses @ sagging**2 / (masses @ sagging)) ** -0.5
    assert low == pytest.approx(1.0 / math.hypot(1.0 / alone[0], 1.0 / alone[1]), rel=1e-3)
    assert low == pytest.approx(120.3, rel=2e-3)
    assert high == pytest.approx(124.7, rel=2e-3)
    assert low < critical_speed(coefficients, masses) <= high
