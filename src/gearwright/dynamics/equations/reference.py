"""The right-hand side in plain numpy: the oracle that every compiled one must agree with."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.model import (
    Acting,
    Arrays,
    Profile,
    Schedules,
    Series,
    along_lines,
    drive_effects,
    entry_matrix,
    onto_coordinates,
)


class LineState(NamedTuple):
    """What every line does at one instant; arrays of shape (lines,)."""

    deflection: Floats
    """δ [m or rad]."""
    rate: Floats
    """δ̇ with the slip of dampers [m/s or rad/s]."""
    contact: Floats
    """g(δ): deflection in contact [m or rad]."""
    stiffness: Floats
    """k(φ) [N/m or N m/rad]."""
    stiffness_rate: Floats
    """dk/dt [N/(m s) or N m/(rad s)]."""
    error_rate: Floats
    """ė [m/s or rad/s]."""
    force: Floats
    """f = k g + c δ̇ [N or N m]."""


def speed_factor(profile: Profile, time: float) -> tuple[float, float, float]:
    """Return speed factor s [-], its rate [1/s] and the travel τ = ∫ s dt [s].

    Args:
        profile: Speed factor against time.
        time: [s].
    """
    t, s = profile.time, profile.factor
    i = int(np.searchsorted(t, time, side="right")) - 1
    if i < 0:
        return float(s[0]), 0.0, float(s[0] * time)
    elapsed = time - t[i]
    slope = (s[i + 1] - s[i]) / (t[i + 1] - t[i]) if i + 1 < len(t) else 0.0
    factor = s[i] + slope * elapsed
    return float(factor), float(slope), float(profile.travel[i] + 0.5 * (s[i] + factor) * elapsed)


def line_state(arrays: Arrays, time: float, position: Floats, velocity: Floats) -> LineState:
    """Return deflections, stiffnesses and forces of all lines.

    Args:
        arrays: The system's numbers.
        time: [s].
        position: q [rad or m], shape (coordinates,).
        velocity: q̇ [rad/s or m/s], shape (coordinates,).
    """
    factor, _, travel = speed_factor(arrays.profile, time)
    angle, rate = arrays.tone_rate * travel, arrays.tone_rate * factor
    error, error_rate = _sums(arrays.error, angle, rate)
    variation, variation_rate = _sums(arrays.variation, angle, rate)
    deflection = along_lines(arrays, position) - error
    deflection_rate = along_lines(arrays, velocity) - error_rate + factor * arrays.slip
    contact = dead_zone(deflection, arrays.backlash)
    stiffness = arrays.stiffness * (1.0 + variation)
    force = stiffness * contact + arrays.damping * deflection_rate
    stiffness_rate = arrays.stiffness * variation_rate
    return LineState(deflection, deflection_rate, contact, stiffness, stiffness_rate, error_rate, force)


def dead_zone(deflection: Floats, backlash: Floats) -> Floats:
    """Return the deflection in contact: δ over zero, nothing in the gap, δ + B on the back flank.

    Args:
        deflection: δ [m or rad].
        backlash: B [m or rad].
    """
    back = deflection < -backlash
    return np.where(deflection > 0.0, deflection, 0.0) + np.where(back, deflection + np.where(back, backlash, 0.0), 0.0)


def _sums(series: Series, angle: Floats, rate: Floats) -> tuple[Floats, Floats]:
    """Return each line's Fourier sum and its time derivative."""
    lines = len(series.start) - 1
    row = np.arange(lines).repeat(series.start[1:] - series.start[:-1])
    cos, sin = np.cos(angle)[series.tone], np.sin(angle)[series.tone]
    value = series.cosine * cos + series.sine * sin
    slope = (series.sine * cos - series.cosine * sin) * rate[series.tone]
    value, slope = (np.bincount(row, part, lines).astype(float, copy=False) for part in (value, slope))
    return value, slope


def driven(arrays: Arrays, time: float, velocity: Floats, states: Floats | None = None) -> Acting:
    """Return what the drives do at one instant.

    Args:
        arrays: The system's numbers.
        time: [s].
        velocity: q̇ [rad/s or m/s], shape (coordinates,).
        states: Of the drives, shape (states,); left out: as at time 0.
    """
    total = arrays.speed * speed_factor(arrays.profile, time)[0] + velocity
    inputs = _scheduled(arrays.drives.inputs, time)
    return drive_effects(arrays.drives, total, inputs, arrays.drives.start if states is None else states)


def external_load(arrays: Arrays, time: float, velocity: Floats, states: Floats | None = None) -> Floats:
    """Return the external load on each coordinate [N or N m], shape (coordinates,).

    Args:
        arrays: The system's numbers.
        time: [s].
        velocity: q̇ [rad/s or m/s], shape (coordinates,).
        states: Of the drives, shape (states,); left out: as at time 0.
    """
    loads = arrays.loads
    total = arrays.speed * speed_factor(arrays.profile, time)[0] + velocity
    load = loads.constant - loads.damping * velocity - loads.quadratic * np.abs(total) * total
    np.add.at(load, loads.schedules.dof, _scheduled(loads.schedules, time))
    return load + driven(arrays, time, velocity, states).torque


def _scheduled(schedules: Schedules, time: float) -> Floats:
    rows = [slice(*pair) for pair in zip(schedules.start[:-1], schedules.start[1:], strict=True)]
    return np.array([np.interp(time, schedules.time[row], schedules.value[row]) for row in rows], dtype=float)


def acceleration(
    arrays: Arrays, time: float, position: Floats, velocity: Floats, states: Floats | None = None
) -> Floats:
    """Return q̈ of each coordinate [rad/s² or m/s²], shape (coordinates,).

    Args:
        arrays: The system's numbers.
        time: [s].
        position: q [rad or m], shape (coordinates,).
        velocity: q̇ [rad/s or m/s], shape (coordinates,).
        states: Of the drives, shape (states,); left out: as at time 0.
    """
    size = len(arrays.mass)
    factor, slope, _ = speed_factor(arrays.profile, time)
    force = external_load(arrays, time, velocity, states) - arrays.mass * arrays.speed * slope
    force -= onto_coordinates(arrays, line_state(arrays, time, position, velocity).force)
    force -= factor * (entry_matrix(arrays.gyroscopic, size) @ velocity)
    force += factor**2 * (entry_matrix(arrays.centripetal, size) @ position)
    return force / arrays.mass
