"""Between: how far line forces reach between the steps of a run, block by block."""

from __future__ import annotations

from functools import cache

import numpy as np

from gearwright.arrays import Floats, Ints
from gearwright.dynamics.codegen import AFTER, BEFORE, aligned, blank_crests, bring_crests, filled, lagrange

LEAD = BEFORE + AFTER
"""Rows of the block before that the next one needs."""
END = np.linspace(0.0, BEFORE, 16 * BEFORE + 1)
"""Where crests are looked for beside the first and last instants, in intervals from the end."""


class Between:
    """Crests of line forces, of each bin, and what they may be off by, of all bins together."""

    def __init__(self, lines: int, edges: Ints, block: int) -> None:
        self.lines, self.edges = lines, edges
        self.rows = aligned(LEAD + block, filled(lines))
        self.crests = blank_crests(filled(lines))
        self.blank = self.crests[:4].copy()
        self.high, self.low = np.full((len(edges) - 1, lines), -np.inf), np.full((len(edges) - 1, lines), np.inf)
        self.bound = np.zeros(lines)

    def take(self, first: int, forces: Floats) -> None:
        """Take a block.

        Args:
            first: Step of its first row; blocks follow each other without a gap.
            forces: Of the lines, shape (steps, lines).
        """
        count, steps = len(forces), int(self.edges[-1])
        self.rows[LEAD : LEAD + count, : self.lines] = forces
        start, stop = max(first - AFTER, BEFORE, int(self.edges[0])), min(first + count - AFTER, steps)
        place = int(np.searchsorted(self.edges, start, side="right")) - 1
        while start < stop:
            end = min(int(self.edges[place + 1]), stop)
            self._look(place, start - first + LEAD, end - start)
            start, place = end, place + 1
        if first == 0 == self.edges[0]:
            self._look_at_end(0, forces[: LEAD + 1])
        if first + count > steps:
            self._look_at_end(-1, self.rows[max(count - 1, LEAD - first) : LEAD + count, : self.lines][::-1])
        self.rows[:LEAD] = self.rows[count : count + LEAD].copy()

    def _look(self, place: int, row: int, count: int) -> None:
        """Look into intervals that lie in one bin."""
        self.crests[:4] = self.blank
        bring_crests(self.rows, row, count, self.crests)
        high, low, above, below = self.crests[:4, : self.lines]
        self._keep(place, high, low, np.maximum(above, -below))

    def _look_at_end(self, place: int, rows: Floats) -> None:
        """Look into the outermost intervals, the end first: rows on one side are too few for the others' way."""
        if len(rows) < 2:
            return
        through, less = _ways(len(rows))
        force = through @ rows
        off = np.abs(less @ rows[:-1] - force)
        self._keep(place, np.max(force, axis=0), np.min(force, axis=0), np.max(np.abs(force) + off, axis=0))

    def _keep(self, place: int, high: Floats, low: Floats, bound: Floats) -> None:
        np.maximum(self.high[place], high, out=self.high[place])
        np.minimum(self.low[place], low, out=self.low[place])
        np.maximum(self.bound, bound, out=self.bound)


@cache
def _ways(count: int) -> tuple[Floats, Floats]:
    """Return the weights of so many rows from an end at the places of `END`, and those of all but the last row."""
    nodes = np.arange(float(count))
    here = END[nodes[-1] >= END]
    through, less = (np.array([lagrange(nodes[:past], theta) for theta in here]) for past in (count, count - 1))
    return through, less
