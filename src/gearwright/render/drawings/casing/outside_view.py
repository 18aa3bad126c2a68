"""Ribs and mounts of a housing on drawings: ribs beside a section, not cut (ISO 128); both seen along the shaft."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.render.drawings.casing.section_path import Lane
from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.shape import CHAMBER, MOUNT, RIB, Node, Scene
from gearwright.shape.solids import Chamber, Solid, around, spans_in
from gearwright.sizing.casing import HEAD, LENGTH, THICKNESS, WASHER

NEAR = 0.9
"""Cosine of the angle at most between a rib and the plane that is taken as if it met it [-]."""
ROUNDED = 9
"""Digits of metres at which places that are equal are equal on every processor [-]."""
CORNERS = 48
"""Of the hole of a mount as it is drawn [-]."""


class Standing(NamedTuple):
    """A rib or a mount where it stands."""

    span: tuple[float, float]
    """Along the first shaft [m]."""
    base: Floats
    """Where the middle of its foot is across the first shaft [m], shape (2,)."""
    out: Floats
    """Which way it stands off [-], shape (2,)."""
    rise: float
    """How far [m]."""
    loop: Floats
    """Its outline across the first shaft, counter-clockwise [m], shape (n, 2)."""
    cover: Floats
    """A convex one, which it hides what is behind it with [m], shape (m, 2)."""
    hole: tuple[Floats, float] | None = None
    """Middle and radius of the hole of a mount [m]."""


def ribs_of(scene: Scene) -> list[Standing]:
    """Return the ribs of a housing.

    Args:
        scene: With the housing.
    """
    found = []
    for node, solid in _named(scene, RIB):
        points = np.concatenate([section.points for section in solid.sections])
        sizes = np.ptp(points, axis=0)
        k = 2 if abs(node.axes.turned[0, 0]) > 0.5 else 0  # of one on a plate, x looks along the first shaft
        out, rise = node.axes.turned[1:, k], float(sizes[k])
        middle, length = node.axes.origin, float(sizes[2 - k])
        side, base = sizes[1] / 2.0 * np.array([-out[1], out[0]]), middle[1:] - rise / 2.0 * out
        loop = np.array([base - side, base + rise * out - side, base + rise * out + side, base + side])
        span = (float(middle[0]) - length / 2.0, float(middle[0]) + length / 2.0)
        found.append(Standing(span, base, out, rise, loop, loop))
    return found


def mounts_of(scene: Scene) -> list[Standing]:
    """Return the mounts of a housing.

    Args:
        scene: With the housing.
    """
    found = []
    for node, solid in _named(scene, MOUNT):
        flat, turned, middle = solid.sections[0].points[:, :2], node.axes.turned[1:, :2], node.axes.origin
        loop, out = flat @ turned.T + middle[1:], turned[:, 0]
        low, high = float(flat[:, 0].min()), float(flat[:, 0].max())
        foot = flat[:, 1] > flat[:, 1].max() - 1e-9
        straight = np.arange(len(flat)) <= int(np.flatnonzero(foot)[-1])
        half = float(solid.sections[1].height[0])
        span = (float(middle[0]) - half, float(middle[0]) + half)
        hole = (middle[1:], float(solid.profile[0][1]))
        found.append(Standing(span, middle[1:] + low * out, out, high - low, loop, loop[straight], hole))
    return found


def _named(scene: Scene, word: str) -> Iterator[tuple[Node, Solid]]:
    for node in scene.nodes:
        solid = scene.solids.get(node.surface)
        if f"housing, {word} " in node.name and isinstance(solid, Solid):
            yield node, solid


def round_loop(hole: tuple[Floats, float]) -> Floats:
    """Return the edge of a hole across the first shaft [m], shape (n, 2).

    Args:
        hole: Its middle and radius [m].
    """
    return np.asarray(around(hole[1], 0.0, CORNERS)[:, :2] + hole[0])


def rib_outlines(
    scene: Scene, ways: Sequence[Lane], screws: Sequence[tuple[complex, complex]] = (), thread: float = 0.0
) -> tuple[tuple[complex, ...], ...]:
    """Return the outlines of ribs above and below a section, as if it met one of each row [mm].

    Args:
        scene: With the housing.
        ways: Where the section runs, from the first end to the last.
        screws: Centre lines of the screws that are drawn there, behind which ribs are not seen [mm].
        thread: Their diameter [mm].
    """
    walls = [(node, solid) for node in scene.nodes
             if isinstance(solid := scene.solids.get(node.surface), Chamber) and CHAMBER in node.name]  # fmt: skip
    nearest: dict[tuple[float, ...], tuple[float, tuple[complex, ...]]] = {}
    for rib in ribs_of(scene):
        at = sum(rib.span) / 2.0
        lane = next(lane for lane in ways if at <= lane.end)
        wall = next((solid for node, solid in walls if _is_in(node, solid, at)), None)
        spans = [] if wall is None else spans_in(wall.outer, lane.legs)
        if not spans:
            continue
        for way, leg, level in ((-1.0, lane.legs[0], spans[0][0]), (1.0, lane.legs[-1], spans[-1][1])):
            point, ahead = leg.foot + level * leg.along, way * leg.along
            if float(rib.out @ ahead) < NEAR:
                continue
            off = rib.base - point
            aside = abs(float(off[0] * ahead[1] - off[1] * ahead[0]))
            ends = (level, level + way * rib.rise)
            corners = tuple(MM * complex(x, y) for x, y in zip((*rib.span, *rib.span[::-1]),
                            (ends[0], ends[0], ends[1], ends[1]), strict=True))  # fmt: skip
            key = (way, *_row(rib))
            found = (aside, corners)
            nearest[key] = min(nearest.get(key, found), found, key=lambda one: round(one[0], ROUNDED))
    taken = [_screw_box((start + end) / 2.0, thread) for start, end in screws]
    return tuple(left for _, corners in _apart(nearest) if (left := _beside(corners, taken)))


def _screw_box(joint: complex, thread: float) -> tuple[float, float, float, float]:
    """Return what a screw takes of a section, from where to where and how high [mm]."""
    before, behind = THICKNESS + WASHER[1] + HEAD[1], LENGTH - WASHER[1] - THICKNESS
    half = WASHER[0] / 2.0 * thread
    return joint.real - before * thread, joint.real + behind * thread, joint.imag - half, joint.imag + half


def _beside(
    corners: tuple[complex, ...], taken: Sequence[tuple[float, float, float, float]]
) -> tuple[complex, ...]:  # fmt: skip
    """Return the outline of a rib without what lies behind screws at its ends; nothing where that is all of it."""
    low, high, bottom, top = _box(corners)
    for box in taken:
        if _meet((low, high, bottom, top), box):
            low, high = (max(low, box[1]), high) if box[0] <= low or box[1] - low < high - box[0] else (low, box[0])
    if high <= low:
        return ()
    return complex(low, bottom), complex(high, bottom), complex(high, top), complex(low, top)


def _row(rib: Standing) -> tuple[float, ...]:
    """Return what ribs side by side around one wall share."""
    return (round(sum(rib.span) / 2.0, 3),)


def _apart(
    nearest: Mapping[tuple[float, ...], tuple[float, tuple[complex, ...]]],
) -> Iterator[tuple[float, tuple[complex, ...]]]:
    """Yield the nearest ribs of which none stands where a nearer one does: those that end short of heads of screws."""
    kept: list[tuple[complex, ...]] = []
    for aside, corners in sorted(nearest.values(), key=lambda found: round(found[0], ROUNDED)):
        boxes = [_box(each) for each in (corners, *kept)]
        if not any(_meet(boxes[0], box) for box in boxes[1:]):
            kept.append(corners)
            yield aside, corners


def _box(corners: Sequence[complex]) -> tuple[float, float, float, float]:
    xs, ys = [corner.real for corner in corners], [corner.imag for corner in corners]
    return min(xs), max(xs), min(ys), max(ys)


def _meet(one: tuple[float, ...], other: tuple[float, ...]) -> bool:
    near = 1e-6
    return (one[0] < other[1] - near and other[0] < one[1] - near
            and one[2] < other[3] - near and other[2] < one[3] - near)  # fmt: skip


def _is_in(node: Node, solid: Chamber, place: float) -> bool:
    at = place - float(node.axes.origin[0])
    return solid.span[0] <= at <= solid.span[1]
