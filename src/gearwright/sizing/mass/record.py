"""The complete mass of a gearbox as a record: every part with how well it is known and where its number comes from."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Annotated

from gearwright.ranking import largest_first
from gearwright.showing import Shown
from gearwright.units import Mass, Origin, Quantity, Ratio

GROUPS = ("gears", "shafts", "carriers", "bearings", "housing", "lubrication", "details")
"""Groups of parts, in the order of tables."""
TRAIN = ("gears", "shafts", "carriers")
"""Groups that are the train itself; what carries, closes and oils it are the others."""
CROWDED = "what the room between pin and rim holds: less than (C/c)^1.5 for load and life"
"""Formula of a planet's bearing that does not fit."""


@dataclass(frozen=True)
class MassItem:
    """One part, or several equal ones."""

    part: str
    group: str
    """One of `GROUPS`."""
    count: int
    """How many of it [-]."""
    each: Mass
    """Of one [kg]."""
    uncertainty: Annotated[
        float, Quantity("percent"), Origin("one standard deviation over the value", "estimate of its rule's scatter")
    ]
    """One standard deviation of the value, over the value [-]."""
    formula: str
    """By which it is found."""
    source: str
    """Of the formula, or whose estimate it is."""

    @property
    def total(self) -> Mass:
        """Of all [kg]."""
        return self.count * self.each


@dataclass(frozen=True)
class MassGroup:
    """The parts of one kind together."""

    group: str
    total: Mass
    """[kg]"""
    share: Annotated[float, Quantity("percent")]
    """Of the whole [-]."""
    deviation: Mass
    """One standard deviation [kg]."""


@dataclass(frozen=True, repr=False)
class CompleteMass(Shown):
    """What a gearbox weighs with everything in it: the sum of its parts, with a band."""

    design: str
    """Its name."""
    parts: tuple[MassItem, ...]
    """In the order of groups, the heaviest of each first."""
    scatter: Ratio
    """Factor of one standard deviation by which sums differ from published gearboxes [-]; 1 where it is not known."""

    @property
    def crowded(self) -> tuple[str, ...]:
        """Planets whose bearing is weighed as large as there is room, which is less than its load and life ask."""
        return tuple(sorted(item.part for item in self.parts if item.formula == CROWDED))

    @cached_property
    def total(self) -> Mass:
        """Sum of all parts [kg]."""
        return math.fsum(item.total for item in self.parts)

    @property
    def train(self) -> Mass:
        """Of gears, shafts and carriers, bodies as manufactured like those of the total [kg]."""
        return math.fsum(item.total for item in self.parts if item.group in TRAIN)

    @cached_property
    def deviation(self) -> Annotated[float, Quantity("mass"), Origin("√Σ (Σ s)²", "groups apart, parts of one alike")]:
        """One standard deviation by the parts' own uncertainties [kg]: a group errs as one, groups apart."""
        return math.sqrt(math.fsum(group.deviation**2 for group in self.groups))

    @property
    def factor(self) -> Annotated[float, Quantity("ratio"), Origin("max(1 + s/m, scatter)", "parts; held against")]:
        """Factor of one standard deviation, by parts or by published gearboxes, whichever is wider [-]."""
        return max(1.0 + self.deviation / self.total, self.scatter) if self.total else self.scatter

    @property
    def band(self) -> tuple[Mass, Mass]:
        """Limits of one standard deviation, 68 % [kg]."""
        return self.total / self.factor, self.total * self.factor

    @cached_property
    def groups(self) -> tuple[MassGroup, ...]:
        """Sum of every group that has parts."""
        return tuple(self._group(name) for name in GROUPS if any(item.group == name for item in self.parts))

    def of(self, group: str) -> Mass:
        """Return the sum of one group, zero where it has no parts [kg].

        Args:
            group: One of `GROUPS`.
        """
        return math.fsum(item.total for item in self.parts if item.group == group)

    def _group(self, name: str) -> MassGroup:
        own = [item for item in self.parts if item.group == name]
        total = math.fsum(item.total for item in own)
        return MassGroup(name, total, total / self.total, math.fsum(item.uncertainty * item.total for item in own))


def ordered(items: Iterable[MassItem]) -> tuple[MassItem, ...]:
    """Return parts by group, the heaviest of each first; what weighs nothing is left out.

    Args:
        items: In any order.
    """
    return tuple(
        sorted(
            largest_first((item for item in items if item.total), lambda item: item.total),
            key=lambda item: GROUPS.index(item.group),
        )
    )
