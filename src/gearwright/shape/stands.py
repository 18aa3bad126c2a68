"""Where every single gear of a sizing stands: one entry for each body on a shaft and for each planet of a set."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from gearwright.arrays import Floats
from gearwright.identity import PartId, Role
from gearwright.sizing import GearSizing, Sizing, pins_of, planet_positions
from gearwright.sizing.arranged import Body, Frame
from gearwright.spec import GROUND


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
