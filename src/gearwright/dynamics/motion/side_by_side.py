"""Side by side: trajectories of one structure in the lanes of vectors, marched block by block."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, Literal, NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.codegen import (
    BLOCK,
    CHUNK,
    SINGLE,
    Compiled,
    Topology,
    aligned,
    table_width,
    wave_width,
    waves_of,
)
from gearwright.dynamics.model import Arrays

Precision = Literal["double", "single"]
"""Of numbers that are marched."""
DOUBLE: Final = "double"
STEPS = 64 * BLOCK
"""Steps between two returns to Python: long enough that threads seldom wait for each other to leave it."""


def lanes_of(precision: Precision) -> int:
    """Return the trajectories in one vector.

    Args:
        precision: Of its numbers.
    """
    return CHUNK if precision == DOUBLE else SINGLE


class Timing(NamedTuple):
    """When, how many at once, and the clock if it is one for all lanes."""

    step: float
    settled: int
    steps: int
    lanes: int
    shared: Clock | None


class Clock:
    """Clock table of a block of steps: one for all lanes if they run at one speed, each lane's own if not.

    Angles are worked out in double precision, whatever that of their cosines and sines.
    """

    def __init__(self, members: Sequence[Arrays], shape: Topology, step: float, lanes: int) -> None:
        factor, count = np.array([arrays.profile.factor[0] for arrays in members]), len(members)
        self.rate = (np.array([arrays.tone_rate for arrays in members]).T * factor).ravel()
        self.step, self.waves, self.single = step, wave_width(shape, count, lanes), lanes == SINGLE
        self.table = aligned(2 * BLOCK + 1, table_width(shape, count, lanes), single=self.single)
        half = 0.5 * step * np.arange(len(self.table))
        self.table[:, : 2 * self.waves] = waves_of(np.outer(half, self.rate), self.waves)
        self.table[:, 2 * self.waves : 2 * self.waves + count] = factor

    def turns(self, first: int, count: int) -> Floats:
        """Return by how much the tones are to be turned for each block of some steps.

        Args:
            first: Step with which they begin.
            count: Steps.
        """
        begins = self.step * (first + BLOCK * np.arange(-(-count // BLOCK)))
        turns = aligned(len(begins), 2 * self.waves, single=self.single)
        turns[:] = waves_of(np.outer(begins, self.rate), self.waves)
        return turns


def run_lanes(
    code: Compiled, shape: Topology, group: Sequence[Arrays], timing: Timing, *, numbers: Floats, states: Floats
) -> tuple[Floats, Floats]:
    """March one vector of trajectories from their numbers and states; return their summaries and ends.

    Args:
        code: Of the structure.
        shape: Structure.
        group: Systems, at most as many as there are lanes.
        timing: When.
        numbers: A row for each.
        states: A row for each.

    Returns:
        Least, most, sum and sum of squares of line forces, shape (systems, 4, lines), and a row of states for each.
    """
    lanes = timing.lanes
    lane_numbers, lane_states = _as_lanes(numbers, lanes), _as_lanes(states, lanes)
    alike = lane_numbers[:, 0].copy()
    clock = timing.shared or Clock([*group, *[group[-1]] * (lanes - len(group))], shape, timing.step, lanes)
    first, block = 0, aligned(4, len(shape.lines), lanes, single=lanes == SINGLE)
    summary = np.zeros(block.shape)
    while first < timing.steps:
        if first in (0, timing.settled):
            summary[:] = _NOTHING
        stop = timing.settled if first < timing.settled else timing.steps
        count = min(STEPS, stop - first)
        block[:] = _NOTHING
        code.advance(count, alike, lane_numbers, clock.table, clock.turns(first, count), lane_states, block)
        np.minimum(summary[0], block[0], out=summary[0])
        np.maximum(summary[1], block[1], out=summary[1])
        summary[2:] += block[2:]
        first += count
    return summary.transpose(2, 0, 1)[: len(group)], lane_states.T[: len(group)].astype(np.float64)


_NOTHING = np.array([np.inf, -np.inf, 0.0, 0.0])[:, None, None]
"""Least, most, sum and sum of squares of nothing."""


def _as_lanes(rows: Floats, lanes: int) -> Floats:
    """Return rows side by side, a lane for each; missing ones repeat the last."""
    columns = aligned(rows.shape[1], lanes, single=lanes == SINGLE)
    with np.errstate(over="ignore", under="ignore"):
        columns[:] = np.vstack([rows, np.repeat(rows[-1:], lanes - len(rows), axis=0)]).T
    return columns
