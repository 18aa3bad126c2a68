"""Generations: the best designs so far as parents, and children of them by NSGA-II over continuous and listed freedoms.

Source: Deb, Pratap, Agarwal, Meyarivan 2002, IEEE Trans. Evol. Comput. 6 (2), 182-197.
"""

from __future__ import annotations

import numpy as np

from gearwright.arrays import Bools, Floats
from gearwright.optimum.judging import Judged
from gearwright.study.answers import crowding
from gearwright.study.running import children

ALIKE = 1e-12
"""Places of the unit cube that are nearer are one [-]."""


class Parents:
    """The best designs that are known, a population of them."""

    def __init__(self, size: int, freedoms: int, objectives: int, constraints: int) -> None:
        self.size = size
        self.places = np.zeros((0, freedoms))
        self.judged = Judged(np.zeros((0, objectives)), np.zeros((0, constraints)))

    def add(self, places: Floats, own: Judged) -> None:
        """Take in designs, and keep the best.

        Args:
            places: In the unit cube, shape (designs, freedoms).
            own: What is known of them.
        """
        places, judged = np.vstack([self.places, places]), self.judged.joined(own)
        _, first = np.unique(np.round(places / ALIKE).astype(np.int64), axis=0, return_index=True)
        first.sort()
        places, judged = places[first], judged.take(first)
        rank = judged.ranks
        best = np.lexsort((-crowding(judged.values, rank), rank))[: self.size]
        self.places, self.judged = places[best], judged.take(best)

    @property
    def front(self) -> Bools:
        """Which of them keep every constraint and no other one dominates."""
        return np.asarray(self.judged.good & (self.judged.ranks == 0))

    def children(self, count: int, generator: np.random.Generator) -> Floats:
        """Return so many children: tournaments, crossover, mutation.

        Args:
            count: How many [-].
            generator: Of random numbers.
        """
        rank = self.judged.ranks
        crowd = crowding(self.judged.values, rank)
        made: list[Floats] = []
        while len(made) * len(self.places) < count:
            made.append(children(self.places.copy(), rank, crowd, generator))
        return np.vstack(made)[:count]
