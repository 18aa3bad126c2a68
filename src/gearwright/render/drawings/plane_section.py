"""A housing and its gearbox cut by one plane along the first shaft, and seen from the first end."""

import cmath
import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.base import Complexes, Floats, smallest_first
from gearwright.render.drawings.arrangement_view import Item, shaft_parts
from gearwright.render.drawings.casing_section import (
    CasingSection,
    casing_entities,
    casing_items,
    joints_of,
    mounts_of,
    rib_outlines,
    ribs_of,
    round_loop,
    screw_holes,
    screw_lines,
    web_nodes,
    webs_across,
    webs_along,
)
from gearwright.render.drawings.entities import (
    Arc,
    Distance,
    Entity,
    Layer,
    Path,
    Words,
    cutting_plane,
    extent,
    millimetres,
    trimmed,
)
from gearwright.render.drawings.paper import SheetTable, balloons
from gearwright.render.drawings.positions import TRUE, Lane, Lying, Positions
from gearwright.render.drawings.shaft_view import MM
from gearwright.shape import CHAMBER, FLANGES, MOUNT, RIB, Node, Scene, screw_places, short_of
from gearwright.shape.chambers import Chamber, Leg, Rectangle, bored, cut_chamber, depth_in, spans_in, united, without
from gearwright.shape.solids import Fastener, Solid
from gearwright.sizing import Sizing
from gearwright.sizing.casing import Flanges
from gearwright.sizing.mass import weighed_flanges
from gearwright.sizing.places import runs

# ----------------------------------------------------------------------------------------------------------------------
# Round outlines of a housing: where its solid has the sides of a polygon, a drawing has the arcs that they touch.
# ----------------------------------------------------------------------------------------------------------------------


LARGEST = math.radians(8.0)
"""Turn from one side to the next up to which both stand for an arc [rad]: solids have 48 sides around."""
LEAST = 1e-6
"""Turn below which there is no corner [rad]."""
PIECES = 6
"""Straight pieces of the arc of one corner [-]."""


def rounded(points: Sequence[complex]) -> tuple[complex, ...]:
    """Return a line with arcs in place of small corners, each from as far before as behind, half a side at most.

    A regular polygon gives the circle that touches its sides.

    Args:
        points: From corner to corner; closed where the last one is the first [mm].

    >>> square = [cmath.rect(1.0 / math.cos(math.pi / 48.0), math.pi / 24.0 * k) for k in range(49)]
    >>> round(max(map(abs, rounded(square))), 6)
    1.0
    """
    closed = len(points) > 3 and abs(points[0] - points[-1]) < LEAST
    if not closed:
        inner = [piece for before, corner, behind in zip(points, points[1:], points[2:], strict=False)
                 for piece in _corner(before, corner, behind)]  # fmt: skip
        return (points[0], *inner, points[-1])
    ring = [points[-2], *points[:-1], points[0]]
    found = [piece for (before, corner), (_, behind) in pairwise(pairwise(ring))
             for piece in _corner(before, corner, behind)]  # fmt: skip
    return (*found, found[0])


def _corner(before: complex, corner: complex, behind: complex) -> list[complex]:
    """Return what stands for a corner."""
    first, second = corner - before, behind - corner
    turn = cmath.phase(second / first) if first and second else 0.0
    if not LEAST < abs(turn) < LARGEST:
        return [corner]
    far = min(abs(first), abs(second)) / 2.0
    start = corner - far * first / abs(first)
    middle = start + 1j * math.copysign(far / math.tan(abs(turn) / 2.0), turn) * first / abs(first)
    return [middle + (start - middle) * cmath.rect(1.0, turn * k / PIECES) for k in range(PIECES + 1)]


# ----------------------------------------------------------------------------------------------------------------------
# The housing alone: cut by a plane along the first shaft, and seen from its first end.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# A gearbox cut by one plane along its first shaft, beside an unfolded section that cannot hold the housing.
# ----------------------------------------------------------------------------------------------------------------------


LETTER = "B"
"""Of the plane."""
LETTERS, BELOW, BEYOND = 5.0, 8.0, 3.0
"""Height of the section's name, from the parts to a length over all, from the outline to a cutting plane's end [mm]."""


class TrueSection(NamedTuple):
    """What one plane cuts."""

    casing: Casing
    plane: Positions
    """Shafts whose axes lie in it."""


def true_section(sizing: Sizing, scene: Scene, unfolded: Positions) -> TrueSection | None:
    """Return the section by the plane along the first shaft that the housing's own sheet has; None where none cuts it.

    Args:
        sizing: What was sized.
        scene: Its solids.
        unfolded: The plane of the arrangement, with the places of parts on shafts.
    """
    casing = casing_of(sizing, scene)
    if casing is None:
        return None
    out, shafts = np.array([-casing.up[1], casing.up[0]]), {}
    for name, lying in unfolded.shafts.items():
        frame = sizing.arrangement.frames[name]
        off = np.array(frame.origin[1:]) - casing.foot
        if MM * max(abs(float(off @ out)), abs(float(np.array(frame.along[1:]) @ out))) < TRUE:
            origin = MM * complex(frame.origin.x, float(off @ casing.up))
            along = complex(frame.along.x, float(np.array(frame.along[1:]) @ casing.up))
            shafts[name] = Lying(origin, along, lying.start, lying.end)
    return TrueSection(casing, Positions(shafts, unfolded.places))


def true_entities(sizing: Sizing, section: TrueSection, scale: float, first: int) -> list[Entity]:
    """Return the section with its name, its length over all, and numbers of what the arrangement shows here alone.

    Args:
        sizing: What was sized.
        section: What is cut.
        scale: mm of paper per mm [-].
        first: Number of its first item.
    """
    casing, entities = section.casing, list[Entity]()
    for name in section.plane.shafts:
        entities += shaft_parts(sizing, section.plane, name, scale)[0]
    entities += [*casing_entities(casing.section, scale), *holes_behind(casing, scale)]
    box = extent(entities)
    entities += balloons([item.anchor for item in true_items(sizing, section, scale)], box, [], first)
    low = complex(0.0, extent(entities)[1] - BELOW)
    entities.append(Distance(complex(box[0], box[1]), complex(box[2], box[1]), low, 0.0, scale))
    name_at = complex((box[0] + box[2]) / 2.0, extent(entities)[3] + BELOW)
    return [*entities, Words(name_at, f"{LETTER}-{LETTER}", LETTERS, "middle")]


def true_items(sizing: Sizing, section: TrueSection, scale: float) -> list[Item]:
    """Return what the list of parts has of the section alone: the housing and its screws.

    Args:
        sizing: What was sized.
        section: What is cut.
        scale: mm of paper per mm [-].
    """
    return list(casing_items(sizing, section.casing.section, scale))


def cutting_line(section: TrueSection, outside: Sequence[Path], scale: float, *, turned: bool) -> list[Entity]:
    """Return both ends of the cutting plane in the view along the first shaft from its second end.

    Args:
        section: What is cut.
        outside: The housing in that view [mm].
        scale: mm of paper per mm [-].
        turned: Whether the view is turned by half a turn.
    """
    up, foot = complex(*section.casing.up.tolist()), MM * complex(*section.casing.foot.tolist())
    reach = [((point - foot) * up.conjugate()).real for line in outside for point in line.points]
    middle, half = foot + up * (min(reach) + max(reach)) / 2.0, (max(reach) - min(reach)) / 2.0
    sense = -1.0 if turned else 1.0
    return cutting_plane(sense * scale * middle, scale * half + BEYOND, LETTER, looking=-1j * sense * up)


# ----------------------------------------------------------------------------------------------------------------------
# Machines towards which a housing has no opening: what their shafts would go through is metal.
# ----------------------------------------------------------------------------------------------------------------------


STEP = 2e-3
"""Between points at which metal is looked for [m]: less than the thinnest wall."""


def closed_towards(sizing: Sizing, scene: Scene) -> tuple[str, ...]:
    """Return the machines whose shafts would have to go through walls of the housing.

    Args:
        sizing: What was sized.
        scene: Its solids with those of the housing.
    """
    return tuple(machine for machine, ray in _rays(sizing, scene) if _is_met(scene, ray))


def _rays(sizing: Sizing, scene: Scene) -> Iterator[tuple[str, Floats]]:
    """Yield every machine with points along the axis of its shaft from the shaft's end out of the housing."""
    pieces = pieces_of(scene)
    if not pieces:
        return
    far = max(float(np.max(np.abs(solid.outer))) + max(map(abs, solid.span)) + abs(float(node.axes.origin[0]))
              for node, solid in pieces)  # fmt: skip
    drawn = runs(sizing)[0]
    for machine, shaft in sizing.train.machines.items():
        steps = [step for run in drawn if run.shaft == shaft for step in run.steps]
        if not steps:
            continue
        frame, place = sizing.arrangement.frames[shaft], sizing.arrangement.plans[shaft].places[machine]
        low, high = min(step[0] for step in steps), max(step[1] for step in steps)
        end, sense = (low, -1.0) if place - low < high - place else (high, 1.0)
        along = np.array(frame.along)
        yield machine, np.array(frame.origin) + (end + sense * np.arange(0.0, 2.0 * far, STEP))[:, None] * along


def _is_met(scene: Scene, points: Floats) -> bool:
    return any(
        depth_in((points - node.axes.origin) @ node.axes.turned, solid) > 0.0 for node, solid in pieces_of(scene)
    )


def exit_notes(closed: Sequence[str]) -> Iterator[str]:
    """Yield what is said of machines towards which there is no opening.

    Args:
        closed: From `closed_towards`.
    """
    if closed:
        yield f"No opening is cut towards {', '.join(closed)}: shafts of the first sizing end within the housing."


# ----------------------------------------------------------------------------------------------------------------------
# What the sheet of a housing says of its ribs and mounts.
# ----------------------------------------------------------------------------------------------------------------------


def mounts_grid(casing: Casing) -> SheetTable:
    """Return the lugs of a housing: from where to where they stand, where their holes are, and how wide.

    Args:
        casing: The housing.
    """
    rows = []
    for k, lug in enumerate(mounts_of(casing.scene), start=1):
        middle, radius = lug.hole or (lug.base, 0.0)
        places = (trimmed(MM * (at - casing.start), 1) for at in lug.span)
        rows.append((f"{k}", *places, *(trimmed(MM * at, 1) for at in middle), f"Ø{trimmed(2.0 * MM * radius, 1)}"))
    return SheetTable("Mounts [mm]", tuple(rows), ("No.", "From", "To", "y", "z", "Hole"))


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
