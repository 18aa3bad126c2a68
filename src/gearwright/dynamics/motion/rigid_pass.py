"""Rigid pass: how a driven train's speed goes when nothing twists, so that mesh phases follow it.

Tones run with the speed profile, and a governed speed is not known before. The rigid motion takes part in the same
right-hand side (line forces do no work on it), a thousand times slower than the teeth; what it finds becomes the
profile of the elastic run, which then measures only what the rigid motion leaves out.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.equations import split_rigid
from gearwright.dynamics.model import Arrays, System, profile_of
from gearwright.dynamics.motion.rigid_march import rigid_speeds

STEP = 1e-3
"""Step of the rigid pass [s]: actuators of propellers are slower by far."""
POINTS = 1000
"""Most points of the profile."""


def followed(system: System, duration: float) -> System:
    """Return a system whose speed profile follows the rigid motion that its drives and loads give it.

    Args:
        system: With one rigid motion at most; with more (a clutch that slips) it keeps its profile.
        duration: [s].
    """
    rigid = split_rigid(system.arrays)[0]
    if rigid.shape[1] != 1 or not np.any(system.arrays.speed):
        return system
    time, factor = rigid_factor(system.arrays, rigid, duration)
    return with_profile(system, list(zip(time.tolist(), factor.tolist(), strict=True)))


def with_profile(system: System, points: Sequence[tuple[float, float]]) -> System:
    """Return a system with another speed profile.

    Args:
        system: Bodies, lines, loads, drives.
        points: (time [s], speed factor [-]).
    """
    return replace(system, arrays=system.arrays._replace(profile=profile_of(points)))


def rigid_factor(arrays: Arrays, rigid: Floats, duration: float) -> tuple[Floats, Floats]:
    """Return time [s] and speed over reference speed [-] of the one rigid motion, shape (points,).

    Args:
        arrays: The system's numbers, with a constant speed factor at which it starts.
        rigid: Its rigid motion, of unit mass, shape (coordinates, 1).
        duration: [s].

    Source: classical fourth-order Runge–Kutta of Rᵀ M R ν̇ = Rᵀ Q with θ̇ = Ω s + R ν.
    """
    steps = max(1, round(duration / STEP))
    motion = rigid_speeds(arrays, rigid[:, 0].copy(), duration / steps, steps)
    fastest = int(np.argmax(np.abs(arrays.speed)))
    factor = arrays.profile.factor[0] + rigid[fastest, 0] * motion / arrays.speed[fastest]
    stride = max(1, -(-steps // POINTS))
    time = np.linspace(0.0, duration, steps + 1)
    return time[::stride], factor[::stride]
