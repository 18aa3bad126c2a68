"""Recording of time histories: samples, statistics, order amplitudes and labelled output.

It takes no step; files of runs are written by `store`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache, cached_property, partial
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from gearwright.base import (
    Complexes,
    DesignError,
    Floats,
    Ints,
    Problem,
    Shown,
    SolveError,
    check_fields,
    extra,
    frame,
    near,
)
from gearwright.dynamics.codegen import (
    BEFORE,
    address,
    aligned,
    blank_crests,
    crests_code,
    filled,
    lagrange,
    summary_code,
)
from gearwright.dynamics.codegen.loops import Room, library
from gearwright.dynamics.equations import Work, speed_factors
from gearwright.dynamics.model import OUTSIDE_MAP, PITCH, SPEED, Labels, Owner, System, Tone, kept
from gearwright.dynamics.motion.taking import FUNCTIONS, LEAD, OUTSIDE, RUNAWAY, TAKEN, Taking

# ----------------------------------------------------------------------------------------------------------------------
# Between: how far line forces reach between the outermost steps of a run, where rows stand on one side only.
# ----------------------------------------------------------------------------------------------------------------------


END = np.linspace(0.0, BEFORE, 16 * BEFORE + 1)
"""Where crests are looked for beside the first and last instants, in intervals from the end."""


@cache
def outer_ways(count: int) -> Floats:
    """Return the weights of so many rows from an end at the places of `END`, and those of all but the last row.

    Args:
        count: Rows; of a single one nothing is told.

    Returns:
        Shape (2, places, rows).
    """
    if count < 2:
        return np.zeros((2, 0, count))
    nodes = np.arange(float(count))
    here = END[nodes[-1] >= END]
    through, less = (np.array([lagrange(nodes[:past], theta) for theta in here]) for past in (count, count - 1))
    return np.array([through, np.pad(less, ((0, 0), (0, 1)))])


# ----------------------------------------------------------------------------------------------------------------------
# Marks: deflections of lines with backlash at instants that runs at a half or a quarter of a step share.
# ----------------------------------------------------------------------------------------------------------------------


MOST = 1024
"""Marks that are kept."""


class Apart(NamedTuple):
    """How far two runs of one motion are from each other on the way, of the line that they differ by most."""

    most: float
    """Largest distance of the deflections over what the deflection covers [-]."""
    rms: float
    """Root mean square of the distance over that of the deflection [-]."""


TOGETHER = Apart(0.0, 0.0)
"""Of runs that lose no contact."""


class Marks(NamedTuple):
    """Deflections at evenly spaced instants, a power of two of steps apart."""

    spacing: float
    """[s]."""
    rows: Floats
    """Shape (marks, lines)."""

    def apart(self, other: Marks) -> Apart:
        """Return how far the runs are from each other.

        Args:
            other: Of the same motion at another step, a power of two of this one's.
        """
        factor = other.spacing / self.spacing
        mine, its = self.rows[:: max(1, round(factor))], other.rows[:: max(1, round(1.0 / factor))]
        count = min(len(mine), len(its))
        away, covered = np.abs(mine[:count] - its[:count]), np.ptp(mine[:count], axis=0)
        return Apart(
            _largest_share(np.max(away, axis=0), covered),
            _largest_share(np.sqrt(np.mean(away**2, axis=0)), np.sqrt(np.mean(mine[:count] ** 2, axis=0))),
        )


def stride_of(steps: int) -> int:
    """Return the steps between marks: a power of two, so that runs at a half or a quarter of a step share them.

    Args:
        steps: Of the run.
    """
    return int(1 << max(0, -(-steps // MOST) - 1).bit_length())


def _largest_share(part: Floats, whole: Floats) -> float:
    return float(np.max(np.divide(part, whole, out=np.zeros_like(part), where=whole > 0.0), initial=0.0))


# ----------------------------------------------------------------------------------------------------------------------
# Samples of a run with names and units: as an xarray ``Dataset`` and as columns of a table.
# ----------------------------------------------------------------------------------------------------------------------


LINES = {"m": ("line", ("force", "N"), ("deflection", "m")), "rad": ("shaft", ("torque", "N m"), ("twist", "rad"))}
"""Unit of a line's deflection -> dimension, and variable with unit of its load and of its deflection."""
COORDINATES = {
    "rad": ("rotation", ("angle", "rad"), ("angular_velocity", "rad/s")),
    "m": ("translation", ("displacement", "m"), ("velocity", "m/s")),
}
"""Unit of a coordinate -> dimension, and variable with unit of its place and of its rate."""


def dataset(samples: Any) -> Any:
    """Return samples as an xarray ``Dataset``: one unit a variable, dimensions whose coordinates are the names.

    Args:
        samples: Of a run.

    Raises:
        DesignError: If xarray is not installed.
    """
    labels: Labels = samples.labels
    lines = (labels.lines, labels.line_units, LINES, (samples.line_force, samples.line_deflection))
    moves = (labels.coordinates, labels.coordinate_units, COORDINATES, (samples.position, samples.velocity))
    variables: dict[str, Any] = {}
    names: dict[str, Any] = {"time": ("time", samples.time, {"units": "s"})}
    for labelled, units, kinds, arrays in (lines, moves):
        for unit, (dimension, *quantities) in kinds.items():
            places = [place for place, own in enumerate(units) if own == unit]
            if places:
                names[dimension] = [labelled[place] for place in places]
                for (name, shown), array in zip(quantities, arrays, strict=True):
                    variables[name] = (("time", dimension), array[:, places], {"units": shown})
    for place, (name, unit) in enumerate(zip(labels.drives, labels.drive_units, strict=True)):
        variables[name] = ("time", samples.drives[:, place], {"units": unit})
    return extra("xarray").Dataset(variables, names)


def line_columns(samples: Any) -> dict[str, tuple[Floats, str]]:
    """Return time, the load of every line and the drives as columns with units.

    Args:
        samples: Of a run.
    """
    return dict(_columns(samples))


def _columns(samples: Any) -> Iterator[tuple[str, tuple[Floats, str]]]:
    labels: Labels = samples.labels
    yield "time", (samples.time, "s")
    for place, (name, unit) in enumerate(zip(labels.lines, labels.line_units, strict=True)):
        yield name, (samples.line_force[:, place], LINES[unit][1][1])
    for place, (name, unit) in enumerate(zip(labels.drives, labels.drive_units, strict=True)):
        yield name, (samples.drives[:, place], unit)


# ----------------------------------------------------------------------------------------------------------------------
# Trace: what a simulated system did, labelled and with units; it does not draw itself.
# ----------------------------------------------------------------------------------------------------------------------


def index_of(name: str, names: Sequence[str], what: str) -> int:
    """Return the place of a name.

    Args:
        name: What was asked for.
        names: What there is.
        what: ``"line"``, ``"coordinate"`` or ``"drive"``, for the message.

    Raises:
        DesignError: If there is no such name; with the nearest one.
    """
    if name not in names:
        raise DesignError([Problem(f"outputs.{name}", f"no such {what}; {near(name, names)}")])
    return names.index(name)


def line_numbers(system: System, names: Sequence[str]) -> Ints:
    """Return the places of lines in the arrays.

    Args:
        system: Where they are looked up.
        names: Of parallel lines.
    """
    return np.array([index_of(name, system.labels.lines, "line") for name in names], dtype=np.int64)


@dataclass(frozen=True, eq=False, repr=False)
class Samples(Shown):
    """The state at some instants."""

    time: Floats
    """[s], shape (instants,)."""
    position: Floats
    """q, from the rigid motion [rad or m], shape (instants, coordinates)."""
    velocity: Floats
    """q̇ [rad/s or m/s], shape (instants, coordinates)."""
    line_force: Floats
    """Line forces, elastic and damping [N or N m], shape (instants, lines)."""
    line_deflection: Floats
    """Line deflections δ [m or rad], shape (instants, lines): for a mesh the dynamic transmission error."""
    labels: Labels
    """Names and units."""
    drives: Floats
    """States of the drives, then torque, speed and flag of each, shape (instants, numbers)."""

    def drive(self, name: str) -> Floats:
        """Return what is recorded of a drive, such as ``"propeller pitch"``, shape (instants,).

        Args:
            name: One of `Labels.drives`.
        """
        return self.drives[:, index_of(name, self.labels.drives, "drive")]

    def force(self, line: str) -> Floats:
        """Return the force of a line, or the torque of a shaft [N or N m], shape (instants,).

        Args:
            line: Its name.
        """
        return self.line_force[:, index_of(line, self.labels.lines, "line")]

    def deflection(self, line: str) -> Floats:
        """Return the deflection of a line [m or rad], shape (instants,).

        Args:
            line: Its name.
        """
        return self.line_deflection[:, index_of(line, self.labels.lines, "line")]

    def to_xarray(self) -> Any:
        """Return an xarray ``Dataset``: force [N] by ``line``, torque [N m] by ``shaft``, and all else."""
        return dataset(self)

    def to_dataframe(self) -> Any:
        """Return a pandas ``DataFrame``: the load of every line over time, units in ``attrs["units"]``."""
        return frame(line_columns(self), "time")

    def motion(self, coordinate: str) -> Floats:
        """Return a coordinate, measured from the rigid motion [rad or m], shape (instants,).

        Args:
            coordinate: Its name.
        """
        return self.position[:, index_of(coordinate, self.labels.coordinates, "coordinate")]


class Extent(NamedTuple):
    """Statistics of one quantity over all time bins, in the unit of the quantity."""

    mean: float
    minimum: float
    maximum: float
    rms: float
    """Root mean square of the value itself."""


@dataclass(frozen=True, eq=False, repr=False)
class Statistics(Shown):
    """Mean, least, greatest and root mean square of one quantity in each time bin, from every step of the run."""

    names: tuple[str, ...]
    """Lines or coordinates."""
    what: str
    """``"line"``, ``"coordinate"`` or ``"drive"``."""
    edges: Floats
    """Bin edges [s], shape (bins + 1,)."""
    mean: Floats
    """Shape (bins, names)."""
    minimum: Floats
    """Shape (bins, names)."""
    maximum: Floats
    """Shape (bins, names)."""
    rms: Floats
    """Root mean square of the value itself, shape (bins, names)."""

    @property
    def bins(self) -> int:
        """Time bins: none if the run was interrupted before the time from which statistics look."""
        return len(self.edges) - 1

    def of(self, name: str) -> dict[str, Floats]:
        """Return mean, least, most and rms of one line or coordinate, shape (bins,) each.

        Args:
            name: Its name.
        """
        column = index_of(name, self.names, self.what)
        return {key: getattr(self, key)[:, column] for key in ("mean", "minimum", "maximum", "rms")}

    def whole(self, name: str) -> Extent:
        """Return one line or coordinate over all bins together.

        Args:
            name: Its name.
        """
        of, weights = self.of(name), np.diff(self.edges) / np.sum(np.diff(self.edges))
        return Extent(float(weights @ of["mean"]), float(np.min(of["minimum"])), float(np.max(of["maximum"])),
                      float(np.sqrt(weights @ of["rms"] ** 2)))  # fmt: skip


@dataclass(frozen=True, eq=False, repr=False)
class Orders(Shown):
    """Complex amplitudes of line forces at every turning tone: the real part times e^(iφ) is the tone's share."""

    names: tuple[str, ...]
    """Lines."""
    tones: tuple[Tone, ...]
    """Which angle each tone is."""
    edges: Floats
    """Bin edges [s], shape (bins + 1,)."""
    amplitude: Complexes
    """Peak amplitudes [N or N m], shape (bins, lines, tones)."""

    def of(self, line: str) -> Complexes:
        """Return the amplitudes of one line's force [N or N m], shape (bins, tones).

        Args:
            line: Its name.
        """
        return self.amplitude[:, index_of(line, self.names, "line")]


@dataclass(frozen=True, eq=False, repr=False)
class Checkpoints(Shown):
    """States from which any part of the run can be repeated bit for bit."""

    step: Ints
    """Steps at which the states were kept, shape (checkpoints,)."""
    state: Floats
    """q, q̇ and works, shape (checkpoints, states)."""


@dataclass(frozen=True, eq=False, repr=False)
class Trace(Shown):
    """A simulated stretch of time."""

    method: str
    """Method that was used."""
    step: float
    """Time step; of adaptive methods the spacing of the instants that statistics and windows look at [s]."""
    duration: float
    """Time that was simulated [s]: less than asked if it was interrupted."""
    error: float
    """Measured error of the peaks of line forces over them, beside the whole run at another step [-]."""
    work: Work
    """Energy balance."""
    samples: Samples
    """Evenly spaced instants over the whole run."""
    windows: tuple[Samples, ...]
    """Every step of the windows that were asked for."""
    force: Statistics
    """Of line forces [N or N m]."""
    deflection: Statistics
    """Of line deflections [m or rad]."""
    velocity: Statistics
    """Of q̇ [rad/s or m/s]."""
    checkpoints: Checkpoints
    """States for `replay`."""
    notes: tuple[str, ...]
    """What a reader must know: contact losses with line and time, interruption."""
    labels: Labels
    """Names and units."""
    tolerance: float = 0.0
    """Root of the energy that the error of one adaptive step might hold; 0 for fixed steps [√J]."""
    orders: Orders | None = None
    """Amplitudes of line forces at the tones, if they were asked for."""
    drive: Statistics | None = None
    """Of what is recorded of drives; None without drives."""
    rms_error: float = 0.0
    """Measured error of the root mean squares of line forces over them [-]."""
    interrupted: bool = False
    """Whether the user stopped the run before its end."""
    exponent: float | None = None
    """Largest Lyapunov exponent where teeth part, about: positive, the motion is chaotic; None where none do [1/s]."""

    def to_xarray(self) -> Any:
        """Return the samples of the whole run as an xarray ``Dataset``, as `Samples.to_xarray`."""
        return self.samples.to_xarray()

    def to_dataframe(self) -> Any:
        """Return the samples of the whole run as a pandas ``DataFrame``, as `Samples.to_dataframe`."""
        return self.samples.to_dataframe()

    def whole(self) -> Trace:
        """Return the run, for what needs all of it.

        Raises:
            KeyboardInterrupt: If it was interrupted, as if the run had not kept what was done so far.
        """
        if self.interrupted:
            raise KeyboardInterrupt
        return self


# ----------------------------------------------------------------------------------------------------------------------
# Order amplitudes: how much of a line's force follows each tone, summed up as the run goes.
#
# Least squares on constant, cosine and sine of every tone. Each block adds a product to its bin's normal equations,
# whose size does not depend on how long the run is. Speed may change, since angles count and not frequencies.
# ----------------------------------------------------------------------------------------------------------------------


ALIKE = 1e-10
"""Share of the largest eigenvalue below which tones cannot be told apart in a bin; they share the amplitude [-]."""


class OrderSums:
    """Normal equations of the lines that were asked for, one set for each bin."""

    def __init__(self, system: System, names: tuple[str, ...], *, step: float, bins: int) -> None:
        self.system, self.names, self.step = system, names, step
        self.columns = np.array([index_of(name, system.labels.lines, "line") for name in names], dtype=np.int64)
        self.turning = np.flatnonzero(system.arrays.tone_rate)
        width = 1 + 2 * len(self.turning)
        self.gram, self.share = np.zeros((bins, width, width)), np.zeros((bins, width, len(names)))

    def add(self, place: int, first: int, forces: Floats) -> None:
        """Add steps to a bin.

        Args:
            place: Bin.
            first: Step of the first row.
            forces: Of all lines, shape (steps, lines).
        """
        arrays = self.system.arrays
        time = np.asarray((first + np.arange(len(forces))) * self.step, dtype=np.float64)
        travel = speed_factors(arrays.profile, time)[2]
        wave = np.exp(1j * np.outer(travel, arrays.tone_rate[self.turning]))
        basis = np.hstack([np.ones((len(wave), 1)), wave.real, wave.imag])
        self.gram[place] += basis.T @ basis
        self.share[place] += basis.T @ forces[:, self.columns]

    def result(self, edges: Ints) -> Orders:
        """Return the amplitudes.

        Args:
            edges: Steps at which bins begin and end.
        """
        tones, bins = len(self.turning), len(edges) - 1
        inverse = np.linalg.pinv(self.gram[:bins], rcond=ALIKE, hermitian=True)
        sums = np.swapaxes(inverse @ self.share[:bins], 1, 2)
        amplitude = (sums[:, :, 1 : 1 + tones] - 1j * sums[:, :, 1 + tones :]).astype(np.complex128)
        labels = tuple(self.system.labels.tones[number] for number in self.turning)
        return Orders(self.names, labels, edges.astype(np.float64) * self.step, amplitude)


# ----------------------------------------------------------------------------------------------------------------------
# Recorder: takes blocks of steps as they come and keeps what was asked for; its memory does not grow with time.
# ----------------------------------------------------------------------------------------------------------------------


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
        self.refuse(library(*FUNCTIONS).function("take")(self.taking.place, first, count), first)
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
