"""One axis of a study: a list of values, equal steps, a range, or a distribution."""

from __future__ import annotations

import math
import sys
from statistics import NormalDist
from typing import Literal

from pydantic import Field

from gearwright.errors import DesignError, Problem
from gearwright.spec.record import Record

Value = float | int | str | bool
MOST_VALUES = 1_000_000
"""Values of one axis of equal steps [-]."""


class Axis(Record):
    """The values that one entry takes: a list, equal steps, a range, or a distribution."""

    values: list[Value] | None = Field(None, min_length=1, description="The values themselves")
    first: int | float | None = Field(None, alias="from", description="First value of equal steps, or of a range")
    last: int | float | None = Field(None, alias="to", description="Last value of equal steps, or of a range")
    step: int | float | None = Field(None, gt=0, description="Step between values; left out: a range for samples")
    distribution: Literal["uniform", "log-uniform", "triangular", "normal"] = Field(
        "uniform", description="How samples are spread: over the range, or normally about the mean"
    )
    likeliest: float | None = Field(None, description="Likeliest value of a triangular distribution")
    mean: float | None = Field(None, description="Mean of a normal distribution")
    deviation: float | None = Field(None, gt=0, description="Standard deviation of a normal distribution")


def axis_values(path: str, axis: Axis) -> list[Value]:
    """Return the values of an axis.

    Args:
        path: Of the entry, for messages.
        axis: As written.

    Raises:
        DesignError: If neither a list nor first, last and step are given, or they do not go together.
    """
    return [_value(axis, k) for k in range(axis_length(path, axis))]


def _value(axis: Axis, k: int) -> Value:
    """Return the k-th value of a list or of equal steps."""
    return axis.values[k] if axis.values is not None else (axis.first or 0) + (axis.step or 0) * k


def axis_length(path: str, axis: Axis) -> int:
    """Return the number of values of an axis.

    Args:
        path: Of the entry, for messages.
        axis: As written.

    Raises:
        DesignError: As `axis_values`.
    """
    if axis.values is not None:
        return len(axis.values)
    if axis.first is None or axis.last is None or axis.step is None:
        message = 'give a list of values, or all of from, to and step; a range needs [sampling] method = "sobol"'
        raise DesignError([Problem(f"axes.{path}", message)])
    steps = (axis.last - axis.first) / axis.step
    if steps == 0:
        message = f"from {axis.first:g} to {axis.last:g} there is no length; a single value belongs under [changes]"
        raise DesignError([Problem(f"axes.{path}", message)])
    if steps < 0 or not math.isfinite(steps):
        message = f"there is nothing from {axis.first:g} up to {axis.last:g}; exchange them"
        raise DesignError([Problem(f"axes.{path}", message)])
    if steps >= MOST_VALUES:
        message = f"{math.floor(steps) + 1:,} values; at most {MOST_VALUES:,} are taken: make the step larger"
        raise DesignError([Problem(f"axes.{path}.step", message)])
    return math.floor(steps + 1e-9) + 1


def axis_problems(path: str, axis: Axis, *, sampled: bool) -> list[Problem]:
    """Return what is wrong with an axis.

    Args:
        path: Of the entry, for messages.
        axis: As written.
        sampled: True if places of the unit interval are drawn, False if every value is taken.
    """
    if axis.values is not None and (axis.first, axis.last, axis.step, axis.mean) != (None, None, None, None):
        return [Problem(f"axes.{path}", "values and a range are given; keep one of them")]
    try:
        if sampled:
            value_at(path, axis, 0.5)
        else:
            axis_length(path, axis)
    except DesignError as error:
        return list(error.problems)
    return []


def value_at(path: str, axis: Axis, place: float) -> Value:
    """Return the value of an axis at a place of the unit interval, by its inverse distribution.

    Args:
        path: Of the entry, for messages.
        axis: As written; of a list or of equal steps every value is as likely.
        place: From 0 to 1 [-].

    Raises:
        DesignError: If what the distribution needs is not given.

    >>> value_at("a", Axis.model_validate({"from": 10, "to": 20}), 0.25)
    12.5
    """
    if axis.distribution == "normal":
        if axis.mean is None or axis.deviation is None:
            raise DesignError([Problem(f"axes.{path}", "a normal distribution needs mean and deviation")])
        inside = min(max(place, sys.float_info.min), 1.0 - 2.0**-53)
        return NormalDist(axis.mean, axis.deviation).inv_cdf(inside)
    if axis.values is not None or axis.step is not None:
        length = axis_length(path, axis)
        return _value(axis, min(int(place * length), length - 1))
    return _in_range(path, axis, place)


def _in_range(path: str, axis: Axis, place: float) -> float:
    if axis.first is None or axis.last is None:
        raise DesignError([Problem(f"axes.{path}", "give a list of values, from and to, or a normal distribution")])
    low, high = float(axis.first), float(axis.last)
    if low >= high:
        message = f"there is nothing between {low:g} and {high:g}; from must be below to (a single value: [changes])"
        raise DesignError([Problem(f"axes.{path}", message)])
    if axis.distribution == "log-uniform":
        if low <= 0.0:
            raise DesignError([Problem(f"axes.{path}.from", f"{low:g} has no logarithm; give a value above 0")])
        return low * math.exp(place * math.log(high / low))
    if axis.distribution == "triangular":
        peak = (low + high) / 2.0 if axis.likeliest is None else axis.likeliest
        if not low <= peak <= high:
            raise DesignError([Problem(f"axes.{path}.likeliest", f"{peak:g} is not between {low:g} and {high:g}")])
        left = (peak - low) / (high - low)
        if place < left:
            return low + math.sqrt(place * (high - low) * (peak - low))
        return high - math.sqrt((1.0 - place) * (high - low) * (high - peak))
    return low + (high - low) * place
