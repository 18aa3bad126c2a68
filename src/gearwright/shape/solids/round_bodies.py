"""Bodies of revolution: shafts by their steps, bearings by their rings, pins."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gearwright.parts.gears import Blank
from gearwright.shape.solids.solid import Solid
from gearwright.shape.solids.toothed import Loop, disc_gear

RING = 0.28
"""Thickness of a bearing's ring over its section, an assumption [-]."""
RECESS = 0.15
"""How far rolling elements and cage stand behind the faces of the rings over the width, an assumption [-]."""


def tube(span: tuple[float, float], outer: float, bore: float) -> Solid:
    """Return a cylinder with a bore, or without one.

    Args:
        span: Where it begins and ends [m].
        outer: Its radius [m].
        bore: Radius of its bore; 0: none [m].
    """
    return stepped([(span[0], span[1], outer)], bore)


def stepped(steps: Sequence[tuple[float, float, float]], bore: float) -> Solid:
    """Return a shaft.

    Args:
        steps: Start, end [m] and radius [m] of each, without gaps.
        bore: Radius of its bore; 0: none [m].
    """
    way = [(steps[0][0], bore)]
    for start, end, radius in steps:
        way += [(start, max(radius, 1.05 * bore)), (end, max(radius, 1.05 * bore))]
    way.append((steps[-1][1], bore))
    return Solid(tuple([*way, way[0]] if bore else way))


def turned(rings: Sequence[tuple[float, float, float, float]]) -> Solid:
    """Return a ring of stretches with bores and outsides of their own.

    Args:
        rings: Start, end, radius of the bore and outer radius of each, without gaps [m].
    """
    way = [point for start, end, _, outer in rings for point in ((start, outer), (end, outer))]
    way += [point for start, end, bore, _ in reversed(rings) for point in ((end, bore), (start, bore))]
    return Solid((*way, way[0]))


def bearing(bore: float, outer: float, width: float) -> Solid:
    """Return the envelope of a bearing: two rings, and between them what rolls.

    Args:
        bore: Radius [m].
        outer: Radius [m].
        width: [m].
    """
    section, half = outer - bore, width / 2.0
    radii = (bore, bore + RING * section, outer - RING * section, outer)
    inner = half * (1.0 - 2.0 * RECESS)
    way = [(-half, radii[0]), (-half, radii[1]), (-inner, radii[1]), (-inner, radii[2]), (-half, radii[2]),
           (-half, radii[3]), (half, radii[3]), (half, radii[2]), (inner, radii[2]), (inner, radii[1]),
           (half, radii[1]), (half, radii[0]), (-half, radii[0])]  # fmt: skip
    return Solid(tuple(way))


def block(width: float, depth: float, length: float) -> Solid:
    """Return a block about the axis.

    Args:
        width: Along y [m].
        depth: Along x [m].
        length: Along the axis [m].
    """
    around = (
        (1, -1),
        (1, 0),
        (1, 1),
        (0, 1),
        (-1, 1),
        (-1, 0),
        (-1, -1),
        (0, -1),
    )  # sides have middles: they are no arcs
    corners = 0.5 * np.array([complex(depth * x, width * y) for x, y in around])
    loop = Loop(np.abs(corners), np.unwrap(np.angle(corners)), np.arange(len(around)) % 2 == 0)
    blank = Blank(abs(corners[0]), 0.0, 0.0, 0.0, length, length)
    return disc_gear(loop, [(-length / 2.0, 0.0), (length / 2.0, 0.0)], blank)
