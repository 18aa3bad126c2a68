"""Importance sampling about the likeliest failures: what the first order leaves out is counted."""

from __future__ import annotations

from collections.abc import Generator, Sequence

import numpy as np

from gearwright.arrays import Bools, Floats
from gearwright.study.reliability.estimate import Estimate, Point, interval_of

PLAIN = 0.1
"""Part of the draws that are about the origin: failures that no search found are not missed for sure [-]."""
LEAST_WEIGHT = 0.05
"""Least part of the other draws that each likeliest failure has, before they are made to add up to one [-]."""


def importance(
    points: Sequence[Point], axes: int, count: int, generator: np.random.Generator
) -> Generator[Floats, Floats, Estimate]:
    """Yield draws about the likeliest failures; send what is left of every limit there, and get the estimate.

    Args:
        points: The likeliest failure of every limit, as `first_order` gives them.
        axes: Coordinates [-].
        count: Draws [-].
        generator: Of random numbers.

    Source: Schuëller, Stix 1987, Struct. Saf. 4, 293-309; a mixture of normal densities, one about each point:
        Melchers 1989, Struct. Saf. 6, 3-10.
    """
    centres, weights = _mixture(points, axes)
    which = generator.choice(len(weights), size=count, p=weights)
    drawn = centres[which] + generator.standard_normal((count, axes))
    broken: Bools = (yield drawn) <= 0.0
    ratio = _ratio(drawn, centres, weights)
    parts = ratio * broken.any(axis=1)
    probability = float(parts.mean())
    settled = all(point.settled for point in points)
    if not probability:
        return Estimate(0.0, (0.0, float(3.0 * ratio.max() / count)), tuple(points), settled=False)
    variation = float(parts.std(ddof=1)) / probability / np.sqrt(count)
    return Estimate(probability, interval_of(probability, float(variation)), tuple(points), settled)


def _mixture(points: Sequence[Point], axes: int) -> tuple[Floats, Floats]:
    known = [point for point in points if np.isfinite(point.place).all() and point.probability < 0.5]
    if not known:
        return np.zeros((1, axes)), np.ones(1)
    likely = np.array([point.probability for point in known])
    shares = np.maximum(likely / max(likely.sum(), np.finfo(float).tiny), LEAST_WEIGHT)
    weights = np.concatenate([[PLAIN], (1.0 - PLAIN) * shares / shares.sum()])
    return np.vstack([np.zeros(axes), *(point.place for point in known)]), weights


def _ratio(drawn: Floats, centres: Floats, weights: Floats) -> Floats:
    """Return the density of what may come over that of the draws [-]."""
    towards = drawn @ centres.T - 0.5 * np.sum(centres**2, axis=1)
    ratio: Floats = 1.0 / (np.exp(towards) @ weights)
    return ratio
