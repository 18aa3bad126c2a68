"""One axis of a panel: its limits, from what is drawn or as they are given, its marks and its name."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from gearwright.arrays import Floats
from gearwright.render.vector.palette import INK

NOWHERE = (np.inf, -np.inf)


@dataclass
class Axis:
    """One axis of a panel."""

    log: bool = False
    low: float | None = None
    high: float | None = None
    margin: float = 0.05
    """Free room at each end over the range [-]."""
    values: list[float] | None = None
    """Marks that are asked for."""
    names: list[str] | None = None
    label: str = ""
    label_colour: str = INK
    size: float = 8.0
    """Of the numbers [pt]."""
    grid: bool = True
    ticks: bool = True
    numbers: bool = True
    most: int = 0
    """Steps, at most; 0: as there is room."""
    mates: list[Axis] = field(default_factory=list)
    """Axes with the same limits."""
    extent: tuple[float, float] = NOWHERE
    least: float = np.inf
    """Least positive value."""
    zero: bool = False
    """Bars start at zero."""
    inverted: bool = False

    def reach(self, values: Floats) -> None:
        """Count values as shown."""
        numbers = np.asarray(values, dtype=float).ravel()
        numbers = numbers[np.isfinite(numbers)]
        if len(numbers):
            self.extent = (min(self.extent[0], float(numbers.min())), max(self.extent[1], float(numbers.max())))
            positive = numbers[numbers > 0.0]
            self.least = min(self.least, float(positive.min()) if len(positive) else np.inf)

    def limits(self) -> tuple[float, float]:
        """Return where the axis starts and ends; the first is larger where it is inverted."""
        axes = self.mates or [self]
        low, high = min(axis.extent[0] for axis in axes), max(axis.extent[1] for axis in axes)
        given_low = next((axis.low for axis in axes if axis.low is not None), None)
        given_high = next((axis.high for axis in axes if axis.high is not None), None)
        log, zero, inverted = (any(getattr(axis, name) for axis in axes) for name in ("log", "zero", "inverted"))
        if log:
            low = min(axis.least for axis in axes)
        if low > high:
            low, high = (1.0, 10.0) if log else (0.0, 1.0)
        low, high = _widened(low, high, min(axis.margin for axis in axes), log=log, zero=zero)
        low, high = (low if given_low is None else given_low), (high if given_high is None else given_high)
        if low == high:
            high = low + (abs(low) or 1.0)
        return (high, low) if inverted else (low, high)


def _widened(low: float, high: float, margin: float, *, log: bool, zero: bool) -> tuple[float, float]:
    if log:
        factor = (high / low) ** margin if high > low else 2.0
        return low / factor, high * factor
    room = margin * (high - low) if high > low else 0.05 * (abs(high) or 1.0)
    return (0.0 if zero and low == 0.0 else low - room), (0.0 if zero and high == 0.0 else high + room)
