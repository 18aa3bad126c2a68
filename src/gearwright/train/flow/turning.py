"""How a train turns: the speeds that a load case asks for, and those that the teeth give."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from gearwright.arrays import Floats
from gearwright.spec import Design, Drive, case_named, cases_of
from gearwright.train.algebra import RANK_TOLERANCE
from gearwright.train.flow.torques import Balance, Laws, Lossy, Sharing, balance, lossy, lost, sharing_of
from gearwright.train.graph import Joint, Train
from gearwright.train.kinematics import Yielded, motions_of, rows, solve_speeds


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
