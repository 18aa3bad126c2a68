"""Hertz's contact of two gear teeth at the pitch point: pressure, and the module that bears it."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from gearwright.arrays import Floats
from gearwright.parts.gears.involute import base_helix_angle, transverse_pressure_angle
from gearwright.parts.material import STEEL_POISSON

Numbers = float | NDArray[Any]
"""One number or many; plain numbers are computed as they are, which is quicker."""

HERTZ_COEFFICIENT = 0.418
"""√(1 / (2π (1 − ν²))) rounded, for ν = 0.3 and two bodies of one material.

Pulvirenti 2023, eq. (2.2) prints 0.4118, which is 1.5 % low in stress.
"""


class ContactAngles(NamedTuple):
    """The angles that a contact formula works with."""

    pressure: float
    """Pressure angle [rad]: α_n as Pulvirenti prints, α_t where the transverse section is taken."""
    line: float
    """Inclination of the contact line [rad]: β as printed, β_b where the base cylinder is taken."""


def hertz_coefficient(poisson_ratio: float) -> float:
    """Return the coefficient of the line contact of two equal materials [-].

    Args:
        poisson_ratio: ν [-].

    Source: Hertz 1882; σ_H = √(1/(2π(1−ν²))) √(F' E / ρ) with F' the load per length and 1/ρ the sum of curvatures.

    >>> round(hertz_coefficient(0.3), 4)
    0.4182
    """
    return math.sqrt(1.0 / (2.0 * math.pi * (1.0 - poisson_ratio**2)))


def _stiffer(poisson_ratio: float) -> float:
    """Return 1/(1 − ν²) over that of the ν for which `HERTZ_COEFFICIENT` is rounded [-]."""
    return (1.0 - STEEL_POISSON**2) / (1.0 - poisson_ratio**2)


def reduced_modulus(first: tuple[float, float], second: tuple[float, float] | None = None) -> float:
    """Return the reduced modulus E_r of two bodies [Pa].

    Args:
        first: E [Pa] and ν [-] of the one.
        second: E [Pa] and ν [-] of the other; None: the same.

    Source: Hertz 1882, 2/((1 − ν_1²)/E_1 + (1 − ν_2²)/E_2); ISO/TS 6336-20:2017, eq. A.10.

    >>> round(reduced_modulus((206e9, 0.3), (173e9, 0.3)) / 1e9, 1)  # steel on nodular iron
    206.7
    """
    one, other = (modulus / (1.0 - ratio**2) for modulus, ratio in (first, second or first))
    return one * (2.0 * other / (one + other))  # the plain one of equals, to the bit


def contact_angles(pressure_angle: float, helix_angle: float, *, transverse: bool) -> ContactAngles:
    """Return the angles of the contact formula.

    Args:
        pressure_angle: Normal pressure angle α_n [rad].
        helix_angle: β [rad].
        transverse: Take α_t and β_b, as theory asks, instead of α_n and β, as Pulvirenti prints (4 % heavier).

    Source: Pulvirenti 2023, eq. (2.2); ISO 6336-2:2019 for the transverse form (Z_H).
    """
    if not transverse:
        return ContactAngles(pressure_angle, helix_angle)
    return ContactAngles(
        transverse_pressure_angle(pressure_angle, helix_angle),
        base_helix_angle(pressure_angle, helix_angle),
    )


def contact_stress(
    tangential_force: float,
    face_width: float,
    curvature: float,
    *,
    angles: ContactAngles,
    elastic_modulus: float,
    poisson_ratio: float = STEEL_POISSON,
) -> float:
    """Return Hertz's pressure at the pitch point [Pa].

    Args:
        tangential_force: F_t of one mesh [N].
        face_width: b [m].
        curvature: Sum 1/r_1 ± 1/r_2 of the pitch radii, minus for an internal mesh [1/m].
        angles: From `contact_angles`.
        elastic_modulus: E of both gears [Pa].
        poisson_ratio: ν of both gears [-].

    Source: Pulvirenti 2023, eq. (2.2), coefficient corrected from 0.4118 to 0.418:
        σ_H = 0.418 √(F_t E (1/r_1 ± 1/r_2) cos β / (b cos α sin α)).
    """
    load = tangential_force * elastic_modulus * _stiffer(poisson_ratio) * curvature * math.cos(angles.line)
    return HERTZ_COEFFICIENT * math.sqrt(load / (face_width * math.cos(angles.pressure) * math.sin(angles.pressure)))


def module_hertz(
    torque_per_tooth: Numbers, curvature: Numbers, width_ratio: Numbers, *, allowable: float,
    elastic_modulus: float, angles: ContactAngles, helix_angle: float = 0.0, poisson_ratio: float = STEEL_POISSON,
) -> Floats:  # fmt: skip
    """Return the smallest normal module whose flanks bear contact [m].

    Args:
        torque_per_tooth: T/z of one mesh [N m]; the same on both gears.
        curvature: Sum 1/z_1 ± 1/z_2, minus for an internal mesh [-].
        width_ratio: λ = b/m_n [-].
        allowable: Allowable pressure [Pa].
        elastic_modulus: E of both gears [Pa].
        angles: From `contact_angles`.
        helix_angle: β on the pitch cylinder [rad].
        poisson_ratio: ν of both gears [-].

    Source: Pulvirenti 2023, eqs (2.2) and (2.12) solved for m_n with b = λ m_n, r = m_n z / (2 cos β).
    """
    geometry = (
        math.cos(angles.line) * math.cos(helix_angle) ** 2 / (math.cos(angles.pressure) * math.sin(angles.pressure))
    )
    load = 4.0 * torque_per_tooth * curvature * elastic_modulus * _stiffer(poisson_ratio) * geometry
    return np.asarray(np.cbrt(HERTZ_COEFFICIENT**2 * load / (width_ratio * allowable**2)))
