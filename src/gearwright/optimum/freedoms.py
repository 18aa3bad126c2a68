"""Freedoms as places of a unit cube: what optimisers move in, and the rows of a study that they mean."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from statistics import NormalDist
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem, near, refuse
from gearwright.spec import Study, value_at
from gearwright.spec.studies import Axis, Value, axis_length, axis_values
from gearwright.study.cases import Case

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
