"""Every architecture with its best numbers: quickly as a first sizing, then against fatigue with its complete mass."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from gearwright.checks import Check
from gearwright.enumeration.building import Built, built, freedoms
from gearwright.enumeration.requirement import Requirement
from gearwright.enumeration.trains import Architecture
from gearwright.errors import DesignError, GearwrightError, Problem
from gearwright.sizing import Sizing, size
from gearwright.sizing.mass import complete_mass
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
    design: Design | None = None
    """At level preliminary; None where it is refused."""
    first_mass: float | None = None
    """Of gears, shafts and carriers as a first sizing, with its motor [kg]."""
    complete_mass: float | None = None
    """Of the whole gearbox against fatigue [kg]."""
    motor_mass: float | None = None
    """[kg]"""
    lacks: tuple[tuple[str, float], ...] = ()
    """Checks that fail, with their margins, the worst first."""
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
    def promise(self) -> float:
        """What it may weigh once everything is met [kg]: a mass grows as the square root of what it lacks, or so.

        It only orders what is looked at next; masses that are told are computed.
        """
        mass = self.with_machines
        return float("inf") if mass is None else mass / max(self.worst, 0.01) ** 0.5


def candidate(requirement: Requirement, architecture: Architecture, *, life: float) -> Candidate:
    """Return an architecture with the numbers that weigh least as a first sizing, sized against fatigue.

    Args:
        requirement: Machines, cases and rules.
        architecture: That is to serve it.
        life: Of gears and bearings alike [s].
    """
    try:
        first, best = _lightest(requirement, architecture)
        design = for_life(at_level(best.design, PRELIMINARY), life)
        sizing = size(design)
    except GearwrightError as error:
        return Candidate(architecture, refused=_words(error))
    return Candidate(
        architecture, best.ratios, best.motor_speed, design, first, complete_mass(sizing).total, sizing.motor_mass,
        tuple(_lacks(sizing.checks)),
    )  # fmt: skip


def for_life(design: Design, life: float) -> Design:
    """Return a design that is asked for one life of gears and bearings.

    Args:
        design: Of any kind.
        life: [s].
    """
    return edited(design, {"service.life_s": life, "service.bearing_life_s": life})


def _lightest(requirement: Requirement, architecture: Architecture) -> tuple[float, Built]:
    """Return the lightest of a star of points in the range of the numbers, and of a smaller star about it."""
    places = [0.5] * freedoms(architecture)
    tried: dict[tuple[float, ...], tuple[float, Built]] = {}
    problems: list[Problem] = []
    for step in _STEPS:
        for around in _star(places, step):
            if around not in tried:
                try:
                    made = built(requirement, architecture, around)
                    tried[around] = (_first_mass(size(made.design)), made)
                except GearwrightError as error:
                    problems = problems or [Problem(architecture.name, _words(error))]
        if not tried:
            raise DesignError(problems)
        best = min(tried, key=lambda point: tried[point][0])
        places = list(best)
    return tried[best]


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
