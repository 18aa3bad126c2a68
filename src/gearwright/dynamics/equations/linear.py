"""The linear system at mean stiffness, all lines in contact: its matrices and its damped modes."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwright.arrays import Complexes, Floats
from gearwright.dynamics.equations.modes import stiffness_matrix
from gearwright.dynamics.model import Arrays, entry_matrix, line_matrix, planned


class Linear(NamedTuple):
    """M q̈ + B q̇ + K q = force, with M diagonal."""

    mass: Floats
    """[kg or kg m²], shape (coordinates,)."""
    damping: Floats
    """B: dampers, loads against speed, gyroscopic terms [N s/m or N m s/rad], shape (coordinates, coordinates)."""
    stiffness: Floats
    """K: lines less centripetal terms [N/m or N m/rad], shape (coordinates, coordinates)."""


def linear(arrays: Arrays, factor: float = 1.0) -> Linear:
    """Return the matrices at one speed.

    Args:
        arrays: The system's numbers.
        factor: Speed over reference speed [-].
    """
    size, matrix, loads = len(arrays.mass), line_matrix(arrays), arrays.loads
    damping = matrix.T @ (arrays.damping[:, None] * matrix)
    damping += np.diag(loads.damping + 2.0 * loads.quadratic * np.abs(arrays.speed * factor))
    damping += factor * entry_matrix(arrays.gyroscopic, size) + entry_matrix(arrays.following.damping, size)
    stiffness = stiffness_matrix(arrays, arrays.stiffness) - factor**2 * entry_matrix(arrays.centripetal, size)
    stiffness += entry_matrix(arrays.following.stiffness, size)
    return Linear(arrays.mass, damping, stiffness)


def state_matrix(system: Linear) -> Floats:
    """Return A of d(q, q̇)/dt = A (q, q̇), shape (2 coordinates, 2 coordinates).

    Args:
        system: Mass, damping, stiffness.
    """
    size = len(system.mass)
    matrix = np.zeros((2 * size, 2 * size))
    matrix[:size, size:] = np.eye(size)
    matrix[size:, :size] = -system.stiffness / system.mass[:, None]
    matrix[size:, size:] = -system.damping / system.mass[:, None]
    return matrix


class DampedModes(NamedTuple):
    """Motions that oscillate, by rising |λ|; rigid and overdamped ones have no frequency and are left out."""

    rate: Complexes
    """Eigenvalues λ with positive imaginary part [rad/s], shape (modes,)."""
    shape: Complexes
    """Their shapes in q, of unit length in the mass matrix, shape (coordinates, modes)."""


def damped_modes(system: Linear) -> DampedModes:
    """Return the damped modes of the linear system.

    Args:
        system: Mass, damping, stiffness.
    """
    values, vectors = np.linalg.eig(state_matrix(system))
    chosen = np.flatnonzero(values.imag > 1e-6 * np.max(np.abs(values)))
    chosen = chosen[np.argsort(np.abs(values[chosen]))]
    shapes = vectors[: len(system.mass), chosen]
    length = np.sqrt(np.sum(system.mass[:, None] * np.abs(shapes) ** 2, axis=0))
    return DampedModes(values[chosen], shapes / length)


@planned
def damped_rates(arrays: Arrays, factor: float) -> Complexes:
    """Return the eigenvalues of the damped modes at one speed [rad/s], shape (modes,).

    Args:
        arrays: The system's numbers.
        factor: Speed over reference speed [-].
    """
    return damped_modes(linear(arrays, factor)).rate
