"""The torques of many loads of a train that turns one way: one linear system a load, all solved together."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats
from gearwright.spec import GROUND
from gearwright.train.flow.balanced import STANDSTILL
from gearwright.train.flow.turning import Turn

_SLIGHT = 0.5
"""Losses whose row sums stay below this leave one state, as in `senses` [-]."""
_ROUNDS = 8
"""Rounds in which the sides that drive settle; two do."""


class Loads(NamedTuple):
    """What a train carries under many loads."""

    multipliers: Floats
    """Torque per tooth of every mesh row, shape (n, rows) [N m]."""
    first: Floats
    """Torque on gear a of every row, all equal meshes together, shape (n, rows) [N m]."""
    second: Floats
    """Torque on gear b, likewise [N m]."""
    third: Floats
    """Torque on the carrier, likewise [N m]."""
    balancing: Floats
    """Torque of the machine that balances, shape (n,) [N m]."""


def can_be_along(turn: Turn, balancing: int) -> bool:
    """Tell whether `along` solves a train: no clutches, no dampers, and one solution for every load.

    Args:
        turn: How it turns.
        balancing: Node of the machine that balances.
    """
    known = turn.balance((balancing,))
    rows, columns = known.system.shape
    return not turn.train.joints and not turn.train.dampers and rows == columns


def along(turn: Turn, balancing: int, part: Floats, applied: Floats) -> Loads | None:
    """Return the torques under many loads; None where losses are so large that several states may be.

    Args:
        turn: How the train turns; the sense is the same for all loads.
        balancing: Node of the machine that balances.
        part: Part 1 − η that each row loses under each load, shape (n, rows) [-].
        applied: Torques that are given on the nodes, shape (n, nodes) [N m].

    Source: `power_flow`: T + Aᵀ λ = 0 with losses in the direction of the power.
    """
    known, equations = turn.balance((balancing,)), turn.lossy((balancing,))
    felt = np.maximum(np.abs(equations.felt.positive), np.abs(equations.felt.negative)).sum(axis=1)
    if part.size and float(part.max()) * float(felt.max()) >= _SLIGHT:
        return None
    rows, nodes = known.matrix.shape
    asked = np.concatenate([applied, np.zeros((len(applied), len(known.completion)))], axis=1)
    x = -np.einsum("ij,lj->li", known.inverse, asked)
    before: Bools = x[:, :rows] < 0.0
    system = np.broadcast_to(known.scaled, (len(applied), *known.scaled.shape)).copy()
    for _ in range(_ROUNDS):
        alike = before[:1] if (before == before[0]).all() else before  # few trains have loads of both senses
        change = np.where(alike[:, :, None], equations.change.negative, equations.change.positive)
        effective = known.matrix + part[:, :, None] * change
        system[:, :nodes, :rows] = effective.transpose(0, 2, 1) / known.scale[:rows]
        x = np.linalg.solve(system, -asked[:, :, None])[:, :, 0]
        noise = STANDSTILL * np.abs(x).max(axis=1, keepdims=True)
        negative: Bools = np.where(np.abs(x[:, :rows]) <= noise, before, x[:, :rows] < 0.0)
        if np.array_equal(negative, before):
            break
        before = negative
    else:
        return None
    return _collected(turn, x / known.scale, effective)


def _collected(turn: Turn, solution: Floats, effective: Floats) -> Loads:
    train, rows = turn.train, effective.shape[1]
    meshes = len(train.meshes)
    noise = STANDSTILL * np.abs(solution[:, :meshes]).max(axis=1, keepdims=True)
    multipliers = np.where(np.abs(solution[:, :meshes]) > noise, solution[:, :meshes], 0.0)
    torques = np.zeros((3, len(solution), meshes))
    for k, mesh in enumerate(train.meshes):
        for place, node in enumerate(mesh.nodes):
            if node != GROUND:
                torques[place, :, k] = multipliers[:, k] * effective[:, k, train.column[node]]
        for place, node in enumerate(mesh.nodes):
            if node == GROUND:
                torques[place, :, k] = -torques[:, :, k].sum(axis=0)
    return Loads(multipliers, torques[0], torques[1], torques[2], solution[:, rows])
