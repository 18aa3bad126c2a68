"""The verb: a design, and perhaps a mission, become one list of checks, worst first, and one verdict."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path

from gearwright.checks import BEYOND_SIZING, Check, Status, accepted, unknown_waivers, unneeded, worst
from gearwright.dynamics.sharing import sharing_checks
from gearwright.dynamics.vibration import SpeedCase, motion_checks
from gearwright.errors import refuse
from gearwright.mission import Durability, Flight, durability, flight_checks, fly
from gearwright.reviews.open import open_checks
from gearwright.showing import Shown
from gearwright.sizing import Named, Sizing, size, total_results
from gearwright.sizing.arrangement import envelope
from gearwright.sizing.losses import largest_heat
from gearwright.sizing.making import built_checks
from gearwright.sizing.mass import CompleteMass, Statistics, complete_mass, oil_flow, statistics_beside
from gearwright.spec import Design, Mission
from gearwright.verbs import verb


class Verdict(StrEnum):
    """What a review says of a design as a whole."""

    FAILS = "fails"
    PASSES_SO_FAR = "passes as far as assessed"
    PASSES = "passes"


@dataclass(frozen=True, repr=False)
class Review(Shown):
    """Every check of a design, worst first."""

    design: str
    """Its name."""
    mission: str
    """Name of the mission that was flown; empty without one."""
    checks: tuple[Check, ...]
    """Worst first; what is not assessed comes last."""
    facts: Mapping[str, Named]
    """What the design amounts to, by name: ``mass``, ``power_density`` …"""
    complete: CompleteMass
    """What it weighs with everything in it, part by part, with its band; machines are not in it."""
    statistics: Statistics
    """What real gearboxes of its power and speeds weigh, and how the sum of its parts stands to them."""
    unneeded: tuple[str, ...] = ()
    """Waivers of what passes."""

    @property
    def worst(self) -> Check | None:
        """The entry that every page shows; None where nothing is assessed."""
        return worst(self.checks)

    @property
    def failing(self) -> tuple[Check, ...]:
        """What fails and is not waived, worst first."""
        return tuple(check for check in self.checks if check.fails)

    @property
    def waived(self) -> tuple[Check, ...]:
        """What fails and is accepted, with the reason."""
        return tuple(check for check in self.checks if check.waiver)

    @property
    def open(self) -> tuple[Check, ...]:
        """What is not assessed, with the reason."""
        return tuple(check for check in self.checks if check.status is Status.NOT_ASSESSED)

    @property
    def verdict(self) -> Verdict:
        """One word for all of it."""
        if self.failing:
            return Verdict.FAILS
        return Verdict.PASSES_SO_FAR if self.open else Verdict.PASSES


@verb
def review(design: Design, mission: Mission | None = None, *, folder: Path | None = None) -> Review:
    """Return every check of a design: of its sizing, of its motion in every case, and of a flight if one is given.

    Args:
        design: As `gearwright.read` gives it.
        mission: What it flies; left out: lives under a mission are not assessed.
        folder: Where a propeller map is looked for that is a file.

    Raises:
        DesignError: If the design cannot be sized, the mission cannot be flown by it, or a waiver names no check.
    """
    sizing = size(design)
    if mission is None:
        return review_of(sizing)
    flight = fly(sizing, mission, folder=folder)
    return review_of(sizing, flight, durability(flight))


@verb
def review_of(
    sizing: Sizing, flight: Flight | None = None, lives: Durability | None = None, *, life: float | None = None,
    speeds: Sequence[SpeedCase] | None = None,
) -> Review:  # fmt: skip
    """Return the review of what is sized already, and perhaps flown.

    Args:
        sizing: As sized.
        flight: Of it.
        lives: Of the flight.
        life: Of gears, where another one is asked than the design's [s].
        speeds: Its `critical_speeds`, where they are known already.

    Raises:
        DesignError: If a waiver names no check.
    """
    design = sizing.design
    checks = [*sizing.checks, *built_checks(sizing), *sharing_checks(sizing), *motion_checks(sizing, speeds)]
    if flight is not None:
        checks += flight_checks(flight, lives or durability(flight), life=life)
    checks += open_checks(sizing, tuple(checks), flown=flight is not None)
    refuse(unknown_waivers(checks, design.waivers, left=BEYOND_SIZING if flight is None else ()))
    complete = complete_mass(sizing)
    return Review(
        design=design.name,
        mission=flight.mission.name if flight is not None else "",
        checks=accepted(checks, design.waivers),
        facts=total_results(sizing) | _masses(complete) | _sides(sizing) | _oil(sizing) | _flown(flight),
        complete=complete,
        statistics=statistics_beside(sizing, complete),
        unneeded=unneeded(checks, design.waivers),
    )


def _masses(complete: CompleteMass) -> dict[str, Named]:
    """Return the sum of all parts, the limits of its band of 68 % and what the train is of it, by name."""
    low, high = complete.band
    sums = {"complete_mass": complete.total, "complete_mass.low": low, "complete_mass.high": high}
    sums["complete_mass.train"] = complete.train
    return {name: Named(mass, "mass") for name, mass in sums.items()}


def _sides(sizing: Sizing) -> dict[str, Named]:
    """Return the sides of the box around all bodies, by name."""
    box = envelope(sizing)
    return {f"envelope.{side}": Named(getattr(box, side), "length") for side in ("width", "height", "length")}


def _oil(sizing: Sizing) -> dict[str, Named]:
    """Return the heat of the hottest case that lasts, and the oil that carries it away where the gearbox has
    a pump, by name."""
    heat = largest_heat(sizing)
    facts = {"heat": Named(heat, "power")}
    if sizing.design.housing.oil_system == "own":
        facts["oil_flow"] = Named(oil_flow(sizing, heat), "oil_flow")
    return facts


def _flown(flight: Flight | None) -> dict[str, Named]:
    """Return what a flight amounts to, by name."""
    if flight is None:
        return {}
    return {
        "fuel": Named(flight.fuel, "mass"),
        "battery_energy": Named(flight.balance.battery, "electric_energy"),
        "hottest_oil": Named(flight.hottest_oil, "absolute_temperature"),
    }
