"""The laws of drives in compiled code: called by the generic kernel, and through a pointer by generated code.

They read the table that `drives.encoded` writes; `drives.drive_effects` is what they must agree with.
"""

from __future__ import annotations

import numpy as np
from numba import njit

from gearwright.dynamics.drives import HEADER, MACHINE, OUTPUTS, PROPELLER
from gearwright.dynamics.energy import WORKS
from gearwright.dynamics.system import Floats
from gearwright.machines.governor import Governor, GovernorState, governor_rates
from gearwright.machines.propeller_map import PropellerMap, look_up

_look_up = njit(error_model="numpy")(look_up)
_governor_rates = njit(error_model="numpy")(governor_rates)


@njit(cache=True, error_model="numpy")
def drive_columns(table: Floats, start: Floats) -> int:
    """Return how many numbers drives add to a row of a record."""
    return len(start) + OUTPUTS * int(table[0]) if len(table) else 0


@njit(error_model="numpy")
def _chart(numbers: Floats) -> PropellerMap:
    """Return a propeller's map as it stands in the table."""
    rows, columns = int(numbers[9]), int(numbers[10])
    a = 11 + rows
    b = a + columns
    c = b + rows * columns
    d = c + rows * columns
    power, thrust = numbers[b:c].reshape((rows, columns)), numbers[c:d].reshape((rows, columns))
    ends = numbers[d : d + rows], numbers[d + rows :]  # whole numbers, which `look_up` rounds
    return PropellerMap(numbers[11:a], numbers[a:b], power, thrust, ends[0], ends[1])  # type: ignore[arg-type]


@njit(error_model="numpy")
def _propeller(numbers: Floats, read: Floats, speed: float, state: Floats, rate: Floats) -> tuple[float, float]:
    """Fill the governor's rates and return torque taken from the shaft and flag; replaces `drives._propeller`."""
    diameter, turns = numbers[0], abs(speed) / (2.0 * np.pi)
    found = _look_up(_chart(numbers), read[1] / (turns * diameter), state[0])
    governor = Governor(
        numbers[1] + read[3], numbers[2], numbers[3], numbers[4], numbers[5], numbers[6], numbers[7], numbers[8]
    )
    moved = _governor_rates(governor, GovernorState(state[0], state[1], state[2]), read[2] - abs(speed))
    rate[0], rate[1], rate[2] = moved.pitch, moved.pitch_rate, moved.error_sum
    torque = found.power * read[0] * turns * turns * diameter**5 / (2.0 * np.pi)
    return np.copysign(torque, speed), float(found.status)


@njit(error_model="numpy")
def _machine(numbers: Floats, command: float, speed: float) -> tuple[float, float]:
    """Return torque on the shaft and flag; replaces `drives._machine`."""
    wanted = command * (1.0 + numbers[2] * (1.0 - numbers[0] * speed / numbers[1]))
    limit = min(numbers[3], numbers[4] / abs(speed))
    return numbers[0] * min(max(wanted, -limit), limit), 1.0 if abs(wanted) > limit else 0.0


@njit(error_model="numpy")
def _clutch(numbers: Floats, capacity: float, slip: float, twist: float) -> tuple[float, float, float]:
    """Return torque, flag and rate of twist; replaces `drives._clutch`."""
    sticking = numbers[0] * twist + numbers[1] * slip
    torque = min(max(sticking, numbers[2] * capacity), capacity)
    if torque == sticking:
        return torque, 0.0, slip
    return torque, 1.0, (torque - numbers[0] * twist) / numbers[1]


@njit(cache=True, error_model="numpy")
def apply_drives(
    table: Floats, inputs: Floats, factor: float, state: Floats, torque: Floats, slope: Floats, output: Floats
) -> None:
    """Add the drives' torques, fill the rates of their states and what they report."""
    drives, size = int(table[0]), int(table[1])
    first = 2 * size + WORKS
    states = len(state) - first
    for i in range(states):
        output[i] = state[first + i]
    place, report = 2, states
    for _ in range(drives):
        length, kind, dof = int(table[place]), int(table[place + 1]), int(table[place + 2])
        other, own, read = int(table[place + 4]), int(table[place + 6]), inputs[int(table[place + 7]) :]
        numbers = table[place + HEADER : place + length]
        speed = table[place + 3] * factor + state[size + dof]
        if kind == PROPELLER:
            part = slice(first + own, first + own + 3)
            value, flag = _propeller(numbers, read, speed, state[part], slope[part])
            torque[dof] -= value
        elif kind == MACHINE:
            value, flag = _machine(numbers, read[0], speed)
            torque[dof] += value
        else:
            speed -= table[place + 5] * factor + state[size + other]
            value, flag, slope[first + own] = _clutch(numbers, read[0], speed, state[first + own])
            torque[dof] -= value
            torque[other] += value
        output[report], output[report + 1], output[report + 2] = value, speed, flag
        place, report = place + length, report + OUTPUTS
