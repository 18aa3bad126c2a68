"""The outline of a shaft, seen from the side, with what is cut into it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

from gearwright.catalogue import thread_chamfer
from gearwright.render.drawings.sheet.entities import Arc, Entity, Hatch, Layer, Path
from gearwright.render.drawings.views.shaft_parts import CHAMFERS, MM, Piece, ShaftBody, Slot, Toothing
from gearwright.render.drawings.views.undercut_view import relief_profile, undercut_profile
from gearwright.sizing.shafts import Cut

OVERSHOOT = 3.0
"""How far a centre line goes beyond what it belongs to [mm]."""
NEAR = 1e-6
"""Places that are nearer to each other are one [mm]."""
_TURN = tuple(2.0 * math.pi * k / 96 for k in range(97))


class Axis(NamedTuple):
    """Where the axis of a part lies on the sheet."""

    origin: complex
    """Of its first end [mm of paper]."""
    along: complex
    """Direction to its second end, of length 1 [-]."""
    scale: float
    """mm of paper per mm [-]."""

    def at(self, x: float, radius: float = 0.0) -> complex:
        """Return a point of the part on the sheet [mm of paper].

        Args:
            x: Along the axis [mm].
            radius: To the left of the axis [mm].
        """
        return self.on(complex(x, radius))

    def on(self, point: complex) -> complex:
        """Return a point of the part on the sheet [mm of paper].

        Args:
            point: Along the axis, and to the left of it [mm].
        """
        return self.origin + self.scale * self.along * point


def shaft_outline(axis: Axis, body: ShaftBody) -> list[Entity]:
    """Return a shaft seen from the side, with its centre line.

    Args:
        axis: Where it lies.
        body: What it is.
    """
    start, end = body.pieces[0].start, body.pieces[-1].end
    beyond = OVERSHOOT / axis.scale
    entities: list[Entity] = [Path((axis.at(start - beyond), axis.at(end + beyond)), Layer.CENTRE)]
    upper = _profile(body)
    corners = [*upper, *((x, -r) for x, r in reversed(upper))]
    entities.append(Path(tuple(axis.at(x, r) for x, r in corners), Layer.OUTLINE, closed=True))
    entities += _edges(axis, body)
    for piece in body.pieces:
        entities += _pitch_lines(axis, piece)
    if body.bore:
        entities += [
            Path((axis.at(start, side * body.bore / 2.0), axis.at(end, side * body.bore / 2.0)), Layer.HIDDEN)
            for side in (-1.0, 1.0)
        ]
    for slot in body.slots:
        entities += _slot(axis, slot)
    for toothing in body.splines:
        entities += _spline(axis, toothing)
    return entities


def end_chamfer(piece: Piece) -> float:
    """Return the chamfer of a shaft's end [mm]; none on teeth, of a thread down to its core.

    Args:
        piece: First or last of the shaft.
    """
    if piece.toothed:
        return 0.0
    if piece.thread is not None:
        return MM * thread_chamfer(piece.thread.nut.pitch)
    return next(chamfer for up_to, chamfer in CHAMFERS if piece.diameter <= up_to)


def _profile(body: ShaftBody) -> list[tuple[float, float]]:
    """Return the upper outline from the first end to the second: along the axis, radius [mm]."""
    first, last = body.pieces[0], body.pieces[-1]
    points: list[tuple[float, float]] = []
    fillets = {round(x, 6): radius for x, radius in body.fillets}
    for before, piece in zip((None, *body.pieces), body.pieces, strict=False):
        start = [(piece.start, piece.diameters[0] / 2.0)]
        if before is not None and not (before.conical or piece.conical):
            cut = next((cut for cut in body.undercuts if abs(MM * cut.place - piece.start) < NEAR), None)
            foot = _fillet(before, piece, fillets.get(round(piece.start, 6), 0.0)) if cut is None else _undercut(cut)
            if foot and before.diameters[1] < piece.diameters[0]:
                points[-1:] = foot
            elif foot:
                start = foot
        if piece.relieved and piece.thread is not None and piece.thread.undercut is not None:
            top = MM * piece.thread.nut.thread / 2.0
            points += [(piece.start + x, top + above) for x, above in relief_profile(piece.thread.undercut)]
            continue
        end = [(piece.end, piece.diameters[1] / 2.0)]
        chamfer = end_chamfer(piece) if piece.thread is not None and not piece.relieved else 0.0
        if chamfer and piece.thread is not None and piece.thread.way < 0 and piece is not first:
            start = [(piece.start, start[0][1] - chamfer), (piece.start + chamfer, start[0][1])]
        elif chamfer and piece.thread is not None and piece.thread.way > 0 and piece is not last:
            end = [(piece.end - chamfer, end[0][1]), (piece.end, end[0][1] - chamfer)]
        points += [*start, *end]
    first_chamfer, last_chamfer = end_chamfer(first), end_chamfer(last)
    if first_chamfer:
        points[:1] = [(first.start, points[0][1] - first_chamfer), (first.start + first_chamfer, points[0][1])]
    if last_chamfer:
        points[-1:] = [(last.end - last_chamfer, points[-1][1]), (last.end, points[-1][1] - last_chamfer)]
    return points


def _undercut(cut: Cut) -> list[tuple[float, float]]:
    """Return the points of an undercut, from left to right."""
    way, radius = math.copysign(1.0, cut.edge - cut.place), MM * (cut.bottom / 2.0 + cut.standard.depth)
    points = [(MM * cut.place + way * along, radius + above) for along, above in undercut_profile(cut.standard)]
    return points if way < 0.0 else points[::-1]


def _fillet(left: Piece, right: Piece, radius: float) -> list[tuple[float, float]]:
    """Return the points of a fillet between two pieces, from left to right; none without one."""
    thin, thick = sorted((left.diameters[1] / 2.0, right.diameters[0] / 2.0))
    if not radius or thick <= thin:
        return []
    turn = math.acos(max(0.0, 1.0 - (thick - thin) / radius))
    reach = radius * math.sin(turn)
    arc = [
        (reach - radius * math.sin(turn * k / 8.0), thin + radius * (1.0 - math.cos(turn * k / 8.0))) for k in range(9)
    ]
    if left.diameters[1] < right.diameters[0]:
        return [(right.start - x, r) for x, r in arc]
    return [(right.start + x, r) for x, r in arc[::-1]]


def _edges(axis: Axis, body: ShaftBody) -> Iterator[Entity]:
    """Yield the round edges that are seen as lines across: of shoulders and chamfers."""
    for left, right in pairwise(body.pieces):
        radius = max(left.diameters[1], right.diameters[0]) / 2.0
        # Where only a seat ends, its limit is a thin line (ISO 129-1).
        layer = Layer.THIN if left.diameters[1] == right.diameters[0] else Layer.OUTLINE
        yield Path((axis.at(left.end, radius), axis.at(left.end, -radius)), layer)
    chamfered = [(body.pieces[0], body.pieces[0].start, 1.0), (body.pieces[-1], body.pieces[-1].end, -1.0)]
    for piece in body.pieces[1:-1]:
        if piece.thread is not None and not piece.relieved:
            outwards = piece.thread.way > 0
            chamfered.append((piece, piece.end if outwards else piece.start, -1.0 if outwards else 1.0))
    for piece, x, sense in chamfered:
        chamfer, radius = end_chamfer(piece), piece.diameters[0 if sense > 0.0 else 1] / 2.0
        if chamfer:
            at = x + sense * chamfer
            yield Path((axis.at(at, radius), axis.at(at, -radius)), Layer.OUTLINE)


def _pitch_lines(axis: Axis, piece: Piece) -> Iterator[Entity]:
    if piece.pitch is not None:
        start, end = (pitch / 2.0 for pitch in piece.pitch)
        slope = (end - start) / (piece.end - piece.start)
        more = 2.0 / axis.scale
        for side in (-1.0, 1.0):
            yield Path(
                (
                    axis.at(piece.start - more, side * (start - slope * more)),
                    axis.at(piece.end + more, side * (end + slope * more)),
                ),
                Layer.PITCH,
            )


def _slot(axis: Axis, slot: Slot) -> Iterator[Entity]:
    """Yield a keyway seen from above."""
    half = MM * slot.section.width / 2.0
    if slot.form == "B":
        corners = ((slot.start, -half), (slot.end, -half), (slot.end, half), (slot.start, half))
        yield Path(tuple(axis.at(*corner) for corner in corners), Layer.OUTLINE, closed=True)
        return
    for side in (-1.0, 1.0):
        ends = (axis.at(slot.start + half, side * half), axis.at(slot.end - half, side * half))
        yield Path(ends, Layer.OUTLINE)
    turn = math.atan2(axis.along.imag, axis.along.real)
    for x, facing in ((slot.start + half, math.pi), (slot.end - half, 0.0)):
        middle = turn + facing
        yield Arc(axis.at(x), half * axis.scale, Layer.OUTLINE, middle - math.pi / 2.0, middle + math.pi / 2.0)


def _spline(axis: Axis, toothing: Toothing) -> Iterator[Entity]:
    """Yield root lines of splines, thin, and the pitch line (ISO 6413)."""
    for layer, diameter in ((Layer.THIN, toothing.teeth.shaft_root), (Layer.PITCH, toothing.teeth.pitch_diameter)):
        for side in (-1.0, 1.0):
            radius = side * MM * diameter / 2.0
            yield Path((axis.at(toothing.start, radius), axis.at(toothing.end, radius)), layer)
    for x in (toothing.start, toothing.end):
        radius = MM * toothing.teeth.shaft_tip / 2.0
        yield Path((axis.at(x, radius), axis.at(x, -radius)), Layer.OUTLINE)


def keyed_rim(axis: Axis, radius: float, half: float) -> list[complex]:
    """Return the rim of a shaft or bore about the origin of an axis, open where a keyway on top cuts it [mm of paper].

    Args:
        axis: Its origin is the middle.
        radius: Of the rim [mm].
        half: Half the width of the keyway [mm].
    """
    start = math.asin(half / radius)
    around = [start + (2.0 * math.pi - 2.0 * start) * k / 96 for k in range(97)]
    return [axis.at(radius * math.sin(angle), radius * math.cos(angle)) for angle in around]


def key_section(axis: Axis, slot: Slot, bore: float = 0.0) -> list[Entity]:
    """Return the section of a shaft through a keyway, looking along its axis; the keyway is on top.

    Args:
        axis: Its origin is the middle.
        slot: The keyway.
        bore: Of the shaft [mm].
    """
    radius, half = slot.diameter / 2.0, MM * slot.section.width / 2.0
    floor = radius - MM * slot.section.shaft_depth
    rim = keyed_rim(axis, radius, half)
    outline = (*rim, axis.at(-half, floor), axis.at(half, floor))
    reach = radius + OVERSHOOT / axis.scale
    inner = [axis.at(bore / 2.0 * math.sin(-angle), bore / 2.0 * math.cos(angle)) for angle in _TURN] if bore else []
    entities: list[Entity] = [
        Hatch((*rim, *((rim[-1], *inner, rim[-1]) if inner else ()), *outline[97:])),
        Path(outline, Layer.OUTLINE, closed=True),
        Path((axis.at(-reach), axis.at(reach)), Layer.CENTRE),
        Path((axis.at(0.0, -reach), axis.at(0.0, reach)), Layer.CENTRE),
    ]
    if bore:
        entities.append(Arc(axis.at(0.0), bore / 2.0 * axis.scale, Layer.OUTLINE))
    return entities
