"""Parallel paths: how the train shares their load, and how the elastic gearbox does."""

from __future__ import annotations

from collections import Counter
from dataclasses import fields

from gearwright.render.grid.table import Table, table
from gearwright.sizing import Sizing

TITLE = "Parallel paths"
NOTE = (
    "Sizing uses the train's shares. The elastic ones follow from shaft and mesh stiffness alone, without errors and"
    " clocking; K_γ is the largest elastic share over the train's."
)


def path_table(sizing: Sizing) -> Table:
    """Return the shares of all parallel meshes in the governing case; no rows where there are none.

    Args:
        sizing: As sized.
    """
    meshes = Counter(mesh.stage for mesh in sizing.train.meshes)
    if all(meshes[stage] < 2 for stage in sizing.design.pairs):
        return table(TITLE, (), ())
    from gearwright.dynamics.sharing import PathShare, path_shares

    names = tuple(field.name for field in fields(PathShare))
    return table(TITLE, path_shares(sizing), names, note=NOTE)
