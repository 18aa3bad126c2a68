"""Rolling bearings against printed tables and worked cases: ISO 281, ISO 76, ISO/TS 16281, Shigley, SKF."""

import math

import pytest

from gearwright.parts.bearings import (
    ISO_R281_1962,
    BearingGeometry,
    BearingKind,
    FactorTable,
    ball_dynamic_factor,
    basic_life,
    deep_groove_factors,
    dynamic_rating,
    equivalent_load,
    life_modification,
    load_distribution,
    reference_viscosity,
    static_rating,
    taper_factors,
)
from gearwright.units import RPM
from gearwright.validate.shafts import BALL_FACTORS, REFERENCE, REFERENCE_LIVES, inside


def test_ball_factors_within_a_thousandth_where_print_allows():
    """From 0.05 on the printed digit is fine enough to ask for 0.1 % (0.15 % is half a digit below 0.03)."""
    for step, printed in enumerate(BALL_FACTORS, start=1):
        if step >= 5:
            computed = ball_dynamic_factor(inside(BearingKind.DEEP_GROOVE, step / 100))
            assert computed == pytest.approx(printed, rel=1e-3)


def test_ratings_of_a_6309():
    """Z = 8, D_w = 17.462 mm, D_pw = 72.5 mm: catalogues print C = 52.7 to 53 kN and C_0 = 31.5 to 32 kN."""
    geometry = BearingGeometry(BearingKind.DEEP_GROOVE, 8, 17.462e-3, 72.5e-3)
    assert dynamic_rating(geometry) == pytest.approx(53.0e3, rel=0.01)
    assert static_rating(geometry) == pytest.approx(31.5e3, rel=0.01)


MOTIONS = {
    "radial, no clearance": {"radial": 15.1101},
    "axial, no clearance": {"axial": 133.5381},
    "radial": {"radial": 21.223},
    "axial": {"axial": 149.1717},
    "both": {"radial": 19.5923, "axial": 146.4603, "tilt": 2.6872},
    "couple, no clearance": {"tilt": 3.6957},
    "all": {"radial": 19.7144, "axial": 146.3084, "tilt": 2.7239},
}
"""Motions of the rings in the program MASTA, in minzhun/ISO16281 (µm, mrad); its lives are published cases."""


@pytest.mark.parametrize("case", MOTIONS)
def test_load_distribution_against_a_commercial_program(case):
    """ISO/TS 16281 with clearance, thrust and tilt: motions within 0.1 %.

    The program tilts the ring about an arm of D_pw/2; the standard's is R_i = D_pw/2 + (r_i − D_w/2) cos α_0, 1.05 %
    longer. What the tilt does at the groove, ψ times the arm, is the same in all three cases.
    """
    clearance, load, _ = REFERENCE_LIVES[case]
    found = load_distribution(REFERENCE, load, clearance=clearance)
    arm = 21.75 + 0.23 * (1.0 - clearance / (2.0 * 0.05 * 11.5e-3))
    shown = {
        "radial": 1e6 * found.motion.radial,
        "axial": 1e6 * found.motion.axial,
        "tilt": 1e3 * found.motion.tilt * arm / 21.75,
    }
    for name, value in MOTIONS[case].items():
        assert shown[name] == pytest.approx(value, rel=1e-3)


def test_equivalent_load_of_shigley():
    """Shigley, ch. 11: 02-30 mm, C_0 = 10 kN, 5 kN radial, 2 kN axial: Y = 1.266, P = 5.34 kN (printed so)."""
    printed = FactorTable((0.17, 0.28), (0.34, 0.38), (1.31, 1.15))  # table 11-1, the two rows between which it reads
    factors = deep_groove_factors(2.0 / 10.0, printed)
    assert factors.axial == pytest.approx(1.266, abs=5e-4)
    assert equivalent_load(5e3, 2e3, factors) == pytest.approx(5.34e3, abs=10.0)


def test_factors_of_the_colibri_report():
    """The report reads e = 0.3994 at F_a/C_0 = 0.355 and e = 0.37 at 0.25 from ISO/R 281."""
    assert deep_groove_factors(0.355, ISO_R281_1962).limit == pytest.approx(0.3994, abs=5e-5)
    assert deep_groove_factors(0.25, ISO_R281_1962).limit == 0.37


def test_factors_of_iso_r_281():
    """The six printed nodes: F_a/C_0, e, Y."""
    printed = [
        (0.025, 0.22, 2.0),
        (0.04, 0.24, 1.8),
        (0.07, 0.27, 1.6),
        (0.13, 0.31, 1.4),
        (0.25, 0.37, 1.2),
        (0.5, 0.44, 1),
    ]
    for relative, limit, axial in printed:
        factors = deep_groove_factors(relative, ISO_R281_1962)
        assert (factors.limit, factors.axial) == (limit, axial)


@pytest.mark.parametrize(
    ("relative", "limit", "axial"), [(0.172, 0.19, 2.30), (1.38, 0.30, 1.45), (6.89, 0.44, 1.00), (9.0, 0.44, 1.00)]
)
def test_factors_of_iso_281_table_3(relative, limit, axial):
    """Printed nodes, and the last one beyond the table."""
    factors = deep_groove_factors(relative)
    assert (factors.limit, factors.radial, factors.axial) == (limit, 0.56, axial)


def test_taper_factors_of_a_30204():
    """α = 12.95°: catalogues print e = 0.35 and Y = 1.7, two digits."""
    factors = taper_factors(math.radians(12.95))
    assert factors.limit == pytest.approx(0.35, abs=0.006)
    assert factors.axial == pytest.approx(1.7, abs=0.05)


def test_life_of_rollers_has_the_higher_exponent():
    """ISO 281: (60/12)^(10/3) = 213.747."""
    assert basic_life(60e3, 12e3, BearingKind.CYLINDRICAL) == pytest.approx(213.7469933, rel=1e-9)


def test_reference_viscosity_meets_itself_near_1000_rpm():
    """ISO 281's two laws differ by 2.3 % where they meet: 45000 × 1000^-0.83 against 4500 × 1000^-0.5."""
    slow, fast = (reference_viscosity(rpm * RPM, 0.0725) for rpm in (999.9, 1000.1))
    assert slow == pytest.approx(fast, rel=0.025)


@pytest.mark.parametrize(
    ("kind", "kappa", "share", "expected"),
    [
        (BearingKind.DEEP_GROOVE, 0.2, 0.1, 0.18835048784376618),
        (BearingKind.DEEP_GROOVE, 0.5, 0.3, 1.2320120703483735),
        (BearingKind.DEEP_GROOVE, 2.0, 0.3, 41.752416748831635),
        (BearingKind.DEEP_GROOVE, 4.0, 0.3, 50.0),
        (BearingKind.CYLINDRICAL, 0.2, 0.05, 0.11780644967620386),
        (BearingKind.CYLINDRICAL, 1.0, 0.3, 0.944798333283515),
        (BearingKind.CYLINDRICAL, 4.0, 0.3, 2.297679542746136),
    ],
)
def test_life_modification_factor(kind, kappa, share, expected):
    """ISO 281:2007, eqs (31)-(36), evaluated independently to 1e-6."""
    assert life_modification(share, kappa, kind) == pytest.approx(expected, rel=1e-6)
