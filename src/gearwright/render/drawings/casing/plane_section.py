"""The housing alone: cut by a plane along the first shaft, and seen from its first end."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Complexes, Floats
from gearwright.ranking import smallest_first
from gearwright.render.drawings.casing.casing_section import CasingSection, joints_of, screw_holes, screw_lines
from gearwright.render.drawings.casing.outside_view import mounts_of, rib_outlines, ribs_of, round_loop
from gearwright.render.drawings.casing.rounded import rounded
from gearwright.render.drawings.casing.section_path import Lane
from gearwright.render.drawings.casing.web_section import web_nodes, webs_across, webs_along
from gearwright.render.drawings.sheet.entities import Arc, Entity, Layer, Path
from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.shape import CHAMBER, FLANGES, MOUNT, RIB, Node, Scene, screw_places
from gearwright.shape.solids import (
    Chamber,
    Fastener,
    Leg,
    Rectangle,
    Solid,
    bored,
    cut_chamber,
    spans_in,
    united,
    without,
)
from gearwright.sizing import Sizing
from gearwright.sizing.casing import Flanges
from gearwright.sizing.mass import weighed_flanges

LINED = 1e-9
"""How far axes may turn from along the plane, or from square to it [-]."""
COVERED = 1e-5
"""By how much what stands before an edge is taken as wider, so that equal edges are drawn once [-]."""
UNCUT = tuple(f"housing, {word} " for word in (RIB, MOUNT))
"""In names of bodies that stand outside of walls, and are not cut."""
SHOWN = 1e-4
"""Edges that are shorter are left out [m]."""


@dataclass(frozen=True)
class Casing:
    """A housing by itself."""

    scene: Scene
    up: Floats
    """What the sheet has upwards, across the first shaft: y and z in space [-], shape (2,)."""
    foot: Floats
    """Where the first shaft stands [m], shape (2,)."""
    section: CasingSection
    """In the plane of the first shaft and of that direction, heights from the first shaft on."""

    @property
    def pieces(self) -> list[tuple[Node, Chamber]]:
        """Its chambers and halves of flanges, from the first end on."""
        return smallest_first(pieces_of(self.scene), lambda piece: span_of(*piece)[0])

    @property
    def chambers(self) -> list[tuple[Node, Chamber]]:
        """Its chambers, from the first end on."""
        return [piece for piece in self.pieces if CHAMBER in piece[0].name]

    @property
    def halves(self) -> list[tuple[Node, Chamber]]:
        """Halves of its flanges, from the first end on."""
        return [piece for piece in self.pieces if FLANGES in piece[0].name]

    @property
    def leg(self) -> Leg:
        """The plane of the section as a way across the first shaft."""
        return Leg(-math.inf, math.inf, self.foot, self.up)

    @property
    def start(self) -> float:
        """Where it begins along the first shaft [m]."""
        return span_of(*self.pieces[0])[0]

    def seen(self, points: Floats) -> Complexes:
        """Return points across the first shaft as the view from the first end has them, x + i y [m], shape (n,).

        Args:
            points: y and z in space [m], shape (n, 2).
        """
        off = np.asarray(points) - self.foot
        return np.asarray(off @ np.array([-self.up[1], self.up[0]]) + 1j * (off @ self.up), dtype=np.complex128)


def pieces_of(scene: Scene) -> list[tuple[Node, Chamber]]:
    """Return the chambers of a housing and the halves of its flanges.

    Args:
        scene: With the housing.
    """
    nodes = [(node, scene.solids[node.surface]) for node in scene.nodes if node.look == "housing"]
    return [(node, solid) for node, solid in nodes if isinstance(solid, Chamber)]


def span_of(node: Node, solid: Chamber) -> tuple[float, float]:
    """Return from where to where along the first shaft a chamber or half of a flange is [m].

    Args:
        node: The piece.
        solid: Its solid.
    """
    at = float(node.axes.origin[0])
    return at + solid.span[0], at + solid.span[1]


def casing_of(sizing: Sizing, scene: Scene) -> Casing | None:
    """Return the housing by itself; None where there is none, or no plane along the first shaft cuts it squarely.

    The plane goes through as many axes as can be.

    Args:
        sizing: What was sized.
        scene: Its solids.
    """
    if not sizing.design.housing.own:
        return None
    frames = list(sizing.arrangement.frames.values())
    foot, ways = np.array(frames[0].origin[1:]), [np.array([1.0, 0.0]), np.array([0.0, 1.0])]
    for frame in frames:
        off = np.array(frame.origin[1:]) - foot
        if float(np.linalg.norm(off)) > SHOWN and abs(frame.along.x) > 1.0 - LINED:
            ways.append(off / np.linalg.norm(off))
    held = [sum(abs(float((np.array(frame.origin[1:]) - foot) @ [-way[1], way[0]])) < SHOWN for frame in frames)
            for way in ways]  # fmt: skip
    flanges = weighed_flanges(sizing)
    for k in sorted(range(len(ways)), key=lambda k: -held[k]):
        section = _section(scene, flanges, foot, ways[k])
        if section is not None:
            return Casing(scene, ways[k], foot, section)
    return None


def _section(scene: Scene, flanges: Flanges, foot: Floats, up: Floats) -> CasingSection | None:
    leg = Leg(-math.inf, math.inf, foot, up)
    rectangles: list[Rectangle] = []
    webs = {node.name for node in web_nodes(scene)}
    for node in (node for node in scene.nodes if node.look == "housing" and node.name not in webs):
        solid, at = scene.solids[node.surface], float(node.axes.origin[0])
        if isinstance(solid, Fastener) or any(word in node.name for word in UNCUT):
            continue
        found = cut_chamber(solid, [leg]) if isinstance(solid, Chamber) else _cut_boss(node, solid, foot, up)
        if found is None:
            return None
        moved = at if isinstance(solid, Chamber) else 0.0
        rectangles += [one._replace(start=one.start + moved, end=one.end + moved) for one in found]
    ways = (Lane(-math.inf, math.inf, (leg,)),)
    rectangles += webs_across(scene, ways)
    edges = tuple(webs_along(scene, ways, rectangles))
    screws = tuple(screw_lines(scene, ways))
    holes = screw_holes(screws, flanges)
    cuts = tuple(united(bored(rectangles, holes), joints_of(scene)))
    ribs = rib_outlines(scene, ways)
    return CasingSection(cuts, (), flat=True, leaning=(), webs=edges, screws=screws, holes=holes, ribs=ribs)


def _cut_boss(node: Node, solid: Solid, foot: Floats, up: Floats) -> list[Rectangle] | None:
    """Return what a plane along the first shaft cuts of a boss; None where it cuts it neither along nor beside it."""
    along, origin, half = node.axes.along, node.axes.origin, max(z for z, _ in solid.profile)
    inner, outer = (pick(radius for _, radius in solid.profile) for pick in (min, max))
    out = np.array([0.0, -up[1], up[0]])
    off = float((origin[1:] - foot) @ out[1:])
    height = float((origin[1:] - foot) @ up)
    if abs(float(along @ out)) > LINED:
        return [] if abs(off) > half * abs(float(along @ out)) + outer else None
    if abs(off) >= outer:
        return []
    far, near = math.sqrt(outer**2 - off**2), math.sqrt(max(inner**2 - off**2, 0.0))
    pieces = ((near, far), (-far, -near)) if near else ((-far, far),)
    if abs(along[0]) > 1.0 - LINED:
        return [Rectangle(origin[0] - half, origin[0] + half, height + low, height + high) for low, high in pieces]
    if abs(along[0]) < LINED:
        return [Rectangle(origin[0] + low, origin[0] + high, height - half, height + half) for low, high in pieces]
    return None


def holes_behind(casing: Casing, scale: float) -> Iterator[Entity]:
    """Yield the edges of holes in plates that are seen beyond the section.

    Args:
        casing: The housing.
        scale: mm of paper per mm [-].
    """
    leg, paper = casing.leg, scale * MM
    for node, solid in casing.chambers:
        for place, way, end in zip(span_of(node, solid), (1.0, -1.0), solid.ends, strict=True):
            for low, high in (span for hole in (end.holes if end else ()) for span in spans_in(hole, [leg])):
                for x in (place, place + way * (end.thickness if end else 0.0)):
                    yield Path((paper * complex(x, low), paper * complex(x, high)), Layer.OUTLINE)


def uncut(casing: Casing, scale: float) -> Iterator[Entity]:
    """Yield the outlines of chambers that the plane does not meet, dashed.

    Args:
        casing: The housing.
        scale: mm of paper per mm [-].
    """
    for node, solid in casing.chambers:
        if not spans_in(solid.outer, [casing.leg]):
            (start, end), heights = span_of(node, solid), casing.seen(solid.outer).imag
            low, high = float(heights.min()), float(heights.max())
            corners = (complex(start, low), complex(end, low), complex(end, high), complex(start, high))
            yield Path(tuple(scale * MM * corner for corner in corners), Layer.HIDDEN, closed=True)


def end_outlines(casing: Casing, scale: float) -> Iterator[Path]:
    """Yield what is seen of chambers, flanges and holes from the first end; what others before them hide is left out.

    Args:
        casing: The housing.
        scale: mm of paper per mm [-].
    """
    faces = [*(_face(node, solid, 0) for node, solid in casing.pieces), *_standing(casing.scene)]
    yield from _not_hidden(faces, lambda points: np.asarray(scale * MM * casing.seen(points), dtype=np.complex128))


def seen_from_second_end(scene: Scene) -> tuple[tuple[Path, ...], tuple[Floats, ...]]:
    """Return what is seen of a housing along the first shaft from its second end, and loops that fill what it covers.

    Ribs and mounts are left to the sheet of the housing.

    Args:
        scene: Solids with those of a housing.

    Returns:
        Lines [mm], and outlines of its pieces across the first shaft [m]; y in space to the right, z upwards.
    """
    faces = [_face(node, solid, 1) for node, solid in pieces_of(scene)]
    lines = _not_hidden(faces, lambda points: np.asarray(MM * (points[:, 0] + 1j * points[:, 1]), dtype=np.complex128))
    return tuple(lines), tuple(face.cover for face in faces)


class _Face(NamedTuple):
    """What a piece shows of itself along the first shaft."""

    at: float
    """Where it begins for who looks [m]."""
    outer: Floats
    cover: Floats
    """A convex outline, with which it hides what is behind [m]."""
    holes: tuple[Floats, ...]
    is_ring: bool = False
    """Whether one looks through its one hole at what is behind; through those of plates, too little is seen."""


def _face(node: Node, solid: Chamber, side: int) -> _Face:
    end, at = solid.ends[side], (-1.0 if side else 1.0) * span_of(node, solid)[side]
    if FLANGES in node.name:
        return _Face(at, solid.outer, solid.outer, (solid.inner,), is_ring=True)
    return _Face(at, solid.outer, solid.outer, end.holes if end else ())


def _standing(scene: Scene) -> Iterator[_Face]:
    """Yield what ribs and mounts show towards the first end."""
    for one in (*ribs_of(scene), *mounts_of(scene)):
        yield _Face(one.span[0], one.loop, one.cover, (round_loop(one.hole),) if one.hole else ())


def _not_hidden(faces: Iterable[_Face], seen: Callable[[Floats], Complexes]) -> Iterator[Path]:
    """Yield the edges of faces with holes, one behind the other, past those before."""
    before: list[tuple[Floats, ...]] = []
    for face in smallest_first(faces, lambda face: face.at):
        for loop in (face.outer, *face.holes):
            yield from _edges(seen, loop, before)
        through = tuple(hole - COVERED * (hole - hole.mean(axis=0)) for hole in face.holes if face.is_ring)
        before.append((face.cover + COVERED * (face.cover - face.cover.mean(axis=0)), *through))


def _edges(seen: Callable[[Floats], Complexes], loop: Floats, before: Sequence[tuple[Floats, ...]]) -> Iterator[Path]:
    """Yield what is seen of a loop past what stands before it, in lines as long as can be."""
    run: list[complex] = []
    lows, highs = (np.array([pick(outer, axis=0) for outer, *_ in before]).reshape(-1, 2) for pick in (np.min, np.max))
    for here, there in pairwise(np.concatenate([loop, loop[:1]])):
        length = float(np.linalg.norm(there - here))
        if length < 1e-9:
            continue
        leg = Leg(0.0, length, here, (there - here) / length)
        left = [(0.0, length)]
        near = np.all((lows < np.maximum(here, there)) & (highs > np.minimum(here, there)), axis=1)
        for outer, *through in (before[k] for k in np.flatnonzero(near).tolist()):
            hidden = spans_in(outer, [leg])
            for hole in through:
                hidden = without(hidden, spans_in(hole, [leg]))
            left = without(left, hidden)
        for low, high in left:
            ends = [complex(point) for point in seen(np.array([here + at * leg.along for at in (low, high)]))]
            if run and abs(run[-1] - ends[0]) < 1e-6:
                run.append(ends[1])
                continue
            if len(run) > 1:
                yield Path(rounded(run), Layer.OUTLINE)
            run = ends
    if len(run) > 1:
        yield Path(rounded(run), Layer.OUTLINE)


def screw_circles(casing: Casing, number: int, hole: float, scale: float) -> list[Arc]:
    """Return the holes of the first flange, seen from the first end.

    Args:
        casing: The housing.
        number: Of screws.
        hole: Radius [m].
        scale: mm of paper per mm [-].
    """
    places = casing.seen(screw_places(casing.halves[0][1], number))
    return [Arc(complex(at) * scale * MM, hole * scale * MM, Layer.THIN) for at in places]
