"""Marching: one pass over a stretch of time at one pace, many blocks at a time in compiled code."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.codegen import CLOCK, Clocked, address, set_clock, unturned
from gearwright.dynamics.codegen.loops import at, call, library
from gearwright.dynamics.model import System
from gearwright.dynamics.motion.accuracy import Forces
from gearwright.dynamics.motion.record import BLOCK, TAKE, Outputs, Recorder, Taking, take
from gearwright.dynamics.motion.steps import Pace, Stepper, check_duration, generated_run, stepper
from gearwright.signals import answered

TOGETHER = 32
"""Blocks that are marched over before Python looks whether the user stops the run, or wants to know how far it is."""


class Pass(NamedTuple):
    """One pass."""

    method: str
    """Of its steps."""
    pace: Pace
    """Its steps."""
    recorder: Recorder
    """What was kept."""
    start: Floats
    """q, q̇ and works at the start."""
    end: Floats
    """And at the end."""
    done: int
    """Steps: fewer than asked if it was interrupted."""

    @property
    def advance(self) -> Stepper:
        """What takes its steps."""
        return stepper(self.recorder.system.arrays, self.method, self.pace.step, tolerance=self.pace.tolerance)

    @property
    def interrupted(self) -> bool:
        """Whether the user stopped it."""
        return self.done < self.recorder.steps

    @property
    def forces(self) -> Forces:
        """What is promised of the line forces, over all bins, shape (1, lines); zeros before any."""
        return Forces(*self.recorder.promised())


class Course(NamedTuple):
    """What takes the steps of a run by generated code."""

    code: int
    """Address of what advances a block."""
    numbers: Floats
    """Its parameters."""
    turn: Floats
    """By which the tones of a block are turned."""
    state: Floats
    """q, q̇, works and drives' states after the steps that are done."""
    ahead: Floats
    """The same after a block that has not been taken yet."""
    length: int
    """Numbers in a state."""
    points: Floats
    """States before every so many steps, shape (points, length)."""
    spacing: int
    """Those steps."""
    done: Floats
    """Steps that are done, shape (1,)."""


def march(m: Course, t: Clocked, c: Taking, first: int, stop: int) -> int:
    """March block by block; say how the last one was, as `take` does."""
    while first < stop:
        count = max(min(BLOCK, c.steps - first), 1)
        if first % m.spacing == 0:
            kept = at(m.points, first // m.spacing * m.length)
            for i in range(m.length):
                kept[i] = m.state[i]
        set_clock(t, m.turn, first, count)
        call(m.code, count, m.numbers, m.numbers, t.table, m.turn, m.ahead, c.record)
        found = take(c, first, count)
        if found:
            return found
        if first == c.steps:
            return 0
        for i in range(m.length):
            m.state[i] = m.ahead[i]
        first += count
        m.done[0] = first
    return 0


def _march() -> Callable[..., int]:
    """Return the compiled `march`."""
    return library(*CLOCK, *TAKE, march).function("march")


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
    recorder, state, done = Recorder(system, outputs, step=pace.step, steps=steps), start.copy(), np.zeros(1)
    recorder.points = np.empty((steps // recorder.spacing + 1, len(start)))
    run = _generated if method == "runge-kutta" else _one_by_one
    try:
        run(recorder, method, pace, state=state, done=done, progress=progress)
    except KeyboardInterrupt:
        if done[0] == 0.0:
            raise
        answered()
    taken = int(done[0])
    kept = len(recorder.points) if taken == steps else -(-taken // recorder.spacing)
    recorder.points = recorder.points[:kept]
    recorder.finish(taken)
    return Pass(method, pace, recorder, start, state, taken)


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


def _generated(recorder: Recorder, _: str, pace: Pace, *, state: Floats, done: Floats, progress: Any) -> None:
    """March by generated code; where amplitudes of tones or progress are asked for, Python looks at every block."""
    steps, together = recorder.steps, BLOCK * (1 if recorder.orders or progress else TOGETHER)
    run, points = generated_run(recorder.system.arrays, pace.step), recorder.points
    turn, ahead = unturned(run.clock), state.copy()
    course = np.array([
        run.code, *map(address, (run.numbers, turn, state, ahead)), len(state), address(points), recorder.spacing,
        address(done),
    ])  # fmt: skip
    places, code = (address(course), address(run.given), recorder.taking.place), _march()
    for first in [*range(0, steps, together), steps]:
        found = code(*places, first, min(first + together, steps) if first < steps else steps + 1)
        if found:
            recorder.refuse(found, int(done[0]))
        if first < steps:
            recorder.count_orders(first, min(together, steps - first))
            if progress is not None:
                progress(done[0] / steps)


def _one_by_one(recorder: Recorder, method: str, pace: Pace, *, state: Floats, done: Floats, progress: Any) -> None:
    """March by a stepper in Python."""
    advance = stepper(recorder.system.arrays, method, pace.step, tolerance=pace.tolerance)
    # The state moves on only when its block has been taken, so that an interruption leaves the two together.
    ahead = state.copy()
    for first, count in blocks(0, recorder.steps):
        if first % recorder.spacing == 0:
            recorder.points[first // recorder.spacing] = state
        advance(first, recorder.record[:count], ahead)
        recorder.take(first, count)
        if first == recorder.steps:
            return
        state[:] = ahead
        done[0] = first + count
        if progress is not None:
            progress(done[0] / recorder.steps)
