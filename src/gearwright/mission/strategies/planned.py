"""Shares of optimal strategies: the demands of all intervals first, then the plan that burns least."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem
from gearwright.machines import Battery, current_of, highest_current, motor_loss
from gearwright.mission.collect import Flown
from gearwright.mission.gearbox import Point
from gearwright.mission.loading import Asked, loaded
from gearwright.mission.moments import Moment, moments, wanted_of
from gearwright.mission.strategies.plan import FORBIDDEN, Plan, Stage, optimal_plan
from gearwright.mission.strategies.rules import driven
from gearwright.mission.strategies.shares import Then, shared
from gearwright.mission.supply import machine_speeds
from gearwright.spec import Mission, Phase, StrategyRules, engine_out

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
