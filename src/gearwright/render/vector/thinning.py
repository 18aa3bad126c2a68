"""Curves as a pixel shows them: extremes of every column, and of paths that turn back every stretch once."""

from __future__ import annotations

import numpy as np

from gearwright.arrays import Floats

COLUMN = 0.26
"""Width of a column on paper [mm]: a pixel of a page, of which 96 make an inch."""
GRAIN = 0.3
"""Distance of points on paper that look like one [mm]."""
PASSES, FEWEST, HAIR_STEPS = 12, 4, 1.5
"""Looks for points on a line, points of a path that is left as it is, and steps beside the line that look straight."""
BANDS = 400
"""Stretches of a band."""
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


def band(x: Floats, rows: Floats) -> tuple[Floats, Floats, Floats]:
    """Return places, and the least and greatest of all rows between two of them.

    Args:
        x: Rising, shape (points,).
        rows: Shape (points, rows).
    """
    starts = np.unique(np.linspace(0, len(x), BANDS + 1, dtype=int)[:-1])
    low, high = np.fmin.reduceat(rows, starts).min(axis=1), np.fmax.reduceat(rows, starts).max(axis=1)
    return np.append(x[starts], x[-1]), np.append(low, low[-1]), np.append(high, high[-1])


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


def straightened(grid: Floats) -> Floats:
    """Return a path without the points that stand on the line between their neighbours, or a hair beside it.

    Args:
        grid: Shape (points, 2), whole steps.
    """
    if len(grid) < FEWEST:
        return grid
    grid = grid[np.concatenate([[True], np.any(np.diff(grid, axis=0) != 0.0, axis=1)])]
    for turn in range(PASSES):
        if len(grid) < FEWEST:
            break
        before, at, after = grid[:-2], grid[1:-1], grid[2:]
        along, off = after - before, at - before
        length = np.hypot(along[:, 0], along[:, 1])
        ahead = np.sum(along * off, axis=1)
        beside = np.abs(along[:, 0] * off[:, 1] - along[:, 1] * off[:, 0])
        on_it = (beside <= HAIR_STEPS * length) & (ahead > 0.0) & (ahead < length**2)
        on_it[turn % 2 :: 2] = False
        if not on_it.any() and turn % 2:
            break
        grid = grid[np.concatenate([[True], ~on_it, [True]])]
    return grid
