"""Clock table: what time alone decides, for every half step of a block."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.dynamics.system import Arrays, Floats, Profile

Clock = Callable[[int, Floats], None]
"""(first step, table) fills the rows: cosine and sine of each tone, s, ṡ, scheduled loads; a row for each half step."""


class Harmonic(NamedTuple):
    """How a tone's wave is made."""

    tone: int
    """Its number."""
    below: int
    """A slower tone, or -1: then by cosine and sine."""
    again: int
    """The tone that is added to it."""


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
    harmonics = _harmonics(arrays.tone_rate)
    return lambda first, table: _ramped(arrays, harmonics, _times(first, h, len(table)), table)


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


def _ramped(arrays: Arrays, harmonics: Sequence[Harmonic], time: Floats, table: Floats) -> None:
    tones = len(arrays.tone_rate)
    factor, slope, travel = speed_factors(arrays.profile, time)
    waves = table[:, : 2 * tones].view(np.complex128)
    for tone, below, again in harmonics:
        if below < 0:
            angle = arrays.tone_rate[tone] * travel
            np.cos(angle, out=table[:, 2 * tone])
            np.sin(angle, out=table[:, 2 * tone + 1])
        else:
            np.multiply(waves[:, below], waves[:, again], out=waves[:, tone])
    table[:, 2 * tones], table[:, 2 * tones + 1] = factor, slope
    _loads(arrays, time, table)


def _harmonics(rates: Floats) -> list[Harmonic]:
    """Return how each tone is made: a harmonic is the product of two slower tones whose rates add up to its own."""
    found, made = list[Harmonic](), list[int]()
    for tone in (int(each) for each in np.argsort(np.abs(rates), kind="stable")):
        sums = (
            (one, two) for one in made for two in made if np.isclose(rates[one] + rates[two], rates[tone], 1e-14, 0)
        )
        found.append(Harmonic(tone, *next(sums, (-1, -1))))
        made.append(tone)
    return found


def _loads(arrays: Arrays, time: Floats, table: Floats) -> None:
    column = 2 * len(arrays.tone_rate) + 2
    for schedules in (arrays.loads.schedules, arrays.drives.inputs):
        for number in range(len(schedules.dof)):
            part = slice(schedules.start[number], schedules.start[number + 1])
            points, values = schedules.time[part], schedules.value[part]
            constant = len(points) == 1 or time[0] >= points[-1] or time[-1] <= points[0]
            # Held values need no look-up, and most loads are held most of the time.
            held = values[-1] if time[0] >= points[-1] else values[0]
            table[:, column] = held if constant else np.interp(time, points, values)
            column += 1


def speed_factors(profile: Profile, time: Floats) -> tuple[Floats, Floats, Floats]:
    """Return s [-], ṡ [1/s] and τ [s] at many times; `reference.speed_factor` does it for one.

    Args:
        profile: Speed factor against time.
        time: Rising [s], shape (times,).
    """
    t, s = profile.time, profile.factor
    factor, slope, travel = np.empty((3, len(time)))
    first, last = (int(np.searchsorted(t, each, side="right")) - 1 for each in (time[0], time[-1]))
    cuts = [0, *np.searchsorted(time, t[first + 1 : last + 1]).tolist(), len(time)]
    for piece, (low, high) in zip(range(first, last + 1), pairwise(cuts), strict=True):
        i = max(piece, 0)
        elapsed = time[low:high] - t[i]
        rate = (s[i + 1] - s[i]) / (t[i + 1] - t[i]) if 0 <= piece < len(t) - 1 else 0.0
        factor[low:high], slope[low:high] = s[i] + rate * elapsed, rate
        travel[low:high] = profile.travel[i] + 0.5 * (s[i] + factor[low:high]) * elapsed
    return factor, slope, travel
