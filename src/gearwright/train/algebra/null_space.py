"""Null space: what the rows of a matrix take to zero, by one tolerance for every question about rank."""

from __future__ import annotations

import numpy as np

from gearwright.arrays import Floats

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
