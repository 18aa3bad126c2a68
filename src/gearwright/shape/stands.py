"""Where every single gear stands, what its teeth are, which gears mesh where, and the scene that holds them."""

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from gearwright.base import SIDES, Floats, PartId, Role, Shown, by_name
from gearwright.parts.bevel_geometry import Hand
from gearwright.parts.gears import CylindricalGear
from gearwright.shape.chambers import Chamber, chamber_surface
from gearwright.shape.solids import Fastener, Solid, fastener_surface, surface_of
from gearwright.shape.surfaces import Surface
from gearwright.sizing import (
    Body,
    Frame,
    GearSizing,
    MeshSizing,
    Sizing,
    gear_geometry as tooth_shape,
    pins_of,
    planet_positions,
    rating_as_sized,
)
from gearwright.sizing.arrangement import helix_hand
from gearwright.sizing.mass import bevel_cones as bevel_pair
from gearwright.sizing.rating import Making, method_for
from gearwright.spec import GROUND, Pair
from gearwright.train import INTERNAL, Mesh

__all__ = ["bevel_pair"]


# ----------------------------------------------------------------------------------------------------------------------
# Where every single gear of a sizing stands: one entry for each body on a shaft and for each planet of a set.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Axes:
    """A place in space and three directions square to each other."""

    origin: Floats
    """[m], shape (3,)"""
    turned: Floats
    """Columns: x (across), y (up) and z (along the axis) [-], shape (3, 3)."""

    @property
    def along(self) -> Floats:
        """The axis [-], shape (3,)."""
        return np.asarray(self.turned[:, 2])

    def angle(self, way: Floats) -> float:
        """Return the angle of a direction about the axis [rad].

        Args:
            way: In space, shape (3,).
        """
        return math.atan2(float(way @ self.turned[:, 1]), float(way @ self.turned[:, 0]))


@dataclass(frozen=True)
class Stand:
    """One gear where it stands, before it is turned to mesh."""

    part: PartId
    """Who it is, with its shaft or its number."""
    gear: GearSizing
    """As sized."""
    node: str
    """Shaft, or the node of a planet's body."""
    place: int
    """Which of equal sets of planets it belongs to, from 0; 0 for all else."""
    axes: Axes
    """Its middle, at rest."""
    carrier: str = ""
    """Of a planet: shaft of its carrier."""

    @cached_property
    def name(self) -> str:
        """Its label."""
        return str(self.part)


def axes_at(frame: Frame, place: Floats) -> Axes:
    """Return the axes of a shaft at a place on it.

    Args:
        frame: Of the shaft.
        place: In space [m], shape (3,).
    """
    return Axes(np.asarray(place, dtype=float), np.stack([frame.across, frame.up, frame.along], axis=1))


def stands_of(sizing: Sizing) -> tuple[Stand, ...]:
    """Return every gear where it stands.

    Args:
        sizing: As sized.
    """
    found: list[Stand] = []
    for gear in sizing.gears:
        found += _of_pair(sizing, gear) if gear.stage in sizing.design.pairs else _of_set(sizing, gear)
    return tuple(found)


def _of_pair(sizing: Sizing, gear: GearSizing) -> Iterator[Stand]:
    for shaft in gear.shafts:
        frame = set_frame(sizing, gear.stage) if shaft == GROUND else sizing.arrangement.frames[shaft]
        middle = sizing.arrangement.plans[shaft].places[gear.name]
        place = np.asarray(frame.origin) + middle * np.asarray(frame.along)
        yield Stand(gear.body(shaft), gear, shaft, 0, axes_at(frame, place))


def _of_set(sizing: Sizing, gear: GearSizing) -> Iterator[Stand]:
    body = next(body for body in sizing.arrangement.bodies if body.part == gear.part)
    frame, middle = set_frame(sizing, gear.stage), middle_of(body)
    if gear.role is not Role.PLANET:
        yield Stand(gear.part, gear, gear.shafts[0], 0, axes_at(frame, middle))
        return
    carrier = sizing.design.sets[gear.stage].carrier
    for k, pin in enumerate(pins(sizing, gear.stage, gear.own)):
        place = middle + pin.real * np.asarray(frame.across) + pin.imag * np.asarray(frame.up)
        yield Stand(gear.part._replace(number=k + 1), gear, gear.shafts[0], k, axes_at(frame, place), carrier)


def middle_of(body: Body) -> Floats:
    """Return the middle of a body on its axis [m].

    Args:
        body: Its envelope.
    """
    return np.asarray(body.origin) + body.length / 2.0 * np.asarray(body.direction)


def set_frame(sizing: Sizing, stage: str) -> Frame:
    """Return the axes of a planetary set.

    Args:
        sizing: As sized.
        stage: Its name.
    """
    frames = sizing.arrangement.frames
    return next(frames[shaft] for shaft in sizing.design.sets[stage].members if shaft in frames)


def pins(sizing: Sizing, stage: str, own: str) -> list[complex]:
    """Return where the pins of equal planets stand beside the set's axis, across + i up [m].

    Args:
        sizing: As sized.
        stage: A planetary or compound set.
        own: What the design calls the planet, in a compound set.
    """
    if stage in sizing.design.planetaries:
        radius = next(carrier.radius for carrier in sizing.carriers if carrier.stage == stage)
        return [cmath.rect(radius, angle) for angle in planet_positions(sizing.design, stage, sizing.teeth)]
    epicyclic = sizing.design.epicyclics[stage]
    gears: Mapping[str, GearSizing] = {gear.own: gear for gear in sizing.gears if gear.stage == stage}
    centres = {mesh.own: mesh.centre_distance for mesh in sizing.meshes if mesh.stage == stage}
    first = pins_of(epicyclic, gears, centres)[epicyclic.body(own)]
    return [first * cmath.rect(1.0, 2.0 * math.pi * k / epicyclic.sets) for k in range(epicyclic.sets)]


# ----------------------------------------------------------------------------------------------------------------------
# The teeth of a sized gear as its drawing states them: cylinders, cones, hand, and what turns with what.
# ----------------------------------------------------------------------------------------------------------------------


def gear_of(sizing: Sizing, name: str) -> GearSizing:
    """Return a gear by its name.

    Args:
        sizing: What was sized.
        name: Such as ``first.sun``.
    """
    return by_name(name, {gear.name: gear for gear in sizing.gears}, "gear")


def kind_of(sizing: Sizing, stage: str) -> str:
    """Return cylindrical, face or bevel.

    Args:
        sizing: What was sized.
        stage: A pair or a planetary set.
    """
    rules = sizing.design.stages[stage]
    return rules.kind if isinstance(rules, Pair) else "cylindrical"


def making_of(sizing: Sizing, stage: str) -> Making:
    """Return how the gears of a stage are made, as far as its method of rating asks.

    Args:
        sizing: What was sized.
        stage: A pair or a planetary set.
    """
    rating = rating_as_sized(sizing, stage)
    return method_for(rating).making(rating)


def halves_of(gear: GearSizing) -> int:
    """Return how often a gear of a pair stands on its shaft: 2 for a double-helical one, 1 for all others.

    Args:
        gear: As sized.
    """
    return max(gear.bodies // max(len(gear.shafts), 1), 1) if gear.role in SIDES else 1


def is_internal(sizing: Sizing, gear: GearSizing) -> bool:
    """Return True for a gear with teeth inside.

    Args:
        sizing: What was sized.
        gear: One of its gears.
    """
    return gear.name in sizing.train.internal


def cylindrical_gear(sizing: Sizing, gear: GearSizing) -> CylindricalGear:
    """Return the teeth of a cylindrical gear with the basic rack ISO 53 A and the profile shift of its stage.

    Args:
        sizing: What was sized.
        gear: One of its gears.
    """
    teeth = tooth_shape.cylindrical_gear(sizing.design, gear)
    return replace(teeth, teeth=-gear.teeth) if is_internal(sizing, gear) else teeth


def meshes_of(sizing: Sizing, gear: str) -> list[tuple[Mesh, int]]:
    """Return every mesh row of a gear, with 0 where it is the first gear of the row and 1 where it is the second.

    Args:
        sizing: What was sized.
        gear: Its name.
    """
    return [(mesh, mesh.gears.index(gear)) for mesh in sizing.train.meshes if gear in mesh.gears]


def sized_mesh(sizing: Sizing, mesh: Mesh) -> MeshSizing:
    """Return what sizing made of a mesh row.

    Args:
        sizing: What was sized.
        mesh: A row of its train.
    """
    return by_name(mesh.name, {row.name: row for row in sizing.meshes}, "mesh")


def hand_of(sizing: Sizing, gear: GearSizing, shaft: str) -> Hand | None:
    """Return the hand of helix or spiral that the forces of the sizing belong to; None for straight teeth.

    The spiral of a bevel pinion pushes it away from the apex in the rated case.

    Args:
        sizing: What was sized.
        gear: One of its gears.
        shaft: That carries it.
    """
    if gear.helix_angle == 0.0:
        return None
    if kind_of(sizing, gear.stage) != "bevel":
        return Hand.LEFT if helix_hand(sizing.design, sizing.train, sizing.flows, shaft) < 0.0 else Hand.RIGHT
    (mesh, side), *_ = meshes_of(sizing, gear.name)
    stage = sizing.design.pairs[mesh.stage]
    pinion, flow = mesh.nodes[0], sizing.reference
    drives = flow.meshes[mesh.name].torques[0] * flow.speeds[pinion] < 0.0
    # Seen from the back towards the apex; a positive speed turns clockwise about the way from first to second end.
    clockwise = (flow.speeds[pinion] >= 0.0) == (stage.pinion_apex == "second")
    return Hand.LEFT if (clockwise == drives) == (side == 0) else Hand.RIGHT


# ----------------------------------------------------------------------------------------------------------------------
# Which single gears mesh, where they touch, and which way their teeth go there.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Contact:
    """Two gears in mesh."""

    mesh: Mesh
    """Row of the train."""
    first: Stand
    second: Stand
    angles: tuple[float, float]
    """Where they touch, as each sees it about its own axis [rad]."""
    sense: float
    """+1 where teeth that turn the same way about both axes go the same way, −1 where against each other [-]."""
    offset: float
    """How far the second gear's middle stands from the first one's along the axis, of parallel axes [m]."""


def contacts_of(sizing: Sizing, stands: Sequence[Stand]) -> tuple[Contact, ...]:
    """Return every mesh of single gears.

    Args:
        sizing: As sized.
        stands: Its gears where they stand.
    """
    by_gear: dict[tuple[str, str, int], Stand] = {(stand.gear.name, stand.node, stand.place): stand for stand in stands}
    return tuple(contact for mesh in sizing.train.meshes for contact in _of_row(sizing, mesh, by_gear))


def _of_row(sizing: Sizing, mesh: Mesh, stands: Mapping[tuple[str, str, int], Stand]) -> Iterator[Contact]:
    sets = mesh.count if mesh.stage in sizing.design.sets else 1
    for place in range(sets):
        pair = []
        for gear, node in zip(mesh.gears, mesh.nodes[:2], strict=True):
            pair.append(stands.get((gear, node, place)) or stands[(gear, node, 0)])
        yield contact_of(sizing, mesh, pair[0], pair[1])


def contact_of(sizing: Sizing, mesh: Mesh, first: Stand, second: Stand) -> Contact:
    """Return how two gears touch.

    Args:
        sizing: As sized.
        mesh: Row of the train.
        first: Its first gear.
        second: Its second gear.
    """
    ways = _ways(sizing, mesh, first, second)
    moves = [np.cross(stand.axes.along, way) for stand, way in zip((first, second), ways, strict=True)]
    angles = (first.axes.angle(ways[0]), second.axes.angle(ways[1]))
    offset = float((second.axes.origin - first.axes.origin) @ first.axes.along)
    return Contact(mesh, first, second, angles, float(np.sign(moves[0] @ moves[1])), offset)


def _ways(sizing: Sizing, mesh: Mesh, first: Stand, second: Stand) -> tuple[Floats, Floats]:
    """Return the directions from both axes to where the gears touch, square to each axis."""
    kind, (one, other) = kind_of(sizing, mesh.stage), (first.axes, second.axes)
    if kind == "bevel":
        pair = sizing.design.pairs[mesh.stage]
        back = [axes.along * (-1.0 if apex == "second" else 1.0)
                for axes, apex in zip((one, other), (pair.pinion_apex, pair.wheel_apex), strict=True)]  # fmt: skip
        return _square(back[1], back[0]), _square(back[0], back[1])
    if kind == "face":
        toward = _square(one.origin - other.origin, other.along)  # from the wheel's axis to the pinion
        radius = second.gear.pitch_diameter / 2.0
        touch = other.origin + radius * toward
        return _square(touch - one.origin, one.along), toward
    between = _square(other.origin - one.origin, one.along)
    return (-between, -between) if mesh.sign == INTERNAL else (between, -between)


def _square(way: Floats, axis: Floats) -> Floats:
    """Return the unit vector along that part of a way which is square to an axis."""
    part = way - (way @ axis) * axis
    return np.asarray(part / np.linalg.norm(part))


# ----------------------------------------------------------------------------------------------------------------------
# A scene as a value: surfaces, and where each of them stands and how it turns.
# ----------------------------------------------------------------------------------------------------------------------


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
