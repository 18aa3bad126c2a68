"""Lewis bending stress and Hertzian contact pressure of gear teeth, and the module required for a load."""

from __future__ import annotations

import math
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearwright.base import Floats
from gearwright.parts.gears.cylindrical_gear import base_helix_angle, transverse_pressure_angle
from gearwright.parts.material import STEEL_POISSON

# ----------------------------------------------------------------------------------------------------------------------
# Hertz's contact of two gear teeth at the pitch point: pressure, and the module that bears it.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Lewis's bending of a gear tooth: form factor, stress, and the module that bears a load.
# ----------------------------------------------------------------------------------------------------------------------


# Lewis form factor Y of 20° full-depth teeth, Shigley's Mechanical Engineering Design, 9th ed., table 14-2.
_TEETH = (12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 24, 26, 28, 30, 34, 38, 43, 50, 60, 75, 100, 150, 300, 400)
_FACTORS = (0.245, 0.261, 0.277, 0.290, 0.296, 0.303, 0.309, 0.314, 0.322, 0.328, 0.331, 0.337, 0.346, 0.353, 0.359,
            0.371, 0.384, 0.397, 0.409, 0.422, 0.435, 0.447, 0.460, 0.472, 0.480)  # fmt: skip
FEWEST_TEETH = _TEETH[0]


@cache
def _table() -> tuple[Floats, Floats]:
    return np.array(_TEETH, dtype=float), np.array(_FACTORS)


def lewis_form_factor(virtual_teeth: ArrayLike) -> Floats:
    """Return the Lewis form factor Y of 20° full-depth teeth [-].

    Args:
        virtual_teeth: Virtual tooth number z_v [-]; scalar or array.

    Source: Shigley's Mechanical Engineering Design, 9th ed., table 14-2; linear between its rows.
    Valid for: 12 teeth and more; above 400 the value at 400 holds (rack 0.485).

    Raises:
        ValueError: Below 12 teeth, where the table ends.

    >>> float(lewis_form_factor(18.0))
    0.309
    """
    teeth = np.asarray(virtual_teeth, dtype=float)
    if np.any(teeth < FEWEST_TEETH):
        raise ValueError(f"the Lewis form factor is tabulated from {FEWEST_TEETH} teeth on; got {float(teeth.min()):g}")
    return np.asarray(np.interp(teeth, *_table()))


def module_lewis(
    torque_per_tooth: Numbers,
    form_factor: Numbers,
    width_ratio: Numbers,
    *,
    allowable: float,
    helix_angle: float = 0.0,
) -> Floats:
    """Return the smallest normal module whose teeth bear bending [m].

    Args:
        torque_per_tooth: T/z of one mesh [N m]; the same on both gears.
        form_factor: Lewis form factor Y of the weaker gear [-].
        width_ratio: λ = b/m_n [-].
        allowable: Allowable bending stress [Pa].
        helix_angle: β [rad].

    Source: Pulvirenti 2023, eq. (2.1) with the cube root that the dimensions ask for (printed: square root):
        m_n³ = 2 (T/z) cos β / (λ Y σ).

    >>> round(1e3 * float(module_lewis(499.43 / 3 / 54, 0.4142, 10.0, allowable=314e6)), 3)
    1.68
    """
    load = 2.0 * torque_per_tooth * math.cos(helix_angle)
    return np.asarray(np.cbrt(load / (width_ratio * form_factor * allowable)))


def bending_stress_lewis(tangential_force: float, face_width: float, module: float, *, form_factor: float) -> float:
    """Return Lewis's bending stress at the tooth root, without stress concentration [Pa].

    Args:
        tangential_force: F_t of one mesh [N].
        face_width: b [m].
        module: Normal module m_n [m].
        form_factor: Lewis form factor Y [-].

    Source: Lewis 1892; σ = F_t / (b m_n Y).
    """
    return tangential_force / (face_width * module * form_factor)
