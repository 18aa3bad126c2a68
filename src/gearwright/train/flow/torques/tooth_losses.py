"""Losses of the teeth: what torques change by the side of a mesh that drives, since the driven one receives less."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.spec import GROUND
from gearwright.train.graph import Train

ROLLS = 1e-10
"""Part of their speed from the ground below which teeth do not roll on each other: their set turns as a block [-]."""


class Laws(NamedTuple):
    """What holds per unit multiplier of every row, by the sign of the multiplier; each (rows, …)."""

    positive: Floats
    negative: Floats

    def of(self, multipliers: Floats) -> Floats:
        """Return what holds with multipliers of given signs, shape (rows, …).

        Args:
            multipliers: Of every row [N m], shape (rows,).
        """
        return np.where(multipliers[:, None] < 0.0, self.negative, self.positive)


def lost(train: Train, matrix: Floats, speeds: Floats) -> Laws:
    """Return what the torques change where a row loses all that it carries, by the sign of the multiplier.

    The driven gear receives less and the carrier bears it. What does not roll loses nothing, whatever it carries.

    Args:
        train: The graph.
        matrix: Rows of meshes and clutches over the nodes, shape (rows, nodes).
        speeds: Of the nodes [rad/s], shape (nodes,).
    """
    rolls = rolling(train, matrix, speeds)
    fastest = np.abs(matrix).max(axis=1, initial=0.0) * np.abs(speeds).max(initial=0.0)
    still = (np.abs(rolls) <= ROLLS * fastest)[:, None]
    first, second = (np.where(still, 0.0, _change(train, matrix, driven)) for driven in (0, 1))
    forwards = rolls[:, None] > 0.0
    return Laws(np.where(forwards, second, first), np.where(forwards, first, second))


def lost_parts(train: Train, rows: int, efficiency: Mapping[str, float]) -> Floats:
    """Return the part 1 − η of what it carries that each row loses [-], shape (rows,); none of clutches.

    Args:
        train: The graph.
        rows: Number of meshes and clutches.
        efficiency: Stage, or mesh row -> efficiency of one mesh [-]; 1 where it is left out.
    """
    part = np.zeros(rows)
    part[: len(train.meshes)] = [
        1.0 - efficiency.get(mesh.name, efficiency.get(mesh.stage, 1.0)) for mesh in train.meshes
    ]
    return part


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


def _change(train: Train, matrix: Floats, driven: int) -> Floats:
    """Return what the torques change where the first (0) or second (1) gear of every row receives nothing."""
    # The ground gets a column here: a ring that stands still is driven too, and its losses load the carrier.
    grounded = np.hstack([matrix, -matrix.sum(axis=1, keepdims=True)])
    column = {node: k for k, node in enumerate((*train.nodes, GROUND))}
    change = np.zeros_like(grounded)
    for k, mesh in enumerate(train.meshes):
        gear, carrier = column[mesh.nodes[driven]], column[mesh.nodes[2]]
        change[k, gear] -= grounded[k, gear]
        change[k, carrier] += grounded[k, gear]
    return change[:, :-1]
