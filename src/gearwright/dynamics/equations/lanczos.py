"""Lowest modes of large systems: Lanczos' method on the inverse, rigid motions taken out beforehand.

What the inverse stretches most are the lowest modes. Each is told with its residual, since the method is iterative.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.blas_threads import one_blas_thread
from gearwright.dynamics.equations.sparse import factored, rigid_motions, scaled_lines
from gearwright.dynamics.model import Arrays


class Lowest(NamedTuple):
    """Modes of the elastic motion, by rising frequency."""

    square: Floats
    """ω² [1/s²], shape (modes,)."""
    shapes: Floats
    """Mass-normalised, shape (coordinates, modes)."""
    residual: Floats
    """‖K φ − ω² M φ‖ over ω² ‖M φ‖, in coordinates of unit mass [-], shape (modes,)."""


def lowest_modes(arrays: Arrays, count: int) -> Lowest:
    """Return the lowest elastic modes at mean stiffness.

    Args:
        arrays: The system's numbers.
        count: How many at most.

    Source: Ericsson & Ruhe 1980, Math. Comp. 35, 1251: Lanczos on the shifted inverse; here the inverse beside the
        rigid motions, by one sparse factorisation.
    """
    from scipy.sparse.linalg import LinearOperator, eigsh

    root, lines = np.sqrt(arrays.mass), scaled_lines(arrays, arrays.stiffness)
    rigid = rigid_motions(arrays) * root[:, None]
    solve, size = factored(lines, rigid), len(root)

    def inverse(force: Floats) -> Floats:
        force = force.ravel()
        return solve(force - rigid @ (rigid.T @ force))

    start = np.random.default_rng(0).normal(size=size)  # the same answer each time
    operator = LinearOperator((size, size), matvec=inverse, dtype=float)
    with one_blas_thread():
        share, shapes = eigsh(operator, k=min(count, size - rigid.shape[1] - 1), which="LA", v0=inverse(start))
    order = np.argsort(-share)
    square, shapes = 1.0 / share[order], shapes[:, order]
    left = lines.T @ (lines @ shapes) - square * shapes
    return Lowest(square, shapes / root[:, None], np.linalg.norm(left, axis=0) / square)
