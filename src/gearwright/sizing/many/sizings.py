"""Sizing of many designs at once: tables of changes, columns of results, and refused designs."""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Any, NamedTuple, SupportsIndex

import numpy as np

from gearwright.base import Bools, DesignError, Floats, GearwrightError, Ints, Problem, Shown, near, refuse, verb
from gearwright.lanes import Diverged, Lanes, Unsupported
from gearwright.sizing.answers import TEXT, Named, asked_results, named_results, total_results
from gearwright.sizing.many.search import Rows, choose_rows
from gearwright.sizing.many.twinned import twinned
from gearwright.sizing.result import Sizing
from gearwright.sizing.size import is_settled, size
from gearwright.sizing.teeth import Chosen
from gearwright.spec import Design, Epicyclic, Pair, brief, edited, entry_of, path_problems, replaced
from gearwright.spec.design import given_values

# ----------------------------------------------------------------------------------------------------------------------
# Many designs sized: their results as columns, and what each is refused for.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Rows of one design sized at once, its numbers in lanes: by the twins of what sizes one design, with its bits.
#
# Rows whose computation takes another way part, and are computed apart. What cannot be computed in lanes, what is
# refused and groups too small to be worth it are left to the caller, who sizes each alone.
# ----------------------------------------------------------------------------------------------------------------------


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
    if design.compares_sizes and not is_settled(design):
        raise Unsupported("sizes that are completed one after the other")
    return choose_rows(design, train, len(place))


def _in_lanes(group: Group, place: Ints, rows: Rows, planets: Mapping[str, int], some: Ints) -> tuple[Any, Any, Any]:
    """Return design, train and teeth of some rows in lanes."""
    base = edited(group.design, {f"planetaries.{name}.planets": count for name, count in planets.items()})
    design = group.lanes(place[some], base)
    train = twinned("gearwright.train").build_train(design)
    return design, train, Chosen({gear: Lanes(numbers[some]) for gear, numbers in rows.teeth.items()}, {})  # type: ignore[misc]


def _numbers(
    group: Group, place: Ints, results: Sequence[str] | None, rows: Rows, planets: Mapping[str, int], some: Ints
) -> Mapping[str, Any]:
    """Return the results of some of the rows whose teeth are chosen."""
    design, train, choice = _in_lanes(group, place, rows, planets, some)
    given = given_values(design).values
    sizing = twinned("gearwright.sizing.size").sized_with(design, train, choice, given=given)
    named = twinned("gearwright.sizing.answers")
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


# ----------------------------------------------------------------------------------------------------------------------
# The verb for many designs: a table of changes, or any designs, become columns of results.
# ----------------------------------------------------------------------------------------------------------------------


Cell = float | int | str | bool | None
"""Value of one entry in one design; None: this design keeps its own."""


@verb
def size_many(
    designs: Design | Sequence[Design],
    axes: Mapping[str, Any] | None = None,
    *,
    results: Sequence[str] | None = None,
) -> Sizings:
    """Return many designs sized, their results as columns.

    Every row is what `size` makes of it alone, bit for bit, whatever stands beside it. A design that cannot be sized
    is a row of NaN with its reason; designs of different structure stand side by side.

    Args:
        designs: One design that the axes vary, or many.
        axes: Dotted path, with the unit in its last part, -> its value in every row, in that unit; None in a row
            leaves that design its own. Left out: the designs as they are.
        results: Names as `named_results` has them; left out: masses, power densities, margin and efficiency.

    Raises:
        DesignError: For axes that are no columns, of different lengths, that no design has, or that mean the same
            entry; for results that no design has, or that are names.
    """
    columns: Mapping[str, Sequence[Cell]] = axes or {}
    refuse(_column_problems(columns), "axes")
    given = [designs] if isinstance(designs, Design) else list(designs)
    count = _count(designs, columns)
    first = {structure_of(design): design for design in reversed(given)}.values() if count else ()
    refuse(_axis_problems(columns, first), "axes")
    refuse(_result_problems(results or (), first), "results")
    made = partial(_design, given, columns)
    found, places = Found(count), dict[int, Structure]()
    if isinstance(designs, Design) and columns:
        found, places = in_lanes(designs, columns, results, count=count)
    rows, reasons = dict[int, dict[str, float]](), dict[int, str]()
    dimensions = dict(found.dimensions)
    for row in np.flatnonzero(~found.done).tolist():
        try:
            design = made(row)
            places[row] = structure_of(design)
            numbers = _asked_numbers(size(design), results)
        except GearwrightError as error:
            problems = error.problems if isinstance(error, DesignError) else ()
            reasons[row] = "; ".join(map(str, problems)) or str(error)
            continue
        rows[row] = {name: float(number.value) for name, number in numbers.items()}
        dimensions |= {name: number.dimension for name, number in numbers.items()}
    values = stacked(rows, found.values, count)
    order = [name for name in results or values if name in values]
    occurring = dict.fromkeys(places[row] for row in sorted(places))
    structures = {structure: place for place, structure in enumerate(occurring)}
    place = np.array([structures[places[row]] if row in places else -1 for row in range(count)], dtype=np.int64)
    return Sizings(
        {name: values[name] for name in order}, {name: dimensions[name] for name in order},
        np.array([row not in reasons for row in range(count)], dtype=bool), reasons, tuple(structures), place, made,
        found.done,
    )  # fmt: skip


def _count(designs: Design | Sequence[Design], axes: Mapping[str, Sequence[Cell]]) -> int:
    """Return how many rows there are, or refuse columns of different lengths."""
    lengths = {path: len(values) for path, values in axes.items()}
    if not isinstance(designs, Design):
        lengths = {"designs": len(designs), **lengths}
    if len(set(lengths.values())) > 1:
        told = ", ".join(f"{path} {length}" for path, length in lengths.items())
        raise DesignError([Problem("axes", f"columns of different lengths: {told}; give every design its row in each")])
    return next(iter(lengths.values()), 1)


def _column_problems(axes: Mapping[str, Any]) -> Iterator[Problem]:
    """Yield the axes that are no columns: one value, or a table of them."""
    for path, column in axes.items():
        if isinstance(column, str | bytes | Mapping) or not hasattr(column, "__len__"):
            yield Problem(path, f"{brief(column)} is no column; give a list with its value in every row")
        elif getattr(column, "ndim", 1) != 1:
            shape = "×".join(map(str, column.shape))
            yield Problem(path, f"an array of {shape} is no column; give one value for every row, in one axis")


def _axis_problems(axes: Mapping[str, Sequence[Cell]], designs: Iterable[Design]) -> list[Problem]:
    """Return what is wrong with the paths of axes in every design of the first, if it is wrong in all."""
    problems = [path_problems(design, axes) for design in designs]
    everywhere = set.intersection(*({problem.path for problem in found} for found in problems)) if problems else set()
    return [problem for problem in next(iter(problems), []) if problem.path in everywhere]


def _result_problems(results: Sequence[str], designs: Iterable[Design]) -> Iterator[Problem]:
    """Yield the results that no design has, or that are names; nothing where one of them cannot be sized to tell."""
    known: dict[str, Named] = {}
    for design in designs if results else ():
        try:
            known |= named_results(size(design))
        except GearwrightError:
            return
    for name in results if known else ():
        if name not in known:
            yield Problem(name, f"no design has such a result; {near(name, known)}")
        elif known[name].dimension == TEXT:
            yield Problem(name, f"{known[name].value!r} is a name and no number; ask for it of `at(row)`")


def _design(designs: Sequence[Design], axes: Mapping[str, Sequence[Cell]], row: int) -> Design:
    """Return the design of a row: its own entries, but for those that the axes say in it."""
    cells = {path: values[row] for path, values in axes.items()}
    changes = {path: _plain(cell) for path, cell in cells.items() if cell is not None}
    design = designs[row] if len(designs) > 1 else designs[0]
    return edited(design, changes) if changes else design


def _plain(cell: Any) -> Any:
    """Return a number of numpy's as one of Python's."""
    return cell.item() if isinstance(cell, np.generic) else cell


def _asked_numbers(sizing: Sizing, results: Sequence[str] | None) -> dict[str, Named]:
    """Return the asked numbers of a sizing, as far as it has them."""
    if results is None:
        return total_results(sizing)
    named = asked_results(sizing, results)
    return {name: named[name] for name in results if name in named}
