"""Which side of every mesh drives: all states in which the sense of each tooth power agrees with its losses.

With x the multipliers in balance and x₀ those without losses, x + Δ(sign x) x = x₀: a piecewise-linear problem, one
piece for each combination of senses. With M the mean of both signs' Δ and S half their difference it is the absolute
value equation (I + M) x + S |x| = x₀, which has one solution whatever x₀ is if the spectral radius of |(I + M)⁻¹ S| is
below one. Where it is not, the sense of one row is fixed, both ways, until the rest has one solution: so every state is
found, and that there is none, or more than one, is known and not merely met.

Source: Rohn 2009, On unique solvability of the absolute value equation, Optimization Letters 3; the rounds within a
piece: Mangasarian 2009, A generalized Newton method for absolute value equations, Optimization Letters 3.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats

NOISE = 1e-10
"""Part of the largest unknown below which an unknown agrees with either sign [-]."""
ROUNDS = 40
"""Rounds in which senses may change within one piece; where they do not settle, the piece is cut [-]."""
MOST_PIECES = 4096
"""Pieces looked at before the question is left open [-]."""


class Losing(NamedTuple):
    """x + Δ(sign x) x = x₀, in unknowns of like size."""

    lossless: Floats
    """(rows,) x₀."""
    positive: Floats
    """(rows, rows) What a unit of each unknown adds to all of them while it is positive, by columns."""
    negative: Floats
    """(rows, rows) The same while it is negative."""


class States(NamedTuple):
    """What solves it."""

    found: list[Floats]
    """Every x, each (rows,)."""
    complete: bool
    """Whether there is certainly no other."""


def states(losing: Losing) -> States:
    """Return every state in which the signs agree with the losses.

    Args:
        losing: The equations.
    """
    if _is_slight(losing) and (state := _settled(losing, np.zeros(len(losing.lossless)))) is not None:
        return States([state], complete=True)
    found: list[Floats] = []
    pieces = [np.zeros(len(losing.lossless))]
    for _ in range(MOST_PIECES):
        if not pieces:
            return States(found, complete=True)
        fixed = pieces.pop()
        inverse, swing = _piece(losing, fixed)
        shift = swing if inverse is None else np.abs(inverse @ swing)
        state = _settled(losing, fixed) if inverse is not None and _contracts(shift) else None
        if state is None:
            pieces += _halves(fixed, shift)
        elif _agrees(state, fixed) and not any(_alike(state, other) for other in found):
            found.append(state)
    return States(found, complete=False)


def _is_slight(losing: Losing) -> bool:
    """Tell whether all row sums of Δ are below a half, so that those of |(I + M)⁻¹ S| are below one."""
    row_sums = np.maximum(np.abs(losing.positive), np.abs(losing.negative)).sum(axis=1)
    return bool(row_sums.max(initial=0.0) < 0.5)


def _piece(losing: Losing, fixed: Floats) -> tuple[Floats | None, Floats]:
    """Return (I + M)⁻¹, or None where there is none, and S, where the signs of some unknowns are fixed."""
    mean = 0.5 * (losing.positive + losing.negative)
    mean = np.where(fixed > 0.0, losing.positive, np.where(fixed < 0.0, losing.negative, mean))
    swing: Floats = np.where(fixed == 0.0, 0.5 * (losing.positive - losing.negative), 0.0)
    try:
        inverse = np.asarray(np.linalg.inv(np.eye(len(mean)) + mean), dtype=np.float64)
    except np.linalg.LinAlgError:
        return None, swing
    return (inverse if np.isfinite(inverse).all() else None), swing


def _contracts(shift: Floats) -> bool:
    """Tell whether the spectral radius is below one; row sums are a quick bound of it."""
    if shift.sum(axis=1).max(initial=0.0) < 1.0:
        return True
    return bool(np.abs(np.linalg.eigvals(shift)).max(initial=0.0) < 1.0)


def _settled(losing: Losing, fixed: Floats) -> Floats | None:
    """Return the state that the rounds end in, or None where they do not."""
    state, unit = losing.lossless, np.eye(len(fixed))
    before: Bools | None = None
    for _ in range(ROUNDS):
        negative: Bools = np.where(fixed == 0.0, state, fixed) < 0.0
        if before is not None and np.array_equal(before, negative):
            return state
        before = negative
        state = _linear(unit + np.where(negative, losing.negative, losing.positive), losing.lossless)
        if not np.isfinite(state).all():
            return None
        state = np.where(np.abs(state) <= NOISE * np.abs(state).max(initial=0.0), 0.0, state)
    return None


def _linear(matrix: Floats, right: Floats) -> Floats:
    """Return the solution of linear equations, infinite where there is none."""
    try:
        return np.asarray(np.linalg.solve(matrix, right), dtype=np.float64)
    except np.linalg.LinAlgError:
        return np.full(len(right), np.inf)


def _halves(fixed: Floats, shift: Floats) -> list[Floats]:
    """Return a piece with the sign of the unknown that shifts the others most fixed both ways; none where all are."""
    felt = np.where(fixed == 0.0, shift.sum(axis=0), 0.0)
    if not felt.max(initial=0.0) > 0.0:
        return []
    halves = np.tile(fixed, (2, 1))
    halves[:, int(np.argmax(felt))] = (-1.0, 1.0)
    return list(halves)


def _agrees(state: Floats, fixed: Floats) -> bool:
    return bool(np.all(state * fixed >= 0.0))


def _alike(one: Floats, other: Floats) -> bool:
    scale = max(np.abs(one).max(initial=0.0), np.abs(other).max(initial=0.0))
    return bool(np.abs(one - other).max(initial=0.0) <= np.sqrt(NOISE) * scale)
