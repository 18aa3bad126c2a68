"""The torques of one load case in balance, with losses in the direction of the power."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.spec import Design
from gearwright.train.flow.carried import Dragged
from gearwright.train.flow.refusals import ambiguous, unbalanced
from gearwright.train.flow.torques import State, lost_parts, solve_lossless, solve_lossy, undecided
from gearwright.train.flow.turning import Turn
from gearwright.train.graph import Damper, Train

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
