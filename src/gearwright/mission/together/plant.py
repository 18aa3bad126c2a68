"""Turbines, motors and battery of many intervals as arrays: power split, charge and propeller maps."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from gearwright.air import SEA_LEVEL_TEMPERATURE, stagnation_along
from gearwright.arrays import Bools, Floats, Ints
from gearwright.catalogue.propeller_maps import ALL_STATES, MAPS, hamilton_standard_charts
from gearwright.errors import DesignError, Problem
from gearwright.lanes import rebound
from gearwright.machines import (
    Battery,
    BatteryStep,
    Blades,
    Charts,
    Engine,
    PropellerMap,
    current_of,
    gas_turbine,
    highest_current,
    motor_loss,
    turboshaft,
)
from gearwright.machines import electric as motor
from gearwright.machines import hamilton_standard as chart_reading
from gearwright.machines.hamilton_standard import STATIC_FADE, Look
from gearwright.machines.propeller_map import SAME_ANGLE
from gearwright.machines.turboshaft import Exhaust, Gas
from gearwright.mission import strategies as rules
from gearwright.mission.plant import Pack, PackState
from gearwright.mission.profile import Course, Stretch
from gearwright.mission.strategies import AGREED, Demand, driven, electric_share
from gearwright.mission.supply import Supply
from gearwright.spec import StrategyRules

# ----------------------------------------------------------------------------------------------------------------------
# Turbines, motors and battery in many intervals at once; charge follows from interval to interval.
# ----------------------------------------------------------------------------------------------------------------------


_SLACK = 1e-9
"""As in `supply` [-]."""
_NEWTON = 60
"""Most rounds for a temperature."""


class Burnt(NamedTuple):
    """What all turbines burn, could give and leave behind; fields of shape (n,)."""

    fuel_flow: Floats
    available: Floats
    power: Floats
    exhaust: Exhaust
    heat: Floats
    """That leaves with the gas [W]."""
    weak: Bools
    """Where one cannot give its power."""


class Discharged(NamedTuple):
    """A battery over all intervals; fields of shape (n,) but the states."""

    charge: Floats
    """At the end of each interval [-]."""
    current: Floats
    open_power: Floats
    loss: Floats
    voltage: Floats
    temperature: Floats | None
    faulty: Bools
    ends: tuple[PackState, ...]
    """Of every flight."""


def _newton(gas: Gas, wanted: Floats) -> Floats:
    """Return the temperatures of gases, as `temperature_of`: each stops where it would stop alone."""
    capacity, integral, *_ = turboshaft._coefficients.__wrapped__(gas)
    zero = turboshaft.REFERENCE / 1000.0
    held = _horner(integral, zero) * zero
    temperature, going = turboshaft.REFERENCE + wanted / 1050.0, np.ones(len(wanted), bool)
    for _ in range(_NEWTON):
        part = temperature / 1000.0
        step = (wanted - (_horner(integral, part) * part - held)) / _horner(capacity, part)
        temperature = np.where(going, temperature + step, temperature)
        going = going & (np.abs(step) > turboshaft._TOLERANCE * temperature)
        if not going.any():
            break
    return temperature


_horner: Any = turboshaft._horner
_GASES = rebound(turboshaft, _coefficients=turboshaft._coefficients.__wrapped__, temperature_of=_newton)
_TURBINE, _MOTOR = rebound(gas_turbine), rebound(motor)


def burnt_along(
    supply: Supply, course: Course, powers: Mapping[str, Floats], speeds: Mapping[str, Floats], rating: Floats
) -> Burnt:
    """Return what all turbines burn in every interval.

    Args:
        supply: The machines.
        course: Where it is flown.
        powers: Machine -> power, shape (n,) [W].
        speeds: Machine -> speed without sign, shape (n,) [rad/s].
        rating: Of the turbines over the usual one, shape (n,) [-].

    Source: `Supply.drive`.
    """
    count = len(course.time)
    ratios = stagnation_along(course.air, course.mach)
    inlet = ratios[0] * SEA_LEVEL_TEMPERATURE
    fuel, available, given, weak = np.zeros(count), np.zeros(count), np.zeros(count), np.zeros(count, bool)
    exhausts = list[Exhaust]()
    for name, usual in supply.engines.items():
        limits = _limits(usual, rating, ratios, speeds[name])
        least, power = np.minimum(np.minimum(*limits[:2]), limits[2]), powers[name]
        available, given = available + least, given + power
        weak |= (power > least * (1.0 + _SLACK)) | (power < -_SLACK * limits[1])
        burnt = _fuel(usual, ratios, power)
        part = np.clip(np.maximum(power, 0.0) / limits[0], 0.0, 1.0)
        air = _GASES.air_flow(supply.breathing[name], *ratios, part)
        exhausts.append(_left(supply.breathing[name], air, inlet, burnt, power))
        fuel = fuel + burnt
    gas = _mixed(exhausts, inlet)
    return Burnt(fuel, available, given, gas, _carried(gas, inlet), weak)


def available_along(
    supply: Supply, course: Course, speeds: Mapping[str, Floats], rating: Floats, working: Mapping[str, Bools]
) -> Floats:
    """Return what all turbines that are not out could give, shape (n,) [W].

    Args:
        supply: The machines.
        course: Where it is flown.
        speeds: Machine -> speed without sign, shape (n,) [rad/s].
        rating: Of the turbines over the usual one, shape (n,) [-].
        working: Turbine -> where it is not out, shape (n,).
    """
    ratios, total = stagnation_along(course.air, course.mach), np.zeros(len(rating))
    for name, usual in supply.engines.items():
        least = np.minimum.reduce(_limits(usual, rating, ratios, speeds[name]))
        total = total + np.where(working[name], least, 0.0)
    return total


def electric_along(
    supply: Supply, powers: Mapping[str, Floats], speeds: Mapping[str, Floats]
) -> tuple[Floats, Floats, Bools]:
    """Return what the bus gives, what motors lose, shape (n,) each [W], and where one cannot.

    Args:
        supply: The machines.
        powers: Machine -> power, shape (n,) [W].
        speeds: Machine -> speed without sign, shape (n,) [rad/s].
    """
    heat, weak = motors_along(supply, powers, speeds)
    return sum((powers[name] for name in supply.motors), np.zeros(len(heat))) + heat, heat, weak


def fuel_along(supply: Supply, ratios: tuple[Floats, Floats], powers: Mapping[str, Floats]) -> Floats:
    """Return the fuel flow of all turbines, shape (n,) [kg/s].

    Args:
        supply: The machines.
        ratios: Stagnation temperatures and pressures over those of the standard sea level, each of shape (n,) [-].
        powers: Machine -> power, shape (n,) [W].

    Source: `Supply.drive`.
    """
    flows = [_fuel(usual, ratios, powers[name]) for name, usual in supply.engines.items()]
    return np.asarray(sum(flows, np.zeros(len(ratios[0]))))


def _fuel(engine: Engine, ratios: tuple[Floats, Floats], power: Floats) -> Floats:
    return np.where(power > 0.0, _TURBINE.fuel_flow(engine, *ratios, power), 0.0)


def _limits(engine: Any, rating: Floats, ratios: tuple[Floats, Floats], speed: Floats) -> tuple[Floats, Floats, Floats]:
    """Return what bounds the power, of engines whose rating changes from interval to interval."""
    usual = _TURBINE.power_limits(engine, *ratios, speed)
    return tuple(rating * bound for bound in usual)


def _left(breathing: Any, air: Floats, inlet: Floats, fuel: Floats, power: Floats) -> Exhaust:
    """Return the exhaust of a turbine, of one that is off the air's temperature."""
    runs = fuel > 0.0
    state = [np.zeros(len(air)), np.zeros(len(air)), inlet.copy(), np.zeros(len(air))]
    if runs.any():
        burning = _GASES._burning(breathing, air[runs], inlet[runs], fuel[runs], power[runs])
        for column, values in zip(state, burning, strict=True):
            column[runs] = values
    return Exhaust(*state)  # type: ignore[arg-type]


def _mixed(exhausts: Sequence[Exhaust], inlet: Floats) -> Exhaust:
    """Return the gas of several turbines mixed, by those that run together."""
    if not exhausts:
        return Exhaust(*(np.zeros(len(inlet)), np.zeros(len(inlet)), inlet, np.zeros(len(inlet))))  # type: ignore[arg-type]
    state = [np.array(column) for column in exhausts[0]]
    runs = np.stack([np.asarray(flow.fuel_flow) > 0.0 for flow in exhausts])
    for pattern in np.unique(runs, axis=1).T if len(exhausts) > 1 else ():
        lanes = (runs == pattern[:, None]).all(axis=0)
        running = [_of(flow, lanes) for flow, on in zip(exhausts, pattern, strict=True) if on]
        if running:
            joined = _GASES._joined(running) if len(running) > 1 else running[0]
            for column, values in zip(state, joined, strict=True):
                column[lanes] = values
    return Exhaust(*state)  # type: ignore[arg-type]


def _of(flow: Exhaust, lanes: Bools) -> Exhaust:
    """Return the gas of some intervals."""
    columns: list[Any] = [np.asarray(column)[lanes] for column in flow]
    return Exhaust(*columns)


def _carried(gas: Exhaust, inlet: Floats) -> Floats:
    runs, heat = np.asarray(gas.fuel_flow) > 0.0, np.zeros(len(inlet))
    if runs.any():
        heat[runs] = _GASES._gained(_of(gas, runs), inlet[runs])
    return heat


def motors_along(supply: Supply, powers: Mapping[str, Floats], speeds: Mapping[str, Floats]) -> tuple[Floats, Bools]:
    """Return what motors that give or take lose, shape (n,) [W], and where one cannot.

    Args:
        supply: The machines.
        powers: Machine -> power, shape (n,) [W].
        speeds: Machine -> speed without sign, shape (n,) [rad/s].
    """
    some = next(iter(powers.values()))
    lost, weak = np.zeros(len(some)), np.zeros(len(some), bool)
    for name, losses in supply.motors.items():
        power, speed = powers[name], speeds[name]
        torque = power / speed
        lost = lost + np.where(power != 0.0, _MOTOR.motor_loss(losses, torque, speed), 0.0)
        weak |= np.abs(torque) > losses.peak_torque * (1.0 + _SLACK)
        weak |= np.abs(power) > losses.peak_power * (1.0 + _SLACK)
    return lost, weak


def dragged_along(supply: Supply, driven: Mapping[str, Bools], speeds: Mapping[str, Floats]) -> Floats:
    """Return what motors without current take from the shafts that drag them, shape (n,) [W].

    Args:
        supply: The machines.
        driven: Motor -> where it has a part of the power, shape (n,).
        speeds: Machine -> speed without sign, shape (n,) [rad/s].
    """
    dragged = [
        np.where(driven[name], 0.0, _MOTOR.motor_loss(losses, 0.0, speeds[name]))
        for name, losses in supply.motors.items()
    ]
    return np.asarray(sum(dragged, np.zeros(len(next(iter(speeds.values()))))))


def discharged(
    pack: Pack | None, starts: Sequence[float], flights: Sequence[slice], *, power: Floats, course: Course
) -> Discharged:
    """Return the batteries of flights over all their intervals.

    Args:
        pack: Of every flight; None: there is none.
        starts: State of charge at the start of every flight [-].
        flights: Which intervals are whose.
        power: At the bus, shape (n,) [W].
        course: With durations and the air.
    """
    none = np.zeros(len(power))
    if pack is None:
        ends = tuple(PackState(0.0) for _ in flights)
        return Discharged(none, none, none, none, none, None, power > 0.0, ends)
    if pack.cells is not None or len(flights) == 1:
        return _one_by_one(pack, starts, flights, power, course)
    return _side_by_side(pack.battery, np.array(starts), flights, (power, course.duration))


def _one_by_one(
    pack: Pack, starts: Sequence[float], flights: Sequence[slice], power: Floats, course: Course
) -> Discharged:
    """March through the intervals of each flight."""
    steps, warm, ends = [], [], []
    for start, lanes in zip(starts, flights, strict=True):
        state = pack.start(start)
        air = np.asarray(course.air.temperature)[lanes].tolist()
        for watts, duration, around in zip(power[lanes].tolist(), course.duration[lanes].tolist(), air, strict=True):
            try:
                step, state = pack.drawn(state, watts, duration, around)
            except DesignError as error:  # one by one it is told where
                step = BatteryStep(state.charge, 0.0, 0.0, 0.0, 0.0, str(error))
            steps.append(step)
            warm.append(state.temperature)
        ends.append(state)
    charge, current, opened, loss, voltage = (np.array(column) for column in list(zip(*steps, strict=True))[:5])
    faulty = np.array([bool(step.fault) for step in steps])
    temperature = None if pack.cells is None else np.array(warm, dtype=float)
    return Discharged(charge, current, opened, loss, voltage, temperature, faulty, tuple(ends))


def _side_by_side(
    battery: Battery, starts: Floats, flights: Sequence[slice], drawn: tuple[Floats, Floats]
) -> Discharged:
    """March through the intervals of all flights together; shorter ones wait at their end."""
    power, duration = drawn
    lengths = np.array([lanes.stop - lanes.start for lanes in flights])
    first = np.array([lanes.start for lanes in flights])
    rise = battery.full_voltage - battery.empty_voltage
    before, final, current, square = (np.zeros(len(power)) for _ in range(4))
    charge = starts.astype(float)
    for k in range(int(lengths.max())):
        lanes = first[lengths > k] + k
        held = charge[lengths > k]
        amperes, root = current_of(battery, held, power[lanes], duration[lanes])
        after = held - amperes * duration[lanes] / battery.charge
        before[lanes], final[lanes], current[lanes], square[lanes] = held, after, amperes, root
        charge[lengths > k] = after
    middle = battery.empty_voltage + rise * 0.5 * (before + final)
    faulty = (square < 0.0) | (np.abs(current) > highest_current(battery) * (1.0 + 1e-9))
    faulty |= (final < battery.minimum) | (final > 1.0 + 1e-12)
    loss = battery.resistance * current * current
    ends = tuple(PackState(float(value)) for value in charge)
    return Discharged(final, current, middle * current, loss, middle - battery.resistance * current, None, faulty, ends)


# ----------------------------------------------------------------------------------------------------------------------
# Strategies in many intervals at once: the share that a rule gives, and what machines then give.
# ----------------------------------------------------------------------------------------------------------------------


_RULES = rebound(rules)
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
                share[rows] = _RULES.electric_share(rule, Demand(*some), None, 0.0)
        return np.where(np.abs(share) <= AGREED, 0.0, share)

    def charged(self, supply: Supply, demand: Demand, state: PackState, at: Charging) -> None:
        """Set the shares of a flight that follow from its battery, interval after interval.

        Args:
            supply: With battery and motors.
            demand: Fields of shape (n,); its charge is not looked at.
            state: Of the battery at the start of the flight.
            at: The flight; its shares are written.
        """
        pack, share = supply.pack, at.share
        assert pack is not None  # the caller
        columns = [np.asarray(column) for column in (demand.power, demand.available, demand.duration, at.bus, at.air)]
        rows = zip(*(column[at.lanes].tolist() for column in columns), strict=True)
        for k, (power, available, duration, bus, air) in enumerate(rows, start=at.lanes.start):
            if k in self.charging:
                wanted = Demand(power, available, state.charge, duration)
                found = electric_share(self.charging[k], wanted, supply.battery, 0.0)
                share[k] = found if abs(found) > AGREED else 0.0
                bus = sum(self._bus(supply, name, k, power * share[k], at.speeds[name][k]) for name in supply.motors)
            try:
                state = pack.drawn(state, float(bus), duration, air)[1]
            except DesignError:  # cells that are too warm: the flight says so
                return

    def _bus(self, supply: Supply, name: str, k: int, power: float, speed: float) -> float:
        given = power * float(self.weights[name][k])
        return given + motor_loss(supply.motors[name], given / speed, speed) if given else 0.0


class Charging(NamedTuple):
    """A flight whose battery is followed."""

    lanes: slice
    """Its intervals."""
    bus: Floats
    """Power at the bus, shape (n,) [W]; where shares follow from the battery it is found anew."""
    air: Floats
    """Temperature, shape (n,) [K]."""
    speeds: Mapping[str, Floats]
    """Machine -> speed without sign, shape (n,) [rad/s]."""
    share: Floats
    """Motors' part, shape (n,) [-]."""


def strategies_of(supply: Supply, stretches: Sequence[Stretch], counts: Sequence[int]) -> Strategies | None:
    """Return the strategies of all intervals; None where no phase has one.

    Args:
        supply: The machines.
        stretches: The phases of all flights.
        counts: Intervals of each.

    Raises:
        DesignError: A rule needs a machine that there is not, or that is out.
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
    weights = [_weights(supply, stretch) for stretch in stretches]
    names = (*supply.engines, *supply.motors)
    return Strategies(
        followed,
        np.array([stretch.phase.strategy is not None for stretch in stretches])[whose],
        {name: np.array([of.get(name, 0.0) for of in weights])[whose] for name in names},
        {name: np.array([name not in one.phase.inoperative for one in stretches])[whose] for name in supply.engines},
        {k: rule for rule, rows in followed if rule.rule == _CHARGE for k in rows.tolist()},
    )


def _weights(supply: Supply, stretch: Stretch) -> dict[str, float]:
    phase = stretch.phase
    if phase.strategy is None:
        return {}
    if not supply.motors and stretch.mission.strategies[phase.strategy].rule != "turbine-alone":
        raise DesignError([Problem("strategy", "needs a motor")])  # one by one it is told in more words
    share = 0.5 if supply.motors else 0.0
    return {name: part / (1.0 - share) for name, part in supply.parts(driven(phase, share)).items()}


# ----------------------------------------------------------------------------------------------------------------------
# Propeller maps over arrays of points: coefficients, blade angles, and the factor of compressibility.
# ----------------------------------------------------------------------------------------------------------------------


_READING = rebound(chart_reading)
_CHART_SLACK = 1e-9
"""A point on the edge of a map, but for rounding, is inside, as in `look_up` [-]."""


class Read(NamedTuple):
    """What is read of a chart at many points."""

    value: Floats
    """Shape (n,)."""
    outside: Bools
    """Where the chart does not reach, shape (n,)."""


class _Cell(NamedTuple):
    """Two rows of a map around points."""

    below: Ints
    """Row at the next smaller advance ratio, shape (n,)."""
    part: Floats
    """How far to the next one [-]."""
    low: Ints
    """First blade angle that both rows give."""
    high: Ints
    """Last one."""
    outside: Bools


def _cell(chart: PropellerMap, ratio: Floats) -> _Cell:
    known = chart.advance_ratio
    below = np.clip(np.searchsorted(known, ratio) - 1, 0, len(known) - 2)
    part = (ratio - known[below]) / (known[below + 1] - known[below])
    low = np.maximum(chart.first[below], chart.first[below + 1])
    high = np.minimum(chart.last[below], chart.last[below + 1])
    return _Cell(below, part, low, high, (ratio < known[0]) | (ratio > known[-1]))


def power_and_thrust(chart: PropellerMap, ratio: Floats, angle: Floats) -> tuple[Floats, Floats, Bools]:
    """Return C_P and C_T at many points of a map, and where it does not reach; each of shape (n,).

    Args:
        chart: The map.
        ratio: Advance ratios J, shape (n,) [-].
        angle: Blade angles β, shape (n,) [rad].

    Source: `look_up`.
    """
    cell, angles = _cell(chart, ratio), chart.blade_angle
    k = np.clip(np.searchsorted(angles, angle) - 1, 0, len(angles) - 2)
    j, i = np.minimum(np.maximum(k, cell.low), cell.high - 1), cell.below
    u, v = cell.part, (angle - angles[j]) / (angles[j + 1] - angles[j])
    outside = ~((u >= -_CHART_SLACK) & (u <= 1.0 + _CHART_SLACK) & (v >= -_CHART_SLACK) & (v <= 1.0 + _CHART_SLACK))
    u, v = np.clip(u, 0.0, 1.0), np.clip(v, 0.0, 1.0)
    weights = ((1.0 - u) * (1.0 - v), (1.0 - u) * v, u * (1.0 - v), u * v)
    corners = ((i, j), (i, j + 1), (i + 1, j), (i + 1, j + 1))
    power, thrust = (
        sum((weight * table[corner] for weight, corner in zip(weights, corners, strict=True)), np.zeros(len(ratio)))
        for table in (chart.power, chart.thrust)
    )
    return power, thrust, outside


def angle_along(chart: PropellerMap, ratio: Floats, wanted: Floats, table: Floats) -> Read:
    """Return the blade angles at which a propeller has a coefficient [rad].

    Args:
        chart: The map.
        ratio: Advance ratios J, shape (n,) [-].
        wanted: Coefficients, shape (n,) [-].
        table: Of the map: `power` or `thrust`.

    Source: `angle_for_power`: the rise of the row at J that spans most, inverted.
    """
    cell, angles = _cell(chart, ratio), chart.blade_angle
    start, end = _rises(chart, table, cell)

    def value(k: Ints) -> Floats:
        return np.asarray((1.0 - cell.part) * table[cell.below, k] + cell.part * table[cell.below + 1, k])

    above, beyond = start, end + 1
    for _ in range(int(table.shape[1]).bit_length()):  # the first angle of the rise at which there is more
        middle = np.minimum((above + beyond) // 2, end)
        less, going = value(middle) <= wanted, above < beyond
        above, beyond = np.where(less & going, middle + 1, above), np.where(less | ~going, beyond, middle)
    k = start + np.clip(above - start - 1, 0, np.maximum(end - start - 1, 0))
    after, low = np.minimum(k + 1, table.shape[1] - 1), value(k)
    with np.errstate(invalid="ignore", divide="ignore"):
        slope = (angles[after] - angles[k]) / (value(after) - low)
    outside = cell.outside | ~((value(start) <= wanted) & (wanted <= value(end))) | (end <= start)
    return Read(np.where(outside, angles[start], slope * (wanted - low) + angles[k]), outside)


def governs_along(chart: PropellerMap, ratio: Floats, angle: Floats) -> Bools:
    """Tell where a coarser pitch takes more power.

    Args:
        chart: The map.
        ratio: Advance ratios J, shape (n,) [-].
        angle: Blade angles, shape (n,) [rad].

    Source: `governs`.
    """
    start, end = _rises(chart, chart.power, _cell(chart, ratio))
    least, most = chart.blade_angle[start], chart.blade_angle[end]
    return np.asarray((least - SAME_ANGLE <= angle) & (angle <= most + SAME_ANGLE))


def _rises(chart: PropellerMap, table: Floats, cell: _Cell) -> tuple[Ints, Ints]:
    """Return first and last angle of the rise that spans most, of the rows at points between two rows of a map.

    Where both rows rise at the same angles and most in the same rise, so do all between them.
    """
    nodes = _cell(chart, chart.advance_ratio[1:])
    ends = [_rise(row, nodes.low, nodes.high) for row in (table[:-1], table[1:])]
    alike = (ends[0][0] == ends[1][0]) & (ends[0][1] == ends[1][1]) & (ends[0][2] == ends[1][2]).all(axis=1)
    start, end = ends[0][0][cell.below], ends[0][1][cell.below]
    others = np.flatnonzero(~alike[cell.below])
    if len(others):
        below, u = cell.below[others], cell.part[others, None]
        row = (1.0 - u) * table[below] + u * table[below + 1]
        start[others], end[others], _ = _rise(row, cell.low[others], cell.high[others])
    return start, end


def _rise(row: Floats, low: Ints, high: Ints) -> tuple[Ints, Ints, Bools]:
    """Return first and last angle of the rise that spans most, and where rises start, of many rows."""
    place = np.arange(row.shape[1])
    given = (place >= low[:, None]) & (place <= high[:, None])
    starts = np.ones_like(given)
    starts[:, 1:] = ~(given[:, 1:] & given[:, :-1] & (row[:, 1:] > row[:, :-1]))
    first = np.maximum.accumulate(np.where(starts, place, 0), axis=1)
    end = np.argmax(np.where(given, row - np.take_along_axis(row, first, axis=1), -1.0), axis=1)
    return first[np.arange(len(row)), end], end, starts


def squeezed_along(name: str, ratio: Floats, thrust: Floats, *, mach: Floats, tip_mach: Floats) -> Read:
    """Return the factors of compressibility on the thrust of a map [-].

    Args:
        name: Of the map.
        ratio: Advance ratios J, shape (n,) [-].
        thrust: C_T without compressibility, shape (n,) [-].
        mach: Of the flight, shape (n,) [-].
        tip_mach: Of the tips' rotation, shape (n,) [-].

    Source: `compressed`.
    """
    blades, charts = MAPS.get(ALL_STATES.get(name, name)), hamilton_standard_charts()
    factor, outside = np.ones(len(ratio)), np.zeros(len(ratio), bool)
    if blades is None:
        return Read(factor, outside)
    look = Look(charts, blades)
    reach = (ratio >= 0.0) & (ratio <= charts.advance_ratio[-1])
    held = np.clip(ratio, 0.0, charts.advance_ratio[-1])
    machs = [_excess(charts, row, held, (mach, tip_mach)) for row in look._lift_rows()]
    counts = (thrust > 0.0) & (np.max([over.value for over in machs], axis=0) > 0.0)
    outside |= (thrust > 0.0) & (~reach | np.any([over.outside for over in machs], axis=0))
    if counts.any():
        over = [excess.value[counts] for excess in machs]
        found = _factor(charts, blades, held[counts], (thrust[counts], over))
        factor[counts], outside[counts] = found.value, outside[counts] | found.outside
    return Read(factor, outside)


def _excess(charts: Charts, row: int, ratio: Floats, machs: tuple[Floats, Floats]) -> Read:
    known, flight, static = charts.critical_mach
    moving, (mach, tip) = _at(ratio, known, flight[row]), machs
    fade = np.maximum(1.0 - ratio / STATIC_FADE, 0.0)
    over = np.maximum(np.where(ratio > 0.0, mach - moving.value, 0.0), fade * (tip - static[row]))
    return Read(over, moving.outside)


def _factor(charts: Charts, blades: Blades, ratio: Floats, squeezed: tuple[Floats, list[Floats]]) -> Read:
    """Return the factors where there is an excess of Mach number."""
    look, (thrust, excess) = Look(charts, blades), squeezed
    ends = [look.at(blades.activity_factor, (charts.activity_factor, row), "") for row in charts.activity_thrust]
    activity = ends[0] + (ends[1] - ends[0]) * np.minimum(ratio / 0.5, 1.0)
    scale = _at(ratio, charts.advance_ratio, charts.lift_scale[1])
    outside, factors = scale.outside, []
    machs, thrusts, table = charts.compressibility
    for count in look.counts:
        number = _at(thrust * activity, charts.number_thrust[0], charts.number_thrust[1][count])
        effective, by_lift = thrust * activity * number.value, []
        outside = outside | number.outside
        for row, over in zip(look._lift_rows(), excess, strict=True):
            lift = _at(effective * scale.value, charts.lift_thrust[0][row], charts.lift_thrust[1][row])
            lifted = effective * lift.value
            lines = [_at(lifted, thrusts, line) for line in table]
            large = lifted >= thrusts[0]
            left = np.any([line.outside for line in lines], axis=0)
            found = _at(over, machs, np.stack([line.value for line in lines], axis=1))
            outside = outside | lift.outside | (large & left) | ((over > 0.0) & found.outside)
            by_lift.append(np.where(over > 0.0, found.value, 1.0))
        factors.append(_over(charts.lift, blades.design_lift, by_lift, look._lift_rows()))
    return Read(np.minimum(_over(charts.blade_counts, blades.number, factors, look.counts), 1.0), outside)


def _over(nodes: Floats, x: float, values: list[Floats], around: range) -> Floats:
    """Return values between those at the nodes around a point."""
    if len(values) == 1:
        return values[0]
    return _at(np.full(len(values[0]), x), nodes[around.start : around.stop], np.stack(values, axis=1)).value


def _at(x: Floats, xs: Floats, ys: Floats) -> Read:
    """Return y(x) as `Look.at` does; ys has shape (m,), or (n, m) where it differs from point to point."""
    table = np.broadcast_to(ys, (len(x), len(xs)))
    inside = np.clip(x, xs[0], xs[-1])
    flat = np.where(x < xs[0], table[:, 0] == table[:, 1], table[:, -1] == table[:, -2])
    k = np.clip(np.searchsorted(xs, inside, side="right") - 1, 0, len(xs) - 2)
    edge = (k == 0) | (k == len(xs) - 2)
    first = np.where(k == 0, 0, np.where(edge, len(xs) - 3, k - 1))
    weight = np.where(edge, 0.0, (inside - xs[k]) / (xs[k + 1] - xs[k]))
    left, right = (_through(inside, xs, table, start) for start in (first, np.where(edge, first, k)))
    return Read((1.0 - weight) * left + weight * right, (inside != x) & ~flat)


def _through(x: Floats, xs: Floats, table: Floats, first: Ints) -> Floats:
    lanes = np.arange(len(x))
    nodes = [xs[first + place] for place in range(3)]
    values = [table[lanes, first + place] for place in range(3)]
    return np.asarray(_READING._parabola(x, nodes, values))
