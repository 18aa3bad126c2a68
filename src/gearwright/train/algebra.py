"""Null spaces of matrices, and a cache of results by matrix."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import TypeVar

import numpy as np

from gearwright.arrays import Floats
from gearwright.memo import Memo

# ----------------------------------------------------------------------------------------------------------------------
# Remember what a matrix gave: the trains of a study repeat their matrices from load case to load case and design.
# ----------------------------------------------------------------------------------------------------------------------


Result = TypeVar("Result", Floats, tuple[Floats, Floats, Floats])
KEPT = 1024
"""Latest matrices of which the result is kept: some 1 MB."""


def remembered(function: Callable[[Floats], Result]) -> Callable[[Floats], Result]:
    """Return a function of one matrix that keeps its latest results, which are not to be written to.

    Args:
        function: Its result, one array or several, depends on the matrix alone.
    """

    memo = Memo[tuple[bytes, tuple[int, ...]], Result](KEPT)

    def made(content: bytes, shape: tuple[int, ...]) -> Result:
        result = function(np.frombuffer(content).reshape(shape))
        for array in (result,) if isinstance(result, np.ndarray) else result:
            array.flags.writeable = False
        return result

    @wraps(function)
    def looked_up(matrix: Floats) -> Result:
        key = (matrix.tobytes(), matrix.shape)
        return memo.of(key, lambda: made(*key))

    return looked_up


# ----------------------------------------------------------------------------------------------------------------------
# Null space: what the rows of a matrix take to zero, by one tolerance for every question about rank.
# ----------------------------------------------------------------------------------------------------------------------


RANK_TOLERANCE = 1e-10
"""Singular value over the largest below which a direction counts as free [-]."""


def null_space(matrix: Floats) -> Floats:
    """Return an orthonormal basis (columns, dimensions) of what the rows take to zero.

    Args:
        matrix: (rows, columns), its rows of like length.

    Source: Golub & Van Loan 2013, Matrix Computations, section 5.4: the right singular vectors beyond the rank.
    """
    return row_and_null_space(matrix)[1]


def row_and_null_space(matrix: Floats) -> tuple[Floats, Floats]:
    """Return orthonormal bases (columns, dimensions) of what the rows feel, and of what they take to zero.

    Args:
        matrix: (rows, columns), its rows of like length.

    Source: Golub & Van Loan 2013, Matrix Computations, section 5.4: the right singular vectors, cut at the rank.
    """
    if not len(matrix):
        return np.zeros((matrix.shape[1], 0)), np.eye(matrix.shape[1])
    _, values, right = np.linalg.svd(matrix)
    rank = int(np.count_nonzero(values > RANK_TOLERANCE * np.max(values, initial=1e-300)))
    return right[:rank].T, right[rank:].T
