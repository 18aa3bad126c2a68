"""Events of an event window: short circuit, engine failure, power slam, pitch runaway and sudden stop."""

import math
from collections.abc import Collection, Mapping
from dataclasses import replace
from functools import lru_cache

import numpy as np

from gearwright.air import air_at, stagnation_ratios
from gearwright.base import DesignError, Problem, near
from gearwright.catalogue import ALL_STATES, propeller_map
from gearwright.dynamics import System
from gearwright.dynamics.model import MachineDrive
from gearwright.machines import (
    Inlet,
    PropellerMap,
    Rated,
    Turboshaft,
    Winding,
    engine_of,
    short_circuit_torque,
    state_for,
    steady_state,
)
from gearwright.machines.gas_generator import FuelControl, at_rest, spool
from gearwright.mission.supply import Supply
from gearwright.mission.windows.background import (
    LAGS,
    Background,
    Brake,
    Curve,
    GearboxEquilibrium,
    blended,
    changed_stage,
    flown_phase,
    lagged,
    steady,
    stepped,
    until,
    value_at,
)
from gearwright.spec import SpoolRules, WindowRules

# ----------------------------------------------------------------------------------------------------------------------
# Power slams that wait for the gas generator: how far a turbine's power has come, by its spool and fuel control.
# ----------------------------------------------------------------------------------------------------------------------


STEP = 0.02
"""Of the spool's steps [s]."""
LONGEST = 20.0
"""What a slam lasts at most; what it has reached then stays [s]."""
STIFF = 16.0
"""Gain of the governor on N1, part of the rated fuel over part of the rated speed [-]; an assumption."""
SPARE = 1.05
"""Limits of temperature and fuel over those of the states between which it slams [-]."""
FASTEST = 1.1
"""N1 over the rated one beyond which no gas generator turns [-]; an assumption."""
STANDARD_TEMPERATURE, STANDARD_PRESSURE = 288.15, 101325.0
"""Of the standard sea level [K]; [Pa]."""


def spooled(back: Background, rules: WindowRules, name: str, *, power: float, torque: float) -> Curve:
    """Return a turbine's torque in a slam, which comes as its gas generator speeds up.

    Args:
        back: What goes on.
        rules: When the lever is moved.
        name: Of the turbine.
        power: Of it in the end [W].
        torque: In the end [N m].

    Source: `machines.gas_generator.spool`; the torque goes with the power of the free turbine at one speed.

    Raises:
        DesignError: The gas generator has no state for one of the powers.
    """
    known, before = back.torques[name], float(back.flight.machines[name].power[back.interval])
    start = until(known, rules)
    if before == power:
        return known
    lasts = min(max(rules.duration - rules.event_at, STEP), LONGEST)
    times, shares = _shares(back, name, before=before, after=power, lasts=lasts)
    first = start[-1][1]
    came = [
        (rules.event_at + time, first + share * (torque - first)) for time, share in zip(times, shares, strict=True)
    ]
    return [*start, *came]


def _shares(
    back: Background, name: str, *, before: float, after: float, lasts: float
) -> tuple[list[float], list[float]]:
    """Return times from the slam on [s], and the part of the change that has come by then [-]."""
    history, k = back.flight.history, back.interval
    air = air_at(float(history.altitude[k]), back.flight.mission.isa_offset_k)
    theta, delta = stagnation_ratios(air, float(history.mach[k]))
    inlet = Inlet(theta * STANDARD_TEMPERATURE, delta * STANDARD_PRESSURE, air.pressure)
    given = back.flight.mission.engine.spool
    assert given is not None  # asked before
    engine = back.supply.engines[name]
    design = (engine.thermal_power, engine.fuel_per_energy * engine.thermal_power, back.supply.breathing[name].air_flow)
    try:
        times, powers = _slam(design, given, inlet, (before, after), lasts)
    except ValueError as error:
        message = (
            f"from {before / 1e3:.4g} to {after / 1e3:.4g} kW the gas generator of {name} has no state: {error};"
            " give other efficiencies, pressure ratio or air flow, or slam from and to a power that it can give"
        )
        raise DesignError([Problem("engine.spool", message)]) from None
    first, gained = powers[0], after - powers[0]
    return list(times), [(power - first) / gained for power in powers]


@lru_cache(maxsize=16)
def _slam(
    design: tuple[float, float, float], given: SpoolRules, inlet: Inlet, powers: tuple[float, float], lasts: float
) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Return times [s] and powers [W] of an engine that goes from one power to another.

    Raises:
        ValueError: It has no state for one of the powers.
    """
    engine = _engine(design, given)
    guess = (0.9 * given.speed, 1100.0)
    (slow, rest), (fast, busy) = (state_for(engine, inlet, power, guess) for power in powers)
    if max(slow, fast) > FASTEST * given.speed:
        raise ValueError(f"it would turn at {max(slow, fast) / given.speed:.3g} of its rated N1, at most {FASTEST:g}")
    fuel, pressure = engine.rated.fuel_flow, engine.rated.pressure_ratio * STANDARD_PRESSURE
    ends = [state.fuel_flow / (inlet.pressure * state.pressure_ratio) for state in (rest, busy)]
    top = steady_state(engine, Inlet(STANDARD_TEMPERATURE, STANDARD_PRESSURE, STANDARD_PRESSURE), given.speed)
    stiffness = STIFF * fuel / given.speed
    control = FuelControl(
        gain=stiffness,
        integral=stiffness,
        time=given.valve,
        highest_speed=max(SPARE * given.speed, fast, slow),
        hottest=SPARE * max(top.between, rest.between, busy.between),
        accelerating=max(given.acceleration * fuel / pressure, SPARE * max(ends)),
        decelerating=min(given.deceleration * fuel / pressure, min(ends) / SPARE),
    )
    start = at_rest(engine, inlet, slow, rest, control)
    run = spool(engine, control, inlet, start=start, demand=lambda time: fast, times=(lasts, STEP))
    return tuple(run.time.tolist()), tuple(run.power.tolist())


def _engine(design: tuple[float, float, float], given: SpoolRules) -> Turboshaft:
    """Return the engine of a thermal power [W], its fuel [kg/s] and air flow [kg/s].

    Raises:
        ValueError: No such engine has turbines.
    """
    power, fuel, air = design
    engine = engine_of(
        Rated(
            power, fuel, air, given.pressure_ratio, given.compressor, given.turbine, inertia=given.inertia,
            speed=given.speed,
        )
    )  # fmt: skip
    if not 0.0 < engine.power_efficiency < 1.0:
        raise ValueError(f"its power turbine would need an efficiency of {engine.power_efficiency:.3g}")
    return engine


# ----------------------------------------------------------------------------------------------------------------------
# Faults and slams: short circuit of a motor, failure of an engine, pitch run-away, slam of the power lever, strike.
#
# What every event shares is in `curves`; changes that a pilot or a gust makes are in `events`.
# ----------------------------------------------------------------------------------------------------------------------


POINTS_PER_CYCLE = 32
"""Points of a short circuit's torque in one electric cycle: straight lines between them are off by 5e-3 of it."""
MOST_POINTS = 20_000
"""Of a short circuit's torque [-]."""
BEYOND = 3.2
"""Pitch command that is finer than every stop [rad]."""
SOON = 1e-3
"""Time in which the overspeed governor takes over [s]."""


def failing(supply: Supply, rules: WindowRules, at: str) -> str:
    """Return the machine that fails.

    Args:
        supply: Machines of the gearbox.
        rules: What happens.
        at: Path of the window.

    Raises:
        DesignError: The design has none of its kind, none of this name, or several.
    """
    short = rules.event == "motor-short-circuit"
    kind, machines = ("motor", supply.motors) if short else ("turbine", supply.engines)
    return _named(kind, machines, rules, at)


def _named(kind: str, machines: Collection[str], rules: WindowRules, at: str) -> str:
    if not machines:
        message = f"{rules.event}, but the design has no {kind}; choose another event, or a design with one"
        raise DesignError([Problem(f"{at}.event", message)])
    if rules.machine is None and len(machines) > 1:
        message = f"{rules.event} without machine, and the design has {', '.join(sorted(machines))}; name one"
        raise DesignError([Problem(f"{at}.machine", message)])
    if rules.machine is not None and rules.machine not in machines:
        message = f"no such {kind}: {rules.machine}; {near(rules.machine, machines)}"
        raise DesignError([Problem(f"{at}.machine", message)])
    return rules.machine or next(iter(machines))


def freewheels(back: Background, rules: WindowRules) -> dict[str, float]:
    """Return the overrunning clutches that let an engine go when it fails, with what they carry at first [N m].

    Args:
        back: What goes on.
        rules: What happens.
    """
    if rules.event != "engine-out":
        return {}
    name, train = failing(back.supply, rules, "windows"), back.flight.sizing.train
    return {
        joint.name: value_at(back.torques[name], 0.0)
        for joint in train.joints
        if joint.overrunning and joint.driving == train.machines[name]
    }


def winding_of(back: Background, rules: WindowRules, name: str) -> Winding:
    """Return the motor's winding; a resistance that is not given follows from its copper loss.

    Args:
        back: What goes on.
        rules: With E, L and p.
        name: Of the motor.

    Source: 3 R I² = k_c T² with T Ω_r = 3 E I, hence R = 3 k_c E²/Ω_r²; an estimate, as k_c itself is one where the
        mission does not state the shares of the motor's losses.
    """
    rated = back.flight.sizing.design.motors[name].speed
    emf, copper = rules.back_emf_v or 0.0, back.supply.motors[name].copper
    resistance = 3.0 * copper * (emf / rated) ** 2 if rules.resistance_ohm is None else rules.resistance_ohm
    return Winding(emf, (rules.inductance_mh or 0.0) * 1e-3, resistance, rules.pole_pairs or 1, rated)


def short_circuited(back: Background, rules: WindowRules) -> Background:
    """Return a background in which a motor's phases are short-circuited, its speed that at the window's start.

    Args:
        back: What goes on.
        rules: What happens.
    """
    name = failing(back.supply, rules, "windows")
    winding = winding_of(back, rules, name)
    before = value_at(back.torques[name], rules.event_at)
    speed = back.flight.machines[name].speed[back.interval] * value_at(back.speed, rules.event_at)
    speed = abs(float(speed)) / float(back.flight.history.propeller_speed[back.interval])
    cycle = 2.0 * math.pi / (winding.pole_pairs * speed)
    left = rules.duration - rules.event_at
    rings = LAGS * winding.inductance / winding.resistance if winding.resistance else left
    count = min(max(2, math.ceil(min(rings, left) / cycle * POINTS_PER_CYCLE)), MOST_POINTS)
    time = np.linspace(0.0, min(rings, left), count + 1)
    torque = short_circuit_torque(winding, speed, before=before, time=time)
    curve = [*until(back.torques[name], rules), *zip((rules.event_at + time).tolist(), torque.tolist(), strict=True)]
    return replace(back, torques={**back.torques, name: curve}, limits=False)


def engine_out(back: Background, rules: WindowRules) -> Background:
    """Return a background in which a turbine's torque dies with its time constant.

    Args:
        back: What goes on.
        rules: What happens.
    """
    name = failing(back.supply, rules, "windows")
    return replace(back, torques={**back.torques, name: lagged(back.torques[name], 0.0, rules)})


def slammed(back: Background, rules: WindowRules) -> Background:
    """Return a background in which all machines go to another power: turbines by their lag, motors within `over`.

    Args:
        back: What goes on.
        rules: What happens.
    """
    phase = flown_phase(back.flight, back.interval)
    parts = back.supply.parts(phase)
    powers = {name: parts.get(name, 0.0) * (rules.power or 0.0) for name in back.gearbox.machines}
    after = changed_stage(back, rules, phase, powers)
    return replace(
        back,
        torques={
            name: _sped_up(back, rules, name, (powers[name], after.torques[name]))
            if name in back.supply.engines
            else blended(curve, steady(after.torques[name]), rules)
            for name, curve in back.torques.items()
        },
        resistances=_resisted(back, after, rules),
    )


def _resisted(back: Background, after: GearboxEquilibrium, rules: WindowRules) -> dict[str, Curve]:
    """Return what mesh losses take from shafts, while the event leads to another equilibrium."""
    return {shaft: blended(curve, steady(after.resistances[shaft]), rules) for shaft, curve in back.resistances.items()}


def _sped_up(back: Background, rules: WindowRules, name: str, end: tuple[float, float]) -> Curve:
    """Return a turbine's torque until a power [W] and a torque [N m], by its lag or by its gas generator."""
    if rules.lag is None and back.flight.mission.engine.spool is not None:
        return spooled(back, rules, name, power=end[0], torque=end[1])
    return lagged(back.torques[name], end[1], rules)


def struck(back: Background, rules: WindowRules) -> Background:
    """Return a background in which the propeller strikes: a torque that rises within `over` and lasts.

    Args:
        back: What goes on.
        rules: What happens.

    Source: T = J ω/t for a stop in the time t, J of everything that turns, at the propeller.
    """
    speed = value_at(back.speed, rules.event_at)
    torque = rules.strike_torque or back.gearbox.inertia * speed / (rules.stop_time or math.inf)
    start, end = rules.event_at, rules.event_at + (rules.lasts or 0.0)
    rise = min(rules.over, 0.5 * (end - start))
    return replace(back, strike=[(start, 0.0), (start + rise, -torque), (end - rise, -torque), (end, 0.0)])


def runaway(back: Background, rules: WindowRules) -> Background:
    """Return a background in which the pitch runs to its fine stop, as fast as its actuator moves.

    Args:
        back: What goes on.
        rules: What happens.
    """
    share = rules.overspeed or 1.0
    held = blended(back.speed, [(time, share * value) for time, value in back.speed], rules)
    return replace(back, pitch=[(rules.event_at, 0.0), (rules.event_at + SOON, -BEYOND)], held_speed=held)


def caught(back: Background, rules: WindowRules, system: System) -> Background | None:
    """Return a background in which the overspeed governor takes the pitch over; None where nothing reaches its speed.

    Args:
        back: With a pitch that runs away.
        rules: What happens.
        system: With the speed profile of the run-away.
    """
    profile, limit = system.arrays.profile, rules.overspeed or 1.0
    over = np.flatnonzero(profile.factor >= limit * profile.factor[0])
    if back.held_speed is None or not len(over):
        return None
    time = float(profile.time[over[0]])
    return replace(back, pitch=[*back.pitch, (time, -BEYOND), (time + SOON, 0.0)])


# ----------------------------------------------------------------------------------------------------------------------
# Sudden stop: the propeller or a machine seizes, or a brake is put on, and everything that turns comes to rest.
# ----------------------------------------------------------------------------------------------------------------------


CREEP = 0.01
"""Part of the speed below which a brake's torque falls with it, so that it does not change its sense by steps [-]."""
STEADY = 1e-3
"""Time in which that speed may fade at the fastest: the rigid pass has such steps [s]."""
RESTS = 2.0
"""Times that part of the speed which counts as rest [-]."""


def seized(rules: WindowRules, propeller: str, machines: Mapping[str, object]) -> str:
    """Return what comes to a stop: the propeller, or the machine that is named.

    Args:
        rules: What happens.
        propeller: Its name.
        machines: Turbines, motors and others of the design by name.

    Raises:
        DesignError: There is no such machine.
    """
    if rules.machine is not None and rules.machine not in (propeller, *machines):
        message = f"no such machine: {rules.machine}; {near(rules.machine, [propeller, *machines])}"
        raise DesignError([Problem("windows", message)])
    return rules.machine or propeller


def stopped(back: Background, rules: WindowRules) -> Background:
    """Return a background in which something seizes; machines go on, or fail by the event's time constant.

    Args:
        back: What goes on.
        rules: What happens.

    Source: T = J ω/t for a stop in the time t, J of everything that turns at the shaft that is held; Coulomb friction,
        which holds what it has stopped.
    """
    name = seized(rules, back.gearbox.propeller, back.flight.machines)
    ahead = value_at(back.speed, rules.event_at)
    speed = ahead * turning(back, name)
    whole = back.gearbox.inertia * (ahead / speed) ** 2
    torque = rules.brake_torque or whole * speed / (rules.stop_time or 1.0)
    takes = whole * speed / torque
    creep = max(CREEP, STEADY / takes)
    end = rules.event_at + min(rules.over, 0.5 * takes)
    curve = [(rules.event_at, 0.0), (end, -torque), (end + 1e-6, -torque / creep)]
    torques = {
        machine: blended(known, steady(0.0), rules)
        if machine == name
        else known
        if rules.lag is None
        else lagged(known, 0.0, rules)
        for machine, known in back.torques.items()
    }
    fading = rules.model_copy(update={"over": takes})
    return replace(
        back,
        torques=torques,
        resistances={shaft: blended(known, steady(0.0), fading) for shaft, known in back.resistances.items()},
        brake=Brake(name, torque, curve, speed, creep),
    )


def turning(back: Background, name: str) -> float:
    """Return the speed of a machine over that of the propeller [-].

    Args:
        back: What goes on.
        name: Of the machine, or of the propeller.
    """
    if name not in back.flight.machines:
        return 1.0
    speeds = back.flight.machines[name].speed, back.flight.history.propeller_speed
    return abs(float(speeds[0][back.interval])) / float(speeds[1][back.interval])


def brake_drive(brake: Brake) -> MachineDrive:
    """Return the law of a brake: a constant torque against the speed, which fades with it at the very end.

    Args:
        brake: That holds a shaft.
    """
    return MachineDrive("brake", brake.machine, brake.curve, brake.speed, -1.0, brake.torque)


def stream_map(name: str, chart: PropellerMap) -> PropellerMap:
    """Return a map of blades that come to rest in a stream: of a shipped one that in all states.

    Args:
        name: Of the mission's map.
        chart: That map.
    """
    full = f"{name}-all-states"
    return propeller_map(full) if full in ALL_STATES else chart


def rest_time(time: np.ndarray, speed: np.ndarray, creep: float) -> float | None:
    """Return when a speed has come to rest [s]; None where it has not.

    Args:
        time: Middles of bins, shape (n,) [s].
        speed: Means in them, shape (n,) [rad/s].
        creep: Part of the speed at the start below which a brake's torque fades [-].
    """
    moving = np.flatnonzero(np.abs(speed) > RESTS * creep * abs(float(speed[0])))
    if not len(moving):
        return float(time[0])
    return float(time[moving[-1] + 1]) if moving[-1] + 1 < len(time) else None


# ----------------------------------------------------------------------------------------------------------------------
# Events: what a window changes of the mission that goes on in it.
# ----------------------------------------------------------------------------------------------------------------------


GUST_POINTS = 48
"""Points of a 1-cos gust: straight lines between them are off by 1e-3 of it."""


def changed(back: Background, rules: WindowRules) -> Background:
    """Return a background with the window's event in it.

    Args:
        back: What goes on.
        rules: What happens.

    Raises:
        DesignError: A mode change needs a machine that the design lacks.
    """
    match rules.event:
        case "motor-cut":
            return _scaled(back, rules, set(back.supply.motors))
        case "turbine-cut":
            return _scaled(back, rules, set(back.supply.engines))
        case "mode-change":
            return _other_mode(back, rules)
        case "pitch-step":
            return replace(back, pitch=stepped(steady(0.0), rules, rules.pitch_step or 0.0))
        case "speed-step":
            return replace(back, speed=stepped(back.speed, rules, rules.speed_step or 0.0))
        case "gust":
            return replace(back, airspeed=_gust(back.airspeed, rules))
        case "clutch-engagement":
            return _joining(back, rules)
        case "motor-short-circuit":
            return short_circuited(back, rules)
        case "engine-out":
            return engine_out(back, rules)
        case "pitch-runaway":
            return runaway(back, rules)
        case "power-slam":
            return slammed(back, rules)
        case "propeller-strike":
            return struck(back, rules)
        case "sudden-stop":
            return stopped(back, rules)
        case _:
            return back


def _scaled(back: Background, rules: WindowRules, machines: set[str]) -> Background:
    """Return a background in which machines stop."""
    if not machines:
        message = f"{rules.event}, but the design has no such machine; choose another event"
        raise DesignError([Problem("windows", message)])
    torques = {
        name: blended(curve, steady(0.0), rules) if name in machines else curve for name, curve in back.torques.items()
    }
    return replace(back, torques=torques)


def _other_mode(back: Background, rules: WindowRules) -> Background:
    """Return a background in which other machines share the power, or another one."""
    phase = back.flight.mission.phases[back.phase].model_copy(
        update={"mode": rules.mode, "electric_share": rules.electric_share}
    )
    before = sum(float(machine.power[back.interval]) for machine in back.flight.machines.values())
    power = before if rules.power is None else rules.power
    parts = back.supply.parts(phase)
    powers = {name: parts.get(name, 0.0) * power for name in back.gearbox.machines}
    after = changed_stage(back, rules, phase, powers)
    return replace(
        back,
        torques={name: blended(curve, steady(after.torques[name]), rules) for name, curve in back.torques.items()},
        resistances=_resisted(back, after, rules),
    )


def _gust(airspeed: Curve, rules: WindowRules) -> Curve:
    top = rules.gust or 0.0
    if rules.gust_shape == "step":
        return stepped(airspeed, rules, top)
    times = rules.event_at + np.linspace(0.0, rules.over, GUST_POINTS + 1)
    inside = [
        (float(time), value_at(airspeed, float(time)) + 0.5 * top * (1.0 - math.cos(2.0 * math.pi * k / GUST_POINTS)))
        for k, time in enumerate(times)
    ]
    outside = [(time, value) for time, value in airspeed if not times[0] <= time <= times[-1]]
    return sorted([*outside, *inside])


def _joining(back: Background, rules: WindowRules) -> Background:
    """Return a background in which the machine before a clutch gives nothing until the event."""
    joint = next((clutch for clutch in back.flight.sizing.train.joints if clutch.name == rules.clutch), None)
    train = back.flight.sizing.train
    torques = {
        name: blended(steady(0.0), curve, rules) if joint and train.machines[name] == joint.driving else curve
        for name, curve in back.torques.items()
    }
    return replace(back, torques=torques)
