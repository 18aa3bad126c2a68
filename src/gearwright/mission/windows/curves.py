"""Curves of a window: values, steps, blends."""

from __future__ import annotations

import numpy as np

from gearwright.mission.windows.background import Curve
from gearwright.spec import WindowRules


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
