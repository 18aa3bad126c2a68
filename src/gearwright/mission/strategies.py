"""Power split between turbines and motors by rules, and the split of least fuel by dynamic programming.

A rule answers interval by interval; the optimal share is planned over all of them before they are flown.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem
from gearwright.machines import Battery, current_of, highest_current, motor_loss, stored_energy
from gearwright.mission.gearbox import Point
from gearwright.mission.intervals import Asked, Flown, loaded
from gearwright.mission.profile import Moment, moments
from gearwright.mission.supply import machine_speeds
from gearwright.mission.thrust import wanted_of
from gearwright.spec import Mission, Phase, StrategyRules, engine_out

# ----------------------------------------------------------------------------------------------------------------------
# Rules by which turbines and motors divide the power of an interval.
# ----------------------------------------------------------------------------------------------------------------------


USUAL_END = 0.95
"""State of charge at which charging ends where a strategy does not say it [-]."""


class Demand(NamedTuple):
    """What an interval asks of all machines together, and what could answer."""

    power: float
    """Of all machines, with drag and spin-up; negative where the air drives the propeller [W]."""
    available: float
    """What all turbines can give [W]."""
    charge: float
    """State of charge at its start [-]."""
    duration: float
    """[s]"""


def electric_share(rules: StrategyRules, demand: Demand, battery: Battery | None, planned: float) -> float:
    """Return the motors' part of the machines' power in an interval [-]; negative charges.

    Args:
        rules: The strategy; one that is optimal is planned before.
        demand: Of the interval.
        battery: Of the motors.
        planned: Share by the plan of an optimal strategy.
    """
    power = max(demand.power, _LEAST)
    match rules.rule:
        case "share":
            return rules.electric_share or 0.0
        case "boost":
            most = min(rules.turbine_power or demand.available, demand.available)
            return min(max(1.0 - most / power, 0.0), 1.0)
        case "electric-taxi":
            return 1.0
        case "regenerate":
            return 1.0 * (demand.power < 0.0)
        case "charge":
            return -min(_charging(rules, demand, battery) / power, LARGEST_CHARGE) * (demand.power > 0.0)
        case "optimal":
            return planned
    return 0.0


LARGEST_CHARGE = 9.0
"""Most that motors take over the machines' power [-]: a tenth of the turbines' work goes on."""
_LEAST = 1e-9
"""Power that shares are at least parts of, so that arrays need no branch [W]."""


def _charging(rules: StrategyRules, demand: Demand, battery: Battery | None) -> float:
    """Return what motors take from the gearbox: as asked, as turbines can give, as the battery still holds [W]."""
    if battery is None:
        return 0.0
    end = rules.until_charge or USUAL_END
    room = stored_energy(battery, max(end, demand.charge)) - stored_energy(battery, demand.charge)
    return max(min(rules.charge_power or 0.0, demand.available - demand.power, room / demand.duration), 0.0)


def driven(phase: Phase, share: float) -> Phase:
    """Return a phase as the share of one of its intervals drives it.

    Args:
        phase: With a strategy.
        share: Motors' part of the machines' power [-].
    """
    mode = "conventional" if share == 0.0 else "electric" if share == 1.0 else "hybrid"
    return phase.model_copy(update={"mode": mode, "electric_share": share if mode == "hybrid" else None})


# ----------------------------------------------------------------------------------------------------------------------
# The share of an interval by its phase's strategy, found together with the loads that depend on it.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# The optimal share: dynamic programming over the state of charge, backwards from the end of a mission.
# ----------------------------------------------------------------------------------------------------------------------


FORBIDDEN = 1e9
"""Fuel of what cannot be flown [kg]."""
SHORT = 1e6
"""Fuel for a state of charge that lacks 1 at the end [kg]: more than any engine saves by it."""


class Stage(NamedTuple):
    """What shares cost in an interval."""

    fuel: Floats
    """Of every share; `FORBIDDEN` where a machine cannot give it, shape (shares,) [kg]."""
    after: Callable[[Floats], Floats]
    """States of charge, shape (charges,) -> after the interval, shape (charges, shares) [-]; NaN: cannot be."""


class Plan(NamedTuple):
    """Shares that burn least."""

    shares: tuple[int, ...]
    """Of every interval the place of its share among those that were tried."""
    charge: tuple[float, ...]
    """State of charge after it [-]."""
    fuel: float
    """[kg]"""


def optimal_plan(stages: Sequence[Stage], charges: Floats, *, start: float, end: float) -> Plan:
    """Return the shares with the least fuel that leave a state of charge at the end.

    Args:
        stages: Intervals in their order.
        charges: States of charge at which the least fuel from there on is kept, rising, shape (charges,) [-].
        start: State of charge at the start [-].
        end: At least left at the end [-].

    Source: Bellman 1957: J_k(s) = min_u (g_k(u) + J_(k+1)(f_k(s, u))), linear between the states of charge.
    """
    costs = [SHORT * np.maximum(end - charges, 0.0)]
    for stage in reversed(stages):
        costs.append(_whole(stage, charges, costs[-1], charges).min(axis=1))
    costs.reverse()
    places, states, fuel, now = list[int](), list[float](), 0.0, start
    for stage, later in zip(stages, costs[1:], strict=True):
        at = np.array([now])
        place = int(np.argmin(_whole(stage, charges, later, at)[0]))
        fuel += float(stage.fuel[place])
        now = float(stage.after(at)[0, place])
        places.append(place)
        states.append(now)
    return Plan(tuple(places), tuple(states), fuel)


def _whole(stage: Stage, charges: Floats, later: Floats, at: Floats) -> Floats:
    """Return the fuel of every share from some states of charge to the end, shape (at, shares) [kg]."""
    after = stage.after(at)
    inside = (after >= charges[0] - 1e-12) & (after <= charges[-1] + 1e-12)
    cost = np.interp(np.where(inside, after, charges[0]), charges, later) + stage.fuel
    return np.minimum(np.where(inside, cost, FORBIDDEN), FORBIDDEN)


# ----------------------------------------------------------------------------------------------------------------------
# Shares of optimal strategies: the demands of all intervals first, then the plan that burns least.
# ----------------------------------------------------------------------------------------------------------------------


MARGIN = 1e-3
"""Part of limits of machines and battery that a plan leaves: it knows demands one round before they are flown."""
USUAL_SHARES, USUAL_CHARGES = 41, 101
_ROUNDS = 2
"""Plans, each with the demands of the last one's shares."""


class Need(NamedTuple):
    """What an interval needs of the machines."""

    moment: Moment
    phase: Phase
    """As it was driven."""
    power: float
    """Of turbines and motors together [W]."""
    speeds: Mapping[str, float]
    """Machine -> speed without sense [rad/s]."""
    share: float
    """Motors' part [-]."""


def planned_shares(flown: Flown) -> Mapping[int, float]:
    """Return interval -> share of optimal strategies [-]; nothing where no phase has one.

    Args:
        flown: Gearbox, propeller, mission and machines.
    """
    mission = flown.mission
    asking = {name: mission.strategies[phase.strategy] for name, phase in mission.phases.items() if phase.strategy}
    optimal = {name: rules for name, rules in asking.items() if rules.rule == "optimal"}
    if not optimal or not flown.supply.battery or not flown.supply.engines:
        return {}
    rules = next(iter(optimal.values()))
    tried = np.linspace(rules.lowest_share or 0.0, 1.0, rules.shares or USUAL_SHARES)
    tried = np.unique(np.append(tried, 0.0))  # the turbine alone is always one of them
    plan: Mapping[int, float] = {}
    for _ in range(_ROUNDS):
        needs = _needs(flown, plan)
        stages = [
            _stage(flown, need, tried if need.moment.phase in optimal else np.array([need.share])) for need in needs
        ]
        found = _best(flown, rules, stages, last_of(needs, optimal))
        plan = {k: float(tried[found.shares[k]]) for k, need in enumerate(needs) if need.moment.phase in optimal}
    return plan


def has_plan(mission: Mission) -> bool:
    """Tell whether shares of a mission are planned before it is flown.

    Args:
        mission: As read.
    """
    asking = (mission.strategies[phase.strategy] for phase in mission.phases.values() if phase.strategy)
    return any(rules.rule == "optimal" for rules in asking)


def last_of(needs: list[Need], optimal: Mapping[str, StrategyRules]) -> int:
    """Return how many intervals there are up to the end of the last optimal phase.

    Args:
        needs: Of all intervals.
        optimal: Phases with an optimal strategy.
    """
    return 1 + max(k for k, need in enumerate(needs) if need.moment.phase in optimal)


def _best(flown: Flown, rules: StrategyRules, stages: list[Stage], count: int) -> Plan:
    battery, start = flown.supply.battery, flown.mission.battery
    assert battery is not None and start is not None  # there is a plan only with one
    end = max(rules.end_charge if rules.end_charge is not None else battery.minimum, battery.minimum) + MARGIN
    grid = np.unique(np.append(np.linspace(battery.minimum, 1.0, rules.charges or USUAL_CHARGES), min(end, 1.0)))
    plan = optimal_plan(stages[:count], grid, start=start.start_charge, end=end)
    if plan.fuel >= FORBIDDEN:
        message = "no shares of turbines and motors can fly its phases; charge less before, or ask for less power"
        raise DesignError([Problem("strategies", message)])
    return plan


def _needs(flown: Flown, plan: Mapping[int, float]) -> list[Need]:
    """Return what every interval needs, with the shares of a plan; limits are not looked at."""
    mission, before, burnt, needs = flown.mission, None, 0.0, list[Need]()
    charge = mission.battery.start_charge if mission.battery else 0.0
    for k, moment in enumerate(moments(mission, flown.paths)):
        phase = mission.phases[moment.phase]
        wanted = wanted_of(flown.blades, mission, moment, burnt=burnt).power
        gain = flown.gearbox.inertia * moment.propeller_speed * moment.propeller_gain / moment.duration
        asked = Asked(flown.supply.parts(phase), wanted, gain)
        if phase.strategy is not None:
            phase, asked = shared(flown, moment, asked, Then(phase, before, charge, plan.get(k, 0.0)))
        need, before = _need(flown, moment, phase, asked, before)
        burnt += float(_fuel(flown, need, np.array([need.share]))[0]) * (phase.engines or mission.engines)
        needs.append(need)
    return needs


def _need(flown: Flown, moment: Moment, phase: Phase, asked: Asked, before: Point | None) -> tuple[Need, Point]:
    loads = loaded(flown, moment, asked, before)
    share = sum(asked.parts.get(name, 0.0) for name in flown.supply.motors)
    power = sum(loads.powers[name] for name in (*flown.supply.engines, *flown.supply.motors))
    return Need(moment, phase, power, machine_speeds(flown.gearbox, loads.point), share), loads.point


def _parts(flown: Flown, need: Need, share: float) -> Mapping[str, float]:
    return flown.supply.parts(driven(need.phase, share))


def _fuel(flown: Flown, need: Need, shares: Floats) -> Floats:
    """Return what all turbines burn in an interval at some shares, without limits [kg]."""
    supply = flown.supply
    burnt = np.zeros(len(shares))
    for place, share in enumerate(shares.tolist()):
        for name, part in _parts(flown, need, share).items():
            if name in supply.engines and part * need.power > 0.0:
                burnt[place] += supply.fuel(name, need.moment, part * need.power)
    return burnt * need.moment.duration


def _stage(flown: Flown, need: Need, shares: Floats) -> Stage:
    battery = flown.supply.battery
    assert battery is not None  # there is a plan only with one
    fuel, electric = _fuel(flown, need, shares), np.zeros(len(shares))
    for place, share in enumerate(shares.tolist()):
        parts = _parts(flown, need, share)
        if len(shares) > 1 and not _within(flown, need, parts):
            fuel[place] = FORBIDDEN
        for name, motor in flown.supply.motors.items():
            if (power := parts.get(name, 0.0) * need.power) and need.speeds[name]:
                electric[place] += power + motor_loss(motor, power / need.speeds[name], need.speeds[name])
    return Stage(fuel, lambda charges: _after(battery, charges, electric, need.moment.duration))


def _within(flown: Flown, need: Need, parts: Mapping[str, float]) -> bool:
    """Tell whether machines can give their parts."""
    supply, mission = flown.supply, flown.mission
    rating = mission.engine.contingency if engine_out(mission, need.phase) else 1.0
    for name, part in parts.items():
        power, speed = part * need.power, need.speeds[name]
        if name in supply.engines:
            if power > min(supply.limits(name, need.moment, speed, rating)) * (1.0 - MARGIN) or power < 0.0:
                return False
        elif abs(power) > min(supply.motors[name].peak_power, supply.motors[name].peak_torque * speed) * (1.0 - MARGIN):
            return False
    return True


def _after(battery: Battery, charges: Floats, electric: Floats, duration: float) -> Floats:
    """Return states of charge after an interval, shape (charges, shares) [-]; NaN where the battery cannot."""
    current, square = current_of(battery, charges[:, None], electric[None, :], duration)
    final = charges[:, None] - current * duration / battery.charge
    faulty = (square < 0.0) | (np.abs(current) > highest_current(battery) * (1.0 - MARGIN)) | (final > 1.0)
    return np.where(faulty, np.nan, final)
