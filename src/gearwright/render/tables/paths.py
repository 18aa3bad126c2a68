"""Parallel paths: how the train shares their load, and how the elastic gearbox does."""

from __future__ import annotations

from dataclasses import fields

from gearwright.dynamics.sharing import PathShare, path_shares
from gearwright.render.tables.tables import Table, table
from gearwright.sizing import Sizing

NOTE = (
    "Sizing uses the train's shares. The elastic ones follow from shaft and mesh stiffness alone, without errors and"
    " clocking; K_γ is the largest elastic share over the train's."
)


def path_table(sizing: Sizing) -> Table:
    """Return the shares of all parallel meshes in the design's first case; no rows where there are none.

    Args:
        sizing: As sized.
    """
    names = tuple(field.name for field in fields(PathShare))
    return table("Parallel paths", path_shares(sizing), names, note=NOTE)
