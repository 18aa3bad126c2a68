"""Turbines, motors and battery in flight: power split, ratings, fuel and charge, and limits of duration."""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from gearwright.air import SEA_LEVEL_TEMPERATURE, air_at, stagnation_ratios
from gearwright.base import KWH, Bools, DesignError, Floats, Problem, apart, near, refuse
from gearwright.machines import (
    Battery,
    BatteryStep,
    Breathing,
    Day,
    Engine,
    EngineDeck,
    Exhaust,
    MotorLosses,
    PowerLimits,
    air_flow,
    current_of,
    deck_fuel,
    deck_limit,
    exhaust_heat,
    exhaust_of,
    fuel_flow,
    highest_current,
    mixed,
    motor_loss,
    power_limits,
    rated_losses,
    shared_losses,
)
from gearwright.mission.gearbox import torque_of
from gearwright.mission.plant import (
    Pack,
    PackState,
    Warmth,
    faulty,
    less,
    pack_of,
    refuse_hot,
    started,
    warm_motor,
    warmed_motor,
)
from gearwright.mission.profile import Course, Doubt, Moment
from gearwright.sizing import Sizing
from gearwright.spec import EngineRules, Machine, Mission, Motor, MotorRules, Phase, WindingRules
from gearwright.spec.design import allowed_for

# ----------------------------------------------------------------------------------------------------------------------
# What drives the gearbox in flight: turbines with their fuel, motors with their battery, and the limits of all.
# ----------------------------------------------------------------------------------------------------------------------


_SLACK = 1e-9
"""Part by which a limit may be passed: rounding."""


@dataclass(frozen=True)
class Supply:
    """The machines of one gearbox and their battery."""

    engines: Mapping[str, Engine]
    motors: Mapping[str, MotorLosses]
    pack: Pack | None
    ratings: Mapping[str, float]
    """Machine -> rated power [W]."""
    breathing: Mapping[str, Breathing]
    """Turbine -> the air it breathes."""
    windings: WindingRules | None
    """How motors warm up; None: whatever their temperature."""
    deck: EngineDeck | None = None
    """Of each turbine; None: a Willans line and a law of what air leaves of its power."""

    @property
    def battery(self) -> Battery | None:
        """The pack's battery, if there is one."""
        return self.pack.battery if self.pack else None

    def parts(self, phase: Phase) -> dict[str, float]:
        """Return machine -> part of the power of all machines in a phase [-].

        Args:
            phase: With mode and electric share.

        Raises:
            DesignError: The mode needs a machine that the design lacks, or that is out.
        """
        machines = {**self.engines, **self.motors}
        unknown = [name for name in phase.inoperative if name not in machines]
        if unknown:
            raise DesignError(
                [Problem("inoperative", f"there is no machine {unknown[0]!r}; {near(unknown[0], machines)}")]
            )
        if phase.mode == "rated":
            working = {name: rating for name, rating in self.ratings.items() if name not in phase.inoperative}
            if not working:
                raise DesignError([Problem("inoperative", "every machine is out; name fewer")])
            return _divided(1.0, working)
        share = {"conventional": 0.0, "electric": 1.0, "hybrid": phase.electric_share or 0.0}[phase.mode]
        if share != 0.0 and not self.motors:
            raise DesignError([Problem("mode", f"{phase.mode}, but the design has no motor; write conventional")])
        if share != 1.0 and not self.engines:
            raise DesignError([Problem("mode", f"{phase.mode}, but the design has no turbine; write electric")])
        turbines, motors = self._working(phase)
        if (share != 1.0 and not turbines) or (share != 0.0 and not motors):
            message = (
                f"{', '.join(phase.inoperative)} out, and {phase.mode} mode needs one; name fewer, or change the mode"
            )
            raise DesignError([Problem("inoperative", message)])
        return {**_divided(1.0 - share, turbines), **_divided(share, motors)}

    def weights(self, phase: Phase) -> dict[str, float]:
        """Return machine -> part of what all turbines, or all motors, give together [-]; none of what is out.

        Args:
            phase: With what is out.
        """
        turbines, motors = self._working(phase)
        return {**_divided(1.0, turbines), **_divided(1.0, motors)}

    def _working(self, phase: Phase) -> tuple[dict[str, float], dict[str, float]]:
        """Return turbines and motors that are not out -> by what they divide a power [W]."""
        turbines = {name: engine.rated_power for name, engine in self.engines.items() if name not in phase.inoperative}
        motors = {name: motor.peak_power for name, motor in self.motors.items() if name not in phase.inoperative}
        return turbines, motors

    def limits(self, name: str, moment: Moment, speed: float, rating: float) -> PowerLimits:
        """Return what bounds the power of a turbine in an interval [W].

        Args:
            name: Of the turbine.
            moment: Where it is flown.
            speed: Of its shaft [rad/s].
            rating: Over the usual one [-].
        """
        engine, ratios = self.engines[name].rated(rating), stagnation_ratios(moment.air, moment.mach)
        found = power_limits(engine, *ratios, speed)
        if self.deck is None:
            return found
        day = _day(moment)
        standard = power_limits(engine, day.theta / day.warmer, day.delta, speed)
        with _decked():
            core = deck_limit(self.deck, day, found.core / standard.core)
        return found._replace(core=rating * core)

    def limited(self, name: str, moment: Moment, *, power: float, speed: float, rating: float) -> PowerLimits:
        """Return what bounds the power of a turbine that gives some in an interval [W].

        Args:
            name: Of the turbine.
            moment: Where it is flown.
            power: At its shaft [W].
            speed: Of its shaft [rad/s].
            rating: Over the usual one [-].

        Raises:
            DesignError: It cannot give that power.
        """
        limits = self.limits(name, moment, speed, rating)
        if power > min(limits) * (1.0 + _SLACK):
            raise DesignError([Problem(name, self._too_weak(moment, power, limits))])
        return limits

    def fuel(self, name: str, moment: Moment, power: float) -> float:
        """Return what a turbine that runs burns at a power, at any rating [kg/s].

        Args:
            name: Of the turbine.
            moment: Where it is flown.
            power: At its shaft [W].
        """
        if self.deck is None:
            return float(fuel_flow(self.engines[name], *stagnation_ratios(moment.air, moment.mach), power))
        with _decked():
            return deck_fuel(self.deck, _day(moment), power)

    def _too_weak(self, moment: Moment, power: float, limits: PowerLimits) -> str:
        """Return what is wrong with a power that a turbine cannot give, and what helps."""
        bound, available = limits._fields[limits.index(min(limits))], min(limits)
        fix = "climb slower, fly slower" if moment.power is None else "ask for less power"
        if self.motors:
            fix += ", or give the motors a larger electric_share"
        asked, given = apart(power, available, "power")
        return f"needs {asked} at {moment.altitude:.0f} m, and gives {given} (by its {bound}); {fix}"

    def refuse_motor(self, name: str, motor: MotorLosses, *, power: float, speed: float, mode: str) -> None:
        """Refuse what a motor cannot give.

        Args:
            name: Of the motor.
            motor: As warm as it is.
            power: At its shaft [W].
            speed: Of its shaft [rad/s].
            mode: Of the phase.

        Raises:
            DesignError: Torque or power are above its limits.
        """
        torque = power / speed if speed else 0.0
        if abs(torque) > motor.peak_torque * (1.0 + _SLACK) or abs(power) > motor.peak_power * (1.0 + _SLACK):
            asked, limits = zip(
                apart(power, motor.peak_power, "power"), apart(torque, motor.peak_torque, "torque"), strict=True
            )
            message = (
                f"needs {' and '.join(asked)}; its limits are {' and '.join(limits)};"
                f" {less(mode)}, {self._more(name, motor)}"
            )
            raise DesignError([Problem(name, message)])

    def _more(self, name: str, motor: MotorLosses) -> str:
        """Return what raises a motor's limits."""
        derated = motor.peak_power < self.motors[name].peak_power
        return (
            "or cool it more: its winding is derated from motor.heat.derate_from_k"
            if derated
            else "or raise motor.overload"
        )

    def refuse_battery(self, state: PackState, power: float, moment: Moment, mode: str) -> None:
        """Refuse what the battery cannot give or take in an interval.

        Args:
            state: At its start.
            power: At the bus [W].
            moment: Where it is flown.
            mode: Of the phase.

        Raises:
            DesignError: Current, charge or temperature leave their limits, or there is no battery.
        """
        if self.pack is None:
            if power > 0.0:
                message = (
                    f"the motors turn with {power / 1e3:.3g} kW of losses and there is no battery; give a [battery]"
                )
                raise DesignError([Problem("battery", message)])
            return
        step, _ = self.pack.drawn(state, power, moment.duration, moment.air.temperature)
        if step.fault:
            message = faulty(self.pack.battery, state.charge, power, step=step, mode=mode)
            raise DesignError([Problem("battery", message)])


@contextmanager
def _decked() -> Iterator[None]:
    """Say what is outside an engine's deck as a fault of the mission."""
    try:
        yield
    except ValueError as error:
        raise DesignError([Problem("engine.deck", f"{error}; give a deck that goes there, or fly elsewhere")]) from None


def _day(moment: Moment) -> Day:
    """Return where a deck is read."""
    theta, delta = stagnation_ratios(moment.air, moment.mach)
    standard, _ = stagnation_ratios(air_at(moment.altitude), moment.mach)
    return Day(moment.altitude, moment.mach, theta, delta, theta / standard)


def refuse_braked(name: str, power: float) -> None:
    """Refuse a turbine that would take power.

    Args:
        name: Of the turbine.
        power: At its shaft [W].

    Raises:
        DesignError: Always; the caller has seen that it would.
    """
    message = (
        f"would take {-power / 1e3:.3g} kW from the gearbox, and a turbine only gives; raise pitch or power, fly"
        " electric so that the motors take it, or slow the propeller down within a longer ramp_s"
    )
    raise DesignError([Problem(name, message)])


def _divided(share: float, weights: Mapping[str, float]) -> dict[str, float]:
    """Divide a share in proportion to weights; without a share nothing is in it."""
    total = sum(weights.values())
    return {name: share * weight / total for name, weight in weights.items()} if share else {}


# ----------------------------------------------------------------------------------------------------------------------
# Turbines in many intervals at once: limits, fuel, exhaust.
# ----------------------------------------------------------------------------------------------------------------------


class Burnt(NamedTuple):
    """What all turbines burn, could give and leave behind; fields of shape (n,)."""

    fuel_flow: Floats
    """[kg/s]"""
    available: Floats
    """[W]"""
    power: Floats
    """[W]"""
    exhaust: Exhaust
    """Mixed."""
    heat: Floats
    """That leaves with the gas [W]."""


def burnt_along(
    supply: Supply, course: Course, powers: Mapping[str, Floats], speeds: Mapping[str, Floats], rating: Floats
) -> tuple[Burnt, list[Doubt]]:
    """Return what all turbines burn in every interval, and where one cannot give its power.

    Args:
        supply: The machines.
        course: Where it is flown.
        powers: Machine -> power, shape (n,) [W].
        speeds: Machine -> speed without sign, shape (n,) [rad/s].
        rating: Of the turbines over the usual one, shape (n,) [-].
    """
    count, ratios = len(course.time), stagnation_ratios(course.air, course.mach)
    inlet = ratios[0] * SEA_LEVEL_TEMPERATURE
    fuel, available, given = np.zeros(count), np.zeros(count), np.zeros(count)
    exhausts, doubts = list[Exhaust](), list[Doubt]()
    for name in supply.engines:
        limits, power = limits_along(supply, name, course, speeds[name], rating), powers[name]
        least = np.minimum(np.minimum(*limits[:2]), limits[2])
        available, given = available + least, given + power
        burnt = _fuel(supply, name, course, power)
        doubts += _turbine_doubts(supply, name, course, (power, speeds[name], rating), limits, burnt)
        part = np.clip(np.maximum(power, 0.0) / limits[0], 0.0, 1.0)
        air = air_flow(supply.breathing[name], *ratios, part)
        exhausts.append(exhaust_of(supply.breathing[name], air, inlet, fuel=burnt, power=power))
        fuel = fuel + burnt
    off = Exhaust(np.zeros(count), np.zeros(count), inlet, np.zeros(count))
    gas = mixed(exhausts) if exhausts else off
    return Burnt(fuel, available, given, gas, exhaust_heat(gas, inlet)), doubts


def _turbine_doubts(
    supply: Supply, name: str, course: Course, at: tuple[Floats, Floats, Floats], limits: PowerLimits, burnt: Floats
) -> Iterator[Doubt]:
    """Yield where a turbine cannot give its power; `at` is power, speed and rating."""
    power, speed, rating = at

    def limited(k: int) -> None:
        given = {"power": float(power[k]), "speed": float(speed[k]), "rating": float(rating[k])}
        supply.limited(name, course.moment(k), **given)

    least = np.minimum(np.minimum(*limits[:2]), limits[2])
    yield Doubt(~(power <= least * (1.0 + _SLACK)), limited)
    yield Doubt(power < -_SLACK * limits.rating, lambda k: refuse_braked(name, float(power[k])))
    yield Doubt(np.isnan(burnt), lambda k: _told(supply.fuel(name, course.moment(k), float(power[k]))))


def _told(_: float) -> None:
    """Do nothing with a value that was found only for what it refuses."""


def limits_along(supply: Supply, name: str, course: Course, speed: Floats, rating: Floats) -> PowerLimits:
    """Return what bounds the power of a turbine in every interval; NaN beyond its deck.

    Args:
        supply: The machines.
        name: Of the turbine.
        course: Where it is flown.
        speed: Of its shaft, shape (n,) [rad/s].
        rating: Over the usual one, shape (n,) [-].
    """
    ratios = stagnation_ratios(course.air, course.mach)
    usual = PowerLimits(*(rating * bound for bound in power_limits(supply.engines[name], *ratios, speed)))
    if supply.deck is None:
        return usual
    core = np.full(len(speed), math.nan)
    for k, day in enumerate(_days(course)):
        standard = power_limits(supply.engines[name], day.theta / day.warmer, day.delta, float(speed[k])).core
        with suppress(ValueError):
            lapse = float(usual.core[k]) / (float(rating[k]) * standard)
            core[k] = rating[k] * deck_limit(supply.deck, day, lapse)
    return usual._replace(core=core)


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
    total = np.zeros(len(rating))
    for name in supply.engines:
        least = np.minimum.reduce(limits_along(supply, name, course, speeds[name], rating))
        total = total + np.where(working[name], least, 0.0)
    return total


def fuel_along(supply: Supply, course: Course, powers: Mapping[str, Floats]) -> Floats:
    """Return the fuel flow of all turbines, shape (n,) [kg/s].

    Args:
        supply: The machines.
        course: Where it is flown.
        powers: Machine -> power, shape (n,) [W].
    """
    flows = [np.nan_to_num(_fuel(supply, name, course, powers[name])) for name in supply.engines]
    return np.asarray(sum(flows, np.zeros(len(course.time))))


def _fuel(supply: Supply, name: str, course: Course, power: Floats) -> Floats:
    """Return what a turbine burns [kg/s], shape (n,); one that idles in electric mode is off; NaN beyond its deck."""
    if supply.deck is None:
        ratios = stagnation_ratios(course.air, course.mach)
        return np.where(power > 0.0, fuel_flow(supply.engines[name], *ratios, power), 0.0)
    flow = np.where(power > 0.0, math.nan, 0.0)
    for k, day in enumerate(_days(course)):
        if power[k] > 0.0:
            with suppress(ValueError):
                flow[k] = deck_fuel(supply.deck, day, float(power[k]))
    return flow


def _days(course: Course) -> Iterator[Day]:
    """Yield where a deck is read in every interval."""
    theta, delta = stagnation_ratios(course.air, course.mach)
    standard, _ = stagnation_ratios(air_at(course.altitude), course.mach)
    columns = (course.altitude, course.mach, theta, delta, theta / standard)
    yield from map(Day, *(column.tolist() for column in columns))


# ----------------------------------------------------------------------------------------------------------------------
# Motors and battery in many intervals at once; charge and warmth follow from interval to interval.
# ----------------------------------------------------------------------------------------------------------------------


class Electric(NamedTuple):
    """What motors turn into heat; fields of shape (n,)."""

    bus: Floats
    """Power that the battery gives [W]."""
    heat: Floats
    """[W]"""
    winding: Floats | None
    """Of the hottest motor at the end [K]; None where a mission does not follow it."""
    doubts: tuple[Doubt, ...]
    """Where a motor cannot give its power."""
    hot: tuple[Doubt, ...]
    """Where a winding is too warm."""


def electric_along(
    supply: Supply,
    course: Course,
    flights: Sequence[slice],
    powers: Mapping[str, Floats],
    speeds: Mapping[str, Floats],
    modes: Callable[[int], str] = str,
) -> Electric:
    """Return what the bus gives and what motors that give or take lose.

    Args:
        supply: The machines.
        course: Where it is flown.
        flights: Which intervals are whose.
        powers: Machine -> power, shape (n,) [W].
        speeds: Machine -> speed without sign, shape (n,) [rad/s].
        modes: Interval -> mode of its phase as it is driven, for words.
    """
    count, warm, hot = len(course.time), None, list[Doubt]()
    motors: Mapping[str, Sequence[MotorLosses]] = {}
    if supply.windings is not None and supply.motors:
        warm, motors, hot = _wound(supply, course, flights, powers, speeds)
    heat, doubts = np.zeros(count), list[Doubt]()
    for name, usual in supply.motors.items():
        power, speed = powers[name], speeds[name]
        torque = torque_of(power, speed)
        losses = _stacked(motors[name]) if name in motors else usual
        heat = heat + np.where(power != 0.0, motor_loss(losses, torque, speed), 0.0)
        weak = np.abs(torque) > losses.peak_torque * (1.0 + _SLACK)
        weak |= np.abs(power) > losses.peak_power * (1.0 + _SLACK)

        def words(k: int, name: str = name, usual: MotorLosses = usual) -> None:
            motor, (power, speed) = motors[name][k] if name in motors else usual, (powers[name][k], speeds[name][k])
            supply.refuse_motor(name, motor, power=float(power), speed=float(speed), mode=modes(k))

        doubts.append(Doubt(weak & (power != 0.0), words))
    bus = sum((powers[name] for name in supply.motors), np.zeros(count)) + heat
    return Electric(bus, heat, warm, tuple(doubts), tuple(hot))


def _stacked(motors: Sequence[MotorLosses]) -> Any:
    """Return the losses of a motor in many intervals as arrays."""
    return MotorLosses(*np.array(motors).T)


def _wound(
    supply: Supply,
    course: Course,
    flights: Sequence[slice],
    powers: Mapping[str, Floats],
    speeds: Mapping[str, Floats],
) -> tuple[Floats, dict[str, list[MotorLosses]], list[Doubt]]:
    """Return windings' temperatures [K], motors as warm as they are, and where a winding is too warm."""
    rules, motors = supply.windings, dict[str, list[MotorLosses]]()
    assert rules is not None  # the caller
    air, durations, ends = course.air.temperature.tolist(), course.duration.tolist(), dict[str, list[Warmth]]()
    for name, motor in supply.motors.items():
        motors[name], ends[name] = [], []
        torques = torque_of(powers[name], speeds[name]).tolist()
        turning = np.where(powers[name] == 0.0, 0.0, speeds[name]).tolist()
        for lanes in flights:
            warmth = started(rules, supply.motors, air[lanes.start])[name]
            for k in range(lanes.start, lanes.stop):
                now = warm_motor(rules, motor, warmth)
                at = (torques[k], turning[k])
                warmth = warmed_motor(rules, now, warmth, at=at, air=air[k], duration=durations[k])
                motors[name].append(now)
                ends[name].append(warmth)
    winding = np.array([[warmth.winding for warmth in column] for column in ends.values()])
    hottest = rules.highest_winding_k * (1.0 + 1e-12)
    hot = [Doubt(winding[k] > hottest, _too_hot(rules, name, ends[name])) for k, name in enumerate(ends)]
    return winding.max(axis=0), motors, hot


def _too_hot(rules: WindingRules, name: str, warmths: Sequence[Warmth]) -> Callable[[int], None]:
    """Return the words of a winding that is too warm."""
    return lambda k: refuse_hot(rules, name, warmths[k])


def dragged_along(supply: Supply, driven: Mapping[str, Bools], speeds: Mapping[str, Floats]) -> Floats:
    """Return what motors without current take from the shafts that drag them, shape (n,) [W].

    Args:
        supply: The machines.
        driven: Motor -> where it has a part of the power, shape (n,).
        speeds: Machine -> speed without sign, shape (n,) [rad/s].
    """
    dragged = [
        np.where(driven[name], 0.0, motor_loss(losses, 0.0, speeds[name])) for name, losses in supply.motors.items()
    ]
    return np.asarray(sum(dragged, np.zeros(len(next(iter(speeds.values()))))))


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
    starts: Callable[[int], PackState]
    """Interval -> state at its start."""
    ends: tuple[PackState, ...]
    """Of every flight."""


def discharged(
    supply: Supply, starts: Sequence[float], flights: Sequence[slice], *, power: Floats, course: Course
) -> Discharged:
    """Return the batteries of flights over all their intervals.

    Args:
        supply: With the battery of every flight, if there is one.
        starts: State of charge at the start of every flight [-].
        flights: Which intervals are whose.
        power: At the bus, shape (n,) [W].
        course: With durations and the air.
    """
    none, pack = np.zeros(len(power)), supply.pack
    if pack is None:
        ends = tuple(PackState(0.0) for _ in flights)
        return Discharged(none, none, none, none, none, None, power > 0.0, lambda k: PackState(0.0), ends)
    if pack.cells is not None or len(flights) == 1:
        return _marched(pack, starts, flights, power, course)
    return _side_by_side(pack.battery, np.array(starts), flights, (power, course.duration))


def _marched(
    pack: Pack, starts: Sequence[float], flights: Sequence[slice], power: Floats, course: Course
) -> Discharged:
    """March through the intervals of each flight."""
    steps, before, warm, ends = list[BatteryStep](), list[PackState](), list[float | None](), list[PackState]()
    air = course.air.temperature
    for start, lanes in zip(starts, flights, strict=True):
        state, rows = pack.start(start), (power[lanes], course.duration[lanes], air[lanes])
        for watts, duration, around in zip(*(column.tolist() for column in rows), strict=True):
            before.append(state)
            try:
                step, state = pack.drawn(state, watts, duration, around)
            except DesignError as error:  # cells that are too warm or too cold
                step = BatteryStep(state.charge, 0.0, 0.0, 0.0, 0.0, str(error))
            steps.append(step)
            warm.append(state.temperature)
        ends.append(state)
    charge, current, opened, loss, voltage = (np.array(column) for column in list(zip(*steps, strict=True))[:5])
    faulty = np.array([bool(step.fault) for step in steps])
    temperature = None if pack.cells is None else np.array(warm, dtype=float)
    return Discharged(charge, current, opened, loss, voltage, temperature, faulty, before.__getitem__, tuple(ends))


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
    voltage = middle - battery.resistance * current
    states = lambda k: PackState(float(before[k]))  # noqa: E731
    return Discharged(final, current, middle * current, loss, voltage, None, faulty, states, ends)


# ----------------------------------------------------------------------------------------------------------------------
# The machines of a design as the rules of a mission make them fly.
# ----------------------------------------------------------------------------------------------------------------------


SPECIFIC_POWER = 250e3
"""Power over air flow where a mission does not say it [J/kg]; an assumption."""


def supply_of(sizing: Sizing, mission: Mission, deck: EngineDeck | None) -> Supply:
    """Return the machines of a design as the mission's rules make them fly.

    Args:
        sizing: With its design.
        mission: With the rules of engine, motor and battery.
        deck: Of the turbines, as its file has it; None: a Willans line.
    """
    rules, motor, deck = mission.engine, mission.motor, _scaled(deck, mission.engine)
    core, burnt = (None, rules.fuel_kg_kwh / KWH) if deck is None else _of_deck(deck)
    engines = {
        name: Engine(
            (most := allowed_for(turbine, None)).power or turbine.power,
            core or rules.thermal_power or most.power or turbine.power,
            max(most.torque or 0.0, (most.power or turbine.power) / turbine.speed * (1.0 + _TOLERANCE)),
            burnt,
            rules.idle_fuel,
            rules.temperature_exponent,
            rules.hot_exponent,
        )
        for name, turbine in sizing.design.turbines.items()
    }
    motors = {name: _losses(machine, motor) for name, machine in sizing.design.motors.items()}
    ratings = {name: turbine.power for name, turbine in sizing.design.turbines.items()}
    ratings |= {name: machine.power for name, machine in sizing.design.motors.items()}
    breathing = {
        name: Breathing(rules.air_flow_kg_s or engine.thermal_power / SPECIFIC_POWER, rules.idle_air, rules.casing_loss)
        for name, engine in engines.items()
    }
    pack = pack_of(mission.battery) if mission.battery and motors else None
    return Supply(engines, motors, pack, ratings, breathing, mission.motor.heat, deck)


def _scaled(deck: EngineDeck | None, rules: EngineRules) -> EngineDeck | None:
    """Return a deck of the thermal power that a mission asks for."""
    if deck is None or rules.thermal_power is None:
        return deck
    return deck.scaled(rules.thermal_power / deck.reference[0])


def _of_deck(deck: EngineDeck) -> tuple[float, float]:
    """Return the thermal power of a deck [W], and the specific fuel consumption there [kg/J]."""
    power, fuel = deck.reference
    return power, fuel / power


def _losses(machine: Motor, rules: MotorRules) -> MotorLosses:
    overload = _overload(machine, rules.overload)
    if rules.loss_shares is None:
        return rated_losses(machine.power, machine.speed, efficiency=rules.efficiency, overload=overload)
    lost = machine.power * (1.0 / rules.efficiency - 1.0)
    return shared_losses(machine.power, machine.speed, lost=lost, shares=rules.loss_shares, overload=overload)


def _overload(machine: Machine, said: float) -> float:
    """Return the largest power or torque of a motor over the rated one, by the mission or for a time by its limits."""
    most, rated = allowed_for(machine, None), machine.rating or 1.0
    torque = (most.torque or 0.0) * (machine.asked_speed or 0.0)
    return max(said, (most.power or 0.0) / rated, torque / rated)


_TOLERANCE = 0.05
"""Part by which a torque may exceed power over rated speed, as teeth let a speed yield by so much [-]."""


# ----------------------------------------------------------------------------------------------------------------------
# How long machines may give more than their ratings: limits for a time, held against flights without a break.
# ----------------------------------------------------------------------------------------------------------------------


_BOUND_SLACK = 1e-6
"""Part by which a bound may be passed: drag is that of the loads one round before."""


class Bound(NamedTuple):
    """A power or torque of a machine, and for how long without a break it may be reached."""

    machine: str
    name: str
    """``power`` or ``torque``."""
    value: float
    """[W] or [N m]"""
    duration: float
    """[s]; infinite for any time."""


def bounds_of(machines: Mapping[str, Machine], ratings: Mapping[str, float]) -> tuple[Bound, ...]:
    """Return the bounds of machines that have limits; the others' are their ratings, which hold for any time.

    Args:
        machines: By name.
        ratings: Machine -> power that the mission lets it give for any time [W].
    """
    bounds = list[Bound]()
    for name, machine in machines.items():
        if machine.limits and name in ratings:
            bounds.append(Bound(name, "power", ratings[name], math.inf))
        for limit in machine.limits.values():
            for what, value in (("power", limit.power), ("torque", limit.torque)):
                if value is not None:
                    bounds.append(Bound(name, what, value, limit.duration or math.inf))
    return tuple(bounds)


def outlasted(
    sets: Sequence[tuple[tuple[Bound, ...], Bools]],
    duration: Floats,
    powers: Mapping[str, Floats],
    speeds: Mapping[str, Floats],
) -> Doubt:
    """Return where a bound is passed for longer than a higher one allows in a flight.

    Args:
        sets: Bounds, and the intervals in which they hold, shape (n,).
        duration: Of each interval, shape (n,) [s].
        powers: Machine -> power, shape (n,) [W].
        speeds: Machine -> speed without sign, shape (n,) [rad/s].
    """
    late, told = dict[Bound, Bools](), dict[Bound, tuple[Floats, Floats, Floats]]()
    for bound in dict.fromkeys(bound for bounds, _ in sets for bound in bounds):
        power = np.abs(powers[bound.machine])
        value = power if bound.name == "power" else torque_of(power, speeds[bound.machine])
        applies, allowed = np.zeros(len(duration), bool), np.zeros(len(duration))
        for bounds, where in sets:
            if bound in bounds:
                higher = [other for other in bounds if other[:2] == bound[:2] and other.value > bound.value]
                applies |= where
                allowed[where] = max((other.duration for other in higher), default=0.0)
        passed = (value > bound.value * (1.0 + _BOUND_SLACK)) & applies
        held = _without_break(passed, duration)
        late[bound] = passed & (held > allowed * (1.0 + _BOUND_SLACK))
        told[bound] = value, held, allowed

    def words(k: int) -> None:
        problems = dict[str, Problem]()
        for bounds, where in sets:
            for bound in bounds if where[k] else ():
                if late[bound][k]:
                    problems.setdefault(bound.machine, _worn(bound, *(float(column[k]) for column in told[bound])))
        refuse(problems.values())

    return Doubt(np.any(list(late.values()), axis=0), words)


def _without_break(passed: Bools, duration: Floats) -> Floats:
    """Return for how long without a break a bound has been passed at the end of every interval [s]."""
    held, clock = np.zeros(len(duration)), 0.0
    for k, (over, span) in enumerate(zip(passed.tolist(), duration.tolist(), strict=True)):
        clock = clock + span if over else 0.0
        held[k] = clock
    return held


def _worn(bound: Bound, value: float, held: float, allowed: float) -> Problem:
    """Return what is wrong with a machine that gives or takes too much, or for too long."""
    amount = "{}; more than {}".format(*apart(value, bound.value, bound.name))
    if not allowed:
        return Problem(bound.machine, f"{amount} is beyond every limit that it has; ask for less, or add a limit")
    lasts, may = apart(held, allowed, "flight_time")
    message = f"{amount} lasts {lasts} without a break, and its limits allow {may}"
    return Problem(bound.machine, f"{message}; shorten the phase, or ask for less")
