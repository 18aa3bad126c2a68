"""What a closure yields: the written design, its sizing and checks, the rounds to it, and what could not be met."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property
from typing import Annotated

from gearwright.checks import Check, worst
from gearwright.closure.wishes import Wishes
from gearwright.showing import Shown
from gearwright.sizing import Sizing
from gearwright.sizing.mass import CompleteMass, complete_mass
from gearwright.spec import Design
from gearwright.units import Life, Mass, Origin, Quantity, Ratio


class Outcome(StrEnum):
    """What a closure says."""

    CLOSED = "meets everything that is assessed"
    OPEN = "does not meet everything"


class Step(StrEnum):
    """What is done in a round."""

    PROPORTION = "proportioned"
    CONFIRM = "confirmed"
    BEAR = "bearings of planets"
    SEPARATE = "other teeth or modules"
    LIGHTEN = "made lighter"
    SIMULATE = "simulated"
    FLY = "flown"


@dataclass(frozen=True)
class Round:
    """One step of the loop."""

    step: Step
    mass: Mass
    """Of gears, shafts and carriers after it [kg]."""
    margin: Ratio
    """Of the worst check that it looked at [-]."""
    change: Ratio
    """Largest relative change of a dynamic factor since the round before [-]."""
    what: str
    """In words."""


@dataclass(frozen=True)
class Unmet:
    """A requirement that no freedom of the closure meets."""

    requirement: str
    """Its name."""
    check: Check
    """The best that was found."""
    kept: str
    """What the design gives and the closure therefore does not change; empty where nothing."""
    helps: str
    """What would help."""


@dataclass(frozen=True)
class StageLife:
    """How long the gears of a stage live at the safeties that are asked."""

    stage: str
    life: Annotated[
        Life,
        Origin(
            "largest life at which the safeties against fatigue are met", "the rating of the stage, Miner, ISO 6336-6"
        ),
    ]
    """[s]"""
    governs: str
    """Check that ends it."""


@dataclass(frozen=True, repr=False)
class Closed(Shown):
    """A gearbox that meets everything, or says what it does not meet."""

    design: Design
    """With every freedom written: what `gearwright review` judges."""
    sizing: Sizing
    """Of it."""
    checks: tuple[Check, ...]
    """Everything that was looked at, worst first."""
    rounds: tuple[Round, ...]
    unmet: tuple[Unmet, ...]
    lives: tuple[StageLife, ...]
    """Of the stages whose method knows one, the shortest first."""
    kept: tuple[str, ...]
    """Paths of what the design gives and the closure does not change."""
    wishes: Wishes

    @property
    def outcome(self) -> Outcome:
        """One word for all of it."""
        return Outcome.OPEN if self.unmet else Outcome.CLOSED

    @property
    def life(self) -> Annotated[float | None, Quantity("life")]:
        """Life of the gears that fail first, at the asked safeties [s]; None where no method knows one."""
        return self.lives[0].life if self.lives else None

    @property
    def worst(self) -> Check | None:
        """The check that every page shows."""
        return worst(self.checks)

    @property
    def mass(self) -> Mass:
        """Of gears, shafts and carriers [kg]."""
        return self.sizing.mass

    @cached_property
    def whole(self) -> CompleteMass:
        """Everything in the gearbox, housing, bearings and oil included, with its band."""
        return complete_mass(self.sizing)
