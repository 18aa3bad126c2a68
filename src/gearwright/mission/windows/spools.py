"""Power slams that wait for the gas generator: how far a turbine's power has come, by its spool and fuel control."""

from __future__ import annotations

from functools import lru_cache

from gearwright.air import air_at, stagnation_ratios
from gearwright.errors import DesignError, Problem
from gearwright.machines.power import (
    FuelControl,
    Inlet,
    Rated,
    Turboshaft,
    at_rest,
    engine_of,
    spool,
    state_for,
    steady_state,
)
from gearwright.mission.windows.background import Background, Curve
from gearwright.mission.windows.curves import until
from gearwright.spec import SpoolRules, WindowRules

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

    Source: `machines.power.spool`; the torque goes with the power of the free turbine at one speed.

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
