"""Generations by NSGA-II, and selection of candidates by a Gaussian process as surrogate model."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.blas_threads import one_blas_thread
from gearwright.optimum.freedoms import Judged, freedoms_of
from gearwright.optimum.optimum import Fit
from gearwright.spec import Study
from gearwright.spec.studies import Search
from gearwright.study.cases import children
from gearwright.study.tables import crowding

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
        if not failed.any() or failed.all():
            return None
        return fitted(self._all, failed.astype(float))

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
