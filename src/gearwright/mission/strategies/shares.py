"""The share of an interval by its phase's strategy, found together with the loads that depend on it."""

from __future__ import annotations

from typing import NamedTuple

from gearwright.errors import DesignError, Problem
from gearwright.mission.collect import Flown
from gearwright.mission.gearbox import Point
from gearwright.mission.loading import Asked, loaded
from gearwright.mission.moments import Moment
from gearwright.mission.strategies.rules import Demand, driven, electric_share
from gearwright.mission.supply import machine_speeds
from gearwright.spec import Phase, engine_out

ROUNDS = 20
"""Most rounds in which share and loads agree: losses hardly change with the share [-]."""
AGREED = 1e-12
"""Difference of two shares that agree [-]."""


class Then(NamedTuple):
    """With what an interval starts."""

    phase: Phase
    point: Point | None
    """Of the interval before; None at the start."""
    charge: float
    """State of charge [-]."""
    planned: float
    """Share by the plan of an optimal strategy [-]."""


def shared(flown: Flown, moment: Moment, asked: Asked, then: Then) -> tuple[Phase, Asked]:
    """Return a phase as its strategy drives it in an interval, and what is then asked of the gearbox.

    Args:
        flown: Gearbox, propeller, mission and machines.
        moment: Where it is flown.
        asked: Of the gearbox, whoever drives it.
        then: With what the interval starts.

    Raises:
        DesignError: The strategy needs a machine that the design lacks.
    """
    rules = flown.mission.strategies[then.phase.strategy or ""]
    if rules.rule != "turbine-alone" and not flown.supply.motors:
        message = f"{then.phase.strategy!r} ({rules.rule}) needs a motor, and the design has none; write turbine-alone"
        raise DesignError([Problem("strategy", message)])
    share = 1.0 if rules.rule == "electric-taxi" else 0.0
    for _ in range(ROUNDS):
        phase = driven(then.phase, share)
        asked = asked._replace(parts=flown.supply.parts(phase))
        demand = _demand(flown, moment, asked, then)
        found = electric_share(rules, demand, flown.supply.battery, then.planned)
        if abs(found - share) <= AGREED:
            break
        share = found
    return phase, asked


def _demand(flown: Flown, moment: Moment, asked: Asked, then: Then) -> Demand:
    loads = loaded(flown, moment, asked, then.point)
    rating = flown.mission.engine.contingency if engine_out(flown.mission, then.phase) else 1.0
    speeds = machine_speeds(flown.gearbox, loads.point)
    working = [name for name in flown.supply.engines if name not in then.phase.inoperative]
    available = sum(min(flown.supply.limits(name, moment, speeds[name], rating)) for name in working)
    driving = [*flown.supply.engines, *flown.supply.motors]
    return Demand(sum(loads.powers[name] for name in driving), available, then.charge, moment.duration)
