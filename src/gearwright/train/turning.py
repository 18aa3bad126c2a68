"""How a train turns: the speeds that a load case asks for, and those that the teeth give."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from gearwright.arrays import Floats
from gearwright.spec import Design, Drive
from gearwright.train.graph import Joint, Train
from gearwright.train.kinematics import Yielded, rows, solve_speeds
from gearwright.train.statics import Balance, balance


@dataclass(frozen=True)
class Turn:
    """One way in which a train turns."""

    matrix: Floats
    """From `rows`."""
    speeds: Floats
    """Of every node [rad/s]."""
    yielded: tuple[Yielded, ...]
    """Machines whose asked speed the teeth give only nearly."""
    balances: dict[tuple[int, ...], Balance] = field(default_factory=dict)
    """Nodes of balancing machines -> equations of the torques, without losses."""

    def balance(self, balancing: Sequence[int]) -> Balance:
        """Return the equations of the torques without losses, made once.

        Args:
            balancing: Nodes of the machines whose torque balances.
        """
        key = tuple(balancing)
        if key not in self.balances:
            self.balances[key] = balance(self.matrix, balancing)
        return self.balances[key]


class Turning:
    """The speeds of a train with its teeth. Load cases often turn alike: each way is solved once."""

    def __init__(self, design: Design, train: Train, teeth: Mapping[str, float]) -> None:
        self.train, self.teeth = train, teeth
        self._known: dict[tuple[object, ...], Turn] = {}
        self.asked = asked_speeds(design, {})
        """Machine -> rated speed [rad/s], the one to be kept first."""
        rated = self.turn(self.asked, train.joints)
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
            speeds, yielded = solve_speeds(self.train, matrix, asked)
            self._known[key] = Turn(matrix, speeds, tuple(yielded))
        return self._known[key]


def asked_speeds(design: Design, drives: Mapping[str, Drive]) -> dict[str, float]:
    """Return machine -> asked speed [rad/s] in the order in which they are kept.

    Args:
        design: With the machines' rated speeds and the order of keeping.
        drives: The case; a speed given there comes first and replaces the rated one.
    """
    machines = design.machines
    order = [*(design.speeds.keep or []), *design.turbines, *design.motors, *design.propellers]
    stated = [name for name in order if name in drives and drives[name].speed is not None]
    speeds = {name: drives[name].speed or 0.0 for name in stated}
    if not stated:
        speeds = {name: machines[name].speed for name in dict.fromkeys(order)}
    reversed_ = {name for name, motor in design.motors.items() if motor.reverse}
    return {name: -speed if name in reversed_ else speed for name, speed in speeds.items()}


def drives_of(design: Design, case: str) -> dict[str, Drive]:
    """Return what each machine does in a case.

    Args:
        design: With its cases.
        case: Name of one of them, or ``rated``: every machine at rated power, the propellers balance.
    """
    if case in design.cases:
        return dict(design.cases[case])
    rated = {name: turbine.power for name, turbine in design.turbines.items()}
    drives = {name: Drive(power=power) for name, power in rated.items()}
    drives |= {name: Drive(power=None if motor.balances else motor.power) for name, motor in design.motors.items()}
    return drives
