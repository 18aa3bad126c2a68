"""Accuracy: what is left of a run's error, measured on the whole run beside the same run at another pace."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats, Ints
from gearwright.dynamics.codegen import address
from gearwright.dynamics.codegen.loops import at, library, packed
from gearwright.dynamics.motion.record import Apart
from gearwright.dynamics.motion.steps import MARGIN, RMS_SHARE, Accuracy

SMOOTH = 4
"""Order of the error of smooth motions: that of the steps."""
SECOND = 2
"""Order of implicit steps."""
PARTING = 1
"""Order where teeth part or touch inside a step: by steps of second, but one step may meet them and the next not."""
CHAOTIC = 0
"""Motions that part from their neighbours: no step brings two runs together, and what they differ by is the error."""
CAUTION = 4.0
"""What the error by the order is multiplied by, since peaks are met by chance and orders hold in the limit [-]."""
NEGLIGIBLE = 1e-2
"""Share of the largest force of its kind below which a line's force is judged beside that share [-]."""
CHANCE = 0.04
"""Share of the error of peaks below which that of a root mean square is not told: two of them agree by chance [-].

A peak is not told to be nearer than the root mean square, for the same reason.
"""
UNRELATED = 0.25
"""The same of chaotic motions, whose two runs see different parts of what the motion does [-]."""
SENSITIVE = 0.1
"""Distance of two runs of one motion on the way, over what its deflection covers, from which they count as parted [-].

Among 1000 random runs with impacts it is below 0.02, or about 1.
"""
REFINED = 4
"""Times that a run is repeated at a finer pace."""
PARTED_REFINED = 2
"""The same of a motion whose runs part on the way: two follow each other once the step is small enough, or never do."""
COARSER = 2.0
"""Pace of the run beside the first one, over its own [-]."""


class Forces(NamedTuple):
    """What is promised of the line forces; arrays of shape (…, lines)."""

    peak: Floats
    """Largest absolute value [N or N m]."""
    rms: Floats
    """Root mean square [N or N m]."""
    between: Floats
    """By how much the peak between steps may be larger [N or N m]."""
    ends: Floats
    """By how much the one that is told differs from it: sums over steps begin and end with whole ones [N or N m]."""


class Error(NamedTuple):
    """Largest error of all lines."""

    peak: float
    """Of the peak force over it [-]."""
    rms: float
    """Of the root mean square over it [-]."""

    def over(self, asked: Accuracy) -> float:
        """Return the error over the one that is asked for [-]: at most 1 if it holds.

        Args:
            asked: Of peaks, and a tenth of it of root mean squares.
        """
        return max(self.peak, self.rms / RMS_SHARE) / asked.value

    def least(self, other: Error | Apart) -> Error:
        """Return the error, or what else is known of it where that is larger.

        Args:
            other: Of peaks and of root mean squares.
        """
        return Error(max(self.peak, other[0]), max(self.rms, other[1]))

    def plus(self, other: Error) -> Error:
        """Return the sum of two errors.

        Args:
            other: Of another cause.
        """
        return Error(self.peak + other.peak, self.rms + other.rms)

    def words(self) -> str:
        """Return the error as a note says it."""
        return f"peaks of line forces are right to {self.peak:.1e}, their root mean squares to {self.rms:.1e}"


EXACT = Error(0.0, 0.0)
"""None."""


class Compared(NamedTuple):
    """What runs promise beside what others do, for translated Python; forces are the parts of `Forces` in one array."""

    runs: int
    lines: int
    kinds: int
    kind: Ints
    """Of each line: forces are compared with those of their kind."""
    forces: Floats
    """Shape (4, runs, lines)."""
    other: Floats
    scale: Floats
    """What the parts of errors are taken of, shape (2, runs, lines)."""
    largest: Floats
    """Room for the largest of each kind, shape (kinds,)."""
    errors: Floats
    """Largest of all lines, of peaks and of root mean squares, shape (2, runs)."""


def measure(c: Compared) -> None:
    """Fill in what errors are taken of: peaks, root mean squares, or a share of the largest of their kind."""
    for row in range(2 * c.runs):
        force, scale = at(c.forces, row * c.lines), at(c.scale, row * c.lines)
        for kind in range(c.kinds):
            c.largest[kind] = 0.0
        for j in range(c.lines):
            c.largest[c.kind[j]] = max(c.largest[c.kind[j]], force[j])
        for j in range(c.lines):
            scale[j] = max(force[j], NEGLIGIBLE * c.largest[c.kind[j]])


def over(part: float, whole: float) -> float:
    """Return a ratio, zero where there is nothing."""
    if whole > 0.0:
        return part / whole
    return 0.0


def compare(c: Compared, share: float) -> None:
    """Fill in the largest errors of all lines."""
    measure(c)
    room = c.runs * c.lines
    for run in range(c.runs):
        mine, its, scale = at(c.forces, run * c.lines), at(c.other, run * c.lines), at(c.scale, run * c.lines)
        worst, swollen = 0.0, 0.0
        for j in range(c.lines):
            moved, swell = abs(mine[j] - its[j]), abs(mine[room + j] - its[room + j])
            alike = min(moved, over(swell * mine[j], mine[room + j]))
            peak = share * alike + max(share, 1.0) * (moved - alike) + mine[2 * room + j]
            worst = max(worst, over(peak, scale[j]))
            swollen = max(swollen, over(share * swell + mine[3 * room + j], scale[room + j]))
        c.errors[run] = worst
        c.errors[c.runs + run] = swollen


def errors_of(forces: Forces, other: Forces, units: Sequence[str], *, ratio: float, order: int) -> list[Error]:
    """Return the errors of runs, one for each row of their forces.

    An amplitude that a step damps or shifts moves peak and root mean square alike, by its order. What a peak moves by
    beyond that is of oscillations that met at another instant; it follows no order and counts whole.

    Args:
        forces: Of runs, shape (runs, lines).
        other: Of the same runs at another pace.
        units: Of the deflection of each line: forces are compared with those of their kind.
        ratio: The other pace's step over that of the run [-].
        order: Power of the step that the error follows.
    """
    share = CAUTION / abs(ratio**order - 1.0) if order else CAUTION
    compared = _compared("compare", forces, other, units, share)
    chance = CHANCE if order else UNRELATED
    return [Error(max(peak, rms), max(rms, chance * peak)) for peak, rms in compared.errors.T.tolist()]


def apart(forces: Forces, other: Forces, units: Sequence[str]) -> Floats:
    """Return what peaks and root mean squares of runs differ by from those of others over them, shape (2, runs, lines).

    Args:
        forces: Of runs, shape (runs, lines).
        other: Of other runs of the same.
        units: Of the deflection of each line.
    """
    compared = _compared("measure", forces, other, units)
    moved, scale = np.abs(compared.forces[:2] - compared.other[:2]), compared.scale
    return np.divide(moved, scale, out=np.zeros_like(scale), where=scale > 0.0)


def _compared(function: str, forces: Forces, other: Forces, units: Sequence[str], *given: float) -> Compared:
    """Return runs beside others, as a function has filled them in."""
    kind, kinds = _kinds(tuple(units))
    mine, its = np.array(forces), np.array(other)
    _, runs, lines = mine.shape
    scale, largest, errors = np.empty((2, runs, lines)), np.empty(kinds), np.empty((2, runs))
    compared = Compared(runs, lines, kinds, kind, mine, its, scale, largest, errors)
    read = packed(compared)  # stands as long as it is read
    library(measure, over, compare).function(function)(address(read), *given)
    return compared


@lru_cache
def _kinds(units: tuple[str, ...]) -> tuple[Ints, int]:
    """Return the number of each line's kind, lines of one unit, and how many there are."""
    kinds = list(dict.fromkeys(units))
    return np.array([kinds.index(unit) for unit in units], dtype=np.int64), len(kinds)


def parted(apart: Apart) -> str:
    """Return what the reader of a motion must know whose runs part on the way, though its end draws neighbours in.

    Args:
        apart: How far.
    """
    return (
        f"sensitive: runs of this motion at two steps part on the way, by {100.0 * apart.most:.0f} % of what the "
        "deflection covers; means, root mean squares and distributions of a long run hold, the waveform and single "
        "peaks are those of one motion among many"
    )


def finer(over: float, order: int) -> float:
    """Return by how much the step is to shrink [-]: a half or a quarter, so that runs look at the same instants.

    Args:
        over: Error over the one that is asked for [-].
        order: Power of the step that the error follows.
    """
    return 0.5 if over < MARGIN * 2.0**order else 0.25


def shortfall(error: Error, asked: Accuracy, why: str) -> list[str]:
    """Return the note of a result whose error is larger than asked for; nothing of one that holds.

    Args:
        error: Measured.
        asked: For.
        why: It was not brought down.
    """
    if error.over(asked) <= 1.0:
        return []
    return [f"{error.words()}; asked were {asked.value:.1e} and {RMS_SHARE * asked.value:.1e}: {why}"]


REPEATED = f"{REFINED} repetitions at finer steps did not bring it down; contact that comes and goes converges slowly"
"""Why a result falls short that was not given its step."""
GIVEN = "the step was given"
"""Why a result falls short that was."""
UNPREDICTABLE = "neighbouring motions part, so that peaks are those of one motion among many"
"""Why a chaotic or sensitive one does."""
STOPPED = "the run was interrupted"
"""Why one does that was stopped."""
