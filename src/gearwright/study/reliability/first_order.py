"""The first-order reliability method: the nearest failure of every limit, found along its gradient.

A limit that is the least of several, such as a worst margin, has kinks, at which a gradient leads astray: a second
search starts from the nearest failure among some points that are scattered widely, and the nearer end counts.

Source: Hasofer, Lind 1974, J. Eng. Mech. Div. 100 (1), 111-121; Rackwitz, Fiessler 1978, Comput. Struct. 9, 489-494;
steps shortened by the merit function of Zhang, Der Kiureghian 1995 (improved HL-RF).
"""

from __future__ import annotations

import math
from collections.abc import Generator
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.ranking import smallest
from gearwright.spec.studies import MOST_STEPS, SCATTERED, TRIED_STEPS
from gearwright.study.reliability.estimate import Point, chance_beyond

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
