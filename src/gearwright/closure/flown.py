"""A closed design on a mission: where gears do not live through its flights, their stages are proportioned anew."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from pathlib import Path

from gearwright.checks import Check, Status
from gearwright.closure.closed import Round, Step
from gearwright.closure.loop import MOST_ROUNDS, Settled, settled
from gearwright.closure.proportion import searched
from gearwright.closure.requirements import requirement_of, wanted
from gearwright.identity import GEARBOX
from gearwright.mission import durability, flight_checks, fly
from gearwright.spec import Mission

IN_FLIGHT = "life in flight"
"""Requirement for which stages are proportioned anew."""
ABOVE = 1.001
"""Factor on the margin that a flight asks for, as the next size is loaded a little otherwise [-]."""


@dataclass(frozen=True)
class OnMission:
    """What is flown."""

    mission: Mission
    folder: Path | None = None
    """Where a propeller map is looked for that is a file."""


def lived(state: Settled, asked: OnMission, tell: Callable[[str], None]) -> tuple[Settled, list[Check]]:
    """Return a design whose gears live through their flights, and the checks of the last flight.

    At most eight flights; if gears do not live then that the search may change, a check of the convergence fails.

    Args:
        state: From the loop.
        asked: What is flown.
        tell: Called with what is being done.

    Raises:
        DesignError: If the mission cannot be flown.
    """
    for number in range(1, MOST_ROUNDS + 1):
        tell(f"flying {asked.mission.name}")
        flight = fly(state.sizing, asked.mission, folder=asked.folder)
        checks = wanted(flight_checks(flight, durability(flight)), state.task.wishes.left_out)
        factors = _asked_by(state, checks)
        if not factors:
            return state, checks
        if number == MOST_ROUNDS:
            break
        words = "; ".join(f"{stage} bears {factor:.3f} times its cases" for stage, factor in factors.items())
        round_ = Round(Step.FLY, state.sizing.mass, min(1.0 / factor for factor in factors.values()), 0.0, words)
        targets = {stage: state.task.targets.get(stage, 1.0) * ABOVE * factor for stage, factor in factors.items()}
        again = settled(replace(state.task, targets={**state.task.targets, **targets}))
        state = replace(again, rounds=(*state.rounds, round_, *again.rounds))
    clause = f"{MOST_ROUNDS} flights: gears of {', '.join(factors)} live through them"
    least = 1.0 / max(factors.values())
    return state, [*checks, Check(GEARBOX, "convergence of the closure in flight", clause, least, 1.0, exponent=None)]


def _asked_by(state: Settled, checks: Iterable[Check]) -> dict[str, float]:
    """Return stage -> factor by which its gears would have to bear more, where the search may change it [-]."""
    open_, factors = set(searched(state.task.design)), dict[str, float]()
    for check in checks:
        if check.status is Status.FAILS and requirement_of(check) == IN_FLIGHT and check.reserve:
            stage = check.part.name
            if stage in open_:
                factors[stage] = max(factors.get(stage, 1.0), 1.0 / check.reserve)
    return factors
