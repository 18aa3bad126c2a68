"""Marks: deflections of lines with backlash at instants that runs at a half or a quarter of a step share."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats

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


class Marks(NamedTuple):
    """Deflections at evenly spaced instants, a power of two of steps apart."""

    spacing: float
    """[s]."""
    rows: Floats
    """Shape (marks, lines)."""

    def apart(self, other: Marks) -> Apart:
        """Return how far the runs are from each other.

        Args:
            other: Of the same motion at another step, a power of two of this one's.
        """
        factor = other.spacing / self.spacing
        mine, its = self.rows[:: max(1, round(factor))], other.rows[:: max(1, round(1.0 / factor))]
        count = min(len(mine), len(its))
        away, covered = np.abs(mine[:count] - its[:count]), np.ptp(mine[:count], axis=0)
        return Apart(
            _largest_share(np.max(away, axis=0), covered),
            _largest_share(np.sqrt(np.mean(away**2, axis=0)), np.sqrt(np.mean(mine[:count] ** 2, axis=0))),
        )


def stride_of(steps: int) -> int:
    """Return the steps between marks: a power of two, so that runs at a half or a quarter of a step share them.

    Args:
        steps: Of the run.
    """
    return int(1 << max(0, -(-steps // MOST) - 1).bit_length())


def _largest_share(part: Floats, whole: Floats) -> float:
    return float(np.max(np.divide(part, whole, out=np.zeros_like(part), where=whole > 0.0), initial=0.0))
