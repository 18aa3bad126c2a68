"""Static equilibrium under loads and errors, and load sharing of redundant load paths in closed form."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from gearwright.base import Bools, Floats, Shown, SolveError, one_blas_thread, place_of_largest, verb
from gearwright.dynamics.equations.modes import is_sparse, rigid_motions, settled, split_rigid, stiffness_matrix
from gearwright.dynamics.equations.reference import (
    Potential,
    errors_at,
    escape,
    external_load,
    least,
    line_state,
    speed_factor,
    stiffness_at,
)
from gearwright.dynamics.model import (
    Arrays,
    Labels,
    System,
    entry_matrix,
    finite_numbers,
    holding,
    line_matrix,
    onto_coordinates,
    refuse_following,
    refuse_not_finite,
)
from gearwright.train.graph import RANK_TOLERANCE, null_space

# ----------------------------------------------------------------------------------------------------------------------
# Statics: the equilibrium of loads, line forces and errors at one instant, the least of a convex potential.
# ----------------------------------------------------------------------------------------------------------------------


BALANCE_TOLERANCE = 1e-6
"""Largest power of the loads on a rigid motion, over the sum of its parts [-]: room for rounded radii."""

Balance = Literal["required", "accelerate"]


@dataclass(frozen=True, eq=False, repr=False)
class Equilibrium(Shown):
    """Static equilibrium, measured from the rigid motion."""

    position: Floats
    """q [rad or m], shape (coordinates,); of least kinetic norm where rigid motions leave it open."""
    force: Floats
    """Line forces [N or N m], shape (lines,)."""
    labels: Labels
    """Names of coordinates and lines."""


@verb
@one_blas_thread()
def statics(system: System, *, time: float = 0.0, balance: Balance = "required") -> Equilibrium:
    """Return the elastic equilibrium under the loads, stiffnesses and errors of one instant.

    Args:
        system: Bodies, lines, loads.
        time: Instant [s].
        balance: ``"required"`` refuses loads that would set a rigid motion going; ``"accelerate"`` lets it go and finds
            the shape that it keeps under that steady acceleration (inertia relief).

    Raises:
        SolveError: If loads do not balance on a motion that no line holds, or push bodies away from all that could hold
            them; with that motion.
    """
    refuse_following(system)
    with finite_numbers(system):
        equilibrium = _equilibrium(system, time, balance)
    refuse_not_finite(equilibrium.position, system.labels.coordinates, "static position")
    refuse_not_finite(equilibrium.force, system.labels.lines, "static force")
    return equilibrium


def _equilibrium(system: System, time: float, balance: Balance) -> Equilibrium:
    load = steady_load(system.arrays, time)
    left = unbalanced(system, time=time) if balance == "required" else ""
    if left:
        raise SolveError(f"{left}; balance the loads or add a support")
    position = _settle(system, time, load)
    return Equilibrium(
        position, line_state(system.arrays, time, position, np.zeros_like(position)).force, system.labels
    )


def unbalanced(system: System, *, time: float = 0.0) -> str:
    """Return what the loads leave over on a motion that nothing holds, in words; empty if they balance.

    Args:
        system: Bodies, lines, loads.
        time: Instant [s].
    """
    arrays = system.arrays
    load = steady_load(arrays, time)
    for motion in rigid_motions(arrays).T:
        parts = motion * load
        if abs(np.sum(parts)) > BALANCE_TOLERANCE * np.sum(np.abs(parts)):
            left, pushed = np.sum(parts) / motion[place_of_largest(np.abs(motion))], _in_words(system, motion)
            return f"nothing holds {pushed} and the loads on it do not balance: they leave {left:.4g} N m"
    return ""


def steady_load(arrays: Arrays, time: float) -> Floats:
    """Return what acts on the coordinates in the rigid motion: external loads, and dampers by their slip [N or N m].

    Args:
        arrays: The system's numbers.
        time: Instant [s].
    """
    slipping = arrays.damping * arrays.slip * speed_factor(arrays.profile, time)[0]
    return external_load(arrays, time, np.zeros(len(arrays.mass))) - onto_coordinates(arrays, slipping)


def _settle(system: System, time: float, load: Floats) -> Floats:
    """Return where the potential of lines and loads is least."""
    arrays, still = system.arrays, np.zeros_like(load)
    start = line_state(arrays, time, still, still)
    if is_sparse(arrays):
        return settled(arrays, load, start.stiffness, -start.deflection)
    elastic = split_rigid(arrays)[1]
    turned = speed_factor(arrays.profile, time)[0] ** 2 * entry_matrix(arrays.centripetal, len(load))
    potential = Potential(
        line_matrix(arrays) @ elastic, -start.deflection, arrays.backlash, start.stiffness, elastic.T @ load,
        elastic.T @ turned @ elastic,
    )  # fmt: skip
    motion = elastic @ escape(potential)
    if np.any(motion):
        pushed = _in_words(system, motion)
        raise SolveError(f"the loads push {pushed} away from every line that could hold it; add a support")
    return np.asarray(elastic @ least(potential))


def _in_words(system: System, motion: Floats) -> str:
    """Return a motion by its coordinates, the largest 1."""
    shape, names = motion / motion[place_of_largest(np.abs(motion))], system.labels.coordinates
    return "the motion (" + ", ".join(f"{names[i]} {shape[i]:.3g}" for i in np.flatnonzero(np.abs(shape) > 1e-9)) + ")"


# ----------------------------------------------------------------------------------------------------------------------
# Load sharing in closed form: how parallel paths share a load when nothing is perfect, from the train's redundancy.
#
# A train with as many lines as it has elastic motions is determinate: equilibrium alone gives every force. Each
# further line adds one self-equilibrated state, a pattern of forces s with Dᵀ s = 0 that no load causes and every
# error can. Its size X follows from compatibility, Sᵀ (f/k + e) = 0 (force method):
#
#     f = f₀ − S C⁻¹ Sᵀ e,   C = Sᵀ diag(1/k) S
#
# f₀ are the forces without errors, C is the flexibility around the loops: meshes, shafts and bearings alike. Where an
# error is larger than what the load presses together, teeth part, at most until their back flanks touch.
# Errors count as in `line`: a positive one opens the line.
# ----------------------------------------------------------------------------------------------------------------------


SETTLED = 1e-10
"""Change of a mesh force in a round, over the largest force, at which contact has settled [-]."""
ROUNDS = 2000
"""Rounds in which contact must settle."""


@dataclass(frozen=True, eq=False)
class Redundancy:
    """What decides how the paths of a train share its load, as long as it moves slowly."""

    perfect: Floats
    """f₀: line forces without errors, all lines in contact [N or N m], shape (lines,)."""
    states: Floats
    """S: self-equilibrated force states, one a column [N or N m], shape (lines, redundancies)."""
    flexibility: Floats
    """C = Sᵀ diag(1/k) S: flexibility around the loops, shape (redundancies, redundancies)."""
    gain: Floats
    """R = −S C⁻¹ Sᵀ: line forces that errors cause, f = f₀ + R e [N/m], shape (lines, lines)."""
    backlash: Floats
    """Of each line [m or rad], shape (lines,): where it is positive, the line carries nothing between its flanks."""
    labels: Labels
    """Names of the lines."""

    @property
    def count(self) -> int:
        """Number of redundancies: independent loops of the load."""
        return int(self.states.shape[1])


def redundancy(system: System, *, stiffness: Floats | None = None) -> Redundancy:
    """Return the force states, the flexibility and the gain that decide the sharing of load.

    Args:
        system: Bodies, lines (supports among them) and loads, which must balance on the rigid motion.
        stiffness: Of each line [N/m or N m/rad], shape (lines,), such as that of one instant; left out: the means.

    Source: force method of statically indeterminate structures, such as Przemieniecki 1968, Theory of Matrix
        Structural Analysis, chapter 8.
    """
    arrays = system.arrays
    values = arrays.stiffness if stiffness is None else stiffness
    _, elastic = split_rigid(arrays)
    matrix = line_matrix(arrays)
    reduced = elastic.T @ stiffness_matrix(arrays, values) @ elastic
    load = arrays.loads.constant - matrix.T @ (arrays.damping * arrays.slip)
    perfect = values * (matrix @ (elastic @ np.linalg.solve(reduced, elastic.T @ load)))
    perfect += arrays.damping * arrays.slip
    held = holding(arrays)  # a damper gives way: it closes no loop
    states = _states(matrix / np.sqrt(arrays.mass), held)
    flexibility = states[held].T @ (states[held] / values[held, None])
    gain = -states @ np.linalg.solve(flexibility, states.T)
    return Redundancy(perfect, states, flexibility, gain, arrays.backlash, system.labels)


def _states(matrix: Floats, held: Bools) -> Floats:
    """Return a basis of the forces of lines that hold, such that they balance on every coordinate, Dᵀ s = 0."""
    length = np.linalg.norm(matrix[held], axis=1, keepdims=True)
    basis = null_space((matrix[held] / length).T)
    basis[np.linalg.norm(basis, axis=1) < RANK_TOLERANCE] = 0.0  # in no loop, however stiff
    states = np.zeros((len(held), basis.shape[1]))
    states[held] = basis / length
    return states


def line_forces(train: Redundancy, errors: Floats) -> Floats:
    """Return the quasi-static line forces for many sets of errors, unloaded branches included.

    Args:
        train: From `redundancy`.
        errors: Of each line [m or rad], shape (lines,) or (sets, lines).

    Returns:
        [N or N m], in the shape of the errors.

    Raises:
        SolveError: If contact does not settle, because the load closes no line.
    """
    return _settled(train, np.atleast_2d(errors))[0].reshape(np.shape(errors))


def _settled(train: Redundancy, sets: Floats) -> tuple[Floats, Floats]:
    """Return line forces and how far lines stand open, shape (sets, lines) each."""
    force, gap = train.perfect + sets @ train.gain, np.zeros_like(sets)
    parted = np.any(force[:, train.backlash > 0.0] < 0.0, axis=1)
    if np.any(parted):
        gap[parted] = _gaps(train, force[parted])
        force[parted] -= gap[parted] @ train.gain
    return force, gap


def slow_position(system: System, time: float = 0.0) -> Floats:
    """Return where the coordinates stand if everything is slow, teeth that part included: a start for integration.

    Args:
        system: With loads that balance.
        time: Instant, whose stiffnesses and errors count [s].

    Returns:
        q [rad or m], shape (coordinates,), of least kinetic norm where rigid motions leave it open.
    """
    instant = np.array([time])
    stiffness, errors = stiffness_at(system, instant)[0], errors_at(system, instant)
    force, gap = _settled(redundancy(system, stiffness=stiffness), errors)
    root = np.sqrt(system.arrays.mass)
    held = holding(system.arrays)
    matrix = line_matrix(system.arrays)[held] / root
    scale = 1.0 / np.linalg.norm(matrix, axis=1)
    stretch = force[0, held] / stiffness[held] - gap[0, held] + errors[0, held]
    return np.asarray(np.linalg.lstsq(scale[:, None] * matrix, scale * stretch, rcond=RANK_TOLERANCE)[0] / root)


def _gaps(train: Redundancy, force: Floats) -> Floats:
    """Return how far lines stand open, 0 ≤ λ ≤ B, shape (sets, lines): Gauss–Seidel, all sets side by side.

    Between its flanks a line carries nothing: λ = 0 where it presses, λ = B where its back flank does. A gap acts as an
    error of the other sign, f − R λ, and −R has no negative eigenvalue, so that the rounds settle.
    """
    stiffness = -train.gain
    movable = np.diag(stiffness) > 0.0
    pressed, gap = force.copy(), np.zeros_like(force)
    for _ in range(ROUNDS):
        largest = 0.0
        for line in np.flatnonzero(movable & (train.backlash > 0.0)):
            wanted = gap[:, line] - pressed[:, line] / stiffness[line, line]
            change = np.clip(wanted, 0.0, train.backlash[line]) - gap[:, line]
            gap[:, line] += change
            pressed += change[:, None] * stiffness[line]
            largest = max(largest, float(np.max(np.abs(change))) * stiffness[line, line])
        if largest <= SETTLED * float(np.max(np.abs(force))):
            return gap
    names = ", ".join(train.labels.lines[line] for line in np.flatnonzero(np.all(gap > 0.0, axis=0)))
    message = f"contact did not settle in {ROUNDS} rounds: the load closes no line; turn its flanks or the load"
    raise SolveError(f"{message} ({names or 'no line'} open in every set)")
