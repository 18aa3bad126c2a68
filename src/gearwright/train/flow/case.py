"""One load case of a train: every speed, every torque, every power, closed to rounding."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import Problem, SolveError, refuse
from gearwright.spec import GROUND, RATED, Design, Drive, Pair, case_named, cases_of, drives_of
from gearwright.train.flow.refusals import ambiguous, unbalanced
from gearwright.train.flow.statics import Sharing, balance, solve_torques, undecided
from gearwright.train.flow.tooth_losses import MAX_REVERSALS, TOGETHER, rolling, turned, with_losses
from gearwright.train.flow.turning import Turn, Turning, asked_speeds, holding
from gearwright.train.graph import Damper, Joint, Mesh, Train
from gearwright.train.kinematics import Yielded

STANDSTILL = 1e-12
"""Speed below this part of the largest one is rounding of a shaft that stands still."""


@dataclass(frozen=True)
class MeshFlow:
    """What one row of equal meshes carries."""

    name: str
    multiplier: float
    """Torque per tooth of all equal meshes together, λ [N m]."""
    torques: tuple[float, float, float]
    """Torque on the nodes of gear a, gear b and carrier, all equal meshes together [N m]."""
    tooth_power: float
    """Power through the teeth relative to the carrier, positive from a to b [W]."""
    loss: float
    """Power lost in the teeth [W]."""


@dataclass(frozen=True)
class Dragged:
    """What a damper carries."""

    torque: float
    """That it gives to its driven shaft [N m]."""
    slip: float
    """Speed of its driving shaft over the driven one [rad/s]."""

    @property
    def loss(self) -> float:
        """Heat [W]."""
        return self.torque * self.slip


@dataclass(frozen=True)
class PowerFlow:
    """A balanced load case."""

    case: str
    speeds: Mapping[str, float]
    """Node -> speed [rad/s]; the ground is in it with zero."""
    machine_torques: Mapping[str, float]
    """Machine -> torque on its shaft [N m]."""
    machine_powers: Mapping[str, float]
    """Machine -> power into the train [W]; negative takes power out."""
    meshes: Mapping[str, MeshFlow]
    """Mesh row -> what it carries."""
    joints: Mapping[str, float] = field(default_factory=dict)
    """Engaged clutch -> torque that it gives to its driven shaft [N m]; an open one is not in it."""
    dampers: Mapping[str, Dragged] = field(default_factory=dict)
    """Damper -> what it carries."""
    yielded: tuple[Yielded, ...] = ()
    """Machines whose asked speed the teeth give only nearly."""

    @property
    def loss(self) -> float:
        """Power lost in all meshes and dampers [W]."""
        return sum(mesh.loss for mesh in self.meshes.values()) + sum(damper.loss for damper in self.dampers.values())

    def given(self, link: str) -> float:
        """Return the torque that a clutch or damper gives to its driven shaft [N m]; zero of an open clutch.

        Args:
            link: Its name.
        """
        return self.dampers[link].torque if link in self.dampers else self.joints.get(link, 0.0)

    @property
    def residual(self) -> float:
        """Power in minus power out minus losses, as a part of the power in [-]."""
        powers = self.machine_powers.values()
        supplied = sum(power for power in powers if power > 0.0)
        return abs(sum(powers) - self.loss) / supplied if supplied else 0.0


def power_flow(
    design: Design, train: Train, teeth: Mapping[str, float], case: str = RATED, *,
    efficiency: Mapping[str, float] | None = None, turning: Turning | None = None,
) -> PowerFlow:  # fmt: skip
    """Return the speeds, torques and powers of a case.

    Args:
        design: With machines and cases.
        train: Its graph.
        teeth: Tooth number of every gear.
        case: Name of the case.
        efficiency: Stage -> efficiency of each of its meshes [-]; left out: lossless.
        turning: Of this train and teeth, where many cases are solved; left out: made anew.

    Raises:
        DesignError: If shafts are locked or free, or no torques balance.
        SolveError: If losses leave no steady direction of the power.
    """
    return _flow(design, turning or Turning(design, train, teeth), case, efficiency or {})


def power_flows(
    design: Design, turning: Turning, *, efficiency: Mapping[str, float] | None = None
) -> dict[str, PowerFlow]:
    """Return the speeds, torques and powers of every case, the one first that speaks for the design.

    Args:
        design: With machines and cases.
        turning: Its graph with the teeth.
        efficiency: Stage -> efficiency of each of its meshes [-]; left out: lossless.

    Raises:
        DesignError: As `power_flow`.
        SolveError: As `power_flow`.
    """
    return {case: _flow(design, turning, case, efficiency or {}) for case in cases_of(design)}


def _flow(design: Design, turning: Turning, case: str, efficiency: Mapping[str, float]) -> PowerFlow:
    train, drives = turning.train, drives_of(design, case)
    joints = list(holding(design, train, case))
    while True:
        locked = turning.locked(joints)
        still = locked | _left_alone(train, drives, joints)
        asked = _asked(design, turning, case, still)
        signed = {name: abs(speed) * turning.senses[train.machines[name]] for name, speed in asked.items()}
        turn = turning.turn(signed, joints)
        stated, balancing = _machine_torques(design, turning, turn, case=case, locked=locked)
        balanced = _balance(design, train, turn, efficiency, stated, balancing=balancing, case=case)
        slipping = [
            joint
            for k, joint in enumerate(joints)
            if _overruns(joint, balanced.multipliers[len(train.meshes) + k], train, turn.speeds)
        ]
        if not slipping:
            break
        joints.remove(slipping[0])
    return _collect(train, case, replace(turn, yielded=_blamed(design, train, case, turn.yielded)), balanced, joints)


def _blamed(design: Design, train: Train, case: str, yielded: tuple[Yielded, ...]) -> tuple[Yielded, ...]:
    """Return the asked speeds that count in a case: rated ones are those of the gear of the first case."""
    if holding(design, train, case) == holding(design, train, cases_of(design)[0]):
        return yielded
    said = case_named(design, case).machines
    return tuple(speed for speed in yielded if speed.machine in said and said[speed.machine].speed is not None)


def _asked(design: Design, turning: Turning, case: str, still: frozenset[str]) -> Mapping[str, float]:
    """Return the asked speeds, zero for the machines that stand still unless the case gives them a speed."""
    said = case_named(design, case).machines
    stated = any(drive.speed is not None for drive in said.values())
    asked = asked_speeds(design, said) if stated else turning.asked
    standing = [name for name in still if name not in said or said[name].speed is None]
    return {**asked, **dict.fromkeys(standing, 0.0)}


def _left_alone(train: Train, drives: Mapping[str, Drive], joints: Sequence[Joint]) -> frozenset[str]:
    """Return the machines on shafts that open clutches part from everything that may drive them."""
    if len(joints) == len(train.joints):
        return frozenset()
    part = {node: node for node in (*train.nodes, GROUND)}

    def root(node: str) -> str:
        while part[node] != node:
            node = part[node]
        return node

    ends = [mesh.nodes for mesh in train.meshes] + [(joint.driving, joint.driven) for joint in joints]
    for nodes in ends:
        first, *others = (node for node in nodes if node != GROUND)
        for other in others:
            part[root(other)] = root(first)
    driven = {root(shaft) for name, shaft in train.machines.items() if _may_drive(drives[name])}
    return frozenset(name for name, shaft in train.machines.items() if root(shaft) not in driven)


def _may_drive(drive: Drive) -> bool:
    return not drive.stated or (drive.power or 0.0) > 0.0 or (drive.torque or 0.0) > 0.0


def _overruns(joint: Joint, multiplier: float, train: Train, speeds: Floats) -> bool:
    """Tell whether an overrunning clutch has nothing to transmit, or would have to pull its driving shaft."""
    if not joint.overrunning:
        return False
    turning = 0.0 if joint.driven == GROUND else speeds[train.column[joint.driven]]
    return bool(-multiplier * np.sign(turning or 1.0) <= 1e-9)


class _Balanced(NamedTuple):
    """The torques of a case in balance."""

    machine_torques: dict[str, float]
    """Machine -> torque on its shaft [N m]."""
    multipliers: Floats
    """Torque per tooth of every mesh row, then torque of every engaged clutch [N m]."""
    effective: Floats
    """(rows, nodes): torque on a node per multiplier [-], losses included."""


def _balance(
    design: Design, train: Train, turn: Turn, efficiency: Mapping[str, float], stated: Mapping[str, float], *,
    balancing: Sequence[str], case: str,
) -> _Balanced:  # fmt: skip
    """Return the torques that balance a case, with losses in the direction of the power."""
    matrix, speeds = turn.matrix, turn.speeds
    applied = _applied(train, speeds, stated)
    taking = [train.column[train.machines[name]] for name in balancing]
    sharing = _sharing(design, train)
    rolls = rolling(train, matrix, speeds)
    noise = 1e-9 * float(np.abs(applied * speeds).max(initial=0.0))
    effective, known = matrix, turn.balance(taking)
    open_ = undecided(known, len(matrix))
    if open_.any():
        raise ambiguous(design, case, [name for name, free in zip(balancing, open_, strict=True) if free])
    direction: Floats | None = None
    for attempt in range(MAX_REVERSALS):
        solved = solve_torques(known, applied, sharing=sharing)
        if solved is None:
            raise unbalanced(train, balancing, case)
        multipliers, rest = solved[: len(matrix)], solved[len(matrix) :]
        if all(value == 1.0 for value in efficiency.values()):
            break
        before, power = direction, multipliers * rolls
        direction = turned(before, power, noise, together=attempt < TOGETHER)
        if before is not None and np.array_equal(before, direction):
            break
        effective = with_losses(train, matrix, direction, efficiency)
        known = balance(effective, taking)
    else:
        raise SolveError(
            f"cases.{case}: no direction of the power through the teeth agrees with their losses: more power"
            " circulates than the machines give, and the train locks itself. Use higher efficiencies, or other teeth"
        )
    return _Balanced({**stated, **dict(zip(balancing, rest.tolist(), strict=True))}, multipliers, effective)


def _applied(train: Train, speeds: Floats, stated: Mapping[str, float]) -> Floats:
    """Return the torques on every node that are given: of machines and dampers [N m]."""
    applied = np.zeros(len(train.nodes))
    for name, torque in stated.items():
        applied[train.column[train.machines[name]]] += torque
    for damper in train.dampers:
        torque = _dragged(train, damper, speeds).torque
        applied[train.column[damper.driven]] += torque
        applied[train.column[damper.driving]] -= torque
    return applied


def _machine_torques(
    design: Design, turning: Turning, turn: Turn, *, case: str, locked: frozenset[str]
) -> tuple[dict[str, float], list[str]]:
    """Return the torques that the case states, and the machines that balance the rest."""
    train, drives, said = turning.train, drives_of(design, case), case_named(design, case).machines
    stated: dict[str, float] = {}
    balancing: list[str] = []
    problems: list[Problem] = []
    for name, shaft in train.machines.items():
        drive, speed = drives[name], float(turn.speeds[train.column[shaft]])
        if not drive.stated and name in locked and name not in said:
            stated[name] = 0.0  # a brake balances it
        elif not drive.stated:
            balancing.append(name)
        elif drive.torque is not None:
            stated[name] = drive.torque * (np.sign(speed) or turning.senses[shaft])
        elif not drive.power or (speed == 0.0 and name not in said and drive.power < 0.0):
            stated[name] = 0.0  # what takes power of its own takes none from a shaft that stands still
        elif speed == 0.0:
            message = f"{drive.power / 1e3:g} kW at standstill: its shaft {shaft!r} does not turn; give its torque"
            problems.append(Problem(f"cases.{case}.{name}", message))
        else:
            stated[name] = drive.power / speed
    refuse(problems)
    return stated, balancing


def _sharing(design: Design, train: Train) -> list[Sharing]:
    groups = []
    for stage, pair in design.pairs.items():
        rows = tuple(k for k, mesh in enumerate(train.meshes) if mesh.stage == stage)
        if len(rows) > 1:
            groups.append(Sharing(rows, _shares(pair, len(rows)), stated=pair.share is not None))
    return groups


def _shares(pair: Pair, count: int) -> tuple[float, ...]:
    return tuple(pair.share) if pair.share is not None else (1.0 / count,) * count


def _collect(train: Train, case: str, turn: Turn, balanced: _Balanced, joints: list[Joint]) -> PowerFlow:
    torques, carried, by_node = balanced.machine_torques, balanced.multipliers.tolist(), balanced.effective.tolist()
    solved_speeds = turn.speeds.tolist()
    noise = STANDSTILL * max(map(abs, solved_speeds), default=0.0)
    speed = {name: value if abs(value) > noise else 0.0 for name, value in zip(train.nodes, solved_speeds, strict=True)}
    speed[GROUND] = 0.0
    meshes = {mesh.name: _mesh_flow(train, mesh, speed, carried[k], by_node[k]) for k, mesh in enumerate(train.meshes)}
    start = len(train.meshes)
    return PowerFlow(
        case=case,
        speeds=speed,
        machine_torques=torques,
        machine_powers={name: torque * speed[train.machines[name]] for name, torque in torques.items()},
        meshes=meshes,
        joints={joint.name: -carried[start + k] for k, joint in enumerate(joints)},
        dampers={damper.name: _dragged(train, damper, turn.speeds) for damper in train.dampers},
        yielded=turn.yielded,
    )


def _dragged(train: Train, damper: Damper, speeds: Floats) -> Dragged:
    """Return what a damper carries; a slip that is rounding of the speeds is none."""
    slip = float(speeds[train.column[damper.driving]] - speeds[train.column[damper.driven]])
    slip = slip if abs(slip) > STANDSTILL * float(np.abs(speeds).max(initial=0.0)) else 0.0
    return Dragged(damper.damping * slip, slip)


def _mesh_flow(
    train: Train, mesh: Mesh, speed: Mapping[str, float], multiplier: float, effective: list[float]
) -> MeshFlow:
    """Return what a row carries; a member on the ground takes what the other two leave."""
    torque = {node: multiplier * effective[train.column[node]] for node in mesh.nodes if node != GROUND}
    if len(torque) < len(mesh.nodes):
        torque[GROUND] = -sum(torque.values())
    first, second, third = mesh.nodes
    on_first, on_second = torque[first], torque[second]
    inward = -on_first * (speed[first] - speed[third])
    outward = on_second * (speed[second] - speed[third])
    return MeshFlow(mesh.name, multiplier, (on_first, on_second, torque[third]), inward, inward - outward)
