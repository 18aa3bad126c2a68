"""What samples of equal weight say of the limits: how often each breaks, and the likeliest failure among them."""

from __future__ import annotations

import numpy as np

from gearwright.arrays import Floats
from gearwright.study.reliability.estimate import Point


def from_samples(places: Floats, left: Floats, probability: float) -> tuple[Point, ...]:
    """Return the likeliest failure of every limit among samples, the nearest to the origin.

    Args:
        places: Standard normal coordinates, shape (samples, axes) [-].
        left: What is left of every limit, shape (samples, limits): at 0 and below it is broken [-].
        probability: That any limit breaks [-].
    """
    broken = left <= 0.0
    failures = max(int(broken.any(axis=1).sum()), 1)
    points = []
    for own in broken.T:
        failing = np.flatnonzero(own)
        if not len(failing):
            points.append(Point(np.full(places.shape[1], np.inf), 0.0, settled=True))
            continue
        nearest = failing[np.argmin(np.sum(places[failing] ** 2, axis=1))]
        points.append(Point(places[nearest], probability * len(failing) / failures, settled=True))
    return tuple(points)
