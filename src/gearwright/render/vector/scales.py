"""Scales of axes: from values to paper, and the round numbers that stand beside an axis."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats

PLAIN = (1e-3, 1e4)
"""Powers of ten between these are written out."""
ENOUGH = 6
"""Steps that are asked for at most where fewer leave less than three numbers."""
_STEPS = (1.0, 2.0, 5.0, 10.0)


class Scale(NamedTuple):
    """A straight or logarithmic way from values to places on paper."""

    low: float
    """Value at the start."""
    high: float
    start: float
    """Place of the lowest value [mm]."""
    end: float
    log: bool = False

    def places(self, values: Floats) -> Floats:
        """Return where values stand [mm]."""
        numbers = np.asarray(values, dtype=float)
        if not self.log:
            return self.start + (numbers - self.low) * ((self.end - self.start) / (self.high - self.low))
        low, high = math.log10(self.low), math.log10(self.high)
        with np.errstate(divide="ignore", invalid="ignore"):
            part = (np.log10(numbers) - low) / (high - low)
        # What is not positive lies far below the paper, so that a curve leaves it downwards.
        part = np.where(numbers > 0.0, part, np.where(np.isnan(numbers), np.nan, -9.0))
        return self.start + part * (self.end - self.start)

    def place(self, value: float) -> float:
        """Return where one value stands [mm]."""
        return float(self.places(np.array([value]))[0])


class Ticks(NamedTuple):
    """Marks of an axis."""

    values: list[float]
    names: list[str]
    minor: list[float]
    """Values of marks without a name."""


def nice_step(span: float, most: int) -> float:
    """Return the smallest of 1, 2, 5 times a power of ten that divides a span into no more than so many parts.

    Args:
        span: Positive.
        most: Parts.

    Source: P. S. Heckbert, Nice Numbers for Graph Labels, Graphics Gems, Academic Press 1990.

    >>> nice_step(7.3, 5)
    2.0
    """
    raw = span / max(most, 1)
    power = 10.0 ** math.floor(math.log10(raw))
    return next(step for step in _STEPS if step * power >= raw * (1.0 - 1e-9)) * power


def linear_ticks(low: float, high: float, most: int = 7) -> Ticks:
    """Return round numbers from low to high, at most so many steps apart.

    Args:
        low: Of the axis.
        high: Above it.
        most: Steps.

    >>> linear_ticks(0.0, 1.0, 5).names
    ['0.0', '0.2', '0.4', '0.6', '0.8', '1.0']
    """
    step = nice_step(high - low, most)
    first, last = math.ceil(low / step - 1e-6), math.floor(high / step + 1e-6)
    if last - first < 2 and most < ENOUGH:
        return linear_ticks(low, high, most + 1)
    digits = max(0, -math.floor(math.log10(step) + 1e-9))
    values = [step * k for k in range(first, last + 1)]
    return Ticks(values, [_number(value, digits, step) for value in values], [])


def _number(value: float, digits: int, step: float) -> str:
    largest = max(abs(value), step)
    if step >= 1e7 or (largest < 1e-4 and digits > 4):
        return f"{value:.4g}".replace("-", "−")
    return f"{value:.{digits}f}".replace("-", "−")


def log_ticks(low: float, high: float, most: int = 8) -> Ticks:
    """Return powers of ten from low to high; where they are few, 2 and 5 times them as well.

    Args:
        low: Of the axis, above zero.
        high: Above it.
        most: Named marks.

    >>> log_ticks(0.5, 200.0).names
    ['1', '10', '100']
    """
    first, last = math.ceil(math.log10(low) - 1e-9), math.floor(math.log10(high) + 1e-9)
    stride = max(1, -(-(last - first + 1) // most))
    powers = list(range(first, last + 1, stride))
    between = [factor * 10.0**power for power in range(first - 1, last + 1) for factor in range(2, 10)]
    minor = [value for value in between if low <= value <= high] if stride == 1 and last - first <= 5 else []
    if len(powers) >= 3 or math.log10(high / low) > 2.0:
        return Ticks([10.0**power for power in powers], [_power(power, powers) for power in powers], minor)
    values = [factor * 10.0**power for power in range(first - 1, last + 1) for factor in (1.0, 2.0, 5.0)]
    values = [value for value in values if low * (1.0 - 1e-9) <= value <= high * (1.0 + 1e-9)]
    if len(values) < 2:
        return linear_ticks(low, high, min(most, 5))
    return Ticks(values, [f"{value:.6g}" for value in values], minor)


def _power(power: int, every: Sequence[int]) -> str:
    if PLAIN[0] <= 10.0 ** every[0] and 10.0 ** every[-1] <= PLAIN[1]:
        return f"{10.0**power:.6g}"
    return f"$10^{{{power}}}$".replace("-", "−")
