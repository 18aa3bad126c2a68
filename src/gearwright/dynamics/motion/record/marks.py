"""Marks: deflections of lines with backlash at instants that runs at a half or a quarter of a step share."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats, Ints

MOST = 1024
"""Marks that are kept."""


class Apart(NamedTuple):
    """How far two runs of one motion are from each other on the way, of the line that they differ by most."""

    most: float
    """Largest distance of the deflections over what the deflection covers [-]."""
    rms: float
    """Root mean square of the distance over that of the deflection [-]."""


TOGETHER = Apart(0.0, 0.0)
"""Of runs that lose no contact."""


class Marks:
    """Deflections at evenly spaced instants, a power of two of steps apart."""

    def __init__(self, columns: Ints, step: float, steps: int) -> None:
        self.columns, self.stride = columns, 1
        while self.stride * MOST < steps:
            self.stride *= 2
        self.spacing = self.stride * step
        self.rows: list[Floats] = []

    def take(self, first: int, record: Floats) -> None:
        """Take a block of rows.

        Args:
            first: Step of the first.
            record: Shape (steps, columns).
        """
        if len(self.columns):
            self.rows.append(record[-first % self.stride :: self.stride, self.columns])

    def apart(self, other: Marks) -> Apart:
        """Return how far the runs are from each other.

        Args:
            other: Of the same motion at another step, a power of two of this one's.
        """
        factor = other.spacing / self.spacing
        mine = np.concatenate(self.rows)[:: max(1, round(factor))]
        its = np.concatenate(other.rows)[:: max(1, round(1.0 / factor))]
        count = min(len(mine), len(its))
        away, covered = np.abs(mine[:count] - its[:count]), np.ptp(mine[:count], axis=0)
        return Apart(
            _largest_share(np.max(away, axis=0), covered),
            _largest_share(np.sqrt(np.mean(away**2, axis=0)), np.sqrt(np.mean(mine[:count] ** 2, axis=0))),
        )


def _largest_share(part: Floats, whole: Floats) -> float:
    return float(np.max(np.divide(part, whole, out=np.zeros_like(part), where=whole > 0.0), initial=0.0))
