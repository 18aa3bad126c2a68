"""Cylindrical gear geometry, tooth thickness allowances, span measurement, gear blank and mass."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from typing import Any, NamedTuple, TypeVar

from numpy.typing import NDArray

from gearwright.base import DesignError, Problem, refuse

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


# ----------------------------------------------------------------------------------------------------------------------
# A cylindrical gear as its drawing states it, and the radii and thicknesses that follow.
#
# An internal gear has a negative number of teeth (ISO 21771); all radii are positive here, and a positive profile shift
# makes the tooth of either kind thicker at the reference circle.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class BasicRack:
    """The straight-sided rack that defines a tooth; lengths in normal modules."""

    pressure_angle: float = math.radians(20.0)
    """Normal pressure angle α_n [rad]."""
    addendum: float = 1.0
    """Addendum h_aP* [-]."""
    dedendum: float = 1.25
    """Dedendum h_fP* [-]."""
    fillet_radius: float = 0.38
    """Radius of the root fillet ρ_fP* [-]."""

    @property
    def straight_dedendum(self) -> float:
        """Straight part of the flank below the reference line, h_fP* − ρ_fP* (1 − sin α_n) [-]."""
        return self.dedendum - self.fillet_radius * (1.0 - math.sin(self.pressure_angle))


ISO53_A = BasicRack()
"""ISO 53:1998 profile A: general, for high torques."""
ISO53_D = BasicRack(dedendum=1.40, fillet_radius=0.39)
"""ISO 53:1998 profile D: fully rounded root, for ground or shaved high-precision gears."""


@dataclass(frozen=True)
class CylindricalGear:
    """One external or internal gear with its basic rack."""

    teeth: int
    """Number of teeth z [-]; negative for an internal gear."""
    module: float
    """Normal module m_n [m]."""
    face_width: float
    """Face width b [m]."""
    helix_angle: float = 0.0
    """Helix angle at the reference cylinder β [rad], absolute value."""
    profile_shift: float = 0.0
    """Profile shift coefficient x [-]."""
    rack: BasicRack = ISO53_A
    """Basic rack."""
    tip_alteration: float = 0.0
    """Tip alteration coefficient k [-]; negative shortens the tooth."""

    def __post_init__(self) -> None:
        limits = (
            ("teeth", self.teeth, "at least 5, or at most −5 for an internal gear", abs(self.teeth) >= 5),
            ("module", self.module, "above 0 m", 0.0 < self.module < math.inf),
            ("face_width", self.face_width, "above 0 m", 0.0 < self.face_width < math.inf),
            ("helix_angle", self.helix_angle, "from 0 to below π/3 rad", 0.0 <= self.helix_angle < math.pi / 3.0),
            ("profile_shift", self.profile_shift, "between −2 and 2", abs(self.profile_shift) <= 2.0),
        )
        if not all(good for *_, good in limits):
            wrong = [(name, value, allowed) for name, value, allowed, good in limits if not good]
            refuse(Problem(name, f"{value:.6g} given; must be {allowed}") for name, value, allowed in wrong)

    @property
    def side(self) -> int:
        """+1 for external teeth, −1 for internal ones [-]."""
        return 1 if self.teeth > 0 else -1

    @cached_property
    def transverse_pressure_angle(self) -> float:
        """Transverse pressure angle α_t [rad]."""
        return transverse_pressure_angle(self.rack.pressure_angle, self.helix_angle)

    @cached_property
    def base_helix_angle(self) -> float:
        """Helix angle at the base cylinder β_b [rad]."""
        return base_helix_angle(self.rack.pressure_angle, self.helix_angle)

    @cached_property
    def transverse_module(self) -> float:
        """Transverse module m_t [m]."""
        return self.module / math.cos(self.helix_angle)

    @cached_property
    def pitch_radius(self) -> float:
        """Reference radius r [m]."""
        return 0.5 * abs(self.teeth) * self.transverse_module

    @cached_property
    def base_radius(self) -> float:
        """Base radius r_b [m]."""
        return self.pitch_radius * math.cos(self.transverse_pressure_angle)

    @property
    def base_pitch(self) -> float:
        """Transverse base pitch p_bt [m]."""
        return math.pi * self.transverse_module * math.cos(self.transverse_pressure_angle)

    @cached_property
    def tip_radius(self) -> float:
        """Tip radius r_a [m]."""
        height = self.rack.addendum + self.profile_shift + self.tip_alteration
        return self.pitch_radius + self.side * height * self.module

    @property
    def root_radius(self) -> float:
        """Root radius r_f [m]."""
        return self.pitch_radius - self.side * (self.rack.dedendum - self.profile_shift) * self.module

    @property
    def undercut_shift(self) -> float:
        """Least profile shift of an external gear without undercut x_min [-]; −∞ for an internal one."""
        if self.side < 0:
            return -math.inf
        return least_profile_shift(
            self.teeth,
            self.rack.straight_dedendum,
            pressure_angle=self.rack.pressure_angle,
            helix_angle=self.helix_angle,
        )


def pressure_angle_at(gear: CylindricalGear, radius: float) -> float:
    """Return the transverse pressure angle of the flank at a radius.

    Args:
        gear: The gear.
        radius: At least the base radius [m].

    Source: ISO 21771:2007, cos α_y = r_b / r_y.
    """
    return math.acos(min(1.0, gear.base_radius / radius))


def half_angle_at(gear: CylindricalGear, radius: float) -> float:
    """Return half the angle that a tooth takes at a radius, without backlash allowance.

    Args:
        gear: The gear.
        radius: At least the base radius [m].

    Returns:
        ψ_y [rad]; the transverse tooth thickness is 2 ψ_y r_y.

    Source: ISO 21771:2007, ψ_y = (π + 4 x tan α_n)/(2 z) + inv α_t − inv α_y; opposite signs for internal teeth.
    """
    at_pitch = (math.pi + 4.0 * gear.profile_shift * math.tan(gear.rack.pressure_angle)) / (2.0 * abs(gear.teeth))
    return at_pitch + gear.side * (involute(gear.transverse_pressure_angle) - involute(pressure_angle_at(gear, radius)))


def tip_thickness(gear: CylindricalGear) -> float:
    """Return the transverse tooth thickness at the tip circle.

    Args:
        gear: The gear.

    Returns:
        s_a [m]; not positive means a pointed tooth.

    Source: ISO 21771:2007, s_a = 2 ψ_a r_a.

    >>> round(1e3 * tip_thickness(CylindricalGear(20, 1e-3, 0.01)), 3)
    0.695
    """
    return 2.0 * half_angle_at(gear, gear.tip_radius) * gear.tip_radius


# ----------------------------------------------------------------------------------------------------------------------
# How much thinner than without backlash a tooth is made, and how much the maker may miss it.
# ----------------------------------------------------------------------------------------------------------------------


_MM = 1e-3
_FEED = {4: (7, 1.26), 5: (8, 1.0), 6: (8, 1.26), 7: (9, 1.0), 8: (9, 1.26), 9: (10, 1.0)}
"""Flank tolerance class -> grade of ISO 286 and factor of the tolerance on the radial feed (ISO/TR 10064-2:1996)."""


def least_backlash(centre_distance: float, module: float) -> float:
    """Return the least normal backlash that steel gears in steel or iron housings usually have.

    Args:
        centre_distance: a [m].
        module: m_n [m].

    Returns:
        j_bn [m].

    Source: ISO/TR 10064-2:1996, annex: j_bn = 2/3 (0.06 + 0.0005 a + 0.03 m_n) in mm.
    Valid for: pitch-line speeds up to 15 m/s and usual tolerances of the housing.

    >>> round(1e6 * least_backlash(0.171, 2.5e-3))
    147
    """
    return _MM * 2.0 / 3.0 * (0.06 + 0.0005 * centre_distance / _MM + 0.03 * module / _MM)


def runout_tolerance(diameter: float, module: float, grade: int) -> float:
    """Return the tolerance of the runout of a gear.

    Args:
        diameter: Reference diameter d [m].
        module: m_n [m].
        grade: Flank tolerance class A [-].

    Returns:
        F_rT [m].

    Source: ISO 1328-1:2013: F_pT = (0.002 d + 0.55 √d + 0.7 m_n + 12) √2^(A−5) in µm with d and m_n in mm, and
        F_rT = 0.9 F_pT of annex F.
    """
    d, m = diameter / _MM, module / _MM
    return 0.9e-6 * (0.002 * d + 0.55 * math.sqrt(d) + 0.7 * m + 12.0) * math.sqrt(2.0) ** (grade - 5)


def feed_grade(grade: int) -> tuple[int, float]:
    """Return what tolerance the radial feed of the cutter has: a grade of ISO 286 and a factor on it.

    Args:
        grade: Flank tolerance class A [-].

    Source: ISO/TR 10064-2:1996, 4 to 9: 1.26 IT7, IT8, 1.26 IT8, IT9, 1.26 IT9, IT10 at the reference diameter.

    Raises:
        DesignError: If the report has none for this class.
    """
    if grade not in _FEED:
        raise DesignError([Problem("tolerance_class", f"{grade} given; a tolerance on the feed is known for 4 to 9")])
    return _FEED[grade]


def span_allowances(backlash: float, runout: float, feed: float, *, pressure_angle: float) -> tuple[float, float]:
    """Return lower and upper allowance of a span measurement, where both gears give half of the least backlash.

    Args:
        backlash: Least normal backlash j_bn [m].
        runout: Tolerance F_r [m].
        feed: Tolerance of the radial feed b_r [m].
        pressure_angle: α_n [rad].

    Returns:
        E_bni and E_bns [m], both negative.

    Source: ISO/TR 10064-2:1996: E_bns = −j_bn/2, T_sn = 2 tan α_n √(F_r² + b_r²), E_bni = E_bns − T_sn cos α_n.

    >>> low, high = span_allowances(147e-6, 17e-6, 46e-6, pressure_angle=math.radians(20.0))
    >>> round(1e6 * low), round(1e6 * high)
    (-107, -74)
    """
    upper = -backlash / 2.0
    width = 2.0 * math.tan(pressure_angle) * math.hypot(runout, feed) * math.cos(pressure_angle)
    return upper - width, upper


def span_allowance(thickness: float, *, pressure_angle: float) -> float:
    """Return by how much a span measurement is shorter where teeth are thinner.

    Args:
        thickness: Allowance of the normal tooth thickness E_sn, negative [m].
        pressure_angle: α_n [rad].

    Returns:
        E_bn [m], negative; of two gears that mesh the sum is their normal backlash −j_bn.

    Source: DIN 3967:1978, A_W = A_sn cos α_n.

    >>> round(1e6 * span_allowance(-70e-6, pressure_angle=math.radians(20.0)))
    -66
    """
    return thickness * math.cos(pressure_angle)


def thinned(gear: CylindricalGear, thickness: float) -> CylindricalGear:
    """Return a gear whose teeth are thinner, of the same tip circle: its shift is the one with which it is cut.

    Args:
        gear: Without backlash.
        thickness: Allowance of the normal tooth thickness E_sn, negative [m].

    Source: DIN 3960:1987, x_E = x + A_s/(2 m_n tan α_n).

    >>> round(thinned(CylindricalGear(51, 1e-3, 0.017, profile_shift=0.2034), -278e-6 / math.cos(math.radians(20.0)))
    ...       .profile_shift, 4)
    -0.203
    """
    less = thickness / (2.0 * gear.module * math.tan(gear.rack.pressure_angle))
    shift, tip = gear.profile_shift + less, gear.tip_alteration - less
    return replace(gear, profile_shift=shift, tip_alteration=tip)


def centre_play(further: float, *, working_angle: float, helix_angle: float) -> float:
    """Return the normal backlash that an external mesh gains where its axes stand further apart; a ring loses it.

    Args:
        further: By which the centre distance is larger [m].
        working_angle: Working transverse pressure angle α_wt [rad].
        helix_angle: At the base cylinder β_b [rad].

    Returns:
        Δj_bn [m].

    Source: DIN 3967:1978, Δj = 2 A_a tan α_wt on the working circles, times cos α_wt cos β_b along the flank's normal.
    Valid for: changes that are small against the centre distance.

    >>> round(1e6 * centre_play(15e-6, working_angle=math.radians(21.46), helix_angle=0.0))
    11
    """
    return 2.0 * further * math.sin(working_angle) * math.cos(helix_angle)


def circumferential_play(normal: float, *, working_angle: float, helix_angle: float) -> float:
    """Return a normal backlash along the working pitch circles.

    Args:
        normal: j_bn [m].
        working_angle: Working transverse pressure angle α_wt [rad].
        helix_angle: At the base cylinder β_b [rad].

    Returns:
        j_wt [m].

    Source: ISO 21771:2007, j_bn = j_wt cos α_wt cos β_b.

    >>> round(1e6 * circumferential_play(485e-6, working_angle=math.radians(21.46), helix_angle=0.0))
    521
    """
    return normal / (math.cos(working_angle) * math.cos(helix_angle))


# ----------------------------------------------------------------------------------------------------------------------
# What an inspector measures: span over teeth, and distance over balls or pins.
# ----------------------------------------------------------------------------------------------------------------------


def span_measurement(gear: CylindricalGear, spanned: int) -> float:
    """Return the span measurement (base tangent length) over a number of teeth of an external gear.

    Args:
        gear: External gear.
        spanned: Number of teeth between the anvils k [-].

    Returns:
        W_k [m], nominal, without backlash allowance.

    Source: ISO 21771:2007, W_k = m_n cos α_n [(k − 0.5) π + z inv α_t + 2 x tan α_n].

    >>> round(1e3 * span_measurement(CylindricalGear(20, 1e-3, 0.01), 3), 4)
    7.6604
    """
    if gear.side < 0:
        raise DesignError([Problem("teeth", f"{gear.teeth} given; measure an internal gear between balls instead")])
    angle = gear.rack.pressure_angle
    pitches = (spanned - 0.5) * math.pi + gear.teeth * involute(gear.transverse_pressure_angle)
    return gear.module * math.cos(angle) * (pitches + 2.0 * gear.profile_shift * math.tan(angle))


def spanned_teeth(gear: CylindricalGear) -> int:
    """Return the number of teeth to span so that the anvils touch near the middle of the flank.

    Args:
        gear: External gear.

    Source: the base tangent length whose half meets the cylinder of diameter d + 2 x m_n (ISO 21771:2007); where two
        numbers are as near, the smaller, as tables of spans have it (27 teeth of 20 degrees: 3).

    >>> spanned_teeth(CylindricalGear(20, 1e-3, 0.01)), spanned_teeth(CylindricalGear(27, 1e-3, 0.01))
    (3, 3)
    """
    middle = gear.pitch_radius + gear.profile_shift * gear.module
    length = 2.0 * math.sqrt(max(middle**2 - gear.base_radius**2, 0.0)) / math.cos(gear.base_helix_angle)
    pitches = (length - span_measurement(gear, 1)) / (math.pi * gear.module * math.cos(gear.rack.pressure_angle))
    return max(2, math.ceil(round(pitches, 9) + 0.5))


def ball_measurement(gear: CylindricalGear, diameter: float) -> float:
    """Return the distance over two balls in opposite tooth spaces; between them for an internal gear.

    Args:
        gear: External or internal gear.
        diameter: Diameter of the balls D_M [m].

    Returns:
        M_dK [m], nominal, without backlash allowance.

    Source: ISO 21771:2007, inv α_Kt = ± D_M/(|z| m_n cos α_n) + inv α_t ∓ (π − 4 x tan α_n)/(2 |z|), upper signs for
        external gears; cos(π/2z) for odd numbers of teeth.
    """
    teeth, angle = abs(gear.teeth), gear.rack.pressure_angle
    ball = diameter / (teeth * gear.module * math.cos(angle))
    half_space = (math.pi - 4.0 * gear.profile_shift * math.tan(angle)) / (2.0 * teeth)
    centre = involute_angle(involute(gear.transverse_pressure_angle) + gear.side * (ball - half_space))
    across = 2.0 * gear.base_radius / math.cos(centre)
    across *= math.cos(0.5 * math.pi / teeth) if teeth % 2 else 1.0
    return across + gear.side * diameter


# ----------------------------------------------------------------------------------------------------------------------
# Mass and inertia of gear bodies: discs and rings, to the circle that is the pitch circle without profile shift.
# ----------------------------------------------------------------------------------------------------------------------


def disc_mass(diameter: float, width: float, density: float) -> float:
    """Return the mass of a solid disc [kg].

    Args:
        diameter: Outer diameter; of a gear that of its mean circle, d + 2 x m_n [m].
        width: Face width [m].
        density: ρ [kg/m³].

    Source: Pulvirenti 2023, eq. (3.3), π r² b ρ; its eq. (2.18) lacks the width and mixes radius and diameter.

    >>> round(disc_mass(0.2, 0.05, 7850.0), 3)
    12.331
    """
    return math.pi / 4.0 * diameter**2 * width * density


def disc_inertia(mass: float, diameter: float) -> float:
    """Return the polar inertia of a solid disc [kg m²].

    Args:
        mass: [kg].
        diameter: [m].

    Source: m d²/8; Pulvirenti 2023, eq. (3.6) (its appendix prints m d²/2 for the turbine).
    """
    return mass * diameter**2 / 8.0


def ring_mass(inner_diameter: float, wall: float, width: float, *, density: float) -> float:
    """Return the mass of a ring gear's body, from its pitch circle outwards [kg].

    Args:
        inner_diameter: Of its mean circle, d − 2 x m_n [m].
        wall: Radial thickness outside of it [m].
        width: Face width [m].
        density: ρ [kg/m³].

    Source: annulus; a wall of 3.95 m is the tooth's dedendum and AGMA 2001's backup ratio of 1.2.
    """
    inner = inner_diameter / 2.0
    return math.pi * ((inner + wall) ** 2 - inner**2) * width * density


def ring_inertia(mass: float, inner_diameter: float, wall: float) -> float:
    """Return the polar inertia of a ring [kg m²].

    Args:
        mass: [kg].
        inner_diameter: [m].
        wall: Radial thickness [m].

    Source: annulus, m (r_i² + r_o²) / 2.
    """
    inner = inner_diameter / 2.0
    return mass * (inner**2 + (inner + wall) ** 2) / 2.0


# ----------------------------------------------------------------------------------------------------------------------
# What a gear's body under its teeth weighs as it is made: a rim that carries them, a web, a hub.
# ----------------------------------------------------------------------------------------------------------------------


HOLE = 0.6
"""Diameter of a hole in a web over the room between rim and hub, or between neighbours, an assumption [-]."""


class Blank(NamedTuple):
    """A body of revolution under external teeth: three annuli one inside the other; lengths [m]."""

    root_radius: float
    """Outside of the rim."""
    rim_radius: float
    """Inside of the rim."""
    hub_radius: float
    """Outside of the hub."""
    bore_radius: float
    """Inside of the hub."""
    width: float
    """Of rim and hub."""
    web_width: float
    """Of the web between them."""
    holes: int = 0
    """Evenly spaced ones in the web that lighten it [-]."""
    dish: float = 0.0
    """How far the web stands at the hub from where it stands at the rim, along the axis [m]."""

    @property
    def is_solid(self) -> bool:
        """Whether rim and hub meet, or nothing is turned out between them."""
        return self.rim_radius <= self.hub_radius or self.web_width >= self.width

    @property
    def hole_circle(self) -> float:
        """Radius of the circle on which holes stand, in the middle of the web."""
        return (self.rim_radius + self.hub_radius) / 2.0

    @property
    def hole_radius(self) -> float:
        """Of one hole; 0 where there is none."""
        if not self.holes or self.is_solid:
            return 0.0
        chord = 2.0 * self.hole_circle * math.sin(math.pi / self.holes)
        return HOLE / 2.0 * min(self.rim_radius - self.hub_radius, chord)


def blank_volume(blank: Blank) -> float:
    """Return the volume of the body under the teeth [m³].

    Args:
        blank: Its radii and widths.

    Source: annuli; one alone where rim and hub meet; less what is bored through the web. A dished web is sheared along
        the axis, so that it is as thick along it, and fills as much (Cavalieri).
    """
    root, bore = blank.root_radius, min(blank.bore_radius, blank.root_radius)
    inside = max(blank.rim_radius, blank.hub_radius)
    rim, hub = _annulus(root, inside), _annulus(blank.hub_radius, bore)
    web = _annulus(inside, blank.hub_radius) - blank.holes * math.pi * blank.hole_radius**2
    return (rim + hub) * blank.width + web * blank.web_width


def _annulus(outer: float, inner: float) -> float:
    return math.pi * (outer**2 - inner**2)


def revolved_volume(corners: Sequence[tuple[float, float]]) -> float:
    """Return the volume that a closed chain of straight lines sweeps about the axis [m³].

    Args:
        corners: Place along the axis and radius of each [m]; the last one is joined to the first.

    Source: frusta of cones, V = π/3 Σ (z_2 − z_1)(r_1² + r_1 r_2 + r_2²), either way round.

    >>> round(revolved_volume([(0.0, 0.0), (0.3, 0.0), (0.3, 0.1)]) / math.pi, 6)  # a cone, r² h/3
    0.001
    """
    ends = pairwise([*corners, corners[0]])
    swept = sum((high - low) * (one**2 + one * two + two**2) for (low, one), (high, two) in ends)
    return abs(math.pi / 3.0 * swept)
