"""Torques of every mesh and of the machines that balance: T + Aᵀ λ = 0, with losses that follow the power.

Parallel paths leave λ undetermined: a share that the design states holds, and what is left is shared as equally as
equilibrium allows (`sharing.py`). The elastic answer comes from the System.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats
from gearwright.train.algebra import null_space, remembered
from gearwright.train.flow.torques.sharing import Sharing, completing

BALANCE_TOLERANCE = 1e-9
"""Largest torque left over, as a part of the largest applied, in a train that can balance."""
LARGEST_INVERSE = 1e6
"""Largest element of the inverse of a matrix of unit columns that is far from singular."""
UNDECIDED = 1e-9
"""Torque of a machine in a unit of what balances by itself, above which equilibrium does not decide it [-]."""


class Balance(NamedTuple):
    """The equations of a train's torques, ready to be solved for one load after the other."""

    matrix: Floats
    """(rows, nodes) Torque on each node per unit multiplier of each row."""
    balancing: tuple[int, ...]
    """Nodes of the machines whose torque balances."""
    completion: Floats
    """(freedoms, unknowns): what is zero besides the torques on the nodes, so that parallel paths share."""
    free: Floats
    """(unknowns, freedoms) Basis of what balances by itself without losses."""
    system: Floats
    """(nodes and freedoms, unknowns): torque on each node per unit of each unknown, then the completion."""
    scaled: Floats
    """The same with columns of unit length, which lets powers close to rounding."""
    scale: Floats
    """(unknowns,) Lengths of the columns."""
    inverse: Floats
    """(unknowns, nodes and freedoms) Of `scaled`, in the least-squares sense."""

    def with_losses(self, matrix: Floats) -> Balance:
        """Return the same equations where the rows' torques have losses.

        Args:
            matrix: (rows, nodes) torque on each node per unit multiplier of each row.
        """
        system = np.vstack([_written(matrix, self.balancing), self.completion])
        return Balance(matrix, self.balancing, self.completion, self.free, system, *_prepared(system))


def balance(matrix: Floats, balancing: Sequence[int], sharing: Sequence[Sharing] = ()) -> Balance:
    """Return the equations T + Aᵀ λ = 0 without losses, and what makes their solution one where paths are parallel.

    Args:
        matrix: (rows, nodes) A: torque on each node per unit multiplier of each row.
        balancing: Nodes of the machines whose torque balances.
        sharing: Groups of parallel rows.
    """
    system = _written(matrix, balancing)
    free = _free(system)
    scale = np.maximum(np.linalg.norm(system, axis=0), 1e-300)
    completion = completing(free, scale, sharing) if free.shape[1] else free.T
    completed = np.vstack([system, completion])
    return Balance(matrix, tuple(balancing), completion, free, completed, *_prepared(completed))


def solve_torques(known: Balance, applied: Floats) -> Floats | None:
    """Return the multipliers of the rows, then the torques of the balancing machines.

    Args:
        known: The equations.
        applied: (nodes,) torques that are given [N m].

    Returns:
        λ of every row [N m per tooth] and torque of every machine [N m], or None where no torques balance.
    """
    asked = np.concatenate([applied, np.zeros(len(known.completion))])
    first = known.inverse @ asked
    solution: Floats = (known.inverse @ (known.scaled @ first - asked) - first) / known.scale
    left = abs(known.system @ solution + asked).max(initial=0.0)
    return None if left > BALANCE_TOLERANCE * max(abs(applied).max(initial=0.0), 1e-30) else solution


def undecided(known: Balance, rows: int) -> Bools:
    """Tell of each balancing machine whether its torque may change without any node noticing, shape (machines,).

    Args:
        known: The equations without losses, in which what circulates inside the train does not touch the machines.
        rows: Number of rows, before the machines' unknowns.

    Source: the null space of the equations, restricted to the machines; empty where the torques are unique.
    """
    swing: Bools = np.abs(known.free[rows:]).max(axis=1, initial=0.0) > UNDECIDED
    return swing


def _written(matrix: Floats, balancing: Sequence[int]) -> Floats:
    """Return the torque on each node per unit multiplier of each row, then per unit torque of each machine."""
    rows, nodes = matrix.shape
    system = np.zeros((nodes, rows + len(balancing)))
    system[:, :rows] = matrix.T
    for k, node in enumerate(balancing, start=rows):
        system[node, k] = 1.0
    return system


@remembered
def _free(system: Floats) -> Floats:
    """Return what balances by itself, (unknowns, freedoms)."""
    scaled = system / np.maximum(np.linalg.norm(system, axis=0), 1e-300)
    none = np.zeros((system.shape[1], 0))
    if _inverse(scaled) is not None:
        return none
    values = np.linalg.svd(scaled, compute_uv=False)
    determined = len(values) == system.shape[1] and bool(np.all(values > 1e-10 * values.max(initial=0.0)))
    return none if determined else null_space(system)


@remembered
def _prepared(system: Floats) -> tuple[Floats, Floats, Floats]:
    """Return the columns of a system scaled to unit length, their lengths, and the inverse."""
    scale = np.maximum(np.linalg.norm(system, axis=0), 1e-300)
    scaled = system / scale
    direct = _inverse(scaled)
    if direct is not None:
        return scaled, scale, direct
    left, values, right = np.linalg.svd(scaled, full_matrices=False)
    inverse = (right.T / np.where(values > 1e-12 * values.max(initial=0.0), values, np.inf)) @ left.T
    return scaled, scale, inverse


def _inverse(matrix: Floats) -> Floats | None:
    """Return the inverse of a square matrix that is far from singular, or None."""
    if matrix.shape[0] != matrix.shape[1]:
        return None
    try:
        inverse = np.asarray(np.linalg.inv(matrix), dtype=np.float64)
    except np.linalg.LinAlgError:
        return None
    return inverse if abs(inverse).max() < LARGEST_INVERSE else None
