"""Instants: how fast a system runs, and the stiffness and error of each of its lines, at many times at once."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.model import Arrays, Profile, Series, System


def speed_factors(profile: Profile, time: Floats) -> tuple[Floats, Floats, Floats]:
    """Return s [-], ṡ [1/s] and τ [s] at many times; `reference.speed_factor` does it for one.

    Args:
        profile: Speed factor against time.
        time: Rising [s], shape (times,).
    """
    t, s = profile.time, profile.factor
    factor, slope, travel = np.empty((3, len(time)))
    first, last = (int(np.searchsorted(t, end, side="right")) - 1 for end in (time[0], time[-1]))
    cuts = [0, *np.searchsorted(time, t[first + 1 : last + 1]).tolist(), len(time)]
    for piece, (low, high) in zip(range(first, last + 1), pairwise(cuts), strict=True):
        i = max(piece, 0)
        elapsed = time[low:high] - t[i]
        rate = (s[i + 1] - s[i]) / (t[i + 1] - t[i]) if 0 <= piece < len(t) - 1 else 0.0
        factor[low:high], slope[low:high] = s[i] + rate * elapsed, rate
        travel[low:high] = profile.travel[i] + 0.5 * (s[i] + factor[low:high]) * elapsed
    return factor, slope, travel


def stiffness_at(system: System, time: Floats) -> Floats:
    """Return the stiffnesses of all lines at some instants [N/m or N m/rad], shape (instants, lines).

    Args:
        system: Whose lines.
        time: [s], shape (instants,).
    """
    arrays = system.arrays
    _, _, travel = speed_factors(arrays.profile, time)
    return np.asarray(arrays.stiffness * (1.0 + _series(arrays, arrays.variation, travel)))


def errors_at(system: System, time: Floats) -> Floats:
    """Return the errors of all lines at some instants [m or rad], shape (instants, lines).

    Args:
        system: Whose errors.
        time: [s], shape (instants,).
    """
    _, _, travel = speed_factors(system.arrays.profile, time)
    return _series(system.arrays, system.arrays.error, travel)


def _series(arrays: Arrays, series: Series, travel: Floats) -> Floats:
    """Fourier sums of all lines at many travels, shape (travels, lines)."""
    lines = len(series.start) - 1
    angle = np.outer(travel, arrays.tone_rate)
    cosine, sine = np.zeros((2, angle.shape[1], lines))
    line = np.repeat(np.arange(lines), np.diff(series.start))
    np.add.at(cosine, (series.tone, line), series.cosine)
    np.add.at(sine, (series.tone, line), series.sine)
    return np.asarray(np.cos(angle) @ cosine + np.sin(angle) @ sine)
