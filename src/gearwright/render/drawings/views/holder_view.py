"""Parts that hold bearings in section: rings, nuts, end plates, spacers and covers."""

from __future__ import annotations

import math

from gearwright.render.drawings.sheet.entities import Entity, Hatch, Layer, Path
from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.render.drawings.views.shaft_view import Axis
from gearwright.sizing.shafts import Holder

_FINE = 1.0
"""Between hatching lines [mm]."""
LEANS = {"spacer": 60.0, "housing spacer": 120.0, "cover": 30.0}
"""Kind -> lean of its hatching [°]: unlike that of the rings beside it; of all else 150."""


def holder_section(axis: Axis, holder: Holder) -> list[Entity]:
    """Return a part in section, both halves.

    Args:
        axis: Of its shaft.
        holder: The part.
    """
    lean = math.radians(LEANS.get(holder.kind, 150.0))
    entities: list[Entity] = []
    for side in (1.0, -1.0):
        low, high = side * MM * holder.bore / 2.0, side * MM * holder.outer / 2.0
        start, end = MM * holder.start, MM * holder.end
        corners = (axis.at(start, low), axis.at(end, low), axis.at(end, high), axis.at(start, high))
        entities += [Hatch(corners, lean, _FINE), Path(corners, Layer.OUTLINE, closed=True)]
    return entities


def holder_anchor(axis: Axis, holder: Holder) -> complex:
    """Return where the item number of a part points.

    Args:
        axis: Of its shaft.
        holder: The part.
    """
    return axis.at(MM * (holder.start + holder.end) / 2.0, MM * (holder.bore + 3.0 * holder.outer) / 8.0)
