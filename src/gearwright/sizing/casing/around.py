"""What stands around the bosses of bearings: rooms up to their walls, and bodies to keep clear of."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.catalogue import HousingMaterial
from gearwright.sizing.arranged import Body
from gearwright.sizing.casing.loops import NEAR, ways_of
from gearwright.sizing.casing.shell import Stretch

CLEAR = 2e-3
"""Between a web and what turns or holds bearings, at least [m], an assumption."""
SUNK = 1e-3
"""How far webs and collars go on into walls, so that they are one piece with them [m]."""


class Around(NamedTuple):
    """What stands around bosses."""

    rooms: Sequence[Stretch]
    bodies: Sequence[Body]
    balls: Floats
    """Of bodies, from `ball_around` [m], shape (n, 4)."""
    wall: float
    material: HousingMaterial

    def is_free(self, points: Floats, ignored: Callable[[Body], bool] = lambda _: False) -> bool:
        """Tell whether points are clear of bodies.

        Args:
            points: [m], shape (n, 3).
            ignored: Which bodies do not count.
        """
        middle = points.mean(axis=0)
        radius = float(np.max(np.linalg.norm(points - middle, axis=1))) + CLEAR
        near = np.linalg.norm(self.balls[:, :3] - middle, axis=1) < self.balls[:, 3] + radius
        for k in np.flatnonzero(near).tolist():
            body = self.bodies[k]
            if ignored(body):
                continue
            off, axis = points - np.asarray(body.origin), np.asarray(body.direction)
            place = off @ axis
            beside = np.linalg.norm(off - place[:, None] * axis, axis=1)
            places, radii = zip(*body.stations, strict=True)
            within = (place > -CLEAR) & (place < body.length + CLEAR) & (beside > body.bore - CLEAR)
            if np.any(within & (beside < np.interp(place, places, radii) + CLEAR)):
                return False
        return True

    def reach(self, start: Floats, way: Floats) -> float:
        """Return how far it is from a point into the wall [m]; 0 outside of all rooms.

        Args:
            start: [m], shape (3,).
            way: Unit vector, shape (3,).
        """
        ways, far = ways_of(len(self.rooms[0].reach)), 0.0
        across, order = ways @ way[1:], list(self.rooms if way[0] >= 0.0 else self.rooms[::-1])
        for room in order:
            here = start + far * way
            ahead = (room.end if way[0] >= 0.0 else room.start) - here[0]
            if (ahead < NEAR) if way[0] >= 0.0 else (ahead > -NEAR):
                continue
            left = room.reach - ways @ here[1:]
            if left.min() < -NEAR or not room.start - NEAR < here[0] < room.end + NEAR:
                return far + SUNK if far else 0.0
            out = across > NEAR
            side = float(np.min(left[out] / across[out], initial=math.inf))
            plane = ahead / float(way[0]) if abs(way[0]) > NEAR else math.inf
            if side <= plane:
                return far + side + SUNK
            far += plane
        return far + SUNK if far else 0.0


def ball_around(body: Body) -> list[float]:
    """Return middle and radius of a ball around a body [m].

    Args:
        body: The body.
    """
    middle = np.asarray(body.origin) + body.length / 2.0 * np.asarray(body.direction)
    return [*middle.tolist(), math.hypot(body.length / 2.0, body.radius)]
