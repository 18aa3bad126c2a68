"""Seconds of a turboshaft: a lever that is moved, a rotor that is loaded and held by a governor on N2, a start."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

import numpy as np

from gearwright.arrays import Bools, Floats
from gearwright.catalogue.turboshafts.made import DesignPoint, highest_state, inlet_at, turboshaft_engine
from gearwright.errors import DesignError, Problem, refuse
from gearwright.machines.power import (
    FuelControl,
    Inlet,
    RotorGovernor,
    SpoolStep,
    Starter,
    Turboshaft,
    at_rest,
    compressed_to,
    held_rotor,
    spool,
    started,
    state_for,
    steady_state,
)
from gearwright.showing import Shown
from gearwright.units import CELSIUS, Energy, Inertia, Origin, Power, Quantity, Ratio, Speed, Time, Torque
from gearwright.verbs import verb

SPARE = 1.05
"""Limits of T_45 and N1 on the way over those of the design point, which hold at rest [-]; an assumption."""
STIFF = 16.0
"""Gain of the governor on N1, part of the rated fuel over part of the rated speed [-]; an assumption."""
STEP = 0.02
"""Of a slam [s]."""
START_STEP = 0.1
"""Of a start [s]."""
HIGHEST_MACH = 0.95
"""Of a slam [-]."""
SHOWN = 24
"""Rows that a transient shows, about."""
_SPOOL = "gas generator by its components; docs/theory/power.md"


@dataclass(frozen=True)
class Rotor:
    """A rotor or propeller that turns with the power turbine, and the governor that holds its speed."""

    inertia: Inertia
    """Of all that turns with it, at the power turbine."""
    speed: Speed
    """N2 that is held."""
    gain: Ratio = 1.0
    """Per cent of N1 asked for one per cent of N2."""
    integral: Annotated[float, Quantity("frequency")] = 0.5
    """The same over its integral [1/s]; 0: a governor with droop."""
    highest: Ratio = 1.1
    """N2 over the one that is held from which on the least fuel flows; an assumption."""


@dataclass(frozen=True)
class Slam:
    """A change of power within half a second, at one place."""

    before: Power
    after: Power
    altitude: Annotated[float, Quantity("height")] = 0.0
    mach: Ratio = 0.0
    isa_offset: float = 0.0
    """[K]"""
    duration: Time = 10.0
    acceleration: Ratio = 1.0
    """Most fuel over p_3, over that of the design point."""
    deceleration: Ratio = 0.3
    """Least of it."""
    rotor: Rotor | None = None
    """None: the speed of the power turbine is held by others, and the lever asks for N1."""


@dataclass(frozen=True)
class StartRules:
    """A start, at one place."""

    torque: Torque
    """Of the starter at rest, on the gas generator."""
    free: Ratio = 0.8
    """N1 over the rated one at which it gives nothing."""
    cut: Ratio = 0.5
    """N1 at which it is switched off."""
    light: Ratio = 0.12
    """N1 at which fuel flows."""
    idle: Ratio = 0.62
    """N1 at which the engine has started."""
    fuel: Ratio = 0.9
    """Most fuel over p_3, over that of the design point."""
    hottest: Annotated[float, Quantity("absolute_temperature")] = 1100.0
    """T_45 to which the fuel is cut back."""
    altitude: Annotated[float, Quantity("height")] = 0.0
    isa_offset: float = 0.0
    """[K]"""
    longest: Time = 60.0


@dataclass(frozen=True)
class TransientRow:
    """An engine at one instant."""

    time: Time
    gas_generator: Annotated[Ratio, Origin("J N1 dN1/dt = P_t - P_c", _SPOOL)]
    """N1/N1_0."""
    rotor: Annotated[float | None, Quantity("ratio"), Origin("J dω/dt = T - Q", _SPOOL)]
    """N2/N2_0; None where no rotor is held."""
    power: Annotated[Power, Origin("of the power turbine; of a starter while it starts", _SPOOL)]
    fuel_flow: Annotated[float, Quantity("mass_flow"), Origin("of the fuel control", _SPOOL)]
    between: Annotated[float, Quantity("absolute_temperature"), Origin("T_45", _SPOOL)]


@dataclass(frozen=True, repr=False)
class EngineTransient(Shown):
    """Seconds of an engine."""

    kind: Literal["slam", "held rotor", "start"]
    settled: Annotated[
        float | None, Quantity("time"), Origin("95 % of the change of power; N2 within 0.5 %; idle", "definition")
    ]
    """From the change on; None where it does not come."""
    hottest: Annotated[float, Quantity("absolute_temperature"), Origin("largest T_45", _SPOOL)]
    lowest_rotor: Annotated[float | None, Quantity("ratio"), Origin("least N2/N2_0", _SPOOL)]
    highest_rotor: Annotated[float | None, Quantity("ratio"), Origin("largest N2/N2_0", _SPOOL)]
    starter_energy: Annotated[Energy | None, Origin("∫ T ω dt", _SPOOL)]
    bound: tuple[str, ...]
    """Limits of the fuel control that were reached."""
    rows: tuple[TransientRow, ...]


@verb
def engine_slam(design: DesignPoint, slam: Slam) -> EngineTransient:
    """Return how an engine follows its lever, or how a governor on N2 holds a rotor whose load changes.

    Args:
        design: The engine.
        slam: What changes, where.

    Raises:
        DesignError: One of the powers is more than the engine gives there at rest, or less than it has a state for; it
            burns out on the way.
    """
    refuse(_slam_problems(slam))
    engine, inlet = turboshaft_engine(design), inlet_at(slam.altitude, slam.mach, slam.isa_offset)
    try:
        return _slammed(engine, inlet, slam)
    except ValueError as error:
        where = f"from {slam.before / 1e3:.4g} to {slam.after / 1e3:.4g} kW at {slam.altitude:g} m"
        raise DesignError([Problem("slam", f"{where}: {error}; ask for powers that it gives there")]) from None


def _slammed(engine: Turboshaft, inlet: Inlet, slam: Slam) -> EngineTransient:
    rated, control = engine.rated, control_of(engine, slam)
    most = highest_state(engine, inlet, control.hottest / SPARE)[1].power
    if max(slam.before, slam.after) > most * (1.0 + 1e-6):
        limits = "N1 and T_45 of the design point"
        raise ValueError(f"{limits} leave {most / 1e3:.4g} kW in air of {inlet.temperature - CELSIUS:.1f} °C")
    guess = (0.9 * rated.speed, 1150.0)
    (slow, rest), (fast, _) = (state_for(engine, inlet, power, guess) for power in (slam.before, slam.after))
    start, times = at_rest(engine, inlet, slow, rest, control), (slam.duration, STEP)
    if slam.rotor is not None:
        return _held(engine, inlet, slam, control, start=start, times=times)
    run = spool(engine, control, inlet, start=start, demand=lambda time: fast, times=times)
    there = np.abs(run.power - slam.after) <= 0.05 * abs(slam.after - slam.before)
    rows = _rows(run.time, run.speed / rated.speed, None, (run.power, run.fuel, run.between))
    bound = _bound(control, run.fuel_over_pressure, run.between)
    return EngineTransient("slam", _settled(run.time, there), float(run.between.max()), None, None, None, bound, rows)


def _held(
    engine: Turboshaft, inlet: Inlet, slam: Slam, control: FuelControl, *, start: SpoolStep, times: tuple[float, float]
) -> EngineTransient:
    """Return a rotor that is loaded between 0.5 and 1 s, its torque as the square of its speed."""
    rotor = slam.rotor
    assert rotor is not None  # asked before
    scale = engine.rated.speed / rotor.speed
    governor = RotorGovernor(
        rotor.inertia, rotor.speed, rotor.gain * scale, rotor.integral * scale, rotor.highest * rotor.speed
    )

    def load(time: float, speed: float) -> float:
        part = min(max((time - 0.5) / 0.5, 0.0), 1.0)
        power = slam.before + part * (slam.after - slam.before)
        return power / rotor.speed * (speed / rotor.speed) ** 2

    run = held_rotor(engine, control, governor, inlet, start=start, load=load, times=times)
    turns, speed = run.rotor / rotor.speed, run.speed / engine.rated.speed
    rows = _rows(run.time, speed, turns, (run.torque * run.rotor, run.fuel, run.between))
    pressure = np.array([inlet.pressure * compressed_to(engine, inlet, one)[1] for one in run.speed.tolist()])
    bound, settled = _bound(control, run.fuel / pressure, run.between), _settled(run.time, np.abs(turns - 1.0) <= 5e-3)
    bound += ("N2",) if turns.max() >= rotor.highest else ()
    ends = float(turns.min()), float(turns.max())
    return EngineTransient("held rotor", settled, float(run.between.max()), *ends, None, bound, rows)


def control_of(engine: Turboshaft, slam: Slam) -> FuelControl:
    """Return a fuel control by parts of the design point's fuel over p_3.

    Args:
        engine: The engine.
        slam: With its limits of acceleration and deceleration.
    """
    rated, standard = engine.rated, inlet_at(0.0, 0.0)
    over = rated.fuel_flow / (standard.pressure * rated.pressure_ratio)
    gain = STIFF * rated.fuel_flow / rated.speed
    hottest = SPARE * steady_state(engine, standard, rated.speed).between
    return FuelControl(
        gain, gain, 0.05, SPARE * rated.speed, hottest, slam.acceleration * over, slam.deceleration * over
    )


def _bound(control: FuelControl, over: Floats, between: Floats) -> tuple[str, ...]:
    """Return which limits of a fuel control were reached."""
    reached = {
        "fuel for acceleration": bool(np.any(over >= 0.99 * control.accelerating)),
        "T_45": bool(np.any(between >= 0.995 * control.hottest)),
        "fuel for deceleration": bool(np.any(over <= 1.01 * control.decelerating)),
    }
    return tuple(name for name, found in reached.items() if found)


@verb
def engine_start(design: DesignPoint, rules: StartRules) -> EngineTransient:
    """Return how an engine starts: cranked, lit, on its own, at idle; its power turbine stands.

    Args:
        design: The engine.
        rules: Starter, fuel and place.

    Raises:
        DesignError: The starter cannot turn it to where it lights, it hangs below idle, or burns out.
    """
    refuse(_start_problems(rules))
    engine, inlet = turboshaft_engine(design), inlet_at(rules.altitude, 0.0, rules.isa_offset)
    rated, fast = engine.rated, engine.rated.speed
    over = rated.fuel_flow / (inlet_at(0.0, 0.0).pressure * rated.pressure_ratio)
    starter = Starter(
        rules.torque, rules.free * fast, rules.cut * fast, rules.light * fast, rules.fuel * over, rules.hottest
    )
    try:
        run = started(engine, starter, inlet, idle=rules.idle * fast, times=(rules.longest, START_STEP))
    except ValueError as error:
        raise DesignError([Problem("start", f"{error}; give less fuel, or light it at a higher N1")]) from None
    if run.speed[-1] < rules.idle * fast:
        raise DesignError([Problem("start", _hung(run.speed / fast, rules))])
    energy = float(np.trapezoid(run.starter, run.time))
    rows = _rows(run.time, run.speed / fast, None, (run.starter, run.fuel, run.between))
    hot = ("T_45",) if run.between.max() >= 0.98 * rules.hottest else ()
    return EngineTransient("start", float(run.time[-1]), float(run.between.max()), None, None, energy, hot, rows)


def _hung(speed: Floats, rules: StartRules) -> str:
    most = float(speed.max())
    where = f"after {rules.longest:g} s it turns at {speed[-1]:.3f} of N1 (at most {most:.3f}), not {rules.idle:g}"
    if most < rules.light:
        return f"{where}: the starter does not turn it to {rules.light:g}, where it lights; give more torque"
    return f"{where}: it hangs; give more torque, a higher cut, more fuel or a higher hottest T_45"


def _rows(
    time: Floats, speed: Floats, rotor: Floats | None, others: tuple[Floats, Floats, Floats]
) -> tuple[TransientRow, ...]:
    every = max(len(time) // SHOWN, 1)
    picked = sorted({*range(0, len(time), every), len(time) - 1})
    return tuple(
        TransientRow(
            float(time[k]), float(speed[k]), None if rotor is None else float(rotor[k]),
            *(float(one[k]) for one in others),
        )
        for k in picked
    )  # fmt: skip


def _settled(time: Floats, there: Bools) -> float | None:
    """Return from when on it stays there; None: not at the end."""
    if not there[-1]:
        return None
    away = np.flatnonzero(~there)
    return float(time[away[-1] + 1]) if len(away) else 0.0


def _slam_problems(slam: Slam) -> list[Problem]:
    found = [
        Problem(name, f"{value:g} W is not allowed; give a power above 0")
        for name, value in (("before", slam.before), ("after", slam.after))
        if not value > 0.0
    ]
    if slam.before == slam.after:
        found.append(Problem("after", "it is the power before; give another"))
    if not 0.0 <= slam.mach <= HIGHEST_MACH:
        found.append(Problem("mach", f"{slam.mach:g} is not allowed; give one from 0 to {HIGHEST_MACH:g}"))
    if not 0.1 <= slam.duration <= 60.0:
        found.append(Problem("duration", f"{slam.duration:g} s is not allowed; give one from 0.1 to 60 s"))
    if not 0.0 < slam.deceleration < slam.acceleration <= 3.0:
        found.append(Problem("acceleration", "give a limit above that of deceleration, up to 3"))
    rotor = slam.rotor
    if rotor is not None and not 1.0 < rotor.highest <= 1.5:
        found.append(Problem("highest", f"{rotor.highest:g} is not allowed; give an N2 limit above 1, up to 1.5"))
    if rotor is not None and not (rotor.inertia > 0.0 and rotor.speed > 0.0 and rotor.gain > 0.0 <= rotor.integral):
        found.append(Problem("rotor", "give inertia, N2 and gain above 0, and an integral of at least 0"))
    return found


def _start_problems(rules: StartRules) -> list[Problem]:
    found = list[Problem]()
    if not 0.0 < rules.torque <= 1e5:
        found.append(Problem("torque", f"{rules.torque:g} N m is not allowed; give one above 0, up to 1e5"))
    if not 0.02 <= rules.light < rules.cut <= rules.free <= 2.0:
        found.append(Problem("cut", "give light below cut below free, from 0.02 to 2 of N1"))
    if not 0.3 <= rules.idle <= 0.95:
        found.append(Problem("idle", f"{rules.idle:g} is not allowed; give one from 0.3 to 0.95 of N1"))
    if not 0.05 <= rules.fuel <= 3.0:
        found.append(Problem("fuel", f"{rules.fuel:g} is not allowed; give one from 0.05 to 3"))
    if not 500.0 <= rules.hottest <= 1900.0:
        found.append(Problem("hottest", f"{rules.hottest:g} K is not allowed; give one from 500 to 1900 K"))
    return found
