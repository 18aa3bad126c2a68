"""Hardness of steel in one scale from another: Vickers, Brinell, Rockwell C."""

from __future__ import annotations

import numpy as np

BRINELL_PER_VICKERS = 0.95
"""HB over HV [-] (ISO 18265:2013, table A.1)."""
ROCKWELL = (
    20.3, 22.2, 24.0, 25.6, 27.1, 28.5, 29.8, 31.0, 32.2, 33.3, 34.4, 35.5, 36.6, 37.7, 38.8, 39.8, 40.8, 41.8, 42.7,
    43.6, 44.5, 45.3, 46.1, 46.9, 47.7, 48.4, 49.1, 49.8, 50.5, 51.1, 51.7, 52.3, 53.0, 53.6, 54.1, 54.7, 55.2, 55.7,
    56.3, 56.8, 57.3, 57.8, 58.3, 58.8, 59.2, 59.7, 60.1, 61.0, 61.8, 62.5, 63.3, 64.0, 64.7, 65.3, 65.9, 66.4, 67.0,
    67.5, 68.0,
)  # fmt: skip
"""HRC at each of `VICKERS` (ISO 18265:2013, table A.1: unalloyed and low-alloy steels)."""
VICKERS = (*range(240, 701, 10), *range(720, 941, 20))
"""HV [-]."""


def vickers_of_rockwell(hardness: float) -> float:
    """Return the Vickers hardness HV of steel with a Rockwell hardness C.

    Args:
        hardness: HRC [-].

    Source: ISO 18265:2013, table A.1, unalloyed and low-alloy steels; linear between its rows.
    Valid for: 20.3 to 68 HRC.

    >>> round(vickers_of_rockwell(60.1)), round(vickers_of_rockwell(61.0))
    (700, 720)
    """
    if not ROCKWELL[0] <= hardness <= ROCKWELL[-1]:
        raise ValueError(f"{hardness:g} HRC; ISO 18265 converts {ROCKWELL[0]:g} to {ROCKWELL[-1]:g}")
    return float(np.interp(hardness, ROCKWELL, VICKERS))
