"""Arrays by what they hold, for signatures and fields."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]
Complexes = NDArray[np.complexfloating[Any, Any]]


def following(values: NDArray[Any]) -> NDArray[Any]:
    """Return the next one of every value along the first axis of a closed loop; what `numpy.roll` gives, in less time.

    Args:
        values: Shape (n, …).

    >>> following(np.array([1, 2, 3])).tolist()
    [2, 3, 1]
    """
    return np.concatenate([values[1:], values[:1]])
