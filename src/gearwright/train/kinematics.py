"""Kinematics of the gear train: speeds of shafts and planets, and speed relations of its stages."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TypeVar

import numpy as np

from gearwright.base import SIDES, DesignError, Floats, Kind, Problem, Role
from gearwright.spec import GROUND, Design, Epicyclic, Pair, Planetary
from gearwright.train.graph import (
    RANK_TOLERANCE,
    Joint,
    Train,
    epicyclic_gears,
    epicyclic_meshes,
    null_space,
    remembered,
    shafts_of,
)

# ----------------------------------------------------------------------------------------------------------------------
# Speeds of every node from the teeth and the machines: A ω = 0 with as many given speeds as the train has freedoms.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# A stage as a relation between its shafts' speeds: one ratio between two of them, or Willis's equation of three.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Edge:
    """A stage as one ratio between two shafts: ω_fast / ω_slow = ratio(tooth ratio)."""

    stage: str
    fast: tuple[str, ...]
    """Shafts of the pinions, or of the sun (of the ring where the sun stands still)."""
    slow: tuple[str, ...]
    """Shafts of the wheels, or the other turning member's."""
    grounded: Role | Kind | None
    """Member of a planetary set that stands still; None for a pair, whose axes do."""

    def ratio(self, tooth_ratio: float) -> float:
        """Return the speed ratio of a tooth ratio z_2/z_1 or z_r/z_s [-]."""
        match self.grounded:
            case Role.RING:
                return 1.0 + tooth_ratio
            case Role.SUN:
                return 1.0 + 1.0 / tooth_ratio
            case _:
                return tooth_ratio

    def tooth_ratio(self, ratio: float) -> float:
        """Return the tooth ratio of a speed ratio [-]."""
        match self.grounded:
            case Role.RING:
                return ratio - 1.0
            case Role.SUN:
                return 1.0 / (ratio - 1.0)
            case _:
                return ratio


def edge_of(name: str, design: Design) -> Edge | None:
    """Return a stage as an edge between shafts, or None for a differential and for a compound set (see `ties_of`).

    Args:
        name: Name of the stage.
        design: The design.
    """
    stage = design.stages[name]
    if isinstance(stage, Epicyclic):
        return None
    if isinstance(stage, Pair):
        pinions, wheels = (shafts_of(side, stage, design) for side in SIDES)
        return Edge(name, tuple(pinions), tuple(wheels), None)
    if stage.ring == GROUND:
        return Edge(name, (stage.sun,), (stage.carrier,), Role.RING)
    if stage.carrier == GROUND:
        return Edge(name, (stage.sun,), (stage.ring,), Kind.CARRIER)
    if stage.sun == GROUND:
        return Edge(name, (stage.ring,), (stage.carrier,), Role.SUN)
    return None


def given_tooth_ratio(stage: Pair | Planetary) -> float | None:
    """Return the tooth ratio that a stage's own teeth give, if they do [-].

    Args:
        stage: As in the design.
    """
    if isinstance(stage, Pair):
        return stage.wheel_teeth / stage.pinion_teeth if stage.pinion_teeth and stage.wheel_teeth else None
    if stage.sun_teeth and stage.ring_teeth:
        return stage.ring_teeth / stage.sun_teeth
    known = stage.known_teeth
    return known[2] / known[0] if known else None


def asked_tooth_ratio(stage: Pair | Planetary) -> float | None:
    """Return the tooth ratio that a stage's teeth or its asked ratio give, if either does [-].

    Args:
        stage: As in the design.
    """
    if (tooth_ratio := given_tooth_ratio(stage)) is not None or stage.ratio is None:
        return tooth_ratio
    return stage.ratio if isinstance(stage, Pair) else stage.ratio - 1.0


def members_of(stage: Planetary) -> tuple[str, str, str]:
    """Return the shafts of sun, ring and carrier.

    Args:
        stage: A planetary set.
    """
    return stage.sun, stage.ring, stage.carrier


def willis_ratio(stage: Planetary, speeds: Mapping[str, Floats]) -> Floats:
    """Return z_r/z_s that lets the members turn at given speeds [-].

    Args:
        stage: A planetary set.
        speeds: Shaft -> speed without its sense; the ground is zero [rad/s].

    Source: Willis 1841, ω_s − ω_c = −(z_r/z_s) (ω_r − ω_c); with the carrier held the ring turns backwards.
    """
    sun, ring, carrier = (speeds[member] for member in members_of(stage))
    if stage.carrier == GROUND:
        return np.asarray(sun / ring)
    with np.errstate(divide="ignore"):
        return np.asarray((sun - carrier) / (carrier - ring))


def willis_speed(stage: Planetary, member: str, ratio: Floats, speeds: Mapping[str, Floats]) -> Floats:
    """Return the speed of one member from those of the other two, without its sense [rad/s].

    Args:
        stage: A planetary set.
        member: Shaft whose speed is asked.
        ratio: z_r/z_s [-].
        speeds: Shaft -> speed of the others [rad/s].

    Source: Willis 1841, ω_s + (z_r/z_s) ω_r = (1 + z_r/z_s) ω_c.
    """
    zero = np.zeros(len(ratio))
    sun, ring, carrier = (speeds.get(shaft, zero) for shaft in members_of(stage))
    if member == stage.sun:
        return np.abs((1.0 + ratio) * carrier - ratio * ring)
    if member == stage.ring:
        return np.abs(((1.0 + ratio) * carrier - sun) / ratio)
    return np.abs((sun + ratio * ring) / (1.0 + ratio))


# ----------------------------------------------------------------------------------------------------------------------
# Speeds that a compound set ties to each other: its teeth are given, so that a held member leaves known ratios.
# ----------------------------------------------------------------------------------------------------------------------


Speed = TypeVar("Speed", float, Floats)
STANDS = 1e-9
"""Part of the motion below which a shaft stands still [-]."""


def ties_of(design: Design, name: str) -> dict[str, float]:
    """Return shaft -> speed, signed and relative to each other, of a compound set with one freedom; else nothing.

    Args:
        design: As typed.
        name: Of one of its compound sets.
    """
    epicyclic = design.epicyclics[name]
    gears, meshes = tuple(epicyclic_gears(name, epicyclic)), tuple(epicyclic_meshes(name, epicyclic))
    shafts = [shaft for shaft in dict.fromkeys(epicyclic.members) if shaft != GROUND]
    planets = dict.fromkeys(node for gear in gears for node in gear.nodes if node not in (*shafts, GROUND))
    train = Train((*shafts, *planets), gears, meshes, (), (), {})
    motions = null_space(rows(train, teeth_of(design, name), ()))
    if motions.shape[1] != 1:
        return {}
    speeds = {shaft: float(motions[train.column[shaft], 0]) for shaft in shafts}
    return {shaft: speed for shaft, speed in speeds.items() if abs(speed) > STANDS}


def handed_on(ties: Mapping[str, float], known: Mapping[str, Speed]) -> dict[str, Speed]:
    """Return the speeds that a compound set adds to those that are known, without their sense.

    Args:
        ties: From `ties_of`.
        known: Shaft -> speed [rad/s].
    """
    source = next((shaft for shaft in ties if shaft in known), "")
    if not source:
        return {}
    return {shaft: known[source] * abs(tied / ties[source]) for shaft, tied in ties.items() if shaft not in known}


def teeth_of(design: Design, name: str) -> dict[str, int]:
    """Return the tooth number of every gear of a compound set.

    Args:
        design: As typed.
        name: Of the set.
    """
    epicyclic = design.epicyclics[name]
    return {gear.name: epicyclic.toothed[gear.own].teeth for gear in epicyclic_gears(name, epicyclic)}
