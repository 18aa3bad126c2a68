"""Where the axes of the shafts stand in the cross-section, so that every mesh force has a direction.

A place is a complex number y + i z [m], seen along x. Shafts joined by a planetary set, clutch or damper share an axis.
The first shaft of the design stands at the origin. A shaft in mesh with one that is placed stands at their centre
distance from it, in the direction of its ``angle``. Where none is given, the shafts around one gear are evenly spaced;
two stand opposite each other, so that their forces on that gear cancel (Pulvirenti 2023, eq. 2.9).

Two layshafts between several gears (the input's, the output's, a motor's) make triangles: they stand opposite each
other about the gear with the shortest centre distance a_min, and another gear with centre distance a has its axis at
√(a² − a_min²) from that one, square to the line of the layshafts. That keeps the wheels on the layshafts as far apart
as the train allows, and clear of the other axes. A shaft tied to two placed axes stands where their circles cross: at
the crossing in the direction of its ``angle``, or, where none is given, at the one that is farther from all other
axes (the lower one, −z, where both are equally far).
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass

from gearwright.errors import DesignError, Problem, refuse
from gearwright.sizing.rating import Context
from gearwright.sizing.result import GearSizing
from gearwright.sizing.rolling import rollings
from gearwright.spec.design import SIDE_ANGLES, Design
from gearwright.units import apart

TOLERANCE = 0.01
"""Part of a centre distance that a change of profile shifts is trusted to take up; more does not close."""
TOUCHING = 1e-6
"""Half of what parts two crossings over a centre distance, below which they are one [-]: beyond that a last digit of a
module would say on which side of an axis the next one stands."""


@dataclass(frozen=True)
class Bond:
    """One mesh of a pair, as a distance between two axes."""

    stage: str
    axes: tuple[str, str]
    """Shafts that name the two axes."""
    distance: float
    """Centre distance [m]."""

    def other(self, axis: str) -> str:
        """Return the axis at the other end."""
        return self.axes[1] if self.axes[0] == axis else self.axes[0]


def axes_of(context: Context, gears: tuple[GearSizing, ...], angles: Mapping[str, float]) -> dict[str, complex]:
    """Return where the axis of every shaft stands, y + i z [m].

    Args:
        context: What sizing reads.
        gears: From `size_gears`.
        angles: Shaft -> direction of its axis from its mate, where the design leaves it open [rad].

    Raises:
        DesignError: If the centre distances do not close.
    """
    asked = _asked(context.design, angles)
    axis = shared_axes(context.design)
    faces = {name for name, pair in context.design.pairs.items() if pair.kind == "face"}
    bonds = list(_bonds(context, axis, {gear.name: gear for gear in gears}, faces))
    placed: dict[str, complex] = {}
    while len(placed) < len(set(axis.values())):
        placed |= _next(asked, bonds, placed, [shaft for shaft in axis.values() if shaft not in placed])
    _close(bonds, placed)
    return {shaft: placed[axis[shaft]] for shaft in context.design.shafts}


def shared_axes(design: Design) -> dict[str, str]:
    """Return shaft -> the first shaft on the same axis.

    Args:
        design: As read.
    """
    axis = {name: name for name in design.shafts}
    groups = [stage.members for stage in design.sets.values()]
    for group in (*groups, *((link.driving, link.driven) for link in design.links.values())):
        joined = {axis[name] for name in group if name in axis}
        first = min(joined, key=design.shafts.index)
        axis = {name: first if root in joined else root for name, root in axis.items()}
    return axis


def _bonds(
    context: Context, axis: Mapping[str, str], gears: Mapping[str, GearSizing], faces: Collection[str]
) -> Iterator[Bond]:
    rolls = rollings(context, gears)
    for mesh in context.train.meshes:
        if mesh.nodes[0] not in axis or mesh.nodes[1] not in axis:
            continue
        ends = (axis[mesh.nodes[0]], axis[mesh.nodes[1]])
        if ends[0] == ends[1]:
            message = (
                f"{mesh.nodes[0]!r} and {mesh.nodes[1]!r} share an axis, so their gears cannot mesh; use a layshaft"
            )
            raise DesignError([Problem(f"pairs.{mesh.stage}", message)])
        # The pinion of a face gear lies across: the middle of its face, not its axis, is on the wheel's pitch circle.
        apart = rolls[mesh.name].radii[1] if mesh.stage in faces else rolls[mesh.name].centre_distance
        yield Bond(mesh.stage, ends, apart)


def _next(
    asked: Mapping[str, float], bonds: list[Bond], placed: Mapping[str, complex], waiting: Sequence[str]
) -> dict[str, complex]:
    """Return the next axes that can be placed."""
    ties = {name: [bond for bond in bonds if name in bond.axes and bond.other(name) in placed] for name in waiting}
    for name in waiting:
        known: dict[complex, float] = {}
        for bond in ties[name]:
            place = placed[bond.other(name)]
            if all(abs(place - centre) > TOLERANCE * bond.distance for centre in known):
                known[place] = bond.distance
        if len(known) > 1:
            return {name: _crossing(known, placed, asked.get(name))}
    for name in waiting:
        if ties[name]:
            return _around(asked, bonds, placed, tie=ties[name][0], name=name)
    return {waiting[0]: 0j}


def _asked(design: Design, angles: Mapping[str, float]) -> dict[str, float]:
    """Return shaft -> direction of its axis from its mate [rad]: as given, as found, or the middle of its side."""
    sides = {name: SIDE_ANGLES[layout.side] for name, layout in design.layout.items() if layout.side is not None}
    given = {name: layout.angle for name, layout in design.layout.items() if layout.angle is not None}
    return {**sides, **angles, **given}


def _around(
    asked: Mapping[str, float], bonds: list[Bond], placed: Mapping[str, complex], *, tie: Bond, name: str
) -> dict[str, complex]:
    """Return the places of all shafts that a pair sets around one placed axis."""
    hub = tie.other(name)
    ring = {bond.other(hub): bond.distance for bond in bonds if bond.stage == tie.stage and hub in bond.axes}
    drop = math.acos(_half_distance(bonds, ring) / tie.distance) if len(ring) == 2 else 0.0
    even = {shaft: 2.0 * math.pi * k / len(ring) + (drop if k else -drop) for k, shaft in enumerate(ring)}
    turns = [cmath.phase(placed[shaft] - placed[hub]) - even[shaft] for shaft in ring if shaft in placed]
    places = {}
    for shaft, distance in ring.items():
        angle = asked.get(shaft)
        if angle is None:
            angle = even[shaft] + (turns[0] if turns else 0.0)
        places[shaft] = placed[hub] + cmath.rect(distance, angle)
    return {shaft: place for shaft, place in places.items() if shaft not in placed}


def _half_distance(bonds: list[Bond], ring: Mapping[str, float]) -> float:
    """Return the shortest centre distance of all axes that mesh with both of two shafts: half of what parts them."""
    first, second = (_reach(bonds, name) for name in ring)
    return min(min(first[hub], second[hub]) for hub in first.keys() & second.keys())


def _reach(bonds: list[Bond], name: str) -> dict[str, float]:
    """Return axis -> shortest centre distance from another one [m]; where two pairs differ, `_close` says so."""
    reach: dict[str, float] = {}
    for bond in bonds:
        if name in bond.axes:
            reach[bond.other(name)] = min(bond.distance, reach.get(bond.other(name), math.inf))
    return reach


def _crossing(known: Mapping[complex, float], placed: Mapping[str, complex], angle: float | None) -> complex:
    """Return where two circles about placed axes cross, or come nearest; `_close` judges how near that is."""
    (one, first), (other, second) = list(known.items())[:2]
    apart = abs(other - one)
    along = (first**2 - second**2 + apart**2) / (2.0 * apart)
    across = math.sqrt(max(first**2 - along**2, 0.0))
    if across < TOUCHING * first:
        across = 0.0
    direction = (other - one) / apart
    sides = [one + direction * complex(along, side) for side in (across, -across)]
    if angle is not None:
        return max(sides, key=lambda place: ((place - one) * cmath.rect(1.0, -angle)).real)
    fits = [place for place in sides if _fit(place, known)] or sides
    rest = [place for place in placed.values() if place not in (one, other)]

    def alone(place: complex) -> float:
        return min((abs(place - neighbour) for neighbour in rest), default=0.0)

    return max(fits, key=lambda place: (round(alone(place), 9), -place.imag))


def _fit(place: complex, known: Mapping[complex, float]) -> bool:
    return all(abs(abs(place - centre) - distance) <= TOLERANCE * distance for centre, distance in known.items())


def _close(bonds: list[Bond], placed: Mapping[str, complex]) -> None:
    """Refuse centre distances that the axes do not keep."""
    problems = []
    for bond in bonds:
        first, second = bond.axes
        stand = abs(placed[first] - placed[second])
        if abs(stand - bond.distance) > TOLERANCE * bond.distance:
            here, asked = apart(stand, bond.distance, "length")
            message = (
                f"the axes of {first!r} and {second!r} stand {here} apart where their other meshes put them, but the"
                f" gears ask {asked}; change an angle in [layout], give a module_mm that closes the triangle, or write"
                " coaxial_with where two pairs lie on the same axes"
            )
            problems.append(Problem(f"pairs.{bond.stage}", message))
    refuse(problems)
