"""Bells: what joins a ring that turns to its shaft, a wall beside the ring and a disc down to the shaft.

What weighs a bell, what draws it and how far its shaft reaches all follow from the section that stands here.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.identity import Kind
from gearwright.parts.gears import revolved_volume
from gearwright.sizing.arranged import Body
from gearwright.sizing.arrangement import PLATE_GAP
from gearwright.sizing.blanks import ring_radii
from gearwright.sizing.places.plates import plates_of
from gearwright.sizing.result import GearSizing, Sizing
from gearwright.spec import GROUND

LEAST_WALL = 3e-3
"""Of a bell, that it can be turned and hardened without warping [m], an assumption."""
FLAT = 5e-4
"""By how much a disc must be thicker at its hub to be a cone there [m], an assumption."""
TAPER = 3.0
"""Thickness of a bell's disc at its hub over that at its outside, at most [-]."""

Span = tuple[float, float]


class Bell(NamedTuple):
    """What joins a turning ring to its shaft; places along that shaft from its first end."""

    ring: GearSizing
    middle: float
    """Of the ring [m]."""
    disc: Span
    """Where the disc begins and ends at its hub, away from the ring [m]."""
    hub: float
    """Radius of the shaft there [m]."""
    section: tuple[tuple[float, float], ...]
    """Corners from the shaft on, along the face towards the ring, back along the other one: place and radius [m]."""

    @property
    def volume(self) -> float:
        """[m³]"""
        return revolved_volume(self.section)


def along(sizing: Sizing, shaft: str, body: Body) -> Span:
    """Return where a body begins and ends along a shaft [m].

    Args:
        sizing: As sized.
        shaft: In line with the body.
        body: Its envelope.
    """
    frame = sizing.arrangement.frames[shaft]
    ends = [float((np.asarray(body.origin) + far * np.asarray(body.direction) - np.asarray(frame.origin))
                  @ np.asarray(frame.along)) for far in (0.0, body.length)]  # fmt: skip
    return min(ends), max(ends)


def bells(sizing: Sizing) -> Iterator[Bell]:
    """Yield the bell of every ring that turns, on the side of its set or pair to which its shaft leads.

    Args:
        sizing: As sized.

    Source: equilibrium of a disc in shear (Tresca), τ = T/(2 π r² t): as thick as the largest torque of all cases asks
        at the hub, from there a cone to where a third of it is enough, or the thinnest wall; the wall by the same.
    """
    for ring in sizing.gears:
        if ring.rim and ring.shafts[0] != GROUND:
            yield _bell(sizing, ring)


def _bell(sizing: Sizing, ring: GearSizing) -> Bell:
    shaft = ring.shafts[0]
    start, end = along(sizing, shaft, next(body for body in sizing.arrangement.bodies if body.part == ring.body(shaft)))
    middle = (start + end) / 2.0
    side = 1.0 if sizing.arrangement.plans[shaft].length / 2.0 >= middle else -1.0
    face = side * _beyond(sizing, ring, side) + side * PLATE_GAP
    hub, torque = _radius(sizing, shaft, face), ring_torque(sizing, ring)
    root, outside = ring_radii(sizing.design, ring)
    inside = max(outside - max(LEAST_WALL, _thickness(sizing, torque, outside)), root)
    thick = max(_thickness(sizing, torque, hub), LEAST_WALL)
    thin = max(thick / TAPER, LEAST_WALL)
    knee = min(hub * math.sqrt(thick / thin), inside)
    cone = [(face + side * thin, knee)] if thick > thin + FLAT else []
    thin = thin if cone else thick
    back = [(face + side * thick, hub), *cone, (face + side * thin, outside)]
    ring_end = end if side > 0.0 else start
    front = [(face, hub), (face, inside), (ring_end, inside), (ring_end, outside)]
    return Bell(ring, middle, (face, face + side * thick), hub, (*front, *back[::-1]))


def _beyond(sizing: Sizing, ring: GearSizing, side: float) -> float:
    """Return how far gears and both plates of a ring's set, or the gears of its pair, reach along its shaft [m]."""
    gears = [body for body in sizing.arrangement.bodies
             if body.part.name == ring.stage and body.part.kind is Kind.GEAR]  # fmt: skip
    plates = plates_of(sizing, ring.stage) if ring.stage in sizing.design.sets else ()
    bodies: Sequence[Body] = (*gears, *plates)
    return max(side * end for body in bodies for end in along(sizing, ring.shafts[0], body))


def _radius(sizing: Sizing, shaft: str, place: float) -> float:
    """Return the radius of a shaft at a place: its step's, of a first sizing its own [m]."""
    steps = next((built.steps for built in sizing.built_shafts if built.name == shaft), ())
    at = [step.diameter for step in steps if step.start <= place <= step.end]
    return max(at, default=next(one.diameter for one in sizing.shafts if one.name == shaft)) / 2.0


def _thickness(sizing: Sizing, torque: float, radius: float) -> float:
    """Return the thickness of a disc, or of a tube, that its torque shears at a radius [m]; 0 of unknown strength."""
    shear = (sizing.design.shaft_material.yield_strength or 0.0) / sizing.design.shafting.safety / 2.0
    return torque / (2.0 * math.pi * radius**2 * shear) if shear else 0.0


def ring_torque(sizing: Sizing, ring: GearSizing) -> float:
    """Return the largest torque that the meshes of a ring put on it, of all cases [N m].

    Args:
        sizing: As sized.
        ring: One of its internal gears.
    """
    rows = [(mesh.name, mesh.gears.index(ring.name)) for mesh in sizing.train.meshes if ring.name in mesh.gears]
    return max(abs(sum(flow.meshes[row].torques[side] for row, side in rows)) for flow in sizing.flows.values())
