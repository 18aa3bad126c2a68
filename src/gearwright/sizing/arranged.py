"""Where everything in a sized transmission stands, as records: axes, places along every shaft, bodies in space.

Axes and plans are found once, by `arrangement`, before shafts are sized; frames and bodies once, by `places`, when all
is sized. Loads, checks, drawings, flights and reports read them. The origin is the first end of the design's first
shaft, x runs along it, y and z are those of its cross-section.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

from gearwright.identity import PartId
from gearwright.spec.design import BearingSeat
from gearwright.units import Angle, Length, Number


class Point(NamedTuple):
    """A place in space."""

    x: Length
    """[m]"""
    y: Length
    """[m]"""
    z: Length
    """[m]"""


class Direction(NamedTuple):
    """A unit vector."""

    x: Number
    """[-]"""
    y: Number
    """[-]"""
    z: Number
    """[-]"""


class Station(NamedTuple):
    """A circle square to a body's axis."""

    place: Length
    """From the body's origin on along its axis [m]."""
    radius: Length
    """[m]"""


@dataclass(frozen=True)
class Frame:
    """The axes of one shaft in space."""

    origin: Point
    """Its first end."""
    along: Direction
    """From its first end to its second one: its x."""
    across: Direction
    """The y of its cross-section."""
    up: Direction
    """The z of its cross-section."""


@dataclass(frozen=True)
class Body:
    """The envelope of one part: the hull of circles about an axis, less a bore; cylinders and cones are two circles."""

    part: PartId
    """Who it is; planets of a set are one body, the ring that they sweep."""
    shaft: str
    """Shaft that it turns with or stands on, or ``ground``."""
    what: str
    """What of the part it is, where it is one of several: ``40 to 46 mm`` of a shaft, ``teeth`` of a bevel gear."""
    origin: Point
    """On its axis, at its first end."""
    direction: Direction
    """Of its axis."""
    stations: tuple[Station, ...]
    """Circles whose hull it is, in order along the axis, the first at the origin."""
    bore: Length = 0.0
    """Radius about the axis within which there is nothing of it [m]."""

    @property
    def length(self) -> Length:
        """Along the axis [m]."""
        return self.stations[-1].place

    @property
    def radius(self) -> Length:
        """The largest [m]."""
        return max(station.radius for station in self.stations)

    @property
    def name(self) -> str:
        """Its part, and what of it."""
        return f"{self.part} ({self.what})" if self.what else str(self.part)


@dataclass(frozen=True)
class Turn:
    """An axis that the design leaves open and that was turned about its mate to make room."""

    shaft: str
    """Of that axis."""
    before: Angle
    """Direction from its mate where nothing is in the way [rad]."""
    after: Angle
    """Direction from its mate with room around it [rad]."""
    why: str
    """What was in the way."""


@dataclass(frozen=True)
class ShaftPlan:
    """A shaft from its first end on."""

    length: Length
    """[m]"""
    bearings: tuple[Length, Length]
    """Middles of its two radial bearings, from the first end [m]."""
    places: Mapping[str, Length]
    """Gear, carrier, machine or clutch -> middle of its width, from the first end [m], in order."""
    seats: Mapping[str, BearingSeat] = field(default_factory=dict)
    """Bearings that the design gives the shaft, by name, in order along it; none where it leaves them open."""


@dataclass(frozen=True)
class Arrangement:
    """Axes and shafts of a transmission."""

    axes: Mapping[str, complex]
    """Shaft -> where its axis stands in the cross-section, y + i z [m], seen along x. The shafts of a bevel pair stand
    beside each other, as if the wheel's were turned into the pinion's; `frames` has them as they cross."""
    plans: Mapping[str, ShaftPlan]
    """Shaft -> where everything sits along it."""
    frames: Mapping[str, Frame] = field(default_factory=dict)
    """Shaft -> its axes in space."""
    bodies: tuple[Body, ...] = ()
    """Gears, free stretches of shafts, bearings, carriers."""
    apart: Mapping[str, Length] = field(default_factory=dict)
    """Mesh row -> how far its gears stand from where they mesh, along their axes [m]; those beside each other left
    out."""
    turns: tuple[Turn, ...] = ()
    """Axes that were turned to make room."""
    within: tuple[tuple[str, str], ...] = ()
    """Inner and outer shaft, where one goes through the other."""
    turned: tuple[str, ...] = ()
    """Planetary sets whose planes lie the other way round along the axis."""
    two_sided: tuple[str, ...] = ()
    """Planetary sets whose carrier's shaft leaves them on both sides."""
    unordered: tuple[tuple[str, ...], ...] = ()
    """Shafts of every axis on which no order was found in which all have room."""
