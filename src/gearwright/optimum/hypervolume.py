"""Hypervolume: the room that a front dominates, up to a point that everything good is better than."""

from __future__ import annotations

import numpy as np

from gearwright.arrays import Floats
from gearwright.study.answers import non_dominated

EXACT = 3
"""Objectives up to which it is exact [-]."""
POINTS = 16384
"""Points of the unit cube by which it is estimated for more [-]."""


def hypervolume(values: Floats, reference: Floats) -> float:
    """Return the volume that points dominate below a reference: exact for up to three objectives, else by points.

    Args:
        values: Objectives to be made small, shape (points, objectives).
        reference: Largest value of each that counts, shape (objectives,).

    Returns:
        In the product of their units; for more than three objectives within a per cent or so of the whole box.

    Source: Fonseca, Paquete, López-Ibáñez 2006, IEEE CEC, 1157-1163: sweep along the last objective.

    >>> hypervolume(np.array([[1.0, 2.0], [2.0, 1.0]]), np.array([3.0, 3.0]))
    3.0
    """
    inside = values[(values < reference).all(axis=1)]
    if not len(inside):
        return 0.0
    front = np.unique(inside[non_dominated(inside, np.zeros(len(inside)))], axis=0)
    if front.shape[1] > EXACT:
        return _estimated(front, reference)
    return _swept(front, reference)


def _swept(front: Floats, reference: Floats) -> float:
    """Return the volume slice by slice along the last objective."""
    if front.shape[1] == 1:
        return float(reference[0] - front[:, 0].min())
    if front.shape[1] == 2:
        lowest = np.minimum.accumulate(front[:, 1])  # sorted along the first
        return float((np.append(front[1:, 0], reference[0]) - front[:, 0]) @ (reference[1] - lowest))
    order = np.argsort(front[:, -1], kind="stable")
    heights = np.append(front[order, -1], reference[-1])
    total = 0.0
    for k in range(len(order)):
        if heights[k + 1] > heights[k]:
            total += (heights[k + 1] - heights[k]) * _swept(
                np.unique(front[order[: k + 1], :-1], axis=0), reference[:-1]
            )
    return float(total)


def _estimated(front: Floats, reference: Floats) -> float:
    """Return the part of points of the box between the best of each objective and the reference, times its volume."""
    best = front.min(axis=0)
    points = best + (reference - best) * np.random.default_rng(0).random((POINTS, front.shape[1]))
    dominated = np.zeros(len(points), dtype=bool)
    for own in front:
        dominated |= (points >= own).all(axis=1)
    return float(dominated.mean() * np.prod(reference - best))
