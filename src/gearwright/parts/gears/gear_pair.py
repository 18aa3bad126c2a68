"""A gear pair: contact ratios, backlash, interference, and its strength by Lewis and Hertz."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearwright.base import Floats, Problem, refuse
from gearwright.parts.gears.cylindrical_gear import (
    CylindricalGear,
    base_helix_angle,
    half_angle_at,
    involute,
    transverse_pressure_angle,
    working_pressure_angle,
)
from gearwright.parts.material import STEEL_POISSON

# ----------------------------------------------------------------------------------------------------------------------
# Two gears in mesh: working pressure angle, backlash, path of contact, contact ratios.
#
# Gear 1 is external and drives; gear 2 is external or internal. Distances along the path of contact are counted from
# the pitch point in the direction in which the contact moves: from the driver's root to its tip.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class GearPair:
    """A driving external gear and its mate on a centre distance."""

    driver: CylindricalGear
    """Gear 1, external."""
    driven: CylindricalGear
    """Gear 2, external or internal."""
    given_centre_distance: float | None = None
    """Working centre distance [m], positive; None: the one without backlash."""

    def __post_init__(self) -> None:
        problems = _mismatches(self.driver, self.driven)
        distance = self.given_centre_distance
        if not problems and distance is not None and distance <= self.base_centre_distance:
            allowed = f"above {1e3 * self.base_centre_distance:.6g} mm, where the base circles would roll on each other"
            problems.append(Problem("given_centre_distance", f"{1e3 * distance:.6g} mm given; must be {allowed}"))
        refuse(problems)
        _ = self.working_pressure_angle  # profile shifts that fit no centre distance are refused here

    @property
    def side(self) -> int:
        """+1 for an external pair, −1 for an internal one [-]."""
        return self.driven.side

    @cached_property
    def base_centre_distance(self) -> float:
        """Sum (external) or difference (internal) of the base radii, a cos α_t [m]."""
        return self.driven.base_radius + self.side * self.driver.base_radius

    @cached_property
    def working_pressure_angle(self) -> float:
        """Working transverse pressure angle α_wt [rad]."""
        if self.given_centre_distance is not None:
            return math.acos(self.base_centre_distance / self.given_centre_distance)
        return working_pressure_angle(
            self.driver.teeth + self.driven.teeth,
            self.driver.profile_shift + self.driven.profile_shift,
            pressure_angle=self.driver.rack.pressure_angle,
            helix_angle=self.driver.helix_angle,
        )

    @cached_property
    def centre_distance(self) -> float:
        """Working centre distance a_w [m]."""
        return self.base_centre_distance / math.cos(self.working_pressure_angle)

    @property
    def backlash(self) -> float:
        """Transverse circumferential backlash at the working pitch circles j_wt [m]; negative: the teeth jam."""
        cosine = math.cos(self.working_pressure_angle)
        radii = [gear.base_radius / cosine for gear in (self.driver, self.driven)]
        thickness = sum(
            2.0 * half_angle_at(gear, r) * r for gear, r in zip((self.driver, self.driven), radii, strict=True)
        )
        return 2.0 * math.pi * radii[0] / self.driver.teeth - thickness

    @cached_property
    def approach(self) -> float:
        """Length of the path of contact before the pitch point, ended by the driven gear's tip [m].

        An external pair's path never passes the tangent points of the base circles: beyond them there is no involute.
        """
        return _path(self.driven, self.driver, self.working_pressure_angle)

    @cached_property
    def recess(self) -> float:
        """Length of the path of contact after the pitch point, ended by the driver's tip [m]."""
        return _path(self.driver, self.driven, self.working_pressure_angle)

    @property
    def transverse_contact_ratio(self) -> float:
        """Transverse contact ratio ε_α [-] (ISO 21771:2007)."""
        return (self.approach + self.recess) / self.driver.base_pitch

    @property
    def overlap_ratio(self) -> float:
        """Overlap ratio ε_β = b sin β / (π m_n) with the narrower face [-] (ISO 21771:2007)."""
        return self.face_width * math.sin(self.driver.helix_angle) / (math.pi * self.driver.module)

    @property
    def face_width(self) -> float:
        """Common face width b [m]."""
        return min(self.driver.face_width, self.driven.face_width)


def tip_clearances(pair: GearPair) -> tuple[float, float]:
    """Return the room between the tips of each gear and the root of the other, on the line of centres.

    Args:
        pair: The pair.

    Returns:
        Of the driver's tips and of the driven gear's [m]; negative where they run into the root.

    Source: ISO 21771:2007, c = a_w − r_a1 − r_f2, with a_w, r_a2 and r_f2 negative for an internal gear.
    """
    driver, driven, centre = pair.driver, pair.driven, pair.centre_distance
    return (
        pair.side * (centre - driven.root_radius) - driver.tip_radius,
        pair.side * (centre - driven.tip_radius) - driver.root_radius,
    )


def contact_radii(pair: GearPair, distance: float) -> tuple[float, float]:
    """Return the radii at which the two flanks touch at a place of the path of contact.

    Args:
        pair: The pair.
        distance: Distance from the pitch point, positive towards the driver's tip [m].

    Returns:
        Radius on the driver and on the driven gear [m].

    Source: ISO 21771:2007, r_y² = r_b² + ρ_y² with the radii of curvature ρ_1 = r_b1 tan α_wt + s and
        ρ_2 = r_b2 tan α_wt − s (+ s for an internal gear).
    """
    tangent = math.tan(pair.working_pressure_angle)
    driver, driven = pair.driver.base_radius, pair.driven.base_radius
    return (
        math.hypot(driver, driver * tangent + distance),
        math.hypot(driven, driven * tangent - pair.side * distance),
    )


def _path(tip: CylindricalGear, mate: CylindricalGear, angle: float) -> float:
    """Length of the path that the tip of one gear adds beyond the pitch point [m]."""
    reach = math.sqrt(max(tip.tip_radius**2 - tip.base_radius**2, 0.0))
    length = tip.side * (reach - tip.base_radius * math.tan(angle))
    return min(length, mate.base_radius * math.tan(angle)) if mate.side > 0 else length


def _mismatches(driver: CylindricalGear, driven: CylindricalGear) -> list[Problem]:
    """Problems that keep two gears from meshing at all."""
    problems = []
    if driver.side < 0:
        problems.append(Problem("driver", f"{driver.teeth} teeth given; gear 1 must be external, exchange the gears"))
    elif driven.side < 0 and driver.teeth >= -driven.teeth:
        problems.append(Problem("driver", f"{driver.teeth} teeth do not fit inside a ring of {-driven.teeth}"))
    for name, expected, value in (
        ("module", driver.module, driven.module),
        ("helix_angle", driver.helix_angle, driven.helix_angle),
        ("rack.pressure_angle", driver.rack.pressure_angle, driven.rack.pressure_angle),
    ):
        if not math.isclose(expected, value, rel_tol=1e-9):
            message = f"{value:.6g} given, the driver has {expected:.6g}; they must be equal"
            problems.append(Problem(f"driven.{name}", message))
    return problems


# ----------------------------------------------------------------------------------------------------------------------
# Can a pinion run inside a ring, and can it be put there: the three interferences of internal pairs.
# ----------------------------------------------------------------------------------------------------------------------


class Room(NamedTuple):
    """What there is and what is needed of a length or an angle."""

    there: float
    needed: float

    @property
    def clearance(self) -> float:
        """What is left; negative where the teeth foul."""
        return self.there - self.needed


def involute_room(pair: GearPair) -> Room:
    """Return the ring's tip radius, and the least that ends on the pinion's involute [m].

    Args:
        pair: An internal pair.

    Source: Niemann & Winter, Maschinenelemente II: r_a2 ≥ √(r_b2² + (a_w sin α_wt)²).
    """
    tangent_point = math.hypot(pair.driven.base_radius, pair.centre_distance * math.sin(pair.working_pressure_angle))
    return Room(pair.driven.tip_radius, tangent_point)


def involute_clearance(pair: GearPair) -> float:
    """Return by how much the ring's tip circle clears the point where the pinion's involute ends.

    Args:
        pair: An internal pair.

    Returns:
        Radius of the ring's tip less that of the ring's flank at the pinion's base tangent point [m]; negative: the
        ring's tip digs into the pinion's root.

    Source: `involute_room`.
    """
    return involute_room(pair).clearance


def tip_room(pair: GearPair) -> Room | None:
    """Return the angle at the ring's centre at which the pinion's tip crosses the ring's tip circle, and the least.

    Args:
        pair: An internal pair.

    Returns:
        Angles [rad]; None where the tip circles do not cross, so that nothing can foul.

    Source: Colbourne 1987, The Geometry of Involute Gears, as
        θ_1 z_1/z_2 + inv α_wt (1 − z_1/z_2) ≥ θ_2 with θ_1 = γ_1 + inv α_a1, θ_2 = γ_2 + inv α_a2 and γ the angles at
        the two centres of the point where the tip circles cross.
    """
    r_1, r_2, centre = pair.driver.tip_radius, pair.driven.tip_radius, pair.centre_distance
    if r_1 + centre <= r_2:
        return None
    # Tips below their base circles have no involute, and teeth that are undercut away no crossing: limits of both.
    gamma_1 = _arc((r_2**2 - r_1**2 - centre**2) / (2.0 * r_1 * centre))
    gamma_2 = _arc((r_2**2 - r_1**2 + centre**2) / (2.0 * r_2 * centre))
    theta_1 = gamma_1 + involute(_arc(pair.driver.base_radius / r_1))
    theta_2 = gamma_2 + involute(_arc(pair.driven.base_radius / r_2))
    ratio = pair.driver.teeth / -pair.driven.teeth
    return Room(theta_1 * ratio + involute(pair.working_pressure_angle) * (1.0 - ratio), theta_2)


def _arc(cosine: float) -> float:
    return math.acos(min(max(cosine, -1.0), 1.0))


def tip_clearance_angle(pair: GearPair) -> float:
    """Return the angle by which the tips of pinion and ring miss each other outside the path of contact.

    Args:
        pair: An internal pair.

    Returns:
        Clearance angle at the ring's centre [rad]; negative: the tips foul (trochoidal interference).

    Source: `tip_room`.
    """
    room = tip_room(pair)
    return math.pi if room is None else room.clearance


def assembly_room(pair: GearPair) -> Room | None:
    """Return half the width of the ring's tooth space, and that of the pinion's tip on its radial way into it.

    Args:
        pair: An internal pair.

    Returns:
        Of the tip with the least room [m]; None where no tip passes the ring's tip circle.

    Source: Colbourne 1987, The Geometry of Involute Gears (radial interference, trimming); each pinion tip on
        its way to the working position must stay inside the ring's tooth space at the ring's tip circle.
    """
    halves, rooms = tip_halves(pair), []
    # A pinion tooth centred in its space is the symmetric position; tooth j then faces space j.
    for j in range(pair.driver.teeth // 2 + 1):
        reaches, room = passing_tip(pair, j, halves)
        if not reaches:
            break
        rooms.append(room)
    return min(rooms, key=lambda room: room.clearance, default=None)


class PassingTip(NamedTuple):
    """A tip of the pinion on its radial way into a ring."""

    reaches: bool
    """Whether it passes the ring's tip circle."""
    room: Room
    """Half the width of the ring's tooth space, and that of the tip [m]."""


def tip_halves(pair: GearPair) -> tuple[float, float]:
    """Return half the angles of a tip of the pinion and of a space of the ring at its tips [rad].

    Args:
        pair: An internal pair.

    Source: `half_angle_at`; ISO 21771:2007.
    """
    pinion, ring = pair.driver, pair.driven
    half_space = math.pi / -ring.teeth - half_angle_at(ring, ring.tip_radius)
    return half_angle_at(pinion, pinion.tip_radius), half_space


def passing_tip(pair: GearPair, j: int, halves: tuple[float, float]) -> PassingTip:
    """Return how a tip of the pinion passes the tip circle of the ring on its radial way into it.

    Args:
        pair: An internal pair.
        j: Which tooth, from the one in the middle [-].
        halves: From `tip_halves` [rad].

    Source: `assembly_room`.
    """
    pinion, outer = pair.driver, pair.driven.tip_radius
    angle = 2.0 * math.pi * j / pinion.teeth + halves[0]
    lateral = pinion.tip_radius * math.sin(angle)
    inside = math.sqrt(max(outer**2 - lateral**2, 0.0))
    beyond = pair.centre_distance + pinion.tip_radius * math.cos(angle) > inside
    room = Room(outer * math.sin(2.0 * math.pi * j / -pair.driven.teeth + halves[1]), lateral)
    return PassingTip((angle <= 0.5 * math.pi) & (lateral <= outer) & beyond, room)


def interference(pair: GearPair) -> tuple[Problem, ...]:
    """Return what keeps an internal pair from running, in words; empty when nothing does.

    Args:
        pair: The pair; an external one has none of these interferences.

    Source: see `involute_clearance` and `tip_clearance_angle`. Radial assembly is not a condition for running.
    """
    if pair.side > 0:
        return ()
    problems = []
    if (gap := involute_clearance(pair)) < 0.0:
        fix = "shorten the ring's tip (tip_alteration) or give the pinion more teeth or profile shift"
        problems.append(
            Problem("driven", f"the ring's tip reaches {-1e6 * gap:.3g} µm past the pinion's involute; {fix}")
        )
    if (angle := tip_clearance_angle(pair)) < 0.0:
        fix = "increase the difference of the tooth numbers or shorten the tips"
        problems.append(Problem("driven", f"the tips foul by {math.degrees(-angle):.3g}°; {fix}"))
    return tuple(problems)


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
