"""Marching: one pass over a stretch of time at one pace, block by block."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.model import System
from gearwright.dynamics.motion.accuracy import Forces
from gearwright.dynamics.motion.record import BLOCK, Outputs, Recorder
from gearwright.dynamics.motion.steps import Pace, Stepper, blank_record, check_duration, stepper


class Pass(NamedTuple):
    """One pass."""

    method: str
    """Of its steps."""
    pace: Pace
    """Its steps."""
    advance: Stepper
    """What took them."""
    recorder: Recorder
    """What was kept."""
    start: Floats
    """q, q̇ and works at the start."""
    end: Floats
    """And at the end."""
    done: int
    """Steps: fewer than asked if it was interrupted."""

    @property
    def interrupted(self) -> bool:
        """Whether the user stopped it."""
        return self.done < self.recorder.steps

    @property
    def forces(self) -> Forces:
        """What is promised of the line forces, over all bins, shape (1, lines); zeros before any."""
        recorder = self.recorder
        low, high, square = recorder.line_extremes()
        length = np.diff(recorder.edges)[:, None] * self.pace.step
        if not len(length):
            return Forces(*np.zeros((4, 1, low.shape[1])))
        square = np.add.reduce(square) * (self.pace.step / np.add.reduce(length))
        extremes = np.maximum.reduce(np.maximum(np.abs(low), np.abs(high)))
        # The sum over steps counts the first instant whole and the last not at all; each should count half.
        ends = (recorder.last_force**2 - recorder.first_force**2) / (2.0 * float(np.sum(length)) / self.pace.step)
        rms = np.sqrt(np.maximum(square + ends, 0.0))
        late = abs(float(recorder.edges[0]) * self.pace.step - recorder.outputs.start) / float(np.sum(length))
        missed = late * np.maximum(extremes**2 - square, square) / np.maximum(2.0 * rms, 1e-300)
        between = np.maximum(recorder.between.bound - extremes, 0.0)
        return Forces(extremes[None], rms[None], between[None], (np.abs(rms - np.sqrt(square)) + missed)[None])


def marched(
    system: System, method: str, pace: Pace, duration: float, *, start: Floats, outputs: Outputs,
    progress: Callable[[float], None] | None = None,
) -> Pass:  # fmt: skip
    """Return one pass over a stretch of time.

    Args:
        system: Bodies, lines, loads.
        method: One of `METHODS`.
        pace: How finely.
        duration: [s].
        start: q, q̇ and works; kept as it is.
        outputs: What to keep.
        progress: Called with the fraction done.
    """
    steps = check_duration(duration, pace.step)
    recorder = Recorder(system, outputs, step=pace.step, steps=steps)
    advance, state = stepper(system.arrays, method, pace.step, tolerance=pace.tolerance), start.copy()
    done = _run(advance, recorder, state, progress)
    return Pass(method, pace, advance, recorder, start, state, done)


def blocks(first: int, steps: int) -> Iterator[tuple[int, int]]:
    """Return first step and number of rows of each block, the last instant by itself.

    Blocks are the same for whoever takes a run up: adaptive steps end where their block does.

    Args:
        first: Step of the first row, a multiple of `BLOCK`.
        steps: Of the whole run.
    """
    for start in range(first, steps, BLOCK):
        yield start, min(BLOCK, steps - start)
    yield steps, 1


def _run(advance: Stepper, recorder: Recorder, state: Floats, progress: Callable[[float], None] | None) -> int:
    """March block by block; return the number of steps done."""
    record = blank_record(recorder.system.arrays, BLOCK)
    # The state moves on only when its block has been taken, so that an interruption leaves the two together.
    done, ahead = 0, state.copy()
    try:
        for first, count in blocks(0, recorder.steps):
            recorder.checkpoint(first, state)
            recorder.take(first, record[:count], advance(first, record[:count], ahead))
            if first == recorder.steps:
                break
            done += count
            state[:] = ahead
            if progress is not None:
                progress(done / recorder.steps)
    except KeyboardInterrupt:
        if done == 0:
            raise
        recorder.stop(done)
    return done
