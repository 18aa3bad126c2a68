"""Design variables in the unit cube, objectives and constraints as numbers, and sizes that are fixed."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from statistics import NormalDist
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats, Ints
from gearwright.errors import DesignError, GearwrightError, Problem, near, refuse
from gearwright.identity import Role
from gearwright.sizing import GearSizing, Sizing, size
from gearwright.spec import Design, Study, edited, value_at
from gearwright.spec.design import Pair, Planetary
from gearwright.spec.studies import Axis, Value, axis_length, axis_values
from gearwright.study.cases import Case, split
from gearwright.study.tables import FAILED, NUMBER, REAL, Block, Blocks, Row, ranks, wanted
from gearwright.units import shown

# ----------------------------------------------------------------------------------------------------------------------
# Freedoms as places of a unit cube: what optimisers move in, and the rows of a study that they mean.
# ----------------------------------------------------------------------------------------------------------------------


DESIGN = "design"
"""Name of the freedom that chooses among several designs."""


class Freedoms(NamedTuple):
    """What a search may change."""

    designs: tuple[str, ...]
    """Designs to choose from."""
    axes: Mapping[str, Axis]
    """Path -> values that it may take."""

    @property
    def names(self) -> tuple[str, ...]:
        """One for each axis of the unit cube: the design, where there are several, then the paths."""
        return (DESIGN, *self.axes) if len(self.designs) > 1 else tuple(self.axes)

    def row(self, place: Floats) -> dict[str, Value]:
        """Return what a place of the unit cube means: freedom -> value, in the unit of its path.

        Args:
            place: From 0 to 1, shape (freedoms,).
        """
        paths = place[len(self.names) - len(self.axes) :].tolist()
        row: dict[str, Value] = {}
        if len(self.designs) > 1:
            row[DESIGN] = self.designs[min(int(place[0] * len(self.designs)), len(self.designs) - 1)]
        return row | {
            path: value_at(path, axis, own) for (path, axis), own in zip(self.axes.items(), paths, strict=True)
        }

    def places(self, rows: Sequence[Mapping[str, Value]]) -> Floats:
        """Return the places of rows in the unit cube, shape (rows, freedoms).

        Args:
            rows: Freedom -> value; what else they hold is left out.
        """
        return np.array([[self._place(name, row[name]) for name in self.names] for row in rows]).reshape(
            len(rows), len(self.names)
        )

    def meant(self, places: Floats) -> Floats:
        """Return places of which those that mean one row are one: lists at the middle of their values' parts.

        Args:
            places: Of the unit cube, shape (rows, freedoms).
        """
        counts = [len(self.designs)] * (len(self.names) - len(self.axes))
        counts += [0 if is_continuous(axis) else axis_length(path, axis) for path, axis in self.axes.items()]
        count = np.array(counts)
        listed = np.minimum(np.floor(places * count), count - 1)
        return np.where(count > 0, (listed + 0.5) / np.maximum(count, 1), places)

    def _place(self, name: str, value: Value) -> float:
        if name == DESIGN:
            return (self.designs.index(str(value)) + 0.5) / len(self.designs)
        return place_of(name, self.axes[name], value)

    def case(self, number: int, row: Mapping[str, Value]) -> Case:
        """Return a row as a case of the study.

        Args:
            number: Of the evaluation.
            row: Freedom -> value; paths that are no freedoms of the search are kept, such as teeth.
        """
        inputs = {name: value for name, value in row.items() if name != DESIGN}
        return Case(number, str(row.get(DESIGN, self.designs[0])), inputs)

    def refuse(self, rows: Sequence[Mapping[str, Value]]) -> None:
        """Raise where rows are none of this search.

        Args:
            rows: Freedom -> value.

        Raises:
            DesignError: With every freedom that is missing or unknown, and every design that is not there.
        """
        problems = []
        for k, row in enumerate(rows):
            missing = [name for name in self.names if name not in row]
            unknown = [name for name in row if name not in self.names]
            problems += [Problem(f"rows.{k}", f"{name} is missing; every freedom needs a value") for name in missing]
            problems += [
                Problem(f"rows.{k}", f"there is no freedom {name}; {near(name, self.names)}") for name in unknown
            ]
            if DESIGN in row and row[DESIGN] not in self.designs:
                problems.append(
                    Problem(f"rows.{k}", f"there is no design {row[DESIGN]}; {near(str(row[DESIGN]), self.designs)}")
                )
        refuse(problems[:20])


def freedoms_of(study: Study) -> Freedoms:
    """Return what the axes of a study leave free.

    Args:
        study: With axes.
    """
    return Freedoms(tuple(study.designs), study.axes)


def is_continuous(axis: Axis) -> bool:
    """Tell whether an axis takes all values of a range, not those of a list.

    Args:
        axis: As written.
    """
    return axis.values is None and axis.step is None


def place_of(path: str, axis: Axis, value: Value) -> float:
    """Return the place of a value in the unit interval, of which `value_at` gives it again but for rounding.

    Args:
        path: Of the entry, for messages.
        axis: As written.
        value: In the unit of the path.

    Raises:
        DesignError: If the axis does not have it.

    >>> place_of("a", Axis.model_validate({"from": 10, "to": 20}), 12.5)
    0.25
    """
    if not is_continuous(axis):
        values = axis_values(path, axis)
        if value not in values:
            raise DesignError(
                [Problem(path, f"{value!r} is none of the values of its axis; {near(str(value), map(str, values))}")]
            )
        return (values.index(value) + 0.5) / len(values)
    if isinstance(value, str | bool):
        raise DesignError([Problem(path, f"{value!r} is no number; its axis is a range")])
    if axis.distribution == "normal":
        place = NormalDist(axis.mean or 0.0, axis.deviation or 1.0).cdf(value)
    else:
        low, high = float(axis.first or 0.0), float(axis.last or 0.0)
        place = _share(axis, low, high, float(value))
    return min(max(place, 0.0), 1.0)


def _share(axis: Axis, low: float, high: float, value: float) -> float:
    """Return the part of a range below a value by its distribution."""
    if axis.distribution == "log-uniform":
        return math.log(max(value, low) / low) / math.log(high / low)
    if axis.distribution == "triangular":
        peak = (low + high) / 2.0 if axis.likeliest is None else axis.likeliest
        if value <= peak:
            return (value - low) ** 2 / ((high - low) * (peak - low)) if peak > low else 0.0
        return 1.0 - (high - value) ** 2 / ((high - low) * (high - peak))
    return (value - low) / (high - low)


# ----------------------------------------------------------------------------------------------------------------------
# Rows as numbers for optimisers: objectives to be made small, and by how much each constraint is broken.
# ----------------------------------------------------------------------------------------------------------------------


class Judged(NamedTuple):
    """What optimisers know of designs."""

    values: Floats
    """Objectives to be made small [SI], shape (designs, objectives)."""
    broken: Floats
    """By how much each constraint is broken, over its bound [-], shape (designs, constraints); 0 where it is kept."""

    @property
    def violation(self) -> Floats:
        """All constraints together [-], shape (designs,)."""
        return np.asarray(self.broken.sum(axis=1) + np.where(self.failed, FAILED, 0.0))

    @property
    def failed(self) -> Bools:
        """Designs that cannot be sized."""
        return np.asarray((self.values >= FAILED).all(axis=1))

    @property
    def good(self) -> Bools:
        """Designs that keep every constraint."""
        return np.asarray(self.violation == 0.0)

    def take(self, place: Ints) -> Judged:
        """Return some of the designs.

        Args:
            place: Which.
        """
        return Judged(self.values[place], self.broken[place])

    def joined(self, other: Judged) -> Judged:
        """Return these designs and others.

        Args:
            other: Of the same search.
        """
        return Judged(np.vstack([self.values, other.values]), np.vstack([self.broken, other.broken]))

    @property
    def ranks(self) -> Ints:
        """Front that each belongs to [-], shape (designs,)."""
        return ranks(self.values, self.violation)


def judged(study: Study, blocks: Blocks) -> tuple[Ints, Judged]:
    """Return the numbers of cases and what optimisers know of them.

    Args:
        study: With objectives and constraints.
        blocks: Finished cases.
    """
    parts = [_of_block(study, block) for block in blocks.blocks]
    numbers = np.concatenate([block.records[NUMBER] for block in blocks.blocks])
    return numbers, Judged(np.vstack([part.values for part in parts]), np.vstack([part.broken for part in parts]))


def judged_rows(study: Study, rows: list[Row]) -> Judged:
    """Return what optimisers know of rows.

    Args:
        study: With objectives and constraints.
        rows: In any order, which is kept.
    """
    broken = np.array([[_excess(study, row, name) for name in study.constraints] for row in rows])
    return Judged(wanted(study, rows), broken.reshape(len(rows), len(study.constraints)))


def _excess(study: Study, row: Row, name: str) -> float:
    return 0.0 if row.problem else float(_over(study, name, np.array([row.shown(name)]))[0])


def _of_block(study: Study, block: Block) -> Judged:
    entries = {name: (k, dimension, kind) for k, (name, dimension, kind) in enumerate(block.shape.results)}
    asked = [*study.objectives, *study.constraints]
    if block.shape.failed or any(entries[name][2] != REAL for name in asked):
        return judged_rows(study, [row for _, row in block])
    offset = len(block.shape.inputs)
    columns = {name: (block.records[f"entry {offset + entries[name][0]}"], entries[name][1]) for name in asked}
    return judged_columns(study, columns)


def judged_columns(study: Study, columns: Mapping[str, tuple[Floats, str]]) -> Judged:
    """Return what optimisers know of designs whose results are columns.

    Args:
        study: With objectives and constraints.
        columns: Result -> values [SI], shape (designs,), and their dimension.
    """
    signs = [1.0 if sense == "minimum" else -1.0 for sense in study.objectives.values()]
    values = [sign * columns[name][0] for sign, name in zip(signs, study.objectives, strict=True)]
    broken = [_over(study, name, columns[name][0] * shown(1.0, columns[name][1])) for name in study.constraints]
    count = len(values[0])
    return Judged(np.array(values).reshape(-1, count).T, np.array(broken).reshape(-1, count).T)


ROUNDING = 1e-9
"""Of a bound by which it may be missed, as every check may [-]."""


def _over(study: Study, name: str, value: Floats) -> Floats:
    """Return by how much a result breaks its bounds, over them [-]."""
    bound, total = study.constraints[name], np.zeros(len(value))
    for limit, excess in ((bound.minimum, -1.0), (bound.maximum, 1.0)):
        if limit is not None:
            over = excess * (value - limit) / (abs(limit) or 1.0)
            total += np.where(over > ROUNDING, over, 0.0)
    return total


# ----------------------------------------------------------------------------------------------------------------------
# Designs of which something is kept: the teeth that were chosen, or modules and face widths, too.
# ----------------------------------------------------------------------------------------------------------------------


_TEETH = {
    Role.PINION: "pinion_teeth", Role.WHEEL: "wheel_teeth",
    Role.SUN: "sun_teeth", Role.PLANET: "planet_teeth", Role.RING: "ring_teeth",
}  # fmt: skip
_TABLES: Mapping[type, str] = {Pair: "pairs", Planetary: "planetaries"}
_MM = 1e-3


class Fixed(NamedTuple):
    """A design whose teeth are kept."""

    design: str
    inputs: Mapping[str, Value]
    """Freedoms, and paths of teeth."""


def sizing_of(study: Study, designs: Mapping[str, Design], row: Row) -> Sizing:
    """Return the sizing of a row.

    Args:
        study: With its changes.
        designs: Name -> design.
        row: That could be sized.
    """
    changes, _ = split({**study.changes, **row.inputs})
    return size(edited(designs[row.design], changes))


def with_teeth(study: Study, designs: Mapping[str, Design], row: Row) -> Fixed | None:
    """Return a row with the teeth and numbers of planets that were chosen; nothing where they cannot be kept.

    Args:
        study: With its changes.
        designs: Name -> design.
        row: That could be sized.
    """
    try:
        sizing = sizing_of(study, designs, row)
        return Fixed(row.design, {**row.inputs, **teeth_of(sizing)})
    except GearwrightError:
        return None


def teeth_of(sizing: Sizing) -> dict[str, Value]:
    """Return path -> teeth and planets of every pair and planetary set.

    Args:
        sizing: As sized.
    """
    found: dict[str, Value] = {}
    for path, gear in _gears(sizing):
        if gear.role in _TEETH:
            found[f"{path}.{_TEETH[gear.role]}"] = gear.teeth
        if gear.role is Role.PLANET:
            found[f"{path}.planets"] = gear.bodies
    return found


def sizes_of(sizing: Sizing) -> dict[str, Value]:
    """Return path -> module and face width of every pair and planetary set [mm].

    Args:
        sizing: As sized.
    """
    found: dict[str, Value] = {}
    for path, gear in _gears(sizing):
        found.setdefault(f"{path}.module_mm", gear.module / _MM)
        found.setdefault(f"{path}.face_width_mm", gear.face_width / _MM)
    return found


def _gears(sizing: Sizing) -> Iterator[tuple[str, GearSizing]]:
    """Yield the gears of pairs and planetary sets, each with the path of its stage."""
    for gear in sizing.gears:
        table = _TABLES.get(type(sizing.design.stages[gear.stage]))
        if table is not None:
            yield f"{table}.{gear.stage}", gear
