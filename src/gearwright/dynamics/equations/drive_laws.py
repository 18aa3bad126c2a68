"""The laws of drives in compiled code: called by the generic kernel, and through a pointer by generated code.

They read the table that `drives.encoded` writes, number by number, since slices cost more than the laws themselves;
`drives.drive_effects` is what they must agree with.
"""

from __future__ import annotations

import numpy as np
from numba import njit

from gearwright.arrays import Floats
from gearwright.dynamics.code_cache import compiled
from gearwright.dynamics.model import HEADER, MACHINE, OUTPUTS, PROPELLER, STANDSTILL
from gearwright.machines import Governor, GovernorState, governor_rates

_governor_rates = njit(error_model="numpy")(governor_rates)
_SLACK = 1e-9
"""Part of a cell by which rounding may leave the map, as in `machines.propeller_map` [-]."""


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
