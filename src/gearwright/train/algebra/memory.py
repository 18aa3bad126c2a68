"""Remember what a matrix gave: the trains of a study repeat their matrices from load case to load case and design."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache, wraps
from typing import TypeVar

import numpy as np

from gearwright.arrays import Floats

Result = TypeVar("Result", Floats, tuple[Floats, Floats, Floats])
KEPT = 1024
"""Latest matrices of which the result is kept: some 1 MB."""


def remembered(function: Callable[[Floats], Result]) -> Callable[[Floats], Result]:
    """Return a function of one matrix that keeps its latest results, which are not to be written to.

    Args:
        function: Its result, one array or several, depends on the matrix alone.
    """

    @lru_cache(maxsize=KEPT)
    def kept(content: bytes, shape: tuple[int, ...]) -> Result:
        result = function(np.frombuffer(content).reshape(shape))
        for array in (result,) if isinstance(result, np.ndarray) else result:
            array.flags.writeable = False
        return result

    @wraps(function)
    def looked_up(matrix: Floats) -> Result:
        return kept(matrix.tobytes(), matrix.shape)

    return looked_up
