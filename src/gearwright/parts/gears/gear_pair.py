"""Geometry of a gear pair: contact ratios, backlash, and interference of internal gears."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from gearwright.base import Problem, refuse
from gearwright.parts.gears.cylindrical_gear import CylindricalGear, half_angle_at, involute, working_pressure_angle

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
