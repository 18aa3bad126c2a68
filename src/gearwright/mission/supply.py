"""Turbines, motors and battery in flight: ratings, fuel and limits of duration."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from typing import NamedTuple

from gearwright.air import SEA_LEVEL_TEMPERATURE, air_at, stagnation_ratios
from gearwright.errors import DesignError, Problem, near, refuse
from gearwright.machines import (
    Battery,
    BatteryStep,
    Day,
    Engine,
    EngineDeck,
    MotorLosses,
    PowerLimits,
    deck_fuel,
    deck_limit,
    fuel_flow,
    motor_loss,
    power_limits,
    rated_losses,
    shared_losses,
)
from gearwright.machines.turboshaft import Breathing, Exhaust, air_flow, exhaust_of, mixed
from gearwright.mission.gearbox import Gearbox, Point
from gearwright.mission.plant import (
    Pack,
    PackState,
    Warmth,
    Warmths,
    faulty,
    less,
    pack_of,
    refuse_hot,
    warm_motor,
    warmed_motor,
)
from gearwright.mission.profile import Moment
from gearwright.sizing import Sizing
from gearwright.spec import EngineRules, Machine, Mission, Motor, MotorRules, Phase, WindingRules
from gearwright.spec.design import allowed_for
from gearwright.units import KWH, apart

# ----------------------------------------------------------------------------------------------------------------------
# What drives the gearbox in flight: turbines with their fuel, motors with their battery, and the limits of all.
# ----------------------------------------------------------------------------------------------------------------------


_SLACK = 1e-9
"""Part by which a limit may be passed: rounding."""


class Given(NamedTuple):
    """What the machines give in an interval."""

    point: Point
    """Of the gearbox."""
    powers: Mapping[str, float]
    """Machine -> power into the train, with drag and spin-up [W]."""


class Terms(NamedTuple):
    """Under which machines and battery give it."""

    pack: PackState
    """Of the battery at the start."""
    warmths: Warmths
    """Of the motors at the start."""
    rating: float
    """Of the turbines, over the usual one [-]."""
    mode: str
    """Of the phase."""


class Drawn(NamedTuple):
    """What machines and battery draw for what they give."""

    fuel_flow: float
    """[kg/s]"""
    turbine_power: float
    """Of all turbines [W]."""
    turbine_available: float
    """What they could give [W]."""
    exhaust: Exhaust
    """Of all turbines, mixed."""
    motor_loss: float
    """[W]"""
    battery: BatteryStep
    pack: PackState
    """Of the battery at the end."""
    warmths: Warmths
    """Of the motors at the end."""


class Burnt(NamedTuple):
    """What all turbines burn, could give and leave behind."""

    fuel_flow: float
    """[kg/s]"""
    available: float
    """[W]"""
    exhaust: Exhaust
    """Mixed."""


class MotorPoint(NamedTuple):
    """An operating point of a motor."""

    power: float
    """[W]"""
    speed: float
    """[rad/s]"""


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
        turbines = {name: engine.rated_power for name, engine in self.engines.items() if name not in phase.inoperative}
        motors = {name: motor.peak_power for name, motor in self.motors.items() if name not in phase.inoperative}
        if (share != 1.0 and not turbines) or (share != 0.0 and not motors):
            message = (
                f"{', '.join(phase.inoperative)} out, and {phase.mode} mode needs one; name fewer, or change the mode"
            )
            raise DesignError([Problem("inoperative", message)])
        return {**_divided(1.0 - share, turbines), **_divided(share, motors)}

    def drive(self, gearbox: Gearbox, moment: Moment, given: Given, terms: Terms) -> Drawn:
        """Return fuel, charge and losses of an interval.

        Args:
            gearbox: With the machines' names.
            moment: Where it is flown.
            given: The operating point, and the machines' powers.
            terms: Charge, rating and mode.

        Raises:
            DesignError: A machine or the battery cannot give its power.
        """
        powers, speeds = given.powers, machine_speeds(gearbox, given.point)
        burnt = self._burn(moment, powers, speeds, terms.rating)
        points = {name: MotorPoint(powers[name], speeds[name]) for name in self.motors if powers[name]}
        motors = {
            name: warm_motor(self.windings, motor, terms.warmths.get(name)) for name, motor in self.motors.items()
        }
        lost = sum(self._heat(name, motors[name], at, terms.mode) for name, at in points.items())
        electric = sum(powers[name] for name in self.motors) + lost
        step, pack = self._discharge(terms, electric, moment)
        warmths = self._warmer(motors, terms.warmths, points, moment)
        turbines = sum(powers[name] for name in self.engines)
        return Drawn(burnt.fuel_flow, turbines, burnt.available, burnt.exhaust, lost, step, pack, warmths)

    def dragged(self, gearbox: Gearbox, point: Point, parts: Mapping[str, float]) -> float:
        """Return what motors without current take from the shafts that drag them [W].

        Args:
            gearbox: With the machines' names.
            point: With the speeds.
            parts: The machines that give power.
        """
        speeds = machine_speeds(gearbox, point)
        return sum(motor_loss(motor, 0.0, speeds[name]) for name, motor in self.motors.items() if name not in parts)

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
            return fuel_flow(self.engines[name], *stagnation_ratios(moment.air, moment.mach), power)
        with _decked():
            return deck_fuel(self.deck, _day(moment), power)

    def _burn(self, moment: Moment, powers: Mapping[str, float], speeds: Mapping[str, float], rating: float) -> Burnt:
        """Return what all turbines burn; one that idles in electric mode is off."""
        fuel = available = 0.0
        exhausts = list[Exhaust]()
        ratios = stagnation_ratios(moment.air, moment.mach)
        for name in self.engines:
            limits = self.limited(name, moment, power=powers[name], speed=speeds[name], rating=rating)
            available += min(limits)
            if powers[name] < -_SLACK * limits.rating:
                raise DesignError([Problem(name, _braked(powers[name]))])
            burnt = self.fuel(name, moment, powers[name]) if powers[name] > 0.0 else 0.0
            exhausts.append(self._left(name, ratios, powers[name], (burnt, limits.core)))
            fuel += burnt
        gas = mixed(exhausts) if exhausts else Exhaust(temperature=ratios[0] * SEA_LEVEL_TEMPERATURE)
        return Burnt(fuel, available, gas)

    def _left(self, name: str, ratios: tuple[float, float], power: float, burnt: tuple[float, float]) -> Exhaust:
        """Return the exhaust of a turbine; `burnt` is its fuel flow [kg/s] and what its core could give [W]."""
        breathing, (fuel, core) = self.breathing[name], burnt
        air = air_flow(breathing, *ratios, min(max(power, 0.0) / core, 1.0))
        return exhaust_of(breathing, air, ratios[0] * SEA_LEVEL_TEMPERATURE, fuel=fuel, power=power)

    def _too_weak(self, moment: Moment, power: float, limits: PowerLimits) -> str:
        """Return what is wrong with a power that a turbine cannot give, and what helps."""
        bound, available = limits._fields[limits.index(min(limits))], min(limits)
        fix = "climb slower, fly slower" if moment.power is None else "ask for less power"
        if self.motors:
            fix += ", or give the motors a larger electric_share"
        asked, given = apart(power, available, "power")
        return f"needs {asked} at {moment.altitude:.0f} m, and gives {given} (by its {bound}); {fix}"

    def _warmer(
        self, motors: Mapping[str, MotorLosses], warmths: Warmths, points: Mapping[str, MotorPoint], moment: Moment
    ) -> Warmths:
        """Return the motors' temperatures at the end of an interval."""
        if self.windings is None:
            return {}
        after, air = dict[str, Warmth](), moment.air.temperature
        for name, motor in motors.items():
            power, speed = points.get(name, MotorPoint(0.0, 0.0))
            at, warmth = (power / speed if speed else 0.0, speed), warmths[name]
            after[name] = warmed_motor(self.windings, motor, warmth, at=at, air=air, duration=moment.duration)
            refuse_hot(self.windings, name, after[name])
        return after

    def _heat(self, name: str, motor: MotorLosses, point: MotorPoint, mode: str) -> float:
        power, speed = point
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
        return motor_loss(motor, torque, speed)

    def _more(self, name: str, motor: MotorLosses) -> str:
        """Return what raises a motor's limits."""
        derated = motor.peak_power < self.motors[name].peak_power
        return (
            "or cool it more: its winding is derated from motor.heat.derate_from_k"
            if derated
            else "or raise motor.overload"
        )

    def _discharge(self, terms: Terms, power: float, moment: Moment) -> tuple[BatteryStep, PackState]:
        if self.pack is None:
            if power > 0.0:
                message = (
                    f"the motors turn with {power / 1e3:.3g} kW of losses and there is no battery; give a [battery]"
                )
                raise DesignError([Problem("battery", message)])
            return BatteryStep(0.0, 0.0, 0.0, 0.0, 0.0, ""), terms.pack._replace(charge=0.0)
        step, after = self.pack.drawn(terms.pack, power, moment.duration, moment.air.temperature)
        if step.fault:
            message = faulty(self.pack.battery, terms.pack.charge, power, step=step, mode=terms.mode)
            raise DesignError([Problem("battery", message)])
        return step, after


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


def _braked(power: float) -> str:
    return (
        f"would take {-power / 1e3:.3g} kW from the gearbox, and a turbine only gives; raise pitch or power, fly"
        " electric so that the motors take it, or slow the propeller down within a longer ramp_s"
    )


def machine_speeds(gearbox: Gearbox, point: Point) -> dict[str, float]:
    """Return the speed of every machine without its sense [rad/s].

    Args:
        gearbox: With the machines' names.
        point: With the speeds.
    """
    train = gearbox.sizing.train
    return {name: abs(float(point.speeds[train.nodes.index(train.machines[name])])) for name in gearbox.machines}


def _divided(share: float, weights: Mapping[str, float]) -> dict[str, float]:
    """Divide a share in proportion to weights; without a share nothing is in it."""
    total = sum(weights.values())
    return {name: share * weight / total for name, weight in weights.items()} if share else {}


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


Clocks = Mapping[Bound, float]
"""Bound -> time without a break for which it has been passed [s]."""


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


def endured(
    bounds: tuple[Bound, ...], clocks: Clocks, duration: float, points: Mapping[str, tuple[float, float]]
) -> Clocks:
    """Return for how long each bound has been passed after an interval.

    Args:
        bounds: From `bounds_of`.
        clocks: Before the interval.
        duration: Of the interval [s].
        points: Machine -> power [W] and speed [rad/s].

    Raises:
        DesignError: If one is passed for longer than a higher one allows.
    """
    after, problems = dict[Bound, float](), dict[str, Problem]()
    for bound in bounds:
        power, speed = points[bound.machine]
        value = abs(power) if bound.name == "power" else abs(power) / speed if speed else 0.0
        if value <= bound.value * (1.0 + _BOUND_SLACK):
            continue
        after[bound] = clocks.get(bound, 0.0) + duration
        higher = [other for other in bounds if other[:2] == bound[:2] and other.value > bound.value]
        allowed = max((other.duration for other in higher), default=0.0)
        if after[bound] > allowed * (1.0 + _BOUND_SLACK):
            problems.setdefault(bound.machine, _worn(bound, value, after[bound], allowed))
    refuse(problems.values())
    return after


def _worn(bound: Bound, value: float, held: float, allowed: float) -> Problem:
    """Return what is wrong with a machine that gives or takes too much, or for too long."""
    amount = "{}; more than {}".format(*apart(value, bound.value, bound.name))
    if not allowed:
        return Problem(bound.machine, f"{amount} is beyond every limit that it has; ask for less, or add a limit")
    lasts, may = apart(held, allowed, "flight_time")
    message = f"{amount} lasts {lasts} without a break, and its limits allow {may}"
    return Problem(bound.machine, f"{message}; shorten the phase, or ask for less")
