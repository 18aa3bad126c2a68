"""How parallel meshes share their load when the gearbox is elastic and without errors."""

from __future__ import annotations

from gearwright.dynamics.assembly import assemble, default_case
from gearwright.dynamics.equations import statics
from gearwright.sizing import Sizing
from gearwright.verbs import verb


@verb
def elastic_shares(sizing: Sizing, case: str | None = None) -> dict[str, dict[str, float]]:
    """Return the share of each parallel mesh of every pair that meshes with several, from the System's statics [-].

    The train shares equally, or as the design states; the elastic answer differs where the paths differ.

    Args:
        sizing: What was sized.
        case: Load case; left out: the design's first one, or ``rated``.

    Returns:
        Pair -> mesh -> share; the shares of a pair add up to 1.
    """
    case = case or default_case(sizing)
    system = assemble(sizing, case, stiffness="constant")
    force = dict(zip(system.labels.lines, statics(system).force, strict=True))
    shares = {}
    for stage in sizing.design.pairs:
        rows = [mesh.name for mesh in sizing.train.meshes if mesh.stage == stage]
        total = sum(force[row] for row in rows)
        if len(rows) > 1 and total:
            shares[stage] = {row: float(force[row] / total) for row in rows}
    return shares
