"""Wishes of where shafts stand that contradict each other, and keep-outs without a body."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gearwright.errors import Problem
from gearwright.spec.design import SIDE_ANGLES, Design

_THIN = 1e-6
"""Edges and axes of a keep-out that are shorter are none [m]."""


def place_problems(design: Design) -> Iterator[Problem]:
    """Yield angles that point away from their sides, and keep-outs that enclose nothing or say no reason.

    Args:
        design: As typed.
    """
    for name, layout in design.layout.items():
        if layout.side is None or layout.angle is None:
            continue
        off = layout.angle - SIDE_ANGLES[layout.side]
        if math.cos(off) <= 0.0:
            message = (
                f"{layout.side!r} contradicts angle_deg = {math.degrees(layout.angle):g}; leave one of them out, or"
                f" give an angle within 90° of {math.degrees(SIDE_ANGLES[layout.side]):g}"
            )
            yield Problem(f"layout.{name}.side", message)
    for name, keep in design.keep_out.items():
        edges = [abs(end - start) for start, end in ((getattr(keep.start, k), getattr(keep.end, k)) for k in "xyz")]
        if keep.radius is None and min(edges) < _THIN:
            thin = ", ".join(k for k, edge in zip("xyz", edges, strict=True) if edge < _THIN)
            message = f"the box is flat: start and end are equal in {thin}; give it a thickness, or a radius_mm"
            yield Problem(f"keep_out.{name}.end", message)
        if keep.radius is not None and math.hypot(*edges) < _THIN:
            message = "start and end of the cylinder's axis are one place; give it a length"
            yield Problem(f"keep_out.{name}.end", message)
        if not keep.reason.strip():
            yield Problem(f"keep_out.{name}.reason", "is empty; write what is there")
