"""Simulated peaks beside the rated loads as a table."""

from __future__ import annotations

from dataclasses import fields

from gearwright.dynamics import Trace
from gearwright.dynamics.vibration import DynamicLoad, dynamic_loads
from gearwright.render.grid.table import Table, table
from gearwright.sizing import Sizing
from gearwright.sizing.rating import METHODS

_NOTE = (
    "Tangential peak of the worst line of each mesh row over its simulated mean, and over the force it is sized for:"
)


def dynamic_table(sizing: Sizing, trace: Trace) -> Table:
    """Return the peaks as a table.

    Args:
        sizing: As sized.
        trace: A run of it.
    """
    names = tuple(field.name for field in fields(DynamicLoad))
    return table("Peaks beside rated loads", dynamic_loads(sizing, trace), names, note=_note(sizing))


def _note(sizing: Sizing) -> str:
    """Return what the force is that each mesh is sized for, by its method."""
    methods = {name: METHODS[name] for name in dict.fromkeys(mesh.rating.method for mesh in sizing.meshes) if name}
    forces = [f"{f'F_t {method.peaks}'.rstrip()} by {method.edition}" for method in methods.values()]
    return f"{_NOTE} {', '.join(forces)}; a margin below 1 there asks for a larger safety."
