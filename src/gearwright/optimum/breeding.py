"""Generations: the best designs so far as parents, and children of them by NSGA-II over continuous and listed freedoms.

Two things are not as in NSGA-II: half a population are parents, which leaves more generations for as many designs, and
no child repeats a design that was looked at.

Source: Deb, Pratap, Agarwal, Meyarivan 2002, IEEE Trans. Evol. Comput. 6 (2), 182-197.
"""

from __future__ import annotations

import numpy as np

from gearwright.arrays import Floats
from gearwright.optimum.freedoms import freedoms_of
from gearwright.optimum.judging import Judged
from gearwright.optimum.optimum import Fit
from gearwright.spec import Study
from gearwright.study.answers import crowding
from gearwright.study.running import children

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
