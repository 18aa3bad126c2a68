"""The torques of a train with losses: the lossless ones, then every state whose senses agree with the losses."""

from __future__ import annotations

from typing import NamedTuple

from gearwright.arrays import Floats
from gearwright.train.flow.torques.senses import Losing, states
from gearwright.train.flow.torques.statics import Balance, solve_torques
from gearwright.train.flow.torques.tooth_losses import Laws


class State(NamedTuple):
    """Torques in balance."""

    multipliers: Floats
    """Torque per tooth of every mesh row, then torque of every engaged clutch [N m]."""
    machines: Floats
    """Torque of every machine that balances [N m]."""
    effective: Floats
    """(rows, nodes): torque on a node per multiplier [-], losses included."""


class Solved(NamedTuple):
    """All states of a load."""

    lossless: State
    found: list[State]
    """With losses."""
    complete: bool
    """Whether there is certainly no other."""


class Lossy(NamedTuple):
    """Equations of torques that may lose, ready to be solved for one load and one set of efficiencies after another."""

    known: Balance
    """Without losses."""
    change: Laws
    """What the torques change where a row loses all that it carries."""
    felt: Laws
    """What a unit of each multiplier that loses all takes from every one, in units of their columns; (rows, rows)."""


def lossy(known: Balance, change: Laws) -> Lossy:
    """Return the equations of torques with losses.

    Args:
        known: The equations without losses.
        change: What the torques change where a row loses all that it carries.
    """
    rows, nodes = known.matrix.shape
    inverse, scale = known.inverse[:rows, :nodes], known.scale[:rows]
    return Lossy(known, change, Laws(*(inverse @ (law.T / scale) for law in change)))


def solve_lossless(known: Balance, applied: Floats) -> Solved | None:
    """Return the one state of balance under a load where no teeth lose anything, or None where no torques balance.

    Args:
        known: The equations without losses.
        applied: (nodes,) torques that are given [N m].
    """
    solution, rows = solve_torques(known, applied), len(known.matrix)
    if solution is None:
        return None
    state = State(solution[:rows], solution[rows:], known.matrix)
    return Solved(state, [state], complete=True)


def solve_lossy(equations: Lossy, part: Floats, applied: Floats) -> Solved | None:
    """Return every state of balance under a load, or None where no torques balance.

    Args:
        equations: From `lossy`.
        part: Part 1 − η that each row loses [-], shape (rows,).
        applied: (nodes,) torques that are given [N m].
    """
    known, rows = equations.known, len(part)
    lossless = solve_torques(known, applied)
    if lossless is None:
        return None
    senses = states(Losing(known.scale[:rows] * lossless[:rows], *(law * part for law in equations.felt)))
    found = []
    for multipliers in senses.found:
        effective = known.matrix + part[:, None] * equations.change.of(multipliers)
        solution = solve_torques(known.with_losses(effective), applied)
        if solution is None:
            return None
        found.append(State(solution[:rows], solution[rows:], effective))
    return Solved(State(lossless[:rows], lossless[rows:], known.matrix), found, senses.complete)
