"""A remembered function is asked once for each matrix, and nobody can spoil what it keeps."""

import numpy as np
import pytest

from gearwright.train import remembered


def test_a_matrix_is_solved_once_and_its_transpose_is_another_one():
    asked = []

    @remembered
    def doubled(matrix):
        asked.append(matrix.copy())
        return 2.0 * matrix

    one = np.arange(6.0).reshape(2, 3)
    assert np.array_equal(doubled(one), 2.0 * one)
    assert np.array_equal(doubled(one.copy()), 2.0 * one)
    assert len(asked) == 1
    assert np.array_equal(doubled(one.reshape(3, 2)), 2.0 * one.reshape(3, 2)), "the shape counts"
    assert np.array_equal(doubled(one.T), 2.0 * one.T), "the order in memory does not"
    assert len(asked) == 3
    with pytest.raises(ValueError, match="read-only"):
        doubled(one)[0, 0] = 1.0
