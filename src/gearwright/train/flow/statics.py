"""Torques of every mesh and of the machines that balance: T + Aᵀ λ = 0, with losses that follow the power.

Parallel paths leave λ undetermined: a share that the design states holds, and what is left is shared as equally as
equilibrium allows. The elastic answer comes from the System.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats
from gearwright.train.algebra import null_space, remembered

BALANCE_TOLERANCE = 1e-9
"""Largest torque left over, as a part of the largest applied, in a train that can balance."""
LARGEST_INVERSE = 1e6
"""Largest element of the inverse of a matrix of unit columns that is far from singular."""
UNDECIDED = 1e-9
"""Torque of a machine in a unit of what balances by itself, above which equilibrium does not decide it [-]."""


@dataclass(frozen=True)
class Sharing:
    """Rows that run in parallel and the share of each; `stated` if the design says so."""

    rows: tuple[int, ...]
    """Rows of the graph."""
    share: tuple[float, ...]
    """Part of the group's load on each row [-]; the sum is one."""
    stated: bool
    """True if the design gives the shares, so that they hold before any other."""


class Balance(NamedTuple):
    """The equations of a train's torques, ready to be solved for one load after the other."""

    system: Floats
    """(nodes, unknowns): torque on each node per unit of each unknown."""
    scaled: Floats
    """The same with columns of unit length, which lets powers close to rounding."""
    scale: Floats
    """(unknowns,) Lengths of the columns."""
    inverse: Floats
    """(unknowns, nodes) Of `scaled`, in the least-squares sense."""
    free: Floats
    """(unknowns, freedoms) Basis of what balances by itself."""


def balance(matrix: Floats, balancing: Sequence[int]) -> Balance:
    """Return the equations T + Aᵀ λ = 0.

    Args:
        matrix: (rows, nodes) torque on each node per unit multiplier of each row; A itself where nothing is lost.
        balancing: Nodes of the machines whose torque balances.
    """
    rows, nodes = matrix.shape
    system = np.zeros((nodes, rows + len(balancing)))
    system[:, :rows] = matrix.T
    for k, node in enumerate(balancing, start=rows):
        system[node, k] = 1.0
    return Balance(system, *_prepared(system))


def solve_torques(known: Balance, applied: Floats, *, sharing: Sequence[Sharing] = ()) -> Floats | None:
    """Return the multipliers of the rows, then the torques of the balancing machines.

    Args:
        known: The equations.
        applied: (nodes,) torques that are given [N m].
        sharing: Groups of parallel rows.

    Returns:
        λ of every row [N m per tooth] and torque of every machine [N m], or None where no torques balance.
    """
    first = known.inverse @ applied
    solution: Floats = (known.inverse @ (known.scaled @ first - applied) - first) / known.scale
    left = abs(known.system @ solution + applied).max(initial=0.0)
    if left > BALANCE_TOLERANCE * max(abs(applied).max(initial=0.0), 1e-30):
        return None
    return _share(solution, known.free, sharing) if known.free.shape[1] else solution


def undecided(known: Balance, rows: int) -> Bools:
    """Tell of each balancing machine whether its torque may change without any node noticing, shape (machines,).

    Args:
        known: The equations without losses, in which what circulates inside the train does not touch the machines.
        rows: Number of rows, before the machines' unknowns.

    Source: the null space of the equations, restricted to the machines; empty where the torques are unique.
    """
    swing: Bools = np.abs(known.free[rows:]).max(axis=1, initial=0.0) > UNDECIDED
    return swing


@remembered
def _prepared(system: Floats) -> tuple[Floats, Floats, Floats, Floats]:
    """Return the columns of a system scaled to unit length, their lengths, the inverse, and the freedoms."""
    scale = np.maximum(np.linalg.norm(system, axis=0), 1e-300)
    scaled = system / scale
    direct = _inverse(scaled)
    if direct is not None:
        return scaled, scale, direct, np.zeros((system.shape[1], 0))
    left, values, right = np.linalg.svd(scaled, full_matrices=False)
    largest = values.max(initial=0.0)
    inverse = (right.T / np.where(values > 1e-12 * largest, values, np.inf)) @ left.T
    determined = len(values) == system.shape[1] and bool(np.all(values > 1e-10 * largest))
    return scaled, scale, inverse, np.zeros((system.shape[1], 0)) if determined else null_space(system)


def _inverse(matrix: Floats) -> Floats | None:
    """Return the inverse of a square matrix that is far from singular, or None."""
    if matrix.shape[0] != matrix.shape[1]:
        return None
    try:
        inverse = np.asarray(np.linalg.inv(matrix), dtype=np.float64)
    except np.linalg.LinAlgError:
        return None
    return inverse if abs(inverse).max() < LARGEST_INVERSE else None


def _share(solution: Floats, free: Floats, sharing: Sequence[Sharing]) -> Floats:
    """Move along the torques that balance by themselves until the shares hold: stated ones first, then equal ones."""
    for stated in (True, False):
        equations = [row for group in sharing if group.stated is stated for row in _equal(group, len(solution))]
        if not equations or not free.shape[1]:
            continue
        left = np.array(equations)
        move, *_ = np.linalg.lstsq(left @ free, -left @ solution, rcond=None)
        solution = np.asarray(solution + free @ move, dtype=np.float64)
        free = free @ null_space(left @ free)
    return solution


def _equal(group: Sharing, size: int) -> list[Floats]:
    """Return the equations λ_i / share_i = λ_0 / share_0 of a group."""
    equations = []
    for row, share in zip(group.rows[1:], group.share[1:], strict=True):
        equation = np.zeros(size)
        equation[group.rows[0]], equation[row] = share, -group.share[0]
        equations.append(equation)
    return equations


def lossy(matrix: Floats, driving: Floats, driven: Floats, efficiency: Floats) -> Floats:
    """Return the torque matrix with tooth losses: the driven gear receives η times what the driving one gives.

    Args:
        matrix: (rows, nodes) kinematic rows relative to the carrier.
        driving: (rows, nodes) the part of each row that belongs to the gear that drives.
        driven: (rows, nodes) the part of the gear that is driven.
        efficiency: (rows,) η of each row [-].

    Returns:
        (rows, nodes); the carrier takes what keeps the three torques of a mesh in balance.
    """
    carrier = matrix - driving - driven
    loss = (1.0 - efficiency)[:, None]
    drop = driven * loss
    on_carrier = np.where(carrier != 0.0, 1.0, 0.0) * drop.sum(axis=1, keepdims=True)
    result: Floats = matrix - drop + on_carrier
    return result
