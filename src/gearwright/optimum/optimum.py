"""Result of an optimisation: Pareto front, active constraints, regret and hypervolume."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gearwright.base import DesignError, Floats, Problem, Ratio, Shown
from gearwright.spec import Study, Value
from gearwright.study.tables import Row, non_dominated

# ----------------------------------------------------------------------------------------------------------------------
# The answer of a search: its front, what binds every design of it, what limits cost, and how sure the choice is.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Binding:
    """What keeps a design from being better."""

    kind: str
    """check, constraint, or end of a range."""
    name: str
    """Of the check, result or path."""
    margin: Ratio
    """Value over limit [-]; 1 is just enough."""


@dataclass(frozen=True)
class Best:
    """A design of the front."""

    row: Row
    """Its design, freedoms and results; polished ones with their teeth, too."""
    binds: tuple[Binding, ...]
    """The nearest first."""
    teeth: Mapping[str, tuple[int, ...]]
    """Stage -> teeth of its gears."""
    polished: bool
    """Whether its sizes were polished with its teeth kept."""

    @property
    def inputs(self) -> Mapping[str, Value]:
        """Dotted path -> value, in the unit of the path."""
        return self.row.inputs


@dataclass(frozen=True)
class Price:
    """What a limit costs."""

    limit: str
    """Path, result or end of a range."""
    kind: str
    """rule, constraint, or end of a range."""
    changes: Mapping[str, float]
    """Objective -> its change for each per cent by which the limit is relaxed, all others polished along [SI]."""


@dataclass(frozen=True)
class Regret:
    """How the designs of the front do where nobody knows what comes."""

    place: int
    """Of the design in the front."""
    best: Ratio
    """Part of the samples in which it is the best of the front [-]."""
    mean: Ratio
    """Of how much it is worse than the best, over the span of the front [-]."""
    late: Ratio
    """The same, which 95 % of the samples keep [-]."""
    keeps: Ratio
    """Part of the samples in which it keeps every constraint as it was built, teeth, modules and widths kept [-]."""
    spread: Mapping[str, tuple[float, float]]
    """Objective -> values that 5 and 95 % of the samples stay below, sized anew for each [SI]."""


@dataclass(frozen=True)
class Influence:
    """What an assumption does to the chosen design and to the choice."""

    path: str
    low: float
    """16 % of all that may come, in the unit of the path."""
    high: float
    """84 %."""
    changes: Mapping[str, float]
    """Objective of the chosen design -> its change from low to high [SI]."""
    chosen: tuple[int, int]
    """Design of the front that would be chosen at either."""


@dataclass(frozen=True)
class Counts:
    """What the search looked at."""

    screened: int
    """Designs of the first layer [-]."""
    bred: int
    """Designs of generations [-]."""
    polished: int
    """Designs of the polish [-]."""
    generations: int


@dataclass(frozen=True)
class Fit:
    """How well a surrogate foretells a result that it is not told."""

    result: str
    """Objective or constraint."""
    error: Ratio
    """Root mean square of what is foretold wrong of each design by all others, over the deviation of the values [-];
    1 is no better than their mean."""
    designs: int
    """That it knows [-]."""


@dataclass(frozen=True)
class Gap:
    """How far the best of an objective may lie beyond what independent starts found."""

    objective: str
    best: float
    """Of all starts [SI]."""
    beyond: float
    """By how much the best there is may be expected to be better [SI]."""


def expected_gap(found: Sequence[float]) -> float:
    """Return by how much the best there is may be expected to lie beyond the best of some starts; 0 of one start.

    Each start misses the best by x_i − x* ~ Exp(θ), so that the least of r misses it by θ/r, and the mean of all lies
    θ (r − 1)/r above the least: θ/r = (x̄ − x_1)/(r − 1).

    Args:
        found: Best value of each start, made small.

    Source: estimator without bias of a two-parameter exponential distribution, of its least and its mean.

    >>> expected_gap([10.0, 11.0, 12.0])
    0.5
    """
    return (sum(found) / len(found) - min(found)) / (len(found) - 1) if len(found) > 1 else 0.0


@dataclass(frozen=True, repr=False)
class Optimum(Shown):
    """The best designs that a search found."""

    study: Study
    front: tuple[Best, ...]
    """The best of the first objective first."""
    chosen: int
    """Place of the design nearest to having the best of every objective at once, over the span of the front."""
    counts: Counts
    growth: tuple[float, ...]
    """Hypervolume of the front after every generation, over the box between its first ideal and its first nadir [-]."""
    still: bool
    """Whether the hypervolume stood still; False where the evaluations ran out."""
    prices: tuple[Price, ...] = ()
    regrets: tuple[Regret, ...] = ()
    influences: tuple[Influence, ...] = ()
    fits: tuple[Fit, ...] = ()
    """Of the surrogates that chose the designs; empty where none did."""
    starts: int = 1
    """Independent searches, each with random numbers of its own [-]."""
    gaps: tuple[Gap, ...] = ()
    """Of every objective; empty with one start, which tells nothing of it."""

    @property
    def best(self) -> Best:
        """The chosen design.

        Raises:
            DesignError: If the front is empty.
        """
        if not self.front:
            raise DesignError([Problem("constraints", "no design keeps all of them; relax one")], self.study.name)
        return self.front[self.chosen]

    @property
    def objectives(self) -> tuple[str, ...]:
        """What was wanted."""
        return tuple(self.study.objectives)


# ----------------------------------------------------------------------------------------------------------------------
# Hypervolume: the room that a front dominates, up to a point that everything good is better than.
# ----------------------------------------------------------------------------------------------------------------------


EXACT = 3
"""Objectives up to which it is exact [-]."""
POINTS = 16384
"""Points of the unit cube by which it is estimated for more [-]."""


def hypervolume(values: Floats, reference: Floats) -> float:
    """Return the volume that points dominate below a reference: exact for up to three objectives, else by points.

    Args:
        values: Objectives to be made small, shape (points, objectives).
        reference: Largest value of each that counts, shape (objectives,).

    Returns:
        In the product of their units; for more than three objectives within a per cent or so of the whole box.

    Source: Fonseca, Paquete, López-Ibáñez 2006, IEEE CEC, 1157-1163: sweep along the last objective.

    >>> hypervolume(np.array([[1.0, 2.0], [2.0, 1.0]]), np.array([3.0, 3.0]))
    3.0
    """
    inside = values[(values < reference).all(axis=1)]
    if not len(inside):
        return 0.0
    front = np.unique(inside[non_dominated(inside, np.zeros(len(inside)))], axis=0)
    return _estimated(front, reference) if front.shape[1] > EXACT else _swept(front, reference)


def _swept(front: Floats, reference: Floats) -> float:
    """Return the volume slice by slice along the last objective."""
    if front.shape[1] == 1:
        return float(reference[0] - front[:, 0].min())
    if front.shape[1] == 2:
        lowest = np.minimum.accumulate(front[:, 1])  # sorted along the first
        return float((np.append(front[1:, 0], reference[0]) - front[:, 0]) @ (reference[1] - lowest))
    order = np.argsort(front[:, -1], kind="stable")
    heights = np.append(front[order, -1], reference[-1])
    total = 0.0
    for k in range(len(order)):
        if heights[k + 1] > heights[k]:
            total += (heights[k + 1] - heights[k]) * _swept(
                np.unique(front[order[: k + 1], :-1], axis=0), reference[:-1]
            )
    return float(total)


def _estimated(front: Floats, reference: Floats) -> float:
    """Return the part of points of the box between the best of each objective and the reference, times its volume."""
    best = front.min(axis=0)
    points = best + (reference - best) * np.random.default_rng(0).random((POINTS, front.shape[1]))
    dominated = np.zeros(len(points), dtype=bool)
    for own in front:
        dominated |= (points >= own).all(axis=1)
    return float(dominated.mean() * np.prod(reference - best))
