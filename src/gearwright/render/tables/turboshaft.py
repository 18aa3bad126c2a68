"""Tables of a turboshaft engine: its deck, and seconds of it."""

from __future__ import annotations

from gearwright.catalogue import EngineTransient, MadeEngine
from gearwright.render.grid.table import Table, table

DECK = (
    "altitude", "mach", "power", "part", "fuel_flow", "consumption", "gas_generator", "between", "pressure_ratio",
)  # fmt: skip
SECONDS = ("time", "gas_generator", "rotor", "power", "fuel_flow", "between")
MIDDLE = 0.4
"""Part of the highest power that is shown beside it [-]."""
TITLES = {"slam": "Lever", "held rotor": "Rotor held by a governor on N2", "start": "Start; P is the starter's"}
"""Kind of a transient -> title of its table."""


def deck_table(made: MadeEngine) -> Table:
    """Return an engine's highest and a middle power at every place of its deck.

    Args:
        made: The engine.
    """
    parts = sorted({row.part for row in made.rows})
    shown = {parts[-1], min(parts, key=lambda part: abs(part - MIDDLE))}
    return table("Deck", [row for row in made.rows if row.part in shown], list(DECK))


def transient_table(found: EngineTransient) -> Table:
    """Return seconds of an engine.

    Args:
        found: As computed.
    """
    without = {"rotor"} if found.lowest_rotor is None else set[str]()
    return table(TITLES[found.kind], found.rows, [name for name in SECONDS if name not in without])
