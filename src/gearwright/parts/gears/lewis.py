"""Lewis's bending of a gear tooth: form factor, stress, and the module that bears a load."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
from numpy.typing import ArrayLike

from gearwright.arrays import Floats
from gearwright.parts.gears.hertz import Numbers

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
