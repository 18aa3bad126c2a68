"""Dimensions that cylindrical and bevel gears have in common: thickness of a web, run-out of a face."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gearwright.catalogue import LARGEST, SMALLEST, standard_tolerance
from gearwright.render.drawings.sheet.dimensions import arrow
from gearwright.render.drawings.sheet.entities import Distance, Entity, Layer, Path
from gearwright.render.drawings.sheet.tolerances import Tolerance, tolerance_frame
from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.render.drawings.views.shaft_view import Axis

LEAN = math.pi / 4.0
"""Of the hatching [rad]."""
FACE_GRADE = 5
"""Of the run-out of a gear's faces; assumed."""
LEAST_BETWEEN = 8.0
"""Room on paper below which the thickness of a web stands in the notes alone [mm]."""


def thickness(axis: Axis, web: tuple[float, float], radii: tuple[float, float]) -> Iterator[Distance]:
    """Yield the thickness of a web where the sheet has room between rim and hub.

    Args:
        axis: On paper.
        web: Where it begins and ends along the axis [mm].
        radii: Of hub and rim [mm].
    """
    if axis.scale * (radii[1] - radii[0]) > LEAST_BETWEEN:
        low, high = (axis.at(x, sum(radii) / 2.0) for x in web)
        yield Distance(low, high, low, 0.0, axis.scale)


def face_runout(root: float) -> Tolerance | None:
    """Return what the face of a gear may run out against its bore; None beyond the sizes of ISO 286-1.

    Args:
        root: Root radius, where it is measured [mm].
    """
    if not SMALLEST < 2.0 * root / MM <= LARGEST:
        return None
    return Tolerance("run-out", MM * standard_tolerance(2.0 * root / MM, FACE_GRADE), "A")


def runout_beside(face: complex, start: float, root: float) -> Iterator[Entity]:
    """Yield what a face that looks to the right may run out against the bore; nothing beyond the sizes of ISO 286-1.

    Args:
        face: Where the arrow meets it [mm of paper].
        start: Where the frame begins, on paper from left to right [mm].
        root: Radius at which it is measured [mm].
    """
    tolerance = face_runout(root)
    if tolerance is not None:
        left = complex(start, face.imag)
        yield from (Path((face, left), Layer.SYMBOL), arrow(face, -1 + 0j, Layer.SYMBOL))
        yield from tolerance_frame(left, tolerance)
