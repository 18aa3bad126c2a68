"""Table of a made propeller map: what stands out at every advance ratio."""

from __future__ import annotations

from gearwright.catalogue import MadePropeller
from gearwright.render.grid.table import Table, table

FIELDS = (
    "advance_ratio", "best_angle", "power_coefficient", "thrust_coefficient", "efficiency", "windmilling_angle",
    "windmilling_thrust",
)  # fmt: skip
MOST_ROWS = 21
"""Rows of a table; of more advance ratios every second, third … is shown."""


def propeller_table(made: MadePropeller) -> Table:
    """Return the best and the windmilling blade angle over the advance ratio, at the first Mach number of the map.

    Args:
        made: The map.
    """
    first = made.maps[0][0]
    rows = [row for row in made.rows if row.tip_mach == first]
    step = -(-len(rows) // MOST_ROWS)
    title = f"Propeller at tip Mach {first:g}" if first else "Propeller without compressibility"
    return table(title, rows[::step], FIELDS, note=NOTE)


NOTE = (
    "Best: of efficiency, at standstill of C_T^1.5/C_P, among the map's blade angles; idle: where the blades windmill"
    " and take no power."
)
"""What the columns mean."""
