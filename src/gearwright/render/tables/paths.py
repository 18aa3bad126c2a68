"""Parallel paths: how the train shares their load, and how the elastic gearbox does."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Annotated

from gearwright.dynamics.assembly import default_case
from gearwright.dynamics.sharing import elastic_shares
from gearwright.render.tables.tables import Table, table
from gearwright.sizing import Sizing
from gearwright.units import Origin, Quantity

NOTE = (
    "Sizing uses the train's shares. The elastic ones follow from shaft and mesh stiffness alone, without errors and"
    " clocking; K_γ is the largest elastic share over the train's."
)
IDLE = 1e-9
"""Share of the load below which a path idles and is not listed [-]."""


@dataclass(frozen=True)
class PathShare:
    """One of several meshes side by side."""

    mesh: str
    case: str
    train: Annotated[float, Quantity("percent"), Origin("equal, or as the design states", "design")]
    """Share of the load in the train's statics [-]."""
    elastic: Annotated[float, Quantity("percent"), Origin("Σ d f = Q at mean stiffness", "System statics")]
    """Share of the load in the elastic gearbox [-]."""
    ratio: Annotated[float, Quantity("ratio"), Origin("elastic / train", "definition")]
    """Elastic over train share [-]."""


def path_table(sizing: Sizing) -> Table:
    """Return the shares of all parallel meshes in the design's first case; no rows where there are none.

    Args:
        sizing: As sized.
    """
    case = default_case(sizing)
    flow, rows = sizing.flows[case], []
    if any(len(_rows(sizing, stage)) > 1 for stage in sizing.design.pairs):
        for stage, shares in elastic_shares(sizing, case).items():
            total = sum(flow.meshes[mesh].multiplier for mesh in _rows(sizing, stage))
            for mesh, elastic in shares.items():
                train = flow.meshes[mesh].multiplier / total
                if abs(train) > IDLE:
                    rows.append(PathShare(mesh, case, train, elastic, elastic / train))
    return table("Parallel paths", rows, tuple(field.name for field in fields(PathShare)), note=NOTE)


def _rows(sizing: Sizing, stage: str) -> list[str]:
    return [mesh.name for mesh in sizing.train.meshes if mesh.stage == stage]
