"""How parallel paths share what equilibrium leaves open, as equations that complete it.

What may circulate without losses is the null space of the equations. Shares that the design states hold first, then
equal ones; where they cannot be had, what is left of them has no part along what may circulate. Since that is said
before any losses, the completion is the same whichever side of a mesh drives, and losses change the torques steadily.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gearwright.arrays import Floats
from gearwright.spec import Design, Pair
from gearwright.train.algebra import row_and_null_space
from gearwright.train.graph import Train


@dataclass(frozen=True)
class Sharing:
    """Rows that run in parallel and the share of each; `stated` if the design says so."""

    rows: tuple[int, ...]
    """Rows of the graph."""
    share: tuple[float, ...]
    """Part of the group's load on each row [-]; the sum is one."""
    stated: bool
    """True if the design gives the shares, so that they hold before any other."""


def completing(free: Floats, scale: Floats, sharing: Sequence[Sharing]) -> Floats:
    """Return the equations that fix what equilibrium leaves open, shape (freedoms, unknowns); each is to give zero.

    Args:
        free: (unknowns, freedoms) basis of what balances by itself, without losses.
        scale: (unknowns,) length of each unknown's column; what no share fixes is as small as can be in units of it.
        sharing: Groups of parallel rows.

    Source: normal equations of the least squares of the deviations from the shares, within the null space.
    """
    written: list[Floats] = []
    for stated in (True, False):
        shares = [row for group in sharing if group.stated is stated for row in _shared(group, len(scale))]
        if shares and free.shape[1]:
            deviation = np.array(shares)
            felt, unfelt = row_and_null_space(deviation @ free)
            written.append((deviation @ free @ felt).T @ deviation)
            free = free @ unfelt
    written.append((free * scale[:, None] ** 2).T)
    equations = np.vstack(written) / scale
    return np.asarray(equations / np.linalg.norm(equations, axis=1, keepdims=True) * scale, dtype=np.float64)


def _shared(group: Sharing, size: int) -> list[Floats]:
    """Return the equations λ_i / share_i = λ_0 / share_0 of a group."""
    equations = []
    for row, share in zip(group.rows[1:], group.share[1:], strict=True):
        equation = np.zeros(size)
        equation[group.rows[0]], equation[row] = share, -group.share[0]
        equations.append(equation)
    return equations


def sharing_of(design: Design, train: Train) -> list[Sharing]:
    """Return the parallel rows of a train with the share of each.

    Args:
        design: With the shares that it states.
        train: Its graph.
    """
    groups = []
    for stage, pair in design.pairs.items():
        rows = tuple(k for k, mesh in enumerate(train.meshes) if mesh.stage == stage)
        if len(rows) > 1:
            groups.append(Sharing(rows, _shares(pair, len(rows)), stated=pair.share is not None))
    return groups


def _shares(pair: Pair, count: int) -> tuple[float, ...]:
    return tuple(pair.share) if pair.share is not None else (1.0 / count,) * count
