"""The path of an aircraft through a phase: where it is at the ends of every interval."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import pairwise
from typing import NamedTuple

from gearwright.air import Air, true_of_calibrated
from gearwright.spec import Phase


class Node(NamedTuple):
    """End of an interval."""

    time: float
    """From the start of the phase [s]."""
    altitude: float
    """[m]"""
    speed: float
    """True airspeed [m/s]."""


class Energy(NamedTuple):
    """Where the energy of a path that follows from its thrust went; books of the integration, not of its nodes."""

    thrust: float
    """Work of all propellers [J]."""
    drag: float
    """Of the air and the wheels [J]."""
    carried: float
    """Height and speed of the fuel that was burnt [J]."""
    gained: float
    """Height and speed of the aircraft at the end, less those at the start [J]."""

    @property
    def residual(self) -> float:
        """What is missing, as a part of the work of the propellers [-]."""
        return abs(self.thrust - self.drag - self.carried - self.gained) / max(abs(self.thrust), abs(self.drag))


class Leg(NamedTuple):
    """One interval of a path."""

    start: Node
    end: Node
    stage: str
    """What the aircraft does: roll, rotation, flight."""

    @property
    def duration(self) -> float:
        """[s]"""
        return self.end.time - self.start.time


class Path(NamedTuple):
    """A phase as an aircraft flies it."""

    nodes: tuple[Node, ...]
    """In their order; the first is its start."""
    stages: tuple[str, ...]
    """Of each interval."""
    energy: Energy | None = None
    """None where the path is stated, and thrust follows from it."""

    @property
    def duration(self) -> float:
        """[s]"""
        return self.nodes[-1].time

    @property
    def legs(self) -> Iterator[Leg]:
        """Its intervals."""
        for (start, end), stage in zip(pairwise(self.nodes), self.stages, strict=True):
            yield Leg(start, end, stage)

    def distance(self, stage: str | None = None) -> float:
        """Return how far it leads through the air [m].

        Args:
            stage: Of these intervals only; left out: of all.
        """
        legs = (leg for leg in self.legs if stage in (None, leg.stage))
        return sum(0.5 * (leg.start.speed + leg.end.speed) * leg.duration for leg in legs)


def speed_by_law(phase: Phase, air: Air) -> float:
    """Return the true airspeed that a phase states [m/s]; of a calibrated one and a Mach number the slower.

    Args:
        phase: With its speeds.
        air: Where it is flown.
    """
    stated = [] if phase.mach is None else [phase.mach * air.sound_speed]
    if phase.tas is not None:
        stated.append(phase.tas)
    if phase.cas is not None:
        stated.append(true_of_calibrated(phase.cas, air))
    return min(stated)


Paths = Mapping[str, Path]
"""Phase -> its path, where an aircraft flies it."""
