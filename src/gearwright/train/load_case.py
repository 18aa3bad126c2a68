"""Load cases of a gear train: speeds, torques and powers with losses."""

from __future__ import annotations

from collections.abc import Mapping, Sequence, Set
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from gearwright.base import Bools, Floats, Problem, refuse
from gearwright.elementwise import Values
from gearwright.spec import GROUND, RATED, Design, Drive, case_named, cases_of, drives_of
from gearwright.train.efficiency import (
    STANDSTILL,
    Balanced,
    Turn,
    Turning,
    asked_speeds,
    balanced,
    dragged,
    efficiencies,
    holding,
    jammed,
)
from gearwright.train.graph import Joint, Mesh, Train
from gearwright.train.kinematics import Yielded
from gearwright.train.power_flow import (
    MeshFlow,
    PowerFlow,
)
from gearwright.train.torques import undecided

# ----------------------------------------------------------------------------------------------------------------------
# One load case of a train: every speed, every torque, every power, closed to rounding.
# ----------------------------------------------------------------------------------------------------------------------


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
        SolveError: If losses leave no state in which the train turns, or several.
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
    train, drives, said = turning.train, drives_of(design, case), case_named(design, case).machines
    joints = list(holding(design, train, case))
    while True:
        locked = turning.locked(joints)
        still = locked | left_alone(train, {name for name in drives if _may_drive(drives[name])}, joints)
        asked = _asked(design, turning, case, still)
        signed = {name: abs(speed) * turning.senses[train.machines[name]] for name, speed in asked.items()}
        turn = turning.turn(signed, joints)
        stated, balancing = _machine_torques(said, turning, turn, case=case, locked=locked, drives=drives)
        torques = balanced(design, train, turn, efficiency, stated, balancing=balancing, case=case)
        state = torques.found[0] if torques.found else torques.lossless
        slipping = [
            joint
            for k, joint in enumerate(joints)
            if overruns(joint, state.multipliers[len(train.meshes) + k], train, turn.speeds)
        ]
        if not slipping:
            break
        joints.remove(slipping[0])
    turn = replace(turn, yielded=_blamed(design, train, case, turn.yielded))
    found = [_collect(train, case, turn, state, joints) for state in torques.found]
    if len(found) == 1 and torques.complete:
        return found[0]
    lossless = _collect(train, case, turn, torques.lossless, joints)
    alike = [flow for flow in found if _gives_alike(flow, lossless)]
    if len(alike) == 1 and torques.complete:
        return alike[0]
    ways = efficiencies(design, train, turning.teeth, lossless, efficiency)
    raise jammed(train, lossless, found, ways, complete=torques.complete)


def _gives_alike(flow: PowerFlow, lossless: PowerFlow) -> bool:
    """Tell whether every machine gives or takes as it does without losses: so a train of several states is meant."""
    pairs = [(flow.machine_powers[machine], power) for machine, power in lossless.machine_powers.items()]
    return all(one * other >= 0.0 for one, other in pairs)


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


def left_alone(train: Train, driving: Set[str], joints: Sequence[Joint]) -> frozenset[str]:
    """Return the machines on shafts that open clutches part from everything that may drive them.

    Args:
        train: The graph.
        driving: Machines that may drive: those that balance, and those that give power or torque.
        joints: The clutches that are engaged.
    """
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
    driven = {root(shaft) for name, shaft in train.machines.items() if name in driving}
    return frozenset(name for name, shaft in train.machines.items() if root(shaft) not in driven)


def _may_drive(drive: Drive) -> bool:
    return not drive.stated or (drive.power or 0.0) > 0.0 or (drive.torque or 0.0) > 0.0


def overruns(joint: Joint, multiplier: Values, train: Train, speeds: Floats) -> Values:
    """Tell whether an overrunning clutch has nothing to transmit, or would have to pull its driving shaft.

    Args:
        joint: The clutch.
        multiplier: That it carries, one or shape (n,) [N m].
        train: The graph.
        speeds: Of its nodes, shape (nodes,) [rad/s].
    """
    if not joint.overrunning:
        return False
    turning = 0.0 if joint.driven == GROUND else speeds[train.column[joint.driven]]
    return -multiplier * np.sign(turning or 1.0) <= 1e-9


def _machine_torques(
    said: Mapping[str, Drive],
    turning: Turning,
    turn: Turn,
    *,
    case: str,
    locked: frozenset[str],
    drives: Mapping[str, Drive],
) -> tuple[dict[str, float], list[str]]:
    """Return the torques that the case states, and the machines that balance the rest."""
    train = turning.train
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


def _collect(train: Train, case: str, turn: Turn, state: Balanced, joints: list[Joint]) -> PowerFlow:
    torques, by_node, start = state.machine_torques, state.effective.tolist(), len(train.meshes)
    speed = dict(zip(train.nodes, _told_from_zero(turn.speeds.tolist()), strict=True))
    speed[GROUND] = 0.0
    carried = _told_from_zero(state.multipliers[:start].tolist()) + state.multipliers[start:].tolist()
    meshes = {mesh.name: _mesh_flow(train, mesh, speed, carried[k], by_node[k]) for k, mesh in enumerate(train.meshes)}
    return PowerFlow(
        case=case,
        speeds=speed,
        machine_torques=torques,
        machine_powers={name: torque * speed[train.machines[name]] for name, torque in torques.items()},
        meshes=meshes,
        joints={joint.name: -carried[start + k] for k, joint in enumerate(joints)},
        dampers={damper.name: dragged(train, damper, turn.speeds) for damper in train.dampers},
        yielded=turn.yielded,
    )


def _told_from_zero(values: list[float]) -> list[float]:
    """Return values of which those that are rounding beside the largest are zero: an idle mesh pushes neither way."""
    noise = STANDSTILL * max(map(abs, values), default=0.0)
    return [value if abs(value) > noise else 0.0 for value in values]


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


# ----------------------------------------------------------------------------------------------------------------------
# The torques of many loads of a train that turns one way: one linear system a load, all solved together.
# ----------------------------------------------------------------------------------------------------------------------


_SLIGHT = 0.5
"""Losses whose row sums stay below this leave one state, as in `senses` [-]."""
_ROUNDS = 8
"""Rounds in which the sides that drive settle; two do."""


class Loads(NamedTuple):
    """What a train carries under many loads."""

    multipliers: Floats
    """Torque per tooth of every mesh row, then torque of every engaged clutch, shape (n, rows) [N m]."""
    first: Floats
    """Torque on gear a of every mesh row, all equal meshes together, shape (n, meshes) [N m]."""
    second: Floats
    """Torque on gear b, likewise [N m]."""
    third: Floats
    """Torque on the carrier, likewise [N m]."""
    balancing: Floats
    """Torque of the machine that balances, shape (n,) [N m]."""


def can_be_along(turn: Turn, balancing: int) -> bool:
    """Tell whether `along` solves a train: equilibrium has one solution for every load.

    Args:
        turn: How it turns.
        balancing: Node of the machine that balances.
    """
    known = turn.balance((balancing,))
    rows, columns = known.system.shape
    return rows == columns and not undecided(known, len(turn.matrix)).any()


def is_slight(turn: Turn, balancing: int, part: Floats) -> Bools:
    """Tell under which loads losses are so slight that there is one state, shape (n,).

    Args:
        turn: How the train turns.
        balancing: Node of the machine that balances.
        part: Part 1 − η that each mesh row loses under each load, shape (n, meshes) [-].
    """
    equations = turn.lossy((balancing,))
    felt = np.maximum(np.abs(equations.felt.positive), np.abs(equations.felt.negative)).sum(axis=1)
    return np.asarray(part.max(axis=1, initial=0.0) * felt.max(initial=0.0) < _SLIGHT)


def along(turn: Turn, balancing: int, part: Floats, applied: Floats) -> Loads | None:
    """Return the torques under many loads; None where the sides that drive do not settle.

    Args:
        turn: How the train turns; the sense is the same for all loads.
        balancing: Node of the machine that balances.
        part: Part 1 − η that each mesh row loses under each load, shape (n, meshes) [-], slight (`is_slight`);
            clutches lose nothing.
        applied: Torques that are given on the nodes, shape (n, nodes) [N m].

    Source: `power_flow`: T + Aᵀ λ = 0 with losses in the direction of the power.
    """
    known, equations = turn.balance((balancing,)), turn.lossy((balancing,))
    rows, nodes = known.matrix.shape
    if part.shape[1] < rows:
        part = np.concatenate([part, np.zeros((len(part), rows - part.shape[1]))], axis=1)
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
    multipliers = solution[:, :rows].copy()
    multipliers[:, :meshes] = np.where(np.abs(solution[:, :meshes]) > noise, solution[:, :meshes], 0.0)
    torques = np.zeros((3, len(solution), meshes))
    for k, mesh in enumerate(train.meshes):
        for place, node in enumerate(mesh.nodes):
            if node != GROUND:
                torques[place, :, k] = multipliers[:, k] * effective[:, k, train.column[node]]
        for place, node in enumerate(mesh.nodes):
            if node == GROUND:
                torques[place, :, k] = -torques[:, :, k].sum(axis=0)
    return Loads(multipliers, torques[0], torques[1], torques[2], solution[:, rows])
