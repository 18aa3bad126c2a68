"""A turboshaft engine in words: its deck, what a mission says of it, and seconds of a lever, a rotor or a start."""

from __future__ import annotations

from rich.console import Group, RenderableType
from rich.text import Text

from gearwright.catalogue import EngineTransient, MadeEngine
from gearwright.render.tables.turboshaft import deck_table, transient_table
from gearwright.render.words.text import table_text
from gearwright.units import text


def engine_text(made: MadeEngine) -> RenderableType:
    """Return an engine's deck for the terminal.

    Args:
        made: The engine.
    """
    keys, design = made.keys, made.design
    exponents = (
        f"  temperature_exponent = {keys.temperature_exponent:.2f}",
        f"  hot_exponent = {keys.hot_exponent:.2f}",
    )
    lines = (
        f"Its power turbine has an efficiency of {made.power_turbine:.3f}; T_45 is {made.hottest:.0f} K at most.",
        f"This deck of {len(made.rows)} rows is a file with --out deck.csv; a mission then has",
        "  [engine]",
        '  deck = "deck.csv"',
        *exponents,
        f"or, up to {100 * keys.worst_fuel:.0f} % in fuel and {100 * keys.worst_power:.0f} % in power from it,",
        "  [engine]",
        f"  thermal_power_kw = {design.power / 1e3:.4g}",
        f"  fuel_kg_kwh = {design.fuel_per_energy * 3.6e6:.4g}",
        f"  idle_fuel = {keys.idle_fuel:.3f}",
        *exponents,
        f"  air_flow_kg_s = {design.air_flow:.4g}",
    )
    words = "\n".join(lines)
    return Group(table_text(deck_table(made)), Text(), Text(words))


def transient_text(found: EngineTransient) -> RenderableType:
    """Return seconds of an engine for the terminal.

    Args:
        found: As computed.
    """
    return Group(Text(), table_text(transient_table(found)), Text(), Text(_said(found)))


def _said(found: EngineTransient) -> str:
    if found.kind == "start":
        energy = text(found.starter_energy or 0.0, "energy")
        said = f"At idle after {found.settled or 0.0:.1f} s; the starter gave {energy}"
    elif found.settled is None:
        said = "It does not settle in this time"
    elif found.kind == "held rotor":
        said = f"N2 stays within 0.5 % from {found.settled:.2f} s on"
    else:
        said = f"95 % of the change of power have come after {found.settled:.2f} s"
    if found.lowest_rotor is not None and found.highest_rotor is not None:
        said += f"; N2 is from {100 * found.lowest_rotor:.1f} to {100 * found.highest_rotor:.1f} %"
    bound = f"; bound by {', '.join(found.bound)}" if found.bound else "; no limit is reached"
    return f"{said}.\nT_45 up to {found.hottest:.0f} K{bound}."
