"""How parallel meshes share their load when the gearbox is elastic and without errors."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from gearwright.blas_threads import one_blas_thread
from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.equations import statics
from gearwright.sizing import Sizing, governing_case
from gearwright.units import Origin, Quantity
from gearwright.verbs import verb

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


@verb
@one_blas_thread()
def elastic_shares(sizing: Sizing, case: str | None = None) -> dict[str, dict[str, float]]:
    """Return the share of each parallel mesh of every pair that meshes with several, from the System's statics [-].

    The train shares equally, or as the design states; the elastic answer differs where the paths differ.

    Args:
        sizing: What was sized.
        case: Load case; left out: the governing one, which has the least margin.

    Returns:
        Pair -> mesh -> share; the shares of a pair add up to 1.
    """
    case = case or governing_case(sizing)
    system = assemble(sizing, case, stiffness="constant")
    force = dict(zip(system.labels.lines, statics(system).force, strict=True))
    shares = {}
    for stage in sizing.design.pairs:
        rows = _rows(sizing, stage)
        total = sum(force[row] for row in rows)
        if len(rows) > 1 and total:
            shares[stage] = {row: float(force[row] / total) for row in rows}
    return shares


def path_shares(sizing: Sizing) -> tuple[PathShare, ...]:
    """Return the shares of all parallel meshes in the governing case; none where no pair has several meshes.

    Args:
        sizing: What was sized.
    """
    if all(len(_rows(sizing, stage)) < 2 for stage in sizing.design.pairs):
        return ()
    case = governing_case(sizing)
    meshes, paths = sizing.flows[case].meshes, []
    for stage, shares in elastic_shares(sizing, case).items():
        total = sum(meshes[mesh].multiplier for mesh in _rows(sizing, stage))
        for mesh, elastic in shares.items():
            train = meshes[mesh].multiplier / total
            if abs(train) > IDLE:
                paths.append(PathShare(mesh, case, train, elastic, elastic / train))
    return tuple(paths)


def _rows(sizing: Sizing, stage: str) -> list[str]:
    return [mesh.name for mesh in sizing.train.meshes if mesh.stage == stage]
