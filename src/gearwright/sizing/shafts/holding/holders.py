"""Turned parts that hold bearings along shafts: rings, nuts, end plates, spacers; how thick, how heavy."""

from __future__ import annotations

import math
from typing import NamedTuple

from gearwright.catalogue import STEEL_DENSITY, CentreHole, LockNut, RetainingRing
from gearwright.sizing.mounted import BearingSizing
from gearwright.sizing.result import Sizing
from gearwright.sizing.shafts.holding.retention import Retention
from gearwright.sizing.shafts.stretches import SHOULDER

RING_HEIGHT = 0.08
"""How far a retaining ring stands out of the shaft over its diameter, an estimate [-]."""
LEAST_PLATE = 3e-3
"""Thinnest end plate, an assumption [m]."""


class Ring(NamedTuple):
    """A part of a holder with one bore and one outside."""

    start: float
    """From the shaft's first end [m]."""
    end: float
    """[m]"""
    bore: float
    """Diameter [m]; 0: none."""
    outer: float
    """Diameter [m]."""


class Holder(NamedTuple):
    """A part of revolution about a shaft."""

    name: str
    shaft: str
    beside: str
    """Bearing that it holds."""
    kind: str
    """retaining ring, lock washer, lock nut, end plate, spacer, housing spacer, cover or radial seal."""
    designation: str
    """Of the standard, or its screws; empty of a plain part."""
    start: float
    """From the shaft's first end [m]."""
    end: float
    """[m]"""
    bore: float
    """Diameter [m]; 0: none."""
    outer: float
    """Diameter [m]."""
    mass: float
    """[kg]"""
    turns: bool
    """Whether it goes round with the shaft."""
    force: float = 0.0
    """That it bears [N]."""
    capacity: float = 0.0
    """What its screws clamp with [N]; 0 of what has none, or is checked with the end of its shaft."""
    stepped: tuple[Ring, ...] = ()
    """Its parts along the shaft, of what is no plain ring: bore and outer are then the smallest and the largest."""

    lip: int = 0
    """Way along the shaft to which the lip of a seal looks: −1 to its first end, +1 to its second; 0 of all else."""

    @property
    def rings(self) -> tuple[Ring, ...]:
        """Its parts along the shaft, without gaps."""
        return self.stepped or (Ring(self.start, self.end, self.bore, self.outer),)


def ring(sizing: Sizing, bearing: BearingSizing, end: Retention, standard: RetainingRing) -> Holder:
    """Return a retaining ring in its groove beside a bearing.

    Args:
        sizing: As sized.
        bearing: That it holds.
        end: Of the shaft.
        standard: The ring.
    """
    del sizing
    span = span_from(end.place, end.way, standard.thickness)
    outer = standard.shaft * (1.0 + 2.0 * RING_HEIGHT)
    return made(
        bearing, "retaining ring", standard.designation, span, (standard.groove, outer), STEEL_DENSITY, turns=True
    )


def washer_and_nut(bearing: BearingSizing, end: Retention, nut: LockNut) -> tuple[Holder, Holder]:
    """Return a lock washer and the nut behind it, as heavy as their maker says.

    Args:
        bearing: That they hold.
        end: Of the shaft.
        nut: The nut.
    """
    behind = end.place + end.way * nut.washer
    sheet = made(
        bearing, "lock washer", "", span_from(end.place, end.way, nut.washer), (nut.thread, nut.face), 0.0, turns=True
    )
    body = made(
        bearing,
        "lock nut",
        nut.designation,
        span_from(behind, end.way, nut.width),
        (nut.thread, nut.outer),
        0.0,
        turns=True,
    )
    return sheet._replace(mass=nut.washer_mass), body._replace(mass=nut.mass)


def plate(sizing: Sizing, bearing: BearingSizing, end: Retention, hole: CentreHole) -> tuple[Holder, ...]:
    """Return an end plate before the end of a shaft, with the spacer on what sticks out of the bearing.

    Args:
        sizing: As sized.
        bearing: That they hold.
        end: Of the shaft.
        hole: For its screw.
    """
    shaft = next(shaft for shaft in sizing.built_shafts if shaft.name == end.shaft)
    face = shaft.steps[-1].end if end.way > 0 else shaft.steps[0].start
    seat, material = bearing.inner_diameter, sizing.design.shaft_material
    outer = seat + SHOULDER * (bearing.outer_diameter - seat)
    allowed = (material.yield_strength or math.inf) / sizing.design.shafting.safety
    thick = max(clamped_plate(end.force, hole.thread, (seat + outer) / 2.0, allowed), LEAST_PLATE)
    disc = made(bearing, "end plate", f"screw {hole.screw}, 8.8", span_from(face, end.way, thick), (0.0, outer),
                 material.density, turns=True)._replace(force=end.force)  # fmt: skip
    if abs(face - end.place) < 1e-6:
        return (disc,)
    low, high = sorted((face, end.place))
    return spacer(sizing, bearing, (low, high), bore=seat, outer=outer, turns=True), disc


def spacer(
    sizing: Sizing, bearing: BearingSizing, span: tuple[float, float], *, bore: float, outer: float, turns: bool
) -> Holder:
    """Return a plain ring between two parts.

    Args:
        sizing: As sized.
        bearing: Beside which it lies.
        span: Where it begins and ends [m].
        bore: Diameter [m].
        outer: Diameter [m].
        turns: Whether it lies on the shaft, not in the housing.
    """
    kind, density = ("spacer" if turns else "housing spacer"), sizing.design.shaft_material.density
    return made(bearing, kind, "", span, (bore, outer), density, turns=turns)


def clamped_plate(force: float, inner: float, outer: float, allowed: float) -> float:
    """Return how thick a plate must be that is pressed along one circle and held along another [m].

    Args:
        force: [N].
        inner: Diameter of the smaller circle [m].
        outer: Of the larger [m].
        allowed: Stress [Pa].

    Source: strips along the radius, which bear alone: M = F (r_o − r_i) on 2 π r_i, σ = 6 M/(2 π r_i t²). Rings around
        them, which are left out, make it thicker than it must be.

    >>> round(1e3 * clamped_plate(33.5e3, 0.020, 0.071, 567e6), 1)
    12.0
    """
    return math.sqrt(6.0 * force * (outer - inner) / 2.0 / (math.pi * inner * allowed))


def span_from(place: float, way: int, thick: float) -> tuple[float, float]:
    """Return where a part begins and ends that lies on one side of a place [m].

    Args:
        place: [m].
        way: −1 towards the shaft's first end, +1 towards the second.
        thick: [m].
    """
    low, high = sorted((place, place + way * thick))
    return low, high


def made(
    bearing: BearingSizing, kind: str, designation: str, span: tuple[float, float], size: tuple[float, float],
    density: float, *, turns: bool,
) -> Holder:  # fmt: skip
    """Return a plain ring or disc as heavy as it is large.

    Args:
        bearing: Beside which it lies.
        kind: What it is.
        designation: Of the standard, or its screws.
        span: Where it begins and ends [m].
        size: Bore and outer diameter [m].
        density: [kg/m³].
        turns: Whether it goes round with the shaft.
    """
    bore, outer = size
    mass = math.pi / 4.0 * (outer**2 - bore**2) * (span[1] - span[0]) * density
    name = f"{kind} beside {bearing.name}, {1e3 * span[0]:.4g} mm"
    return Holder(name, bearing.shaft, bearing.name, kind, designation, *span, bore, outer, mass, turns)
