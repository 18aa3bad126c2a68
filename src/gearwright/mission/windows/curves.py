"""Curves of a window: values, steps, blends."""

from __future__ import annotations

import numpy as np

from gearwright.mission.windows.background import Curve
from gearwright.spec import WindowRules

LAGS = 8.0
"""Time constants after which what decays is gone: 3e-4 is left [-]."""
LAG_POINTS = 80
"""Points of a decay: straight lines between them are off by 1e-3 of it."""


def value_at(curve: Curve, time: float) -> float:
    """Return a curve's value; it is held before its first and after its last point.

    Args:
        curve: (time [s], value).
        time: [s].
    """
    times, values = zip(*curve, strict=True)
    return float(np.interp(time, times, values))


def stepped(curve: Curve, rules: WindowRules, change: float) -> Curve:
    """Return a curve that is higher by a change after the event.

    Args:
        curve: (time [s], value).
        rules: When, and how long it takes.
        change: In the curve's unit.
    """
    return blended(curve, [(time, value + change) for time, value in curve], rules)


def blended(before: Curve, after: Curve, rules: WindowRules) -> Curve:
    """Return one curve that becomes another while the event lasts.

    Args:
        before: (time [s], value).
        after: The same.
        rules: When, and how long it takes.
    """
    start, end = rules.event_at, rules.event_at + rules.over
    times = sorted({start, end, *(time for curve in (before, after) for time, _ in curve)})
    share = np.clip((np.array(times) - start) / rules.over, 0.0, 1.0)
    return [
        (time, (1.0 - part) * value_at(before, time) + part * value_at(after, time))
        for time, part in zip(times, share.tolist(), strict=True)
    ]


def until(curve: Curve, rules: WindowRules) -> Curve:
    """Return what a curve does before the event.

    Args:
        curve: (time [s], value).
        rules: When the event is.
    """
    first = [(time, value) for time, value in curve if time < rules.event_at]
    return [*first, (rules.event_at - 1e-9, value_at(curve, rules.event_at))]


def lagged(before: Curve, after: float, rules: WindowRules) -> Curve:
    """Return a curve that goes to a value with the event's time constant.

    Args:
        before: (time [s], value).
        after: Value in the end.
        rules: When, and by which lag.
    """
    lag = rules.lag or 1.0
    late = np.linspace(0.0, LAGS * lag, LAG_POINTS + 1)
    old = value_at(before, rules.event_at)
    values = after + (old - after) * np.exp(-late / lag)
    values[-1] = after
    return [*until(before, rules), *zip((rules.event_at + late).tolist(), values.tolist(), strict=True)]
