"""Whether a mesh runs in its main resonance: N of ISO 6336-1 at the speed of every case that matters."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gearwright.checks import Check
from gearwright.identity import PartId
from gearwright.sizing.rating.iso6336.record import MeshResonance

CLAUSE = "ISO 6336-1, 6.5.3: N below N_S or above 1.15"
MODE = "main resonance"
HELPS = "other teeth, modules or speeds lie beside it; gearwright close looks for the lightest where they are open"
"""What to do about a mesh in its main resonance."""


def resonance_checks(found: Sequence[MeshResonance], mesh: PartId) -> Iterator[Check]:
    """Yield the case in which a mesh runs nearest to its main resonance, with what it passes on the way to others.

    Args:
        found: N in every case that matters.
        mesh: The mesh.
    """
    nearest = min(found, key=lambda one: one.separation / one.least, default=None)
    if nearest is None:
        return
    slow, fast = (pick(found, key=lambda one: one.ratio) for pick in (min, max))
    why = list[str]()
    if nearest.separation < nearest.least:
        why.append(HELPS)
    if slow.ratio < 1.0 < fast.ratio:
        why.append(f"passes N = 1 between {slow.case} (N {slow.ratio:.2f}) and {fast.case} (N {fast.ratio:.2f})")
    yield Check(
        mesh, MODE, CLAUSE, nearest.separation, nearest.least, "ratio", exponent=None, symbol="|1 − N|",
        place=f"N {nearest.ratio:.3f}", case=nearest.case, why="; ".join(why),
    )  # fmt: skip
