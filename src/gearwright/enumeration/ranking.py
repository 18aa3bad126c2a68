"""Every architecture with its best numbers: as a first sizing, against fatigue, then by what it weighs and lacks."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from gearwright.checks import Check
from gearwright.enumeration.building import Built, built, freedoms
from gearwright.enumeration.requirement import Requirement
from gearwright.enumeration.stepped import borne
from gearwright.enumeration.trains import Architecture
from gearwright.errors import DesignError, GearwrightError, Problem
from gearwright.identity import Role, gear_part
from gearwright.ranking import smallest
from gearwright.sizing import Sizing, size, size_unturned
from gearwright.sizing.mass import complete_mass
from gearwright.sizing.rating import remembering
from gearwright.spec import Design, at_level, edited

_STEPS = (0.25, 0.12)
"""Of every number within its range, up and down [-]."""
PRELIMINARY = "preliminary"


@dataclass(frozen=True)
class Candidate:
    """An architecture with its best numbers."""

    architecture: Architecture
    ratios: tuple[float, ...] = ()
    """Of its stages [-]."""
    motor_speed: float | None = None
    """[rad/s]"""
    places: tuple[float, ...] = ()
    """Of its numbers within their ranges, from 0 to 1 [-]."""
    first_mass: float | None = None
    """Of gears, shafts and carriers as a first sizing, with its motor [kg]."""
    first_complete: float | None = None
    """Of the whole gearbox of that first sizing, with its motor [kg]."""
    design: Design | None = None
    """At level preliminary; None where it is refused, or far from the lightest as a first sizing."""
    complete_mass: float | None = None
    """Of the whole gearbox against fatigue [kg]."""
    motor_mass: float | None = None
    """[kg]"""
    lacks: tuple[tuple[str, float], ...] = ()
    """Checks that fail, with their margins, the worst first."""
    rated_mass: float | None = None
    """Complete, with its motor, before its numbers were chosen anew [kg]."""
    proportioned: bool = False
    """Whether its numbers were chosen anew, by what it weighs and lacks against fatigue."""
    refused: str = ""
    """Why it cannot be sized."""

    @property
    def with_machines(self) -> float | None:
        """Complete mass and motor [kg]; None where it is refused."""
        return None if self.complete_mass is None else self.complete_mass + (self.motor_mass or 0.0)

    @property
    def worst(self) -> float:
        """Margin of the check that fails worst, 1 where none does [-]."""
        return min((margin for _, margin in self.lacks), default=1.0)

    @property
    def unborne(self) -> bool:
        """Whether it has planets in which no bearing lives as long as asked."""
        if self.design is None:
            return False
        planets = [gear_part(name, Role.PLANET) for name in self.design.planetaries]
        stepped = self.design.epicyclics.items()
        planets += [gear_part(name, Role.PLANET, own=own) for name, stage in stepped for own in stage.planets]
        return not {f"{planet} life" for planet in planets}.isdisjoint(name for name, _ in self.lacks)

    @property
    def promise(self) -> float:
        """What it may weigh once everything is met [kg]: a mass grows as the square root of what it lacks, or so.

        It only orders what is looked at next; masses that are told are computed.
        """
        mass = self.with_machines
        return float("inf") if mass is None else mass / max(self.worst, 0.01) ** 0.5

    @property
    def order(self) -> tuple[float, float, str]:
        """By what it promises; those that are known as first sizings alone follow, by their mass, then refused ones."""
        return self.promise, self.first_complete or float("inf"), self.architecture.slug


def sketched(requirement: Requirement, architecture: Architecture, *, most: float = math.inf) -> Candidate:
    """Return an architecture with the numbers that weigh least as a first sizing.

    Args:
        requirement: Machines, cases and rules.
        architecture: That is to serve it.
        most: Complete mass with its motor in the middle of its ranges, above which no other numbers are looked at [kg].
    """
    if slowed := _slowed(requirement, architecture):
        return Candidate(architecture, refused=slowed)
    middle = _middle(requirement, architecture) if most < math.inf else None
    if middle is not None and (middle.first_complete or 0.0) > most:
        return middle
    try:
        first, best, places = _lightest(requirement, architecture)
        sizing = size_unturned(best.design)
        whole = complete_mass(sizing).total + sizing.motor_mass
    except GearwrightError as error:
        return Candidate(architecture, refused=_words(error))
    return Candidate(architecture, best.ratios, best.motor_speed, places, first, whole)


def _slowed(requirement: Requirement, architecture: Architecture) -> str:
    """Say where a differential turns the propeller more slowly than may be; empty where it does not."""
    case, speed = requirement.slowed
    tolerance = requirement.design.teeth.speed_tolerance
    if speed >= 1.0 - tolerance or not any(kind.balanced for kind in architecture.members):
        return ""
    why = "its torques stand in a fixed ratio, and the motor gives less there"
    return f"turns the propeller at {speed:.2f} of its speed in {case}: {why}; {1.0 - tolerance:.2f} is asked"


def _middle(requirement: Requirement, architecture: Architecture) -> Candidate | None:
    """Return an architecture with the middle of its ranges as a first sizing; None where that cannot be sized."""
    places = (0.5,) * freedoms(architecture)
    try:
        made = built(requirement, architecture, places)
        sizing = size_unturned(made.design)
        whole = complete_mass(sizing).total + sizing.motor_mass
    except GearwrightError:
        return None
    return Candidate(architecture, made.ratios, made.motor_speed, places, _first_mass(sizing), whole)


@remembering()
def rated(requirement: Requirement, row: Candidate, *, life: float) -> Candidate:
    """Return a sketched architecture sized against fatigue, with everything in its mass.

    Args:
        requirement: Machines, cases and rules.
        row: As sketched.
        life: Of gears and bearings alike [s].
    """
    try:
        found = _rated(requirement, row, row.places, life)
        return replace(found, rated_mass=found.with_machines)
    except GearwrightError as error:
        return replace(row, refused=_words(error))


@remembering()
def proportioned(requirement: Requirement, row: Candidate, *, life: float) -> Candidate:
    """Return an architecture whose numbers promise most against fatigue, of a star of points about those it has.

    A first sizing knows no bearing: numbers that are lightest without may leave planets no bearing that lives.

    Args:
        requirement: Machines, cases and rules.
        row: As rated.
        life: Of gears and bearings alike [s].
    """
    best = replace(row, proportioned=True)
    for step in _STEPS:
        for around in list(_star(best.places, step))[1:]:
            try:
                tried = _rated(requirement, best, around, life)
            except GearwrightError:
                continue
            best = smallest([best, tried], lambda one: one.promise)
    return best


def _rated(requirement: Requirement, row: Candidate, places: Sequence[float], life: float) -> Candidate:
    """Return an architecture at a place in the range of its numbers, sized against fatigue."""
    made = built(requirement, row.architecture, places)
    design = borne(for_life(at_level(made.design, PRELIMINARY), life))
    sizing = size(design)
    return replace(
        row, ratios=made.ratios, motor_speed=made.motor_speed, places=tuple(places), design=design,
        complete_mass=complete_mass(sizing).total, motor_mass=sizing.motor_mass, lacks=tuple(_lacks(sizing.checks)),
    )  # fmt: skip


def for_life(design: Design, life: float) -> Design:
    """Return a design that is asked for one life of gears and bearings.

    Args:
        design: Of any kind.
        life: [s].
    """
    return edited(design, {"service.life_s": life, "service.bearing_life_s": life})


def _lightest(requirement: Requirement, architecture: Architecture) -> tuple[float, Built, tuple[float, ...]]:
    """Return the lightest, and its place, of a star of points, and of a smaller star about it; its place."""
    places = [0.5] * freedoms(architecture)
    tried: dict[tuple[float, ...], tuple[float, Built]] = {}
    problems: list[Problem] = []
    for step in _STEPS:
        for around in _star(places, step):
            if around not in tried:
                try:
                    made = built(requirement, architecture, around)
                    tried[around] = (_first_mass(size_unturned(made.design)), made)
                except GearwrightError as error:
                    problems = problems or [Problem(architecture.name, _words(error))]
        if not tried:
            raise DesignError(problems)
        best = smallest(tried, lambda point: tried[point][0])
        places = list(best)
    return (*tried[best], best)


def _star(places: Sequence[float], step: float) -> Iterator[tuple[float, ...]]:
    """Yield a point and those a step away from it along every number, within the range."""
    yield tuple(places)
    for number, place in enumerate(places):
        for moved in (place - step, place + step):
            if 0.0 <= moved <= 1.0:
                yield (*places[:number], moved, *places[number + 1 :])


def _first_mass(sizing: Sizing) -> float:
    return sizing.mass + sizing.motor_mass


def _lacks(checks: Sequence[Check]) -> Iterator[tuple[str, float]]:
    """Yield what fails, with its margin."""
    for check in checks:
        if check.fails and check.margin is not None:
            yield check.name, check.margin


def _words(error: GearwrightError) -> str:
    problems = error.problems if isinstance(error, DesignError) else ()
    return "; ".join(f"{problem.path}: {problem.message}" for problem in problems) or str(error)
