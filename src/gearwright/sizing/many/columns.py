"""Rows of one design sized at once, its numbers in lanes: by the twins of what sizes one design, with its bits.

Rows whose computation takes another way part, and are computed apart. What cannot be computed in lanes, what is refused
and groups too small to be worth it are left to the caller, who sizes each alone.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats, Ints
from gearwright.errors import GearwrightError
from gearwright.lanes import Diverged, Lanes, Unsupported
from gearwright.sizing.many.nearest import Looked, nearest_rows
from gearwright.sizing.many.search import Rows, choose_rows, consider_rows
from gearwright.sizing.many.sizings import Structure, structure_of
from gearwright.sizing.many.twinned import twinned
from gearwright.sizing.result import PRELIMINARY
from gearwright.sizing.teeth import CONSIDERED, Chosen
from gearwright.spec import Design, edited
from gearwright.spec.design import given_values
from gearwright.spec.edit import entry_of, replaced

LANES = 16384
"""Rows that are computed at once [-]."""
FEW, FEWEST = 12, 6
"""Rows that are sized sooner one by one than together: of a batch, whose first loads the twins; and of a part of one
(as quick either way: 5 rows where twins are loaded, 45 where the process loads them) [-]."""
SPARED = 0.1
"""Part of rows whose time may go into computations that part [-]."""
LEAST_PURSE = 24.0
"""Rows that may be computed in vain of few that part early, as most do: at their powers, speeds and teeth [-]."""
BEARINGS, BEVELS = 10, 20
"""Rows one by one that take as long as a computation of rows together, where these part late: by the bearing that is
chosen for a planet, and by sizes of rated bevel gears, which are looked for longest. Of all others `FEWEST` [-]."""
TRIED = 4
"""Rows of a group of which one must make a design [-]."""
PLAIN = "lewis-hertz"
"""Rating of which designs with built shafts are tried together: steps and bearings part the rows as a standard's sizes
do not, and what is tried in vain costs a second."""
BEVEL = "iso10300"
"""Rating of bevel gears."""
BY_VALUE = frozenset({"pressure_angle"})
"""Numbers of which the search for teeth takes one for all its candidates: rows part by them."""
DEEP = 12
"""How often rows may part before they are sized one by one [-]."""


class Group(NamedTuple):
    """Rows that differ by plain numbers alone."""

    design: Design
    """That has every entry; the numbers of its first row stand in it."""
    rows: Ints
    entries: Mapping[tuple[str, ...], Floats]
    """Location of a number -> its value in each of these rows [SI]."""

    def lanes(self, place: Ints, design: Design | None = None) -> Design:
        """Return the design with the numbers of some of its rows in lanes."""
        return replaced(design or self.design, {at: Lanes(values[place]) for at, values in self.entries.items()})


@dataclass
class Found:
    """Results of rows that were computed in lanes."""

    count: int
    """Rows of all, also of those that are not computed here [-]."""
    values: dict[str, Floats] = field(default_factory=dict)
    """Result -> its value in every row [SI]; NaN where it is not computed here."""
    dimensions: dict[str, str] = field(default_factory=dict)
    """Result -> its dimension."""
    done: Bools = field(default_factory=lambda: np.zeros(0, dtype=bool))
    """Which rows are computed."""

    def __post_init__(self) -> None:
        self.done = np.zeros(self.count, dtype=bool)

    def add(self, rows: Ints, numbers: Mapping[str, Any]) -> None:
        """Note the results of some rows."""
        for name, number in numbers.items():
            if name not in self.values:
                self.values[name] = np.full(self.count, np.nan)
            value = number.value
            self.values[name][rows] = value.data if isinstance(value, Lanes) else value
            self.dimensions[name] = number.dimension
        self.done[rows] = True


def in_lanes(
    design: Design, axes: Mapping[str, Sequence[Any]], results: Sequence[str] | None, *, count: int
) -> tuple[Found, dict[int, Structure]]:
    """Return the results of as many rows as can be computed at once, and the structures of those rows.

    Args:
        design: That the axes vary.
        axes: Dotted path -> value in every row; None leaves a row its own.
        results: Names of results; left out: totals.
        count: Rows [-].
    """
    found, structures = Found(count), dict[int, Structure]()
    if count >= FEW:
        with np.errstate(all="ignore"):
            for group in groups_of(design, axes, count):
                structure = structure_of(group.design)
                structures |= dict.fromkeys(group.rows.tolist(), structure)
                for first in range(0, len(group.rows), LANES):
                    _size(group, np.arange(first, min(first + LANES, len(group.rows))), found, results)
    return found, structures


def groups_of(design: Design, axes: Mapping[str, Sequence[Any]], count: int) -> Iterator[Group]:
    """Yield the rows that differ by plain numbers alone, as far as they are many and allowed.

    Args:
        design: That the axes vary.
        axes: Dotted path -> value in every row.
        count: Rows [-].
    """
    columns = {path: list(values) for path, values in axes.items()}
    plain = {path: np.fromiter(map(_is_plain, cells), bool, count) for path, cells in columns.items()}
    others = [path for path, numbers in plain.items() if 2 * numbers.sum() < count]
    good = np.ones(count, dtype=bool)
    for path in plain.keys() - others:
        good &= plain[path]  # one that is no number where all others are is left to its own sizing
    for path in others:
        good &= np.fromiter((isinstance(cell, _SCALARS) for cell in columns[path]), bool, count)
    yield from _groups(design, columns, others, np.flatnonzero(good))


def _groups(design: Design, columns: Mapping[str, list[Any]], others: Sequence[str], rows: Ints) -> Iterator[Group]:
    """Yield some rows in groups that have the same values on the other axes."""
    alike = dict[tuple[Any, ...], list[int]]()
    for row in rows.tolist():
        alike.setdefault(tuple((type(columns[path][row]), columns[path][row]) for path in others), []).append(row)
    for own in alike.values():
        group = _group(design, columns, others, np.array(own)) if len(own) >= FEW else None
        if isinstance(group, Group):
            yield group
        elif group:  # whole numbers, such as those of planets: the graph follows from them
            yield from _groups(design, columns, [*others, *group], np.array(own))


def _is_plain(cell: Any) -> bool:
    if isinstance(cell, float | np.floating):
        return True
    return isinstance(cell, int | np.integer) and not isinstance(cell, bool) and abs(int(cell)) < _LARGEST


_SCALARS = (str, float, int, bool, type(None))
_LARGEST = 2**53
"""Whole numbers below are as exact among real ones [-]."""


def _group(
    design: Design, columns: Mapping[str, list[Any]], others: Sequence[str], rows: Ints
) -> Group | list[str] | None:
    """Return the rows of a group whose numbers are allowed; paths by which they have to part; None of neither."""
    base = next((made for row in rows[:TRIED].tolist() if (made := _made(design, columns, row)) is not None), None)
    if base is None:
        return None
    entries: dict[tuple[str, ...], Floats] = {}
    good, parting = np.ones(len(rows), dtype=bool), list[str]()
    for path, cells in columns.items():
        if path in others:
            continue
        own = [_python(cells[row]) for row in rows.tolist()]
        entry = entry_of(base, path)
        if entry is None or entry.location[-1] in BY_VALUE:
            if any(cell != own[0] for cell in own):
                parting.append(path)
            continue
        values = np.array([entry.si(float(cell)) for cell in own])
        allowed = entry.allowed
        good &= np.isfinite(values) & (values > allowed.minimum if allowed.above else values >= allowed.minimum)
        good &= values < allowed.maximum if allowed.below else values <= allowed.maximum
        good &= (values == 0.0) | (np.abs(values) >= allowed.smallest)
        entries[entry.location] = values
    if parting:
        return parting
    if not good.any():
        return None
    return Group(base, rows[good], {at: values[good] for at, values in entries.items()})


def _made(design: Design, columns: Mapping[str, list[Any]], row: int) -> Design | None:
    """Return the design of a row; None where it is none."""
    cells = {path: _python(cells[row]) for path, cells in columns.items()}
    try:
        return edited(design, {path: cell for path, cell in cells.items() if cell is not None})
    except GearwrightError:
        return None


def _python(cell: Any) -> Any:
    return cell.item() if isinstance(cell, np.generic) else cell


def _size(group: Group, place: Ints, found: Found, results: Sequence[str] | None) -> None:
    """Size some rows of a group, and note their results."""
    price = _price(group.design)
    for part, rows in _parting(place, partial(_teeth, group), price):
        for some, numbers in _at_once(rows, partial(_numbers, group, part, results), price):
            found.add(group.rows[part[some]], numbers)


def _price(design: Design) -> int:
    """Return how many rows one by one take about as long as a computation of rows together [-]."""
    if any(design.rating(stage) == BEVEL for stage in design.stages):
        return BEVELS
    return BEARINGS if any(stage.planet_bearing for stage in design.planetaries.values()) else FEWEST


def _at_once(
    rows: Rows, computed: Callable[[Rows, Mapping[str, int], Ints], Any], price: int
) -> Iterator[tuple[Ints, Any]]:
    """Yield what is computed of rows with teeth, those of equal numbers of planets at once."""
    count = len(rows.found)
    planets = np.stack([*rows.planets.values(), np.zeros(count)]) if rows.planets else np.zeros((1, count))
    for counts in np.unique(planets[:, rows.found], axis=1).T:
        own = np.flatnonzero(rows.found & (planets == counts[:, None]).all(axis=0))
        given = dict(zip(rows.planets, counts.astype(int).tolist(), strict=False))
        yield from _parting(own, partial(computed, rows, given), price)


def _teeth(group: Group, place: Ints) -> Rows:
    """Return the teeth of some rows, whose design nothing speaks against."""
    design = group.lanes(place)
    if design.bearings and any(design.rating(stage) != PLAIN for stage in design.stages):
        raise Unsupported("built shafts with gears that a standard rates")
    if twinned("gearwright.spec.checks.design").reference_problems(design) or given_values(design).problems:
        raise TypeError("a design that is refused")
    train = twinned("gearwright.train").build_train(design)
    if design.level != PRELIMINARY or design.teeth.sized != 1:
        return choose_rows(design, train, len(place))
    considered = consider_rows(design, train, len(place), kept=CONSIDERED)

    def look(rows: Ints, teeth: Rows) -> Iterator[tuple[Ints, Looked]]:
        yield from _at_once(teeth, partial(_looked, group, place[rows]), _price(group.design))

    return nearest_rows(train, considered, look, count=len(place))


def _in_lanes(group: Group, place: Ints, rows: Rows, planets: Mapping[str, int], some: Ints) -> tuple[Any, Any, Any]:
    """Return design, train and teeth of some rows in lanes."""
    base = edited(group.design, {f"planetaries.{name}.planets": count for name, count in planets.items()})
    design = group.lanes(place[some], base)
    train = twinned("gearwright.train").build_train(design)
    return design, train, Chosen({gear: Lanes(numbers[some]) for gear, numbers in rows.teeth.items()}, {})  # type: ignore[misc]


def _looked(group: Group, place: Ints, rows: Rows, planets: Mapping[str, int], some: Ints) -> Looked:
    """Return what comes of the gears of some of the rows with some teeth."""
    design, train, choice = _in_lanes(group, place, rows, planets, some)
    geared = twinned("gearwright.sizing.stages.geared").geared
    gears = geared(design, train, choice, given=given_values(design).values)
    return Looked(gears.nearness, gears.heaviness, gears.mass)


def _numbers(
    group: Group, place: Ints, results: Sequence[str] | None, rows: Rows, planets: Mapping[str, int], some: Ints
) -> Mapping[str, Any]:
    """Return the results of some of the rows whose teeth are chosen."""
    design, train, choice = _in_lanes(group, place, rows, planets, some)
    given = given_values(design).values
    sizing = twinned("gearwright.sizing.size").sized_with(design, train, choice, given=given)
    named = twinned("gearwright.sizing.answers.named")
    if results is None:
        return dict(named.total_results(sizing))
    numbers = named.asked_results(sizing, results)
    return {name: numbers[name] for name in results if name in numbers}


@dataclass
class _Purse:
    """How many rows may still be computed in vain before all that are left are sized one by one."""

    left: float


def _parting(
    place: Ints, computed: Callable[[Ints], Any], price: int = FEWEST, depth: int = 0, purse: _Purse | None = None
) -> Iterator[tuple[Ints, Any]]:
    """Yield what a computation in lanes gives of rows, apart where they part; nothing of those that must be alone.

    A computation costs what some rows cost one by one, its price. Those that part are paid from a tenth of all rows and
    from what others gain, and where rows part late none is begun that could not be paid: so no batch takes much longer
    than its rows one by one.
    """
    purse = purse or _Purse(max(SPARED * len(place), LEAST_PURSE if price == FEWEST else 0.0))
    if len(place) < FEWEST or depth > DEEP or purse.left < price:
        return
    try:
        result = computed(place)
    except Diverged as parted:
        labels = np.broadcast_to(np.asarray(parted.labels), (len(place),))
    except (GearwrightError, ArithmeticError, LookupError, TypeError, ValueError, AttributeError, RecursionError):
        purse.left -= price
        return
    else:
        gain = len(place) - price
        purse.left += SPARED * gain if gain > 0 else gain
        yield place, result
        return
    purse.left -= price
    for label in np.unique(labels):
        yield from _parting(place[labels == label], computed, price, depth + 1, purse)
