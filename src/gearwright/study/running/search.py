"""NSGA-II: the Pareto front of the objectives, found over continuous and discrete choices.

Source: Deb, Pratap, Agarwal, Meyarivan 2002, IEEE Trans. Evol. Comput. 6 (2), 182-197: non-dominated sorting,
constraint-domination and crowding distance; simulated binary crossover and polynomial mutation of Deb and Agrawal 1995.
"""

from __future__ import annotations

from collections.abc import Generator

import numpy as np

from gearwright.arrays import Floats, Ints
from gearwright.spec import Study, case_count, value_at
from gearwright.study.answers import Row, crowding, ranks, violations, wanted
from gearwright.study.cases import Case

CROSSOVER = 0.9
"""Probability that two parents are mixed [-] (Deb et al. 2002, section V)."""
SPREAD_OF_CHILDREN, SPREAD_OF_MUTATION = 15.0, 20.0
"""Distribution indices of crossover and mutation [-]; the paper takes 20 for both, 15 looks a little further."""


def generations(study: Study) -> Generator[list[Case], list[Row], None]:
    """Yield one generation of cases after the other; send the rows of each to get the next.

    The cases follow from the seed and the rows alone, so that a search that was interrupted finds its way again.

    Args:
        study: With objectives, a count of evaluations and a population.
    """
    count, generator = case_count(study), np.random.default_rng(study.sampling.seed)
    size = min(study.sampling.population, count)
    genes = generator.random((size, len(study.axes) + 1))
    parents, values, broken = genes[:0], np.zeros((0, len(study.objectives))), np.zeros(0)
    number = 0
    while number < count:
        genes = genes[: count - number]
        rows = yield [_case(study, number + k, gene) for k, gene in enumerate(genes)]
        number += len(genes)
        parents = np.vstack([parents, genes])
        values = np.vstack([values, wanted(study, rows)])
        broken = np.concatenate([broken, violations(study, rows)])
        rank = ranks(values, broken)
        crowd = crowding(values, rank)
        best = np.lexsort((-crowd, rank))[:size]
        parents, values, broken = parents[best], values[best], broken[best]
        genes = children(parents, rank[best], crowd[best], generator)


def _case(study: Study, number: int, gene: Floats) -> Case:
    """Return the case of a gene: its first entry chooses the design, the others their axes."""
    design = study.designs[min(int(gene[0] * len(study.designs)), len(study.designs) - 1)]
    inputs = {
        path: value_at(path, axis, float(place))
        for (path, axis), place in zip(study.axes.items(), gene[1:], strict=True)
    }
    return Case(number, design, inputs)


def children(parents: Floats, rank: Ints, crowd: Floats, generator: np.random.Generator) -> Floats:
    """Return as many children as parents: tournaments, crossover, mutation.

    Args:
        parents: Genes in the unit cube, shape (parents, genes).
        rank: Front that each belongs to, shape (parents,).
        crowd: Crowding distance of each, shape (parents,).
        generator: Of random numbers.
    """
    size = len(parents)
    pairs = generator.integers(size, size=(size + size % 2, 2))
    first_wins = (rank[pairs[:, 0]] < rank[pairs[:, 1]]) | (
        (rank[pairs[:, 0]] == rank[pairs[:, 1]]) & (crowd[pairs[:, 0]] >= crowd[pairs[:, 1]])
    )
    chosen = parents[np.where(first_wins, pairs[:, 0], pairs[:, 1])]
    for first in range(0, len(chosen), 2):
        if generator.random() < CROSSOVER:
            chosen[first : first + 2] = _crossed(chosen[first], chosen[first + 1], generator)
    return _mutated(chosen[:size], generator)


def _crossed(first: Floats, second: Floats, generator: np.random.Generator) -> Floats:
    """Return two children by simulated binary crossover, each gene mixed with probability one half."""
    draw = generator.random(len(first))
    power = 1.0 / (SPREAD_OF_CHILDREN + 1.0)
    beta = np.where(draw <= 0.5, (2.0 * draw) ** power, (0.5 / (1.0 - draw)) ** power)
    beta = np.where(generator.random(len(first)) < 0.5, beta, 1.0)
    middle, half = (first + second) / 2.0, (second - first) / 2.0
    half = np.where((beta != 1.0) & (generator.random(len(first)) < 0.5), -half, half)  # genes of both parents meet
    return np.clip(np.stack([middle - beta * half, middle + beta * half]), 0.0, 1.0)


def _mutated(genes: Floats, generator: np.random.Generator) -> Floats:
    """Return genes of which one in each child or more is moved by polynomial mutation: no child repeats a parent."""
    draw = generator.random(genes.shape)
    power = 1.0 / (SPREAD_OF_MUTATION + 1.0)
    move = np.where(draw < 0.5, (2.0 * draw) ** power - 1.0, 1.0 - (2.0 * (1.0 - draw)) ** power)
    hit = generator.random(genes.shape) < 1.0 / genes.shape[1]
    hit[np.arange(len(genes)), generator.integers(genes.shape[1], size=len(genes))] = True
    return np.clip(genes + np.where(hit, move, 0.0), 0.0, 1.0)
