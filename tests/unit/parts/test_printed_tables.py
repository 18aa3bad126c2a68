"""Printed tables and coefficients against another source, or a law that the table itself must keep."""

import importlib
import math

import numpy as np
import pytest

from gearwright.parts import agma2001 as factors, stiffness as kuang_yang
from gearwright.parts.agma2001 import AgmaSteel, agma_strength
from gearwright.parts.bearings import life, life as load, rolling_bearing as rating
from gearwright.parts.bearings.rolling_bearing import BearingKind
from gearwright.parts.gears.cylindrical_gear import feed_grade
from gearwright.parts.gears.gear_pair import lewis_form_factor
from gearwright.parts.iso6336 import GearSteel, Treatment, life_factor
from gearwright.parts.iso6336.tooth_strength import slip_layer
from gearwright.parts.material import ROCKWELL, VICKERS, vickers_of_rockwell
from gearwright.parts.shafts import MODULES
from gearwright.units import INCH, POUND_FORCE

E140 = {
    68: 940, 67: 900, 66: 865, 65: 832, 64: 800, 63: 772, 62: 746, 61: 720, 60: 697, 59: 674, 58: 653, 57: 633,
    56: 613, 55: 595, 54: 577, 53: 560, 52: 544, 51: 528, 50: 513, 49: 498, 48: 484, 47: 471, 46: 458, 45: 446,
    44: 434, 43: 423, 42: 412, 41: 402, 40: 392, 39: 382, 38: 372, 37: 363, 36: 354, 35: 345, 34: 336, 33: 327,
    32: 318, 31: 310, 30: 302, 29: 294, 28: 286, 27: 279, 26: 272, 25: 266, 24: 260, 23: 254, 22: 248, 21: 243,
}  # fmt: skip
"""HRC -> HV of steels by ASTM E140, table 1."""


@pytest.mark.parametrize(("rockwell", "vickers"), E140.items())
def test_iso_18265_converts_hardness_as_astm_e140_does(rockwell, vickers):
    """The two standards differ by less than 1 %."""
    assert vickers_of_rockwell(rockwell) == pytest.approx(vickers, rel=0.01)


def test_the_table_of_hardness_has_no_slip():
    """Rockwell rises with Vickers ever more slowly: steps per 10 HV fall from 1.9 to 0.25, each by 0.3 at the most."""
    assert len(ROCKWELL) == len(VICKERS)
    steps = np.diff(ROCKWELL) / np.diff(VICKERS) * 10.0
    smooth = np.convolve(steps, [0.25, 0.5, 0.25], mode="valid")
    assert np.all(np.diff(smooth) < 0.08) and np.all(np.abs(steps[1:-1] - smooth) < 0.13)
    assert set(np.diff(VICKERS[:47])) == {10} and set(np.diff(VICKERS[46:])) == {20}


LEWIS = {
    12: 0.245, 13: 0.261, 14: 0.277, 15: 0.290, 16: 0.296, 17: 0.303, 18: 0.309, 19: 0.314, 20: 0.322, 21: 0.328,
    22: 0.331, 24: 0.337, 26: 0.346, 28: 0.353, 30: 0.359, 34: 0.371, 38: 0.384, 43: 0.397, 50: 0.409, 60: 0.422,
    75: 0.435, 100: 0.447, 150: 0.460, 300: 0.472, 400: 0.480,
}  # fmt: skip
"""Teeth -> Y as Shigley's table 14-2 prints it."""


def test_the_lewis_factor_is_the_printed_one_and_straight_between():
    assert [float(lewis_form_factor(teeth)) for teeth in LEWIS] == list(LEWIS.values())
    assert float(lewis_form_factor(35.0)) == pytest.approx(0.371 + 0.013 / 4.0)
    assert float(lewis_form_factor(900.0)) == 0.480


def test_barths_approximation_follows_the_lewis_factor():
    """Y = 0.484 − 2.87/z for 20° full-depth teeth, printed as π (0.154 − 0.912/z): 9 % above, nowhere below."""
    for teeth in LEWIS:
        assert 0.99 <= (0.484 - 2.87 / teeth) / float(lewis_form_factor(teeth)) <= 1.09


@pytest.mark.parametrize("table", [load.ISO281_2007, load.ISO_R281_1962])
def test_both_branches_of_the_equivalent_load_meet(table):
    """At F_a/F_r = e both give F_r: 0.56 + Y e = 1, to the digits that are printed."""
    for limit, axial in zip(table.limit, table.axial, strict=True):
        assert limit * axial == pytest.approx(0.44, rel=0.025)


def test_limits_of_deep_groove_bearings_are_the_printed_ones():
    new = {
        0.172: 0.19,
        0.345: 0.22,
        0.689: 0.26,
        1.03: 0.28,
        1.38: 0.30,
        2.07: 0.34,
        3.45: 0.38,
        5.17: 0.42,
        6.89: 0.44,
    }
    old = {0.025: 0.22, 0.04: 0.24, 0.07: 0.27, 0.13: 0.31, 0.25: 0.37, 0.5: 0.44}
    for table, printed in ((load.ISO281_2007, new), (load.ISO_R281_1962, old)):
        for relative, limit in printed.items():
            factors_there = load.deep_groove_factors(relative, table)
            assert factors_there.limit == limit
            assert factors_there.radial == 0.56 and factors_there.axial_low == 0.0
            assert factors_there.axial == pytest.approx(0.44 / limit, rel=0.025)


def test_reliability_is_the_weibull_distribution_behind_the_table():
    """a_1 = 0.95 (ln S/ln 0.9)^(2/3) + 0.05 (ISO/TR 1281-2); ISO 281:2007, table 12, rounds it to two digits."""
    for reliability in (0.90, 0.95, 0.96, 0.97, 0.98, 0.99, 0.995, 0.999):
        law = 0.95 * (math.log(reliability) / math.log(0.9)) ** (2.0 / 3.0) + 0.05
        assert life.reliability_factor(reliability) == pytest.approx(law, rel=0.012)
    assert life.reliability_factor(0.985) == pytest.approx(0.31)


def test_modern_steel_raises_ratings_of_balls_more_than_of_rollers():
    """b_m of ISO 281:2007, tables 1 and 6."""
    assert rating.MODERN_STEEL == {
        BearingKind.DEEP_GROOVE: 1.3, BearingKind.FOUR_POINT: 1.3, BearingKind.CYLINDRICAL: 1.1, BearingKind.TAPER: 1.1,
    }  # fmt: skip


@pytest.mark.parametrize(
    ("mounting", "at_10", "at_30"),
    [
        (factors.OPEN_GEARING, 0.247 + 0.167 - 0.00765, 0.247 + 0.501 - 0.06885),
        (factors.COMMERCIAL, 0.127 + 0.158 - 0.01093, 0.127 + 0.474 - 0.09837),
        (factors.PRECISION, 0.0675 + 0.128 - 0.00926, 0.0675 + 0.384 - 0.08334),
        (factors.EXTRA_PRECISION, 0.038 + 0.102 - 0.00822, 0.038 + 0.306 - 0.07398),
    ],
)
def test_load_distribution_of_agma_at_ten_and_thirty_inches(mounting, at_10, at_30):
    """C_pf = F/(10 d) − 0.0375 + 0.0125 F to 17 in, then − 0.1109 + 0.0207 F − 0.000228 F²; F = d here."""
    for inches, alignment, proportion in ((10.0, at_10, 0.1 + 0.0875), (30.0, at_30, 0.1 - 0.1109 + 0.621 - 0.2052)):
        width = inches * INCH
        plain = factors.load_distribution_factor(width, width, mounting=mounting)
        assert float(plain) == pytest.approx(1.0 + proportion + alignment)
        made = factors.load_distribution_factor(
            width, width, mounting=mounting, crowning=0.8, offset=1.1, adjustment=0.8
        )
        assert float(made) == pytest.approx(1.0 + 0.8 * (1.1 * proportion + 0.8 * alignment))


@pytest.mark.parametrize(
    ("curve", "left", "cycles"),
    [
        (factors.BENDING_HB160, 1.6, 1e3), (factors.BENDING_HB250, 2.4, 1e3), (factors.BENDING_HB400, 3.4, 1e3),
        (factors.BENDING_CARBURISED, 2.7, 1e3), (factors.BENDING_NITRIDED, 2.0, 1e3),
        (factors.PITTING, 1.472, 1e4), (factors.PITTING_NITRIDED, 1.1, 1e4),
    ],
)  # fmt: skip
def test_cycle_curves_begin_where_the_figure_does_and_do_not_jump(curve, left, cycles):
    """Figures 17 and 18: Y_N at 1000 cycles, Z_N at 10 000; at 10^10, 0.9 and 0.853; one value at the corner."""
    assert float(life_factor(curve, cycles)) == pytest.approx(left, rel=1e-3)
    corner = 3e6 if left > 1.55 else 1e7
    assert curve.cycles[1] == pytest.approx(corner, rel=0.02)
    below, above = (float(life_factor(curve, corner * part)) for part in (1.0 - 1e-9, 1.0 + 1e-9))
    assert below == pytest.approx(above, rel=3e-4)
    assert float(life_factor(curve, 1e10)) == pytest.approx(0.9 if corner == 3e6 else 0.853, rel=1e-3)


def test_slip_layers_are_those_of_iso_6336_3():
    """ρ′ of table 3 [mm] by yield point [MPa], straight between; hard cases have one value."""
    printed = {
        300: 0.0833,
        400: 0.0445,
        500: 0.0281,
        600: 0.0194,
        800: 0.0064,
        1000: 0.0014,
        700: (0.0194 + 0.0064) / 2,
    }
    for strength, layer in printed.items():
        assert slip_layer(steel(Treatment.THROUGH_HARDENED, strength * 1e6)) == pytest.approx(1e-3 * layer)
    assert slip_layer(steel(Treatment.CASE_HARDENED, None)) == pytest.approx(0.003e-3)
    assert slip_layer(steel(Treatment.NITRIDED, None)) == pytest.approx(0.1005e-3)


def steel(treatment, strength):
    """Return a gear steel with a yield point [Pa]."""
    return GearSteel("", treatment, "MQ", 300.0, 1e9, 3e8, yield_strength=strength)


KSI = 1e3 * POUND_FORCE / INCH**2


@pytest.mark.parametrize(
    ("steel", "grade", "hardness", "bending", "contact"),
    [
        # Shigley, tables 14-3 and 14-6, figures 14-2 to 14-5: lines over HB in psi, or one value in ksi.
        ("through-hardened", 1, 200.0, 77.3 * 0.2 + 12.8, 322.0 * 0.2 + 29.1),
        ("through-hardened", 2, 300.0, 102.0 * 0.3 + 16.4, 349.0 * 0.3 + 34.3),
        ("carburised", 1, 0.0, 55.0, 180.0), ("carburised", 2, 0.0, 65.0, 225.0), ("carburised", 3, 0.0, 75.0, 275.0),
        ("nitrided-4140", 1, 300.0, 82.3 * 0.3 + 12.15, 155.0), ("nitrided-4140", 2, 300.0, 108.6 * 0.3 + 15.89, 168.0),
    ],
)  # fmt: skip
def test_allowable_stresses_of_agma_are_the_printed_ones(steel, grade, hardness, bending, contact):
    strength = agma_strength(AgmaSteel(steel), grade, hardness)
    assert strength.bending == pytest.approx(bending * KSI) and strength.contact == pytest.approx(contact * KSI)


def test_four_point_bearings_have_the_factors_of_35_degrees():
    """ISO 281:2007, table 3, double row: e = 0.95, X = 0.60, Y = 1.07 and 0.66; both branches meet at e."""
    limit, radial, axial, low = load.FOUR_POINT
    assert (limit, radial, axial, low) == (0.95, 0.60, 1.07, 0.66)
    assert 1.0 + low * limit == pytest.approx(radial + axial * limit, rel=0.01)
    assert load.FOUR_POINT_STATIC == (1.0, 0.58) and load.DEEP_GROOVE_STATIC == (0.6, 0.5)


def test_modules_of_splines_are_those_of_din_5480():
    printed = (0.5, 0.6, 0.75, 0.8, 1, 1.25, 1.5, 1.75, 2, 2.5, 3, 4, 5, 6, 8, 10)
    assert [1e3 * module for module in MODULES] == pytest.approx(printed)


@pytest.mark.parametrize("grade", range(4, 10))
def test_the_feed_of_a_cutter_alternates_between_grades(grade):
    """1.26 IT7, IT8, 1.26 IT8, IT9, 1.26 IT9, IT10 of classes 4 to 9 (ISO/TR 10064-2); 1.26 is the step of R10."""
    expected = ((grade + 10) // 2, 1.26) if grade % 2 == 0 else ((grade + 11) // 2, 1.0)
    assert feed_grade(grade) == expected


def test_the_foundation_of_a_tooth_has_the_printed_polynomials():
    """Sainsot, Velex & Duverger 2004, table 1: L*, M*, P* and Q* over θ_f and h_f by six coefficients each."""
    printed = (
        "-5.574e-5 -1.9986e-3 -2.3015e-4 4.7702e-3 0.0271 6.8045 60.111e-5 28.100e-3 -83.431e-4 -9.9256e-3 0.1624"
        " 0.9086 -50.952e-5 185.50e-3 0.0538e-4 53.300e-3 0.2895 0.9236 -6.2042e-5 9.0889e-3 -4.0964e-4 7.8297e-3"
        " -0.1472 0.6904"
    )
    tooth_compliance = importlib.import_module("gearwright.parts.stiffness")
    assert tooth_compliance._BODY.ravel().tolist() == [float(number) for number in printed.split()]


def test_single_stiffness_of_kuang_and_yang_is_that_of_its_cubics():
    """Kuang & Yang 1992 at 20 teeth: A_0 = 25.685, A_1 = 25.52, A_2 = −13.88, A_3 = −19.62 N/(µm mm)."""
    cubics = kuang_yang._CUBICS
    values = [sum(c * 20.0**power for power, c in enumerate(row)) for row in cubics]
    by_hand = [
        3.867 + 32.24 - 11.664 + 1.2424, 17.06 + 14.578 - 6.912 + 0.7944, 2.637 - 24.44 + 8.868 - 0.9432,
        -6.33 - 20.66 + 8.272 - 0.904,
    ]  # fmt: skip
    assert values == pytest.approx(by_hand, abs=2e-3)
    at_40 = [sum(c * 40.0**power for power, c in enumerate(row)) for row in cubics]
    assert at_40 == pytest.approx([31.6302, 24.9232, -18.3166, -21.794], abs=5e-3)
