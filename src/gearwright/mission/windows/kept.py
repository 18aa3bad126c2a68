"""What is kept of a window's motion."""

from __future__ import annotations

import math

import numpy as np

from gearwright.dynamics import Outputs, System
from gearwright.spec import WindowRules

BINS = 400
"""Time bins of a window's statistics."""
CLOSE_CYCLES = 4.0
"""Cycles of the slowest mesh at the end of a window of which every step is kept [-]."""
START = 0.05
"""Time from which on statistics look [s]: teeth that change their stiffness at once shake a train that was at rest."""


def window_outputs(system: System, rules: WindowRules) -> Outputs:
    """Return what is kept of a window: its time bins, and every step of its last cycles.

    Bins begin when what changing stiffness shook at the start has died, at half the time of the event at the latest.

    Args:
        system: With its speed profile.
        rules: Of the window.
    """
    turning = np.abs(system.arrays.tone_rate[system.arrays.tone_rate != 0.0])
    last = 0 if rules.event == "sudden-stop" else -1  # a train at rest has no cycles
    slowest = float(np.min(turning)) * float(system.arrays.profile.factor[last]) if len(turning) else 0.0
    close = min(2.0 * math.pi * CLOSE_CYCLES / slowest, rules.duration) if slowest else min(0.02, rules.duration)
    until = rules.duration if rules.event == "none" else rules.event_at
    start = min(START, 0.5 * until) if len(turning) else 0.0
    return Outputs(bins=BINS, start=start, windows=((rules.duration - close, rules.duration),))
