"""The housing as the arrangement's section cuts it: chambers, webs, ribs, mounts, screws, list of parts."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.base import Floats, largest
from gearwright.render.drawings.arrangement_view import Item
from gearwright.render.drawings.entities import Entity, Hatch, Layer, Path, millimetres, trimmed
from gearwright.render.drawings.positions import Lane, Positions, crossed, lanes
from gearwright.render.drawings.shaft_view import MM, made_of
from gearwright.shape import CHAMBER, FLANGES, MOUNT, RIB, WEB, Node, Scene, around, short_of
from gearwright.shape.chambers import Chamber, Cut, Rectangle, bored, cut_chamber, spans_in, united, without
from gearwright.shape.solids import Solid
from gearwright.sizing import Sizing
from gearwright.sizing.casing import HEAD, HOLE, LENGTH, NUT, THICKNESS, WASHER, Flanges
from gearwright.sizing.mass import carried_in_walls, weighed_flanges, weighed_wall

# ----------------------------------------------------------------------------------------------------------------------
# Webs that carry bosses, in a section: cut across they are metal, lengthwise they are not hatched (ISO 128).
# ----------------------------------------------------------------------------------------------------------------------


SQUARE_WEB = 1e-9
"""How far directions may be from square, or from one another [-]."""
SEEN = 1e-5
"""Pieces of lines that are shorter are left out [m]."""

Line = tuple[complex, complex]
Span = tuple[float, float]


def web_nodes(scene: Scene) -> list[Node]:
    """Return the webs of a housing.

    Args:
        scene: With the housing.
    """
    return [node for node in scene.nodes if node.look == "housing" and f", {WEB} " in node.name]


def webs_across(scene: Scene, ways: Sequence[Lane]) -> Iterator[Rectangle]:
    """Yield what a section cuts of webs that it does not lie along.

    Args:
        scene: With the housing.
        ways: Of the section.
    """
    for node in web_nodes(scene):
        along, across, way = node.axes.turned.T
        if abs(abs(float(along[0])) - 1.0) > SQUARE_WEB:
            continue  # of a shaft across the first one: its webs lie in the section, or beside it
        long, wide, thick = _half_sizes(scene, node)
        signs = ((1, 1), (-1, 1), (-1, -1), (1, -1))
        loop = node.axes.origin[1:] + np.array([x * thick * across + y * long * way for x, y in signs])[:, 1:]
        if float(across[1] * way[2] - across[2] * way[1]) < 0.0:
            loop = loop[::-1]
        start, end = (float(node.axes.origin[0]) + sign * wide for sign in (-1.0, 1.0))
        for lane in ways:
            if any(abs(float(leg.along @ across[1:])) < SQUARE_WEB for leg in lane.legs):
                continue
            low, high = max(start, lane.start), min(end, lane.end)
            if low < high:
                yield from (Rectangle(low, high, *span) for span in spans_in(loop, lane.legs))


def webs_along(scene: Scene, ways: Sequence[Lane], metal: Sequence[Rectangle]) -> Iterator[Line]:
    """Yield the edges of webs along which a section lies, where they stand out of other metal, x + i height [m].

    Args:
        scene: With the housing.
        ways: Of the section.
        metal: What the section cuts of the housing.
    """
    for node in web_nodes(scene):
        for lane in ways:
            for leg in lane.legs:
                found = _outline_of_web(scene, node, leg.foot, leg.along)
                if found is None:
                    continue
                x, height = found
                x = max(x[0], lane.start), min(x[1], lane.end)
                height = max(height[0], leg.low), min(height[1], leg.high)
                if x[0] >= x[1] or height[0] >= height[1]:
                    continue
                if abs(float(node.axes.along[0])) < SQUARE_WEB:
                    yield from (_seen_up(at, height, metal) for at in x)
                else:
                    yield from (_seen_along(at, x, metal) for at in height)


def _outline_of_web(
    scene: Scene, node: Node, foot: Floats, up: Floats
) -> tuple[tuple[float, float], tuple[float, float]] | None:
    """Return from where to where a web that lies in a plane is along the first shaft and on it; None of others [m]."""
    along, across, way = node.axes.turned.T
    off = node.axes.origin[1:] - foot
    long, wide, thick = _half_sizes(scene, node)
    beside = abs(float(off @ np.array([-up[1], up[0]])))
    if abs(float(across[0])) > SQUARE_WEB or abs(float(across[1:] @ up)) > SQUARE_WEB or beside > thick:
        return None
    height, x = float(off @ up), float(node.axes.origin[0])
    level = wide * abs(float(along[0])) + long * abs(float(way[0]))
    upright = wide * abs(float(along[1:] @ up)) + long * abs(float(way[1:] @ up))
    return (x - level, x + level), (height - upright, height + upright)


def _half_sizes(scene: Scene, node: Node) -> tuple[float, float, float]:
    """Return half of a web's length, of its width along its shaft and of its thickness [m]."""
    solid = scene.solids[node.surface]
    assert isinstance(solid, Solid)
    points = solid.sections[0].points
    length = max(place for place, _ in solid.profile)
    return length, float(points[:, 0].max()), float(points[:, 1].max())


def _seen_up(x: float, height: tuple[float, float], metal: Sequence[Rectangle]) -> Line:
    """Return the longest piece of an upright edge that is not in metal."""
    taken = [(one.low, one.high) for one in metal if one.start - SEEN < x < one.end + SEEN]
    low, high = largest(without([height], taken) or [(height[0], height[0])], lambda span: span[1] - span[0])
    return complex(x, low), complex(x, high)


def _seen_along(height: float, x: tuple[float, float], metal: Sequence[Rectangle]) -> Line:
    """Return the longest piece of a level edge that is not in metal."""
    taken = [(one.start, one.end) for one in metal if one.low - SEEN < height < one.high + SEEN]
    low, high = largest(without([x], taken) or [(x[0], x[0])], lambda span: span[1] - span[0])
    return complex(low, height), complex(high, height)


# ----------------------------------------------------------------------------------------------------------------------
# Ribs and mounts of a housing on drawings: ribs beside a section, not cut (ISO 128); both seen along the shaft.
# ----------------------------------------------------------------------------------------------------------------------


NEAR = 0.9
"""Cosine of the angle at most between a rib and the plane that is taken as if it met it [-]."""
ROUNDED = 9
"""Digits of metres at which places that are equal are equal on every processor [-]."""
HOLE_CORNERS = 48
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
    return np.asarray(around(hole[1], 0.0, HOLE_CORNERS)[:, :2] + hole[0])


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
    low, high, bottom, top = _bounds(corners)
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
        boxes = [_bounds(each) for each in (corners, *kept)]
        if not any(_meet(boxes[0], box) for box in boxes[1:]):
            kept.append(corners)
            yield aside, corners


def _bounds(corners: Sequence[complex]) -> tuple[float, float, float, float]:
    xs, ys = [corner.real for corner in corners], [corner.imag for corner in corners]
    return min(xs), max(xs), min(ys), max(ys)


def _meet(one: tuple[float, ...], other: tuple[float, ...]) -> bool:
    near = 1e-6
    return (one[0] < other[1] - near and other[0] < one[1] - near
            and one[2] < other[3] - near and other[2] < one[3] - near)  # fmt: skip


def _is_in(node: Node, solid: Chamber, place: float) -> bool:
    at = place - float(node.axes.origin[0])
    return solid.span[0] <= at <= solid.span[1]


# ----------------------------------------------------------------------------------------------------------------------
# A screw of a flange on a section: seen from its side and not cut, as ISO 128 has fasteners, in its clearance hole.
# ----------------------------------------------------------------------------------------------------------------------


CORNERS = 1.0 / math.cos(math.pi / 6.0)
"""Across the corners of a hexagon over across its flats [-]: a screw shows three of its sides."""


def screw_entities(joint: complex, thread: float) -> Iterator[Entity]:
    """Yield the outlines of a screw along x, its head before the joint: head, washers, shank in its hole, nut and end.

    Args:
        joint: Where its axis goes through the joint [mm].
        thread: Its diameter [mm].
    """
    radius, face, washer = 0.5 * thread, THICKNESS * thread, WASHER[1] * thread
    below = -face - washer
    nut = (face + washer, face + washer + NUT[1] * thread)
    yield from _hexagon(joint, (below - HEAD[1] * thread, below), CORNERS * HEAD[0] * radius)
    for start in (below, face):
        yield _box(joint, (start, start + washer), WASHER[0] * radius)
    for side in (1j, -1j):
        yield Path((joint - face + side * radius, joint + face + side * radius), Layer.OUTLINE)
    yield from _hexagon(joint, nut, CORNERS * NUT[0] * radius)
    yield _box(joint, (nut[1], below + LENGTH * thread), radius)


def _hexagon(joint: complex, span: tuple[float, float], half: float) -> Iterator[Path]:
    """Yield the outline of a hexagon with the edges between its sides."""
    yield _box(joint, span, half)
    for side in (1j, -1j):
        yield Path(tuple(joint + place + side * half / 2.0 for place in span), Layer.OUTLINE)


def _box(joint: complex, span: tuple[float, float], half: float) -> Path:
    low, high = span
    corners = (complex(low, -half), complex(high, -half), complex(high, half), complex(low, half))
    return Path(tuple(joint + corner for corner in corners), Layer.OUTLINE, closed=True)


# ----------------------------------------------------------------------------------------------------------------------
# The housing as the arrangement's section cuts it: chambers, flanges and bosses are one part up to joints.
# ----------------------------------------------------------------------------------------------------------------------


LEAN, SPACING = math.pi / 4.0, 4.0
"""Of the hatching of the housing [rad] and [mm]: wider than that of gears; parts beside a joint lean the other way."""
OVER = 2.4
"""Half a centre line of a screw over the thickness of a half of its flange [-]."""
SQUARE = 1e-9
"""How far an axis on the sheet may turn from upright or level [-]."""


@dataclass(frozen=True)
class CasingSection:
    """What the section cuts of the housing, in metres of the part at the places of the sheet."""

    cuts: tuple[Cut, ...]
    """Its parts, between joints along the first shaft."""
    steps: tuple[float, ...]
    """Where the section steps from one plane to another [m]."""
    flat: bool
    """Whether it is one plane."""
    leaning: tuple[tuple[complex, ...], ...]
    """Outlines of bosses on axes that lean on the sheet [mm]."""

    webs: tuple[Line, ...] = ()
    """Edges of webs along which the section lies [m]."""
    screws: tuple[tuple[complex, complex], ...] = ()
    """Centre lines of screws in flanges, through both halves, heads and nuts [mm]."""
    holes: tuple[Rectangle, ...] = ()
    """Clearance holes around them [m]."""
    ribs: tuple[tuple[complex, ...], ...] = ()
    """Outlines of ribs beside it [mm]."""
    short: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    """What is drawn otherwise than weighed -> both masses [kg]."""
    thread: float = 0.0
    """Diameter of the screws that are drawn [mm]; 0 where their holes are alone."""

    wall: float = 0.0
    """Thickness of the wall as it is drawn [m]."""
    crossed: tuple[str, ...] = ()
    """Shafts whose bodies it also cuts where the sheet does not show them."""

    @property
    def screw(self) -> complex:
        """Where the item number of a flange's screw points [mm]: the highest one."""
        return (
            max((start + end for start, end in self.screws), key=lambda twice: (round(twice.imag, 6), twice.real)) / 2.0
        )

    @property
    def anchor(self) -> complex:
        """Where the item number points [mm]: into the longest wall."""
        rectangles = [one for cut in self.cuts for one in cut.rectangles]
        longest = max(rectangles, key=lambda one: (round(one.end - one.start, 6), one.high))
        return MM * complex(0.7 * longest.start + 0.3 * longest.end, (longest.low + longest.high) / 2.0)


def casing_section(sizing: Sizing, scene: Scene, plane: Positions) -> CasingSection | None:
    """Return the housing in the section of the general arrangement; None where there is none or no true section of it.

    Args:
        sizing: What was sized.
        scene: Its solids.
        plane: Where shafts lie.
    """
    if not sizing.design.housing.own or lanes(sizing, plane) is None:
        return None
    ways = lanes(sizing, plane, joints_of(scene)) or ()
    nodes = [node for node in scene.nodes if node.look == "housing"]
    rectangles: list[Rectangle] = []
    for node in nodes:
        solid = scene.solids[node.surface]
        if isinstance(solid, Chamber):
            cut = _cut(node, solid, ways)
            if cut is None:
                return None
            rectangles += cut
    rectangles += webs_across(scene, ways)
    leaning = []
    for corners in _bosses(sizing, scene, plane):
        turn = (corners[1] - corners[0]) / abs(corners[1] - corners[0])
        if min(abs(turn.real), abs(turn.imag)) < SQUARE:
            xs, ys = (sorted(part / MM for part in parts)
                      for parts in ([c.real for c in corners], [c.imag for c in corners]))  # fmt: skip
            rectangles.append(Rectangle(xs[0], xs[-1], ys[0], ys[-1]))
        else:
            leaning.append(corners)
    steps = tuple(lane.end for lane in ways[:-1])
    legs = [leg for lane in ways for leg in lane.legs]
    flat = all(abs(float(leg.along @ legs[0].along)) > 1.0 - SQUARE for leg in legs)
    flanges = weighed_flanges(sizing)
    screws = tuple(screw_lines(scene, ways))
    holes = screw_holes(screws, flanges)
    cuts = tuple(united(bored(rectangles, holes), joints_of(scene)))
    ribs, short = rib_outlines(scene, ways, screws, MM * flanges.thread), short_of(sizing, scene)
    return CasingSection(
        cuts, steps, flat, tuple(leaning), tuple(webs_along(scene, ways, rectangles)), screws, holes, ribs, short,
        MM * flanges.thread, _wall_of(scene), tuple(crossed(sizing, plane, ways)),
    )  # fmt: skip


def _wall_of(scene: Scene) -> float:
    """Return the thickness of a housing's wall, which is that of its plates [m]."""
    chambers = [solid for node in scene.nodes if isinstance(solid := scene.solids.get(node.surface), Chamber)]
    return next(end.thickness for chamber in chambers for end in chamber.ends if end)


def _cut(node: Node, chamber: Chamber, ways: tuple[Lane, ...]) -> list[Rectangle] | None:
    """Return what the section cuts of a chamber; None where it meets an opening that it does not lie along."""
    found, at = [], float(node.axes.origin[0])
    for lane in ways:
        cut = cut_chamber(chamber, lane.legs)
        if cut is None:
            return None
        for one in cut:
            start, end = max(one.start + at, lane.start), min(one.end + at, lane.end)
            if start < end:
                found.append(Rectangle(start, end, one.low, one.high))
    return found


def screw_lines(scene: Scene, ways: tuple[Lane, ...]) -> Iterator[tuple[complex, complex]]:
    """Yield the centre lines of screws where a section cuts flanges, as if it met one there [mm].

    Args:
        scene: With the housing.
        ways: Where the section runs, from the first end to the last.
    """
    for node in (node for node in scene.nodes if node.look == "housing" and FLANGES in node.name):
        half, at = scene.solids[node.surface], float(node.axes.origin[0])
        joint = any(abs(at - place) < SQUARE for place in joints_of(scene))
        lane = next(lane for lane in ways if at <= lane.end)
        if joint and isinstance(half, Chamber):
            reach = OVER * half.span[1]
            for low, high in without(spans_in(half.outer, lane.legs), spans_in(half.inner, lane.legs)):
                yield tuple(MM * complex(x, (low + high) / 2.0) for x in (at - reach, at + reach))  # type: ignore[misc]


def screw_holes(lines: Sequence[tuple[complex, complex]], flanges: Flanges) -> tuple[Rectangle, ...]:
    """Return the clearance holes around the centre lines of screws, through both halves of flanges.

    Args:
        lines: Their centre lines [mm].
        flanges: As they are weighed.
    """
    middles = [(start + end) / (2.0 * MM) for start, end in lines]
    reach, half = flanges.thickness, HOLE * flanges.thread / 2.0
    return tuple(Rectangle(at.real - reach, at.real + reach, at.imag - half, at.imag + half) for at in middles)


def joints_of(scene: Scene) -> list[float]:
    """Return where halves of flanges meet, along the first shaft [m].

    Args:
        scene: With the housing.
    """
    halves = [node for node in scene.nodes if node.look == "housing" and FLANGES in node.name]
    places = sorted(float(node.axes.origin[0]) for node in halves)
    return places[1::2]


def _bosses(sizing: Sizing, scene: Scene, plane: Positions) -> Iterator[tuple[complex, ...]]:
    """Yield the outlines of both halves of every boss and collar on the sheet [mm]."""
    for bearing in sizing.bearings:
        node = scene.by_name.get(f"housing, boss of {bearing.name}")
        solid = scene.solids[node.surface] if node else None
        if node is None or not isinstance(solid, Solid):
            continue
        frame, lying = sizing.arrangement.frames[bearing.shaft], plane.shafts[bearing.shaft]
        middle = float((node.axes.origin - np.array(frame.origin)) @ np.array(frame.along))
        for side in (1.0, -1.0):
            yield tuple(lying.at(MM * (middle + z), side * MM * radius) for z, radius in solid.profile[:-1])
    for collar in (one for carried in carried_in_walls(sizing) for one in carried.collars):
        lying, (low, high) = plane.shafts[collar.shaft], collar.span
        around = ((low, collar.inner), (low, collar.outer), (high, collar.outer), (high, collar.inner))
        for side in (1.0, -1.0):
            yield tuple(lying.at(MM * place, side * MM * radius) for place, radius in around)


def casing_entities(section: CasingSection, scale: float) -> Iterator[Entity]:
    """Yield a housing in section; where the section steps, a chain line parts its planes.

    Args:
        section: What is cut.
        scale: mm of paper per mm [-].
    """
    paper = scale * MM
    for k, cut in enumerate(section.cuts):
        lean = LEAN if k % 2 == 0 else math.pi - LEAN
        for one in cut.rectangles:
            corners = (complex(one.start, one.low), complex(one.end, one.low),
                       complex(one.end, one.high), complex(one.start, one.high))  # fmt: skip
            yield Hatch(tuple(paper * corner for corner in corners), lean, SPACING)
        for loop in cut.loops:
            yield from _outline([paper * complex(*corner) for corner in loop], [paper * at for at in section.steps])
    for start, end in section.webs:
        yield Path((paper * start, paper * end), Layer.OUTLINE)
    for outline in section.ribs:
        yield Path(tuple(scale * corner for corner in outline), Layer.OUTLINE, closed=True)
    for start, end in section.screws:
        yield Path((scale * start, scale * end), Layer.CENTRE)
        if section.thread:
            yield from screw_entities(scale * (start + end) / 2.0, scale * section.thread)
    for outline in section.leaning:
        boss = tuple(scale * corner for corner in outline)
        yield from (Hatch(boss, LEAN, SPACING), Path(boss, Layer.OUTLINE, closed=True))


def _outline(corners: list[complex], steps: list[float]) -> Iterator[Path]:
    """Yield an outline; its sides where the section steps are no edges of the part."""
    sides = list(pairwise([*corners, corners[0]]))
    stepped = [any(abs(end.real - at) < 1e-6 for at in steps) and abs(end.real - start.real) < 1e-6
               for start, end in sides]  # fmt: skip
    if not any(stepped):
        yield Path(tuple(corners), Layer.OUTLINE, closed=True)
        return
    first = stepped.index(True)
    run: list[complex] = []
    for (start, end), is_step in zip(sides[first:] + sides[:first], stepped[first:] + stepped[:first], strict=True):
        if is_step:
            if run:
                yield Path(tuple(run), Layer.OUTLINE)
            yield Path((start, end), Layer.CENTRE)
            run = []
        else:
            run = [*(run or [start]), end]
    if run:
        yield Path(tuple(run), Layer.OUTLINE)


# ----------------------------------------------------------------------------------------------------------------------
# The housing in a list of parts, and what a drawing says of it.
# ----------------------------------------------------------------------------------------------------------------------


SHOWN = tuple(
    f"housing {part}".strip()
    for part in ("", "shell", "inner walls", "flanges", "bosses", "webs", "lands of rings", "ribs", "mounts")
)
"""What is drawn of what a housing is weighed as; the first one where a design gives the whole."""
SCREWS = "housing bolts"
"""What of it is not one piece with it."""


def casing_items(sizing: Sizing, section: CasingSection, scale: float) -> Iterator[Item]:
    """Yield the housing and the screws of its flanges as the list of parts has them.

    Args:
        sizing: What was sized.
        section: What is drawn of the housing.
        scale: mm of paper per mm [-].
    """
    masses = made_of(sizing).casing
    mass = sum(each for name, each in masses.items() if name != SCREWS)
    yield Item("Housing", sizing.design.housing.material, 1, mass, scale * section.anchor)
    if SCREWS in masses:
        flanges = weighed_flanges(sizing)
        count, size = flanges.number * flanges.screws, f"M{trimmed(MM * flanges.thread, 1)}"
        remark = f"{size} x {trimmed(MM * LENGTH * flanges.thread, 1)}, 10.9, nut, washers"
        yield Item("Screw of flange", remark, count, masses[SCREWS] / count, scale * section.screw)


def casing_notes(sizing: Sizing, section: CasingSection | None) -> Iterator[str]:
    """Yield what has to be said of the housing.

    Args:
        sizing: What was sized.
        section: What is drawn of it.
    """
    if not sizing.design.housing.own:
        yield "No housing: what stands around the gears is no part of the gearbox."
    elif section is None:
        yield "The housing is not drawn: the section has axes beside each other that are not in one plane in space."
    else:
        wall = weighed_wall(sizing)
        yield (
            f"Housing: a wall of {millimetres(MM * section.wall)} mm, the shell of the complete mass (thin, "
            f"{millimetres(MM * wall.thickness)} mm as {wall.why} asks), with flanges, bosses, ribs and mounts."
        )
        bare = [name for one in carried_in_walls(sizing) if not one.found for name in one.bearings]
        if sizing.bearings:
            yield "Webs (not hatched) and collars carry bosses; webs beside this plane: sheet housing."
        if bare:
            yield f"No web or collar finds a way from the housing to the bosses of {', '.join(bare)}."
        hidden = {name: mass for name, mass in made_of(sizing).casing.items() if name not in (*SHOWN, SCREWS)}
        if hidden:
            listed = ", ".join(f"{name} {mass:.3g} kg" for name, mass in hidden.items())
            yield f"Weighed, not drawn: {listed}."
        for part, (drawn, weighed) in section.short.items():
            yield f"{part.capitalize()}: {drawn:.3g} kg of {weighed:.3g} kg are drawn: walls leave no room for more."
        if section.steps:
            yield "The section of the housing steps from one plane of axes to the other at the chain line."
        elif not section.flat:
            yield "B-B is unfolded: cut in the plane of each two axes that stand beside each other, as view A has them."
        if section.crossed:
            names = ", ".join(section.crossed)
            yield f"Where other legs of the section also cut bodies on {names}, these are left out of them."
