"""The generic compiled right-hand side and its Runge–Kutta driver: any topology, straight from the arrays.

Each function says which plain function of `reference` it replaces. What the clock decides (stiffness, errors, loads) is
worked out once for an instant and shared by the stages that fall on it.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.code_cache import compiled
from gearwright.dynamics.equations.drive_laws import apply_drives
from gearwright.dynamics.equations.energy import WORKS
from gearwright.dynamics.model import Arrays, Profile, Schedules, Series


class Instant(NamedTuple):
    """What the clock alone decides; work arrays that are filled in place."""

    stiffness: Floats
    """k(φ) [N/m or N m/rad], shape (lines,)."""
    stiffness_rate: Floats
    """dk/dt, shape (lines,)."""
    error: Floats
    """e(φ) [m or rad], shape (lines,)."""
    error_rate: Floats
    """de/dt, shape (lines,)."""
    load: Floats
    """Constant and scheduled load less the inertia force of the speed profile, shape (coordinates,)."""
    inertia_load: Floats
    """M Ω ṡ, taken from `load`, shape (coordinates,)."""
    factor: Floats
    """Speed factor s, shape (1,)."""
    tone: Floats
    """cos and sin of every tone, shape (2, tones)."""
    input: Floats
    """What the drives read against time, shape (inputs,)."""


def empty_instant(arrays: Arrays) -> Instant:
    """Return work arrays of the right sizes.

    Args:
        arrays: The system's numbers.
    """
    lines, size, tones = len(arrays.stiffness), len(arrays.mass), len(arrays.tone_rate)
    stiffness, stiffness_rate, error, error_rate = np.zeros((4, lines))
    load, inertia_load = np.zeros((2, size))
    tone = np.zeros((2, tones))
    read = np.zeros(len(arrays.drives.inputs.dof))
    return Instant(stiffness, stiffness_rate, error, error_rate, load, inertia_load, np.zeros(1), tone, read)


@compiled
def speed_factor(profile: Profile, time: float) -> tuple[float, float, float]:
    """Return s, ṡ and τ; replaces `reference.speed_factor`."""
    t, s = profile.time, profile.factor
    i = np.searchsorted(t, time, side="right") - 1
    if i < 0:
        return s[0], 0.0, s[0] * time
    elapsed = time - t[i]
    slope = (s[i + 1] - s[i]) / (t[i + 1] - t[i]) if i + 1 < len(t) else 0.0
    factor = s[i] + slope * elapsed
    return factor, slope, profile.travel[i] + 0.5 * (s[i] + factor) * elapsed


@compiled
def fill_sums(series: Series, rate: Floats, tone: Floats, value: Floats, slope: Floats) -> None:
    """Fill Fourier sums and their derivatives by τ; replaces `reference._sums`."""
    for j in range(len(value)):
        total = 0.0
        change = 0.0
        for i in range(series.start[j], series.start[j + 1]):
            k = series.tone[i]
            cos, sin = tone[0, k], tone[1, k]
            total += series.cosine[i] * cos + series.sine[i] * sin
            change += (series.sine[i] * cos - series.cosine[i] * sin) * rate[k]
        value[j] = total
        slope[j] = change


@compiled
def add_schedules(schedules: Schedules, time: float, load: Floats) -> None:
    """Add piecewise linear loads; replaces `reference._scheduled`."""
    for i in range(len(schedules.dof)):
        first, past = schedules.start[i], schedules.start[i + 1]
        t, value = schedules.time[first:past], schedules.value[first:past]
        load[schedules.dof[i]] += np.interp(time, t, value)


@compiled
def fill_inputs(inputs: Schedules, time: float, value: Floats) -> None:
    """Fill what the drives read; replaces `reference._scheduled`."""
    for i in range(len(inputs.dof)):
        first, past = inputs.start[i], inputs.start[i + 1]
        value[i] = np.interp(time, inputs.time[first:past], inputs.value[first:past])


@compiled
def set_instant(arrays: Arrays, time: float, now: Instant) -> None:
    """Fill everything that the clock alone decides."""
    factor, slope, travel = speed_factor(arrays.profile, time)
    now.factor[0] = factor
    for i in range(len(arrays.tone_rate)):
        angle = arrays.tone_rate[i] * travel
        now.tone[0, i], now.tone[1, i] = np.cos(angle), np.sin(angle)
    fill_sums(arrays.variation, arrays.tone_rate, now.tone, now.stiffness, now.stiffness_rate)
    fill_sums(arrays.error, arrays.tone_rate, now.tone, now.error, now.error_rate)
    for j in range(len(arrays.stiffness)):
        now.stiffness[j] = arrays.stiffness[j] * (1.0 + now.stiffness[j])
        now.stiffness_rate[j] *= arrays.stiffness[j] * factor
        now.error_rate[j] *= factor
    for i in range(len(arrays.mass)):
        now.inertia_load[i] = arrays.mass[i] * arrays.speed[i] * slope
        now.load[i] = arrays.loads.constant[i] - now.inertia_load[i]
    add_schedules(arrays.loads.schedules, time, now.load)
    fill_inputs(arrays.drives.inputs, time, now.input)


@compiled
def apply_lines(arrays: Arrays, now: Instant, state: Floats, slope: Floats, output: Floats) -> None:
    """Fill line forces and deflections and add forces and powers to the slopes; replaces `reference.line_state`."""
    size, lines = len(arrays.mass), len(arrays.stiffness)
    dissipated, stiffness_power, error_power = 0.0, 0.0, 0.0
    for j in range(len(arrays.stiffness)):
        first, past = arrays.line_start[j], arrays.line_start[j + 1]
        deflection, rate = -now.error[j], now.factor[0] * arrays.slip[j] - now.error_rate[j]
        for i in range(first, past):
            deflection += arrays.line_weight[i] * state[arrays.line_dof[i]]
            rate += arrays.line_weight[i] * state[size + arrays.line_dof[i]]
        contact = max(deflection, 0.0)
        if deflection < -arrays.backlash[j]:
            contact = deflection + arrays.backlash[j]
        force = now.stiffness[j] * contact + arrays.damping[j] * rate
        output[j], output[lines + j] = force, deflection
        for i in range(first, past):
            slope[size + arrays.line_dof[i]] -= arrays.line_weight[i] * force
        dissipated += arrays.damping[j] * rate * rate
        stiffness_power += 0.5 * now.stiffness_rate[j] * contact * contact
        error_power -= now.error_rate[j] * force
    slope[2 * size + 2], slope[2 * size + 3], slope[2 * size + 4] = dissipated, stiffness_power, error_power


@compiled
def apply_frames(arrays: Arrays, now: Instant, state: Floats, slope: Floats) -> None:
    """Add gyroscopic and centripetal forces and the power that holds the frame at its speed."""
    size = len(arrays.mass)
    factor, power = now.factor[0], 0.0
    for i in range(len(arrays.gyroscopic.value)):
        row = size + arrays.gyroscopic.row[i]
        force = -factor * arrays.gyroscopic.value[i] * state[size + arrays.gyroscopic.column[i]]
        slope[row] += force
        power += force * state[row]
    for i in range(len(arrays.centripetal.value)):
        row = size + arrays.centripetal.row[i]
        force = factor * factor * arrays.centripetal.value[i] * state[arrays.centripetal.column[i]]
        slope[row] += force
        power += force * state[row]
    slope[2 * size + 5] = power


@compiled
def derivative(arrays: Arrays, now: Instant, state: Floats, slope: Floats, output: Floats) -> None:
    """Fill the time derivative of (q, q̇, works, x), line forces and deflections; replaces `reference.acceleration`."""
    size = len(arrays.mass)
    driven, braked = 0.0, 0.0
    slope[size : 2 * size] = 0.0
    if len(arrays.drives.table):
        seen, first = output[2 * len(arrays.stiffness) :], 2 * size + WORKS
        speeds, torque = state[size : 2 * size], slope[size : 2 * size]
        apply_drives(arrays.drives.table, now.input, now.factor[0], speeds, state[first:], torque, slope[first:], seen)
    for i in range(size):
        velocity = state[size + i]
        rigid = arrays.speed[i] * now.factor[0]
        total = rigid + velocity
        load = now.load[i] + slope[size + i] - arrays.loads.damping[i] * velocity
        load -= arrays.loads.quadratic[i] * abs(total) * total
        slope[i] = velocity
        slope[size + i] = load
        power = (load + now.inertia_load[i]) * total
        driven += max(power, 0.0)
        braked += max(-power, 0.0)
    slope[2 * size], slope[2 * size + 1] = driven, braked
    apply_lines(arrays, now, state, slope, output)
    apply_frames(arrays, now, state, slope)
    for i in range(size):
        slope[size + i] /= arrays.mass[i]


@compiled
def runge_kutta(
    arrays: Arrays, instants: tuple[Instant, Instant], first: int, h: float, record: Floats, state: Floats
) -> None:
    """Advance by one step for each row of `record`; a row holds q, q̇, line forces and deflections at its start.

    Times are step × h, so that a run that starts again at any step repeats itself bit for bit.
    """
    now, later = instants
    size = len(arrays.mass)
    k1, k2, k3, k4 = np.empty_like(state), np.empty_like(state), np.empty_like(state), np.empty_like(state)
    spare = np.empty(record.shape[1] - 2 * size)
    set_instant(arrays, first * h, now)
    for row in range(len(record)):
        derivative(arrays, now, state, k1, record[row, 2 * size :])
        record[row, : 2 * size] = state[: 2 * size]
        set_instant(arrays, (first + row + 0.5) * h, later)
        derivative(arrays, later, state + 0.5 * h * k1, k2, spare)
        derivative(arrays, later, state + 0.5 * h * k2, k3, spare)
        set_instant(arrays, (first + row + 1) * h, now)
        derivative(arrays, now, state + h * k3, k4, spare)
        for i in range(len(state)):
            state[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i])
