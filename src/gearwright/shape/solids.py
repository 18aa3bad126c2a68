"""Closed surfaces from numbers: toothed walls, cones, faces, bodies of revolution; none knows a sizing.

Which bodies a gearbox has, and where they stand, is for `shape`.
"""

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.base import Bools, Floats, Ints, following
from gearwright.parts.bevel_geometry import BevelPair, bevel_form
from gearwright.parts.gears import Blank, TransverseTooth, face_reach, face_thickness, face_way
from gearwright.shape.surfaces import (
    Bores,
    Holes,
    Surface,
    around,
    around_hole,
    bored_ends,
    circle,
    joined,
    pierced,
    plane_triangles,
    revolved,
    strip,
)

# ----------------------------------------------------------------------------------------------------------------------
# What a solid is made of: a way about the axis, and the toothed walls between its ends; and its triangles.
# ----------------------------------------------------------------------------------------------------------------------


class Section(NamedTuple):
    """A loop at a place along the axis."""

    radius: Floats
    """[m], shape (n,)"""
    angle: Floats
    """[rad], shape (n,)"""
    height: Floats
    """z of its points [m], shape (n,)."""

    @property
    def points(self) -> Floats:
        """Its corners [m], shape (n, 3)."""
        return np.stack([self.radius * np.cos(self.angle), self.radius * np.sin(self.angle), self.height], axis=1)


class Solid(NamedTuple):
    """A body about its own axis z, as exact as its numbers: meshes and files of CAD are made of it."""

    profile: tuple[tuple[float, float], ...]
    """z and radius of a way of straight lines about the axis, the body to its right [m]; its ends meet each other or
    the axis, or, of toothed bodies, the faces of the last and of the first section."""
    sections: tuple[Section, ...] = ()
    """Outlines of the teeth, in the order of their places along the axis; none of a body of revolution."""
    edges: Bools | None = None
    """Where outlines have corners."""
    inside: bool = False
    """Whether the body lies around its teeth, as a ring's does."""
    holes: Holes | None = None
    """Between the two faces of its profile on which they lie."""
    bores: Bores | None = None
    """Through both ends of a plate, whose profile is its own hole, as wide at both."""


BORE_STEPS = 3
"""Corners of a quarter of a bore through a plate [-]."""
RING_CORNERS = 2
"""Corners of the outside of a ring over those of other circles: thin walls lose most by chords [-]."""
SAME_ROOT = 1e-9
"""How far radii of roots may differ by rounding over themselves [-]."""
FEW = 6
"""Points of roots below which a loop has no teeth [-]."""
TOUCHING = 3
"""Corners of a circle that is one point [-]."""


def surface_of(solid: Solid, segments: int) -> Surface:
    """Return the triangles of a solid; holes are as wide as round bodies need.

    Args:
        solid: The solid.
        segments: Corners of a circle.
    """
    if not solid.sections or solid.edges is None:
        return revolved(_widened(solid.profile, segments), segments)
    if solid.bores is not None:
        return _plate(solid, solid.edges, solid.bores)
    corners = segments * (RING_CORNERS if solid.inside else 1)
    profile = solid.profile if solid.inside else _widened(solid.profile, segments)
    if not any(radius for _, radius in profile):
        corners = TOUCHING
    if solid.holes is not None:  # they stand alike to the corners of circles
        corners = solid.holes.number * math.ceil(corners / solid.holes.number)
    # The way begins at the last section of an external gear, and at the first one of a ring.
    order = (0, -1) if solid.inside else (-1, 0)
    ends = []
    for end, (height, radius) in zip(order, (profile[0], profile[-1]), strict=True):
        section, ring = solid.sections[end], ring_of(radius, height, corners)
        outer, inner = (ring, section) if solid.inside else (section, ring)
        toothed_loop = (1 if solid.inside else 0) if solid.edges.any() else None
        ends.append(cap(outer, inner, facing(section, up=end == -1), up=end == -1, toothed=toothed_loop))
    toothed = wall(solid.sections, solid.edges, inside=solid.inside)
    behind = revolved(profile, corners) if solid.holes is None else pierced(profile, solid.holes, corners)
    return joined([toothed, *(ends[::-1] if solid.inside else ends), behind])


def _plate(solid: Solid, edges: Bools, bores: Bores) -> Surface:
    """Return a plate with its bores: its hole has corners on the rays of those of its outline."""
    low, high = solid.sections
    (_, bore), _ = solid.profile
    span, turn = (float(low.height[0]), float(high.height[0])), np.exp(1j * low.angle)
    hole = bore / math.cos(0.5 * float(np.max(np.diff(low.angle, append=low.angle[0] + 2.0 * math.pi))))
    pieces = [wall(solid.sections, edges), bored_ends(low.radius * turn, hole * turn, span, bores.as_large(BORE_STEPS))]
    if bore:
        ring = [section._replace(radius=np.full(len(turn), hole)) for section in solid.sections]
        pieces.append(wall(ring, edges, inside=True))
    return joined(pieces)


def _widened(profile: Sequence[tuple[float, float]], segments: int) -> list[tuple[float, float]]:
    """Return a way whose hole is widened for its corners, where that leaves metal, and what it would cut not below."""
    bore = min(radius for _, radius in profile)
    least = around_hole(bore, segments) if bore else 0.0
    if least >= max(radius for _, radius in profile):  # a ring thinner than its chords are deep
        return list(profile)
    return [(height, max(radius, least)) for height, radius in profile]


def facing(section: Section, *, up: bool) -> tuple[float, float]:
    """Return which way the face at an end of a toothed wall looks, along the axis and outwards [-].

    Args:
        section: There: square to the axis, on a back cone or on a cylinder.
        up: Whether it is the last one.
    """
    low, high = int(np.argmin(section.height)), int(np.argmax(section.height))
    rise, out = float(section.height[high] - section.height[low]), float(section.radius[high] - section.radius[low])
    length = math.hypot(rise, out)
    if length == 0.0:
        return (1.0, 0.0) if up else (-1.0, 0.0)
    sign = 1.0 if up else -1.0
    return (-sign * out / length, sign * rise / length)


def wall(sections: Sequence[Section], edges: Bools, *, inside: bool = False) -> Surface:
    """Return the flanks, fillets and lands between sections of a gear.

    Args:
        sections: In the order of their places along the axis.
        edges: Where the outline has corners.
        inside: Whether the body lies around the loop, as a ring's does.
    """
    places = np.stack([section.points for section in sections])
    levels, count = places.shape[:2]
    doubled = edges.astype(np.int64)
    before = np.arange(count) + np.cumsum(doubled) - doubled
    after = before + doubled
    width = count + int(doubled.sum())
    points = np.empty((levels, width, 3))
    points[:, before], points[:, after] = places, places
    # Along the outline and along the axis, both by differences; their product stands square to the surface.
    seen = places[:1] if levels == 2 and np.array_equal(places[0, :, :2], places[1, :, :2]) else places
    along = np.roll(seen, -1, axis=1) - seen
    axial = np.gradient(places, axis=0)[: len(seen)] if levels > 1 else np.zeros_like(places)
    onward = np.cross(along, 0.5 * (axial + np.roll(axial, -1, axis=1)))
    onward /= np.linalg.norm(onward, axis=2, keepdims=True)
    backward = np.roll(onward, 1, axis=1)
    mean = onward + backward
    mean /= np.linalg.norm(mean, axis=2, keepdims=True)
    normals = np.empty_like(points)
    normals[:, before] = np.where(edges[None, :, None], backward, mean)
    normals[:, after] = np.where(edges[None, :, None], onward, mean)
    first, second = after, np.roll(before, -1)
    quads = []
    for level in range(levels - 1):
        low, high = level * width, (level + 1) * width
        quads.append(np.stack([first + low, second + low, second + high], axis=1))
        quads.append(np.stack([first + low, second + high, first + high], axis=1))
    triangles = np.concatenate(quads)
    if inside:
        triangles, normals = triangles[:, ::-1], -normals
    return Surface(points.reshape(-1, 3), normals.reshape(-1, 3), triangles)


def cap(
    outer: Section, inner: Section, normal: tuple[float, float], *, up: bool, toothed: int | None = None
) -> Surface:
    """Return the face between two loops at one end of a body.

    Teeth are cut off along the chords of their roots, and each is made of triangles of its own: between the corners of
    a circle and the flanks of many teeth they would reach across gaps.

    Args:
        outer: The outer loop.
        inner: The inner one.
        normal: Of the face, along the axis and outwards from it [-].
        up: Whether it looks along +z.
        toothed: Which loop has teeth: 0 the outer one, 1 the inner one; None: neither.
    """
    angle = np.concatenate([outer.angle, inner.angle])
    turned = []
    for section in (outer, inner):
        lead = np.mod(section.angle[0] + np.pi, 2.0 * np.pi) - np.pi
        turned.append(section.angle - section.angle[0] + lead)
    kept = [np.arange(len(section.angle)) for section in (outer, inner)]
    teeth: list[Ints] = []
    if toothed is not None:
        radius = (outer, inner)[toothed].radius
        kept[toothed], cut = teeth_apart(radius if toothed == 0 else -radius)
        teeth.append(cut if toothed == 0 else cut[:, ::-1] + len(outer.angle))
    numbers = np.concatenate([kept[0], kept[1] + len(outer.angle)])
    between = numbers[strip(turned[0][kept[0]], turned[1][kept[1]])]
    triangles = np.concatenate([between, *teeth])
    points = np.concatenate([outer.points, inner.points])
    normals = np.stack([normal[1] * np.cos(angle), normal[1] * np.sin(angle), np.full(len(angle), normal[0])], axis=1)
    return Surface(points, normals, triangles if up else triangles[:, ::-1])


def teeth_apart(radius: Floats) -> tuple[Ints, Ints]:
    """Return the points of a loop that are left without its teeth, and the triangles of the teeth.

    Args:
        radius: Of its points [m], shape (n,); of teeth that point inwards, negative.

    Source: a tooth is walked from both of its roots at once, from flank to flank.
    """
    least = float(radius.min())
    base, count = np.flatnonzero(radius <= least + SAME_ROOT * abs(least)), len(radius)
    if len(base) < FEW:  # a block's sides
        return np.arange(count), np.empty((0, 3), dtype=np.int64)
    spans = np.mod(np.roll(base, -1) - base, count)
    spans[spans == 0] = count
    found = [np.empty((0, 3), dtype=np.int64)]
    for span in np.unique(spans[spans > 1]):
        low, high, steps = 0, int(span), list[tuple[int, int, int]]()
        while high - low > 1:
            steps.append((low, low + 1, high))
            low += 1
            if high - low > 1:
                steps.append((low, high - 1, high))
                high -= 1
        found.append((base[spans == span][:, None, None] + np.array(steps)).reshape(-1, 3) % count)
    return base, np.concatenate(found)


def ring_of(radius: float, height: float, segments: int) -> Section:
    """Return a circle as a section.

    Args:
        radius: [m].
        height: z [m].
        segments: How many corners.
    """
    return Section(np.full(segments, radius), circle(segments), np.full(segments, height))


# ----------------------------------------------------------------------------------------------------------------------
# Outlines of all teeth of a cylindrical gear, swept along its axis, and the bodies under them.
# ----------------------------------------------------------------------------------------------------------------------


SAME_ANGLE = 1e-9
"""Angle between two points that are one [rad]."""


class Loop(NamedTuple):
    """A closed outline about the axis, counter-clockwise, tooth 0 about the angle 0."""

    radius: Floats
    """[m], shape (n,)"""
    angle: Floats
    """[rad], shape (n,)"""
    edges: Bools
    """Where it has a corner, shape (n,)."""


def loop_of(form: tuple[Floats, Floats], teeth: int) -> Loop:
    """Return the outline of all teeth.

    Args:
        form: Radii [m] and half angles [rad] of one side of a tooth, from its root to its tip.
        teeth: z [-].
    """
    radius, half = form
    one = np.concatenate([-half, half[::-1]])
    corner = np.zeros(2 * len(half), dtype=bool)
    corner[[len(half) - 1, len(half)]] = True
    pitch = 2.0 * np.pi / teeth
    if one[0] + pitch - one[-1] < SAME_ANGLE:  # a fully rounded root: the fillets of two teeth meet in one point
        one, corner, radius = one[:-1], corner[:-1], np.concatenate([radius, radius[::-1]])[:-1]
    else:
        radius = np.concatenate([radius, radius[::-1]])
    angle = (np.arange(teeth)[:, None] * pitch + one).ravel()
    return Loop(np.tile(radius, teeth), angle, np.tile(corner, teeth))


def sections_of(loop: Loop, levels: Sequence[tuple[float, float]]) -> list[Section]:
    """Return a loop at several places along the axis.

    Args:
        loop: The outline.
        levels: Place [m] and turn [rad] of each.
    """
    return [Section(loop.radius, loop.angle + turn, np.full(len(loop.angle), place)) for place, turn in levels]


def inner_profile(blank: Blank) -> list[tuple[float, float]]:
    """Return the way along the inside of a gear's body from its upper face to its lower one, z and radius [m].

    Args:
        blank: Its radii and widths; where rim and hub meet, its bore alone.
    """
    half, web = blank.width / 2.0, blank.web_width / 2.0
    if blank.is_solid:
        return [(half, blank.bore_radius), (-half, blank.bore_radius)]
    rim, hub, bore = blank.rim_radius, blank.hub_radius, blank.bore_radius
    upper, lower = (
        [(side * half, rim), (side * web, rim), (side * web + blank.dish, hub), (side * half, hub), (side * half, bore)]
        for side in (1.0, -1.0)
    )
    return [*upper, *lower[::-1]]


def disc_gear(loop: Loop, levels: Sequence[tuple[float, float]], blank: Blank) -> Solid:
    """Return an external gear with its body.

    Args:
        loop: Its outline.
        levels: Place along the axis [m] and turn [rad] of its sections, from −b/2 to b/2.
        blank: The body under the teeth.
    """
    bored = Holes(blank.holes, blank.hole_circle, blank.hole_radius) if blank.hole_radius else None
    return Solid(tuple(inner_profile(blank)), tuple(sections_of(loop, levels)), loop.edges, holes=bored)


def ring_gear(loop: Loop, levels: Sequence[tuple[float, float]], outside: float) -> Solid:
    """Return an internal gear with its wall.

    Args:
        loop: Its outline.
        levels: Place along the axis [m] and turn [rad] of its sections.
        outside: Its outer radius [m].
    """
    sections = sections_of(loop, levels)
    low, high = (float(sections[end].height[0]) for end in (0, -1))
    return Solid(((low, outside), (high, outside)), tuple(sections), loop.edges, inside=True)


# ----------------------------------------------------------------------------------------------------------------------
# Bevel and face gears: teeth on cones by their virtual spur gears, teeth on a face as racks, and the bodies behind.
#
# Both stand with their axis along z, away from the mate: the mean point of the face at z = 0, tips towards −z.
#
# These teeth are approximations. Bevel teeth have the profile of the virtual cylindrical gear of their back cone
# (Tredgold), which differs from the octoid of a generated tooth by little, and spirals of constant angle instead of a
# cutter's circle. Teeth of a face gear are, in every cylinder about its axis, those of the rack that the unrolled
# pinion meshes with there; the curvature of the wheel's motion within the width of a tooth is left out.
# ----------------------------------------------------------------------------------------------------------------------


class Fineness(NamedTuple):
    """How finely surfaces are cut."""

    fillet: int
    """Points on a fillet [-]."""
    flank: int
    """Points on a flank [-]."""
    circle: int
    """Corners of a circle [-]."""
    layer: float
    """Largest turn of a tooth between two sections [rad]."""
    slices: int
    """Sections along the face of a bevel or face gear, less one [-]."""


def bevel_gear(pair: BevelPair, side: int, way: Sequence[tuple[float, float]], *, hand: float, fine: Fineness) -> Solid:
    """Return a bevel gear with its body.

    Args:
        pair: Its pair.
        side: 0 for the pinion, 1 for the wheel.
        way: Behind its teeth, `bevel_way`.
        hand: +1 for a right-hand spiral, −1 for a left-hand one, 0 for straight teeth.
        fine: How finely.

    Source: Tredgold's virtual gear z/cos δ of the back cone; standard depth taper, ISO 23509:2016.
    """
    cone, mean = pair.pitch_angles[side], pair.mean_cone_distance
    form = bevel_form(pair, side, fillet=fine.fillet, flank=fine.flank)
    virtual = mean * math.tan(cone)
    loop = loop_of((form[0] - virtual, form[1] / math.cos(cone)), pair.teeth[side])
    ends = (mean - pair.face_width / 2.0, mean + pair.face_width / 2.0)
    count = fine.slices if hand else 1
    sections = [
        _on_cone(loop, cone, mean, far=float(far), turn=hand * spiral_turn(pair, side, float(far)))
        for far in np.linspace(*ends, count + 1)
    ]
    return Solid(tuple(way), tuple(sections), loop.edges)


def spiral_turn(pair: BevelPair, side: int, far: float) -> float:
    """Return by how much a right-hand tooth is turned about the axis, against the middle of the face [rad].

    Args:
        pair: The pair.
        side: 0 for the pinion, 1 for the wheel.
        far: Cone distance [m].

    Source: a line that crosses the cone's generators at β: dφ = tan β dR/(R sin δ).
    """
    return math.tan(pair.spiral_angle) * math.log(far / pair.mean_cone_distance) / math.sin(pair.pitch_angles[side])


def _on_cone(loop: Loop, cone: float, mean: float, *, far: float, turn: float) -> Section:
    """Return the outline at a cone distance; its radii are heights above the pitch cone at the mean one."""
    height = loop.radius * far / mean
    radius = far * math.sin(cone) + height * math.cos(cone)
    return Section(radius, loop.angle + turn, (far - mean) * math.cos(cone) - height * math.sin(cone))


def face_wheel(pinion: TransverseTooth, teeth: int, *, width: float, bore: float, fine: Fineness) -> Solid:
    """Return the wheel of a face-gear pair whose shaper has the teeth of the pinion.

    Args:
        pinion: A spur gear.
        teeth: Of the wheel [-].
        width: Of its face about the pitch circle, as far as teeth are whole there [m].
        bore: Radius of what it sits on [m].
        fine: How finely.

    Source: as `gearwright.parts.gears.face_thickness`.
    """
    radii = np.linspace(*face_reach(pinion, teeth, width), fine.slices + 1)
    corner = np.tile(np.array([True, True, True, True]), teeth)
    sections = [_face_section(pinion, teeth, float(radius)) for radius in radii]
    return Solid(tuple(face_way(pinion, teeth, width=width, bore=bore)), tuple(sections), corner)


def _face_section(pinion: TransverseTooth, teeth: int, radius: float) -> Section:
    top, root = face_thickness(pinion, teeth, radius)
    one = np.array([-root, -top, top, root]) / radius
    angle = (np.arange(teeth)[:, None] * (2.0 * math.pi / teeth) + one).ravel()
    tip, foot = -pinion.rack.addendum * pinion.module, pinion.rack.dedendum * pinion.module
    return Section(np.full(len(angle), radius), angle, np.tile(np.array([foot, tip, tip, foot]), teeth))


# ----------------------------------------------------------------------------------------------------------------------
# Bodies of revolution: shafts by their steps, bearings by their rings, pins.
# ----------------------------------------------------------------------------------------------------------------------


RING = 0.28
"""Thickness of a bearing's ring over its section, an assumption [-]."""
RECESS = 0.15
"""How far rolling elements and cage stand behind the faces of the rings over the width, an assumption [-]."""


def tube(span: tuple[float, float], outer: float, bore: float) -> Solid:
    """Return a cylinder with a bore, or without one.

    Args:
        span: Where it begins and ends [m].
        outer: Its radius [m].
        bore: Radius of its bore; 0: none [m].
    """
    return stepped([(span[0], span[1], outer)], bore)


def stepped(steps: Sequence[tuple[float, float, float]], bore: float) -> Solid:
    """Return a shaft.

    Args:
        steps: Start, end [m] and radius [m] of each, without gaps.
        bore: Radius of its bore; 0: none [m].
    """
    way = [(steps[0][0], bore)]
    for start, end, radius in steps:
        way += [(start, max(radius, 1.05 * bore)), (end, max(radius, 1.05 * bore))]
    way.append((steps[-1][1], bore))
    return Solid(tuple([*way, way[0]] if bore else way))


def turned(rings: Sequence[tuple[float, float, float, float]]) -> Solid:
    """Return a ring of stretches with bores and outsides of their own.

    Args:
        rings: Start, end, radius of the bore and outer radius of each, without gaps [m].
    """
    way = [point for start, end, _, outer in rings for point in ((start, outer), (end, outer))]
    way += [point for start, end, bore, _ in reversed(rings) for point in ((end, bore), (start, bore))]
    return Solid((*way, way[0]))


def bearing(bore: float, outer: float, width: float) -> Solid:
    """Return the envelope of a bearing: two rings, and between them what rolls.

    Args:
        bore: Radius [m].
        outer: Radius [m].
        width: [m].
    """
    section, half = outer - bore, width / 2.0
    radii = (bore, bore + RING * section, outer - RING * section, outer)
    inner = half * (1.0 - 2.0 * RECESS)
    way = [(-half, radii[0]), (-half, radii[1]), (-inner, radii[1]), (-inner, radii[2]), (-half, radii[2]),
           (-half, radii[3]), (half, radii[3]), (half, radii[2]), (inner, radii[2]), (inner, radii[1]),
           (half, radii[1]), (half, radii[0]), (-half, radii[0])]  # fmt: skip
    return Solid(tuple(way))


def block(width: float, depth: float, length: float) -> Solid:
    """Return a block about the axis.

    Args:
        width: Along y [m].
        depth: Along x [m].
        length: Along the axis [m].
    """
    around = (
        (1, -1),
        (1, 0),
        (1, 1),
        (0, 1),
        (-1, 1),
        (-1, 0),
        (-1, -1),
        (0, -1),
    )  # sides have middles: they are no arcs
    corners = 0.5 * np.array([complex(depth * x, width * y) for x, y in around])
    loop = Loop(np.abs(corners), np.unwrap(np.angle(corners)), np.arange(len(around)) % 2 == 0)
    blank = Blank(abs(corners[0]), 0.0, 0.0, 0.0, length, length)
    return disc_gear(loop, [(-length / 2.0, 0.0), (length / 2.0, 0.0)], blank)


# ----------------------------------------------------------------------------------------------------------------------
# Plates of carriers: a hub with arms that end in eyes around pins, and that carry bridges.
# ----------------------------------------------------------------------------------------------------------------------


SAMPLES = 1440
"""Rays by which the area of an outline is taken [-]."""
LEAST_CORNERS = 4
"""Corners around half of an eye, at least [-]."""
SAME_RAY = 1e-7
"""Rays that are nearer to each other are one [rad]."""
TURNED = math.radians(105.0)
"""Of an eye that corners lie on, to both sides of its outermost point [rad]."""
SHARP = 30.0
"""Exponent by which an outline goes from one arm over to the next without a corner: they meet 2.3 % further out [-]."""
_HALVINGS = 30


class Arm(NamedTuple):
    """What a plate reaches out to, away from its axis."""

    angle: float
    """[rad]"""
    radius: float
    """Of the middle of its end, about the axis [m]."""
    half: float
    """Half of its width; of an eye its radius [m]."""
    inner: float = 0.0
    """Where what it carries begins, about the axis, of one that ends square [m]."""
    is_round: bool = True
    """Whether it ends in an eye around a pin; else square, beyond a bridge."""


class Outline(NamedTuple):
    """What a plate is cut to."""

    reach: float
    """Outer radius [m]."""
    bore: float
    """Radius of the hole for shafts; 0: none [m]."""
    fill: float
    """Share of the disc that is left, holes for pins not counted [-]."""


class Form(NamedTuple):
    """The outline of a plate: arms over a hub that leaves as much as is asked."""

    arms: tuple[Arm, ...]
    reach: float
    """Outer radius [m]."""
    hub: float
    """Its radius over the outer one [-]."""
    stem: float
    """Width of arms between the hub and what they hold over that of their ends [-]."""

    def radii(self, angles: Floats) -> Floats:
        """Return the outline about its axis [m], shape (n,).

        Args:
            angles: [rad], shape (n,).
        """
        return np.asarray(self.reach * _joined(_powers(self.arms, angles, self.reach, self.stem), self.hub))


def plate_form(arms: Sequence[Arm], outline: Outline, angles: Floats | None = None) -> Form:
    """Return the outline of a plate.

    Args:
        arms: To pins and bridges.
        outline: Its sizes.
        angles: Of the corners that it is cut to, between which it is straight, rising [rad]; left out: so many that it
            is round.

    Source: rays from the axis to stadiums and rectangles; the hub's radius by halving. Where arms alone leave more than
        is asked, they are narrower between the smallest hub and what they hold, as far as rays past that allow.
    """
    reach, angles = outline.reach, circle(SAMPLES) if angles is None else angles
    left = min(outline.fill + (outline.bore / reach) ** 2, 1.0)
    if left >= 1.0:
        return Form(tuple(arms), reach, 1.0, 1.0)
    least, whole = min(1.05 * outline.bore, 0.95 * reach) / reach, _powers(arms, angles, reach, 1.0)
    if _share(_joined(whole, least), angles) <= left:
        hub = _halved(lambda hub: _share(_joined(whole, hub), angles) > left, least, 1.0)
        return Form(tuple(arms), reach, hub, 1.0)
    stem = _halved(lambda stem: _share(_joined(_powers(arms, angles, reach, stem), least), angles) > left, 0.0, 1.0)
    return Form(tuple(arms), reach, least, stem)


def _halved(is_much: Callable[[float], bool], low: float, high: float) -> float:
    """Return the most that is not too much."""
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if is_much(middle) else (middle, high)
    return low


def _powers(arms: Sequence[Arm], angles: Floats, reach: float, stem: float) -> Floats:
    """Return how far arms reach, as powers that are added up, with stems as wide as a share of their ends [-]."""
    out = [(_round_arm if arm.is_round else _square_arm)(arm, angles, stem) for arm in arms]
    return np.asarray(np.sum([(each / reach) ** SHARP for each in out], axis=0))


def _joined(powers: Floats, hub: float) -> Floats:
    """Return arms and hub as one outline, over the outer radius [-]."""
    return np.asarray(np.minimum((powers + hub**SHARP) ** (1.0 / SHARP), 1.0))


def _share(radius: Floats, angles: Floats) -> float:
    """Return the area within an outline over that of the circle around it [-]."""
    turn = np.diff(angles, append=angles[0] + 2.0 * math.pi)
    return float(np.sum(radius * following(radius) * np.sin(turn))) / (2.0 * math.pi)


def _round_arm(arm: Arm, angles: Floats, stem: float) -> Floats:
    """Return how far rays from the axis reach within an arm that ends in an eye [m]."""
    off = np.angle(np.exp(1j * (angles - arm.angle)))
    across = np.maximum(np.abs(np.sin(off)), 1e-9)
    eye = arm.radius * np.cos(off) + np.sqrt(np.maximum(arm.half**2 - (arm.radius * across) ** 2, 0.0))
    seen = arm.radius * across <= arm.half
    beside = np.abs(off) >= math.atan2(stem * arm.half, arm.radius)
    side = np.where(beside, stem * arm.half / across, 0.0)
    return _ahead(off, np.maximum(np.where(seen, eye, 0.0), side))


def _square_arm(arm: Arm, angles: Floats, stem: float) -> Floats:
    """Return how far rays from the axis reach within an arm that ends square [m]."""
    off = np.angle(np.exp(1j * (angles - arm.angle)))
    across, along = np.maximum(np.abs(np.sin(off)), 1e-9), np.maximum(np.cos(off), 1e-9)
    end = np.minimum(arm.half / across, arm.radius / along)
    within = np.abs(off) <= math.atan2(arm.half, arm.inner) + SAME_RAY  # rays through its near corners reach them
    return _ahead(off, np.where(within, end, stem * arm.half / across))


def _ahead(off: Floats, radius: Floats) -> Floats:
    """Return nothing behind the axis."""
    return np.where(np.abs(off) < math.pi / 2.0, radius, 0.0)


def plate(arms: Sequence[Arm], outline: Outline, thickness: float, *, pin: float, segments: int) -> Solid:
    """Return the plate of a carrier, with holes for its pins.

    Args:
        arms: To pins and bridges.
        outline: Its sizes.
        thickness: [m].
        pin: Radius of the pins [m].
        segments: Corners of a circle; its outline has as many, and more around eyes and beside bridges.
    """
    middles = tuple(complex(arm.radius * np.exp(1j * arm.angle)) for arm in arms if arm.is_round)
    bores, half = Bores(middles, pin), thickness / 2.0
    angles = _corners(arms, segments, bores.as_large(BORE_STEPS).rays(BORE_STEPS))
    radius = plate_form(arms, outline, angles).radii(angles)
    sections = tuple(Section(radius, angles, np.full(len(angles), place)) for place in (-half, half))
    edges: Bools = np.zeros(len(angles), dtype=bool)
    return Solid(((half, outline.bore), (-half, outline.bore)), sections, edges, bores=bores)


def _corners(arms: Sequence[Arm], segments: int, rays: Floats) -> Floats:
    """Return where an outline has corners [rad]: on the rays of bores, closer around eyes and beside bridges."""
    found, more = [], max(LEAST_CORNERS, segments // 12)
    for arm in arms:
        if arm.is_round:
            turn = np.linspace(0.0, TURNED, more)
            off = np.angle(arm.radius + arm.half * np.exp(1j * turn))
            off = off[off < math.asin(min(arm.half / arm.radius, 1.0))]
            found.append(arm.angle + np.concatenate([-off, off]))
        else:
            ends = [math.atan2(arm.half, place) for place in (arm.radius, max(arm.inner, arm.half))]
            found.append(arm.angle + np.array([-ends[1], -ends[0], ends[0], ends[1]]))
    step, angles = 2.0 * math.pi / segments, np.sort(np.mod(rays.ravel(), 2.0 * math.pi))
    middles, spans = rays[:, rays.shape[1] // 2], rays[:, -1] - rays[:, rays.shape[1] // 2]
    for these, apart in ((np.concatenate(found), 0.1 * step), (circle(segments), 0.4 * step)):
        free = np.all(_between(these, middles) > spans, axis=1)
        far = np.min(_between(these, angles), axis=1) > apart
        angles = np.sort(np.concatenate([angles, np.mod(these[free & far], 2.0 * math.pi)]))
    return angles[np.diff(angles, append=angles[0] + 2.0 * math.pi) > SAME_RAY]


def _between(these: Floats, others: Floats) -> Floats:
    """Return the angles between every one of some rays and every one of others [rad], shape (n, m)."""
    return np.asarray(np.abs(np.angle(np.exp(1j * (these[:, None] - others[None, :])))))


# ----------------------------------------------------------------------------------------------------------------------
# Screws with what is on them: coaxial rings, round or with a hexagon outside, each a closed body of its own.
# ----------------------------------------------------------------------------------------------------------------------


FEWER, LEAST = 5, 8
"""Corners of circles of the scene over those of screws, which are small, and how many these have at least [-]."""
SIDES = 6
"""Of a hexagon [-]."""


class Layer(NamedTuple):
    """A ring about z."""

    start: float
    """Along z [m]."""
    end: float
    """[m]"""
    outer: float
    """Radius; of a hexagon half the width across its flats [m]."""
    bore: float = 0.0
    """Radius; 0: none [m]."""
    is_hexagon: bool = False

    @property
    def volume(self) -> float:
        """[m³]"""
        area = 2.0 * math.sqrt(3.0) if self.is_hexagon else math.pi
        return (area * self.outer**2 - math.pi * self.bore**2) * (self.end - self.start)


class Fastener(NamedTuple):
    """A screw with nut and washers: layers that touch each other or not, none in another."""

    layers: tuple[Layer, ...]


def fastener_surface(fastener: Fastener, segments: int) -> Surface:
    """Return the triangles of a screw and of what is on it, every layer closed by itself.

    Args:
        fastener: The screw.
        segments: Corners of larger circles of the scene.
    """
    return joined([_layer(layer, max(segments // FEWER, LEAST)) for layer in fastener.layers])


def _layer(layer: Layer, corners: int) -> Surface:
    span = (layer.start, layer.end)
    outer = around(*_corner(layer), corners)[:, :2] if not layer.is_hexagon else around(*_corner(layer), SIDES)[:, :2]
    loops = [outer, *([around(layer.bore, 0.0, corners)[:, :2]] if layer.bore else [])]
    pieces = [_flat_sides(outer, span) if layer.is_hexagon else _side(outer, span, out=True)]
    pieces += [_side(loop, span, out=False) for loop in loops[1:]]
    flat, triangles = np.concatenate(loops), plane_triangles(loops)
    for place, way in zip(span, (-1.0, 1.0), strict=True):
        points = np.column_stack([flat, np.full(len(flat), place)])
        normals = np.tile([0.0, 0.0, way], (len(flat), 1))
        pieces.append(Surface(points, normals, triangles if way > 0.0 else triangles[:, ::-1]))
    return joined(pieces)


def _corner(layer: Layer) -> tuple[float, float]:
    """Return how far the corners of a layer lie from its axis, and a height for them [m]."""
    return layer.outer / math.cos(math.pi / SIDES) if layer.is_hexagon else layer.outer, 0.0


def _side(loop: Floats, span: tuple[float, float], *, out: bool) -> Surface:
    """Return a round wall, seen from outside or from inside."""
    count = len(loop)
    points = np.concatenate([np.column_stack([loop, np.full(count, place)]) for place in span])
    ways = loop / np.linalg.norm(loop, axis=1, keepdims=True) * (1.0 if out else -1.0)
    normals = np.tile(np.column_stack([ways, np.zeros(count)]), (2, 1))
    here, there = np.arange(count), following(np.arange(count))
    triangles = np.concatenate([np.stack([here, there, there + count], axis=1),
                                np.stack([here, there + count, here + count], axis=1)])  # fmt: skip
    return Surface(points, normals, triangles if out else triangles[:, ::-1])


def _flat_sides(loop: Floats, span: tuple[float, float]) -> Surface:
    """Return the flat sides of a hexagon, whose corners are edges."""
    pieces = []
    for here, there in zip(loop, following(loop), strict=True):
        points = np.array([[*here, span[0]], [*there, span[0]], [*there, span[1]], [*here, span[1]]])
        way = (here + there) / float(np.linalg.norm(here + there))
        pieces.append(Surface(points, np.tile([*way, 0.0], (4, 1)), np.array([[0, 1, 2], [0, 2, 3]])))
    return joined(pieces)
