"""Blade elements from the geometry of propellers that were measured: NACA, UIUC, a hovering rotor.

Sections are not those of the measured blades: design lifts and thicknesses are assumed, Reynolds numbers of model
propellers (5e4 to 1e5) are far below those of the section. Tolerances are what that leaves, told in the docstrings.
"""

import math

import numpy as np
import pytest

from gearwright.machines.propellers import BladeShape, loads


def blades(stations, number, design_lift):
    """Return blades of (r/R, c/R, angle [deg]) and their angle at three quarters of the radius."""
    radius, chord, angle = np.array(stations).T
    edges = np.linspace(radius[0], 1.0, 31)
    middle = 0.5 * (edges[1:] + edges[:-1])
    at = float(np.interp(0.75, radius, angle))
    twist = np.radians(np.interp(middle, radius, angle) - at)
    chords, same = np.interp(middle, radius, chord), np.ones(30)
    shape = BladeShape(
        number, middle, np.diff(edges), chords, twist, design_lift * same, 0.1 * same, hub=float(edges[0])
    )
    return shape, math.radians(at)


def errors(shape, angle, rows):
    """Return how far C_T and C_P are off at advance ratios."""
    ratio, thrust, power = np.array(rows).T
    found = loads(shape, ratio, angle)
    return found.thrust / thrust - 1.0, found.power / power - 1.0


NACA_C = [
    (radius / 1.527, chord / 1.527, 17.0)
    for radius, chord in (
        (0.525, 0.18), (0.675, 0.225), (0.825, 0.225), (0.975, 0.21), (1.125, 0.1875), (1.275, 0.1425), (1.425, 0.12),
    )
]  # fmt: skip
NACA_ROWS = (
    (0.0, 0.1322, 0.0584), (0.1, 0.1224, 0.0578), (0.2, 0.1101, 0.0564), (0.3, 0.0968, 0.0543),
    (0.4, 0.0826, 0.0514), (0.5, 0.0674, 0.0461), (0.6, 0.0495, 0.0370),
)  # fmt: skip


def test_a_propeller_of_three_blades_and_ten_feet():
    """Theodorsen, Stickle and Brevoort, NACA TR-594 (1937), propeller C at 15° (17° to the chord), Clark Y.

    Geometry and curve as in pyBEMT's examples. Design lift 0.5 (usual for Clark Y): thrust within 4 %, power within
    15 % at standstill and 8 % from J 0.2 on.
    """
    thrust, power = errors(*blades(NACA_C, 3, 0.5), NACA_ROWS)
    assert np.abs(thrust).max() < 0.04
    assert np.abs(power).max() < 0.16
    assert np.abs(power[2:]).max() < 0.08


UIUC_RADII = (
    0.15, 0.20, 0.25, 0.30, 0.35, 0.40, 0.45, 0.50, 0.55, 0.60, 0.65, 0.70, 0.75, 0.80, 0.85, 0.90, 0.95, 1.00,
)  # fmt: skip
UIUC = {
    "10x4.7": (
        (
            0.109, 0.132, 0.156, 0.176, 0.193, 0.206, 0.216, 0.223, 0.226, 0.225, 0.219, 0.210, 0.197, 0.179, 0.157,
            0.130, 0.087, 0.042,
        ),
        (
            21.11, 23.90, 24.65, 24.11, 22.78, 21.01, 19.00, 17.06, 15.33, 13.82, 12.51, 11.36, 10.27, 9.32, 8.36,
            7.27, 6.15, 5.04,
        ),
        (
            (0.0, 0.1299, 0.0531), (0.089, 0.1201, 0.0523), (0.155, 0.1101, 0.0511), (0.199, 0.1019, 0.0493),
            (0.246, 0.0935, 0.0475), (0.308, 0.0833, 0.0454), (0.357, 0.0743, 0.0434), (0.395, 0.0669, 0.0414),
        ),
    ),
    "11x4.7": (
        (
            0.112, 0.137, 0.160, 0.181, 0.198, 0.211, 0.221, 0.227, 0.230, 0.228, 0.222, 0.213, 0.199, 0.181, 0.158,
            0.132, 0.084, 0.035,
        ),
        (
            19.64, 21.81, 22.45, 21.88, 20.73, 19.14, 17.30, 15.58, 14.06, 12.71, 11.53, 10.47, 9.53, 8.63, 7.71,
            6.61, 5.28, 3.93,
        ),
        (
            (0.0, 0.1259, 0.0493), (0.087, 0.1151, 0.0482), (0.155, 0.1033, 0.0461), (0.197, 0.0960, 0.0448),
            (0.241, 0.0885, 0.0434), (0.310, 0.0762, 0.0408), (0.347, 0.0687, 0.0390), (0.391, 0.0597, 0.0364),
        ),
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", UIUC)
def test_model_propellers_of_the_uiuc(name):
    """Brandt and Selig, UIUC Propeller Data Site, volume 1: APC Slow Flyer at 6512 and 6006 rpm, static to J 0.39.

    As tabulated in a public repository with the files' checksums. The sections are not published: the design lift of
    0.944 is that which gives C_T of the 10x4.7 at J 0.2, one number for both. Reynolds numbers near 7e4: thrust within
    6 %, power within 18 %.
    """
    chord, angle, rows = UIUC[name]
    thrust, power = errors(*blades(list(zip(UIUC_RADII, chord, angle, strict=True)), 2, 0.944), rows)
    assert np.abs(thrust).max() < 0.06
    assert np.abs(power).max() < 0.18


T_MOTOR = [
    (radius / 0.3556, chord / 0.3556, angle)
    for radius, chord, angle in (
        (0.07112, 0.056, 19.6), (0.10668, 0.070, 17.9), (0.14224, 0.070, 14.4), (0.17780, 0.065, 11.6),
        (0.21336, 0.058, 9.7), (0.24892, 0.050, 8.4), (0.28448, 0.043, 7.2), (0.32004, 0.034, 6.7),
    )
]  # fmt: skip
T_MOTOR_ROWS = (
    (1006, 5.296, 0.187), (1580, 14.28, 0.487), (2207, 28.798, 0.954), (2850, 47.757, 1.57), (3223, 61.972, 2.024),
)  # fmt: skip


def test_a_small_hovering_rotor():
    """T-Motor 28 x 9.2, two blades, geometry and measured thrust and torque as in pyBEMT's examples.

    Design lift 0.5 of three different sections: thrust within 10 %, torque within 15 % (Reynolds numbers near 1e5).
    """
    shape, angle = blades(T_MOTOR, 2, 0.5)
    found = loads(shape, 0.0, angle)
    for rpm, thrust, torque in T_MOTOR_ROWS:
        unit = 1.225 * (rpm / 60.0) ** 2 * 0.7112**4
        assert found.thrust * unit == pytest.approx(thrust, rel=0.10)
        assert found.power * unit * 0.7112 / (2.0 * math.pi) == pytest.approx(torque, rel=0.15)
