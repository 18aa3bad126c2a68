"""What the search for teeth works on: a front of partial choices as arrays, and one task per stage."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, fields
from typing import Any, NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats, Ints
from gearwright.sizing.rating import Load, Rating
from gearwright.spec import Pair, Planetary
from gearwright.spec.design import ForbiddenBand, StageShifts
from gearwright.train import Edge


@dataclass(frozen=True)
class Front:
    """All partial choices: every array has one entry per choice."""

    teeth: Mapping[str, Ints]
    """Gear -> tooth numbers."""
    speeds: Mapping[str, Floats]
    """Shaft -> speed that the teeth give [rad/s]."""
    cubes: Mapping[str, Floats]
    """Group of gears with one module -> m_n³ [m³]."""
    volumes: Mapping[str, Floats]
    """Group -> mass of its bodies over m_n³ [kg/m³]."""
    planets: Mapping[str, Ints] = field(default_factory=dict)
    """Planetary set -> number of its planets [-]."""
    tally: Mapping[str, Floats] = field(default_factory=dict)
    """What a choice stands for: ``combinations`` of teeth that it was the lightest of [-], and the mass of the
    ``second`` lightest of them [kg]."""

    def __len__(self) -> int:
        """Return how many choices there are."""
        return len(next(iter(self.speeds.values())))

    @property
    def mass(self) -> Floats:
        """Mass of the gears chosen so far [kg]."""
        parts = [self.cubes[group] * self.volumes[group] for group in self.cubes]
        return np.sum(parts, axis=0) if parts else np.zeros(1)

    def take(self, index: Ints | Bools) -> Front:
        """Return the choices of an index, repeated where it repeats them, or those that are marked."""
        return self._of_parts(lambda values: values[0][index], self)

    def joined(self, others: Sequence[Front]) -> Front:
        """Return the choices of this front and, after them, those of others that chose for the same stages."""
        return self._of_parts(np.concatenate, self, *others)

    @staticmethod
    def _of_parts(made: Callable[[list[Any]], Any], *fronts: Front) -> Front:
        """Return a front whose every array is made of those of the same name."""
        parts = [[getattr(front, part.name) for front in fronts] for part in fields(Front)]
        return Front(*({name: made([part[name] for part in same]) for name in same[0]} for same in parts))


class Ban(NamedTuple):
    """A forbidden band of frequencies as one stage is held against it."""

    name: str
    band: ForbiddenBand
    factor: float
    """Speeds of the case over those of the search [-]."""


@dataclass(frozen=True)
class Task:
    """One stage of the search."""

    name: str
    stage: Pair | Planetary
    edge: Edge | None
    group: str
    rating: Rating
    torque: float
    """Largest nominal torque on the stage's reference gear, of one mesh or of all planets, K_γ included [N m]."""
    speed: float
    """Nominal speed of the edge's fast shaft; where the teeth let it turn faster, the torque is less [rad/s]."""
    rolling: float
    """Nominal speed of pinion or sun against the carrier [rad/s]."""
    rows: tuple[Load, ...] = ()
    """Of each loaded row of a bevel pair the heaviest case over the whole life, without teeth."""
    made: bool = False
    """Whether gears are weighed with rims and webs, as at a preliminary level."""
    twin: str = ""
    """Stage before it whose teeth it has, because what both do is the same; empty where it has none."""
    deviation: int = 0
    """z_r − (z_s + 2 z_p) of a ring that is chosen [-]."""
    bans: tuple[Ban, ...] = ()
    """Bands of frequencies at which nothing of it passes."""
    row: Ints | None = None
    """Of many designs, that which every choice belongs to; torque, speed and rolling are then those of every choice."""
    factors: Mapping[int, float] = field(default_factory=dict)
    """Number of planets that is looked at -> its K_γ [-]; empty of pairs."""
    steady: float = 1.0
    """Load for which tips are relieved over the largest one [-]."""
    fastest: float = 1.0
    """Greatest rolling speed over the one at the largest load [-]."""
    known: dict[tuple[int, int, int, int], tuple[float, float]] = field(default_factory=dict, compare=False, repr=False)
    """Teeth of pinion or sun, of wheel or planet, number of planets, deviation of the ring -> m_n³ [m³] and λ = b/m_n
    [-] at nominal load, as far as found."""
    closed: dict[tuple[int, int, int], StageShifts | None] = field(default_factory=dict, compare=False, repr=False)
    """Teeth of sun, planet and ring -> shifts that close them, as far as looked for; None where none do."""
