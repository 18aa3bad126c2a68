"""Loops around the cross-sections of a housing, each n·p ≤ h in every direction n."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from gearwright.arrays import Floats, following
from gearwright.sizing.casing.shell import Stretch, outline_of

SAME = 1e-4
"""Steps of a wall that are less are none [m]."""
GAP = 5e-4
"""Between a wall and the end of what stands square to it, at least [m], an assumption."""
NEAR = 1e-7
"""Corners that are nearer are one [m]."""


def inside_of(own: Stretch, wall: float) -> Floats:
    """Return how far the inside of a wall is: the wall's middle where it is weighed, where there is room for it [m].

    Args:
        own: The cross-section.
        wall: Thickness [m].
    """
    corners = loop_around(own.reach - wall / 2.0)
    if not len(corners):  # a wall thicker than the room is wide
        return np.asarray(own.least + GAP)
    return np.asarray(np.maximum(np.max(corners @ ways_of(len(own.reach)).T, axis=0), own.least + GAP))


@lru_cache(maxsize=4)
def ways_of(count: int) -> Floats:
    """Return equally spaced directions from y on [-], shape (n, 2).

    Args:
        count: How many.
    """
    angle = 2.0 * math.pi * np.arange(count) / count
    return np.stack([np.cos(angle), np.sin(angle)], axis=1)


def fits(reach: Floats, middle: Floats, radius: float) -> bool:
    """Tell whether a circle lies in a cross-section; of a negative radius, whether any of it does.

    Args:
        reach: h of the cross-section in every direction [m].
        middle: Of the circle [m].
        radius: Of the circle [m].
    """
    return bool(np.all(ways_of(len(reach)) @ middle + radius < reach))


def loop_size(reach: Floats) -> tuple[float, float]:
    """Return perimeter [m] and area [m²] of the polygon n·p ≤ h.

    Args:
        reach: h in every direction [m].
    """
    loop = loop_around(reach)
    after = following(loop)
    area = float(np.sum(loop[:, 0] * after[:, 1] - loop[:, 1] * after[:, 0]) / 2.0)
    return float(np.sum(np.linalg.norm(after - loop, axis=1))), area


def loop_around(reach: Floats) -> Floats:
    """Return the corners of the polygon n·p ≤ h, also where some of its sides lie outside of others [m], shape (n, 2).

    None where nothing lies within all sides.

    Args:
        reach: h in every direction [m].
    """
    loop, ways = outline_of(reach), ways_of(len(reach))
    if np.all(loop @ ways.T <= reach + NEAR):
        return _cleaned(loop)
    wide = 2.0 * float(np.max(np.abs(reach)))
    corners = [complex(wide, -wide), complex(wide, wide), complex(-wide, wide), complex(-wide, -wide)]
    for way, limit in zip((ways[:, 0] - 1j * ways[:, 1]).tolist(), reach.tolist(), strict=True):
        far = [(corner * way).real - limit for corner in corners]
        if not far:
            return np.empty((0, 2))
        if max(far) <= 0.0:
            continue
        kept: list[complex] = []
        for here, there, corner, onward in zip(
            far, [*far[1:], far[0]], corners, [*corners[1:], corners[0]], strict=True
        ):
            if here <= 0.0:
                kept.append(corner)
            if (here < 0.0 < there) or (there < 0.0 < here):
                kept.append(corner + here / (here - there) * (onward - corner))
        corners = kept
    loop = np.array([[corner.real, corner.imag] for corner in corners])
    return _cleaned(loop)


def _cleaned(loop: Floats) -> Floats:
    """Return a loop with one corner where several coincide."""
    return np.asarray(loop[np.linalg.norm(loop - np.concatenate([loop[-1:], loop[:-1]]), axis=1) > NEAR])
