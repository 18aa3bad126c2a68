"""Edges of gears: chamfers of bores, and how the edges of teeth are broken."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.render.drawings.sheet.entities import trimmed
from gearwright.render.drawings.views.shaft_parts import CHAMFERS

BROKEN = 0.1
"""Of the edges of teeth over the module [-]; assumed."""
LEAST = 0.2
"""Of the same, at least [mm]; assumed."""


def edge_notes(bore: float, module: float) -> Iterator[str]:
    """Yield how the edges of a gear are broken.

    Args:
        bore: Its diameter; 0: none [mm].
        module: Normal, or mean normal module [mm].
    """
    broken = max(round(BROKEN * module, 1), LEAST)
    bored = ""
    if bore:
        chamfer = next(chamfer for up_to, chamfer in CHAMFERS if bore <= up_to)
        bored = f" chamfers of the bore {trimmed(chamfer, 1)} × 45°,"
    yield f"Edges of teeth, at tips and ends, {trimmed(broken, 1)} × 45°,{bored} as assumed; not weighed."
