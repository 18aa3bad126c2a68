"""Mass items of the complete gearbox with their sources, and calibration to published gearboxes."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Annotated

from gearwright.base import DesignError, Mass, Origin, Quantity, Ratio, Shown, largest, largest_first, text
from gearwright.catalogue import MassClass, mass_classes
from gearwright.sizing.bearing_arrangement import bare_shafts
from gearwright.sizing.result import Sizing
from gearwright.weights import Requirement, bands, estimate, methods

# ----------------------------------------------------------------------------------------------------------------------
# The complete mass of a gearbox as a record: every part with how well it is known and where its number comes from.
# ----------------------------------------------------------------------------------------------------------------------


GROUPS = ("gears", "shafts", "carriers", "bearings", "housing", "reaction", "lubrication", "details")
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


# ----------------------------------------------------------------------------------------------------------------------
# How well sums agree with published gearboxes. Nothing in a sum is fitted to them; each class has one factor beside it.
# ----------------------------------------------------------------------------------------------------------------------


DETAILS = 0.05
"""What no rule counts (splines, nuts, spacers, plugs) over the parts that are counted [-], an estimate."""


def class_of(sizing: Sizing) -> MassClass:
    """Return the class of published gearboxes that a design is held against: wind turbines' lean on torque arms.

    Args:
        sizing: As sized.
    """
    return mass_classes()["wind" if sizing.design.housing.reaction == "torque-arms" else "aircraft"]


# ----------------------------------------------------------------------------------------------------------------------
# The sum of parts beside the statistics of real gearboxes, and what to make of a difference.
# ----------------------------------------------------------------------------------------------------------------------


_LEVEL = 0.68
"""Probability of both bands that are compared [-]."""


@dataclass(frozen=True)
class Statistics:
    """What the refit of real gearboxes says of a design's power and speeds, or why it says nothing."""

    mass: Mass | None
    """Median of its kind [kg]; None outside the range of the weights."""
    low: Mass | None
    """Lower limit of the 68 % band [kg]."""
    high: Mass | None
    """Upper limit of the 68 % band [kg]."""
    sentence: str
    """How the sum of parts stands to it."""


def requirement_of(sizing: Sizing) -> Requirement | None:
    """Return power, fastest driving and slowest driven speed of a design; None where it does not reduce speed.

    Args:
        sizing: As sized.
    """
    flow, machines = sizing.reference, sizing.design.machines
    powers = {name: power for name, power in flow.machine_powers.items() if power}
    driving = [abs(flow.speeds[machines[name].shaft]) for name, power in powers.items() if power > 0.0]
    driven = {name: -power for name, power in powers.items() if power < 0.0}
    if not driving or not driven:
        return None
    most = largest(driven, lambda name: driven[name])
    try:
        return Requirement(sizing.rated_power, max(driving), abs(flow.speeds[machines[most].shaft]))
    except DesignError:
        return None


def band_of(need: Requirement) -> tuple[float, float, float] | None:
    """Return median and 68 % limits of the refit [kg]; None outside the range of its weights.

    Args:
        need: Power and speeds.
    """
    refit = estimate(next(method for method in methods() if method.key == "refit"), need)
    if refit.mass is None:
        return None
    (band,) = bands(need, (_LEVEL,))
    return refit.mass, band.low, band.high


def statistics_beside(sizing: Sizing, mass: CompleteMass) -> Statistics:
    """Return the refit's band for a design, and a sentence on the sum of its parts.

    Args:
        sizing: As sized.
        mass: Its complete mass.
    """
    need, beside = requirement_of(sizing), _held_against(class_of(sizing)) + _cramped(mass) + _without(sizing)
    if need is None:
        said = "No statistics: they are of gearboxes that reduce an engine's speed."
        return Statistics(None, None, None, said + beside)
    found = band_of(need)
    if found is None:
        return Statistics(None, None, None, "No statistics: its β is outside that of the 61 weights." + beside)
    median, low, high = found
    return Statistics(median, low, high, _sentence(mass, median, (low, high)) + beside)


def _held_against(own: MassClass) -> str:
    """Say what was fitted to the published gearboxes of a class: one factor, which is in no sum."""
    if own.gearboxes == 0:
        return ""
    return (
        f" {own.gearboxes} {own.members} weigh {own.factor:.2f} times their sums of parts, each within a factor of"
        f" {own.scatter:.2f}: that factor was fitted to them, and is not in this sum."
    )


def _cramped(mass: CompleteMass) -> str:
    """Say whose bearings are lighter than their load asks."""
    if not mass.crowded:
        return ""
    return (
        f" The bearings of {' and '.join(mass.crowded)} are weighed as large as there is room, and their load asks for"
        " larger ones: gearwright close finds what lives."
    )


def _without(sizing: Sizing) -> str:
    """Say whose bearings are not in the sum."""
    bare = bare_shafts(sizing)
    return f" Bearings of {' and '.join(bare)} are not in it: gearwright arrange puts them in." if bare else ""


def _sentence(mass: CompleteMass, median: float, band: tuple[float, float]) -> str:
    """Say whether two bands of 68 % meet."""
    low, high = mass.band
    said = f"61 real gearboxes: {_kg(median)}, 68 % from {_kg(band[0])} to {_kg(band[1])}"
    if low <= band[1] and high >= band[0]:
        return f"{said}; the bands meet."
    way = "lighter" if high < band[0] else "heavier"
    return (
        f"{said}: the sum of parts is {way}, and the bands do not meet. Where requirements are not met yet"
        " (gearwright review), or life and loads that are asked differ from those of aircraft, the sum is not that of a"
        " gearbox that flies."
    )


def _kg(mass: float) -> str:
    return text(mass, "mass", 3)
