"""The Colibri report's printed gear numbers, replayed to their digits by its own formulas (Uyar et al., ITU).

The torque is 9.55e6 · 322/6000 N mm; 322 kW is the only power that gives the printed 512516.6667.
"""

import math

import pytest

from gearwright.parts.colibri_formulas import (
    Reading,
    ReportGear,
    bevel_forces_colibri,
    form_factor_colibri,
    fracture_module,
    helical_forces_colibri,
    pitting_module,
    report_diameters,
    report_width,
    settled_dynamic_factor,
)
from gearwright.units import RPM

T1 = 9.55e3 * 322.0 / 6000.0
T2 = 4.0 * T1
T3 = T2 * 43.0 / 17.0
BETA, ALPHA = math.radians(15.0), math.radians(20.0)
Z_EQ = round(15 / math.cos(BETA) ** 3, 2)
HELICAL = ReportGear(T1, 15, 4.0, form_factor_colibri(Z_EQ), 1.65, BETA)
BEVEL = ReportGear(T2, 17, 2.5, 8.6, 1.73)
WHEEL = ReportGear(T3, 43, 2.5, 8.6, 1.73)
KV = (1.1165, 1.0188)


def pitting(gear, factor, reading=Reading.EXECUTED):
    return 1e3 * pitting_module(gear, reading, dynamic_factor=factor, allowable=1400e6, elastic_modulus=200e9)


def fracture(gear, factor):
    return 1e3 * fracture_module(gear, dynamic_factor=factor, allowable=220e6)


@pytest.mark.parametrize(
    ("found", "printed"),
    [
        (1e3 * T1, 512516.6667),
        (1e3 * T3, 5185462.7454),
        (HELICAL.form_factor, 8.6720),
        (settled_dynamic_factor(HELICAL, speed=6000.0 * RPM, allowable=220e6), 1.1165),
        (settled_dynamic_factor(BEVEL, speed=1500.0 * RPM, allowable=220e6), 1.0188),
        (fracture(HELICAL, KV[0]), 2.5117),
        (pitting(HELICAL, KV[0]), 2.1826),
        (fracture(BEVEL, KV[1]), 3.6833),
        (pitting(BEVEL, KV[1]), 3.3097),
        (fracture(WHEEL, KV[1]), 3.6833),
        (pitting(WHEEL, KV[1]), 2.4291),
        (1e3 * report_width(3e-3, 12.0), 113.0973),
        (1e3 * report_width(4e-3, 12.0), 150.7964),
    ],
)
def test_printed_modules_come_out_as_executed(found, printed):
    """To 3e-5, the rounding of five printed digits; K_v 3.5e-5 by its inferred constant."""
    assert found == pytest.approx(printed, rel=4e-5)


def test_eq_1_2_as_printed_would_let_pitting_govern():
    """Without ε_α: 2.5791 and 3.9732 mm, above the fracture modules 2.5117 and 3.6833; the choice turns round."""
    assert pitting(HELICAL, KV[0], Reading.PRINTED) == pytest.approx(2.5791, rel=3e-5)
    assert pitting(BEVEL, KV[1], Reading.PRINTED) == pytest.approx(3.9732, rel=3e-5)
    assert pitting(HELICAL, KV[0], Reading.PRINTED) > fracture(HELICAL, KV[0])
    assert pitting(HELICAL, KV[0]) < fracture(HELICAL, KV[0])


@pytest.mark.parametrize(
    ("module", "teeth", "helix", "printed"),
    [
        (3.0, 15, BETA, (52.5874, 39.3874, 46.5874)),
        (3.0, 60, BETA, (192.3497, 179.1497, 186.3497)),
        (4.0, 17, 0.0, (76.0, 58.4, 68.0)),
        (4.0, 43, 0.0, (180.0, 162.4, 172.0)),
    ],
)
def test_printed_diameters(module, teeth, helix, printed):
    """Eqs 1.3 to 1.5, to the printed four decimals."""
    assert report_diameters(module, teeth, helix) == pytest.approx(printed, abs=6e-5)


def test_printed_forces():
    """Shafts 1 and 2 and the rotor shaft, with the report's own diameters and angles, to its digits."""
    first = helical_forces_colibri(T1, 46.587e-3, pressure_angle=ALPHA, helix_angle=BETA)
    assert (first.tangential, first.normal, first.radial, first.axial) == pytest.approx(
        (22002.56152, 24240.61586, 8290.778911, 5895.56859), rel=1e-9
    )
    second = helical_forces_colibri(T2, 68e-3, pressure_angle=ALPHA, helix_angle=BETA)
    assert (second.tangential, second.normal, second.radial, second.axial) == pytest.approx(
        (60296.07844, 66429.26889, 22720.14807, 16156.28552), rel=1e-9
    )
    rotor = bevel_forces_colibri(5185.4627464, 306e-3, pressure_angle=ALPHA, pitch_angle=math.atan(2.5))
    assert (rotor.tangential, rotor.radial, rotor.axial) == pytest.approx((33891.9134, 4581.3445, 11453.3613), rel=1e-8)
