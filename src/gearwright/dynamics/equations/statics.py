"""Statics: the equilibrium of loads, line forces and errors at one instant, the least of a convex potential."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from gearwright.arrays import Floats
from gearwright.blas_threads import one_blas_thread
from gearwright.dynamics.equations.modes import split_rigid
from gearwright.dynamics.equations.potential import Potential, escape, least
from gearwright.dynamics.equations.reference import external_load, line_state, speed_factor
from gearwright.dynamics.equations.sparse import is_sparse, rigid_motions, settled
from gearwright.dynamics.model import (
    Arrays,
    Labels,
    System,
    entry_matrix,
    finite_numbers,
    line_matrix,
    onto_coordinates,
    refuse_following,
    refuse_not_finite,
)
from gearwright.errors import SolveError
from gearwright.ranking import place_of_largest
from gearwright.showing import Shown
from gearwright.verbs import verb

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
