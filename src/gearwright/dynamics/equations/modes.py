"""Modes: natural frequencies and shapes of a system at its mean stiffness, all lines in contact, undamped."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.blas_threads import one_blas_thread
from gearwright.dynamics.model import (
    LARGE,
    Arrays,
    Labels,
    System,
    along_lines,
    finite_numbers,
    holding,
    line_matrix,
    planned,
    refuse_not_finite,
)
from gearwright.errors import DesignError, Problem
from gearwright.showing import Shown
from gearwright.train.algebra import row_and_null_space
from gearwright.verbs import verb

LOWEST = 60
"""Elastic modes of a large system that are found where no count is asked for."""
REPEATED = 1e-6
"""Relative distance under which two natural frequencies count as one [-]."""


@dataclass(frozen=True, eq=False, repr=False)
class Modes(Shown):
    """Natural modes, rigid ones first, then by rising frequency."""

    frequency: Floats
    """Natural frequencies [Hz], shape (modes,)."""
    shapes: Floats
    """Mass-normalised shapes [1/√kg or 1/(√kg m)], shape (coordinates, modes)."""
    line_energy: Floats
    """Share of each mode's elastic energy in each line [-], shape (lines, modes); zero for rigid modes."""
    labels: Labels
    """Names of coordinates and lines."""
    residual: Floats = field(default_factory=lambda: np.zeros(0))
    """‖K φ − ω² M φ‖ over ω² ‖M φ‖ of modes that were found iteratively [-], shape (elastic modes,); none of others."""

    @property
    def rigid(self) -> int:
        """Number of rigid modes."""
        return int(np.count_nonzero(self.frequency == 0.0))

    def groups(self) -> Iterator[tuple[float, int]]:
        """Yield each distinct frequency [Hz] with its multiplicity."""
        first = 0
        for last in range(1, len(self.frequency) + 1):
            reference = self.frequency[first]
            if last == len(self.frequency) or self.frequency[last] - reference > REPEATED * reference:
                yield float(np.mean(self.frequency[first:last])), last - first
                first = last


@planned
def split_rigid(arrays: Arrays) -> tuple[Floats, Floats]:
    """Return mass-normalised rigid and elastic motions: bases of what stretches no line, and of the rest.

    Found from the lines' directions alone, so that soft and stiff lines side by side cannot blur it.

    Args:
        arrays: The system's numbers.

    Returns:
        Shapes (coordinates, rigid) and (coordinates, elastic), both orthonormal in the mass matrix.
    """
    root = np.sqrt(arrays.mass)
    direction = line_matrix(arrays)[holding(arrays)] / root
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    elastic, rigid = row_and_null_space(direction)
    return rigid / root[:, None], elastic / root[:, None]


class Natural(NamedTuple):
    """Undamped motions of the mean stiffness, all lines in contact, without what turns and follows."""

    rate: Floats
    """ω, rising [rad/s], shape (elastic modes,)."""
    rigid: Floats
    """Mass-normalised motions that stretch no line, shape (coordinates, rigid modes)."""
    elastic: Floats
    """Mass-normalised mode shapes, shape (coordinates, elastic modes)."""
    strain: Floats
    """√(k/ω²) times how far each mode stretches each line [-], shape (lines, elastic modes): squares are shares of its
    elastic energy."""


@planned
def natural(arrays: Arrays) -> Natural:
    """Return the natural modes from the stretches of the lines, so that soft lines beside stiff ones keep their digits.

    With K = Gᵀ G and G = √k D the singular values of G are the rates themselves: of stiffnesses that span 14 decades
    they span seven, where the soft ones would be lost in the rounding of K.

    Args:
        arrays: The system's numbers.

    Source: Golub & Van Loan 2013, Matrix Computations, section 8.6: singular values and the symmetric eigenproblem.
    """
    rigid, basis = split_rigid(arrays)
    felt = np.sqrt(arrays.stiffness)[:, None] * (line_matrix(arrays) @ basis)
    strain, rates, turned = np.linalg.svd(felt, full_matrices=False)
    rising = np.arange(len(rates))[::-1]
    return Natural(rates[rising], rigid, basis @ turned[rising].T, strain[:, rising])


def stiffness_matrix(arrays: Arrays, stiffness: Floats) -> Floats:
    """Return K = Σ d k d.

    Args:
        arrays: The system's numbers.
        stiffness: Of each line [N/m or N m/rad], shape (lines,).

    Returns:
        Shape (coordinates, coordinates).
    """
    matrix = line_matrix(arrays)
    return matrix.T @ (stiffness[:, None] * matrix)


@verb
@one_blas_thread()
def modes(system: System, count: int | None = None) -> Modes:
    """Return natural frequencies, shapes and the lines that hold each mode's elastic energy.

    Args:
        system: Gyroscopic and centripetal terms are left out: see `campbell` for those.
        count: How many elastic modes, the lowest; left out: all, of more than `LARGE` coordinates the `LOWEST`. These
            are found by Lanczos' method and told with their residuals.

    Raises:
        DesignError: If the count is not positive.
        SolveError: If a number of the system or of its modes is not finite; with the part.

    Source:
        Symmetric eigenproblem K φ = ω² M φ, rigid motions taken out beforehand, by `natural`.
    """
    if count is not None and count < 1:
        raise DesignError([Problem("count", f"{count} modes; ask for one or more, or leave it out")])
    with finite_numbers(system):
        size = len(system.arrays.mass)
        large = size > LARGE and 2 * (count or LOWEST) < size  # most of all modes are had from the whole matrix
        solved = _lowest(system, count or LOWEST) if large else _modes(system, count)
    numbers = [f"mode {number}" for number in range(1, 1 + len(solved.frequency))]
    refuse_not_finite(solved.frequency, numbers, "frequency")
    refuse_not_finite(solved.shapes.T, system.labels.coordinates, "mode shape")
    refuse_not_finite(solved.line_energy.T, system.labels.lines, "energy")
    return solved


def _lowest(system: System, count: int) -> Modes:
    from gearwright.dynamics.equations.lanczos import lowest_modes  # both need `split_rigid` from here
    from gearwright.dynamics.equations.sparse import rigid_motions

    arrays, lines = system.arrays, len(system.arrays.stiffness)
    found, rigid = lowest_modes(arrays, count), rigid_motions(arrays)
    stretch = np.array([along_lines(arrays, shape) for shape in found.shapes.T]).T
    share = np.hstack([np.zeros((lines, rigid.shape[1])), arrays.stiffness[:, None] * stretch**2 / found.square])
    frequency = np.concatenate([np.zeros(rigid.shape[1]), np.sqrt(found.square)]) / (2.0 * np.pi)
    return Modes(frequency, np.hstack([rigid, found.shapes]), share, system.labels, found.residual)


def _modes(system: System, count: int | None) -> Modes:
    found = natural(system.arrays)
    rigid, lines = found.rigid.shape[1], len(system.labels.lines)
    frequency = np.concatenate([np.zeros(rigid), found.rate[:count]]) / (2.0 * np.pi)
    shapes = np.hstack([found.rigid, found.elastic[:, :count]])
    share = np.hstack([np.zeros((lines, rigid)), found.strain[:, :count] ** 2])
    return Modes(frequency, shapes, share, system.labels)
