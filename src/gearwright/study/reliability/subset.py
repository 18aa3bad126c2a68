"""Subset simulation: a small probability as the product of larger ones, each had from chains of the one before.

Source: Au, Beck 2001, Prob. Eng. Mech. 16, 263-277 (levels, coefficient of variation); chains by conditional sampling
in standard normal space: Papaioannou, Betz, Zwirglmaier, Straub 2015, Prob. Eng. Mech. 41, 89-103.
"""

from __future__ import annotations

import math
from collections.abc import Generator, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats
from gearwright.ranking import smallest
from gearwright.study.reliability.estimate import Estimate, Point, interval_of

PART = 0.1
"""Part of the samples of a level that the next one starts from [-] (Au and Beck 2001)."""
ACCEPTED = 0.44
"""Part of the moves that shall be accepted [-] (Papaioannou et al. 2015)."""
NEVER = 1e-13
"""Probability below which a limit is taken as never broken [-]."""
SMALL = 0.1
"""Part of the probability below which limits may be of which no more than a bound is known [-]."""
FIRST_SCALE = 0.6
"""Of the moves, in standard deviations of the seeds [-]."""


class Level(NamedTuple):
    """Samples of one level."""

    places: Floats
    """Shape (samples, axes) [-]; of chains, those of each stand together."""
    left: Floats
    """What is left of every limit, shape (samples, limits) [-]."""
    chains: int
    """Chains that they are of; of independent ones as many as there are samples [-]."""


class Own(NamedTuple):
    """What simulations of one limit find."""

    point: Point
    """Its likeliest failure and probability; not settled, an upper bound, where the evaluations did not suffice."""
    variation: float
    """Coefficient of variation of its probability [-]."""
    alone: float
    """Mean of one over the limits that a failure breaks [-]."""
    used: int
    """Evaluations [-]."""


def subset(
    axes: int, limits: int, size: int, count: int, generator: np.random.Generator
) -> Generator[Floats, Floats, Estimate]:
    """Yield points of standard normal space; send what is left of every limit there, and get the estimate.

    Every limit has its share of the evaluations: one that is soon near, yet never broken, would lead simulations of
    all together away from the failures of another. A failure that breaks several counts for each of them in part
    (Karp, Luby 1983). Simulations follow one another until their share is used up, and those that came down to the
    failures are averaged; what does not suffice for a level is drawn plainly.

    Args:
        axes: Coordinates [-].
        limits: Limits that may be broken [-].
        size: Samples of a level [-].
        count: Evaluations, of all limits [-].
        generator: Of random numbers.
    """
    found, left = list[Own](), count
    for limit in range(limits):
        share = left // (limits - limit)
        runs, spent = list[Own](), 0
        while share - spent >= size:
            runs.append((yield from _run(axes, limit, size, share - spent, generator)))
            spent += runs[-1].used
        if share > spent:
            yield generator.standard_normal((share - spent, axes))
        found.append(_averaged([run for run in runs if run.point.settled] or runs[:1]))
        left -= share
    return _together(found)


def _averaged(runs: Sequence[Own]) -> Own:
    parts = [run.point.probability for run in runs]
    probability = math.fsum(parts) / len(parts)
    nearest = smallest((run.point for run in runs), lambda point: float(point.place @ point.place))
    scatter = math.hypot(*(part * run.variation for part, run in zip(parts, runs, strict=True)))
    variation = scatter / math.fsum(parts) if probability else 0.0
    alone = math.fsum(part * run.alone for part, run in zip(parts, runs, strict=True))
    return Own(
        nearest._replace(probability=probability), variation, alone / math.fsum(parts) if probability else 1.0,
        sum(run.used for run in runs),
    )  # fmt: skip


def _together(found: Sequence[Own]) -> Estimate:
    """Return the probability that any limit breaks, from those of each and how often several break at once."""
    points = tuple(own.point for own in found)
    known = [own for own in found if own.point.settled]
    parts = [own.point.probability * own.alone for own in known]
    probability = math.fsum(parts)
    bounds = math.fsum(own.point.probability for own in found if not own.point.settled)
    if bounds > SMALL * probability:
        return Estimate(probability + bounds, (0.0, min(1.0, probability + bounds)), points, settled=False)
    scatter = math.hypot(*(part * own.variation for part, own in zip(parts, known, strict=True)))
    low, high = interval_of(probability, scatter / probability if probability else 0.0)
    return Estimate(probability, (low, min(1.0, high + bounds)), points, settled=True)


def _run(
    axes: int, limit: int, size: int, count: int, generator: np.random.Generator
) -> Generator[Floats, Floats, Own]:
    """Go from all that may come down to the failures of one limit."""
    places = generator.standard_normal((size, axes))
    level, used = Level(places, (yield places), size), size
    probability, variance, scale = 1.0, 0.0, FIRST_SCALE
    seeds = round(PART * size)
    while probability > NEVER:
        own = level.left[:, limit]
        order = np.argsort(own, kind="stable")
        threshold = float(own[order[seeds - 1]])
        if threshold <= 0.0 or used + size - seeds > count:
            return _ended(level, limit, probability, variance, used)
        inside = own <= threshold
        probability *= float(inside.mean())
        variance += _variation(inside, level.chains) ** 2
        starts = generator.permutation(order[:seeds])
        level, accepted = yield from _chains(level, limit, starts, threshold, scale, generator)
        scale *= math.exp(accepted - ACCEPTED)
        used += size - seeds
    return Own(Point(np.full(axes, np.inf), 0.0, settled=True), 0.0, 1.0, used)


def _ended(level: Level, limit: int, probability: float, variance: float, used: int) -> Own:
    """Count the failures of the last level; too few of them are an upper bound."""
    inside = level.left[:, limit] <= 0.0
    if inside.mean() < PART:
        most = probability * (3.0 / len(inside) + float(inside.mean()))
        return Own(Point(np.full(level.places.shape[1], np.inf), most, settled=False), 0.0, 1.0, used)
    probability *= float(inside.mean())
    variation = math.sqrt(variance + _variation(inside, level.chains) ** 2)
    failing = level.places[inside]
    nearest = failing[np.argmin(np.sum(failing**2, axis=1))]
    alone = float(np.mean(1.0 / (level.left[inside] <= 0.0).sum(axis=1)))
    return Own(Point(nearest, probability, settled=True), variation, alone, used)


def _chains(
    level: Level, limit: int, starts: np.ndarray, threshold: float, scale: float, generator: np.random.Generator
) -> Generator[Floats, Floats, tuple[Level, float]]:
    """Walk from every start inside the level, all side by side; return the samples and the part of moves accepted."""
    places, left = level.places[starts], level.left[starts]
    spread = np.minimum(1.0, scale * places.std(axis=0, ddof=1)) if len(starts) > 1 else np.full(places.shape[1], scale)
    kept = np.sqrt(1.0 - spread**2)
    walked, seen, moved = [places], [left], 0.0
    steps = len(level.places) // len(starts)
    for _ in range(steps - 1):
        tried = kept * places + spread * generator.standard_normal(places.shape)
        values = yield tried
        inside: Bools = values[:, limit] <= threshold
        places, left = np.where(inside[:, None], tried, places), np.where(inside[:, None], values, left)
        walked.append(places)
        seen.append(left)
        moved += float(inside.mean()) / (steps - 1)
    axes, limits = places.shape[1], left.shape[1]
    together = np.stack(walked, axis=1).reshape(-1, axes), np.stack(seen, axis=1).reshape(-1, limits)
    return Level(*together, len(starts)), moved


def _variation(inside: Bools, chains: int) -> float:
    """Return the coefficient of variation of the part of samples inside [-] (Au and Beck 2001, equations 25 to 29)."""
    count, part = len(inside), float(inside.mean())
    steps = count // chains
    off = inside.reshape(chains, steps) - part
    correlated = 0.0
    for lag in range(1, steps):
        covariance = float(np.mean(off[:, :-lag] * off[:, lag:]))
        correlated += 2.0 * (1.0 - lag / steps) * covariance / (part * (1.0 - part) or 1.0)
    return math.sqrt((1.0 - part) / (part * count) * max(1.0 + correlated, 1.0))
