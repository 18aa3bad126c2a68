"""A scene as a value: surfaces, and where each of them stands and how it turns."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from gearwright.arrays import Floats
from gearwright.identity import PartId
from gearwright.shape.solids import Chamber, Fastener, Solid, Surface, chamber_surface, fastener_surface, surface_of
from gearwright.shape.stands import Axes
from gearwright.showing import Shown


@dataclass(frozen=True)
class Node:
    """A body where it stands."""

    name: str
    """Its label; unique in the scene."""
    part: PartId
    """Whose body it is, as checks and results name it: of a planet all equal ones."""
    look: str
    """What it is painted as: sun, planet, ring, pinion, wheel, tie, shaft, carrier, pin, bearing, holder, housing or
    screw."""
    surface: str
    """Of the scene's solids and surfaces; empty of what only carries others."""
    axes: Axes
    """Where it stands in space at rest, z along its own axis."""
    phase: float
    """By which it is turned about its axis from there [rad]."""
    spins: Mapping[str, float]
    """Load case -> speed about its own axis, against the carrier that it is on where it is on one [rad/s]."""
    on: str = ""
    """Name of the carrier that it goes round with."""


@dataclass(frozen=True, repr=False)
class Scene(Shown):
    """A gearbox of solids."""

    name: str
    """Of the design."""
    solids: Mapping[str, Solid | Chamber | Fastener]
    """What nodes are; equal bodies share one."""
    segments: int
    """Corners of a circle in its triangles [-]."""
    nodes: tuple[Node, ...]
    """Carriers before what is on them."""
    cases: tuple[str, ...]
    """Load cases, the one that speaks for the design first."""
    approximations: tuple[str, ...]
    """What is not as it would be made, in sentences."""

    @cached_property
    def by_name(self) -> Mapping[str, Node]:
        """Name -> node."""
        return {node.name: node for node in self.nodes}

    @cached_property
    def surfaces(self) -> Mapping[str, Surface]:
        """Name of a solid -> its triangles."""
        return {name: triangles_of(solid, self.segments) for name, solid in self.solids.items()}

    @property
    def box(self) -> tuple[Floats, Floats]:
        """Corners of a box around all bodies at rest [m]."""
        lows, highs = [], []
        for node in self.nodes:
            if node.surface:
                points = self.surfaces[node.surface].points @ node.axes.turned.T + node.axes.origin
                lows.append(points.min(axis=0))
                highs.append(points.max(axis=0))
        return np.min(lows, axis=0), np.max(highs, axis=0)


def triangles_of(solid: Solid | Chamber | Fastener, segments: int) -> Surface:
    """Return the triangles of a solid, of a chamber of a housing or of a screw.

    Args:
        solid: One of them.
        segments: Corners of a circle; those of a chamber are its own.
    """
    if isinstance(solid, Fastener):
        return fastener_surface(solid, segments)
    return chamber_surface(solid) if isinstance(solid, Chamber) else surface_of(solid, segments)
