"""Circle, length and offset that a gearbox takes as it is installed, against the room that its design leaves it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations
from statistics import NormalDist
from typing import Annotated

import numpy as np

from gearwright.base import GEARBOX, Area, Check, Floats, Quantity, largest
from gearwright.memo import of_latest
from gearwright.sizing.casing import housed
from gearwright.sizing.housing_shell import stretches_around, ways_of
from gearwright.sizing.mass.complete import weighed_wall
from gearwright.sizing.result import Sizing

SURE = 0.05
"""One standard deviation of diameter and length over their values, as sized before they are drawn [-], an estimate."""
CLAUSE = "installation_envelope of the design"


@dataclass(frozen=True)
class Installation:
    """What a gearbox takes of a nacelle: along the axis of its first shaft, and across it."""

    diameter: Annotated[float, Quantity("length")]
    """Of the smallest circle across the first shaft that holds the housing, its flanges left out [m]."""
    length: Annotated[float, Quantity("length")]
    """Along the first shaft, with the ends of shafts that leave the housing [m]."""
    offset: Annotated[float, Quantity("length")]
    """Of the axis of what is driven most from that of what drives most, across the first shaft [m]."""

    @property
    def frontal_area(self) -> Area:
        """Of the circle [m²]."""
        return math.pi / 4.0 * self.diameter**2


@of_latest(1)
def installation_of(sizing: Sizing) -> Installation:
    """Return what a gearbox takes of a nacelle.

    Args:
        sizing: As sized.

    Source: the cross-sections that `housing_shell.shell_around` weighs, with the wall; machines are not in it.
    """
    rooms = stretches_around(housed(sizing))
    wall = weighed_wall(sizing).thickness if sizing.design.housing.own else 0.0
    radius, _ = circle_around(np.max([room.reach for room in rooms], axis=0))
    ends = [end for body in sizing.arrangement.bodies for end in _ends(body.origin.x, body.direction.x, body.length)]
    first, last = min([rooms[0].start - wall, *ends]), max([rooms[-1].end + wall, *ends])
    return Installation(2.0 * (radius + wall), last - first, _offset(sizing))


def _ends(start: float, along: float, length: float) -> tuple[float, float]:
    return start, start + along * length


def circle_around(reach: Floats) -> tuple[float, Floats]:
    """Return radius and middle of the smallest circle that holds a cross-section n·p ≤ h [m].

    Args:
        reach: h in equally spaced directions n from y on [m].

    Source: h_i ≤ c·n_i + R in all directions; the least R stands where three of them are equal. Across directions
        between those that are looked at it is too small by 1 − cos(π/n), 0.2 % for 48, at most.

    >>> radius, middle = circle_around(0.2 + ways_of(48) @ np.array([0.1, -0.3]))
    >>> round(radius, 9), middle.round(9).tolist()
    (0.2, [0.1, -0.3])
    """
    triples = _triples(len(reach))
    sides = np.column_stack([ways_of(len(reach)), np.ones(len(reach))])
    found = np.linalg.solve(sides[triples], reach[triples][:, :, None])[:, :, 0]
    lacks = np.max(reach - found @ sides.T, axis=1)
    holding = found[lacks <= 1e-9 * np.max(np.abs(reach))]
    least = holding[np.argmin(holding[:, 2])]
    return float(least[2]), least[:2]


@lru_cache(maxsize=1)
def _triples(count: int) -> np.ndarray:
    """Return every three of some directions, by number, shape (n, 3)."""
    return np.array(list(combinations(range(count), 3)))


def _offset(sizing: Sizing) -> float:
    """Return how far the axes of the largest machine that drives and of the largest that is driven are apart [m]."""
    torques, flow = sizing.reference.machine_torques, sizing.reference.speeds
    machines = sizing.train.machines
    powers = {name: torque * flow[machines[name]] for name, torque in torques.items()}
    if not powers:
        return 0.0
    drives, driven = largest(powers, lambda one: powers[one]), largest(powers, lambda one: -powers[one])
    one, other = (sizing.arrangement.frames[machines[name]].origin for name in (drives, driven))
    return math.hypot(one.y - other.y, one.z - other.z)


def installation_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield circle, length and offset against what the design allows; nothing where it states none.

    Args:
        sizing: As sized.
    """
    allowed = sizing.design.installation_envelope
    bounds = {"diameter": allowed.diameter, "length": allowed.length, "offset": allowed.offset}
    asked = {name: most for name, most in bounds.items() if most is not None}
    if asked:
        taken = installation_of(sizing)
        for name, most in asked.items():
            yield Check(
                GEARBOX, f"installation envelope {name}", CLAUSE, getattr(taken, name), most, "length", at_most=True,
                exponent=None,
            )  # fmt: skip


def chance_to_fit(sizing: Sizing) -> float:
    """Return the probability that a gearbox keeps to the circle and the length that its design allows [-].

    Args:
        sizing: As sized.

    Source: p = Φ((limit − size)/(0.05 size)), both as if neither knew of the other; the offset is given by axes.
    """
    allowed = sizing.design.installation_envelope
    if allowed.diameter is None and allowed.length is None:
        return 1.0
    taken = installation_of(sizing)
    pairs = [(allowed.diameter, taken.diameter), (allowed.length, taken.length)]
    return math.prod(NormalDist(size, SURE * size).cdf(most) for most, size in pairs if most is not None)
