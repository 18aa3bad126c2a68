"""Curves as a pixel shows them: extremes of every column, and of paths that turn back every stretch once."""

from __future__ import annotations

import numpy as np

from gearwright.arrays import Floats

COLUMN = 0.26
"""Width of a column on paper [mm]: a pixel of a page, of which 96 make an inch."""
GRAIN = 0.2
"""Distance of points on paper that look like one [mm]."""
FEW = 400
"""Points of a curve that is left as it is."""


def thinned(points: Floats) -> list[Floats]:
    """Return a curve on paper as pieces that look the same.

    Args:
        points: Shape (points, 2) [mm]; not a number parts the curve.
    """
    good = np.all(np.isfinite(points), axis=1)
    if not good.all():
        edges = np.flatnonzero(np.diff(good.astype(int))) + 1
        pieces = [piece for piece, fine in zip(np.split(points, edges), np.split(good, edges), strict=True) if fine[0]]
        return [part for piece in pieces for part in thinned(piece)]
    if len(points) <= FEW:
        return [points] if len(points) else []
    if np.all(np.diff(points[:, 0]) >= 0.0):
        return [extremes(points)]
    return distinct(points)


def extremes(points: Floats) -> Floats:
    """Return the lowest and highest point of every column of a curve that runs to the right.

    Args:
        points: Shape (points, 2) [mm].
    """
    column = np.floor((points[:, 0] - points[0, 0]) / COLUMN)
    starts = np.flatnonzero(np.diff(column, prepend=-1.0))
    if 2 * len(starts) >= len(points):
        return points
    ends = np.append(starts[1:], len(points))
    kept = {0, len(points) - 1}
    for start, end in zip(starts.tolist(), ends.tolist(), strict=True):
        y = points[start:end, 1]
        kept.update((start + int(np.argmin(y)), start + int(np.argmax(y))))
    return points[sorted(kept)]


def distinct(points: Floats) -> list[Floats]:
    """Return the stretches of a path that do not lie on others, on a fine grid.

    Args:
        points: Shape (points, 2) [mm].
    """
    grid = np.round(points / GRAIN).astype(np.int64)
    moved = np.any(np.diff(grid, axis=0, prepend=grid[:1] - 1) != 0, axis=1)
    kept, grid = points[moved], grid[moved]
    key = (grid[:, 0] << 32) + grid[:, 1]
    pairs = np.sort(np.stack([key[:-1], key[1:]], axis=1), axis=1)
    _, first = np.unique(pairs, axis=0, return_index=True)
    new = np.zeros(len(pairs), dtype=bool)
    new[first] = True
    pieces = []
    edges = np.flatnonzero(np.diff(new.astype(int))) + 1
    for part in np.split(np.arange(len(new)), edges):
        if len(part) and new[part[0]]:
            pieces.append(kept[part[0] : part[-1] + 2])
    return pieces
