"""The freedoms of a search and the generations that it goes through."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from statistics import NormalDist
from typing import NamedTuple

import numpy as np

from gearwright.base import (
    Bools,
    DesignError,
    Floats,
    GearwrightError,
    Ints,
    Problem,
    Role,
    near,
    one_blas_thread,
    refuse,
    shown,
)
from gearwright.optimum.optimum import Fit
from gearwright.sizing import GearSizing, Sizing, size
from gearwright.spec import (
    Axis,
    Design,
    Pair,
    Planetary,
    Search,
    Study,
    Value,
    axis_length,
    axis_values,
    edited,
    value_at,
)
from gearwright.study.cases import Case, children, split
from gearwright.study.tables import FAILED, NUMBER, REAL, Block, Blocks, Row, crowding, ranks, wanted

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


# ----------------------------------------------------------------------------------------------------------------------
# Generations: the best designs so far as parents, and children of them by NSGA-II over continuous and listed freedoms.
#
# Two things are not as in NSGA-II: half a population are parents, which leaves more generations for as many designs,
# and no child repeats a design that was looked at.
#
# Source: Deb, Pratap, Agarwal, Meyarivan 2002, IEEE Trans. Evol. Comput. 6 (2), 182-197.
# ----------------------------------------------------------------------------------------------------------------------


ALIKE = 1e-12
"""Places of the unit cube that are nearer are one [-]."""
KEPT = 0.5
"""Of a population that become parents [-]."""
LEAST = 8
"""Parents at least [-]."""
TRIES = 10
"""Times that children are made anew where all are known, before some may be [-]: a few lists have few designs."""


class Parents:
    """The best designs that are known, half a population of them."""

    def __init__(self, study: Study, population: int) -> None:
        self.size = max(round(KEPT * population), LEAST)
        self.freedoms = freedoms_of(study)
        self.places = np.zeros((0, len(self.freedoms.names)))
        self.judged = Judged(np.zeros((0, len(study.objectives))), np.zeros((0, len(study.constraints))))
        self.known = set[bytes]()
        """What stands for each design that was looked at or made."""

    def add(self, places: Floats, own: Judged) -> None:
        """Take in designs, and keep the best.

        Args:
            places: In the unit cube, shape (designs, freedoms).
            own: What is known of them.
        """
        places = self.freedoms.meant(places)
        self.known.update(map(key_of, places))
        places, judged = np.vstack([self.places, places]), self.judged.joined(own)
        _, first = np.unique(np.round(places / ALIKE).astype(np.int64), axis=0, return_index=True)
        first.sort()
        places, judged = places[first], judged.take(first)
        rank = judged.ranks
        best = np.lexsort((-crowding(judged.values, rank), rank))[: self.size]
        self.places, self.judged = places[best], judged.take(best)

    @property
    def fits(self) -> tuple[Fit, ...]:
        """Of surrogates: there are none."""
        return ()

    def children(self, count: int, generator: np.random.Generator) -> Floats:
        """Return so many children: tournaments, crossover, mutation.

        Args:
            count: How many [-].
            generator: Of random numbers.
        """
        rank = self.judged.ranks
        crowd = crowding(self.judged.values, rank)
        made: list[Floats] = []
        tries = 0
        while len(made) < count:
            for child in self.freedoms.meant(children(self.places.copy(), rank, crowd, generator)):
                if len(made) < count and (tries >= TRIES or key_of(child) not in self.known):
                    self.known.add(key_of(child))
                    made.append(child)
            tries += 1
        return np.array(made)


def key_of(place: Floats) -> bytes:
    """Return what stands for a place among those that are known.

    Args:
        place: Of the unit cube, shape (freedoms,).
    """
    return np.round(place / ALIKE).astype(np.int64).tobytes()


# ----------------------------------------------------------------------------------------------------------------------
# Gaussian processes: what a result may be at places that were not looked at, and how far that is off where they were.
#
# Source: Rasmussen, Williams 2006, Gaussian Processes for Machine Learning, MIT Press: eq. 2.25 and 2.26 (prediction),
# 4.17 (Matérn, ν = 5/2), 5.8 (likelihood), 5.12 (each left out). The variance is the likeliest one for the lengths.
# ----------------------------------------------------------------------------------------------------------------------


LENGTHS = (0.05, 20.0)
"""Least and largest length over which a result changes, over a freedom's range [-]."""
NOISE = (1e-8, 1.0)
"""Least and largest part of the variance that places do not explain: steps of modules and teeth [-]."""


class Process(NamedTuple):
    """What is known of one result by places and its values there."""

    places: Floats
    """Shape (n, freedoms)."""
    logs: Floats
    """Logarithms of a length for every freedom, and of the noise."""
    mean: float
    scale: float
    variance: float
    """Of the values over their scale [-]."""
    factor: Floats
    """Lower Cholesky factor of the correlations, shape (n, n)."""
    weights: Floats
    """Correlations' inverse times the values over their scale, shape (n,)."""

    @one_blas_thread()
    def at(self, places: Floats) -> tuple[Floats, Floats]:
        """Return mean and standard deviation of the result at places.

        Args:
            places: Shape (rows, freedoms).
        """
        from scipy.linalg import solve_triangular

        across = _correlation(places, self.places, self.logs[:-1])
        spread = solve_triangular(self.factor, across.T, lower=True)
        left = np.maximum(1.0 - np.einsum("ij,ij->j", spread, spread), 0.0)
        return self.mean + self.scale * (across @ self.weights), self.scale * np.sqrt(self.variance * left)

    @property
    @one_blas_thread()
    def left_out(self) -> Floats:
        """By how much the others foretell each value wrong, lengths kept, shape (n,)."""
        from scipy.linalg import cho_solve

        inverse = cho_solve((self.factor, True), np.eye(len(self.places)))
        return np.asarray(self.scale * self.weights / np.diag(inverse))


@one_blas_thread()
def fitted(places: Floats, values: Floats, start: Floats | None = None) -> Process:
    """Return the process of values at places, with the likeliest lengths and noise.

    Args:
        places: Shape (n, freedoms), n of 2 or more.
        values: Shape (n,).
        start: Logarithms where the likeliest are looked for; left out: halves of ranges, and little noise.
    """
    from scipy.optimize import minimize

    freedoms = places.shape[1]
    start = np.log([0.5] * freedoms + [1e-3]) if start is None else start
    bounds = [tuple(map(math.log, LENGTHS))] * freedoms + [tuple(map(math.log, NOISE))]
    found = minimize(lambda logs: _unlikely(places, values, logs), start, method="L-BFGS-B", bounds=bounds,
                     options={"maxiter": 30})  # fmt: skip
    return conditioned(places, values, found.x)


@one_blas_thread()
def conditioned(places: Floats, values: Floats, logs: Floats) -> Process:
    """Return the process of values at places with given lengths and noise.

    Args:
        places: Shape (n, freedoms).
        values: Shape (n,).
        logs: Logarithms of a length for every freedom, and of the noise.
    """
    from scipy.linalg import cho_solve

    mean, scale = float(values.mean()), float(values.std()) or 1.0
    own = (values - mean) / scale
    matrix = _correlation(places, places, logs[:-1]) + math.exp(logs[-1]) * np.eye(len(places))
    factor: Floats = np.linalg.cholesky(matrix + NOISE[0] * np.eye(len(places))).astype(np.float64)
    weights = cho_solve((factor, True), own)
    return Process(places, logs, mean, scale, max(float(own @ weights) / len(own), 1e-12), factor, weights)


def _unlikely(places: Floats, values: Floats, logs: Floats) -> float:
    """Return the negative logarithm of the likelihood but for a constant."""
    own = conditioned(places, values, logs)
    return float(0.5 * len(values) * math.log(own.variance) + np.log(np.diag(own.factor)).sum())


def _correlation(one: Floats, other: Floats, logs: Floats) -> Floats:
    """Return Matérn's correlation of places, ν = 5/2, shape (one, other)."""
    lengths = np.exp(logs)
    square = np.square((one[:, None] - other[None]) / lengths).sum(axis=2)
    far = np.sqrt(5.0 * square)
    return np.asarray((1.0 + far + 5.0 / 3.0 * square) * np.exp(-far))


# ----------------------------------------------------------------------------------------------------------------------
# Children that a surrogate chooses: for results that take seconds, of which no more are computed than need be.
#
# Of many children and points without a plan, those are taken that promise the largest gain along ways that are drawn
# between the objectives, times the chance that they keep the constraints; each that is taken counts as computed with
# what is foretold of it. Source: Knowles 2006, IEEE Trans. Evol. Comput. 10 (1), 50-66 (ParEGO: a drawn weight for
# each design); Jones, Schonlau, Welch 1998, J. Global Optim. 13, 455-492 (expected improvement).
# ----------------------------------------------------------------------------------------------------------------------


POOL = 256
"""Children, and as many points without a plan, among which is chosen [-]."""
SAMPLES = 64
"""Of what every objective of each of them may be [-]."""
FAR = 3.0
"""Distance from the best beyond which a surrogate tells no values apart, over that of the median [-]."""
AUGMENTED = 0.05
"""Weight of the sum of objectives beside the largest (Knowles 2006) [-]."""


class Guided:
    """The best designs that are known, and surrogates of all that are."""

    def __init__(self, study: Study, population: int) -> None:
        self._best = Parents(study, population)
        self._names = (*study.objectives, *study.constraints)
        self._all, self._judged = self._best.places, self._best.judged
        self._logs: dict[str, Floats] = {}
        self._known: dict[str, tuple[Process, Floats]] | None = None
        """Result -> its process with the values that it knows, as soon as it is asked for."""

    def add(self, places: Floats, own: Judged) -> None:
        """Take in designs, keep the best, and remember all.

        Args:
            places: In the unit cube, shape (designs, freedoms).
            own: What is known of them.
        """
        self._known = None
        self._best.add(places, own)
        self._all, self._judged = np.vstack([self._all, self._best.freedoms.meant(places)]), self._judged.joined(own)

    @property
    def places(self) -> Floats:
        """Of the best, in the unit cube, shape (designs, freedoms)."""
        return self._best.places

    @property
    def judged(self) -> Judged:
        """What is known of the best."""
        return self._best.judged

    @property
    def fits(self) -> tuple[Fit, ...]:
        """Of every objective, and of every constraint that some design breaks."""
        found = []
        for name, (process, values) in self._processes().items():
            error = float(np.sqrt(np.mean(np.square(process.left_out))) / (values.std() or 1.0))
            found.append(Fit(name, error, len(values)))
        return tuple(found)

    def children(self, count: int, generator: np.random.Generator) -> Floats:
        """Return the most promising of many children.

        Args:
            count: How many [-].
            generator: Of random numbers.
        """
        known, met = self._processes(), self._best.known
        fresh = self._best.freedoms.meant(generator.random((POOL, self.places.shape[1])))
        bred = self._best.children(POOL, generator)
        met.difference_update(map(key_of, bred))
        pool = np.vstack([bred, fresh[[key_of(place) not in met for place in fresh]]])
        if not known or len(pool) < count:
            return pool[:count]
        taken = _Choice(self, known, pool).taken(count, generator)
        met.update(map(key_of, taken))
        return taken

    def _processes(self) -> dict[str, tuple[Process, Floats]]:
        """Return result -> its process, with the values that it knows; fitted once to what is known."""
        if self._known is None:
            self._known = dict(self._fitted())
        return self._known

    def _fitted(self) -> Iterator[tuple[str, tuple[Process, Floats]]]:
        sized = ~self._judged.failed
        columns = np.hstack([self._judged.values, self._judged.broken])[sized]
        for k, name in enumerate(self._names):
            if len(columns) > 1 and (k < self._judged.values.shape[1] or columns[:, k].any()):
                values = _near(columns[:, k]) if k < self._judged.values.shape[1] else columns[:, k]
                process = fitted(self._all[sized], values, self._logs.get(name))
                self._logs[name] = process.logs
                yield name, (process, values)

    @property
    def failures(self) -> Process | None:
        """What is known of where designs cannot be sized; nothing where all can."""
        failed = self._judged.failed
        return None if not failed.any() or failed.all() else fitted(self._all, failed.astype(float))

    @property
    def reached(self) -> Floats:
        """Objectives of good designs; where there is none, of all that could be sized."""
        good = self._judged.good
        return self._judged.values[good if good.any() else ~self._judged.failed]


def parents_of(study: Study, rules: Search) -> Parents | Guided:
    """Return what breeds: with a surrogate where the search asks for one.

    Args:
        study: With freedoms, objectives and constraints.
        rules: Of the search.
    """
    return (Guided if rules.surrogate else Parents)(study, rules.population)


class _Choice:
    """The choice among a pool."""

    def __init__(self, guided: Guided, known: dict[str, tuple[Process, Floats]], pool: Floats) -> None:
        self.pool, self.open = pool, np.ones(len(pool), dtype=bool)
        objectives = guided.judged.values.shape[1]
        processes = [process for process, _ in known.values()]
        self.objectives, self.limits = processes[:objectives], processes[objectives:]
        self.values = [values for _, values in known.values()][:objectives]
        failures = guided.failures
        self.chance = np.ones(len(pool)) if failures is None else np.clip(1.0 - failures.at(pool)[0], 0.01, 1.0)
        self.reached = guided.reached
        self.low = self.reached.min(axis=0)
        self.span = np.maximum(np.ptp(self.reached, axis=0), 1e-12 * np.abs(self.low) + 1e-300)
        for limit in self.limits:
            self.chance *= _kept(*limit.at(pool))

    def taken(self, count: int, generator: np.random.Generator) -> Floats:
        """Return so many of the pool, one after the other."""
        places = []
        for _ in range(count):
            told = [process.at(self.pool) for process in self.objectives]
            weight = generator.dirichlet(np.ones(len(told)))
            drawn = generator.normal(size=(SAMPLES, len(self.pool), len(told)))
            mean, deviation = (np.array(part).T for part in zip(*told, strict=True))
            aim = self._merit(self.reached, weight).min()
            gain = np.maximum(aim - self._merit(mean + deviation * drawn, weight), 0.0).mean(axis=0)
            best = int(np.argmax(np.where(self.open, (gain + 1e-12) * self.chance, -1.0)))
            self.open[best] = False
            self._believe(self.pool[best], mean[best])
            places.append(self.pool[best])
        return np.array(places)

    def _merit(self, values: Floats, weight: Floats) -> Floats:
        gain = weight * (values - self.low) / self.span
        return np.asarray(gain.max(axis=-1) + AUGMENTED * gain.sum(axis=-1))

    def _believe(self, place: Floats, values: Floats) -> None:
        """Take what is foretold of a place as computed."""
        for k, process in enumerate(self.objectives):
            self.values[k] = np.append(self.values[k], values[k])
            self.objectives[k] = conditioned(np.vstack([process.places, place]), self.values[k], process.logs)
        self.reached = np.vstack([self.reached, values])


def _near(values: Floats) -> Floats:
    """Return values, those that are far from the best as near as `FAR` says: what they are exactly helps nobody."""
    best = values.min()
    return np.asarray(np.minimum(values, best + FAR * (np.median(values) - best)))


def _kept(mean: Floats, deviation: Floats) -> Floats:
    """Return the chance that a constraint is not broken by a thousandth of its bound."""
    from scipy.special import ndtr

    return np.asarray(ndtr((1e-3 - mean) / np.maximum(deviation, 1e-9)))
