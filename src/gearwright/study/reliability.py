"""Failure probability by first-order reliability, importance sampling and subset simulation.

Only numbers: which case a point is, and which limit a column, is for `running`.
"""

import math
from collections.abc import Generator, Iterator, Mapping, Sequence
from dataclasses import dataclass
from statistics import NormalDist
from typing import NamedTuple

import numpy as np

from gearwright.base import Bools, DesignError, Floats, Problem, Shown, largest_first, smallest
from gearwright.spec import Study, value_at
from gearwright.spec.studies import MOST_STEPS, SCATTERED, TRIED_STEPS, Value
from gearwright.study.answers import confidence
from gearwright.study.cases import Case, unit_sample
from gearwright.study.tables import Limit, Row, Table, left_of, limits_of

# ----------------------------------------------------------------------------------------------------------------------
# What a method finds: the probability of failure, how sure it is, and the likeliest failure of every limit.
# ----------------------------------------------------------------------------------------------------------------------


NORMAL_95 = 1.959963984540054
"""Two-sided 95 % point of the normal distribution [-]."""


class Point(NamedTuple):
    """The likeliest failure of one limit: the point nearest to the origin of standard normal space where it breaks."""

    place: Floats
    """Standard normal coordinates, shape (axes,) [-]; not finite where no failure is known."""
    probability: float
    """That this limit breaks [-]: to first order, or as counted."""
    settled: bool
    """False if a search for it did not come to rest."""


class Estimate(NamedTuple):
    """The probability that any limit breaks."""

    probability: float
    """Of failure [-]."""
    interval: tuple[float, float]
    """Between which it lies with 95 % confidence [-]."""
    points: tuple[Point, ...]
    """Of every limit."""
    settled: bool
    """False if the evaluations did not suffice, so that the probability is below what is said."""


def index_of(probability: float) -> float:
    """Return the reliability index β = −Φ⁻¹(p) [-].

    Args:
        probability: Of failure, from 0 to 1 [-]; 0 gives infinity.

    Source: Hasofer, Lind 1974, J. Eng. Mech. Div. 100 (1), 111-121.

    >>> round(index_of(1e-6), 3)
    4.753
    """
    if not 0.0 < probability < 1.0:
        return math.inf if probability <= 0.0 else -math.inf
    return -NormalDist().inv_cdf(probability)


def chance_beyond(index: float) -> float:
    """Return Φ(−β), the probability beyond a plane at a distance from the origin [-].

    Args:
        index: The distance β [-].

    >>> round(chance_beyond(4.753424) * 1e6, 4)
    1.0
    """
    return 0.5 * math.erfc(index / math.sqrt(2.0))


def interval_of(probability: float, variation: float) -> tuple[float, float]:
    """Return the 95 % interval of an estimate whose logarithm is taken as normal [-].

    Args:
        probability: Estimated [-].
        variation: Its coefficient of variation [-].
    """
    half = NORMAL_95 * math.sqrt(math.log1p(variation**2))
    return probability * math.exp(-half), min(1.0, probability * math.exp(half))


# ----------------------------------------------------------------------------------------------------------------------
# What samples of equal weight say of the limits: how often each breaks, and the likeliest failure among them.
# ----------------------------------------------------------------------------------------------------------------------


def from_samples(places: Floats, left: Floats, probability: float) -> tuple[Point, ...]:
    """Return the likeliest failure of every limit among samples, the nearest to the origin.

    Args:
        places: Standard normal coordinates, shape (samples, axes) [-].
        left: What is left of every limit, shape (samples, limits): at 0 and below it is broken [-].
        probability: That any limit breaks [-].
    """
    broken = left <= 0.0
    failures = max(int(broken.any(axis=1).sum()), 1)
    points = []
    for own in broken.T:
        failing = np.flatnonzero(own)
        if not len(failing):
            points.append(Point(np.full(places.shape[1], np.inf), 0.0, settled=True))
            continue
        nearest = failing[np.argmin(np.sum(places[failing] ** 2, axis=1))]
        points.append(Point(places[nearest], probability * len(failing) / failures, settled=True))
    return tuple(points)


# ----------------------------------------------------------------------------------------------------------------------
# The first-order reliability method: the nearest failure of every limit, found along its gradient.
#
# A limit that is the least of several, such as a worst margin, has kinks, at which a gradient leads astray: a second
# search starts from the nearest failure among some points that are scattered widely, and the nearer end counts.
#
# Source: Hasofer, Lind 1974, J. Eng. Mech. Div. 100 (1), 111-121; Rackwitz, Fiessler 1978, Comput. Struct. 9, 489-494;
# steps shortened by the merit function of Zhang, Der Kiureghian 1995 (improved HL-RF).
# ----------------------------------------------------------------------------------------------------------------------


DIFFERENCE = 0.01
"""Half the distance of two points of a central difference, in standard deviations [-]."""
WIDELY = 3.0
"""Standard deviation of the scattered points [-]."""
FARTHEST = 8.0
"""Distance from the origin beyond which failures are not looked for [-]: one in 1e15."""
SHORTER = 0.5 ** np.arange(TRIED_STEPS)
"""Parts of a full step, of which the longest one that improves is taken [-]."""
DECREASE = 1e-4
"""Part of the decrease that a straight line promises which a step has to bring [-] (Armijo)."""
ON_LIMIT, ALONG_GRADIENT = 1e-4, 1e-3
"""A search rests where the limit is left by this part of its value at the start, and the point off its gradient [-]."""


class Slope(NamedTuple):
    """A limit at a point."""

    place: Floats
    """Standard normal coordinates, shape (axes,) [-]."""
    value: float
    """What is left of the limit: below 0 it is broken [-]."""
    gradient: Floats
    """By the coordinates, shape (axes,) [-]."""


def first_order(axes: int, generator: np.random.Generator) -> Generator[Floats, Floats, tuple[Point, ...]]:
    """Yield points of standard normal space; send what is left of every limit there, and get their nearest failures.

    Points have the shape (points, axes), what is sent back (points, limits): below 0 a limit is broken.

    Args:
        axes: Coordinates [-].
        generator: Of random numbers.
    """
    origin = np.zeros(axes)
    scattered = WIDELY * generator.standard_normal((SCATTERED, axes))
    values = yield np.vstack([origin, _around(origin), scattered])
    near, far = np.split(values, [1 + 2 * axes])
    points = []
    for limit in range(values.shape[1]):
        start = Slope(origin, float(near[0, limit]), _difference(near[1:, limit]))
        first = yield from _search(start, limit, abs(start.value))
        other = yield from _from_afar(scattered, far[:, limit], limit, abs(start.value))
        points.append(_nearer(first, other))
    return tuple(points)


def _from_afar(places: Floats, values: Floats, limit: int, scale: float) -> Generator[Floats, Floats, Point]:
    """Search from the nearest failure among points, or from the point that is the nearest to failing."""
    known = np.isfinite(values)
    distance = np.where(known & (values <= 0.0), np.linalg.norm(places, axis=1), np.inf)
    chosen = int(np.argmin(distance if np.isfinite(distance).any() else np.where(known, values, np.inf)))
    around = (yield _around(places[chosen]))[:, limit]
    return (yield from _search(Slope(places[chosen], float(values[chosen]), _difference(around)), limit, scale))


def _nearer(first: Point, second: Point) -> Point:
    """Return the search that came to rest, and of two that did the nearer one."""
    if first.settled and second.settled:
        return smallest([first, second], lambda point: float(point.place @ point.place))
    return second if second.settled else first


def _search(start: Slope, limit: int, scale: float) -> Generator[Floats, Floats, Point]:
    """Go to the nearest failure of one limit."""
    at = start
    for _ in range(MOST_STEPS):
        steepness = float(np.linalg.norm(at.gradient))
        if not math.isfinite(steepness) or not math.isfinite(at.value):
            return _point(at, settled=False)
        if steepness == 0.0:
            return Point(np.full(len(at.place), np.inf), float(start.value < 0.0), settled=at is start)
        if _rests(at, scale, steepness):
            return _point(at, settled=True)
        target = (at.gradient @ at.place - at.value) / steepness**2 * at.gradient
        reach = float(np.linalg.norm(target))
        if at.value > 0.0 and min(reach, float(np.linalg.norm(at.place))) >= FARTHEST:
            return _never(at.place)
        step = min(1.0, 1.1 * FARTHEST / (reach or 1.0)) * target - at.place
        tried = at.place + SHORTER[:, None] * step
        values = (yield tried)[:, limit]
        chosen = _longest(at, step, steepness, tried, values)
        around = (yield _around(tried[chosen]))[:, limit]
        at = Slope(tried[chosen], float(values[chosen]), _difference(around))
    last = _point(at, settled=False)
    return _never(at.place) if last.probability < chance_beyond(FARTHEST) else last


def _rests(at: Slope, scale: float, steepness: float) -> bool:
    normal = at.gradient / steepness
    across = np.linalg.norm(at.place - (normal @ at.place) * normal)
    return bool(abs(at.value) <= ON_LIMIT * scale and across <= ALONG_GRADIENT * (1.0 + np.linalg.norm(at.place)))


def _longest(at: Slope, step: Floats, steepness: float, tried: Floats, values: Floats) -> int:
    """Return which part of the step is the longest that brings what a straight line promises, else the shortest."""
    distance = float(np.linalg.norm(at.place))
    penalty = 2.0 * distance / steepness + 10.0 / steepness
    if at.value:
        penalty = max(penalty, 0.5 * float(np.sum((at.place + step) ** 2)) / abs(at.value))
    merit = 0.5 * distance**2 + penalty * abs(at.value)
    promised = float(at.place @ step) - penalty * abs(at.value)
    merits = 0.5 * np.sum(tried**2, axis=1) + penalty * np.abs(values)
    good = np.flatnonzero(merits <= merit + DECREASE * SHORTER * promised)
    return int(good[0]) if len(good) else len(SHORTER) - 1


def _point(at: Slope, *, settled: bool) -> Point:
    """Return the point, and the probability beyond the plane through it that touches the limit."""
    steepness = float(np.linalg.norm(at.gradient))
    if not 0.0 < steepness < math.inf:
        return Point(np.full(len(at.place), np.inf), math.nan, settled=False)
    index = (at.value - float(at.gradient @ at.place)) / steepness
    return Point(at.place, chance_beyond(index), settled)


def _never(place: Floats) -> Point:
    return Point(np.full(len(place), np.inf), 0.0, settled=True)


def _around(place: Floats) -> Floats:
    steps = DIFFERENCE * np.eye(len(place))
    return np.vstack([place + steps, place - steps])


def _difference(values: Floats) -> Floats:
    above, below = np.split(values, 2)
    with np.errstate(invalid="ignore"):
        gradient: Floats = (above - below) / (2.0 * DIFFERENCE)
    return gradient


# ----------------------------------------------------------------------------------------------------------------------
# Importance sampling about the likeliest failures: what the first order leaves out is counted.
# ----------------------------------------------------------------------------------------------------------------------


PLAIN = 0.1
"""Part of the draws that are about the origin: failures that no search found are not missed for sure [-]."""
LEAST_WEIGHT = 0.05
"""Least part of the other draws that each likeliest failure has, before they are made to add up to one [-]."""


def importance(
    points: Sequence[Point], axes: int, count: int, generator: np.random.Generator
) -> Generator[Floats, Floats, Estimate]:
    """Yield draws about the likeliest failures; send what is left of every limit there, and get the estimate.

    Args:
        points: The likeliest failure of every limit, as `first_order` gives them.
        axes: Coordinates [-].
        count: Draws [-].
        generator: Of random numbers.

    Source: Schuëller, Stix 1987, Struct. Saf. 4, 293-309; a mixture of normal densities, one about each point:
        Melchers 1989, Struct. Saf. 6, 3-10.
    """
    centres, weights = _mixture(points, axes)
    which = generator.choice(len(weights), size=count, p=weights)
    drawn = centres[which] + generator.standard_normal((count, axes))
    broken: Bools = (yield drawn) <= 0.0
    ratio = _ratio(drawn, centres, weights)
    parts = ratio * broken.any(axis=1)
    probability = float(parts.mean())
    settled = all(point.settled for point in points)
    if not probability:
        return Estimate(0.0, (0.0, float(3.0 * ratio.max() / count)), tuple(points), settled=False)
    variation = float(parts.std(ddof=1)) / probability / np.sqrt(count)
    return Estimate(probability, interval_of(probability, float(variation)), tuple(points), settled)


def _mixture(points: Sequence[Point], axes: int) -> tuple[Floats, Floats]:
    known = [point for point in points if np.isfinite(point.place).all() and point.probability < 0.5]
    if not known:
        return np.zeros((1, axes)), np.ones(1)
    likely = np.array([point.probability for point in known])
    shares = np.maximum(likely / max(likely.sum(), np.finfo(float).tiny), LEAST_WEIGHT)
    weights = np.concatenate([[PLAIN], (1.0 - PLAIN) * shares / shares.sum()])
    return np.vstack([np.zeros(axes), *(point.place for point in known)]), weights


def _ratio(drawn: Floats, centres: Floats, weights: Floats) -> Floats:
    """Return the density of what may come over that of the draws [-]."""
    towards = drawn @ centres.T - 0.5 * np.sum(centres**2, axis=1)
    ratio: Floats = 1.0 / (np.exp(towards) @ weights)
    return ratio


# ----------------------------------------------------------------------------------------------------------------------
# Subset simulation: a small probability as the product of larger ones, each had from chains of the one before.
#
# Source: Au, Beck 2001, Prob. Eng. Mech. 16, 263-277 (levels, coefficient of variation); chains by conditional sampling
# in standard normal space: Papaioannou, Betz, Zwirglmaier, Straub 2015, Prob. Eng. Mech. 41, 89-103.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# How likely it is that a design breaks a constraint of its study: which cases that takes, and what they say.
# ----------------------------------------------------------------------------------------------------------------------


COUNTED = ("random", "sobol", "latin-hypercube")
"""Methods whose cases are simply counted."""


@dataclass(frozen=True)
class LimitState:
    """One limit that may be broken."""

    limit: Limit
    """Which one."""
    probability: float
    """That it is broken: to first order for the method ``form``, else as counted [-]."""
    likeliest: Mapping[str, Value]
    """Axis -> value in the likeliest failure that was found; empty where none was."""
    influence: Mapping[str, float]
    """Axis -> direction cosine of that failure [-]: their squares add up to 1; above 0 a larger value does harm."""
    settled: bool
    """False if the search for it did not come to rest."""

    @property
    def index(self) -> float:
        """Reliability index β [-]."""
        return index_of(self.probability)


@dataclass(frozen=True, repr=False)
class Reliability(Shown):
    """How likely it is that one design breaks any constraint of its study."""

    design: str
    """Its name."""
    probability: float
    """Of failure [-]."""
    interval: tuple[float, float]
    """Between which it lies with 95 % confidence [-]."""
    limits: tuple[LimitState, ...]
    """Every limit, the likeliest to be broken first."""
    evaluations: int
    """Cases that it took [-]."""
    failed: int
    """Cases that could not be built, counted as broken [-]."""
    settled: bool
    """False if the cases did not suffice, or a search did not come to rest: do not trust the probability then."""

    @property
    def index(self) -> float:
        """Reliability index β = −Φ⁻¹(p) [-]."""
        return index_of(self.probability)


def reliability(study: Study, table: Table) -> tuple[Reliability, ...]:
    """Return how likely it is that each design of a study breaks a constraint.

    Args:
        study: With axes that have distributions, and constraints; its method ``form``, ``subset``, or one that draws.
        table: Its rows, all of them.

    Raises:
        DesignError: If the study has no constraint, or its cases are no samples.
    """
    method = study.sampling.method
    if not study.constraints or method not in (*COUNTED, "form", "subset"):
        message = f'{method!r} gives no probability; take "form" or "subset", and give [constraints]'
        raise DesignError([Problem("sampling.method", message)])
    if method in COUNTED:
        return tuple(_counted(study, name, [row for row in table.rows if row.design == name]) for name in study.designs)
    search, rows = failures(study), list(table.rows)
    batch = next(search)
    while True:
        try:
            batch = search.send([rows.pop(0) for _ in batch])
        except StopIteration as end:
            found: tuple[Reliability, ...] = end.value
            return found


def failures(study: Study) -> Generator[list[Case], list[Row], tuple[Reliability, ...]]:
    """Yield one batch of cases after the other; send the rows of each to get the next, and in the end what they say.

    The cases follow from the seed and the rows alone, so that a study that was interrupted finds its way again.

    Args:
        study: With constraints, and the method ``form`` or ``subset``.
    """
    number, found = 0, list[Reliability]()
    for design in study.designs:
        generator = np.random.default_rng(study.sampling.seed)
        if study.sampling.method == "form":
            search = _first_order_then_draws(study, generator)
        else:
            limits, sampling = len(limits_of(study)), study.sampling
            search = subset(len(study.axes), limits, sampling.population, sampling.count or 0, generator)
        places, rows = next(search), list[Row]()
        while True:
            answers = yield [_case(study, design, number + k, place) for k, place in enumerate(places)]
            number += len(places)
            rows += answers
            try:
                places = search.send(_left(study, answers))
            except StopIteration as end:
                found.append(_said(study, design, end.value, rows))
                break
    return tuple(found)


def _first_order_then_draws(study: Study, generator: np.random.Generator) -> Generator[Floats, Floats, Estimate]:
    """Search the likeliest failures; draw about them with the evaluations that are left."""
    axes, count, used = len(study.axes), study.sampling.count or 0, 0
    search = first_order(axes, generator)
    places = next(search)
    while True:
        used += len(places)
        answers = yield places
        try:
            places = search.send(answers)
        except StopIteration as end:
            points: tuple[Point, ...] = end.value
            break
    if count <= used:
        return _bounded(points)
    return (yield from importance(points, axes, count - used, generator))


def _bounded(points: Sequence[Point]) -> Estimate:
    """Return what is known without draws: the likeliest limit alone, and all of them as if they never broke together.

    Source: Cornell 1967, bounds of a series system.
    """
    likely = [point.probability for point in points]
    most = float(1.0 - np.prod([1.0 - part for part in likely]))
    return Estimate(max(likely), (max(likely), most), tuple(points), all(point.settled for point in points))


def _case(study: Study, design: str, number: int, place: Floats) -> Case:
    return Case(number, design, _inputs(study, place))


def _inputs(study: Study, place: Floats) -> dict[str, Value]:
    """Return the values of all axes at a point of standard normal space."""
    return {
        path: value_at(path, axis, chance_beyond(-float(own)))
        for (path, axis), own in zip(study.axes.items(), place, strict=True)
    }


def _left(study: Study, rows: Sequence[Row]) -> Floats:
    """Return what is left of every limit; what no number is, is broken."""
    left = left_of(study, rows)
    kept: Floats = np.where(np.isnan(left), -np.inf, left)
    return kept


def _counted(study: Study, design: str, rows: Sequence[Row]) -> Reliability:
    left = _left(study, rows)
    broken = int((left <= 0.0).any(axis=1).sum())
    probability = broken / len(rows)
    from scipy.special import ndtri  # a third of a second to load, for workers who never ask

    places = ndtri(np.clip(unit_sample(study)[: len(rows)], np.finfo(float).tiny, 1.0 - 2.0**-53))
    points = from_samples(places, left, probability)
    return _said(study, design, Estimate(probability, confidence(broken, len(rows)), points, settled=True), rows)


def _said(study: Study, design: str, found: Estimate, rows: Sequence[Row]) -> Reliability:
    states = largest_first(_states(study, found.points), lambda state: state.probability)
    failed = sum(bool(row.problem) for row in rows)
    return Reliability(
        design, found.probability, found.interval, tuple(states), len(rows), failed, found.settled
    )  # fmt: skip


def _states(study: Study, points: Sequence[Point]) -> Iterator[LimitState]:
    for limit, point in zip(limits_of(study), points, strict=True):
        if not np.isfinite(point.place).all():
            yield LimitState(limit, point.probability, {}, {}, point.settled)
            continue
        distance = float(np.linalg.norm(point.place))
        cosines = point.place / distance if distance else point.place
        influence = dict(zip(study.axes, cosines.tolist(), strict=True))
        yield LimitState(limit, point.probability, _inputs(study, point.place), influence, point.settled)
