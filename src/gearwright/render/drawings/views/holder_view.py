"""Parts that hold bearings in section: rings, nuts, end plates, spacers, covers and the radial seals in them."""

from __future__ import annotations

import math

from gearwright.render.drawings.sheet.entities import Arc, Entity, Hatch, Layer, Path
from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.render.drawings.views.shaft_view import Axis
from gearwright.sizing.shafts import Holder

_FINE = 1.0
"""Between hatching lines [mm]."""
LEANS = {"spacer": 60.0, "housing spacer": 120.0, "cover": 30.0, "radial seal": 75.0}
"""Kind -> lean of its hatching [°]: unlike that of the rings beside it; of all else 150."""
SEAL = (
    (0.0, 1.0), (1.0, 1.0), (1.0, 0.76), (0.32, 0.76), (0.32, 0.58), (0.5, 0.46), (0.86, 0.44), (0.86, 0.2),
    (0.62, 0.0), (0.3, 0.26), (0.0, 0.34),
)  # fmt: skip
"""Corners of a seal's section: along from its air side over its width, up from the shaft over its height [-]."""
SPRING, SPRING_RADIUS = (0.68, 0.34), 0.1
"""Middle and radius of its spring, likewise."""


def holder_section(axis: Axis, holder: Holder) -> list[Entity]:
    """Return a part in section, both halves.

    Args:
        axis: Of its shaft.
        holder: The part.
    """
    lean = math.radians(LEANS.get(holder.kind, 150.0))
    outside = [point for ring in holder.rings for point in ((ring.start, ring.outer), (ring.end, ring.outer))]
    inside = [point for ring in holder.rings for point in ((ring.start, ring.bore), (ring.end, ring.bore))]
    around = [complex(MM * place, MM * diameter / 2.0) for place, diameter in (*outside, *reversed(inside))]
    spring: tuple[complex, float] | None = None
    if holder.lip:
        around, spring = _seal(holder)
    entities: list[Entity] = []
    for side in (1.0, -1.0):
        corners = tuple(axis.at(point.real, side * point.imag) for point in around)
        entities += [Hatch(corners, lean, _FINE), Path(corners, Layer.OUTLINE, closed=True)]
        if spring is not None:
            middle, radius = spring
            entities.append(Arc(axis.at(middle.real, side * middle.imag), radius * axis.scale, Layer.THIN))
    return entities


def _seal(holder: Holder) -> tuple[list[complex], tuple[complex, float]]:
    """Return the section of a radial seal of type A, and middle and radius of its spring [mm]; a form as drawn."""
    width, low, high = MM * (holder.end - holder.start), MM * holder.bore / 2.0, MM * holder.outer / 2.0
    air = MM * (holder.start if holder.lip > 0 else holder.end)

    def at(along: float, up: float) -> complex:
        return complex(air + holder.lip * along * width, low + up * (high - low))

    return [at(*point) for point in SEAL], (at(*SPRING), SPRING_RADIUS * (high - low))


def holder_anchor(axis: Axis, holder: Holder) -> complex:
    """Return where the item number of a part points.

    Args:
        axis: Of its shaft.
        holder: The part.
    """
    if holder.lip:
        width, height = holder.end - holder.start, holder.outer - holder.bore
        air = holder.start if holder.lip > 0 else holder.end
        return axis.at(MM * (air + holder.lip * 0.16 * width), MM * (holder.bore + 0.72 * height) / 2.0)
    ring = max(holder.rings, key=lambda one: (one.outer, one.end - one.start))
    return axis.at(MM * (ring.start + ring.end) / 2.0, MM * (ring.bore + 3.0 * ring.outer) / 8.0)
