"""The laws of drives in translated Python, one function for each kind, called by generated code.

They read the numbers of one record of the table that `drives.encoded` writes, in memory; `drives.drive_effects` is what
they must agree with. What a record reads against time, its states and what it reports stand at the places given.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

from gearwright.arrays import Floats
from gearwright.dynamics.codegen.loops import at, library
from gearwright.dynamics.model import STANDSTILL

_SLACK = 1e-9
"""Part of a cell by which rounding may leave the map, as in `machines.propeller_map` [-]."""
_MAP = 11
"""Numbers of a propeller's record before its map: diameter, governor, rows and columns."""


def cell_of(grid: Floats, count: int, value: float) -> int:
    """Return the cell of a rising grid in which a value lies, the nearest one outside."""
    low, high = 0, count - 1
    while high - low > 1:
        middle = (low + high) // 2
        if grid[middle] < value:
            low = middle
        else:
            high = middle
    return low


def map_power(numbers: Floats, ratio: float, angle: float, seen: Floats) -> float:
    """Return C_P of a map, carried on with J² where the record says so, and report whether the point lies outside."""
    rows, columns = int(numbers[9]), int(numbers[10])
    ratios, angles = at(numbers, _MAP), at(numbers, _MAP + rows)
    powers, firsts = at(angles, columns), at(angles, columns + 2 * rows * columns)
    lasts, past = at(firsts, rows), 1.0
    if lasts[rows] != 0.0 and ratio > ratios[rows - 1]:
        past = ratio / ratios[rows - 1]
        ratio = ratios[rows - 1]
    i = cell_of(ratios, rows, ratio)
    low, high = int(max(firsts[i], firsts[i + 1])), int(min(lasts[i], lasts[i + 1]))
    k = min(max(cell_of(angles, columns, angle), low), high - 1)
    u = (ratio - ratios[i]) / (ratios[i + 1] - ratios[i])
    v = (angle - angles[k]) / (angles[k + 1] - angles[k])
    inside = -_SLACK <= u <= 1.0 + _SLACK and -_SLACK <= v <= 1.0 + _SLACK
    seen[2] = 0.0 if inside else 1.0
    u, v = min(max(u, 0.0), 1.0), min(max(v, 0.0), 1.0)
    here, there = at(powers, i * columns + k), at(powers, (i + 1) * columns + k)
    power = (1.0 - u) * ((1.0 - v) * here[0] + v * here[1]) + u * ((1.0 - v) * there[0] + v * there[1])
    found: float = power * past * past
    return found


def govern(numbers: Floats, read: Floats, error: float, state: Floats, rate: Floats) -> None:
    """Fill the rates of a governor's states, as `machines.governor_rates` does."""
    lower, upper, fastest, pitch, turning = numbers[6], numbers[7], numbers[8], state[0], state[1]
    asked = numbers[1] + read[3] - numbers[2] * error - numbers[3] * state[2]
    stuck = (asked > upper and error < 0.0) or (asked < lower and error > 0.0)
    time, damping, gap = numbers[4], numbers[5], min(max(asked, lower), upper) - pitch
    rate[2] = 0.0 if stuck else error
    if damping == 0.0:
        rate[0] = min(max(gap / time, -fastest), fastest)
        rate[1] = 0.0
    else:
        pull = (gap - 2.0 * damping * time * turning) / (time * time)
        rate[0] = min(max(turning, -fastest), fastest)
        limited = (turning >= fastest and pull > 0.0) or (turning <= -fastest and pull < 0.0)
        rate[1] = 0.0 if limited else pull


def propeller_law(numbers: Floats, read: Floats, state: Floats, rate: Floats, seen: Floats, speed: float) -> float:
    """Return the torque on a propeller's shaft; fill the rates of its governor, and torque, speed and flag."""
    diameter, turns = numbers[0], max(abs(speed) / (2.0 * math.pi), STANDSTILL)
    power = map_power(numbers, read[1] / (turns * diameter), state[0], seen)
    square = diameter * diameter
    torque: float = power * read[0] * turns * turns * (square * square * diameter) / (2.0 * math.pi)
    torque = -torque if speed < 0.0 else torque
    govern(numbers, read, read[2] - abs(speed), state, rate)
    seen[0] = torque
    seen[1] = speed
    return -torque


def machine_law(numbers: Floats, read: Floats, state: Floats, rate: Floats, seen: Floats, speed: float) -> float:
    """Return the torque of a machine on its shaft; fill torque, speed and flag. It has no states."""
    wanted = read[0] * (1.0 + numbers[2] * (1.0 - numbers[0] * speed / numbers[1]))
    limit = min(numbers[3], numbers[4] / abs(speed))
    torque: float = numbers[0] * min(max(wanted, -limit), limit)
    seen[0] = torque
    seen[1] = speed
    seen[2] = 1.0 if abs(wanted) > limit else 0.0
    return torque


def clutch_law(numbers: Floats, read: Floats, state: Floats, rate: Floats, seen: Floats, speed: float) -> float:
    """Return the torque of a clutch on its first shaft; fill the rate of its twist, and torque, slip and flag."""
    sticking = numbers[0] * state[0] + numbers[1] * speed
    torque: float = min(max(sticking, numbers[2] * read[0]), read[0])
    held = torque == sticking
    rate[0] = speed if held else (torque - numbers[0] * state[0]) / numbers[1]
    seen[0] = torque
    seen[1] = speed
    seen[2] = 0.0 if held else 1.0
    return -torque


KINDS = ("propeller_law", "machine_law", "clutch_law")
"""By the kind of a record."""


def laws() -> Mapping[str, int]:
    """Return where in memory the laws are, by name; they are compiled for the first system with drives."""
    code = library(cell_of, map_power, govern, propeller_law, machine_law, clutch_law)
    return {name: code.address(name) for name in KINDS}
