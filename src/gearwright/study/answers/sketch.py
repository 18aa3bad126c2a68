"""Quantiles of any number of values in the room of some hundred counts, the same whatever the order they came in.

Source: logarithmic buckets of Masson, Rim, Lee 2019, DDSketch, Proc. VLDB Endow. 12 (12), 2195-2205: a quantile is off
by no more than the relative accuracy that was asked, and sketches of parts add up to that of the whole.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from gearwright.arrays import Floats, Ints

ACCURACY = 0.005
"""Relative, of a quantile [-]."""
_GROWTH = (1.0 + ACCURACY) / (1.0 - ACCURACY)
_TINY = 1e-300
"""Magnitude up to which a value is zero."""
_BELOW, _ABOVE = -(1 << 40), 1 << 40
"""Buckets of minus and plus infinity."""
_MIDDLE = 1 << 20
"""Bucket of zero lies between those of negative and positive numbers, whose logarithms are below this in magnitude."""


def buckets(values: Floats) -> Ints:
    """Return the bucket of every value, in the order of the values.

    Args:
        values: Numbers or infinities, shape (values,).
    """
    size = np.abs(values)
    with np.errstate(divide="ignore", invalid="ignore"):
        steps = np.where(size > _TINY, np.ceil(np.log(size) / math.log(_GROWTH)) + _MIDDLE, 0.0)
    signed = np.sign(values) * steps
    found: Ints = np.where(np.isinf(values), np.where(values > 0.0, _ABOVE, _BELOW), np.nan_to_num(signed)).astype(
        np.int64
    )
    return found


def middle(bucket: int) -> float:
    """Return the value that stands for a bucket.

    Args:
        bucket: From `buckets`.

    >>> [round(middle(int(bucket)) / value - 1.0, 6) == 0.0 or abs(middle(int(bucket)) / value - 1.0) < 0.0051
    ...  for value in (3.0, -1e-9, 7e12) for bucket in buckets(np.array([value]))]
    [True, True, True]
    """
    if bucket == 0:
        return 0.0
    if bucket in (_ABOVE, _BELOW):
        return math.copysign(math.inf, bucket)
    power = math.exp((abs(bucket) - _MIDDLE) * math.log(_GROWTH))
    return math.copysign(2.0 * power / (_GROWTH + 1.0), bucket)


def quantiles_of(counts: Mapping[int, int], parts: tuple[float, ...]) -> tuple[float, ...]:
    """Return the values below which parts of all lie, to the relative accuracy.

    Args:
        counts: Bucket -> values in it.
        parts: Of all values [-].
    """
    order = sorted(counts)
    reached = np.cumsum([counts[bucket] for bucket in order])
    ranks = [min(int(part * (reached[-1] - 1)), int(reached[-1]) - 1) for part in parts]
    return tuple(middle(order[int(np.searchsorted(reached, rank, side="right"))]) for rank in ranks)
