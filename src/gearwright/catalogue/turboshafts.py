"""Turboshaft engine decks, from CSV files or a design point, and transients of engines and starts.

The components are machines' and are not here; flights read decks and do not make them.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Annotated, Literal, NamedTuple

import numpy as np

from gearwright.air import air_at, stagnation_ratios
from gearwright.base import (
    CELSIUS,
    Bools,
    DesignError,
    Energy,
    Floats,
    Inertia,
    Origin,
    Power,
    Problem,
    Quantity,
    Ratio,
    Shown,
    Speed,
    Time,
    Torque,
    refuse,
    verb,
)
from gearwright.files import numbers_of, text_of
from gearwright.machines.gas_generator import (
    FuelControl,
    RotorGovernor,
    SpoolStep,
    Starter,
    at_rest,
    held_rotor,
    spool,
    started,
)
from gearwright.machines.turboshaft import (
    STANDARD_PRESSURE,
    STANDARD_TEMPERATURE,
    DeckLine,
    EngineDeck,
    EngineState,
    Inlet,
    Rated,
    Turboshaft,
    compressed_to,
    engine_of,
    state_for,
    steady_state,
)

# ----------------------------------------------------------------------------------------------------------------------
# Engine decks as CSV files: read, checked, written.
# ----------------------------------------------------------------------------------------------------------------------


COLUMNS = ("altitude_m", "mach", "power_kw", "fuel_kg_h")
"""What a deck's CSV file has: at every altitude and Mach number of a grid the powers of some positions of the lever."""
LARGEST_DECK = 20_000_000
"""Largest file that is read [bytes]."""
_HOUR = 3600.0
_SENSIBLE: Mapping[str, tuple[float, float]] = {
    "altitude_m": (-1000.0, 20e3), "mach": (0.0, 0.999), "power_kw": (0.0, 1e6), "fuel_kg_h": (0.0, 1e6),
}  # fmt: skip
"""Column -> range of what it can be."""


class _Row(NamedTuple):
    line: int
    """Of the file; 0: none."""
    altitude: float
    mach: float
    power: float
    """[W]"""
    fuel: float
    """[kg/s]"""


def read_engine_deck(path: str | Path) -> EngineDeck:
    """Return an engine's deck from a CSV file.

    Args:
        path: Of the file, with the columns altitude_m, mach, power_kw, fuel_kg_h, for a standard day.

    Raises:
        DesignError: The file is missing or is no such deck; with every line that is wrong.
    """
    text = text_of(path, "engine.deck", largest=LARGEST_DECK)
    try:
        numbers = numbers_of(text, COLUMNS)
    except ValueError as error:
        refuse([Problem("engine.deck", f"{path}: {error}")])
    refuse([Problem("engine.deck", f"{path}: {reason}") for reason in _outside(numbers)])
    rows = [_Row(line, h, m, 1e3 * p, w / _HOUR) for line, (h, m, p, w) in enumerate(numbers, start=2)]
    refuse([Problem("engine.deck", f"{path}: {reason}") for reason in _wrong(rows)])
    return deck_of(row[1:] for row in rows)


def deck_of(rows: Iterable[tuple[float, float, float, float]]) -> EngineDeck:
    """Return a deck of rows that are known to be one.

    Args:
        rows: Altitude [m], Mach number [-], power [W], fuel [kg/s], in any order.

    Source: P and m_f over δ_t √θ_t of the standard day.
    """
    known = sorted(rows)
    altitudes, machs = sorted({row[0] for row in known}), sorted({row[1] for row in known})
    lines = tuple(tuple(_line(known, h, m) for m in machs) for h in altitudes)
    return EngineDeck(tuple(altitudes), tuple(machs), lines)


def _line(rows: list[tuple[float, float, float, float]], altitude: float, mach: float) -> DeckLine:
    theta, delta = stagnation_ratios(air_at(altitude), mach)
    factor = delta * math.sqrt(theta)
    here = [row for row in rows if row[:2] == (altitude, mach)]
    return DeckLine(tuple(row[2] / factor for row in here), tuple(row[3] / factor for row in here))


def deck_text(deck: EngineDeck) -> str:
    """Return a deck as the text of a CSV file, to be read by `read_engine_deck`.

    Args:
        deck: As read or made.
    """
    lines = [",".join(COLUMNS)]
    for altitude, row in zip(deck.altitude, deck.lines, strict=True):
        for mach, line in zip(deck.mach, row, strict=True):
            theta, delta = stagnation_ratios(air_at(altitude), mach)
            factor = delta * math.sqrt(theta)
            lines += [
                f"{altitude:g},{mach:g},{1e-3 * factor * power:.6g},{_HOUR * factor * fuel:.6g}"
                for power, fuel in zip(line.power, line.fuel, strict=True)
            ]
    return "\n".join(lines) + "\n"


def _outside(numbers: list[list[float]]) -> Iterator[str]:
    for line, row in enumerate(numbers, start=2):
        for value, name in zip(row, COLUMNS, strict=True):
            low, high = _SENSIBLE[name]
            if not low <= value <= high:
                yield f"line {line}: {name} is {value:g}; give one from {low:g} to {high:g}"


def _wrong(rows: list[_Row]) -> Iterator[str]:
    """Yield what makes rows no deck: holes of the grid, too few powers, powers given twice, fuel that falls."""
    if not rows:
        yield "it has no rows; give powers at every altitude and Mach number"
    altitudes, machs = sorted({row.altitude for row in rows}), sorted({row.mach for row in rows})
    for altitude in altitudes:
        for mach in machs:
            here = sorted((row for row in rows if row[1:3] == (altitude, mach)), key=lambda row: row.power)
            place = f"at {altitude:g} m and Mach {mach:g}"
            if len(here) < 2:
                yield f"{place} it has {len(here)} powers; give two at least at every altitude and Mach number"
            for one, other in pairwise(here):
                if one.power == other.power:
                    yield f"line {other.line}: {place} {1e-3 * other.power:g} kW is given twice; take one out"
                elif other.fuel <= one.fuel:
                    rises = f"{1e-3 * other.power:g} kW burn no more than {1e-3 * one.power:g} kW"
                    yield f"line {other.line}: {place} {rises}; fuel must rise with the power"


# ----------------------------------------------------------------------------------------------------------------------
# A turboshaft engine from its design point: its deck over altitude, Mach number and power, and a mission's keys.
# ----------------------------------------------------------------------------------------------------------------------


ALTITUDES = (0.0, 3000.0, 6000.0, 9000.0)
"""Of a deck, where none are said [m]."""
MACHS = (0.0, 0.3, 0.6)
"""The same [-]."""
PARTS = (0.1, 0.25, 0.4, 0.55, 0.7, 0.85, 1.0)
"""Of the highest power at each [-]."""
HOT_DAYS = (10.0, 20.0, 30.0, 40.0)
"""Over the standard day at sea level, on which the exponent of hot air is fitted [K]."""
TEMPERATURE_EXPONENT = -2.5
"""Where a deck has no air that is colder than the standard sea level's; as of a mission that states none [-]."""
_CYCLE = "gas generator by its components; docs/theory/power.md"
_RANGES = {
    "power": (1e3, 1e8), "fuel_per_energy": (1e-8, 1e-6), "air_flow": (1e-3, 1e3), "pressure_ratio": (3.0, 40.0),
    "speed": (100.0, 1e4), "compressor": (0.5, 0.95), "turbine": (0.5, 0.95), "inertia": (1e-9, 100.0),
}  # fmt: skip
"""Field -> what it can be (SI)."""


@dataclass(frozen=True)
class DesignPoint:
    """A turboshaft with a gas generator and a free power turbine, at sea level on a standard day without speed."""

    power: Power
    fuel_per_energy: Annotated[float, Quantity("fuel_per_energy")]
    """Specific fuel consumption."""
    air_flow: Annotated[float, Quantity("air_flow")]
    pressure_ratio: Ratio
    """p_3/p_2."""
    speed: Speed
    """N1 of the gas generator."""
    inertia: Inertia = 0.06
    """Of the gas generator."""
    compressor: Ratio = 0.81
    """Isentropic efficiency; an assumption."""
    turbine: Ratio = 0.86
    """Isentropic efficiency of the turbine that drives it; an assumption."""


@dataclass(frozen=True)
class DeckRow:
    """An engine at one altitude, Mach number and power."""

    altitude: Annotated[float, Quantity("height")]
    mach: Ratio
    power: Power
    part: Annotated[Ratio, Origin("P/P_max, where N1 or T_45 is that of the design point", _CYCLE)]
    fuel_flow: Annotated[float, Quantity("mass_flow"), Origin("heat of the burner", _CYCLE)]
    consumption: Annotated[float, Quantity("fuel_per_energy"), Origin("m_f/P", "definition")]
    gas_generator: Annotated[Ratio, Origin("N1/N1_0", _CYCLE)]
    between: Annotated[float, Quantity("absolute_temperature"), Origin("T_45, between the turbines", _CYCLE)]
    pressure_ratio: Annotated[Ratio, Origin("p_3/p_2", _CYCLE)]
    air_flow: Annotated[float, Quantity("air_flow"), Origin("choked first nozzle", _CYCLE)]


@dataclass(frozen=True)
class MissionKeys:
    """What a mission's [engine] says of such an engine, and by how much it errs without a deck."""

    idle_fuel: Annotated[Ratio, Origin("least squares of the Willans line over the deck", _CYCLE)]
    temperature_exponent: Annotated[
        float, Quantity("ratio"), Origin("least squares of n in δ_t θ_t^n, θ_t up to 1", _CYCLE)
    ]
    hot_exponent: Annotated[float, Quantity("ratio"), Origin("the same on hot days at sea level", _CYCLE)]
    worst_fuel: Annotated[Ratio, Origin("largest |Willans line/deck - 1|", "definition")]
    worst_power: Annotated[Ratio, Origin("largest |P_0 δ_t θ_t^n/P_max - 1|, hot days too", "definition")]


@dataclass(frozen=True, repr=False)
class MadeEngine(Shown):
    """An engine's deck, as made."""

    design: DesignPoint
    power_turbine: Annotated[Ratio, Origin("what the design point implies", _CYCLE)]
    """Isentropic efficiency."""
    hottest: Annotated[float, Quantity("absolute_temperature"), Origin("T_45 of the design point", _CYCLE)]
    keys: MissionKeys
    rows: tuple[DeckRow, ...]

    @property
    def deck(self) -> EngineDeck:
        """For missions."""
        return deck_of((row.altitude, row.mach, row.power, row.fuel_flow) for row in self.rows)


@verb
def turboshaft(
    design: DesignPoint,
    *,
    altitudes: Sequence[float] = ALTITUDES,
    machs: Sequence[float] = MACHS,
    parts: Sequence[float] = PARTS,
) -> MadeEngine:
    """Return the deck of a turboshaft engine that its design point implies.

    Args:
        design: The design point.
        altitudes: Of the deck, rising [m].
        machs: Of the deck, rising [-].
        parts: Of the highest power at each, rising [-].

    Raises:
        DesignError: Numbers that no engine has, a design point that cannot be, a place where it gives no power.
    """
    refuse(_problems(design, altitudes, machs, parts))
    engine = turboshaft_engine(design)
    rest = steady_state(engine, Inlet(STANDARD_TEMPERATURE, STANDARD_PRESSURE, STANDARD_PRESSURE), design.speed)
    rows = tuple(
        row
        for altitude in altitudes
        for mach in machs
        for row in _deck_rows(engine, altitude, mach, rest.between, parts)
    )
    hot = [_hot(engine, offset, rest.between) for offset in HOT_DAYS]
    return MadeEngine(design, engine.power_efficiency, rest.between, _keys(design, rows, hot), rows)


def turboshaft_engine(design: DesignPoint) -> Turboshaft:
    """Return the engine of a design point.

    Args:
        design: The design point.

    Raises:
        DesignError: Its power turbine would need an efficiency that there is not.
    """
    fix = "give another power, fuel_kg_kwh, air flow, pressure ratio or efficiency"
    try:
        engine = engine_of(
            Rated(
                design.power, design.fuel_per_energy * design.power, design.air_flow, design.pressure_ratio,
                design.compressor, design.turbine, inertia=design.inertia, speed=design.speed,
            )
        )  # fmt: skip
        found = engine.power_efficiency
    except (ValueError, ZeroDivisionError, OverflowError):
        raise DesignError([Problem("turboshaft", f"its turbines have no state at the design point; {fix}")]) from None
    if not 0.5 < found < 0.97:
        needed = f"its power turbine would need an efficiency of {found:.3g}, not from 0.5 to 0.97"
        raise DesignError([Problem("turboshaft", f"{needed}; {fix}")])
    return engine


def inlet_at(altitude: float, mach: float, isa_offset: float = 0.0) -> Inlet:
    """Return the air before an engine.

    Args:
        altitude: Pressure altitude [m].
        mach: Flight Mach number; all of its stagnation pressure comes in [-].
        isa_offset: Temperature above the standard atmosphere [K].
    """
    air = air_at(altitude, isa_offset)
    theta, delta = stagnation_ratios(air, mach)
    return Inlet(theta * STANDARD_TEMPERATURE, delta * STANDARD_PRESSURE, air.pressure)


def highest_state(engine: Turboshaft, inlet: Inlet, hottest: float) -> tuple[float, EngineState]:
    """Return N1 and state at which a limit of an engine at rest is reached: N1 of its design point, or T_45.

    Args:
        engine: The engine.
        inlet: The air before it.
        hottest: T_45 [K].

    Raises:
        ValueError: There is none.
    """
    from scipy.optimize import brentq

    fast = engine.rated.speed
    state = steady_state(engine, inlet, fast)
    if state.between <= hottest * (1.0 + 1e-9):
        return fast, state

    def hotter(speed: float) -> float:
        return steady_state(engine, inlet, speed).between - hottest

    speed = float(brentq(hotter, 0.8 * fast, fast, xtol=1e-9 * fast, rtol=1e-12))
    return speed, steady_state(engine, inlet, speed)


def _deck_rows(
    engine: Turboshaft, altitude: float, mach: float, hottest: float, parts: Sequence[float]
) -> list[DeckRow]:
    inlet, found = inlet_at(altitude, mach), list[DeckRow]()
    try:
        speed, state = highest_state(engine, inlet, hottest)
        top = state.power
        for part in sorted(parts, reverse=True):
            if part < 1.0:
                speed, state = state_for(engine, inlet, part * top, (speed, state.turbine_inlet))
            found.append(_row((altitude, mach, part), speed / engine.rated.speed, state))
    except ValueError as error:
        at = f"at {altitude:g} m and Mach {mach:g}"
        raise DesignError([Problem("turboshaft", f"{at}: {error}; leave this place or these parts out")]) from None
    return found[::-1]


def _row(at: tuple[float, float, float], speed: float, state: EngineState) -> DeckRow:
    altitude, mach, part = at
    return DeckRow(
        altitude, mach, state.power, part, state.fuel_flow, state.fuel_flow / state.power, speed, state.between,
        state.pressure_ratio, state.air_flow,
    )  # fmt: skip


class _Top(NamedTuple):
    """The highest power of an engine in some air."""

    theta: float
    """Stagnation temperature over that of the standard sea level θ_t [-]."""
    power: float
    """Over δ_t [W]."""


def _top(row: DeckRow) -> _Top:
    theta, delta = stagnation_ratios(air_at(row.altitude), row.mach)
    return _Top(theta, row.power / delta)


def _hot(engine: Turboshaft, offset: float, hottest: float) -> _Top:
    """Return the highest power at sea level on a hot day."""
    inlet = inlet_at(0.0, 0.0, offset)
    return _Top(inlet.temperature / STANDARD_TEMPERATURE, highest_state(engine, inlet, hottest)[1].power)


def _keys(design: DesignPoint, rows: Sequence[DeckRow], days: Sequence[_Top]) -> MissionKeys:
    """Fit the line and the exponents of a mission, all relative, so that every altitude counts alike.

    Source: normal equations of one unknown each: m_f/m_0 = i δ_t √θ_t + (1 - i) P/P_0; ln(P_max/(P_0 δ_t)) = n ln θ_t.
    """
    upper = lower = 0.0
    ratios = [stagnation_ratios(air_at(row.altitude), row.mach) for row in rows]
    burnt = design.fuel_per_energy * design.power
    for row, (theta, delta) in zip(rows, ratios, strict=True):
        part, fuel = row.power / design.power, row.fuel_flow / burnt
        lever = (delta * math.sqrt(theta) - part) / fuel
        upper, lower = upper + lever * (1.0 - part / fuel), lower + lever * lever
    idle = min(max(upper / lower, 0.0), 0.99) if lower else 0.2
    tops = [_top(row) for row in rows if row.part == 1.0]
    cold, hot = _exponent(design, [top for top in tops if top.theta < 1.0]), _exponent(design, days)
    worst = max(
        abs(burnt * (idle * delta * math.sqrt(theta) + (1.0 - idle) * row.power / design.power) / row.fuel_flow - 1.0)
        for row, (theta, delta) in zip(rows, ratios, strict=True)
    )
    most = max(
        abs(design.power * theta ** (hot if theta > 1.0 else cold) / power - 1.0) for theta, power in (*tops, *days)
    )
    return MissionKeys(idle, cold, hot, worst, most)


def _exponent(design: DesignPoint, tops: Sequence[_Top]) -> float:
    """Return n by least squares; a mission's own where no air is colder than the standard sea level."""
    high = sum(math.log(top.theta) * math.log(top.power / design.power) for top in tops)
    deep = sum(math.log(top.theta) ** 2 for top in tops)
    return high / deep if deep > 1e-12 else TEMPERATURE_EXPONENT


def _problems(
    design: DesignPoint, altitudes: Sequence[float], machs: Sequence[float], parts: Sequence[float]
) -> list[Problem]:
    found = list[Problem]()
    for name, (low, high) in _RANGES.items():
        value = getattr(design, name)
        if not low <= value <= high:
            found.append(Problem(name, f"{value:g} is not allowed; give a value from {low:g} to {high:g} (SI)"))
    axes = (("altitudes", altitudes, -1000.0, 20e3), ("machs", machs, 0.0, 0.95), ("parts", parts, 0.02, 1.0))
    for name, values, low, high in axes:
        if not values or any(not low <= value <= high for value in values):
            found.append(Problem(name, f"give one at least, each from {low:g} to {high:g}"))
        elif any(b <= a for a, b in pairwise(values)):
            found.append(Problem(name, "they must rise"))
    if parts and max(parts) != 1.0:
        found.append(Problem("parts", "the last must be 1, the highest power"))
    return found


# ----------------------------------------------------------------------------------------------------------------------
# Seconds of a turboshaft: a lever that is moved, a rotor that is loaded and held by a governor on N2, a start.
# ----------------------------------------------------------------------------------------------------------------------


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
    rows = _transient_rows(run.time, run.speed / rated.speed, None, (run.power, run.fuel, run.between))
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
    rows = _transient_rows(run.time, speed, turns, (run.torque * run.rotor, run.fuel, run.between))
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
    rows = _transient_rows(run.time, run.speed / fast, None, (run.starter, run.fuel, run.between))
    hot = ("T_45",) if run.between.max() >= 0.98 * rules.hottest else ()
    return EngineTransient("start", float(run.time[-1]), float(run.between.max()), None, None, energy, hot, rows)


def _hung(speed: Floats, rules: StartRules) -> str:
    most = float(speed.max())
    where = f"after {rules.longest:g} s it turns at {speed[-1]:.3f} of N1 (at most {most:.3f}), not {rules.idle:g}"
    if most < rules.light:
        return f"{where}: the starter does not turn it to {rules.light:g}, where it lights; give more torque"
    return f"{where}: it hangs; give more torque, a higher cut, more fuel or a higher hottest T_45"


def _transient_rows(
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
