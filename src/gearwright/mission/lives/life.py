"""A life asked for: size, fly, strengthen the stage that fails first, until every gear lives long enough."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

from gearwright.errors import DesignError, Problem, SolveError
from gearwright.mission.flight import Flight
from gearwright.mission.fly import fly
from gearwright.mission.lives.bearings import BearingLives, bearing_lives
from gearwright.mission.lives.damage import GearDamage, gear_damage, unrated_stages
from gearwright.showing import Shown
from gearwright.sizing import Sizing, size
from gearwright.sizing.rating import method_for, rating_of
from gearwright.spec import Design, GearRules, Mission, Record
from gearwright.units import Mass
from gearwright.verbs import verb

STRENGTHENING = 1.04
"""Factor on the safety factor that governs, in each round [-]."""
MOST_ROUNDS = 200
"""Rounds after which a target counts as out of reach [-]."""


@dataclass(frozen=True, repr=False)
class LifeSizing(Shown):
    """A design strengthened until it lives."""

    sizing: Sizing
    flight: Flight
    damages: tuple[GearDamage, ...]
    """Of the strengthened gears, the worst first."""
    hours: float
    """Life that was asked for [h]."""
    path: tuple[tuple[float, Mass], ...]
    """Life [h] of the gear that fails first and mass of the gearbox [kg], before every round and at the end."""
    bearings_before: Mass
    """Of the bearings that the mission asks for without this life [kg]."""
    bearings: BearingLives
    """Chosen for this life, where the mission asks for bearings."""

    @property
    def mass_before(self) -> Mass:
        """Of the gearbox as the design asked [kg]."""
        return self.path[0][1]

    @property
    def rounds(self) -> int:
        """How often a stage was strengthened [-]."""
        return len(self.path) - 1

    @property
    def mass_of_life(self) -> Mass:
        """What the life costs in gears, shafts and carriers [kg]."""
        return self.sizing.mass - self.mass_before


@verb
def size_for_life(design: Design, mission: Mission, hours: float, *, folder: Path | None = None) -> LifeSizing:
    """Return a design's sizing with which every gear lives a number of flight hours of a mission.

    The stage of the gear that fails first gets a larger safety factor, in bending or in contact as it fails, and the
    design is sized again. Torques hardly depend on sizes, so a flight is flown again only where teeth have changed, and
    once at the end.

    Args:
        design: As read.
        mission: What is flown.
        hours: Life that is asked for, of flight hours [h].
        folder: Where a propeller map is looked for that is a file.

    Source: Miner 1945, sum 1 at the end of the life, by the method of each stage as in `gear_damage`.

    Raises:
        SolveError: No strengthening reaches the life.
        DesignError: The mission cannot be flown, or ISO 6336 does not rate its gears.
    """
    if unrated_stages(design):
        stage = unrated_stages(design)[0]
        message = f"stage {stage} has {design.pairs[stage].kind} gears; no standard rates their damage"
        raise DesignError([Problem("life", f"{message}, so that no life can be asked of it")])
    sizing = size(design)
    flight = fly(sizing, mission, folder=folder)
    before, lasting, path = bearing_lives(flight).mass, _lasting(mission, hours), []
    for _ in range(MOST_ROUNDS):
        worst = gear_damage(flight)[0]
        path.append((worst.life, sizing.mass))
        if worst.life >= hours:
            flight = fly(sizing, lasting, folder=folder)
            damages = gear_damage(flight)
            if damages[0].life >= hours:
                return LifeSizing(sizing, flight, damages, hours, tuple(path), before, bearing_lives(flight))
            worst = damages[0]
        design = strengthened(design, worst)
        teeth, sizing = sizing.teeth, size(design)
        flight = replace(flight, sizing=sizing) if sizing.teeth == teeth else fly(sizing, mission, folder=folder)
    message = f"{worst.gear} reaches {worst.life:.0f} h of {hours:.0f} h after {MOST_ROUNDS} rounds; ask for less"
    raise SolveError(f"life: {message}, or take a better steel under [gears] of the mission")


def _lasting(mission: Mission, hours: float) -> Mission:
    """Return a mission whose bearings are chosen for a life."""
    if mission.bearings is None:
        return mission
    return mission.model_copy(update={"bearings": mission.bearings.model_copy(update={"life": 3600.0 * hours})})


def strengthened(design: Design, worst: GearDamage) -> Design:
    """Return a design whose weakest stage has a larger safety factor.

    Args:
        design: As it is.
        worst: The gear that fails first.
    """
    stage = worst.part.name
    path = method_for(rating_of(design, stage)).safeties[worst.mode]
    stronger = _raised(design.stages[stage].gears or GearRules(), design.rules(stage), path)
    table = design.kind(stage)
    stages = dict(getattr(design, table))
    stages[stage] = stages[stage].model_copy(update={"gears": stronger})
    return design.model_copy(update={table: stages})


def _raised(own: Record, rules: Record, path: tuple[str, ...]) -> Record:
    """Return a stage's own rules with a safety factor above the one that holds for it."""
    name, *rest = path
    held = getattr(rules, name)
    raised = _raised(getattr(own, name), held, tuple(rest)) if rest else held * STRENGTHENING
    return own.model_copy(update={name: raised})
