"""Rigid pass: how a driven train's speed goes when nothing twists, so that mesh phases follow it.

Tones run with the speed profile, and a governed speed is not known before. The rigid motion takes part in the same
right-hand side (line forces do no work on it), a thousand times slower than the teeth; what it finds becomes the
profile of the elastic run, which then measures only what the rigid motion leaves out.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.code_cache import compiled
from gearwright.dynamics.codegen import drive_width, topology
from gearwright.dynamics.equations import WORKS, kernel, split_rigid
from gearwright.dynamics.model import Arrays, System, profile_of

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
    motion = np.zeros(steps + 1)
    work = _Work(*(np.zeros(length) for length in _lengths(arrays)))
    _march(arrays, kernel.empty_instant(arrays), rigid[:, 0].copy(), duration / steps, work, motion)
    fastest = int(np.argmax(np.abs(arrays.speed)))
    factor = arrays.profile.factor[0] + rigid[fastest, 0] * motion / arrays.speed[fastest]
    stride = max(1, -(-steps // POINTS))
    time = np.linspace(0.0, duration, steps + 1)
    return time[::stride], factor[::stride]


class _Work(NamedTuple):
    """Arrays that every slope fills anew."""

    state: Floats
    """(q, q̇, works, x), shape (states,)."""
    change: Floats
    """Its rate, shape (states,)."""
    output: Floats
    """Line forces and deflections, and what the drives report."""
    rate: Floats
    """Rate of (ν, x)."""


def _lengths(arrays: Arrays) -> tuple[int, int, int, int]:
    drives = len(arrays.drives.start)
    length = 2 * len(arrays.mass) + WORKS + drives
    return length, length, 2 * len(arrays.stiffness) + drive_width(topology(arrays)), 1 + drives


@compiled
def _slope(arrays: Arrays, now: kernel.Instant, rigid: Floats, state: Floats, work: _Work) -> None:
    """Fill the rate of (ν, x)."""
    size = len(rigid)
    first = 2 * size + WORKS
    for i in range(size):
        work.state[size + i] = rigid[i] * state[0]
    work.state[first:] = state[1:]
    kernel.derivative(arrays, now, work.state, work.change, work.output)
    rate = 0.0
    for i in range(size):
        rate += rigid[i] * arrays.mass[i] * work.change[size + i]
    work.rate[0], work.rate[1:] = rate, work.change[first:]


@compiled
def _march(arrays: Arrays, now: kernel.Instant, rigid: Floats, h: float, work: _Work, motion: Floats) -> None:
    """Fill ν after each step."""
    states = len(arrays.drives.start)
    state, total = np.zeros(1 + states), np.zeros(1 + states)
    state[1:] = arrays.drives.start
    for step in range(len(motion) - 1):
        motion[step] = state[0]
        begin, total[:] = state.copy(), 0.0
        for stage in range(4):
            kernel.set_instant(arrays, (step + (0.0, 0.5, 0.5, 1.0)[stage]) * h, now)
            _slope(arrays, now, rigid, state, work)
            total += (1.0, 2.0, 2.0, 1.0)[stage] * work.rate
            state[:] = begin + (0.5, 0.5, 1.0, 0.0)[stage] * h * work.rate
        state[:] = begin + h / 6.0 * total
    motion[-1] = state[0]
