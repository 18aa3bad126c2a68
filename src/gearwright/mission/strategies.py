"""Power split between turbines and motors by rules, and the split of least fuel by dynamic programming.

A rule answers interval by interval; the optimal share is planned over all of them before they are flown.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from gearwright.base import Bools, DesignError, Floats, Ints, Problem
from gearwright.elementwise import Values, functions
from gearwright.machines import Battery, current_of, highest_current, motor_loss, stored_energy
from gearwright.mission.gearbox import torque_of
from gearwright.mission.plant import started, warm_motor, warmed_motor
from gearwright.mission.profile import Course, Doubt, Stretch
from gearwright.mission.supply import Supply, fuel_along, limits_along
from gearwright.spec import Mission, Phase, StrategyRules

# ----------------------------------------------------------------------------------------------------------------------
# Rules by which turbines and motors divide the power of an interval.
# ----------------------------------------------------------------------------------------------------------------------


USUAL_END = 0.95
"""State of charge at which charging ends where a strategy does not say it [-]."""


class Demand(NamedTuple):
    """What an interval asks of all machines together, and what could answer."""

    power: Values
    """Of all machines, with drag and spin-up; negative where the air drives the propeller [W]."""
    available: Values
    """What all turbines can give [W]."""
    charge: Values
    """State of charge at its start [-]."""
    duration: Values
    """[s]"""


def electric_share(rules: StrategyRules, demand: Demand, battery: Battery | None, planned: Values) -> Values:
    """Return the motors' part of the machines' power in an interval [-]; negative charges.

    Args:
        rules: The strategy; one that is optimal is planned before.
        demand: Of the interval, or of many by a rule that does not look at the battery.
        battery: Of the motors.
        planned: Share by the plan of an optimal strategy.
    """
    of = functions(demand.power)
    power = of.max(demand.power, _LEAST)
    match rules.rule:
        case "share":
            return rules.electric_share or 0.0
        case "boost":
            most = of.min(rules.turbine_power or demand.available, demand.available)
            return of.min(of.max(1.0 - most / power, 0.0), 1.0)
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
    return float(max(min(rules.charge_power or 0.0, demand.available - demand.power, room / demand.duration), 0.0))


def driven(phase: Phase, share: float) -> Phase:
    """Return a phase as the share of one of its intervals drives it.

    Args:
        phase: With a strategy.
        share: Motors' part of the machines' power [-].
    """
    mode = "conventional" if share == 0.0 else "electric" if share == 1.0 else "hybrid"
    return phase.model_copy(update={"mode": mode, "electric_share": share if mode == "hybrid" else None})


# ----------------------------------------------------------------------------------------------------------------------
# Strategies in many intervals at once: the share that a rule gives, and what machines then give.
# ----------------------------------------------------------------------------------------------------------------------


AGREED = 1e-12
"""Difference of two shares that agree [-]."""
_CHARGE = "charge"
"""The rule whose share follows from the battery."""


class Strategies(NamedTuple):
    """Which intervals follow which rules."""

    rows: tuple[tuple[StrategyRules, Ints], ...]
    """Rules, and the intervals that follow them."""
    follows: Bools
    """Where there is a rule, shape (n,)."""
    weights: Mapping[str, Floats]
    """Machine -> part of what turbines, or motors, give together, shape (n,) [-]."""
    working: Mapping[str, Bools]
    """Turbine -> where it is not out, shape (n,)."""
    charging: Mapping[int, StrategyRules]
    """Interval -> its rule, of those that look at the battery."""
    planned: Floats
    """Share by the plan of an optimal strategy, shape (n,) [-]."""

    def begun(self) -> Floats:
        """Return shares to begin with, shape (n,) [-]."""
        share = np.zeros(len(self.follows))
        for rule, rows in self.rows:
            share[rows] = 1.0 if rule.rule == "electric-taxi" else 0.0
        return share

    def parts(self, deck_parts: Mapping[str, Floats], share: Floats) -> dict[str, Floats]:
        """Return machine -> part of the power of all machines, shape (n,) [-].

        Args:
            deck_parts: Those where there is no strategy.
            share: Of the motors, shape (n,) [-].
        """
        turbines = self.working.keys()
        return {
            name: np.where(self.follows, (1.0 - share if name in turbines else share) * self.weights[name], part)
            for name, part in deck_parts.items()
        }

    def shares(self, demand: Demand) -> Floats:
        """Return motors' part of the machines' power, shape (n,) [-]; 0 where it follows from the battery.

        Args:
            demand: Fields of shape (n,).

        Source: `electric_share`.
        """
        share, columns = np.zeros(len(self.follows)), [np.asarray(column) for column in demand]
        for rule, rows in self.rows:
            if rule.rule != _CHARGE:
                some: Any = [column[rows] for column in columns]
                share[rows] = electric_share(rule, Demand(*some), None, self.planned[rows])
        return np.where(np.abs(share) <= AGREED, 0.0, share)

    def charged(self, supply: Supply, demand: Demand, at: Charging) -> None:
        """Set the shares of a flight that follow from its battery, interval after interval.

        Args:
            supply: With battery and motors.
            demand: Fields of shape (n,); its charge is that of the start, which a plan keeps.
            at: The flight; its shares are written.
        """
        pack, share, lanes = supply.pack, at.share, at.lanes
        assert pack is not None  # the caller
        columns = [
            column[lanes].tolist() for column in (demand.power, demand.available, demand.duration, at.bus, at.air)
        ]
        rows = list(enumerate(zip(*columns, strict=True), start=lanes.start))
        start = float(demand.charge[lanes.start])
        state, warmths = pack.start(start), started(supply.windings, supply.motors, columns[-1][0])
        for k, (power, available, duration, bus, air) in rows:
            if k in self.charging:
                charge = start if at.planning else state.charge
                wanted = Demand(power, available, charge, duration)
                found = electric_share(self.charging[k], wanted, pack.battery, 0.0)
                share[k] = found if abs(found) > AGREED else 0.0
            given = {
                name: power * share[k] * self.weights[name][k] if k in self.charging else at.powers[name][k]
                for name in supply.motors
            }
            if k in self.charging or supply.windings is not None:
                bus = 0.0
                for name, motor in supply.motors.items():
                    turned, speed = float(given[name]), float(at.speeds[name][k])
                    torque = turned / speed if turned else 0.0
                    warm = warm_motor(supply.windings, motor, warmths.get(name))
                    bus += turned + motor_loss(warm, torque, speed) if turned else 0.0
                    if supply.windings is not None:
                        after = warmed_motor(
                            supply.windings, warm, warmths[name],
                            at=(torque, speed if turned else 0.0), air=air, duration=duration,
                        )  # fmt: skip
                        warmths = {**warmths, name: after}
            try:
                state = pack.drawn(state, float(bus), duration, air)[1]
            except DesignError:  # cells that are too warm: the flight says so
                return


class Charging(NamedTuple):
    """A flight whose battery is followed."""

    lanes: slice
    """Its intervals."""
    bus: Floats
    """Power at the bus, shape (n,) [W]; where shares follow from the battery it is found anew."""
    air: Floats
    """Temperature, shape (n,) [K]."""
    powers: Mapping[str, Floats]
    """Machine -> power, shape (n,) [W]; of motors whose shares follow from the battery found anew."""
    speeds: Mapping[str, Floats]
    """Machine -> speed without sign, shape (n,) [rad/s]."""
    share: Floats
    """Motors' part, shape (n,) [-]."""
    planning: bool
    """Whether only a plan is made, which does not know the charge."""


def strategies_of(supply: Supply, stretches: Sequence[Stretch], counts: Sequence[int]) -> Strategies | None:
    """Return the strategies of all intervals; None where no phase has one.

    Args:
        supply: The machines.
        stretches: The phases of all flights.
        counts: Intervals of each.
    """
    known: list[tuple[StrategyRules, list[int]]] = []
    for k, stretch in enumerate(stretches):
        if stretch.phase.strategy is None:
            continue
        rule = stretch.mission.strategies[stretch.phase.strategy]
        same = next((places for other, places in known if other is rule or other == rule), None)
        if same is None:
            known.append((rule, [k]))
        else:
            same.append(k)
    if not known:
        return None
    whose = np.repeat(np.arange(len(stretches)), counts)
    followed = tuple((rule, np.flatnonzero(np.isin(whose, places))) for rule, places in known)
    weights = [supply.weights(stretch.phase) for stretch in stretches]
    names = (*supply.engines, *supply.motors)
    return Strategies(
        followed,
        np.array([stretch.phase.strategy is not None for stretch in stretches])[whose],
        {name: np.array([of.get(name, 0.0) for of in weights])[whose] for name in names},
        {name: np.array([name not in one.phase.inoperative for one in stretches])[whose] for name in supply.engines},
        {k: rule for rule, rows in followed if rule.rule == _CHARGE for k in rows.tolist()},
        np.zeros(len(whose)),
    )


def strategy_doubts(supply: Supply, stretches: Sequence[Stretch], whose: Ints, share: Floats) -> Iterator[Doubt]:
    """Yield where strategies need machines that there are not, or that are out.

    Args:
        supply: The machines.
        stretches: The phases of all flights.
        whose: Of every interval the number of its phase, shape (n,).
        share: Motors' part as the interval was driven, shape (n,) [-].
    """
    followed = [stretch.phase.strategy is not None for stretch in stretches]
    if not any(followed):
        return
    yield Doubt(np.array(followed)[whose] & (not supply.motors), lambda k: _refuse_motorless(stretches[whose[k]]))
    weights = [supply.weights(stretch.phase) for stretch in stretches]
    driven_by = [
        np.array([any(name in of for name in machines) for of in weights])[whose]
        for machines in (supply.engines, supply.motors)
    ]
    lacking = (~driven_by[0] & (share != 1.0)) | (~driven_by[1] & (share != 0.0))
    yield Doubt(
        np.array(followed)[whose] & lacking,
        lambda k: _asked_of(supply, driven(stretches[whose[k]].phase, float(share[k]))),
    )


def _asked_of(supply: Supply, phase: Phase) -> None:
    supply.parts(phase)


def _refuse_motorless(stretch: Stretch) -> None:
    name = stretch.phase.strategy or ""
    rule = stretch.mission.strategies[name].rule
    if rule != "turbine-alone":
        message = f"{name!r} ({rule}) needs a motor, and the design has none; write turbine-alone"
        raise DesignError([Problem("strategy", message)])


# ----------------------------------------------------------------------------------------------------------------------
# The optimal share: dynamic programming over the state of charge, backwards from the end of a mission.
# ----------------------------------------------------------------------------------------------------------------------


FORBIDDEN = 1e9
"""Fuel of what cannot be flown [kg]."""
SHORT = 1e6
"""Fuel for a state of charge that lacks 1 at the end [kg]: more than any engine saves by it."""


class ShareCost(NamedTuple):
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


def optimal_plan(stages: Sequence[ShareCost], charges: Floats, *, start: float, end: float) -> Plan:
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


def _whole(stage: ShareCost, charges: Floats, later: Floats, at: Floats) -> Floats:
    """Return the fuel of every share from some states of charge to the end, shape (at, shares) [kg]."""
    after = stage.after(at)
    inside = (after >= charges[0] - 1e-12) & (after <= charges[-1] + 1e-12)
    cost = np.interp(np.where(inside, after, charges[0]), charges, later) + stage.fuel
    return np.minimum(np.where(inside, cost, FORBIDDEN), FORBIDDEN)


# ----------------------------------------------------------------------------------------------------------------------
# Shares of optimal strategies: what all intervals need first, then the plan that burns least.
# ----------------------------------------------------------------------------------------------------------------------


MARGIN = 1e-3
"""Part of limits of machines and battery that a plan leaves: it knows demands one round before they are flown."""
USUAL_SHARES, USUAL_CHARGES = 41, 101
PLANS = 2
"""Plans, each with the demands of the last one's shares."""


class Needs(NamedTuple):
    """What the intervals of one flight need of the machines; arrays of shape (n,)."""

    course: Course
    rating: Floats
    """Of the turbines over the usual one [-]."""
    power: Floats
    """Of turbines and motors together [W]."""
    speeds: Mapping[str, Floats]
    """Machine -> speed without sense [rad/s]."""
    weights: Mapping[str, Floats]
    """Machine -> part of what turbines, or motors, give together [-]."""
    share: Floats
    """Motors' part as the interval was driven [-]."""


def has_plan(supply: Supply, mission: Mission) -> bool:
    """Tell whether shares of a mission are planned before it is flown.

    Args:
        supply: The machines.
        mission: As read.
    """
    return bool(_optimal(mission)) and supply.battery is not None and bool(supply.engines)


def _optimal(mission: Mission) -> dict[str, StrategyRules]:
    """Return phase -> its strategy, of those that are optimal."""
    asking = {name: mission.strategies[phase.strategy] for name, phase in mission.phases.items() if phase.strategy}
    return {name: rules for name, rules in asking.items() if rules.rule == "optimal"}


def planned_shares(supply: Supply, mission: Mission, needs: Needs) -> Floats:
    """Return the shares of optimal strategies, 0 elsewhere, shape (n,) [-].

    Args:
        supply: The machines; with a battery, and turbines.
        mission: With rules that are optimal.
        needs: Of its intervals.

    Raises:
        DesignError: No shares can fly them.
    """
    optimal = _optimal(mission)
    rules = next(iter(optimal.values()))
    tried = np.linspace(rules.lowest_share or 0.0, 1.0, rules.shares or USUAL_SHARES)
    tried = np.unique(np.append(tried, 0.0))  # the turbine alone is always one of them
    free = [phase in optimal for phase in needs.course.phase]
    count = 1 + max(k for k, is_free in enumerate(free) if is_free)
    stages = [_stage(supply, needs, k, tried if free[k] else needs.share[k : k + 1]) for k in range(count)]
    found, planned = _best(supply, mission, rules, stages), np.zeros(len(free))
    for k, place in enumerate(found.shares):
        planned[k] = tried[place] if free[k] else 0.0
    return planned


def _best(supply: Supply, mission: Mission, rules: StrategyRules, stages: list[ShareCost]) -> Plan:
    battery, start = supply.battery, mission.battery
    assert battery is not None and start is not None  # there is a plan only with one
    end = max(rules.end_charge if rules.end_charge is not None else battery.minimum, battery.minimum) + MARGIN
    grid = np.unique(np.append(np.linspace(battery.minimum, 1.0, rules.charges or USUAL_CHARGES), min(end, 1.0)))
    plan = optimal_plan(stages, grid, start=start.start_charge, end=end)
    if plan.fuel >= FORBIDDEN:
        message = "no shares of turbines and motors can fly its phases; charge less before, or ask for less power"
        raise DesignError([Problem("strategies", message)])
    return plan


def _stage(supply: Supply, needs: Needs, k: int, shares: Floats) -> ShareCost:
    battery, duration = supply.battery, float(needs.course.duration[k])
    assert battery is not None  # there is a plan only with one
    course, many = needs.course.at(np.full(len(shares), k)), np.ones(len(shares))
    turbines = {name: (1.0 - shares) * needs.weights[name][k] * needs.power[k] for name in supply.engines}
    motors = {name: shares * needs.weights[name][k] * needs.power[k] for name in supply.motors}
    fuel, electric = fuel_along(supply, course, turbines) * duration, np.zeros(len(shares))
    beyond = np.zeros(len(shares), bool)
    for name, power in turbines.items():
        limits = limits_along(supply, name, course, needs.speeds[name][k] * many, needs.rating[k] * many)
        beyond |= ~(power <= np.minimum.reduce(limits) * (1.0 - MARGIN)) | (power < 0.0)
    for name, power in motors.items():
        motor, speed = supply.motors[name], needs.speeds[name][k] * many
        beyond |= np.abs(power) > np.minimum(motor.peak_power, motor.peak_torque * speed) * (1.0 - MARGIN)
        electric += np.where(power == 0.0, 0.0, power + motor_loss(motor, torque_of(power, speed), speed))
    if len(shares) > 1:
        fuel = np.where(beyond, FORBIDDEN, fuel)
    return ShareCost(fuel, lambda charges: _after(battery, charges, electric, duration))


def _after(battery: Battery, charges: Floats, electric: Floats, duration: float) -> Floats:
    """Return states of charge after an interval, shape (charges, shares) [-]; NaN where the battery cannot."""
    current, square = current_of(battery, charges[:, None], electric[None, :], duration)
    final = charges[:, None] - current * duration / battery.charge
    faulty = (square < 0.0) | (np.abs(current) > highest_current(battery) * (1.0 - MARGIN)) | (final > 1.0)
    return np.where(faulty, np.nan, final)
