"""Remember what a matrix gave: the trains of a study repeat their matrices from load case to load case and design."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache, wraps

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
KEPT = 1024
"""Latest matrices of which the result is kept: some 1 MB."""


def remembered(function: Callable[[Array], Array]) -> Callable[[Array], Array]:
    """Return a function of one matrix that keeps its latest results, which are not to be written to.

    Args:
        function: Its result depends on the matrix alone.
    """

    @lru_cache(maxsize=KEPT)
    def kept(content: bytes, shape: tuple[int, ...]) -> Array:
        result = function(np.frombuffer(content).reshape(shape))
        result.flags.writeable = False
        return result

    @wraps(function)
    def looked_up(matrix: Array) -> Array:
        return kept(matrix.tobytes(), matrix.shape)

    return looked_up
