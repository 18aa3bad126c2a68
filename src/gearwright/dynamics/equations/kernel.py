"""Generic compiled right-hand side with its Runge–Kutta integrator, and the laws of drives."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numba import njit

from gearwright.base import Floats
from gearwright.dynamics.code_cache import compiled
from gearwright.dynamics.equations.reference import WORKS
from gearwright.dynamics.model import (
    HEADER,
    MACHINE,
    OUTPUTS,
    PROPELLER,
    STANDSTILL,
    Arrays,
    Profile,
    Schedules,
    Series,
)
from gearwright.machines import Governor, GovernorState, governor_rates

# ----------------------------------------------------------------------------------------------------------------------
# The laws of drives in compiled code: called by the generic kernel, and through a pointer by generated code.
#
# They read the table that `drives.encoded` writes, number by number, since slices cost more than the laws themselves;
# `drives.drive_effects` is what they must agree with.
# ----------------------------------------------------------------------------------------------------------------------


_governor_rates = njit(error_model="numpy")(governor_rates)
_SLACK = 1e-9
"""Part of a cell by which rounding may leave the map, as in `machines.propeller_charts` [-]."""


@compiled
def drive_columns(table: Floats, start: Floats) -> int:
    """Return how many numbers drives add to a row of a record."""
    return len(start) + OUTPUTS * int(table[0]) if len(table) else 0


@njit(error_model="numpy")
def _cell(table: Floats, first: int, count: int, value: float) -> int:
    """Return the cell of a rising grid in which a value lies, the nearest one outside."""
    low, high = 0, count - 1
    while high - low > 1:
        middle = (low + high) // 2
        if table[first + middle] < value:
            low = middle
        else:
            high = middle
    return low


@njit(error_model="numpy")
def _power(table: Floats, at: int, ratio: float, angle: float) -> tuple[float, float]:
    """Return C_P and flag of a map, carried on with J² where the drive says so; replaces `propeller_map.look_up`."""
    rows, columns = int(table[at + 9]), int(table[at + 10])
    a = at + 11 + rows
    b = a + columns
    first = b + 2 * rows * columns
    last = first + rows
    past = 1.0
    if table[last + rows] != 0.0 and ratio > table[a - 1]:
        past = ratio / table[a - 1]
        ratio = table[a - 1]
    i = _cell(table, at + 11, rows, ratio)
    low = int(max(table[first + i], table[first + i + 1]))
    high = int(min(table[last + i], table[last + i + 1]))
    k = min(max(_cell(table, a, columns, angle), low), high - 1)
    u = (ratio - table[at + 11 + i]) / (table[at + 12 + i] - table[at + 11 + i])
    v = (angle - table[a + k]) / (table[a + k + 1] - table[a + k])
    inside = -_SLACK <= u <= 1.0 + _SLACK and -_SLACK <= v <= 1.0 + _SLACK
    u, v = min(max(u, 0.0), 1.0), min(max(v, 0.0), 1.0)
    c = b + i * columns + k
    d = c + columns
    power = (1.0 - u) * ((1.0 - v) * table[c] + v * table[c + 1]) + u * ((1.0 - v) * table[d] + v * table[d + 1])
    return power * past * past, 0.0 if inside else 1.0


@njit(error_model="numpy")
def _machine(table: Floats, at: int, command: float, speed: float) -> tuple[float, float]:
    """Return torque on the shaft and flag; replaces `drives._machine`."""
    wanted = command * (1.0 + table[at + 2] * (1.0 - table[at] * speed / table[at + 1]))
    limit = min(table[at + 3], table[at + 4] / abs(speed))
    return table[at] * min(max(wanted, -limit), limit), 1.0 if abs(wanted) > limit else 0.0


@njit(error_model="numpy")
def _clutch(table: Floats, at: int, capacity: float, slip: float, twist: float) -> tuple[float, float, float]:
    """Return torque, flag and rate of twist; replaces `drives._clutch`."""
    sticking = table[at] * twist + table[at + 1] * slip
    torque = min(max(sticking, table[at + 2] * capacity), capacity)
    if torque == sticking:
        return torque, 0.0, slip
    return torque, 1.0, (torque - table[at] * twist) / table[at + 1]


@njit(error_model="numpy")
def _govern(table: Floats, at: int, x: int, error: float, command: float, state: Floats, slope: Floats) -> None:
    """Fill the rates of a governor's states."""
    governor = Governor(
        table[at + 1] + command, table[at + 2], table[at + 3], table[at + 4], table[at + 5], table[at + 6],
        table[at + 7], table[at + 8],
    )  # fmt: skip
    moved = _governor_rates(governor, GovernorState(state[x], state[x + 1], state[x + 2]), error)
    slope[x], slope[x + 1], slope[x + 2] = moved.pitch, moved.pitch_rate, moved.error_sum


@compiled
def apply_drives(
    table: Floats, inputs: Floats, factor: float, velocity: Floats, state: Floats, torque: Floats, rate: Floats,
    output: Floats,
) -> None:  # fmt: skip
    """Add the drives' torques, fill the rates of their states and what they report."""
    for i in range(len(state)):
        output[i] = state[i]
    place, report = 2, len(state)
    for _ in range(int(table[0])):
        kind, dof, second = int(table[place + 1]), int(table[place + 2]), int(table[place + 4])
        x, read, at = int(table[place + 6]), int(table[place + 7]), place + HEADER
        speed = table[place + 3] * factor + velocity[dof]
        if kind == PROPELLER:
            diameter, turns = table[at], max(abs(speed) / (2.0 * np.pi), STANDSTILL)
            power, flag = _power(table, at, inputs[read + 1] / (turns * diameter), state[x])
            value = power * inputs[read] * turns * turns * diameter**5 / (2.0 * np.pi)
            value = -value if speed < 0.0 else value
            _govern(table, at, x, inputs[read + 2] - abs(speed), inputs[read + 3], state, rate)
            torque[dof] -= value
        elif kind == MACHINE:
            value, flag = _machine(table, at, inputs[read], speed)
            torque[dof] += value
        else:
            speed -= table[place + 5] * factor + velocity[second]
            value, flag, rate[x] = _clutch(table, at, inputs[read], speed, state[x])
            torque[dof] -= value
            torque[second] += value
        output[report], output[report + 1], output[report + 2] = value, speed, flag
        place, report = place + int(table[place]), report + OUTPUTS


# ----------------------------------------------------------------------------------------------------------------------
# The generic compiled right-hand side and its Runge–Kutta driver: any topology, straight from the arrays.
#
# Each function says which plain function of `reference` it replaces. What the clock decides (stiffness, errors,
# loads) is worked out once for an instant and shared by the stages that fall on it.
# ----------------------------------------------------------------------------------------------------------------------


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
