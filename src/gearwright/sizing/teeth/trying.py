"""Which of the lightest combinations of teeth a preliminary sizing looks at, one after the other, and which it takes.

The search weighs gears before their modules are rounded. What rounding does, by standard modules and by speeds near a
resonance of the mesh, shows when gears are sized and rated. So they are, of one combination after the other: none with
teeth of a stage that failed or grew heavy before, and no more once one that passes is about as light as the next.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from gearwright.checks import ROUNDING
from gearwright.sizing.teeth.search import Chosen
from gearwright.sizing.teeth.states import EQUAL
from gearwright.train import Train

CONSIDERED = 60
"""Combinations of the lightest gears among which a preliminary sizing looks [-]."""
LOOKED_AT = 12
"""How many of them it sizes at most [-]."""
PROMISING = 1.05
"""Gears that pass over the estimate for the next combination, below which that one is not looked at [-]."""

StageTeeth = tuple[str, tuple[int, ...]]
"""Stage, and its teeth with its number of planets where that is open."""


def stage_teeth(train: Train, choice: Chosen) -> frozenset[StageTeeth]:
    """Return the teeth of every stage of a combination.

    Args:
        train: The graph.
        choice: The combination.
    """
    own = dict[str, tuple[int, ...]]()
    for gear in train.gears:
        own[gear.stage] = (*own.get(gear.stage, ()), choice.teeth[gear.name])
    return frozenset((stage, (*teeth, choice.planets.get(stage, 0))) for stage, teeth in own.items())


class Tried(NamedTuple):
    """A combination whose gears are sized."""

    place: int
    """Among those that are considered [-]."""
    nearness: float
    """How near its gears come to all that is asked of them [-]: 1 where they meet it."""
    mass: float
    """What they weigh [kg]."""


@dataclass
class Trying:
    """The course of looking at combinations."""

    stages: Callable[[int], frozenset[StageTeeth]]
    """Place of a combination, those of the lightest gears first -> its teeth."""
    masses: Sequence[float]
    """What the gears of every combination weigh by the estimate of the search [kg]."""
    tried: list[Tried] = field(default_factory=list)
    poor: set[StageTeeth] = field(default_factory=set)
    """Teeth of stages whose gears failed, or became heavier than the search took them for."""
    at: int = 0
    """Combinations that are looked at or passed over [-]."""
    looked: int = 0
    """Combinations that are looked at [-]."""

    def next(self) -> int | None:
        """Return the combination to look at; None where enough are known."""
        while self.looked < LOOKED_AT and self.at < len(self.masses):
            place = self.at
            if self.tried and self._is_light_enough(place):
                return None
            self.at += 1
            if not self.stages(place) & self.poor:
                self.looked += 1
                return place
        return None

    def _is_light_enough(self, place: int) -> bool:
        best = self.ranked()[0]
        return best.nearness >= 1.0 - EQUAL and best.mass <= PROMISING * self.masses[place]

    def note(self, place: int, nearness: Mapping[str, float], heaviness: Mapping[str, float], *, mass: float) -> None:
        """Note what came of a combination.

        Args:
            place: Of it.
            nearness: Stage -> least value over limit of its checks [-].
            heaviness: Stage -> volume of its gears over that by which they were found [-].
            mass: What its gears weigh [kg].
        """
        met = {stage: min(ratio / (1.0 - ROUNDING), 1.0) for stage, ratio in nearness.items()}
        poor = {stage for stage, ratio in met.items() if ratio < 1.0}
        poor |= {stage for stage, ratio in heaviness.items() if ratio > PROMISING}
        self.poor |= {teeth for teeth in self.stages(place) if teeth[0] in poor}
        self.tried.append(Tried(place, min(met.values(), default=1.0), mass))

    def ranked(self) -> list[Tried]:
        """Return what was tried, the nearest first, of equals the lightest, of these the first."""
        left, order = list(self.tried), list[Tried]()
        while left:
            best = left[0]
            for one in left[1:]:
                as_near = one.nearness >= best.nearness - EQUAL
                lighter = one.mass < best.mass * (1.0 - EQUAL)
                if one.nearness > best.nearness + EQUAL or (as_near and lighter):
                    best = one
            left.remove(best)
            order.append(best)
        return order
