"""Time-dependent excitation in generated code: the table over time, and the laws of drives."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from itertools import product
from typing import NamedTuple

import numpy as np

from gearwright.base import Floats, Ints
from gearwright.dynamics.codegen.assembler import address, aligned
from gearwright.dynamics.codegen.loops import at, library, packed
from gearwright.dynamics.codegen.topology import table_width, topology, wave_width
from gearwright.dynamics.model import STANDSTILL, Arrays, Schedules, planned

# ----------------------------------------------------------------------------------------------------------------------
# Clock table: what time alone decides, for every half step of a block, filled by compiled code.
# ----------------------------------------------------------------------------------------------------------------------


Clock = Callable[[int, int], tuple[Floats, Floats]]
"""(first step, steps) returns the table, a row for each half step, and by how much its tones are to be turned.

A row holds the cosines of all tones, their sines, s, ṡ, scheduled loads and drives' inputs; the turn cosines and sines.
"""


class Clocked(NamedTuple):
    """What the clock of a run is filled from, and where to."""

    h: float
    """Step [s]."""
    table: Floats
    """A row for each half step of a block."""
    row: int
    """Numbers in it."""
    tones: int
    rate: Floats
    """Of the tones, at constant speed with its factor [rad/s]."""
    wave: int
    """Numbers that hold the cosines of all tones, filled up to whole vectors."""
    ramped: int
    """Whether the speed changes: tones are then worked out for each row, and not turned."""
    points: int
    """Of the speed profile."""
    time: Floats
    factor: Floats
    travel: Floats
    harmonics: Ints
    """How each tone is made: its number, and two slower ones whose rates add up to its own, or -1; shape (tones, 3)."""
    curves: int
    """Scheduled loads and drives' inputs."""
    starts: Ints
    """First point of each curve, shape (curves + 1,)."""
    knots: Floats
    """[s]."""
    values: Floats


def turn_tones(c: Clocked, turn: Floats, first: int) -> None:
    """Fill by how much the tones are to be turned for a block that begins at a step."""
    for i in range(c.tones):
        angle = c.rate[i] * (first * c.h)
        turn[i] = math.cos(angle)
        turn[c.wave + i] = math.sin(angle)


def fill_speed(c: Clocked, first: int, count: int) -> None:
    """Fill s, ṡ and the waves of the tones at changing speed."""
    piece, rate = -1, 0.0
    for i in range(2 * count + 1):
        time, row = (first + 0.5 * i) * c.h, at(c.table, i * c.row)
        if i == 0 or (piece + 1 < c.points and c.time[piece + 1] <= time):
            while piece + 1 < c.points and c.time[piece + 1] <= time:
                piece += 1
            rate = 0.0
            if piece >= 0 and piece < c.points - 1:
                rate = (c.factor[piece + 1] - c.factor[piece]) / (c.time[piece + 1] - c.time[piece])
        k = max(piece, 0)
        elapsed = time - c.time[k]
        factor = c.factor[k] + rate * elapsed
        travel = c.travel[k] + 0.5 * (c.factor[k] + factor) * elapsed
        row[2 * c.wave] = factor
        row[2 * c.wave + 1] = rate
        for j in range(c.tones):
            tone, one, other = c.harmonics[3 * j], c.harmonics[3 * j + 1], c.harmonics[3 * j + 2]
            if one < 0:
                angle = c.rate[tone] * travel
                row[tone] = math.cos(angle)
                row[c.wave + tone] = math.sin(angle)
            else:
                row[tone] = row[one] * row[other] - row[c.wave + one] * row[c.wave + other]
                row[c.wave + tone] = row[one] * row[c.wave + other] + row[c.wave + one] * row[other]


def fill_curves(c: Clocked, first: int, count: int) -> None:
    """Fill what loads and drives read, joined by straight lines and constant outside their points."""
    for curve in range(c.curves):
        start, column = c.starts[curve], at(c.table, 2 * c.wave + 2 + curve)
        knots, values, points = at(c.knots, start), at(c.values, start), c.starts[curve + 1] - start
        piece, slope, base, value = -1, 0.0, 0.0, values[0]
        for i in range(2 * count + 1):
            time = (first + 0.5 * i) * c.h
            if piece + 1 < points and knots[piece + 1] <= time:
                while piece + 1 < points and knots[piece + 1] <= time:
                    piece += 1
                base, value, slope = knots[piece], values[piece], 0.0
                if piece < points - 1:
                    slope = (values[piece + 1] - values[piece]) / (knots[piece + 1] - knots[piece])
            column[i * c.row] = slope * (time - base) + value


def set_clock(c: Clocked, turn: Floats, first: int, count: int) -> None:
    """Set the clock for a block."""
    if c.ramped:
        fill_speed(c, first, count)
    else:
        turn_tones(c, turn, first)
    fill_curves(c, first, count)


FUNCTIONS = (turn_tones, fill_speed, fill_curves, set_clock)
"""To be compiled together."""


def clocked(arrays: Arrays, h: float, steps: int) -> tuple[Clocked, Ints]:
    """Return the clock of one run, and the same as compiled code reads it.

    At constant speed all blocks share the tones of one table, turned by the exact angles at the block's start: no
    trigonometry in the run, and no drift.

    Args:
        arrays: The system's numbers.
        h: Step [s].
        steps: Most steps of a block.
    """
    fixed, given = _fixed(arrays, h, steps)
    if not (fixed.ramped or fixed.curves):
        return fixed, given
    table = aligned(*fixed.table.shape)  # of this run alone
    table[:] = fixed.table
    own = fixed._replace(table=table)
    return own, packed(own)


def unturned(clocked: Clocked) -> Floats:
    """Return the turn of tones that stay as they are.

    Args:
        clocked: Whose tones.
    """
    turn = np.zeros(2 * clocked.wave)
    turn[: clocked.wave] = 1.0
    return turn


def clock(arrays: Arrays, h: float, steps: int) -> Clock:
    """Return the clock of a run, block by block.

    Args:
        arrays: The system's numbers.
        h: Step [s].
        steps: Most steps of a block.
    """
    (mine, given), code = clocked(arrays, h, steps), library(*FUNCTIONS).function("set_clock")
    turn = unturned(mine)

    def now(first: int, count: int) -> tuple[Floats, Floats]:
        code(address(given), address(turn), first, count)
        return mine.table, turn

    return now


@planned
def _fixed(arrays: Arrays, h: float, steps: int) -> tuple[Clocked, Ints]:
    """Return the clock with the table of the first block at constant speed; what is read against time is left out."""
    shape, profile = topology(arrays), arrays.profile
    waves, table = wave_width(shape), aligned(2 * steps + 1, table_width(shape))
    factor = float(profile.factor[0])
    ramped = bool(np.any(profile.factor != factor))
    rate = arrays.tone_rate * (1.0 if ramped else factor)
    if not ramped:
        table[:, : 2 * waves] = waves_of(np.outer(0.5 * h * np.arange(2 * steps + 1), rate), waves)
        table[:, 2 * waves] = factor
    harmonics = np.array(_harmonics(arrays.tone_rate) if ramped else [], dtype=np.int64)
    curves = [_points(one) for one in (arrays.loads.schedules, arrays.drives.inputs)]
    lengths, knots, values = (np.concatenate(parts) for parts in zip(*curves, strict=True))
    starts = np.concatenate([[0], np.cumsum(lengths)]).astype(np.int64)
    fixed = Clocked(
        h, table, table.shape[1], len(rate), rate, waves, int(ramped), len(profile.time), profile.time,
        profile.factor, profile.travel, harmonics, len(lengths), starts, knots, values,
    )  # fmt: skip
    return fixed, packed(fixed)


def _points(schedules: Schedules) -> tuple[Ints, Floats, Floats]:
    """Return how many points each curve has, and their times and values."""
    ends = schedules.start[: len(schedules.dof) + 1]
    return ends[1:] - ends[:-1], schedules.time[: ends[-1]], schedules.value[: ends[-1]]


def waves_of(angle: Floats, width: int) -> Floats:
    """Return cosines and sines, each filled up to a width, shape (…, 2 width).

    Args:
        angle: [rad], shape (…, tones).
        width: Numbers for each.
    """
    waves = np.zeros((*angle.shape[:-1], 2, width))
    np.cos(angle, out=waves[..., 0, : angle.shape[-1]])
    np.sin(angle, out=waves[..., 1, : angle.shape[-1]])
    return waves.reshape(*angle.shape[:-1], 2 * width)


def _harmonics(rates: Floats) -> Sequence[tuple[int, int, int]]:
    """Return how each tone is made: a harmonic is the product of two slower tones whose rates add up to its own."""
    harmonics = list[tuple[int, int, int]]()
    for tone in np.argsort(np.abs(rates), kind="stable").tolist():
        pairs = product((slower for slower, _, _ in harmonics), repeat=2)
        sums = (pair for pair in pairs if np.isclose(rates[pair[0]] + rates[pair[1]], rates[tone], 1e-14, 0))
        harmonics.append((tone, *next(sums, (-1, -1))))
    return harmonics


# ----------------------------------------------------------------------------------------------------------------------
# The laws of drives in translated Python, one function for each kind, called by generated code.
#
# They read the numbers of one record of the table that `drives.encoded` writes, in memory; `drives.drive_effects` is
# what they must agree with. What a record reads against time, its states and what it reports stand at the places
# given.
# ----------------------------------------------------------------------------------------------------------------------


_SLACK = 1e-9
"""Part of a cell by which rounding may leave the map, as in `machines.propeller_charts` [-]."""
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
