"""Simulated peaks beside the rated loads as a table."""

from __future__ import annotations

from dataclasses import fields

from gearwright.dynamics import Trace
from gearwright.dynamics.vibration import DynamicLoad, dynamic_loads
from gearwright.render.tables.tables import Table, table
from gearwright.sizing import Sizing

NOTE = (
    "Tangential peak of the worst line of each mesh row over its simulated mean, and over the force it is sized for:"
    " F_t K_A K_V where ISO 6336 or ISO 10300 rates the mesh, else F_t alone; a margin below 1 there asks for a dynamic"
    " factor (gears.bending_safety, gears.contact_safety)."
)


def dynamic_table(sizing: Sizing, trace: Trace) -> Table:
    """Return the peaks as a table.

    Args:
        sizing: As sized.
        trace: A run of it.
    """
    names = tuple(field.name for field in fields(DynamicLoad))
    return table("Peaks beside rated loads", dynamic_loads(sizing, trace), names, note=NOTE)
