"""A turboshaft engine from its design point: its deck over altitude, Mach number and power, and a mission's keys."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Annotated, NamedTuple

from gearwright.air import air_at, stagnation_ratios
from gearwright.catalogue.turboshafts.decks import deck_of
from gearwright.errors import DesignError, Problem, refuse
from gearwright.machines.engine_deck import EngineDeck
from gearwright.machines.power import (
    STANDARD_PRESSURE,
    STANDARD_TEMPERATURE,
    EngineState,
    Inlet,
    Rated,
    Turboshaft,
    engine_of,
    state_for,
    steady_state,
)
from gearwright.showing import Shown
from gearwright.units import Inertia, Origin, Power, Quantity, Ratio, Speed
from gearwright.verbs import verb

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
    rest = steady_state(engine, _standard(), design.speed)
    rows = tuple(
        row for altitude in altitudes for mach in machs for row in _rows(engine, altitude, mach, rest.between, parts)
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


def _standard() -> Inlet:
    return Inlet(STANDARD_TEMPERATURE, STANDARD_PRESSURE, STANDARD_PRESSURE)


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


def _rows(engine: Turboshaft, altitude: float, mach: float, hottest: float, parts: Sequence[float]) -> list[DeckRow]:
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
