"""Many designs sized: their results as columns, and what each is refused for."""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import NamedTuple, SupportsIndex

import numpy as np

from gearwright.arrays import Bools, Floats, Ints
from gearwright.errors import DesignError, Problem
from gearwright.showing import Shown
from gearwright.sizing.result import Sizing
from gearwright.sizing.size import size
from gearwright.spec import Design, Epicyclic, Pair


class Structure(NamedTuple):
    """What two designs have in common whose numbers alone differ."""

    level: str | None
    shafts: tuple[str, ...]
    stages: tuple[tuple[str, ...], ...]
    """Name, kind, method of rating, and the shafts that it joins, of every stage."""
    machines: tuple[tuple[str, ...], ...]
    """Name, kind and shaft of every machine."""
    links: tuple[str, ...]
    """Clutches and dampers."""
    cases: tuple[str, ...]


def structure_of(design: Design) -> Structure:
    """Return the structure of a design: its graph, kinds, methods and level, without any number.

    Args:
        design: As read.
    """
    stages = tuple(
        (name, stage.kind if isinstance(stage, Pair) else type(stage).__name__, design.rating(name), *_joined(stage))
        for name, stage in design.stages.items()
    )
    machines = tuple((name, type(machine).__name__, machine.shaft) for name, machine in design.machines.items())
    return Structure(design.level, tuple(design.shafts), stages, machines, tuple(design.links), tuple(design.cases))


def _joined(stage: object) -> tuple[str, ...]:
    if isinstance(stage, Pair):
        return tuple(str(side) for side in (stage.pinion, stage.wheel))
    return tuple(stage.members) if isinstance(stage, Epicyclic) else tuple(getattr(stage, "members", ()))


@dataclass(frozen=True, eq=False, repr=False)
class Sizings(Shown):
    """Sizings of many designs: one row each, in the order in which they were given."""

    columns: Mapping[str, Floats]
    """Result by its dotted name -> its value for every design [SI]; NaN of one that is refused or has no such part."""
    dimensions: Mapping[str, str]
    """Result -> its dimension, such as ``mass``."""
    sized: Bools
    """Which designs are sized."""
    reasons: Mapping[int, str]
    """Row -> why it is refused, of those that are."""
    structures: tuple[Structure, ...]
    """Every structure that occurs."""
    structure: Ints
    """Row -> place of its structure among them; −1 where no design could be made."""
    design: Callable[[int], Design]
    """Row -> its design."""
    together: Bools
    """Which designs were computed together, in lanes; each of the rest was sized alone. All have the same bits."""

    def __len__(self) -> int:
        """Return how many designs there are."""
        return len(self.sized)

    def at(self, row: SupportsIndex) -> Sizing:
        """Return the full sizing of one design, with the same numbers to the last bit.

        Args:
            row: From 0; negative ones count from the end.

        Raises:
            DesignError: If there is no such row, or its design is refused; with why.
        """
        place = operator.index(row)
        if not -len(self) <= place < len(self):
            message = f"{place} is no row; there are {len(self)}, counted from 0"
            raise DesignError([Problem("row", message)])
        return size(self.design(place % len(self)))


def stacked(rows: Mapping[int, Mapping[str, float]], columns: Mapping[str, Floats], count: int) -> dict[str, Floats]:
    """Return columns with the results of more rows; NaN where a row lacks what others have.

    Args:
        rows: Row -> name -> value.
        columns: Of other rows.
        count: Rows of all [-].
    """
    whole = dict(columns)
    for place, row in rows.items():
        for name, value in row.items():
            if name not in whole:
                whole[name] = np.full(count, np.nan)
            whole[name][place] = value
    return whole
