"""What a method finds: the probability of failure, how sure it is, and the likeliest failure of every limit."""

from __future__ import annotations

import math
from statistics import NormalDist
from typing import NamedTuple

from gearwright.arrays import Floats

NORMAL_95 = 1.959963984540054
"""Two-sided 95 % point of the normal distribution [-]."""


class Point(NamedTuple):
    """The likeliest failure of one limit: the point nearest to the origin of standard normal space where it breaks."""

    place: Floats
    """Standard normal coordinates, shape (axes,) [-]; not finite where no failure is known."""
    probability: float
    """That this limit breaks [-]: to first order, or as counted."""
    settled: bool
    """False if a search for it did not come to rest."""


class Estimate(NamedTuple):
    """The probability that any limit breaks."""

    probability: float
    """Of failure [-]."""
    interval: tuple[float, float]
    """Between which it lies with 95 % confidence [-]."""
    points: tuple[Point, ...]
    """Of every limit."""
    settled: bool
    """False if the evaluations did not suffice, so that the probability is below what is said."""


def index_of(probability: float) -> float:
    """Return the reliability index β = −Φ⁻¹(p) [-].

    Args:
        probability: Of failure, from 0 to 1 [-]; 0 gives infinity.

    Source: Hasofer, Lind 1974, J. Eng. Mech. Div. 100 (1), 111-121.

    >>> round(index_of(1e-6), 3)
    4.753
    """
    if not 0.0 < probability < 1.0:
        return math.inf if probability <= 0.0 else -math.inf
    return -NormalDist().inv_cdf(probability)


def chance_beyond(index: float) -> float:
    """Return Φ(−β), the probability beyond a plane at a distance from the origin [-].

    Args:
        index: The distance β [-].

    >>> round(chance_beyond(4.753424) * 1e6, 4)
    1.0
    """
    return 0.5 * math.erfc(index / math.sqrt(2.0))


def interval_of(probability: float, variation: float) -> tuple[float, float]:
    """Return the 95 % interval of an estimate whose logarithm is taken as normal [-].

    Args:
        probability: Estimated [-].
        variation: Its coefficient of variation [-].
    """
    half = NORMAL_95 * math.sqrt(math.log1p(variation**2))
    return probability * math.exp(-half), min(1.0, probability * math.exp(half))
