"""Long histories for a screen: of every stretch its lowest and its highest value, so that no peak is lost."""

from __future__ import annotations

import numpy as np

from gearwright.arrays import Floats

MOST = 12_000
"""Instants that a page draws, several to a pixel of any screen [-]."""


def instants(time: Floats, *, most: int = MOST) -> Floats:
    """Return the instants of a thinned history: where every stretch begins, and its middle.

    Args:
        time: Of the history.
        most: Instants that may stay; as many or fewer stay as they are.

    Returns:
        Instants, at most `most`.
    """
    if len(time) <= most:
        return time
    length = _length(len(time), most)
    missing = np.arange(1.0, -len(time) % length + 1.0)  # of the last stretch, which goes on in equal steps
    stretches = np.concatenate([time, time[-1] + missing * (time[-1] - time[-2])]).reshape(-1, length)
    return stretches[:, [0, stretches.shape[1] // 2]].ravel()


def extremes(values: Floats, *, most: int = MOST) -> Floats:
    """Return the lowest and the highest value of every stretch, in the order in which they come.

    Args:
        values: Of a history, at its instants.
        most: Instants that may stay; as many or fewer stay as they are.

    Returns:
        Values at `instants`.

    >>> extremes(np.array([0.0, 0.0, 9.0, 1.0, 2.0, -3.0, 2.0, 2.0]), most=4)
    array([ 0.,  9.,  2., -3.])
    """
    if len(values) <= most:
        return values
    stretches = _stretches(values, most)
    places = np.sort(np.stack([stretches.argmin(axis=1), stretches.argmax(axis=1)], axis=1), axis=1)
    return np.take_along_axis(stretches, places, axis=1).ravel()


def _stretches(values: Floats, most: int) -> Floats:
    """Return values in rows of equal length; the last row is filled with the last value."""
    length = _length(len(values), most)
    return np.pad(values, (0, -len(values) % length), mode="edge").reshape(-1, length)


def _length(count: int, most: int) -> int:
    """Return how many instants a stretch has, of which two are drawn."""
    return -(-count // (most // 2))
