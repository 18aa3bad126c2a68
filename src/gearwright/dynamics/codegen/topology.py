"""Parameter layout of generated code, and the data that the functions of one structure share."""

from __future__ import annotations

from collections import Counter
from typing import Literal, NamedTuple

import numpy as np

from gearwright.base import Floats, Ints
from gearwright.dynamics.codegen.assembler import CHUNK, Emitter, aligned, vector
from gearwright.dynamics.model import OUTPUTS, Arrays, Drives, Entries, Series, planned, stacked, weight_numbers

# ----------------------------------------------------------------------------------------------------------------------
# Topology: which numbers a generated right-hand side needs, and where each stands in its parameter array.
#
# Code is generated for the structure alone (who joins whom, which lines have backlash, which tones act where); the
# numbers are parameters, so that all systems of one structure share one compiled code.
# ----------------------------------------------------------------------------------------------------------------------


class LineShape(NamedTuple):
    """Structure of one line."""

    dofs: tuple[int, ...]
    """Coordinates."""
    weights: tuple[int, ...]
    """Number of each weight; equal weights share one, so that sums with them are worked out once."""
    signs: tuple[int, ...]
    """1 or −1 for weights of exactly that, 0 for any other."""
    variation: tuple[int, ...]
    """Tones of its stiffness."""
    error: tuple[int, ...]
    """Tones of its error."""
    gap: bool
    """Whether it has backlash."""
    damped: bool
    """Whether it has damping."""
    slips: bool
    """Whether it slips in the rigid motion, as a damper may."""


class DriveRecord(NamedTuple):
    """Structure of one drive."""

    kind: int
    """Propeller, machine or clutch."""
    place: int
    """Of its record in the table."""
    dof: int
    """Coordinate."""
    second: int
    """The other one of a clutch, or -1."""
    state: int
    """Its first."""
    reads: int
    """Its first input."""


class DriveShape(NamedTuple):
    """Structure of the drives."""

    dofs: tuple[int, ...]
    """Coordinates that feel them."""
    states: int
    """States of all."""
    inputs: int
    """What they read against time."""
    records: tuple[DriveRecord, ...]
    """Drives."""


class Topology(NamedTuple):
    """Structure of a system: hashable, the key of the generated code."""

    size: int
    """Coordinates."""
    tones: int
    """Tones."""
    lines: tuple[LineShape, ...]
    """Structure of each line."""
    loaded: tuple[tuple[int, bool, bool], ...]
    """Coordinates with a load: number, whether it depends on speed, whether on its square."""
    scheduled: tuple[int, ...]
    """Coordinates with a schedule, one for each schedule."""
    turning: tuple[int, ...]
    """Coordinates whose rigid motion may speed up: empty when the speed is constant."""
    gyroscopic: tuple[tuple[int, int], ...]
    """Rows and columns."""
    centripetal: tuple[tuple[int, int], ...]
    """Rows and columns."""
    drives: DriveShape
    """Of the drives."""


@planned
def topology(arrays: Arrays) -> Topology:
    """Return the structure of a system.

    Args:
        arrays: The system's numbers.
    """
    loads = arrays.loads
    scheduled, drives = tuple(loads.schedules.dof.tolist()), _drives(arrays.drives)
    acting = (loads.constant != 0.0) | (loads.damping != 0.0) | (loads.quadratic != 0.0)
    acting[list(scheduled)] = True
    acting[list(drives.dofs)] = True
    steady = bool(np.all(arrays.profile.factor == arrays.profile.factor[0]))
    number = weight_numbers(arrays.line_weight)[0]
    return Topology(
        size=len(arrays.mass),
        tones=len(arrays.tone_rate),
        lines=tuple(_line(arrays, j, number) for j in range(len(arrays.stiffness))),
        loaded=tuple((i, bool(loads.damping[i]), bool(loads.quadratic[i])) for i in np.flatnonzero(acting).tolist()),
        scheduled=scheduled,
        turning=() if steady else tuple(np.flatnonzero(arrays.speed).tolist()),
        gyroscopic=_places(arrays.gyroscopic),
        centripetal=_places(arrays.centripetal),
        drives=drives,
    )


def _drives(drives: Drives) -> DriveShape:
    records, table, place = list[DriveRecord](), drives.table, 2
    while place < len(table):
        kind, dof, second, state, reads = (int(table[place + column]) for column in (1, 2, 4, 6, 7))
        records.append(DriveRecord(kind, place, dof, second, state, reads))
        place += int(table[place])
    dofs = {dof for record in records for dof in (record.dof, record.second)} - {-1}
    return DriveShape(tuple(sorted(dofs)), len(drives.start), len(drives.inputs.dof), tuple(records))


def _line(arrays: Arrays, j: int, number: Ints) -> LineShape:
    entries = slice(arrays.line_start[j], arrays.line_start[j + 1])
    return LineShape(
        dofs=tuple(arrays.line_dof[entries].tolist()),
        weights=tuple(number[entries].tolist()),
        signs=tuple(int(weight) if abs(weight) == 1.0 else 0 for weight in arrays.line_weight[entries]),
        variation=_tones(arrays.variation, j),
        error=_tones(arrays.error, j),
        gap=bool(arrays.backlash[j] > 0.0),
        damped=bool(arrays.damping[j] > 0.0),
        slips=bool(arrays.slip[j] != 0.0),
    )


def _tones(series: Series, j: int) -> tuple[int, ...]:
    return tuple(series.tone[series.start[j] : series.start[j + 1]].tolist())


def _places(entries: Entries) -> tuple[tuple[int, int], ...]:
    return tuple(zip(entries.row.tolist(), entries.column.tolist(), strict=True))


class Layout(NamedTuple):
    """First place of each group of numbers in the parameter array."""

    step: int
    """h."""
    weight: int
    """Distinct weights."""
    stiffness: int
    """Mean stiffness."""
    damping: int
    """c."""
    backlash: int
    """B."""
    variation_cos: int
    """Stiffness coefficients k a, of eight lines for each tone that one of them has."""
    variation_sin: int
    """Stiffness coefficients k b."""
    error_cos: int
    """Error coefficients a."""
    error_sin: int
    """Error coefficients b."""
    rate: int
    """ω of each tone."""
    mobility: int
    """1/M."""
    inertia: int
    """M Ω."""
    speed: int
    """Ω."""
    constant: int
    """Constant load."""
    loss: int
    """Load lost per speed."""
    quadratic: int
    """Load lost per speed squared."""
    gyroscopic: int
    """Ω G."""
    centripetal: int
    """Ω² C."""
    drives: int
    """Table of the drives."""
    slip: int
    """σ."""


@planned
def parameters(arrays: Arrays, h: float) -> tuple[Layout, Floats]:
    """Return where each number stands, and the numbers.

    Args:
        arrays: The system's numbers.
        h: Step [s].
    """
    layout, rows = parameter_rows(stacked([arrays]), h)
    return layout, rows[0]


def parameter_rows(family: Arrays, h: float) -> tuple[Layout, Floats]:
    """Return where each number stands, and a row of numbers for each system, each group filled up to whole vectors.

    Args:
        family: Systems of one structure, `stacked`.
        h: Step [s].
    """
    variation = _coefficients(family, family.variation, family.stiffness)
    error = _coefficients(family, family.error, np.ones_like(family.stiffness))
    weights = np.array([weight_numbers(row)[1] for row in family.line_weight])
    lines = (weights, family.stiffness, family.damping, family.backlash)
    bodies = (1.0 / family.mass, family.mass * family.speed, family.speed)
    frames = (family.gyroscopic.value, family.centripetal.value, family.drives.table, family.slip)
    groups = (np.array([[h]]), *lines, *variation, *error, family.tone_rate, *bodies, *family.loads[:3], *frames)
    starts = np.cumsum([0, *(filled(group.shape[1]) for group in groups)]).tolist()
    rows = aligned(max(len(group) for group in groups), starts[-1])
    for start, group in zip(starts, groups, strict=False):
        rows[:, start : start + group.shape[1]] = group
    return Layout(*starts[:-1]), rows


def filled(count: int) -> int:
    """Return a count of numbers filled up to whole vectors.

    Args:
        count: Numbers.
    """
    return -(-count // CHUNK) * CHUNK


def slots(shape: Topology, group: Literal["variation", "error"]) -> dict[tuple[int, int], int]:
    """Return where the coefficients of a tone stand for each eight lines of which one has it, by (eight, tone).

    Args:
        shape: Structure.
        group: Which series.
    """
    pairs = {(j // CHUNK, tone) for j, line in enumerate(shape.lines) for tone in getattr(line, group)}
    return {pair: CHUNK * place for place, pair in enumerate(sorted(pairs))}


def _coefficients(family: Arrays, series: Series, scale: Floats) -> list[Floats]:
    tone, line = series.tone[0], np.repeat(np.arange(scale.shape[1]), np.diff(series.start[0]))
    pairs, slot = np.unique(line // CHUNK * family.tone_rate.shape[1] + tone, return_inverse=True)
    sums = []
    for values in (series.cosine * scale[:, line], series.sine * scale[:, line]):
        sums.append(np.zeros((len(values), CHUNK * len(pairs))))
        np.add.at(sums[-1].T, slot * CHUNK + line % CHUNK, values.T)
    return sums


# ----------------------------------------------------------------------------------------------------------------------
# Writer: what the generated functions of one structure share: widths of arrays, parameters, the clock table.
# ----------------------------------------------------------------------------------------------------------------------


def wave_width(shape: Topology, clocks: int = 1, width: int = CHUNK) -> int:
    """Return the numbers that hold the cosines of all tones, filled up to whole vectors; the sines take as many.

    Args:
        shape: Structure.
        clocks: Clocks side by side: one for all lanes, or one for each.
        width: Numbers in a vector.
    """
    return -(-shape.tones * clocks // width) * width


def table_width(shape: Topology, clocks: int = 1, width: int = CHUNK) -> int:
    """Return the numbers in a row of the clock table: cosines, sines, s, ṡ, scheduled loads, drives' inputs.

    Args:
        shape: Structure.
        clocks: Clocks side by side.
        width: Numbers in a vector.
    """
    return 2 * wave_width(shape, clocks, width) + (2 + len(shape.scheduled) + shape.drives.inputs) * clocks


def record_width(shape: Topology) -> int:
    """Return the numbers in a row of a record, filled up to whole vectors: q, q̇, line forces, deflections, drives.

    Args:
        shape: Structure.
    """
    return filled(2 * (shape.size + len(shape.lines)) + drive_width(shape))


def drive_width(shape: Topology) -> int:
    """Return the numbers that drives add to a row: their states, and what each reports.

    Args:
        shape: Structure.
    """
    return shape.drives.states + OUTPUTS * len(shape.drives.records)


class Writer:
    """Writes the functions of one structure; `own` names the numbers that each lane has to itself."""

    def __init__(self, shape: Topology, layout: Layout, lanes: int, own: frozenset[str]) -> None:
        self.shape, self.layout, self.lanes, self.own = shape, layout, lanes, own
        self.count = len(shape.lines)
        self.clocks = lanes if "clock" in own else 1
        self.width, self.vector, self.kind = max(CHUNK, lanes), vector(lanes), Emitter(lanes).number
        self.books = lanes == 1
        """Whether works are kept: nobody reads those of trajectories side by side."""
        self.uses = Counter(pair for line in shape.lines for pair in zip(line.dofs, line.weights, strict=True))

    @property
    def waves(self) -> int:
        """Numbers that hold the cosines of all tones."""
        return wave_width(self.shape, self.clocks, self.width)

    def cells(self, count: int) -> list[range]:
        """Return which of so many numbers of a trajectory stand together in each vector.

        Args:
            count: Numbers.
        """
        side = self.width // self.lanes
        return [range(first, min(first + side, count)) for first in range(0, count, side)]

    def function(self, code: Emitter, name: str, pointers: tuple[str, ...]) -> str:
        """Return a function.

        Args:
            code: Its body.
            name: Its name.
            pointers: Names of what it is given; with ``"bv"`` it also takes the factors c and share.
        """
        arguments = ", ".join(f"ptr noalias %{pointer}" for pointer in pointers)
        factors = f", {self.vector} %c, {self.vector} %share" if "bv" in pointers else ""
        head = f'define internal void @{name}({arguments}{factors}) noinline nounwind "stackrealign" {{'
        return "\n".join([head, *code.lines, "  ret void", "}"])

    def whole(self, code: Emitter, group: str, index: int) -> str:
        """Load a vector of parameters: of several lines or coordinates, or of all lanes.

        Args:
            code: Body.
            group: Field of `Layout`.
            index: First number.
        """
        place = getattr(self.layout, group) + index
        if self.lanes == 1:
            return code.wide.load("%p", place)
        return code.load("%own", self.lanes * place) if group in self.own else code.spread("%p", place)

    def number(self, code: Emitter, group: str, index: int) -> str:
        """Load a parameter: each lane's own, or one for all.

        Args:
            code: Body.
            group: Field of `Layout`.
            index: Number.
        """
        place = getattr(self.layout, group) + index
        return code.load("%own", self.lanes * place) if group in self.own else code.spread("%p", place)

    def clock(self, code: Emitter, column: int) -> str:
        """Load a column of the clock table after the waves.

        Args:
            code: Body.
            column: 0 for s, 1 for ṡ, then scheduled loads and drives' inputs.
        """
        return self.shared(code, "%row", 2 * self.waves, column)

    def shared(self, code: Emitter, pointer: str, first: int, index: int) -> str:
        """Load what the clock decides: each lane's own, or one for all.

        Args:
            code: Body.
            pointer: Array.
            first: Where in it the numbers begin.
            index: Number.
        """
        place = first + self.clocks * index
        return code.load(pointer, place) if self.clocks > 1 else code.spread(pointer, place)
