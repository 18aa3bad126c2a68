"""What turns on a pin: a planet, or the steps of a stepped one, with the bearings that the design names for it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from gearwright.catalogue import Bearing, bearing, with_ratings
from gearwright.identity import Kind, PartId, Role
from gearwright.sizing.pinned import PlanetBearingSizing
from gearwright.sizing.result import GearSizing
from gearwright.spec import Design
from gearwright.spec.design import PlanetBearing

MAKER = "maker's ratings, given by the user"


def as_made(asked: PlanetBearing, designation: str) -> Bearing:
    """Return what the design names for a planet, with the maker's ratings where it gives both.

    Args:
        asked: As in the design.
        designation: In the catalogue.
    """
    standard = bearing(designation)
    if asked.dynamic_rating is None or asked.static_rating is None:
        return standard
    return with_ratings(standard, asked.dynamic_rating, asked.static_rating, source=MAKER)


class Fitting(NamedTuple):
    """What the design names for a planet or one of its steps."""

    step: GearSizing
    """That holds it."""
    asked: PlanetBearing
    path: str
    """Where it stands in the design file."""

    @property
    def runs_on(self) -> PlanetBearingSizing:
        """What was taken for it."""
        assert self.step.runs_on is not None
        return self.step.runs_on

    @property
    def spacing(self) -> float:
        """From the middle of one of the bearings to the next [m]."""
        return self.asked.spacing or self.runs_on.width / self.runs_on.side_by_side

    @property
    def width(self) -> float:
        """From the outer face of the first to that of the last [m]."""
        return (self.asked.side_by_side - 1) * self.spacing + self.runs_on.width / self.runs_on.side_by_side


class Support(NamedTuple):
    """One bearing of a body whose gears and bearings have a place along the axis."""

    fitting: Fitting
    number: int | None
    """From 1, among those side by side; None where it is alone in its step."""
    place: float
    """Its middle, from the carrier's plate [m]."""


class PlanetBody(NamedTuple):
    """One of the equal pieces that turn on the pins of a set."""

    stage: str
    steps: tuple[GearSizing, ...]
    """One gear, or the steps of a stepped planet, that first which its node is called by."""
    places: tuple[float, ...]
    """Middle of each step from the carrier's plate [m]; empty where the design does not say all."""
    fittings: tuple[Fitting, ...]
    """None where the design names no bearing."""

    @property
    def part(self) -> PartId:
        """Its bearing, called as the first of its steps."""
        return self.steps[0].part._replace(kind=Kind.BEARING)

    @property
    def node(self) -> str:
        """Of the train."""
        return self.steps[0].shafts[0]

    @property
    def mass(self) -> float:
        """Of one, with what turns of its bearings [kg]."""
        return sum(step.turning_mass for step in self.steps)

    @property
    def width(self) -> float:
        """Of its steps side by side [m]."""
        return sum(step.face_width for step in self.steps)

    @property
    def supports(self) -> tuple[Support, ...]:
        """Every bearing by itself, where two or more hold a body whose gears have places; else none."""
        if not self.places:
            return ()
        places = {step.name: place for step, place in zip(self.steps, self.places, strict=True)}
        found = [support for fitting in self.fittings for support in _supports(fitting, places[fitting.step.name])]
        return tuple(found) if len(found) > 1 else ()


def planet_bodies(design: Design, gears: Sequence[GearSizing]) -> Iterator[PlanetBody]:
    """Yield what turns on the pins of every planetary and compound set.

    Args:
        design: As read.
        gears: As sized.
    """
    planets = [gear for gear in gears if gear.role is Role.PLANET]
    for name, stage in design.planetaries.items():
        (planet,) = (gear for gear in planets if gear.stage == name)
        asked, path = stage.planet_bearing, f"planetaries.{name}.planet_bearing"
        yield PlanetBody(name, (planet,), (), () if asked is None else (Fitting(planet, asked, path),))
    for name, epicyclic in design.epicyclics.items():
        own = {gear.own: gear for gear in planets if gear.stage == name}
        for body in dict.fromkeys(epicyclic.body(planet) for planet in epicyclic.planets):
            turning = sorted((step for step in own if epicyclic.body(step) == body), key=lambda step: step != body)
            steps = {step: own[step] for step in turning}
            places = [place for step in steps if (place := epicyclic.planets[step].place) is not None]
            fittings = (
                Fitting(gear, asked, f"epicyclics.{name}.planets.{step}.bearing")
                for step, gear in steps.items()
                if (asked := epicyclic.planets[step].bearing) is not None
            )
            known = tuple(places) if len(places) == len(steps) else ()
            yield PlanetBody(name, tuple(steps.values()), known, tuple(fittings))


def _supports(fitting: Fitting, place: float) -> Iterator[Support]:
    count = fitting.asked.side_by_side
    for k in range(count):
        yield Support(fitting, k + 1 if count > 1 else None, place + (k - (count - 1) / 2.0) * fitting.spacing)
