"""Outlines of all teeth of a cylindrical gear, swept along its axis, and the bodies under them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats
from gearwright.parts.gears import Blank
from gearwright.shape.solids.holes import Holes
from gearwright.shape.solids.solid import Section, Solid

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
