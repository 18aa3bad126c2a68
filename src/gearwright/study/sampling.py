"""Cases of a study: every combination, lists, and samples drawn from ranges and distributions.

A case's number and inputs follow from the study alone, never from who computes it or when: the same seed gives the
same cases, bit for bit, with any number of workers.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import product
from statistics import NormalDist
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gearwright.errors import DesignError, Problem
from gearwright.spec.study import Axis, Study, Value, axis_values, case_count

Floats = NDArray[np.float64]


class Case(NamedTuple):
    """One variant of one design."""

    number: int
    """Place in the study, from 0."""
    design: str
    """Design that is varied."""
    inputs: dict[str, Value]
    """Dotted path with unit -> value."""


def cases(study: Study) -> Iterator[Case]:
    """Yield every case of a study: designs outermost, of a grid the last axis fastest.

    Args:
        study: With any method but ``nsga2``, whose cases follow from earlier results.

    Raises:
        DesignError: If axes and method do not go together, or there are too many cases.
    """
    case_count(study)
    paths, number = list(study.axes), 0
    for name in study.designs:
        for values in _values(study):
            yield Case(number, name, dict(zip(paths, values, strict=True)))
            number += 1


def _values(study: Study) -> Iterator[tuple[Value, ...]]:
    """Yield the values of all axes for every case of one design."""
    if study.sampling.method in ("grid", "list"):
        columns = [axis_values(path, axis) for path, axis in study.axes.items()]
        if study.sampling.method == "grid":
            yield from product(*columns)
        else:
            yield from zip(*columns, strict=True) if columns else iter([()])
        return
    axes = list(study.axes.items())
    for row in unit_sample(study):
        yield tuple(value_at(path, axis, float(place)) for (path, axis), place in zip(axes, row, strict=True))


def unit_sample(study: Study) -> Floats:
    """Return the sample of a study in the unit cube, shape (cases of one design, axes).

    Args:
        study: With a method that draws samples.

    Source: Sobol' points with Owen's scrambling and Latin hypercubes of scipy.stats.qmc; for ``saltelli`` the blocks
        A, B and A with each column of B in turn (Saltelli et al. 2010, Comput. Phys. Commun. 181, 259-270).
    """
    method, count, axes = study.sampling.method, study.sampling.count or 0, len(study.axes)
    generator = np.random.default_rng(study.sampling.seed)
    if method == "random":
        return generator.random((count, axes))
    if method == "latin-hypercube":
        from scipy.stats import qmc  # half a second to load: only for those who draw by it

        return np.asarray(qmc.LatinHypercube(axes, rng=generator).random(count))
    if method == "sobol":
        return _sobol(count, axes, generator)
    both = _sobol(count, 2 * axes, generator)
    first, second = both[:, :axes], both[:, axes:]
    return np.concatenate([first, second, *(_exchanged(first, second, k) for k in range(axes))])


def _sobol(count: int, axes: int, generator: np.random.Generator) -> Floats:
    """Return the first points of a scrambled Sobol' sequence; drawn to a power of two, which keeps their balance."""
    from scipy.stats import qmc

    power = max(0, math.ceil(math.log2(count)))
    return np.asarray(qmc.Sobol(axes, rng=generator).random_base2(power)[:count])


def _exchanged(first: Floats, second: Floats, column: int) -> Floats:
    block = first.copy()
    block[:, column] = second[:, column]
    return block


def value_at(path: str, axis: Axis, place: float) -> Value:
    """Return the value of an axis at a place of the unit interval, by its inverse distribution.

    Args:
        path: Of the entry, for messages.
        axis: As written; of a list or of equal steps every value is as likely.
        place: From 0 to 1 [-].

    Raises:
        DesignError: If what the distribution needs is not given.

    >>> value_at("a", Axis.model_validate({"from": 10, "to": 20}), 0.25)
    12.5
    """
    if axis.distribution == "normal":
        if axis.mean is None or axis.deviation is None:
            raise DesignError([Problem(f"axes.{path}", "a normal distribution needs mean and deviation")])
        inside = min(max(place, np.finfo(float).tiny), 1.0 - 2.0**-53)
        return NormalDist(axis.mean, axis.deviation).inv_cdf(inside)
    if axis.values is not None or axis.step is not None:
        values = axis_values(path, axis)
        return values[min(int(place * len(values)), len(values) - 1)]
    return _in_range(path, axis, place)


def _in_range(path: str, axis: Axis, place: float) -> float:
    if axis.first is None or axis.last is None:
        raise DesignError([Problem(f"axes.{path}", "give a list of values, from and to, or a normal distribution")])
    low, high = float(axis.first), float(axis.last)
    if low >= high:
        message = f"there is nothing between {low:g} and {high:g}; from must be below to (a single value: [changes])"
        raise DesignError([Problem(f"axes.{path}", message)])
    if axis.distribution == "log-uniform":
        if low <= 0.0:
            raise DesignError([Problem(f"axes.{path}.from", f"{low:g} has no logarithm; give a value above 0")])
        return low * math.exp(place * math.log(high / low))
    if axis.distribution == "triangular":
        peak = (low + high) / 2.0 if axis.likeliest is None else axis.likeliest
        if not low <= peak <= high:
            raise DesignError([Problem(f"axes.{path}.likeliest", f"{peak:g} is not between {low:g} and {high:g}")])
        left = (peak - low) / (high - low)
        if place < left:
            return low + math.sqrt(place * (high - low) * (peak - low))
        return high - math.sqrt((1.0 - place) * (high - low) * (high - peak))
    return low + (high - low) * place
