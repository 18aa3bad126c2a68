"""Which design wins over all objectives, by how much, and how sure that is.

Designs are compared at equal inputs: one such comparison is a scenario. In each, every objective gives every design a
rank; the mean rank over the objectives orders them. Ranks need no common unit, so that kilograms, hours and parts of
a per cent can stand side by side. How sure a winner is has two parts: in how many scenarios it comes first, and for how
many weights of the objectives it does (stochastic multicriteria acceptability).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gearwright.arrays import Floats, Ints
from gearwright.spec import Study
from gearwright.study.answers.pareto import FAILED, non_dominated, violations, wanted
from gearwright.study.answers.table import Row, Table

WEIGHTS = 2000
"""Weights of the objectives that are drawn: a share of them is then within 0.02 [-]."""
NORMAL_95 = 1.959963984540054
"""Two-sided 95 % point of the normal distribution [-]."""
CONFIDENCE = 0.95
"""Of intervals and bounds [-]."""


@dataclass(frozen=True)
class Standing:
    """Where one design stands."""

    design: str
    place: float
    """Mean rank over objectives and scenarios, 1 is best [-]."""
    first: int
    """Scenarios in which its mean rank is the best [-]."""
    weights: float
    """Part of all weights of the objectives, over all scenarios, with which it comes first [-]."""
    non_dominated: float
    """Part of the scenarios in which it is on the Pareto front [-]."""


@dataclass(frozen=True)
class Verdict:
    """How designs compare at equal inputs."""

    standings: tuple[Standing, ...]
    """The winner first."""
    scenarios: int
    """Comparisons at equal inputs [-]."""
    without: dict[str, str]
    """Objective -> who would win if it did not count; only those without which another design does."""

    @property
    def sureness(self) -> tuple[float, float]:
        """95 % confidence interval of the part of scenarios in which the winner is first [-]."""
        return confidence(self.standings[0].first, self.scenarios)


def verdict(study: Study, table: Table) -> Verdict | None:
    """Return how the designs of a study compare, or None where there is nothing to compare at equal inputs.

    Args:
        study: With objectives.
        table: Its rows; a design that fails or breaks a constraint in a scenario has the last place there.

    Source: mean rank: Borda 1781; weights drawn evenly from the simplex: Lahdelma and Salminen 2001, SMAA-2, Oper.
        Res. 49 (3), 444-454, on places instead of values.
    """
    searched = study.sampling.method == "nsga2"  # whose cases have equal inputs by chance alone
    groups = scenarios(table) if len(study.designs) > 1 and study.objectives and not searched else []
    if not groups:
        return None
    designs = [row.design for row in groups[0]]
    values = np.stack([_allowed(study, rows) for rows in groups])
    places = np.stack([_places(value) for value in values])
    means = places.mean(axis=2)
    on_front = np.mean([non_dominated(value, np.zeros(len(designs))) for value in values], axis=0)
    standings = [
        Standing(name, float(place), int(won), float(share), float(free))
        for name, place, won, share, free in zip(
            designs, means.mean(axis=0), _firsts(means), _acceptability(study, places), on_front, strict=True
        )
    ]
    standings.sort(key=lambda standing: (standing.place, -standing.first))
    return Verdict(tuple(standings), len(groups), _without(study, places, designs, standings[0].design))


def scenarios(table: Table) -> list[list[Row]]:
    """Return the rows of equal inputs together, of those inputs at which every design is and one at least succeeds.

    Args:
        table: Of a study.
    """
    groups: dict[tuple[object, ...], dict[str, Row]] = {}
    for row in table.rows:
        groups.setdefault(tuple(row.inputs.values()), {})[row.design] = row
    designs = list(dict.fromkeys(row.design for row in table.rows))
    complete = [group for group in groups.values() if len(group) == len(designs)]
    rows = [[group[name] for name in designs] for group in complete]
    return [scenario for scenario in rows if not all(row.problem for row in scenario)]


def _allowed(study: Study, rows: Sequence[Row]) -> Floats:
    broken = violations(study, rows) > 0.0
    values: Floats = np.where(broken[:, None], FAILED, wanted(study, rows))
    return values


def _places(values: Floats) -> Floats:
    """Return the place of every row in every column, 1 the smallest; equal ones share the mean of their places."""
    less = (values[:, None, :] > values[None, :, :]).sum(axis=1, dtype=float)
    same = (values[:, None, :] == values[None, :, :]).sum(axis=1, dtype=float)
    places: Floats = less + (same + 1.0) / 2.0
    return places


def _firsts(means: Floats) -> Ints:
    """Return in how many scenarios each design has the best mean rank; a tie goes to none of its designs."""
    best = means == means.min(axis=1, keepdims=True)
    alone: Ints = (best & (best.sum(axis=1, keepdims=True) == 1)).sum(axis=0)
    return alone


def _acceptability(study: Study, places: Floats) -> Floats:
    """Return the part of weights and scenarios with which each design is first."""
    generator = np.random.default_rng(study.sampling.seed)
    weights = generator.dirichlet(np.ones(places.shape[2]), WEIGHTS)
    shares = np.zeros(places.shape[1])
    for place in places:  # one scenario at a time: all of them together would need gigabytes
        shares += np.bincount(np.argmin(place @ weights.T, axis=0), minlength=len(shares))
    shares /= shares.sum()
    return shares


def _without(study: Study, places: Floats, designs: Sequence[str], winner: str) -> dict[str, str]:
    if len(study.objectives) < 2:
        return {}
    winners = {}
    for k, name in enumerate(study.objectives):
        rest = np.delete(places, k, axis=2).mean(axis=(0, 2))
        best = designs[int(np.argmin(rest))]
        if best != winner:
            winners[name] = best
    return winners


def confidence(hits: int, count: int) -> tuple[float, float]:
    """Return the 95 % confidence interval of a probability [-].

    Args:
        hits: How often it came true.
        count: Of how many independent trials, at least 1.

    Source: Wilson 1927, J. Am. Stat. Assoc. 22, 209-212.

    >>> [round(each, 3) for each in confidence(8, 10)]
    [0.49, 0.943]
    """
    square = NORMAL_95**2
    middle = (hits + square / 2.0) / (count + square)
    half = NORMAL_95 / (count + square) * math.sqrt(hits * (count - hits) / count + square / 4.0)
    return max(0.0, middle - half), min(1.0, middle + half)


def bound(values: Sequence[float], part: float = 0.95) -> float | None:
    """Return the value below which at least a part of all that may come lies, with 95 % confidence, or None.

    Args:
        values: Independent samples; None is returned where there are too few for any bound (59 for a part of 0.95).
        part: Of all cases that shall lie below [-].

    Source: distribution-free tolerance limit, Wilks 1941, Ann. Math. Stat. 12, 91-96.

    >>> bound([float(k) for k in range(58)]), bound([float(k) for k in range(59)])
    (None, 58.0)
    """
    from scipy.stats import binom  # half a second to load

    count = len(values)
    order = int(binom.ppf(CONFIDENCE, count, part)) + 1
    return sorted(values)[order - 1] if order <= count else None


def kept(study: Study, table: Table) -> dict[str, int]:
    """Return in how many cases each constraint is kept; a failed case keeps none.

    Args:
        study: With constraints.
        table: Its rows.
    """
    return {
        name: sum(
            (limit.minimum is None or row.shown(name) >= limit.minimum)
            and (limit.maximum is None or row.shown(name) <= limit.maximum)
            for row in table.good
        )
        for name, limit in study.constraints.items()
    }
