"""A straight line through logarithms, the band in which the next gearbox will lie, and the refit of the 61 weights."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import ArrayLike

from gearwright.catalogue import weighed_gearboxes
from gearwright.units import POUND, Mass, Number
from gearwright.weights.method import Range
from gearwright.weights.requirement import Requirement

_BISECTIONS = 60
"""Halvings of a right angle: below its rounding [-]."""


@dataclass(frozen=True)
class LogLine:
    """Least-squares line log10 y = slope log10 x + intercept, with what a prediction from it needs."""

    slope: Number
    """Exponent of x [-]."""
    intercept: Number
    """log10 of y at x = 1."""
    r_squared: Number
    """Share of the variance of log10 y that the line explains [-]."""
    spread: Number
    """Residual standard deviation of log10 y, with n - 2 degrees of freedom."""
    count: int
    """Number of points n."""
    mean: float
    """Mean of log10 x."""
    sum_of_squares: float
    """Sum of squared deviations of log10 x from its mean."""

    def at(self, x: float) -> float:
        """Return y on the line.

        Args:
            x: In the unit of the points.
        """
        return float(10.0 ** (self.slope * math.log10(x) + self.intercept))

    def band(self, x: float, level: float) -> tuple[float, float]:
        """Return the limits between which one new point lies with a given probability.

        Args:
            x: In the unit of the points.
            level: Probability, such as 0.95 [-].

        Source:
            Prediction interval of simple linear regression, Student's t with n - 2 degrees of freedom.
        """
        quantile = student_quantile(self.count - 2, level)
        offset = (math.log10(x) - self.mean) ** 2 / self.sum_of_squares
        width = quantile * self.spread * math.sqrt(1.0 + 1.0 / self.count + offset)
        return self.at(x) * 10.0**-width, self.at(x) * 10.0**width


def student_quantile(freedoms: int, level: float) -> float:
    """Return the t within which Student's distribution lies with a probability, either side of zero [-].

    A library would do, but loads for longer than a design takes to be sized.

    Args:
        freedoms: Degrees of freedom ν, 1 or more [-].
        level: Probability, 0 to 1 [-].

    Source: Abramowitz & Stegun, 26.7.3 and 26.7.4: finite sums in θ = atan(t/√ν), bisected.

    >>> round(student_quantile(10, 0.95), 3)
    2.228
    """
    low, high = 0.0, 0.5 * math.pi
    for _ in range(_BISECTIONS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if _within(freedoms, middle) < level else (low, middle)
    return math.sqrt(freedoms) * math.tan(0.5 * (low + high))


def _within(freedoms: int, angle: float) -> float:
    """Return A(t|ν) for t = √ν tan θ."""
    odd, cosine = freedoms % 2, math.cos(angle)
    term, total = (cosine, 0.0) if odd else (1.0, 0.0)
    for order in range(odd, freedoms - 1, 2):
        total += term
        term *= (order + 1) / (order + 2) * cosine**2
    total *= math.sin(angle)
    return 2.0 / math.pi * (angle + total) if odd else total


@dataclass(frozen=True)
class Band:
    """A mass with the limits in which it lies."""

    level: Number
    """Probability that the next gearbox of this kind lies within [-]."""
    low: Mass
    """[kg]."""
    high: Mass
    """[kg]."""


def log_line(x: ArrayLike, y: ArrayLike) -> LogLine:
    """Return the least-squares line through log10 of the points.

    Args:
        x: Positive, shape (n,).
        y: Positive, shape (n,).
    """
    u, v = np.log10(np.asarray(x, dtype=float)), np.log10(np.asarray(y, dtype=float))
    du, dv = u - u.mean(), v - v.mean()
    square = float(du @ du)
    slope = float(du @ dv) / square
    residual = dv - slope * du
    return LogLine(
        slope=slope,
        intercept=float(v.mean() - slope * u.mean()),
        r_squared=1.0 - float(residual @ residual) / float(dv @ dv),
        spread=math.sqrt(float(residual @ residual) / (u.size - 2)),
        count=u.size,
        mean=float(u.mean()),
        sum_of_squares=square,
    )


@cache
def refit() -> LogLine:
    """Return the power law in β through the 61 real gearbox weights, in lb.

    Source:
        Weights of NASA/TM-2009-215680, fitted here by least squares in log10.
    """
    points = weighed_gearboxes()
    return log_line([point.beta for point in points], [point.mass / POUND for point in points])


def mass_refit(requirement: Requirement) -> float:
    """Return the mass of a gearbox by the refit: the median of its kind [kg].

    Args:
        requirement: Power and speeds.

    Source:
        `refit`.
    """
    return refit().at(requirement.beta) * POUND


def bands(requirement: Requirement, levels: tuple[float, ...] = (0.68, 0.95)) -> tuple[Band, ...]:
    """Return the prediction bands of the refit.

    Args:
        requirement: Power and speeds.
        levels: Probabilities [-].
    """
    limits = ((level, refit().band(requirement.beta, level)) for level in levels)
    return tuple(Band(level, low * POUND, high * POUND) for level, (low, high) in limits)


def refit_range() -> Range:
    """Return the β of the 61 weights."""
    betas = [gearbox.beta for gearbox in weighed_gearboxes()]
    return Range("beta", min(betas), max(betas), "weights of NASA/TM-2009-215680")
