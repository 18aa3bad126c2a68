"""An engine by a deck: power and fuel over altitude, Mach number and lever, as makers and engine programs print it."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Sequence
from typing import NamedTuple


class DeckLine(NamedTuple):
    """What an engine does at one altitude and Mach number, corrected to the standard sea level."""

    power: tuple[float, ...]
    """P/(δ_t √θ_t), rising [W]."""
    fuel: tuple[float, ...]
    """m_f/(δ_t √θ_t) [kg/s]."""


class EngineDeck(NamedTuple):
    """Power and fuel of an engine over a grid of altitudes and Mach numbers, on a standard day."""

    altitude: tuple[float, ...]
    """Rising [m]."""
    mach: tuple[float, ...]
    """Rising [-]."""
    lines: tuple[tuple[DeckLine, ...], ...]
    """Altitude, Mach -> line."""

    @property
    def reference(self) -> tuple[float, float]:
        """Highest power at the lowest altitude and Mach number, corrected [W], and its fuel [kg/s]."""
        line = self.lines[0][0]
        return line.power[-1], line.fuel[-1]

    def scaled(self, factor: float) -> EngineDeck:
        """Return the deck of an engine that is alike and larger or smaller.

        Args:
            factor: Of power and fuel [-].
        """
        lines = tuple(
            tuple(DeckLine(tuple(factor * p for p in one.power), tuple(factor * f for f in one.fuel)) for one in row)
            for row in self.lines
        )
        return self._replace(lines=lines)


class Day(NamedTuple):
    """Where a deck is read, and the air there."""

    altitude: float
    """Pressure altitude [m]."""
    mach: float
    """[-]"""
    theta: float
    """Stagnation temperature over that of the standard sea level θ_t [-]."""
    delta: float
    """Stagnation pressure, likewise δ_t [-]."""
    warmer: float
    """θ_t over that of a standard day [-]."""


def deck_limit(deck: EngineDeck, day: Day, lapse: float) -> float:
    """Return the power that an engine has at most [W].

    Args:
        deck: Of the engine.
        day: Where.
        lapse: What the day leaves of the power on a standard day, at one pressure [-].

    Source: corrected power between the four nodes around, times δ_t √θ_t of a standard day and the day's lapse.

    Raises:
        ValueError: Altitude or Mach number are outside the deck.
    """
    top = sum(weight * line.power[-1] for weight, line in _around(deck, day))
    return float(top * day.delta * math.sqrt(day.theta / day.warmer) * lapse)


def deck_fuel(deck: EngineDeck, day: Day, power: float) -> float:
    """Return the fuel that an engine burns [kg/s].

    Args:
        deck: Of the engine.
        day: Where.
        power: At its shaft [W].

    Source: at the same part of each node's highest corrected power, linear between the lever's positions, and on by
        the first two of them below; times δ_t √θ_t.

    Raises:
        ValueError: Altitude or Mach number are outside the deck.
    """
    around, factor = _around(deck, day), day.delta * math.sqrt(day.theta)
    part = power / factor / sum(weight * line.power[-1] for weight, line in around)
    return factor * sum(weight * max(_fuel(line, part * line.power[-1]), 0.0) for weight, line in around)


def _fuel(line: DeckLine, power: float) -> float:
    """Return corrected fuel at a corrected power [kg/s], on straight lines through the nodes."""
    k = min(max(bisect_right(line.power, power), 1), len(line.power) - 1)
    slope = (line.fuel[k] - line.fuel[k - 1]) / (line.power[k] - line.power[k - 1])
    return line.fuel[k - 1] + slope * (power - line.power[k - 1])


def _around(deck: EngineDeck, day: Day) -> list[tuple[float, DeckLine]]:
    """Return weights and lines of the nodes around a place."""
    rows, columns = _between(deck.altitude, day.altitude, "m"), _between(deck.mach, day.mach, "Mach")
    return [(a * b, deck.lines[i][j]) for a, i in rows for b, j in columns if a * b]


def _between(axis: Sequence[float], at: float, unit: str) -> list[tuple[float, int]]:
    low, high = axis[0], axis[-1]
    slack = 1e-9 * (high - low)
    if not low - slack <= at <= high + slack:
        raise ValueError(f"the deck holds {low:g} to {high:g} {unit}, and {at:.4g} {unit} is flown")
    if len(axis) == 1:
        return [(1.0, 0)]
    k = min(max(bisect_right(axis, at), 1), len(axis) - 1)
    part = min(max((at - axis[k - 1]) / (axis[k] - axis[k - 1]), 0.0), 1.0)
    return [(1.0 - part, k - 1), (part, k)]
