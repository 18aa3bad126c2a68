"""Undercuts of DIN 509, form F, at the shoulders that bearings lean on: where they are, if a design asks for them.

Seat and shoulder of a bearing are both ground, which form F is for; the bearing's chamfer lies over it.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

from gearwright.catalogue import Undercut, undercut
from gearwright.sizing.mounted import BuiltShaft
from gearwright.sizing.result import Sizing
from gearwright.spec.design import ShaftRules

BLUNTEST = 0.98
"""Thinner over thicker diameter above which a step is no notch [-] (DIN 743-2:2012)."""


class Cut(NamedTuple):
    """An undercut in a shaft."""

    place: float
    """Of the shoulder, from the shaft's first end [m]."""
    edge: float
    """Where it begins in the seat [m]."""
    bottom: float
    """Diameter that is left [m]."""
    standard: Undercut


def foot_of(thin: float, thick: float, rules: ShaftRules) -> Undercut | None:
    """Return the undercut between the seat of a bearing and the next step; None where there is none.

    Args:
        thin: Diameter of the seat [m].
        thick: Of the step [m].
        rules: Of the design.
    """
    asked = rules.shoulders == "undercut" and thin < BLUNTEST * thick
    return undercut(thin) if asked else None


def undercuts_of(sizing: Sizing, shaft: BuiltShaft) -> Iterator[Cut]:
    """Yield the undercuts of a built shaft.

    Args:
        sizing: As sized.
        shaft: One of its built shafts.
    """
    seats = {bearing.name for bearing in sizing.bearings}
    for left, right in pairwise(shaft.steps):
        thin, thick, way = (left, right, -1.0) if left.diameter < right.diameter else (right, left, 1.0)
        cut = foot_of(thin.diameter, thick.diameter, sizing.design.shafting) if thin.seat in seats else None
        if cut is not None:
            edge, bottom = right.start + way * cut.width, thin.diameter - 2.0 * cut.depth
            yield Cut(right.start, edge, bottom, cut)
