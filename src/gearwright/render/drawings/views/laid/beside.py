"""Where a shaft lies in the plane of a drawing beside those of parallel axes with which it meshes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.shape.teeth import halves_of, kind_of, sized_mesh
from gearwright.sizing import Sizing
from gearwright.train import Mesh

TRUE = 0.05
"""How far two gears in mesh may stand from where they mesh before a note says so [mm]."""


@dataclass(frozen=True)
class Lying:
    """A shaft in the plane of the drawing."""

    origin: complex
    """Of its first end [mm]."""
    along: complex
    """Direction to its second end [-]."""
    start: float
    """Where it is drawn from [mm from its first end]."""
    end: float
    """Where it is drawn to [mm from its first end]."""

    def at(self, x: float, radius: float = 0.0) -> complex:
        """Return a point in the plane [mm].

        Args:
            x: From the first end [mm].
            radius: To the left of the axis [mm].
        """
        return self.origin + self.along * complex(x, radius)


@dataclass(frozen=True)
class Join:
    """A mesh that joins a new shaft to one that lies already."""

    mesh: Mesh
    side: int
    """Of the mesh whose shaft lies, 0 or 1."""
    lying: Lying
    """The shaft that lies."""
    at: float
    """Middle of its gear [mm from its first end]."""
    new_at: float
    """Middle of the gear on the new shaft [mm from its first end]."""
    length: float
    """Of the new shaft [mm]."""

    @property
    def new(self) -> str:
        """The new shaft."""
        return self.mesh.nodes[1 - self.side]

    def lay(self, origin: complex, along: complex) -> Lying:
        """Return the new shaft.

        Args:
            origin: Of its first end [mm].
            along: Direction to its second end [-].
        """
        return Lying(origin, along, 0.0, self.length)


def parallel(
    sizing: Sizing, joins: Sequence[Join], shafts: Mapping[str, Lying], places: Mapping[str, Mapping[str, float]]
) -> Lying:
    """Return a shaft that meshes with others: where its gears cover least, then where most of its distances are true.

    Args:
        sizing: What was sized.
        joins: Its meshes with shafts that lie already, the first of parallel axes.
        shafts: That lie already.
        places: Shaft -> gear -> middle of its width [mm from the first end].
    """
    kind = kind_of(sizing, joins[0].mesh.stage)
    widths = _widths(sizing, joins[0].new, places)
    alike = [one for one in joins if kind_of(sizing, one.mesh.stage) == kind]
    choices = []
    for one in alike:
        lying, apart = one.lying, centre_distance(sizing, one.mesh)
        others = [(shaft, _widths(sizing, name, places)) for name, shaft in shafts.items() if shaft is not lying]
        for sign in (1.0, -1.0):
            choice = one.lay(lying.at(one.at - one.new_at, sign * apart), lying.along)
            over = sum(_overlap(choice, widths, other, far) for other, far in others)
            true = sum(abs(_beside_by(choice, each) - centre_distance(sizing, each.mesh)) < TRUE for each in alike)
            off = _off(sizing, joins[0].new, choice, shafts)
            choices.append((over if over > TRUE else 0.0, -true, round(off, 3), choice))
    return min(choices, key=lambda choice: choice[:3])[3]


def _off(sizing: Sizing, new: str, choice: Lying, shafts: Mapping[str, Lying]) -> float:
    """Return by how much distances to shafts along a new one would not be those in space, added up [mm]."""
    frames, off = sizing.arrangement.frames, 0.0
    for name, lying in shafts.items():
        way = np.array(frames[name].along)
        if abs((lying.along * choice.along.conjugate()).imag) < 1e-6:
            between = np.array(frames[new].origin) - np.array(frames[name].origin)
            apart = MM * float(np.linalg.norm(between - (between @ way) * way))
            off += abs(abs(((choice.origin - lying.origin) * lying.along.conjugate()).imag) - apart)
    return off


def _beside_by(choice: Lying, join: Join) -> float:
    """Return how far a shaft would lie from one that it meshes with [mm]."""
    return abs(((choice.origin - join.lying.origin) * join.lying.along.conjugate()).imag)


def centre_distance(sizing: Sizing, mesh: Mesh) -> float:
    """Return the centre distance of a mesh [mm].

    Args:
        sizing: What was sized.
        mesh: Of parallel axes.
    """
    return MM * sized_mesh(sizing, mesh).centre_distance


Widths = list[tuple[float, float, float]]
"""From where to where along a shaft a gear on it is, and its radius [mm]."""


def _widths(sizing: Sizing, shaft: str, places: Mapping[str, Mapping[str, float]]) -> Widths:
    found = []
    for gear in sizing.gears:
        if shaft in gear.shafts and gear.name in places[shaft]:
            middle, half = places[shaft][gear.name], MM * gear.face_width * halves_of(gear) / 2.0
            found.append((middle - half, middle + half, MM * gear.pitch_diameter / 2.0))
    return found


def _overlap(shaft: Lying, widths: Widths, other: Lying, far: Widths) -> float:
    """Return how far the gears of two parallel shafts cover each other, side by side [mm]; 0 for shafts that cross."""
    way = other.along * shaft.along.conjugate()
    if abs(way.imag) > 1e-6:
        return 0.0
    off = (other.origin - shaft.origin) * shaft.along.conjugate()
    over = [
        radius + wide - abs(off.imag)
        for low, high, radius in widths for start, end, wide in far
        if max(low, min(start * way.real, end * way.real) + off.real)
        < min(high, max(start * way.real, end * way.real) + off.real) - TRUE
    ]  # fmt: skip
    return max([0.0, *over])
