"""Clock table: what time alone decides, for every half step of a block."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import product
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.codegen.assembler import aligned
from gearwright.dynamics.codegen.topology import topology
from gearwright.dynamics.codegen.writer import table_width, wave_width
from gearwright.dynamics.equations import speed_factors
from gearwright.dynamics.model import Arrays, planned

Clock = Callable[[int, int], tuple[Floats, Floats]]
"""(first step, steps) returns the table, a row for each half step, and by how much its tones are to be turned.

A row holds the cosines of all tones, their sines, s, ṡ, scheduled loads and drives' inputs; the turn cosines and sines.
"""


class Harmonic(NamedTuple):
    """How a tone's wave is made."""

    tone: int
    """Its number."""
    below: int
    """A slower tone, or -1: then by cosine and sine."""
    again: int
    """The tone that is added to it."""


def clock(arrays: Arrays, h: float, steps: int) -> Clock:
    """Return the clock of a run.

    At constant speed all blocks share the tones of one table, turned by the exact angles at the block's start: no
    trigonometry in the run, and no drift.

    Args:
        arrays: The system's numbers.
        h: Step [s].
        steps: Most steps of a block.
    """
    shape = topology(arrays)
    waves, factor = wave_width(shape), float(arrays.profile.factor[0])
    if np.any(arrays.profile.factor != factor):
        table = aligned(2 * steps + 1, table_width(shape))
        harmonics, unturned = _harmonics(arrays.tone_rate), waves_of(np.zeros(waves), waves)

        def ramped(first: int, count: int) -> tuple[Floats, Floats]:
            _fill_ramp(arrays, harmonics, _times(first, h, count), table=table, width=waves)
            return table, unturned

        return ramped
    rate, table = arrays.tone_rate * factor, _steady_table(arrays, h, steps)
    if table.shape[1] == 2 * waves + 2:
        return lambda first, _: (table, waves_of(rate * (first * h), waves))
    loaded = aligned(*table.shape)  # of this run alone
    loaded[:] = table

    def steady(first: int, count: int) -> tuple[Floats, Floats]:
        _fill_loads(arrays, _times(first, h, count), loaded[:, 2 * waves + 2 :])
        return loaded, waves_of(rate * (first * h), waves)

    return steady


@planned
def _steady_table(arrays: Arrays, h: float, steps: int) -> Floats:
    """Return the clock table of the first block at constant speed; loads are left out."""
    shape = topology(arrays)
    waves, table = wave_width(shape), aligned(2 * steps + 1, table_width(shape))
    factor = float(arrays.profile.factor[0])
    table[:, : 2 * waves] = waves_of(np.outer(_times(0, h, steps), arrays.tone_rate * factor), waves)
    table[:, 2 * waves] = factor
    return table


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


def _times(first: int, h: float, steps: int) -> Floats:
    return np.asarray((first + 0.5 * np.arange(2 * steps + 1)) * h, dtype=np.float64)


def _fill_ramp(arrays: Arrays, harmonics: Sequence[Harmonic], time: Floats, *, table: Floats, width: int) -> None:
    """Fill the rows of a clock table at changing speed; its waves are filled up to a width."""
    tones, rows = len(harmonics), slice(len(time))
    factor, slope, travel = speed_factors(arrays.profile, time)
    waves = np.empty((tones, len(time)), dtype=np.complex128)
    for tone, below, again in harmonics:
        if below < 0:
            angle = arrays.tone_rate[tone] * travel
            np.cos(angle, out=waves.real[tone])
            np.sin(angle, out=waves.imag[tone])
        else:
            np.multiply(waves[below], waves[again], out=waves[tone])
    table[rows, :tones], table[rows, width : width + tones] = waves.real.T, waves.imag.T
    table[rows, 2 * width], table[rows, 2 * width + 1] = factor, slope
    _fill_loads(arrays, time, table[:, 2 * width + 2 :])


def _harmonics(rates: Floats) -> list[Harmonic]:
    """Return how each tone is made: a harmonic is the product of two slower tones whose rates add up to its own."""
    harmonics = list[Harmonic]()
    for tone in np.argsort(np.abs(rates), kind="stable").tolist():
        pairs = product((slower.tone for slower in harmonics), repeat=2)
        sums = (pair for pair in pairs if np.isclose(rates[pair[0]] + rates[pair[1]], rates[tone], 1e-14, 0))
        harmonics.append(Harmonic(tone, *next(sums, (-1, -1))))
    return harmonics


def _fill_loads(arrays: Arrays, time: Floats, columns: Floats) -> None:
    column = 0
    for schedules in (arrays.loads.schedules, arrays.drives.inputs):
        for number in range(len(schedules.dof)):
            row = slice(schedules.start[number], schedules.start[number + 1])
            columns[: len(time), column] = _scheduled(schedules.time[row], schedules.value[row], time)
            column += 1


def _scheduled(points: Floats, values: Floats, time: Floats) -> Floats | float:
    """Return what `np.interp` does, to the last bit, at the price of one line where a block meets no corner."""
    first, last = (int(points.searchsorted(end, side="right")) - 1 for end in (time[0], time[-1]))
    if last < 0 or first == len(points) - 1:
        return float(values[0 if last < 0 else -1])
    if first == last:
        slope = (values[first + 1] - values[first]) / (points[first + 1] - points[first])
        return np.asarray(slope * (time - points[first]) + values[first])
    return np.interp(time, points, values)
