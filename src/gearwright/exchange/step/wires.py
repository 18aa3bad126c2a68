"""Outlines of teeth as wires: arcs where they follow circles about the axis, elsewhere splines through points."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats
from gearwright.exchange.step.kernel import occ
from gearwright.shape.solids import Section

MM = 1e3
"""Millimetres, the unit of the files, in a metre [-]."""
SAME = 1e-9
"""Below which two places are one [m]."""
BETWEEN = 3
"""Parts into which a line on a cylinder is divided, so that its spline stays on it [-]."""


class Piece(NamedTuple):
    """A part of an outline between two corners."""

    points: tuple[int, ...]
    """Of the outline, in order."""
    is_arc: bool
    """Whether it is an arc about the axis."""


def pieces_of(section: Section, edges: Bools) -> tuple[Piece, ...]:
    """Return an outline in pieces, which all sections of one toothed wall share.

    Args:
        section: The first one.
        edges: Where the outline has corners.
    """
    return tuple(_pieces(section, edges))


def _pieces(section: Section, edges: Bools) -> Iterator[Piece]:
    count = len(section.radius)
    level = [np.abs(values - np.roll(values, -1)) < SAME for values in (section.radius, section.height)]
    arc = level[0] & level[1]
    parted = edges | arc | np.roll(arc, 1)
    start = int(np.argmax(parted))
    run = [start]
    for here, there in pairwise((start + k) % count for k in range(count + 1)):
        if arc[here]:
            yield Piece((here, there), is_arc=True)
            run = [there]
            continue
        run.append(there)
        if parted[there] or there == start:
            yield Piece(tuple(run), is_arc=False)
            run = [there]


def wire_of(section: Section, pieces: Sequence[Piece]) -> Any:
    """Return an outline as a closed wire [mm].

    Args:
        section: The outline.
        pieces: As its wall is divided.
    """
    wire = occ.BRepBuilderAPI_MakeWire()
    for piece in pieces:
        wire.Add(_edge(section, piece))
    return wire.Wire()


def _edge(section: Section, piece: Piece) -> Any:
    points = list(piece.points)
    radius, height, angle = section.radius[points], section.height[points], np.unwrap(section.angle[points])
    if piece.is_arc:
        places = [_place(radius[0], height[0], turn) for turn in (angle[0], angle.mean(), angle[1])]
        return occ.BRepBuilderAPI_MakeEdge(occ.GC_MakeArcOfCircle(*places).Value()).Edge()
    if np.ptp(radius) < SAME:
        radius, height, angle = (_divided(values) for values in (radius, height, angle))
    through = occ.HArray1_gp_Pnt(1, len(radius))
    for k, values in enumerate(zip(radius, height, angle, strict=True)):
        through.SetValue(k + 1, _place(*values))
    spline = occ.GeomAPI_Interpolate(through, False, SAME * MM)
    spline.Perform()
    return occ.BRepBuilderAPI_MakeEdge(spline.Curve()).Edge()


def _divided(values: Floats) -> Floats:
    whole = np.arange(len(values))
    return np.interp(np.linspace(0, len(values) - 1, BETWEEN * (len(values) - 1) + 1), whole, values)


def _place(radius: float, height: float, angle: float) -> Any:
    return occ.gp_Pnt(MM * float(radius) * math.cos(angle), MM * float(radius) * math.sin(angle), MM * float(height))
