"""What the sheet of a housing says of its ribs and mounts."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from gearwright.render.drawings.casing.outside_view import mounts_of, ribs_of
from gearwright.render.drawings.casing.plane_section import Casing
from gearwright.render.drawings.sheet.entities import millimetres, trimmed
from gearwright.render.drawings.sheet.tables import Grid
from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.shape import short_of
from gearwright.sizing import Sizing


def mounts_grid(casing: Casing) -> Grid:
    """Return the lugs of a housing: from where to where they stand, where their holes are, and how wide.

    Args:
        casing: The housing.
    """
    rows = []
    for k, lug in enumerate(mounts_of(casing.scene), start=1):
        middle, radius = lug.hole or (lug.base, 0.0)
        places = (trimmed(MM * (at - casing.start), 1) for at in lug.span)
        rows.append((f"{k}", *places, *(trimmed(MM * at, 1) for at in middle), f"Ø{trimmed(2.0 * MM * radius, 1)}"))
    return Grid("Mounts [mm]", tuple(rows), ("No.", "From", "To", "y", "z", "Hole"))


def standing_notes(sizing: Sizing, casing: Casing) -> Iterator[str]:
    """Yield how many ribs of which size a housing has, and what walls leave no room for.

    Args:
        sizing: What was sized.
        casing: The housing.
    """
    ribs = ribs_of(casing.scene)
    if ribs:
        thick = np.linalg.norm(ribs[0].loop[3] - ribs[0].loop[0])
        yield (
            f"{len(ribs)} ribs along walls and on plates beside narrower ones, {millimetres(MM * float(thick))} thick, "
            "as high as they are weighed; not hatched. Places of ribs and mounts are assumed."
        )
    for part, (drawn, weighed) in short_of(sizing, casing.scene).items():
        yield f"{part.capitalize()}: {drawn:.3g} kg of {weighed:.3g} kg are drawn: walls leave no room for more."
