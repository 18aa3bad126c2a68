"""The linear system at mean stiffness, all lines in contact: its matrices and its damped modes."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwright.arrays import Complexes, Floats
from gearwright.dynamics.equations.modes import Natural, natural, stiffness_matrix
from gearwright.dynamics.model import Arrays, entry_matrix, holding, line_matrix, planned
from gearwright.train.algebra import row_and_null_space


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
    matrix = line_matrix(arrays)
    damping = matrix.T @ (arrays.damping[:, None] * matrix) + _turned_damping(arrays, factor)
    stiffness = stiffness_matrix(arrays, arrays.stiffness) + _turned_stiffness(arrays, factor)
    return Linear(arrays.mass, damping, stiffness)


def _turned_stiffness(arrays: Arrays, factor: float) -> Floats:
    """Return the stiffness that no line has: centripetal terms, and films that follow [N/m or N m/rad]."""
    size = len(arrays.mass)
    return entry_matrix(arrays.following.stiffness, size) - factor**2 * entry_matrix(arrays.centripetal, size)


def _turned_damping(arrays: Arrays, factor: float) -> Floats:
    """Return the damping that no line has: loads against speed, gyroscopic terms, films that follow [N s/m]."""
    size, loads = len(arrays.mass), arrays.loads
    against = np.diag(loads.damping + 2.0 * loads.quadratic * np.abs(arrays.speed * factor))
    return against + factor * entry_matrix(arrays.gyroscopic, size) + entry_matrix(arrays.following.damping, size)


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


ROUNDING = 1e-13
"""Rate over the fastest one below which a rate is the rounding of a motion that does not oscillate [-]."""
STILL = 1e-8
"""Rate over the slowest natural one below which a motion is rigid, and oscillates by rounding alone [-]."""
FELT = 1e-12
"""Force over the sum of its terms without signs above which it is none of their rounding [-]."""


@planned
def damped_modes(arrays: Arrays, factor: float = 1.0) -> DampedModes:
    """Return the damped modes at one speed.

    They are found in the natural modes of the lines, each position times its rate: the matrix then holds rates where
    that of `state_matrix` holds their squares, and a mode keeps its digits beside one that is ten million times faster.
    Rigid motions have no position there, unless what turns or follows holds them.

    Args:
        arrays: The system's numbers.
        factor: Speed over reference speed [-].

    Source: Tisseur & Meerbergen 2001, SIAM Review 43, 235-286, section 3: linearisations of M λ² + B λ + K, and why
        their scaling decides what is kept of small eigenvalues.
    """
    found = natural(arrays)
    shapes, rigid = np.hstack([found.rigid, found.elastic]), found.rigid.shape[1]
    held = _held(arrays, factor, found.rigid)
    positions = np.hstack([shapes[:, :rigid] @ held, found.elastic / found.rate])
    rate = np.vstack([np.zeros((rigid, len(found.rate))), np.diag(found.rate)])
    turning = np.vstack([held, np.zeros((len(found.rate), held.shape[1]))])
    places, count = positions.shape[1], shapes.shape[1]
    matrix = np.zeros((places + count, places + count))
    matrix[:places, places:] = np.hstack([turning, rate]).T
    matrix[places:, held.shape[1] : places] = -rate
    matrix[places:, :places] -= shapes.T @ (_turned_stiffness(arrays, factor) @ positions)
    matrix[places:, places:] = -_modal_damping(arrays, factor, found, shapes)
    values, vectors = np.linalg.eig(matrix)
    # A rigid motion that only rounding holds splits into a pair far below the slowest stretch of a line.
    slowest = float(np.min(found.rate)) if len(found.rate) else 0.0
    least = max(ROUNDING * float(np.max(np.abs(values), initial=0.0)), STILL * slowest)
    chosen = np.flatnonzero(values.imag > least)
    chosen = chosen[np.argsort(np.abs(values[chosen]))]
    moved = vectors[places:, chosen] / values[chosen]
    return DampedModes(values[chosen], shapes @ (moved / np.linalg.norm(moved, axis=0)))


def _held(arrays: Arrays, factor: float, rigid: Floats) -> Floats:
    """Return the rigid motions, as parts of all of them, that stretch no line and meet a force all the same."""
    stiffness = _turned_stiffness(arrays, factor)
    force, terms = stiffness @ rigid, np.abs(stiffness) @ np.abs(rigid)
    felt = np.where(np.abs(force) > FELT * terms, force, 0.0)
    lengths = np.linalg.norm(felt, axis=1, keepdims=True)
    return row_and_null_space(felt[lengths[:, 0] > 0.0] / lengths[lengths > 0.0][:, None])[0]


def _modal_damping(arrays: Arrays, factor: float, found: Natural, shapes: Floats) -> Floats:
    """Return the damping that modes feel [rad/s]: of lines by their strain, which keeps its digits, and of all else."""
    holds, damping = holding(arrays), arrays.damping
    stiffness = np.where(holds, arrays.stiffness, 1.0)
    still = np.zeros((len(holds), found.rigid.shape[1]))
    strain = np.hstack([still, found.strain * found.rate]) / np.sqrt(stiffness)[:, None]
    stretch = np.where(holds[:, None], strain, line_matrix(arrays) @ shapes)
    return stretch.T @ (damping[:, None] * stretch) + shapes.T @ _turned_damping(arrays, factor) @ shapes


@planned
def damped_rates(arrays: Arrays, factor: float) -> Complexes:
    """Return the eigenvalues of the damped modes at one speed [rad/s], shape (modes,).

    Args:
        arrays: The system's numbers.
        factor: Speed over reference speed [-].
    """
    return damped_modes(arrays, factor).rate
