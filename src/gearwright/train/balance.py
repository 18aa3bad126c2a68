"""Speeds and balanced torques of a load case, and reasons why a load case has no unique balance."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem
from gearwright.spec import GROUND, Design, Drive, case_named, cases_of
from gearwright.train.algebra import RANK_TOLERANCE
from gearwright.train.graph import Damper, Joint, Train
from gearwright.train.kinematics import Yielded, motions_of, rows, solve_speeds
from gearwright.train.power_flow import Dragged
from gearwright.train.torques import (
    Balance,
    Laws,
    Lossy,
    Sharing,
    State,
    balance,
    lossy,
    lost,
    lost_parts,
    sharing_of,
    solve_lossless,
    solve_lossy,
    undecided,
)

# ----------------------------------------------------------------------------------------------------------------------
# How a train turns: the speeds that a load case asks for, and those that the teeth give.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Turn:
    """One way in which a train turns."""

    matrix: Floats
    """From `rows`."""
    speeds: Floats
    """Of every node [rad/s]."""
    yielded: tuple[Yielded, ...]
    """Machines whose asked speed the teeth give only nearly."""
    train: Train
    """What turns."""
    sharing: Sequence[Sharing]
    """Parallel rows."""
    balances: dict[tuple[int, ...], Balance] = field(default_factory=dict)
    """Nodes of balancing machines -> equations of the torques without losses."""
    equations: dict[tuple[int, ...], Lossy] = field(default_factory=dict)
    """The same with losses."""

    @cached_property
    def lost(self) -> Laws:
        """What the torques change where teeth lose all that they carry."""
        return lost(self.train, self.matrix, self.speeds)

    def balance(self, balancing: Sequence[int]) -> Balance:
        """Return the equations of the torques without losses, made once.

        Args:
            balancing: Nodes of the machines whose torque balances.
        """
        key = tuple(balancing)
        if key not in self.balances:
            self.balances[key] = balance(self.matrix, balancing, self.sharing)
        return self.balances[key]

    def lossy(self, balancing: Sequence[int]) -> Lossy:
        """Return the equations of the torques, made once.

        Args:
            balancing: Nodes of the machines whose torque balances.
        """
        key = tuple(balancing)
        if key not in self.equations:
            self.equations[key] = lossy(self.balance(balancing), self.lost)
        return self.equations[key]


class Turning:
    """The speeds of a train with its teeth. Load cases often turn alike: each way is solved once."""

    def __init__(self, design: Design, train: Train, teeth: Mapping[str, float]) -> None:
        self.train, self.teeth = train, teeth
        self._known: dict[tuple[object, ...], Turn] = {}
        self.sharing = sharing_of(design, train)
        """Parallel rows, and the share of each that the design states."""
        self.asked = asked_speeds(design, {})
        """Machine -> rated speed [rad/s], the one to be kept first."""
        rated = self.turn(self.asked, holding(design, train, cases_of(design)[0]))
        self.yielded = rated.yielded
        """Machines whose rated speed the teeth give only nearly."""
        self.senses = {
            node: -1.0 if speed < 0.0 else 1.0 for node, speed in zip(train.nodes, rated.speeds.tolist(), strict=True)
        }
        """Node -> sense in which it turns, ±1: that of the rated speeds, whatever drives in a case."""

    def turn(self, asked: Mapping[str, float], joints: Sequence[Joint]) -> Turn:
        """Return how the train turns at asked speeds.

        Args:
            asked: Machine -> speed [rad/s], the one to be kept first.
            joints: The clutches that are engaged.

        Raises:
            DesignError: If a shaft is locked, or speeds stay free.
        """
        key = (*joints, *asked.items())
        if key not in self._known:
            matrix = rows(self.train, self.teeth, joints)
            speeds, yielded = solve_speeds(self.train, matrix, asked, joints=joints)
            self._known[key] = Turn(matrix, speeds, tuple(yielded), self.train, self.sharing)
        return self._known[key]

    def locked(self, joints: Sequence[Joint]) -> frozenset[str]:
        """Return the machines whose shafts the brakes that hold keep from turning.

        Args:
            joints: The clutches and brakes that hold.
        """
        if not any(joint.is_brake for joint in joints):
            return frozenset()
        motions = motions_of(rows(self.train, self.teeth, joints))
        still = np.linalg.norm(motions, axis=1) < RANK_TOLERANCE
        return frozenset(name for name, shaft in self.train.machines.items() if still[self.train.column[shaft]])


def holding(design: Design, train: Train, case: str) -> tuple[Joint, ...]:
    """Return the clutches and brakes that hold in a case; an overrunning one may open by itself.

    Args:
        design: With its cases.
        train: The graph.
        case: Name of the case.
    """
    engaged = case_named(design, case).engaged
    return tuple(
        joint
        for joint in train.joints
        if joint.overrunning or (not joint.is_open if engaged is None else joint.name in engaged)
    )


def asked_speeds(design: Design, drives: Mapping[str, Drive]) -> dict[str, float]:
    """Return machine -> asked speed [rad/s] in the order in which they are kept.

    Args:
        design: With the machines' rated speeds and the order of keeping.
        drives: The case; a speed given there comes first and replaces the rated one.
    """
    machines = design.machines
    order = dict.fromkeys([*(design.speeds.keep or []), *machines])
    speeds = {name: drives[name].speed for name in order if name in drives}
    if all(speed is None for speed in speeds.values()):
        speeds = {name: machines[name].asked_speed for name in order}
    asked = {name: speed for name, speed in speeds.items() if speed is not None}
    reversed_ = {name for name, motor in design.motors.items() if motor.reverse}
    return {name: -speed if name in reversed_ else speed for name, speed in asked.items()}


# ----------------------------------------------------------------------------------------------------------------------
# Why a load case has no torques, or more than one set of them, and what would do.
# ----------------------------------------------------------------------------------------------------------------------


def ambiguous(design: Design, case: str, undecided: Sequence[str]) -> DesignError:
    """Return the error of a case in which equilibrium leaves open how machines divide what the others leave.

    Args:
        design: With its cases.
        case: Name of the case.
        undecided: The machines that balance and whose torque equilibrium does not decide.
    """
    names = " and ".join(undecided)
    write, many = f"[cases.{case}.{undecided[-1]}] power_kw = -100", "both" if len(undecided) == 2 else "all"
    missing = ""
    if case not in design.cases:
        missing = f"; {case!r}, every machine at its rating, is the case of a design without cases"
        drives = " and ".join(f"[cases.take-off.{name}] rating = 1" for name in (*design.turbines, *design.motors))
        write = f"{drives} with [cases.take-off.{undecided[-1]}] power_kw = -100"
    return DesignError([
        Problem(
            f"cases.{case}",
            f"{names} {many} balance one branch, and nothing says how they divide its power{missing}; give the"
            f" power or torque of all but one, such as {write} (negative takes power), or 0 for one that idles",
        )
    ])  # fmt: skip


def unbalanced(train: Train, balancing: Sequence[str], case: str) -> DesignError:
    """Return the error of a case in which no torques balance.

    Args:
        train: The graph.
        balancing: The machines that are free to balance.
        case: Name of the case.
    """
    takers = ", ".join(balancing) or "no machine"
    held = {mesh.stage for mesh in train.meshes if GROUND in mesh.nodes}
    loose = ", ".join(dict.fromkeys(mesh.stage for mesh in train.meshes if mesh.stage not in held))
    fix = (
        f"All three members of {loose} turn: ground one, or put a machine that balances on each"
        if loose
        else "Join the shafts, engage a clutch, or leave out the power of one more machine so that it balances"
    )
    return DesignError([
        Problem(
            f"cases.{case}",
            f"no torques balance: {takers} is free to balance, and the power of some machine has no path to it. {fix}",
        )
    ])  # fmt: skip


# ----------------------------------------------------------------------------------------------------------------------
# The torques of one load case in balance, with losses in the direction of the power.
# ----------------------------------------------------------------------------------------------------------------------


STANDSTILL = 1e-12
"""Speed below this part of the largest one is rounding of a shaft that stands still."""


class Balanced(NamedTuple):
    """The torques of a case in balance."""

    machine_torques: dict[str, float]
    """Machine -> torque on its shaft [N m]."""
    multipliers: Floats
    """Torque per tooth of every mesh row, then torque of every engaged clutch [N m]."""
    effective: Floats
    """(rows, nodes): torque on a node per multiplier [-], losses included."""


class Torques(NamedTuple):
    """All states in which a case is in balance."""

    lossless: Balanced
    """Without losses."""
    found: list[Balanced]
    """With losses, each with tooth powers whose senses agree with them."""
    complete: bool
    """Whether there is certainly no other."""


def balanced(
    design: Design, train: Train, turn: Turn, efficiency: Mapping[str, float], stated: Mapping[str, float], *,
    balancing: Sequence[str], case: str,
) -> Torques:  # fmt: skip
    """Return the torques that balance a case, with losses in the direction of the power.

    Args:
        design: With machines and cases.
        train: Its graph.
        turn: How it turns.
        efficiency: Stage, or mesh row -> efficiency of one mesh [-]; 1 where it is left out.
        stated: Machine -> torque that the case gives [N m].
        balancing: Machines that balance the rest.
        case: Name of the case.

    Raises:
        DesignError: If no torques balance, or equilibrium leaves open what a machine gives.
    """
    applied = _applied(train, turn.speeds, stated)
    nodes = [train.column[train.machines[name]] for name in balancing]
    known, part = turn.balance(nodes), lost_parts(train, len(turn.matrix), efficiency)
    open_ = undecided(known, len(turn.matrix))
    if open_.any():
        raise ambiguous(design, case, [name for name, free in zip(balancing, open_, strict=True) if free])
    solved = solve_lossy(turn.lossy(nodes), part, applied) if part.any() else solve_lossless(known, applied)
    if solved is None:
        raise unbalanced(train, balancing, case)

    def named(state: State) -> Balanced:
        torques = {**stated, **dict(zip(balancing, state.machines.tolist(), strict=True))}
        return Balanced(torques, state.multipliers, state.effective)

    return Torques(named(solved.lossless), [named(state) for state in solved.found], solved.complete)


def _applied(train: Train, speeds: Floats, stated: Mapping[str, float]) -> Floats:
    """Return the torques on every node that are given: of machines and dampers [N m]."""
    applied = np.zeros(len(train.nodes))
    for name, torque in stated.items():
        applied[train.column[train.machines[name]]] += torque
    for damper in train.dampers:
        torque = dragged(train, damper, speeds).torque
        applied[train.column[damper.driven]] += torque
        applied[train.column[damper.driving]] -= torque
    return applied


def dragged(train: Train, damper: Damper, speeds: Floats) -> Dragged:
    """Return what a damper carries; a slip that is rounding of the speeds is none.

    Args:
        train: The graph.
        damper: One of its dampers.
        speeds: Of the nodes [rad/s], shape (nodes,).
    """
    slip = float(speeds[train.column[damper.driving]] - speeds[train.column[damper.driven]])
    slip = slip if abs(slip) > STANDSTILL * float(np.abs(speeds).max(initial=0.0)) else 0.0
    return Dragged(damper.damping * slip, slip)
