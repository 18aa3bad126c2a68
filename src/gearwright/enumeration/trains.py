"""Every train of a few stages that can give a ratio, with every place for a motor: structures alone, no numbers."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from enum import StrEnum
from itertools import product

from gearwright.enumeration.kinds import KINDS, Kind


class Seat(StrEnum):
    """How a motor drives a train."""

    NONE = "no motor"
    SHAFT = "on shaft"
    """It turns as the shaft does."""
    PAIR = "through a pair on shaft"
    """Its pinion drives a wheel of its own."""
    WHEEL = "through a pinion on the wheel of"
    """Its pinion meshes with a wheel that is there."""
    BRANCH = "on a branch of"
    """On one of two branches, which bears its torque alone."""
    PINIONS = "through a pinion between the branches of"
    """Its pinion meshes with the pinions of both branches."""
    RING = "on the ring of"
    """It turns the ring of a differential."""
    RIM = "through a pair on the ring of"
    """Its pinion meshes with teeth around the ring of a differential."""


@dataclass(frozen=True)
class Place:
    """Where a motor is."""

    seat: Seat
    at: int = 0
    """Number of the shaft, counted from the engine's, or of the stage, both from 0."""


@dataclass(frozen=True)
class Architecture:
    """A train of stages from engine to propeller, and where its motor is."""

    kinds: tuple[str, ...]
    """Names of the kinds of its stages, from the engine on."""
    motor: Place

    @property
    def members(self) -> tuple[Kind, ...]:
        """Its kinds."""
        return tuple(KINDS[name] for name in self.kinds)

    @property
    def stages(self) -> int:
        """How many stages it has [-]."""
        return sum(kind.stages for kind in self.members)

    @property
    def name(self) -> str:
        """In words: ``star, planetary set; motor on shaft 1``."""
        return f"{', '.join(self.kinds)}; {self._motor}"

    @property
    def _motor(self) -> str:
        """Where its motor is, in words."""
        seat, at = self.motor.seat, self.motor.at
        if seat is Seat.NONE:
            return str(seat)
        named = {0: "of the engine", len(self.kinds): "of the propeller"}.get(at, str(at))
        whose = named if seat in (Seat.SHAFT, Seat.PAIR) else f"{self.kinds[at]} {at + 1}"
        return f"motor {seat} {whose}"

    @property
    def slug(self) -> str:
        """Name of its file."""
        motor = "" if self.motor.seat is Seat.NONE else f"-motor-{self.motor.seat.name.lower()}-{self.motor.at}"
        return "-".join(kind.short for kind in self.members) + motor


def trains(
    ratio: float, *, stages: Sequence[int] = (2, 3), motor: bool = True, added: float = 0.0
) -> Iterator[Architecture]:
    """Yield every architecture that can give a ratio, each once, the ones of fewer stages first.

    Args:
        ratio: Speed of the engine over that of the propeller [-].
        stages: How many stages a train may have.
        motor: Whether there is one.
        added: Power of the motor over that of the engine, by which a differential's output is faster [-].
    """
    for count in stages:
        for length in range(1, count + 1):
            for members in product(KINDS.values(), repeat=length):
                if sum(kind.stages for kind in members) == count and reaches(members, ratio, added=added):
                    names = tuple(kind.name for kind in members)
                    yield from (Architecture(names, place) for place in _places(members, motor=motor))


def held(members: Sequence[Kind], ratio: float, added: float) -> float:
    """Return the ratio that stages must give together, the ring of a differential held [-].

    The ring adds the motor's power at the sun's torque: ω_s + ρ ω_r = (1 + ρ) ω_c with ρ ω_r = ω_s P_m/P_s (Willis).

    Args:
        members: Kinds of the stages.
        ratio: Wanted of them all [-].
        added: Power of the motor over that of the engine [-].
    """
    return ratio * (1.0 + added) if any(kind.balanced for kind in members) else ratio


def reaches(members: Sequence[Kind], ratio: float, *, added: float = 0.0) -> bool:
    """Return whether stages can give a ratio together.

    Args:
        members: Kinds of the stages.
        ratio: Wanted of them all [-].
        added: Power of the motor over that of the engine [-].
    """
    ratio = held(members, ratio, added)
    least = math.prod(kind.least**kind.stages for kind in members)
    return least <= ratio <= math.prod(kind.most**kind.stages for kind in members)


def _places(members: Sequence[Kind], *, motor: bool) -> Iterator[Place]:
    """Yield every place of a motor, or the one that says there is none."""
    balanced = [number for number, kind in enumerate(members) if kind.balanced]
    if balanced:
        if motor and len(balanced) == 1:
            yield from (Place(Seat.RING, balanced[0]), Place(Seat.RIM, balanced[0]))
        return
    if not motor:
        yield Place(Seat.NONE)
        return
    for shaft in range(len(members) + 1):
        yield from (Place(Seat.SHAFT, shaft), Place(Seat.PAIR, shaft))
    for number, kind in enumerate(members):
        if kind.toothed:
            yield Place(Seat.WHEEL, number)
        if kind.branched:
            yield from (Place(Seat.BRANCH, number), Place(Seat.PINIONS, number))
