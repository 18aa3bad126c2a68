"""What a solid is made of: a way about the axis, and the toothed walls between its ends; and its triangles."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats, Ints
from gearwright.shape.solids.holes import Bores, Holes, bored_ends, pierced
from gearwright.shape.solids.surface import Surface, around_hole, circle, joined, revolved, strip


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
