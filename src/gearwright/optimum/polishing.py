"""Polish: teeth are kept, and ranges followed downhill by a compass, all designs of a front at once.

Where a front has few designs, the best with other values of lists follow theirs, teeth chosen anew: they may lie in
another valley. Each design goes the way on which all its objectives gain alike (Chebyshev's distance, augmented), so
that it ends where it dominates what it was.
Source: Kolda, Lewis, Torczon 2003, SIAM Review 45 (3), 385-482 (compass search); Miettinen 1999, Nonlinear
Multiobjective Optimization, section 3.4 (augmented Chebyshev).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from gearwright.arrays import Floats
from gearwright.optimum.freedoms import is_continuous, place_of
from gearwright.optimum.judging import Judged
from gearwright.optimum.keeping import Fixed
from gearwright.spec import value_at
from gearwright.spec.studies import Axis, Value
from gearwright.study.answers import Row

FIRST, LAST = 0.05, 1e-3
"""First and last step of the compass, over each range [-]."""
DIRECTIONS = 14
"""Ways that are tried from each design, so that all can be sized together [-]."""
ENOUGH = 1 + 8 * DIRECTIONS
"""Evaluations of a compass: its start, the steps that become small, and as many that go somewhere [-]."""
AUGMENTED = 1e-3
"""Weight of the sum of objectives beside the largest [-]."""


class Compass:
    """One design on its way downhill."""

    def __init__(self, start: Fixed, axes: Mapping[str, Axis], own: Judged, scale: Floats) -> None:
        self.start, self.scale = start, scale
        self.axes = {path: axis for path, axis in axes.items() if is_continuous(axis)}
        self.place = np.array([place_of(path, axis, start.inputs[path]) for path, axis in self.axes.items()])
        self.aim, self.judged = own.values[0], own
        self.row: Row | None = None
        self.step = FIRST if len(self.place) else 0.0

    @property
    def going(self) -> bool:
        """Whether its steps are not small yet."""
        return self.step >= LAST

    def tries(self, generator: np.random.Generator) -> list[Floats]:
        """Return places around it: along every axis both ways, and on ways that are drawn.

        Args:
            generator: Of random numbers.
        """
        ways = [sign * way for way in np.eye(len(self.place)) for sign in (1.0, -1.0)]
        while len(ways) < DIRECTIONS:
            drawn = generator.normal(size=len(self.place))
            ways.append(drawn / max(float(np.linalg.norm(drawn)), 1e-9))
        return [np.clip(self.place + self.step * way, 0.0, 1.0) for way in ways]

    def inputs(self, place: Floats) -> dict[str, Value]:
        """Return what a place means, teeth kept.

        Args:
            place: Of the ranges, from 0 to 1.
        """
        moved = {
            path: value_at(path, axis, float(own)) for (path, axis), own in zip(self.axes.items(), place, strict=True)
        }
        return {**self.start.inputs, **moved}

    def note(self, places: Sequence[Floats], rows: Sequence[Row], own: Judged) -> None:
        """Go to the best of places, or take smaller steps.

        Args:
            places: That were tried.
            rows: What came of each.
            own: What is known of them.
        """
        merit = np.where(own.good, self._merit(own.values), np.inf)
        best = int(np.argmin(merit))
        if merit[best] < self._merit(self.judged.values)[0] - 1e-9:
            self.place, self.judged, self.row = places[best], own.take(np.array([best])), rows[best]
        else:
            self.step /= 3.0

    def _merit(self, values: Floats) -> Floats:
        gain = (values - self.aim) / self.scale
        return np.asarray(gain.max(axis=1) + AUGMENTED * gain.sum(axis=1))


def rounds(compasses: Sequence[Compass], seed: int) -> Iterator[tuple[list[Compass], list[list[Floats]]]]:
    """Yield those that are still on their way, with the places that each tries.

    Args:
        compasses: All of them; whoever takes a round notes what came of it.
        seed: Of the ways that are drawn.
    """
    generator = np.random.default_rng(seed)
    while going := [compass for compass in compasses if compass.going]:
        yield going, [compass.tries(generator) for compass in going]
