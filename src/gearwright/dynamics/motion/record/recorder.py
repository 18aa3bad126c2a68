"""Recorder: takes blocks of steps as they come and keeps what was asked for; its memory does not grow with time."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gearwright.arrays import Floats, Ints
from gearwright.dynamics.model import OUTSIDE_MAP, PITCH, SPEED, Owner, System
from gearwright.dynamics.motion.record.between import Between
from gearwright.dynamics.motion.record.marks import Marks
from gearwright.dynamics.motion.record.orders import OrderSums
from gearwright.dynamics.motion.record.trace import Checkpoints, Samples, Statistics
from gearwright.errors import DesignError, Problem, SolveError
from gearwright.verbs import check_fields

BLOCK = 512
"""Steps in a block; replays start at its multiples."""
CHECKPOINTS = 1000
"""Most states that are kept for replay."""
RUNAWAY = 1e12
"""Line force at which a run has diverged [N or N m]: no gear comes near it."""


@dataclass(frozen=True)
class Outputs:
    """What to keep of a run."""

    samples: int = 4000
    """Most evenly spaced instants that are kept."""
    bins: int = 1
    """Time bins of the statistics."""
    start: float = 0.0
    """Time before which the statistics do not look [s]: leave out the transient."""
    windows: tuple[tuple[float, float], ...] = ()
    """Stretches of time of which every step is kept, (from, to) [s]."""
    orders: tuple[str, ...] = ()
    """Lines whose force is split into the amplitudes of the tones, in each bin."""

    def __post_init__(self) -> None:
        check_fields(self)


class Kept:
    """Rows of the record at evenly spaced steps."""

    def __init__(self, steps: range, width: int) -> None:
        self.steps, self.taken = steps, 0
        self.table = np.empty((len(steps), width))

    def take(self, first: int, record: Floats) -> None:
        """Take what falls on the steps.

        Args:
            first: Step of the first row; blocks follow each other.
            record: Shape (steps, at least so many columns).
        """
        if self.taken < len(self.steps):
            rows = record[self.steps[self.taken] - first : self.steps.stop - first : self.steps.step]
            self.table[self.taken : self.taken + len(rows)] = rows[:, : self.table.shape[1]]
            self.taken += len(rows)

    @property
    def rows(self) -> tuple[Ints, Floats]:
        """Steps that were taken, and their rows."""
        steps = self.steps[: self.taken]
        return np.arange(steps.start, steps.stop, steps.step), self.table[: self.taken]


class Recorder:
    """Keeps samples, windows, statistics and checkpoints of one run."""

    def __init__(self, system: System, outputs: Outputs, *, step: float, steps: int) -> None:
        self.system, self.outputs, self.step, self.steps = system, outputs, step, steps
        self.size = len(system.labels.coordinates)
        self.forces = slice(2 * self.size, 2 * self.size + len(system.labels.lines))
        self.drives = self.forces.stop + len(system.labels.lines)
        self.past = self.drives + len(system.labels.drives)
        self.outside = [number for number, owner in enumerate(system.labels.drive_owners) if owner.what == OUTSIDE_MAP]
        self.stride = max(1, -(-(steps + 1) // max(2, outputs.samples)))
        self.spans = [_span(window, step, steps) for window in outputs.windows]
        self.edges = _edges(outputs, step, steps)
        width, bins = self.past - self.size, len(self.edges) - 1
        self.sums = np.zeros((2, bins, width))
        self.minimum, self.maximum = np.full((bins, width), np.inf), np.full((bins, width), -np.inf)
        self.first_force, self.last_force = np.zeros((2, len(system.labels.lines)))
        self.between = Between(len(system.labels.lines), self.edges, BLOCK)
        stretches = [(0, steps + 1, self.stride), *((*span, 1) for span in self.spans)]
        self.kept = [Kept(range(*stretch), self.past) for stretch in stretches]
        self.points: list[tuple[int, Floats]] = []
        self.spacing = BLOCK * max(1, -(-steps // (BLOCK * CHECKPOINTS)))
        self.gaps = np.flatnonzero(system.arrays.backlash > 0.0)
        self.lost = np.full(len(self.gaps), -1)
        self.loose = self.forces.stop + self.gaps
        self.marks = Marks(self.loose, step, steps)
        self.orders = OrderSums(system, outputs.orders, step=step, bins=bins) if outputs.orders else None

    def checkpoint(self, first: int, state: Floats) -> None:
        """Keep the state before a step, if it is time to.

        Args:
            first: Step.
            state: q, q̇ and works.
        """
        if first % self.spacing == 0:
            self.points.append((first, state.copy()))

    def take(self, first: int, record: Floats, summary: Floats) -> None:
        """Take a block of rows (q, q̇, line forces, deflections, drives).

        Args:
            first: Step of the first row.
            record: Shape (steps, at least 2 coordinates + 2 lines + numbers of the drives).
            summary: Its `summary_of`.

        Raises:
            SolveError: If the run has diverged, with time, line and value; if a propeller has left its map.
        """
        minimum, maximum, _, square = summary[:, self.forces.start : self.drives]
        if not (maximum.max() < RUNAWAY and minimum.min() > -RUNAWAY and np.isfinite(square).all()):
            self._diverged(first, record)
        if self.outside:
            self._check_maps(first, record, summary)
        for part in self.kept:
            part.take(first, record)
        edges, forces = self.edges, record[:, self.forces]
        begin = int(edges.searchsorted(first, side="right")) - 1
        for place in range(max(begin, 0), len(edges) - 1):
            low, high = max(int(edges[place]), first), min(int(edges[place + 1]), first + len(record))
            if low >= high:
                break
            rows = record[low - first : high - first]
            self._count(place, summary if len(rows) == len(record) else summary_of(rows))
            if self.orders is not None:
                self.orders.add(place, low, rows[:, self.forces])
        self._watch(first, record, summary[0])
        self.marks.take(first, record)
        self.between.take(first, forces)
        self.last_force = forces[-1].copy()
        if first <= edges[0] < first + len(record):
            self.first_force = forces[int(edges[0]) - first].copy()

    def _check_maps(self, first: int, record: Floats, summary: Floats) -> None:
        """Refuse what a propeller does outside its map: the laws go on with the nearest cell's edge."""
        labels = self.system.labels
        start = self.drives
        for number in self.outside:
            if summary[1, start + number] > 0.0:
                row = int(np.argmax(record[:, start + number] > 0.0))
                owners, part = labels.drive_owners, labels.drive_owners[number].part
                seen = {what: record[row, start + owners.index(Owner(part, what))] for what in (SPEED, PITCH)}
                raise SolveError(
                    f"{part} leaves its map at {(first + row) * self.step:.4g} s: {abs(seen[SPEED]) * 30 / np.pi:.4g}"
                    f" rpm at a pitch of {np.degrees(seen[PITCH]):.4g}°; take a smaller change, tighter pitch stops,"
                    " or a map that covers the point"
                )

    def _diverged(self, first: int, record: Floats) -> None:
        forces = record[:, self.forces.start : self.drives]
        row = int(np.argmin(np.all(np.abs(forces) < RUNAWAY, axis=1)))
        lines = self.system.labels.lines
        column = int(np.argmin(np.abs(forces[row]) < RUNAWAY))
        does = "carries" if column < len(lines) else "is deflected by"
        fix = f"take a smaller step than {self.step:.3g} s, or more damping" if first + row else "look at the start"
        raise SolveError(
            f"the run diverged at {(first + row) * self.step:.6g} s: line {lines[column % len(lines)]} {does} "
            f"{forces[row, column]:.3g}; {fix}"
        )

    def _count(self, place: int, summary: Floats) -> None:
        minimum, maximum, total, square = summary[:, self.size : self.past]
        self.sums[0, place] += total
        self.sums[1, place] += square
        np.minimum(self.minimum[place], minimum, out=self.minimum[place])
        np.maximum(self.maximum[place], maximum, out=self.maximum[place])

    def _watch(self, first: int, record: Floats, minimum: Floats) -> None:
        if len(self.gaps):
            new = (minimum[self.loose] <= 0.0) & (self.lost < 0)
            if new.any():
                self.lost[new] = first + np.argmax(record[:, self.loose[new]] <= 0.0, axis=0)

    def samples(self, number: int = 0) -> Samples:
        """Return the evenly spaced instants (0) or a window (1, 2, …).

        Args:
            number: Which.
        """
        size, lines = self.size, len(self.system.labels.lines)
        steps, table = self.kept[number].rows
        time: Floats = steps * np.float64(self.step)
        ends = [size, 2 * size, 2 * size + lines, 2 * size + 2 * lines]
        position, velocity, force, deflection, drive = np.split(table, ends, axis=1)
        return Samples(time, position, velocity, force, deflection, self.system.labels, drive)

    def statistics(self, names: tuple[str, ...], first: int, what: str) -> Statistics:
        """Return the statistics of some of the columns after q.

        Args:
            names: Lines or coordinates.
            first: Column of the first; extremes of line forces, the first after q̇, are those between steps too.
            what: ``"line"``, ``"coordinate"`` or ``"drive"``.
        """
        columns = slice(first, first + len(names))
        mean, square = self.sums[:, :, columns] / np.diff(self.edges)[:, None]
        least, most = self.minimum[:, columns], self.maximum[:, columns]
        if first == self.size:
            least, most, _ = self.line_extremes()
        return Statistics(names, what, self.edges.astype(np.float64) * self.step, mean, least, most, np.sqrt(square))

    def line_extremes(self) -> tuple[Floats, Floats, Floats]:
        """Return least, most and sums of squares of line forces, extremes between steps too, shape (bins, lines)."""
        bins, columns = len(self.edges) - 1, slice(self.size, self.size + len(self.first_force))
        low = np.minimum(self.minimum[:, columns], self.between.low[:bins])
        return low, np.maximum(self.maximum[:, columns], self.between.high[:bins]), self.sums[1, :, columns]

    def checkpoints(self) -> Checkpoints:
        """Return the states that were kept for replay."""
        return Checkpoints(np.array([step for step, _ in self.points]), np.array([state for _, state in self.points]))

    def stop(self, done: int) -> None:
        """Cut the bins to the steps that were done.

        Args:
            done: Steps.
        """
        keep = int(np.searchsorted(self.edges, done, side="left"))
        self.edges = np.concatenate([self.edges[:keep], [max(done, self.edges[0])]])
        bins = len(self.edges) - 1
        self.sums, self.minimum, self.maximum = self.sums[:, :bins], self.minimum[:bins], self.maximum[:bins]


def summary_of(record: Floats) -> Floats:
    """Return least, most, sum and sum of squares of each column, shape (4, columns).

    Args:
        record: Shape (steps, columns).
    """
    with np.errstate(over="ignore", invalid="ignore"):
        square = np.einsum("ij,ij->j", record, record)
        return np.array([np.min(record, axis=0), np.max(record, axis=0), np.sum(record, axis=0), square])


def _span(window: tuple[float, float], step: float, steps: int) -> tuple[int, int]:
    first, last = round(window[0] / step), round(window[1] / step)
    if not 0 <= first < last <= steps:
        message = f"({window[0]:g}, {window[1]:g}) s; it must lie within 0 and {steps * step:g} s and have a length"
        raise DesignError([Problem("outputs.windows", message)])
    return first, last + 1


def _edges(outputs: Outputs, step: float, steps: int) -> Ints:
    first = 2 * round(outputs.start / (2.0 * step))  # so that a run at twice the step looks at the same time
    if not 0 <= first < steps or not 1 <= outputs.bins <= steps - first:
        message = f"{outputs.bins} bins from {outputs.start:g} s do not fit a run of {steps} steps of {step:.3g} s"
        raise DesignError([Problem("outputs", message)])
    if outputs.bins == 1:
        return np.array([first, steps])
    return np.unique(np.linspace(first, steps, outputs.bins + 1).round().astype(np.int64))
