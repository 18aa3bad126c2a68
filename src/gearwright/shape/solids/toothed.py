"""Toothed walls and the bodies under them: a loop of all teeth swept along the axis, closed by a body of revolution."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats
from gearwright.parts.gears import Blank
from gearwright.shape.solids.surface import Surface, around_hole, circle, joined, revolved, strip

SAME = 1e-9
"""Angle between two points that are one [rad]."""


class Loop(NamedTuple):
    """A closed outline about the axis, counter-clockwise, tooth 0 about the angle 0."""

    radius: Floats
    """[m], shape (n,)"""
    angle: Floats
    """[rad], shape (n,)"""
    edges: Bools
    """Where it has a corner, shape (n,)."""


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
    if one[0] + pitch - one[-1] < SAME:  # a fully rounded root: the fillets of two teeth meet in one point
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
    along = np.roll(places, -1, axis=1) - places
    axial = np.gradient(places, axis=0) if levels > 1 else np.zeros_like(places)
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


def cap(outer: Section, inner: Section, normal: tuple[float, float], *, up: bool) -> Surface:
    """Return the face between two loops at one end of a body.

    Args:
        outer: The outer loop.
        inner: The inner one.
        normal: Of the face, along the axis and outwards from it [-].
        up: Whether it looks along +z.
    """
    angle = np.concatenate([outer.angle, inner.angle])
    turned = []
    for section in (outer, inner):
        lead = np.mod(section.angle[0] + np.pi, 2.0 * np.pi) - np.pi
        turned.append(section.angle - section.angle[0] + lead)
    triangles = strip(*turned)
    points = np.concatenate([outer.points, inner.points])
    normals = np.stack([normal[1] * np.cos(angle), normal[1] * np.sin(angle), np.full(len(angle), normal[0])], axis=1)
    return Surface(points, normals, triangles if up else triangles[:, ::-1])


def ring_of(radius: float, height: float, segments: int) -> Section:
    """Return a circle as a section.

    Args:
        radius: [m].
        height: z [m].
        segments: How many corners.
    """
    return Section(np.full(segments, radius), circle(segments), np.full(segments, height))


def inner_profile(blank: Blank) -> list[tuple[float, float]]:
    """Return the way along the inside of a gear's body from its upper face to its lower one, z and radius [m].

    Args:
        blank: Its radii and widths; where rim and hub meet, its bore alone.
    """
    half, web = blank.width / 2.0, blank.web_width / 2.0
    if blank.is_solid:
        return [(half, blank.bore_radius), (-half, blank.bore_radius)]
    rim, hub, bore = blank.rim_radius, blank.hub_radius, blank.bore_radius
    upper = [(half, rim), (web, rim), (web, hub), (half, hub), (half, bore)]
    return [*upper, *((-place, radius) for place, radius in reversed(upper))]


def disc_gear(loop: Loop, levels: Sequence[tuple[float, float]], blank: Blank, segments: int) -> Surface:
    """Return an external gear with its body.

    Args:
        loop: Its outline.
        levels: Place along the axis [m] and turn [rad] of its sections, from −b/2 to b/2.
        blank: The body under the teeth.
        segments: Corners of its circles.
    """
    bore = around_hole(blank.bore_radius, segments)
    blank = blank._replace(bore_radius=bore, hub_radius=max(blank.hub_radius, bore))
    sections, profile = sections_of(loop, levels), inner_profile(blank)
    ends = [cap(sections[end], ring_of(profile[0][1], float(sections[end].height[0]), segments), (sign, 0.0), up=up)
            for end, sign, up in ((-1, 1.0, True), (0, -1.0, False))]  # fmt: skip
    return joined([wall(sections, loop.edges), *ends, revolved(profile, segments)])


def ring_gear(loop: Loop, levels: Sequence[tuple[float, float]], outside: float, segments: int) -> Surface:
    """Return an internal gear with its wall.

    Args:
        loop: Its outline.
        levels: Place along the axis [m] and turn [rad] of its sections.
        outside: Its outer radius [m].
        segments: Corners of its outer circle.
    """
    sections = sections_of(loop, levels)
    low, high = (float(sections[end].height[0]) for end in (0, -1))
    ends = [cap(ring_of(outside, height, segments), sections[end], (sign, 0.0), up=up)
            for end, height, sign, up in ((-1, high, 1.0, True), (0, low, -1.0, False))]  # fmt: skip
    outer = revolved([(low, outside), (high, outside)], segments)
    return joined([wall(sections, loop.edges, inside=True), *ends, outer])
