"""Cases of a study: every combination, lists, and samples drawn from ranges and distributions.

A case's number and inputs follow from the study alone, never from who computes it or when: the same seed gives the
same cases, bit for bit, with any number of workers.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import product
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.signals import heard_after
from gearwright.spec import Study, axis_values, case_count, value_at
from gearwright.spec.studies import Value

DRAWN = 1 << 16
"""Independent draws that are held at once [-]."""


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
    for row in _rows(study):
        yield tuple(value_at(path, axis, float(place)) for (path, axis), place in zip(axes, row, strict=True))


def _rows(study: Study) -> Iterator[Floats]:
    """Yield the rows of the sample; independent draws a part at a time, of which there may be a thousand millions."""
    if study.sampling.method != "random":
        yield from unit_sample(study)
        return
    generator, left = np.random.default_rng(study.sampling.seed), study.sampling.count or 0
    while left:
        yield from generator.random((min(left, DRAWN), len(study.axes)))
        left -= min(left, DRAWN)


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
    with heard_after():  # its first numbers are read in C, which swallows what is raised in it
        return np.asarray(qmc.Sobol(axes, rng=generator).random_base2(power)[:count])


def _exchanged(first: Floats, second: Floats, column: int) -> Floats:
    block = first.copy()
    block[:, column] = second[:, column]
    return block
