"""Involute geometry of cylindrical gears: angles, undercut, profile shift and centre distance."""

from __future__ import annotations

import math
from typing import Any, NamedTuple, TypeVar

from numpy.typing import NDArray

from gearwright.errors import DesignError, Problem

# ----------------------------------------------------------------------------------------------------------------------
# Closed forms of the involute cylindrical gear: angles, virtual teeth, profile shift, undercut.
#
# Numbers of teeth are signed as in ISO 21771: an internal gear has a negative number of teeth, and with it a negative
# centre distance, so that one formula serves external and internal pairs. Lengths are in m, angles in rad.
# ----------------------------------------------------------------------------------------------------------------------


_Teeth = TypeVar("_Teeth", float, NDArray[Any])


def involute(angle: float) -> float:
    """Return the involute function inv α = tan α − α.

    Args:
        angle: Pressure angle [rad].

    Source: ISO 21771:2007.

    >>> round(involute(math.radians(20.0)), 6)
    0.014904
    """
    return math.tan(angle) - angle


def involute_angle(value: float) -> float:
    """Return the pressure angle whose involute function has a given value.

    Args:
        value: inv α [-], not negative.

    Returns:
        α [rad], exact to rounding (Newton's iteration from an upper bound).

    Source: the inverse of ISO 21771:2007's inv α = α³/3 + 2α⁵/15 + …, whose first term gives the start.

    >>> round(math.degrees(involute_angle(0.014904)), 3)
    20.0
    """
    if not (math.isfinite(value) and value >= 0.0):
        raise DesignError(
            [Problem("", f"inv α = {value:.6g} has no angle; the profile shifts or thickness are too small")]
        )
    if value == 0.0:
        return 0.0
    # Both are above the root, as tan α > α + α³/3 and α < π/2; from there Newton's steps only come nearer.
    angle: float = min((3.0 * value) ** (1.0 / 3.0), math.atan(value + 0.5 * math.pi))
    for _ in range(20):
        tangent = math.tan(angle)
        step = (tangent - angle - value) / tangent**2
        angle -= step
        if abs(step) <= 1e-15 * angle:
            break
    return angle


def transverse_pressure_angle(pressure_angle: float, helix_angle: float) -> float:
    """Return the transverse pressure angle α_t of a helical gear.

    Args:
        pressure_angle: Normal pressure angle α_n [rad].
        helix_angle: Helix angle at the reference cylinder β [rad].

    Source: ISO 21771:2007, tan α_t = tan α_n / cos β.

    >>> round(math.degrees(transverse_pressure_angle(math.radians(20.0), math.radians(15.8))), 4)
    20.7197
    """
    return math.atan(math.tan(pressure_angle) / math.cos(helix_angle))


def base_helix_angle(pressure_angle: float, helix_angle: float) -> float:
    """Return the helix angle at the base cylinder β_b.

    Args:
        pressure_angle: Normal pressure angle α_n [rad].
        helix_angle: Helix angle at the reference cylinder β [rad].

    Source: ISO 21771:2007, sin β_b = sin β cos α_n.
    """
    return math.asin(math.sin(helix_angle) * math.cos(pressure_angle))


def virtual_teeth(teeth: _Teeth, pressure_angle: float, helix_angle: float) -> _Teeth:
    """Return the number of teeth of the equivalent spur gear in the normal section, z_n.

    Args:
        teeth: Number of teeth z [-], negative for an internal gear; one or many.
        pressure_angle: Normal pressure angle α_n [rad].
        helix_angle: Helix angle at the reference cylinder β [rad].

    Source: ISO 6336-3:2006, z_n = z / (cos² β_b cos β); Pulvirenti 2023, eq. (2.1).

    >>> round(virtual_teeth(17, math.radians(20.0), math.radians(15.8)), 3)
    18.905
    """
    return teeth / (math.cos(base_helix_angle(pressure_angle, helix_angle)) ** 2 * math.cos(helix_angle))


def working_pressure_angle(teeth_sum: float, shift_sum: float, *, pressure_angle: float, helix_angle: float) -> float:
    """Return the working transverse pressure angle α_wt at which given profile shifts mesh without backlash.

    Args:
        teeth_sum: z_1 + z_2 [-], with z_2 negative for an internal pair.
        shift_sum: x_1 + x_2 [-].
        pressure_angle: Normal pressure angle α_n [rad].
        helix_angle: Helix angle at the reference cylinder β [rad].

    Source: ISO 21771:2007, inv α_wt = inv α_t + 2 tan α_n (x_1 + x_2)/(z_1 + z_2).
    """
    transverse = transverse_pressure_angle(pressure_angle, helix_angle)
    return involute_angle(involute(transverse) + 2.0 * math.tan(pressure_angle) * shift_sum / teeth_sum)


def shift_sum(teeth_sum: float, working_angle: float, *, pressure_angle: float, helix_angle: float) -> float:
    """Return the sum of profile shifts x_1 + x_2 that closes the backlash at a working pressure angle.

    Args:
        teeth_sum: z_1 + z_2 [-], with z_2 negative for an internal pair.
        working_angle: Working transverse pressure angle α_wt [rad].
        pressure_angle: Normal pressure angle α_n [rad].
        helix_angle: Helix angle at the reference cylinder β [rad].

    Source: ISO 21771:2007, the inverse of `working_pressure_angle`.
    """
    transverse = transverse_pressure_angle(pressure_angle, helix_angle)
    return (involute(working_angle) - involute(transverse)) * teeth_sum / (2.0 * math.tan(pressure_angle))


def least_profile_shift(teeth: float, rack_height: float, *, pressure_angle: float, helix_angle: float) -> float:
    """Return the profile shift below which a rack undercuts an external gear.

    Args:
        teeth: Number of teeth z [-].
        rack_height: Straight part of the rack's flank below its reference line, in modules [-].
        pressure_angle: Normal pressure angle α_n [rad].
        helix_angle: Helix angle at the reference cylinder β [rad].

    Source: ISO 21771:2007, x_min = h* − z sin² α_t / (2 cos β).

    >>> round(least_profile_shift(9, 1.0, pressure_angle=math.radians(20.0), helix_angle=0.0), 3)
    0.474
    """
    transverse = transverse_pressure_angle(pressure_angle, helix_angle)
    return rack_height - teeth * math.sin(transverse) ** 2 / (2.0 * math.cos(helix_angle))


def least_teeth(rack_height: float, *, pressure_angle: float, helix_angle: float) -> float:
    """Return the number of teeth below which a rack undercuts an external gear without profile shift.

    Args:
        rack_height: Straight part of the rack's flank below its reference line, in modules [-].
        pressure_angle: Normal pressure angle α_n [rad].
        helix_angle: Helix angle at the reference cylinder β [rad].

    Source: ISO 21771:2007, z_min = 2 h* cos β / sin² α_t.

    >>> round(least_teeth(1.0, pressure_angle=math.radians(20.0), helix_angle=0.0), 2)
    17.1
    """
    transverse = transverse_pressure_angle(pressure_angle, helix_angle)
    return 2.0 * rack_height * math.cos(helix_angle) / math.sin(transverse) ** 2


# ----------------------------------------------------------------------------------------------------------------------
# Profile shifts and the centre distance that they close at, for external and internal pairs.
#
# Numbers of teeth are signed as in ISO 21771: an internal gear has a negative number of teeth. Centre distances are
# positive and over the normal module, so that they hold for every size.
# ----------------------------------------------------------------------------------------------------------------------


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
