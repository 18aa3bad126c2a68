"""Recorder: takes blocks of steps as they come and keeps what was asked for; its memory does not grow with time."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, partial
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from gearwright.arrays import Floats, Ints
from gearwright.dynamics.codegen import address, aligned, blank_crests, crests_code, filled, summary_code
from gearwright.dynamics.codegen.loops import Room, library
from gearwright.dynamics.model import OUTSIDE_MAP, PITCH, SPEED, Owner, System, kept
from gearwright.dynamics.motion.record.between import outer_ways
from gearwright.dynamics.motion.record.marks import Marks, stride_of
from gearwright.dynamics.motion.record.orders import OrderSums
from gearwright.dynamics.motion.record.taking import FUNCTIONS, LEAD, OUTSIDE, RUNAWAY, TAKEN, Taking
from gearwright.dynamics.motion.record.trace import Checkpoints, Samples, Statistics
from gearwright.errors import DesignError, Problem, SolveError
from gearwright.verbs import check_fields

BLOCK = 512
"""Steps in a block; replays start at its multiples."""
CHECKPOINTS = 1000
"""Most states that are kept for replay."""
_RECORD = Taking._fields.index("record")


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


class Frame(NamedTuple):
    """What the records of all runs of a system to the same end have alike."""

    edges: Ints
    """Steps at which bins begin and end."""
    stretches: tuple[range, ...]
    """Steps of which rows are kept: samples, then windows."""
    gaps: Ints
    """Lines with backlash."""
    stride: int
    """Steps between marks."""
    room: Room
    """Of what blocks are taken into."""


def _frame(system: System, outputs: Outputs, step: float, steps: int) -> Frame:
    """Return what runs have alike, and refuse outputs that do not fit them."""
    size, lines = len(system.labels.coordinates), len(system.labels.lines)
    owners, drives = system.labels.drive_owners, 2 * (size + lines)
    past, gaps, stride = drives + len(owners), np.flatnonzero(system.arrays.backlash > 0.0), stride_of(steps)
    spans = [range(*_span(window, step, steps)) for window in outputs.windows]
    stretches = (range(0, steps + 1, max(1, -(-(steps + 1) // max(2, outputs.samples)))), *spans)
    kept = [[one.start, one.stop, one.step, 0, 0] for one in stretches]
    edges = _edges(outputs, step, steps)
    flags = [drives + number for number, owner in enumerate(owners) if owner.what == OUTSIDE_MAP]
    width, room, bins = filled(past), filled(lines), len(edges) - 1
    infinite = np.full((bins, max(past - size, room)), np.inf)
    counted, between = infinite[:, : past - size], infinite[:, :room]
    whole: Callable[[Any], Ints] = partial(np.array, dtype=np.int64)
    begin, end = outer_ways(min(LEAD + 1, steps)), outer_ways(min(LEAD + 1, steps + 1))
    taking = Taking(
        steps=steps, width=width, size=size, lines=lines, past=past, record=np.zeros(0), summary=np.zeros((4, width)),
        part=np.zeros((4, width)), summarise=summary_code(), crests_code=crests_code(), edges=edges, bins=bins,
        places=np.zeros(3, dtype=np.int64), sums=np.zeros((2, *counted.shape)), minimum=counted, maximum=-counted,
        stretches=len(stretches), kept=whole(kept), gaps=len(gaps), loose=2 * size + lines + gaps,
        lost=np.full_like(gaps, -1), stride=stride, marks=np.zeros((steps // stride + 2, len(gaps))),
        flags=len(flags), outside=whole(flags), ends=np.zeros((2, lines)),
        first_places=begin.shape[1], first_rows=begin.shape[2], first_ways=begin,
        last_places=end.shape[1], last_rows=end.shape[2], last_ways=end,
        end_bound=np.zeros(lines), room=room, crests=blank_crests(room), high=-between, low=between,
    )  # fmt: skip
    return Frame(edges, stretches, gaps, stride, Room(taking))


_ROWS = dict[int, list[Floats]]()
"""Blocks that no run is using, by the width of their rows: memory that has been used before costs less."""


class Recorder:
    """Keeps samples, windows, statistics and checkpoints of one run."""

    def __init__(self, system: System, outputs: Outputs, *, step: float, steps: int) -> None:
        self.system, self.outputs, self.step, self.steps = system, outputs, step, steps
        self.size, lines = len(system.labels.coordinates), len(system.labels.lines)
        self.forces = slice(2 * self.size, 2 * self.size + lines)
        self.drives = self.forces.stop + lines
        self.past = self.drives + len(system.labels.drives)
        frame = kept(system.arrays, (_frame, outputs, step, steps), lambda: _frame(system, outputs, step, steps))
        self.frame, self.taking, self.edges = frame, frame.room.fresh(), frame.edges
        self.points = np.zeros((0, 0))
        self.spacing = BLOCK * max(1, -(-steps // (BLOCK * CHECKPOINTS)))
        self.tables = [np.empty((len(stretch), self.past)) for stretch in frame.stretches]
        width = filled(self.past)
        known = _ROWS.setdefault(width, [])
        self._rows = known.pop() if known else aligned(LEAD + BLOCK + 1, width)
        self.record = self._rows[LEAD:-1]
        self.taking.memory[_RECORD] = address(self.record)
        self.taking.kept[:, -1] = [address(table) if table.size else 0 for table in self.tables]
        self.orders = OrderSums(system, outputs.orders, step=step, bins=len(self.edges) - 1) if outputs.orders else None

    @property
    def lost(self) -> Ints:
        """Step at which each line with backlash first lost contact, or -1."""
        return self.taking.lost  # type: ignore[no-any-return]

    @property
    def marks(self) -> Marks:
        """Where lines with backlash were on the way."""
        return Marks(self.frame.stride * self.step, self.taking.marks[: self.taking.places[2]])

    def take(self, first: int, count: int) -> None:
        """Take the block of rows (q, q̇, line forces, deflections, drives) that stands in `record`.

        Args:
            first: Step of the first row; blocks follow each other without a gap.
            count: Rows.

        Raises:
            SolveError: If the run has diverged, with time, line and value; if a propeller has left its map.
        """
        self.refuse(_take()(self.taking.place, first, count), first)
        self.count_orders(first, count)

    def refuse(self, found: int, first: int) -> None:
        """Refuse a block that is not as it should be.

        Args:
            found: What `taking.take` says of it.
            first: Step of its first row.
        """
        if found == OUTSIDE:
            self._outside(first)
        if found != TAKEN:
            self._diverged(first)

    def count_orders(self, first: int, count: int) -> None:
        """Add a block to the amplitudes of tones, if they are asked for.

        Args:
            first: Step of its first row.
            count: Rows.
        """
        if self.orders is None:
            return
        for place, (start, stop) in enumerate(zip(self.edges[:-1].tolist(), self.edges[1:].tolist(), strict=True)):
            low, high = max(start, first), min(stop, first + count)
            if low < high:
                self.orders.add(place, low, self.record[low - first : high - first, self.forces])

    def _outside(self, first: int) -> None:
        """Refuse what a propeller does outside its map: the laws go on with the nearest cell's edge."""
        owners, start = self.system.labels.drive_owners, self.drives
        for column in self.taking.outside.tolist():
            if self.taking.summary[1, column] > 0.0:
                row, part = int(np.argmax(self.record[:, column] > 0.0)), owners[column - start].part
                seen = {what: self.record[row, start + owners.index(Owner(part, what))] for what in (SPEED, PITCH)}
                raise SolveError(
                    f"{part} leaves its map at {(first + row) * self.step:.4g} s: {abs(seen[SPEED]) * 30 / np.pi:.4g}"
                    f" rpm at a pitch of {np.degrees(seen[PITCH]):.4g}°; take a smaller change, tighter pitch stops,"
                    " or a map that covers the point"
                )

    def _diverged(self, first: int) -> None:
        forces = self.record[:, self.forces.start : self.drives]
        row = int(np.argmin(np.all(np.abs(forces) < RUNAWAY, axis=1)))
        lines = self.system.labels.lines
        column = int(np.argmin(np.abs(forces[row]) < RUNAWAY))
        does = "carries" if column < len(lines) else "is deflected by"
        fix = f"take a smaller step than {self.step:.3g} s, or more damping" if first + row else "look at the start"
        raise SolveError(
            f"the run diverged at {(first + row) * self.step:.6g} s: line {lines[column % len(lines)]} {does} "
            f"{forces[row, column]:.3g}; {fix}"
        )

    def samples(self, number: int = 0) -> Samples:
        """Return the evenly spaced instants (0) or a window (1, 2, …).

        Args:
            number: Which.
        """
        stretch, taken = self.frame.stretches[number], int(self.taking.kept[number, 3])
        time: Floats = np.arange(stretch.start, stretch.stop, stretch.step)[:taken] * np.float64(self.step)
        table, ends = self.tables[number][:taken], (0, self.size, self.forces.start, self.forces.stop, self.drives)
        parts = [table[:, low:high] for low, high in pairwise((*ends, self.past))]
        return Samples(time, parts[0], parts[1], parts[2], parts[3], self.system.labels, parts[4])

    def statistics(self, names: tuple[str, ...], first: int, what: str) -> Statistics:
        """Return the statistics of some of the columns after q.

        Args:
            names: Lines or coordinates.
            first: Column of the first; extremes of line forces, the first after q̇, are those between steps too.
            what: ``"line"``, ``"coordinate"`` or ``"drive"``.
        """
        columns = slice(first, first + len(names))
        mean, least, most, rms = (part[:, columns] for part in self._told)
        if first == self.size:
            least, most, _ = self.line_extremes()
        return Statistics(names, what, self.edges * np.float64(self.step), mean, least, most, rms)

    @cached_property
    def _told(self) -> tuple[Floats, Floats, Floats, Floats]:
        """Mean, least, most and root mean square of the columns after q, shape (bins, columns)."""
        bins, taking = len(self.edges) - 1, self.taking
        mean, square = taking.sums[:, :bins] / (self.edges[1:] - self.edges[:-1])[:, None]
        return mean, taking.minimum[:bins], taking.maximum[:bins], np.sqrt(square)

    def line_extremes(self) -> tuple[Floats, Floats, Floats]:
        """Return least, most and sums of squares of line forces, extremes between steps too, shape (bins, lines)."""
        bins, lines, taking = len(self.edges) - 1, self.forces.stop - self.forces.start, self.taking
        columns = slice(self.size, self.size + lines)
        low = np.minimum(taking.minimum[:bins, columns], taking.low[:bins, :lines])
        high = np.maximum(taking.maximum[:bins, columns], taking.high[:bins, :lines])
        return low, high, taking.sums[1, :bins, columns]

    def finish(self, done: int) -> None:
        """Cut the bins to the steps that were done.

        Args:
            done: Steps.
        """
        if done < self.steps:
            keep = int(np.searchsorted(self.edges, done, side="left"))
            self.edges = np.concatenate([self.edges[:keep], [max(done, self.edges[0])]])
        _ROWS[self._rows.shape[1]].append(self._rows)

    def promised(self) -> Floats:
        """Return what `accuracy.Forces` tells of the line forces, shape (4, 1, lines); zeros before any."""
        bins, lines = len(self.edges) - 1, self.forces.stop - self.forces.start
        promised = np.zeros((4, 1, lines))
        if bins:
            first, steps = int(self.edges[0]), float(self.edges[-1] - self.edges[0])
            late = abs(first - self.outputs.start / self.step) / steps
            library(*FUNCTIONS).function("promise")(self.taking.place, bins, steps, late, address(promised))
        return promised

    def checkpoints(self) -> Checkpoints:
        """Return the states that were kept for replay."""
        return Checkpoints(self.spacing * np.arange(len(self.points)), self.points)


def _take() -> Callable[..., int]:
    """Return the compiled `take`."""
    return library(*FUNCTIONS).function("take")


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
