"""Profile shifts and the centre distance that they close at, for external and internal pairs.

Numbers of teeth are signed as in ISO 21771: an internal gear has a negative number of teeth. Centre distances are
positive and over the normal module, so that they hold for every size.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from gearwright.errors import DesignError, Problem
from gearwright.parts.gears.involute import shift_sum, transverse_pressure_angle, working_pressure_angle


class ToothShift(NamedTuple):
    """How far the profile of a gear is shifted, and its tip altered."""

    profile_shift: float = 0.0
    """x [-]; positive makes the tooth thicker, of either kind."""
    tip_alteration: float = 0.0
    """k [-]; negative shortens the tooth."""


UNSHIFTED = ToothShift()
"""A tooth of the basic rack."""


def reference_centre(teeth_sum: int, helix_angle: float) -> float:
    """Return the reference centre distance over the module a/m_n [-].

    Args:
        teeth_sum: z_1 + z_2, with z_2 negative for an internal pair [-].
        helix_angle: β [rad].

    Source: ISO 21771:2007, a = m_n (z_1 + z_2)/(2 cos β).
    """
    return abs(teeth_sum) / (2.0 * math.cos(helix_angle))


def working_centre(teeth_sum: int, shifts: float, *, pressure_angle: float, helix_angle: float) -> float:
    """Return the centre distance without backlash over the module a_w/m_n [-].

    Args:
        teeth_sum: z_1 + z_2, with z_2 negative for an internal pair [-].
        shifts: x_1 + x_2 [-].
        pressure_angle: α_n [rad].
        helix_angle: β [rad].

    Source: ISO 21771:2007, a_w = a cos α_t/cos α_wt with inv α_wt = inv α_t + 2 tan α_n (x_1 + x_2)/(z_1 + z_2).

    Raises:
        DesignError: If the shifts close at no centre distance.

    >>> round(45.0 * working_centre(36, 0.617 + 0.802, pressure_angle=math.radians(20.0), helix_angle=0.0), 3)
    862.996
    """
    reference = reference_centre(teeth_sum, helix_angle)
    if shifts == 0.0:
        return reference
    transverse = transverse_pressure_angle(pressure_angle, helix_angle)
    angle = working_pressure_angle(teeth_sum, shifts, pressure_angle=pressure_angle, helix_angle=helix_angle)
    return reference * math.cos(transverse) / math.cos(angle)


def working_angle_at(teeth_sum: int, centre: float, *, pressure_angle: float, helix_angle: float) -> float:
    """Return the working transverse pressure angle α_wt at a centre distance [rad].

    Args:
        teeth_sum: z_1 + z_2, with z_2 negative for an internal pair [-].
        centre: a_w/m_n [-].
        pressure_angle: α_n [rad].
        helix_angle: β [rad].

    Source: ISO 21771:2007, cos α_wt = a cos α_t/a_w.

    Raises:
        DesignError: If the base circles would roll on each other before.
    """
    transverse = transverse_pressure_angle(pressure_angle, helix_angle)
    reference = reference_centre(teeth_sum, helix_angle)
    if centre == reference:
        return transverse
    base = reference * math.cos(transverse)
    if centre <= base:
        message = f"{centre:.5g} modules; must be above {base:.5g}, where the base circles roll on each other"
        raise DesignError([Problem("centre_distance", message)])
    return math.acos(base / centre)


def shifts_at(teeth_sum: int, centre: float, *, pressure_angle: float, helix_angle: float) -> float:
    """Return the sum of profile shifts that closes without backlash at a centre distance, x_1 + x_2 [-].

    Args:
        teeth_sum: z_1 + z_2, with z_2 negative for an internal pair [-].
        centre: a_w/m_n [-].
        pressure_angle: α_n [rad].
        helix_angle: β [rad].

    Source: ISO 21771:2007, the inverse of `working_centre`.

    Raises:
        DesignError: If the base circles would roll on each other before.
    """
    angle = working_angle_at(teeth_sum, centre, pressure_angle=pressure_angle, helix_angle=helix_angle)
    if centre == reference_centre(teeth_sum, helix_angle):
        return 0.0
    return shift_sum(teeth_sum, angle, pressure_angle=pressure_angle, helix_angle=helix_angle)


def tip_shortening(teeth_sum: int, centre: float, shifts: float, *, helix_angle: float) -> float:
    """Return the tip alteration that keeps the rack's tip clearance in an external pair, k ≤ 0 [-].

    Args:
        teeth_sum: z_1 + z_2 [-].
        centre: a_w/m_n [-].
        shifts: x_1 + x_2 [-].
        helix_angle: β [rad].

    Source: DIN 3960:1987, k m_n = a_w − a − m_n (x_1 + x_2).

    >>> round(tip_shortening(54, 584.002 / 21.0, 0.389 + 0.504, helix_angle=0.0), 4)
    -0.0834
    """
    return min(centre - reference_centre(teeth_sum, helix_angle) - shifts, 0.0) if shifts else 0.0
