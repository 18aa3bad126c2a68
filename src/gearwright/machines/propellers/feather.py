"""A propeller that stands: the blade angle at which the air does not turn it, and what it then drags."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from gearwright.machines.propellers.blade import BladeShape
from gearwright.machines.propellers.elements import loads

STANDING = 1e4
"""Advance ratio of a propeller that stands as good as still [-]."""
_ANGLES = np.radians(np.linspace(50.0, 90.0, 161))


class Feathered(NamedTuple):
    """A propeller in feather."""

    angle: float
    """Blade angle at three quarters of the radius at which it stands [rad]."""
    drag_area: float
    """Drag over the dynamic pressure and D² [-]."""


def feathered(shape: BladeShape) -> Feathered | None:
    """Return how blades feather; None where no angle from 50 to 90° stops them.

    Args:
        shape: The blades.

    Source: `loads` at an advance ratio of 10⁴: no torque; D/(q D²) = -2 C_T/J².
    """
    found = loads(shape, STANDING, _ANGLES)
    torque, area = found.power / STANDING**2, -2.0 * found.thrust / STANDING**2
    turned = np.flatnonzero((torque[:-1] < 0.0) & (torque[1:] >= 0.0))
    if not len(turned):
        return None
    k = int(turned[-1])
    part = float(-torque[k] / (torque[k + 1] - torque[k]))
    angle, drag = (float(row[k] + part * (row[k + 1] - row[k])) for row in (_ANGLES, area))
    return Feathered(angle, drag) if math.isfinite(drag) else None
