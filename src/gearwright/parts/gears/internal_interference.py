"""Can a pinion run inside a ring, and can it be put there: the three interferences of internal pairs."""

from __future__ import annotations

import math
from typing import NamedTuple

from gearwright.errors import Problem
from gearwright.parts.gears.cylindrical_gear import half_angle_at
from gearwright.parts.gears.gear_pair import GearPair
from gearwright.parts.gears.involute import involute


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
