"""Speeds of every node from the teeth and the machines: A ω = 0 with as many given speeds as the train has freedoms."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem
from gearwright.spec import GROUND
from gearwright.train.algebra import RANK_TOLERANCE, null_space, remembered
from gearwright.train.graph import Joint, Train


@dataclass(frozen=True)
class Yielded:
    """A machine whose asked speed the teeth do not give exactly."""

    machine: str
    asked: float
    """Asked speed [rad/s]."""
    actual: float
    """Speed that the teeth give, without its sense [rad/s]."""

    @property
    def deviation(self) -> float:
        """(actual − asked) / asked [-]."""
        return (self.actual - self.asked) / self.asked


def rows(train: Train, teeth: Mapping[str, float], joints: Sequence[Joint]) -> Floats:
    """Return the kinematic matrix A, one row per mesh, then one per engaged clutch.

    Args:
        train: The graph.
        teeth: Tooth number of every gear.
        joints: The clutches that are engaged.

    Returns:
        Shape (rows, nodes); the ground has no column, as it stands still.
    """
    written = []
    for mesh in train.meshes:
        z_a, z_b = teeth[mesh.gears[0]], mesh.sign * teeth[mesh.gears[1]]
        written.append(zip(mesh.nodes, (z_a, -z_b, z_b - z_a), strict=True))
    written += [zip((joint.driving, joint.driven), (1.0, -1.0), strict=True) for joint in joints]
    matrix = np.zeros((len(written), len(train.nodes)))
    for k, entries in enumerate(written):
        for node, value in entries:
            if node != GROUND:
                matrix[k, train.column[node]] += value
    return matrix


def solve_speeds(
    train: Train, matrix: Floats, asked: Mapping[str, float], *, joints: Sequence[Joint] | None = None
) -> tuple[Floats, list[Yielded]]:
    """Return the speed of every node and the machines whose speed had to yield.

    Args:
        train: The graph.
        matrix: From `rows`.
        asked: Machine -> asked speed [rad/s], the one to be kept first. The first ones kept turn
            forwards; the sense of the others follows from the teeth.
        joints: The clutches in the matrix; left out: all.

    Returns:
        Speeds (nodes,) [rad/s], and what yielded.

    Raises:
        DesignError: If a shaft is locked, or speeds stay free; the shafts are named.
    """
    free = motions_of(matrix)
    freedoms, of_node = free.shape[1], free.tolist()
    motions: list[list[float]] = []
    speeds: list[float] = []
    kept: list[str] = []
    for machine, speed in asked.items():
        motion = of_node[train.column[train.machines[machine]]]
        length = math.hypot(*motion)
        if length < RANK_TOLERANCE and speed == 0.0:
            continue  # a brake holds it, and it is to stand still
        if length < RANK_TOLERANCE:
            raise _locked(train, matrix, machine, train.joints if joints is None else joints)
        if len(kept) == freedoms:
            continue  # every freedom is determined
        extended = [*motions, [part / length for part in motion]]
        if not kept or np.linalg.matrix_rank(extended, tol=RANK_TOLERANCE) > len(motions):
            motions = extended
            speeds.append(speed / length)
            kept.append(machine)
    if len(kept) < freedoms:
        raise _free(train, free, np.array(motions), len(kept))
    omega: Floats = free @ _amounts(motions, speeds) if kept else np.zeros(len(train.nodes))
    yielded = [
        Yielded(machine, abs(speed), abs(float(omega[train.column[train.machines[machine]]])))
        for machine, speed in asked.items()
        if machine not in kept and speed
    ]
    return omega, yielded


def _amounts(motions: list[list[float]], speeds: list[float]) -> Floats:
    """Return how much of each free motion gives the kept speeds; most trains have one freedom."""
    if len(speeds) == 1:
        return np.array([speeds[0] / motions[0][0]])
    return np.asarray(np.linalg.solve(motions, speeds), dtype=np.float64)


@remembered
def motions_of(matrix: Floats) -> Floats:
    """Return an orthonormal basis (nodes, freedoms) of the motions that the rows allow.

    Args:
        matrix: From `rows`.
    """
    return null_space(matrix / np.maximum(np.linalg.norm(matrix, axis=1, keepdims=True), 1e-300))


def _locked(train: Train, matrix: Floats, machine: str, joints: Sequence[Joint]) -> DesignError:
    """Say which rows lock a machine's shaft: those without one of which it would turn."""
    shaft = train.machines[machine]
    node = train.column[shaft]
    names = [mesh.name for mesh in train.meshes] + [joint.name for joint in joints]
    guilty = [
        names[k]
        for k in range(len(matrix))
        if np.linalg.norm(null_space(np.delete(matrix, k, axis=0))[node]) > RANK_TOLERANCE
    ]
    loop = f" Their teeth contradict each other around: {', '.join(guilty)}." if guilty else ""
    message = f"{machine} cannot turn it: the train locks it.{loop} Free a member, or give teeth that agree"
    return DesignError([Problem(f"shafts.{shaft}", message)])


def _free(train: Train, free: Floats, motions: Floats, kept: int) -> DesignError:
    """Name the shafts whose speed nothing determines."""
    remaining = free @ null_space(motions) if len(motions) else free
    loose = [name for name, motion in zip(train.nodes, remaining, strict=True) if np.linalg.norm(motion) > 1e-6]
    shafts = [name for name in loose if name not in train.planet_nodes]
    message = (
        f"the speeds of {', '.join(shafts)} are not determined: the train has {free.shape[1]} free speeds and the"
        f" machines give {kept}; give a machine with a speed on one of them, ground a member, or join two shafts"
    )
    return DesignError([Problem("shafts", message)])
