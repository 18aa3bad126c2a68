"""Natural frequencies and mode shapes at mean stiffness, large systems, harmonic balance with sidebands."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from itertools import product
from typing import Any, NamedTuple

import numpy as np

from gearwright.base import Complexes, DesignError, Floats, Problem, Shown, SolveError, one_blas_thread, verb
from gearwright.dynamics.equations.reference import HELD_BACK, ROUNDS, SETTLED, Slope, dead_zone, reach, touching
from gearwright.dynamics.model import (
    LARGE,
    Arrays,
    Labels,
    Series,
    System,
    along_lines,
    entry_matrix,
    finite_numbers,
    holding,
    line_matrix,
    planned,
    refuse_not_finite,
)
from gearwright.train.graph import RANK_TOLERANCE, null_space, row_and_null_space

# ----------------------------------------------------------------------------------------------------------------------
# Modes: natural frequencies and shapes of a system at its mean stiffness, all lines in contact, undamped.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Large systems: rigid motions by the graph of their lines, and statics with sparse matrices.
#
# Beyond `LARGE` coordinates dense decompositions take seconds. Lines join few bodies each, so that spanning trees and
# sparse factors take milliseconds.
# ----------------------------------------------------------------------------------------------------------------------


RIGID_ROUNDING = 1e-14
"""Share of all forces at a body that rounding may leave over [-]."""


def is_sparse(arrays: Arrays) -> bool:
    """Tell whether statics are solved with sparse matrices: no line only pulls, and no body flies outwards.

    Args:
        arrays: The system's numbers.
    """
    presses = np.isinf(arrays.backlash).any()
    return len(arrays.mass) > LARGE and not presses and not len(arrays.centripetal.value)


@planned
def rigid_motions(arrays: Arrays) -> Floats:
    """Return mass-normalised motions that stretch no line that holds, shape (coordinates, rigid).

    Args:
        arrays: The system's numbers.
    """
    return motions_of_graph(arrays) if len(arrays.mass) > LARGE else split_rigid(arrays)[0]


def motions_of_graph(arrays: Arrays) -> Floats:
    """Return the same by the graph of the lines.

    Lines of two coordinates are the edges of a graph: along a spanning tree each coordinate follows from the first of
    its part. What the other lines ask of the parts is a small matrix, whose null space tells the parts' motions.

    Args:
        arrays: The system's numbers.
    """
    rows = _rows(arrays)
    part, ratio = _spanned(rows, len(arrays.mass))
    parts = int(np.max(part, initial=-1)) + 1
    conditions = np.array([row for line in rows if (row := _condition(line, part, ratio, parts)) is not None])
    free = null_space(conditions.reshape(-1, parts)) if len(conditions) else np.eye(parts)
    root = np.sqrt(arrays.mass)
    motions = np.linalg.qr((root * ratio)[:, None] * free[part])[0] if free.size else np.zeros((len(root), 0))
    return np.asarray(motions / root[:, None])


def _rows(arrays: Arrays) -> list[dict[int, float]]:
    """Return the weights of each line that holds, by coordinate."""
    rows = []
    for line in np.flatnonzero(holding(arrays)).tolist():
        row = dict[int, float]()
        for place in range(arrays.line_start[line], arrays.line_start[line + 1]):
            dof = int(arrays.line_dof[place])
            row[dof] = row.get(dof, 0.0) + float(arrays.line_weight[place])
        rows.append({dof: weight for dof, weight in row.items() if weight})
    return rows


def _spanned(rows: list[dict[int, float]], size: int) -> tuple[Any, Floats]:
    """Return the part of each coordinate, and how far it moves with the first coordinate of its part."""
    edges: list[list[tuple[int, float]]] = [[] for _ in range(size)]
    for row in rows:
        if len(row) == 2:
            (first, a), (second, b) = row.items()
            edges[first].append((second, -a / b))
            edges[second].append((first, -b / a))
    part, ratio, parts = np.full(size, -1), np.ones(size), 0
    for start in range(size):
        if part[start] >= 0:
            continue
        part[start], queue = parts, deque([start])
        while queue:
            here = queue.popleft()
            for there, factor in edges[here]:
                if part[there] < 0:
                    part[there], ratio[there] = parts, ratio[here] * factor
                    queue.append(there)
        parts += 1
    return part, ratio


def _condition(line: dict[int, float], part: Any, ratio: Floats, parts: int) -> Floats | None:
    """Return what a line asks of the parts' motions; none of a line that the tree, or its closing, satisfies."""
    row, size = np.zeros(parts), np.zeros(parts)
    for dof, weight in line.items():
        row[part[dof]] += weight * ratio[dof]
        size[part[dof]] += abs(weight * ratio[dof])
    row[np.abs(row) <= RANK_TOLERANCE * size] = 0.0
    length = float(np.linalg.norm(row))
    return row / length if length > 0.0 else None


def settled(arrays: Arrays, load: Floats, stiffness: Floats, error: Floats) -> Floats:
    """Return q at the least of the potential of lines and loads, of least kinetic norm, by Newton's method.

    Args:
        arrays: The system's numbers, without centripetal terms, and with no line that never touches on its back.
        load: On each coordinate [N or N m].
        stiffness: Of each line at the instant [N/m or N m/rad].
        error: Of each line [m or rad].

    Raises:
        SolveError: If contact does not settle.
    """
    from scipy import sparse  # small systems do without it

    root, stiff = np.sqrt(arrays.mass), np.sqrt(stiffness)
    lines = scaled_lines(arrays, stiffness)
    rigid = rigid_motions(arrays) * root[:, None]
    pull = load / root - rigid @ (rigid.T @ (load / root))
    gap, opened = stiff * arrays.backlash, stiff * error
    place = _solve(lines, rigid, pull + lines.T @ opened)
    for _ in range(ROUNDS):
        deflection = lines @ place - opened
        contact = dead_zone(deflection, gap)
        left = pull - lines.T @ contact
        left -= rigid @ (rigid.T @ left)
        acting = np.linalg.norm(pull) + np.linalg.norm(contact) * RIGID_ROUNDING / SETTLED
        acting += np.linalg.norm(abs(lines).T @ np.abs(contact))
        if np.linalg.norm(left) <= SETTLED * acting:
            return np.asarray(place / root)
        weight = np.where(touching(deflection, gap), 1.0, HELD_BACK)
        way = _solve(sparse.diags(np.sqrt(weight)) @ lines, rigid, left)
        place = place + reach(Slope(deflection, lines @ way, gap), float(way @ pull), 0.0) * way
    raise SolveError(
        f"contact did not settle in {ROUNDS} rounds; forces of {np.linalg.norm(left) / acting:.1e} are left over"
    )


def scaled_lines(arrays: Arrays, stiffness: Floats) -> Any:
    """Return √k D M^(−1/2) as a sparse matrix, whose square is the stiffness in coordinates of unit mass.

    Args:
        arrays: The system's numbers.
        stiffness: Of each line [N/m or N m/rad].
    """
    from scipy import sparse

    entries, shape = arrays.line_weight / np.sqrt(arrays.mass)[arrays.line_dof], (len(stiffness), len(arrays.mass))
    return sparse.diags(np.sqrt(stiffness)) @ sparse.csr_matrix((entries, arrays.line_dof, arrays.line_start), shape)


def _solve(lines: Any, rigid: Floats, force: Floats) -> Floats:
    """Return the motion under a force, without any rigid one."""
    return factored(lines, rigid)(force)


def factored(lines: Any, rigid: Floats) -> Callable[[Floats], Floats]:
    """Return what finds the motion under a force, both without any rigid one.

    One coordinate for each rigid motion is held while the rest is solved for, which leaves the matrix as sparse as it
    is; what the answer then has of the rigid motions is taken out.

    Args:
        lines: As `scaled_lines` has them.
        rigid: Motions of unit length, shape (coordinates, rigid).
    """
    from scipy.linalg import qr
    from scipy.sparse.linalg import splu

    held = qr(rigid.T, mode="r", pivoting=True)[-1][: rigid.shape[1]] if rigid.size else []
    free = np.delete(np.arange(len(rigid)), held)
    part = lines[:, free]
    factors = splu((part.T @ part).tocsc(), permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True})

    def solved(force: Floats) -> Floats:
        motion = np.zeros(len(force))
        motion[free] = factors.solve(force[free])
        return np.asarray(motion - rigid @ (rigid.T @ motion))

    return solved


# ----------------------------------------------------------------------------------------------------------------------
# Lowest modes of large systems: Lanczos' method on the inverse, rigid motions taken out beforehand.
#
# What the inverse stretches most are the lowest modes. Each is told with its residual, since the method is iterative.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# The linear system at mean stiffness, all lines in contact: its matrices and its damped modes.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Steady state under errors and varying mesh stiffness: harmonic balance with mesh sidebands, all lines in contact.
#
# With contact held the system is linear, so that every error frequency is its own problem. The varying stiffness
# spreads it to the sidebands ω + Σ n_m Ω_m around it (Ω_m: mesh frequencies). Without sidebands this is the frequency
# response at mean stiffness, with the slow limit of the closed form.
# ----------------------------------------------------------------------------------------------------------------------


SAME = 1e-9
"""Relative distance under which two frequencies are one [-]."""
LARGEST = 6000
"""Unknowns of one balance: beyond, integration is quicker."""


class SteadyForces(NamedTuple):
    """Elastic line forces as a sum of harmonics."""

    rate: Floats
    """Circular frequencies, also negative ones [rad/s], shape (harmonics,)."""
    amplitude: Complexes
    """f(t) = Re Σ amplitude e^(iωt) [N or N m], shape (harmonics, lines)."""

    def at(self, time: Floats) -> Floats:
        """Return the forces at some instants [N or N m], shape (instants, lines).

        Args:
            time: [s], shape (instants,).
        """
        return np.asarray((np.exp(1j * np.outer(time, self.rate)) @ self.amplitude).real)


def steady_forces(system: System, *, sidebands: int = 3) -> SteadyForces:
    """Return the steady elastic line forces under constant loads, errors and varying stiffness.

    Args:
        system: At reference speed, all lines in contact.
        sidebands: Largest Σ |n_m|; 0 takes the mean stiffness.

    Raises:
        DesignError: If there are so many mesh frequencies that the balance would be too large.

    Source: harmonic balance of a linear system with periodic coefficients (Hill 1886), one sideband order at a time.
    """
    arrays = system.arrays
    meshes = _spectrum(arrays, arrays.variation)
    stiffness = {rate: value * arrays.stiffness for rate, value in meshes.items()}
    shifts = _shifts(tuple(rate for rate in stiffness if rate > 0.0), sidebands)
    if not sidebands:
        stiffness = {}
    unknowns = len(shifts) * len(arrays.mass)
    if unknowns > LARGEST:
        message = f"{sidebands} sidebands of all meshes make {unknowns} unknowns; take fewer, or method 'dynamics'"
        raise DesignError([Problem("sidebands", message)])
    balance = _Balance(system, stiffness)
    parts = [balance.solve(base, shifts, error) for base, error in _bases(arrays)]
    return SteadyForces(np.concatenate([rate for rate, _ in parts]), np.concatenate([force for _, force in parts]))


def _spectrum(arrays: Arrays, series: Series) -> dict[float, Complexes]:
    """Return circular frequency -> two-sided amplitude of each line's series; equal frequencies are one."""
    lines = len(arrays.stiffness)
    spectrum: dict[float, Complexes] = {}
    line = np.repeat(np.arange(lines), np.diff(series.start))
    for j, tone, a, b in zip(line, series.tone, series.cosine, series.sine, strict=True):
        rate = float(arrays.tone_rate[tone] * arrays.profile.factor[0])
        for sign in (1.0, -1.0) if rate else (1.0,):
            place = _same(sign * rate, spectrum)
            spectrum.setdefault(place, np.zeros(lines, dtype=np.complex128))
            spectrum[place][j] += (a - 1j * sign * b) / (2.0 if rate else 1.0)
    return spectrum


def _same(rate: float, spectrum: dict[float, Complexes]) -> float:
    return next((known for known in spectrum if abs(known - rate) <= SAME * max(abs(known), abs(rate))), rate)


def _bases(arrays: Arrays) -> Iterator[tuple[float, Complexes]]:
    """Yield the error frequencies, zero first, with one-sided complex amplitudes."""
    spectrum = _spectrum(arrays, arrays.error)
    yield 0.0, spectrum.get(0.0, np.zeros(len(arrays.stiffness), dtype=np.complex128))
    for rate, amplitude in spectrum.items():
        if rate > 0.0:
            yield rate, 2.0 * amplitude


def _shifts(meshes: tuple[float, ...], sidebands: int) -> Floats:
    """Return Σ n_m Ω_m for all Σ |n_m| up to the order; multiples of a mesh frequency are its own harmonics."""
    ground = [
        rate for rate in meshes
        if not any(slower < rate and abs(rate / slower - round(rate / slower)) < SAME for slower in meshes)
    ]  # fmt: skip
    orders = range(-sidebands, sidebands + 1)
    counts = [count for count in product(orders, repeat=len(ground)) if sum(map(abs, count)) <= sidebands]
    return np.array(sorted({round(float(np.dot(count, ground)), 9) if count else 0.0 for count in counts}))


class _Balance:
    """The system in its elastic motions, ready for one frequency after the other."""

    def __init__(self, system: System, stiffness: dict[float, Complexes]) -> None:
        arrays, model = system.arrays, linear(system.arrays)
        _, elastic = split_rigid(arrays)
        self.matrix = line_matrix(arrays) @ elastic
        self.mass = elastic.T @ (model.mass[:, None] * elastic)
        self.damping = elastic.T @ model.damping @ elastic
        self.stiffness = elastic.T @ model.stiffness @ elastic
        self.load = elastic.T @ arrays.loads.constant
        self.mean, self.damper, self.varying = arrays.stiffness, arrays.damping, stiffness

    def solve(self, base: float, shifts: Floats, error: Complexes) -> tuple[Floats, Complexes]:
        """Return the frequencies around one error frequency and the elastic line forces there."""
        rates = base + shifts
        size, centre = len(self.mass), int(np.argmin(np.abs(shifts)))
        coupling = self._coupling(shifts)
        left = np.zeros((len(rates), size, len(rates), size), dtype=np.complex128)
        right = np.zeros((len(rates), size), dtype=np.complex128)
        for i, rate in enumerate(rates):
            left[i, :, i] = self.stiffness + 1j * rate * self.damping - rate**2 * self.mass
            for k, values in coupling[i].items():
                left[i, :, k] += self.matrix.T @ (values[:, None] * self.matrix)
            right[i] = self.matrix.T @ (self._values(coupling, i, centre) * error)
        right[centre] += self.matrix.T @ (1j * base * self.damper * error)
        right[centre] += self.load if base == 0.0 else 0.0
        shape = len(rates) * size
        position = np.linalg.solve(left.reshape(shape, shape), right.ravel()).reshape(len(rates), size)
        stretch = position @ self.matrix.T
        stretch[centre] -= error
        force = stretch * self.mean
        for i, row in enumerate(coupling):
            for k, values in row.items():
                force[i] += values * stretch[k]
        return rates, force

    def _coupling(self, shifts: Floats) -> list[dict[int, Complexes]]:
        """Return for each frequency which others reach it, and through which stiffness."""
        coupling: list[dict[int, Complexes]] = [{} for _ in shifts]
        for i, to in enumerate(shifts):
            for k, source in enumerate(shifts):
                for rate, values in self.varying.items():
                    if abs(to - source - rate) < 1e-6:
                        coupling[i][k] = values
        return coupling

    def _values(self, coupling: list[dict[int, Complexes]], i: int, centre: int) -> Complexes:
        """Return the stiffness through which an error at the centre reaches a frequency."""
        mean = self.mean.astype(np.complex128) if i == centre else np.zeros(len(self.mean), dtype=np.complex128)
        return mean + coupling[i].get(centre, 0.0)
