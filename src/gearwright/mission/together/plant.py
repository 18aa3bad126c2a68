"""Turbines, motors and battery in many intervals at once; charge follows from interval to interval."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from gearwright.air import stagnation_along
from gearwright.air.atmosphere import SEA_LEVEL_TEMPERATURE
from gearwright.arrays import Bools, Floats
from gearwright.errors import DesignError
from gearwright.lanes import rebound
from gearwright.machines import Battery, BatteryStep, Engine, current_of, gas_turbine, highest_current, motor
from gearwright.machines.power import Exhaust, Gas, exhaust, gases
from gearwright.mission.moments import Course
from gearwright.mission.plant import Pack, PackState
from gearwright.mission.supply import Supply

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
    capacity, integral, *_ = gases._coefficients.__wrapped__(gas)
    zero = gases.REFERENCE / 1000.0
    held = _horner(integral, zero) * zero
    temperature, going = gases.REFERENCE + wanted / 1050.0, np.ones(len(wanted), bool)
    for _ in range(_NEWTON):
        part = temperature / 1000.0
        step = (wanted - (_horner(integral, part) * part - held)) / _horner(capacity, part)
        temperature = np.where(going, temperature + step, temperature)
        going = going & (np.abs(step) > gases._TOLERANCE * temperature)
        if not going.any():
            break
    return temperature


_horner: Any = gases._horner
_GASES = rebound(gases, _coefficients=gases._coefficients.__wrapped__, temperature_of=_newton)
_EXHAUST = rebound(exhaust, enthalpy=_GASES.enthalpy, temperature_of=_newton)
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
        air = _EXHAUST.air_flow(supply.breathing[name], *ratios, part)
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
        burning = _EXHAUST._burning(breathing, air[runs], inlet[runs], fuel[runs], power[runs])
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
            joined = _EXHAUST._joined(running) if len(running) > 1 else running[0]
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
        heat[runs] = _EXHAUST._gained(_of(gas, runs), inlet[runs])
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
