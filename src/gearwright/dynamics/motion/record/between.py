"""Between: how far line forces reach between the outermost steps of a run, where rows stand on one side only."""

from __future__ import annotations

from functools import cache

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.codegen import BEFORE, lagrange

END = np.linspace(0.0, BEFORE, 16 * BEFORE + 1)
"""Where crests are looked for beside the first and last instants, in intervals from the end."""


@cache
def outer_ways(count: int) -> Floats:
    """Return the weights of so many rows from an end at the places of `END`, and those of all but the last row.

    Args:
        count: Rows; of a single one nothing is told.

    Returns:
        Shape (2, places, rows).
    """
    if count < 2:
        return np.zeros((2, 0, count))
    nodes = np.arange(float(count))
    here = END[nodes[-1] >= END]
    through, less = (np.array([lagrange(nodes[:past], theta) for theta in here]) for past in (count, count - 1))
    return np.array([through, np.pad(less, ((0, 0), (0, 1)))])
