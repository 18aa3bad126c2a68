"""What the search for teeth reads of many designs of one structure at once: tasks of every choice, and of every row."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from gearwright.arrays import Floats, Ints
from gearwright.lanes import Lanes, Unsupported, lanes_of
from gearwright.sizing.many.by_lane import of_lane
from gearwright.sizing.teeth.candidates import is_given
from gearwright.sizing.teeth.front import Front
from gearwright.spec import Design
from gearwright.spec.edit import replaced

ROW = "\0row"
"""Under which name the row of a choice stands among its teeth."""
NUMBERS = ("torque", "speed", "rolling", "steady", "fastest")
"""Numbers of a task that may differ from row to row."""


def rows_of(value: Any, count: int) -> Any:
    """Return a number of every row.

    Args:
        value: Lanes, or a number that all rows have.
        count: Rows [-].
    """
    return np.broadcast_to(lanes_of(value).data, (count,))


def _spread(rating: Any, row: Ints) -> Any:
    """Return rules whose numbers that are lanes are those of the row of every choice."""
    rules, material = rating.rules, rating.material
    own = {name: value for name, value in rules.__dict__.items() if type(value) is Lanes}
    steel = {name: value for name, value in vars(material).items() if type(value) is Lanes}
    if own:
        rules = replaced(rules, {(name,): rows_of(value, len(value.data))[row] for name, value in own.items()})
    if steel:
        material = replace(material, **{name: value.data[row] for name, value in steel.items()})
    factor = rating.load_factor
    if type(factor) is Lanes:
        factor = rows_of(factor, len(factor.data))[row]
    elif not own and not steel:
        return rating
    return replace(rating, rules=rules, material=material, load_factor=factor)


def _banned(ban: Any, row: Ints) -> Any:
    """Return a ban whose numbers that are lanes are those of the row of every choice."""
    ends: dict[tuple[str, ...], Any] = {
        (name,): end.data[row] for name in ("lowest", "highest") if type(end := getattr(ban.band, name)) is Lanes
    }
    band = replaced(ban.band, ends) if ends else ban.band
    factors = lanes_of(ban.factor).data
    return ban._replace(band=band, factor=factors[row] if len(factors) > 1 else float(factors[0]))


class Batch(NamedTuple):
    """What the search of a batch reads."""

    design: Design
    """As the case holds it that asks for the speeds; its numbers may be lanes."""
    tasks: Sequence[Any]
    nominal: Any
    speeds: Mapping[str, Floats]
    """Shaft -> asked speed in every row [rad/s]."""
    asked: Mapping[str, Floats]
    """Machine -> asked speed in every row [rad/s]."""
    numbers: Mapping[str, Mapping[str, Floats]]
    """Stage -> `NUMBERS` of its task in every row."""
    alone: dict[tuple[str, int], Any]
    """Stage and row -> its task there, as far as asked for."""
    kept: frozenset[str]
    """Shafts whose speed is kept."""

    def task(self, task: Any, front: Front) -> Any:
        """Return a task with the numbers of every choice of a front."""
        row = front.teeth[ROW]
        numbers = {name: values[row] for name, values in self.numbers[task.name].items()}
        bans = tuple(_banned(ban, row) for ban in task.bans)
        rating = _spread(task.rating, row)
        return replace(task, **numbers, rating=rating, bans=bans)

    def row(self, task: Any, row: int) -> Any:
        """Return a task with the numbers of one row."""
        if (task.name, row) not in self.alone:
            numbers = {name: float(values[row]) for name, values in self.numbers[task.name].items()}
            self.alone[task.name, row] = replace(of_lane(task, row), **numbers, known={}, closed={})
        return self.alone[task.name, row]

    def targets(self, front: Front) -> Any:
        """Return the asked speeds of every choice of a front."""
        row = front.teeth[ROW]
        return replace(self.nominal, speeds={shaft: speed[row] for shaft, speed in self.speeds.items()})


def batch_of(design: Design, train: Any, count: int, search: Any) -> Batch:
    """Return what the search of a design with lanes reads.

    Args:
        design: With lanes.
        train: Its graph.
        count: Rows [-].
        search: Twin of the search.

    Raises:
        Unsupported: If its rows have to be searched one by one.
    """
    rules = design.teeth
    if rules.sized != 1 or rules.split != "equal" or rules.ring_deviation:
        raise Unsupported("teeth that are searched in another way")
    nominal = search.targets(design)
    if any(not is_given(stage) and nominal.tooth_ratios[name] <= 1.0 for name, stage in design.planetaries.items()):
        raise Unsupported("a ring no larger than its sun")
    flow, known = search.nominal_flow(design, train, nominal)
    given_design, design = design, nominal.design
    tasks = [search.task_of(name, design, train, nominal, flow) for name in design.simple_stages]
    bans = search.banned(tasks, given_design, train, nominal, flow)
    if bans.whole:
        raise Unsupported("bands of frequencies that only whole trains are held against")
    tasks = search.with_twins(bans.tasks, design, nominal)
    return Batch(
        design, tasks, nominal,
        {shaft: rows_of(speed, count) for shaft, speed in nominal.speeds.items()},
        {name: rows_of(machine.asked_speed, count) for name, machine in design.machines.items()
         if machine.asked_speed is not None},
        {task.name: {name: rows_of(getattr(task, name), count) for name in NUMBERS} for task in tasks},
        {}, frozenset(known),
    )  # fmt: skip
