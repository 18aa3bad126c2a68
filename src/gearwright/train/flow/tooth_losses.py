"""Losses of the teeth: which side of a mesh drives, and the torque matrix with what the driven side receives."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from gearwright.arrays import Floats
from gearwright.spec import GROUND
from gearwright.train.flow.statics import lossy
from gearwright.train.graph import Train

TOGETHER = 8
"""Rounds in which every row that disagrees is turned; later ones turn the first of them alone [-]."""
MAX_REVERSALS = 1000
"""Rounds in which the direction of the tooth power may still change while losses are found [-]."""


def turned(direction: Floats | None, power: Floats, noise: float, *, together: bool) -> Floats:
    """Return the senses to try next of each row's tooth power, +1 from a to b; the same where all agree.

    The torques with losses are a linear complementarity problem: each row loses on the side that it drives. Turning all
    rows that disagree converges at once as a rule, and may go in circles; turning the first one alone ends wherever
    losses leave one solution. Power within the noise agrees with either sense: such a row loses nothing.

    Args:
        direction: Senses with which the power was found; None: without losses.
        power: From gear a to gear b of every row [W], shape (rows,).
        noise: What counts as rounding [W].
        together: Turn all rows that disagree, not only the first.

    Source: Murty 1974, Note on a Bard-type scheme for solving the complementarity problem, Opsearch 11.
    """
    if direction is None:
        return np.where(power < -noise, -1.0, 1.0)
    wrong = np.flatnonzero(direction * power < -noise)
    following = direction.copy()
    following[wrong if together else wrong[:1]] *= -1.0
    return following


def rolling(train: Train, matrix: Floats, speeds: Floats) -> Floats:
    """Return z_a (ω_a − ω_c) of every mesh row [rad/s], shape (rows,); zero for clutches.

    Args:
        train: The graph.
        matrix: Rows of meshes and clutches over the nodes, shape (rows, nodes).
        speeds: Of the nodes [rad/s], shape (nodes,).
    """
    value = {**dict(zip(train.nodes, speeds, strict=True)), GROUND: 0.0}
    relative = np.zeros(len(matrix))
    for k, mesh in enumerate(train.meshes):
        first, _, carrier = mesh.nodes
        relative[k] = _teeth_of(train, matrix, k) * (value[first] - value[carrier])
    return -relative


def _teeth_of(train: Train, matrix: Floats, row: int) -> float:
    """Return z_a of a mesh row from the matrix, also where gear a is on the ground."""
    first, second, carrier = train.meshes[row].nodes
    entry = {node: matrix[row, train.column[node]] for node in (first, second, carrier) if node != GROUND}
    return float(entry[first] if first in entry else -entry[second] - entry[carrier])


def with_losses(train: Train, matrix: Floats, direction: Floats, efficiency: Mapping[str, float]) -> Floats:
    """Return the torque matrix of meshes whose driving side is known, shape (rows, nodes).

    Args:
        train: The graph.
        matrix: Rows of meshes and clutches over the nodes, shape (rows, nodes).
        direction: Sense of each row's tooth power, from `turned`.
        efficiency: Stage, or mesh row -> efficiency of one mesh [-]; 1 where it is left out.
    """
    kept = np.ones(len(matrix))
    kept[: len(train.meshes)] = [efficiency.get(mesh.name, efficiency.get(mesh.stage, 1.0)) for mesh in train.meshes]
    # The ground gets a column here: a ring that stands still is driven too, and its losses load the carrier.
    grounded = np.hstack([matrix, -matrix.sum(axis=1, keepdims=True)])
    column = {node: k for k, node in enumerate((*train.nodes, GROUND))}
    driving, driven = np.zeros_like(grounded), np.zeros_like(grounded)
    for k, mesh in enumerate(train.meshes):
        ends = mesh.nodes[:2] if direction[k] > 0.0 else mesh.nodes[1::-1]
        for node, part in zip(ends, (driving, driven), strict=True):
            part[k, column[node]] = grounded[k, column[node]]
    return lossy(grounded, driving, driven, kept)[:, :-1]
