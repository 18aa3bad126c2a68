"""Losses of the teeth: which side of a mesh drives, and the torque matrix with what the driven side receives."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from gearwright.arrays import Floats
from gearwright.spec import GROUND
from gearwright.train.graph import Train
from gearwright.train.statics import lossy


def direction_of(power: Floats, noise: float) -> Floats:
    """Return the sense of each row's tooth power, +1 from a to b; rounding noise of an idle row counts as +1.

    Args:
        power: From gear a to gear b of every row [W], shape (rows,).
        noise: What counts as rounding [W].
    """
    return np.where(power < -noise, -1.0, 1.0)


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
        direction: Sense of each row's tooth power, from `direction_of`.
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
