"""Clock table: what time alone decides, for every half step of a block."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from gearwright.dynamics.system import Arrays, Floats, Profile

Clock = Callable[[int, Floats], None]
"""(first step, table) fills the rows: cosine and sine of each tone, s, ṡ, scheduled loads; a row for each half step."""


def clock(arrays: Arrays, h: float, rows: int) -> Clock:
    """Return the filler of clock tables.

    At constant speed each tone of a block is its exact value at the block's start, turned by angles that are worked out
    once: no trigonometry in the run, and no drift.

    Args:
        arrays: The system's numbers.
        h: Step [s].
        rows: Most rows of a table.
    """
    if np.all(arrays.profile.factor == arrays.profile.factor[0]):
        return _steady(arrays, h, rows)
    return lambda first, table: _ramped(arrays, _times(first, h, len(table)), table)


def _times(first: int, h: float, rows: int) -> Floats:
    return np.asarray((first + 0.5 * np.arange(rows)) * h, dtype=np.float64)


def _steady(arrays: Arrays, h: float, rows: int) -> Clock:
    factor = float(arrays.profile.factor[0])
    turned = np.exp(1j * np.outer(0.5 * h * np.arange(rows), arrays.tone_rate * factor))
    tones = len(arrays.tone_rate)

    def fill(first: int, table: Floats) -> None:
        start = np.exp(1j * arrays.tone_rate * factor * (first * h))
        np.multiply(turned[: len(table)], start, out=table[:, : 2 * tones].view(np.complex128))
        table[:, 2 * tones], table[:, 2 * tones + 1] = factor, 0.0
        if len(arrays.loads.schedules.dof) or len(arrays.drives.inputs.dof):
            _loads(arrays, _times(first, h, len(table)), table)

    return fill


def _ramped(arrays: Arrays, time: Floats, table: Floats) -> None:
    tones = len(arrays.tone_rate)
    factor, slope, travel = speed_factors(arrays.profile, time)
    table[:, : 2 * tones].view(np.complex128)[:] = np.exp(1j * np.outer(travel, arrays.tone_rate))
    table[:, 2 * tones], table[:, 2 * tones + 1] = factor, slope
    _loads(arrays, time, table)


def _loads(arrays: Arrays, time: Floats, table: Floats) -> None:
    column = 2 * len(arrays.tone_rate) + 2
    for schedules in (arrays.loads.schedules, arrays.drives.inputs):
        for number in range(len(schedules.dof)):
            part = slice(schedules.start[number], schedules.start[number + 1])
            table[:, column] = np.interp(time, schedules.time[part], schedules.value[part])
            column += 1


def speed_factors(profile: Profile, time: Floats) -> tuple[Floats, Floats, Floats]:
    """Return s [-], ṡ [1/s] and τ [s] at many times; `reference.speed_factor` does it for one.

    Args:
        profile: Speed factor against time.
        time: [s], shape (times,).
    """
    t, s = profile.time, profile.factor
    place = np.searchsorted(t, time, side="right") - 1
    i = np.maximum(place, 0)
    slopes = np.append(np.diff(s) / np.diff(t), 0.0)
    slope = np.where(place < 0, 0.0, slopes[i])
    elapsed = time - t[i]
    factor = s[i] + slope * elapsed
    return factor, slope, profile.travel[i] + 0.5 * (s[i] + factor) * elapsed
