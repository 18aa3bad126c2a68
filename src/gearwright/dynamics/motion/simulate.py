"""Simulate: a system's motion over a stretch of time."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Literal, NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.equations import WORKS, Work, statics, stored_energy, unbalanced
from gearwright.dynamics.model import Arrays, System, check_finite, refuse_not_finite
from gearwright.dynamics.motion.record import BLOCK, Outputs, Recorder, Samples, Trace
from gearwright.dynamics.motion.sensitivity import PARTED, parting
from gearwright.dynamics.motion.steps import (
    ADAPTIVE,
    METHODS,
    STRETCH,
    Accuracy,
    Pace,
    Stepper,
    blank_record,
    check_duration,
    default_step,
    estimated_error,
    excited_step,
    fastest_rate,
    is_exact,
    pace_of,
    stepper,
)
from gearwright.dynamics.motion.touching import slack_lines
from gearwright.errors import DesignError, Problem, near
from gearwright.verbs import verb

LARGEST_GENERATED = 250
"""Lines up to which code is generated for the structure: beyond, generating it takes seconds."""
STIFF = 2.5e6
"""Fastest rate above which implicit steps may pay [rad/s]."""
STIFF_GAIN = 40.0
"""How much longer an implicit step must be, since it costs so much more than an explicit one [-]."""

Start = Literal["static", "rigid"] | tuple[Floats, Floats]


class Ran(NamedTuple):
    """How a run went."""

    method: str
    """Kind of its steps."""
    pace: Pace
    """Their size."""
    error: float
    """Estimated [-]."""
    notes: tuple[str, ...]
    """What a reader should know of it."""


@verb
def simulate(
    system: System,
    duration: float,
    *,
    method: str = "auto",
    step: float | Accuracy | None = None,
    start: Start = "static",
    outputs: Outputs | None = None,
    progress: Callable[[float], None] | None = None,
) -> Trace:
    """Return the motion of a system, with statistics of every step, an energy balance and an error estimate.

    Args:
        system: Bodies, lines, loads.
        duration: [s].
        method: One of `METHODS`, or ``"auto"``, which says in the notes what it picked and why.
        step: [s], or an `Accuracy`; left out, from the highest harmonic and the fastest mode. Adaptive methods take
            it as the spacing of the instants that statistics and windows look at.
        start: ``"static"`` equilibrium, the ``"rigid"`` motion itself, or (q, q̇).
        outputs: What to keep.
        progress: Called with the fraction done, from 0 to 1.

    Returns:
        The trace; of what was done so far, marked and with a note, if the user interrupts. Contact loss and motions
        that part from their neighbours are noted.

    Raises:
        DesignError: Method, step, duration or outputs that cannot be.
        SolveError: If the motion diverges, with time, line and value.
    """
    check_finite(system)
    arrays = system.arrays
    method, reason = _method(arrays, method)
    state = _start(system, start)
    pace = pace_of(system, method, step, state)
    steps = check_duration(duration, pace.step)
    recorder = Recorder(system, outputs or Outputs(), step=pace.step, steps=steps)
    error = estimated_error(arrays, method, pace, steps=min(steps, STRETCH), start=state)
    first = state.copy()
    advance = stepper(arrays, method, pace.step, tolerance=pace.tolerance)
    done = _run(advance, recorder, state, progress)
    left = unbalanced(system)
    notes = [reason, *([f"at the start {left}; the train speeds up or slows down"] if left else [])]
    slack = slack_lines(system, first[: len(arrays.mass)])
    notes += [f"at the start no tooth touches: {', '.join(slack)} stand between their flanks"] if slack else []
    notes += _notes(recorder, done)
    if np.any(recorder.lost >= 0):
        notes += _sensitivity(parting(arrays, advance, done, state))
    return _trace(recorder, Ran(method, pace, error, tuple(notes)), (first, state), done)


@verb
def replay(system: System, trace: Trace, start: float, end: float) -> Samples:
    """Return every step of a part of a run, bit for bit as it was.

    Args:
        system: The system of the run.
        trace: What the run left.
        start: [s].
        end: [s].

    Raises:
        DesignError: If the part lies outside the run, or a run of adaptive steps has lost its tolerance.
    """
    if trace.method in ADAPTIVE and not trace.tolerance > 0.0:
        message = f"{trace.tolerance:g} √J; a run of {trace.method} can only be repeated at the tolerance that it had"
        raise DesignError([Problem("trace.tolerance", message)])
    steps = round(trace.duration / trace.step)
    recorder = Recorder(system, Outputs(windows=((start, end),)), step=trace.step, steps=steps)
    low, high = recorder.spans[0]
    place = int(np.searchsorted(trace.checkpoints.step, low, side="right")) - 1
    state = trace.checkpoints.state[place].copy()
    advance = stepper(system.arrays, trace.method, trace.step, tolerance=trace.tolerance)
    record = blank_record(system.arrays, BLOCK)
    for first, count in _blocks(int(trace.checkpoints.step[place]), steps):
        if first >= high:
            break
        recorder.take(first, record[:count], advance(first, record[:count], state))
    return recorder.samples(1)


def _blocks(first: int, steps: int) -> Iterator[tuple[int, int]]:
    """Return first step and number of rows of each block, the last instant by itself.

    Blocks are the same for whoever takes a run up: adaptive steps end where their block does.
    """
    for start in range(first, steps, BLOCK):
        yield start, min(BLOCK, steps - start)
    yield steps, 1


def _method(arrays: Arrays, method: str) -> tuple[str, str]:
    if method == "auto":
        if is_exact(arrays):
            return "exact", "exact step: constant stiffness and speed, no backlash, loads linear in speed"
        if len(arrays.stiffness) > LARGEST_GENERATED:
            return "runge-kutta generic", f"Runge–Kutta, generic code: more than {LARGEST_GENERATED} lines"
        stiff = not len(arrays.drives.table) and fastest_rate(arrays) > STIFF
        if stiff and excited_step(arrays) > STIFF_GAIN * default_step(arrays):
            return "implicit", f"implicit: modes up to {fastest_rate(arrays):.1e} rad/s, far above what excites"
        return "runge-kutta", "Runge–Kutta, generated code: stiffness, backlash or loads change with time or speed"
    if method not in METHODS:
        raise DesignError([Problem("method", f"no such method: {method}; {near(method, ('auto', *METHODS))}")])
    if method == "exact" and not is_exact(arrays):
        message = "exact needs constant stiffness and speed, no backlash, no drives, loads linear in speed; use auto"
        raise DesignError([Problem("method", message)])
    if method == "implicit" and len(arrays.drives.table):
        raise DesignError([Problem("method", "implicit steps do not carry the states of drives; use runge-kutta")])
    return method, f"{method}: asked for"


def _start(system: System, start: Start) -> Floats:
    size = len(system.arrays.mass)
    state = np.concatenate([np.zeros(2 * size + WORKS), system.arrays.drives.start])
    if start == "static":
        state[:size] = statics(system, balance="accelerate").position
    elif start != "rigid":
        parts = [np.asarray(part, dtype=float) for part in start]
        if len(parts) != 2 or any(part.shape != (size,) or not np.all(np.isfinite(part)) for part in parts):
            message = f"give (position, velocity), {size} finite numbers each, or 'static' or 'rigid'"
            raise DesignError([Problem("start", message)])
        state[:size], state[size : 2 * size] = parts
    return state


def _run(advance: Stepper, recorder: Recorder, state: Floats, progress: Callable[[float], None] | None) -> int:
    """March block by block; return the number of steps done."""
    record = blank_record(recorder.system.arrays, BLOCK)
    # The state moves on only when its block has been taken, so that an interruption leaves the two together.
    done, ahead = 0, state.copy()
    try:
        for first, count in _blocks(0, recorder.steps):
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


def _notes(recorder: Recorder, done: int) -> list[str]:
    notes = [
        f"line {recorder.system.labels.lines[line]} first lost contact at {first * recorder.step:.6g} s"
        for line, first in zip(recorder.gaps, recorder.lost, strict=True)
        if first >= 0
    ]
    if done < recorder.steps:
        late = "; its statistics had not begun" if done <= recorder.edges[0] else ""
        notes.append(f"interrupted at {done * recorder.step:.6g} s of {recorder.steps * recorder.step:.6g} s{late}")
    return notes


def _sensitivity(growth: float) -> list[str]:
    if growth < PARTED:
        return []
    return [f"neighbouring motions part (by a factor of {growth:.0e} after the run): judge it by its statistics only"]


def _trace(recorder: Recorder, ran: Ran, ends: tuple[Floats, Floats], done: int) -> Trace:
    size, labels = recorder.size, recorder.system.labels
    moved = [*labels.coordinates, *(f"{name} (rate)" for name in labels.coordinates)]
    refuse_not_finite(ends[1][: 2 * size], moved, f"motion at {done * recorder.step:.4g} s")
    refuse_not_finite([ran.error], ["the largest force"], "error estimate")
    lines = len(labels.lines)
    return Trace(
        method=ran.method,
        step=recorder.step,
        duration=done * recorder.step,
        error=ran.error,
        work=_work(recorder, ends, done),
        samples=recorder.samples(),
        windows=tuple(recorder.samples(number) for number in range(1, 1 + len(recorder.spans))),
        force=recorder.statistics(labels.lines, size, "line"),
        deflection=recorder.statistics(labels.lines, size + lines, "line"),
        velocity=recorder.statistics(labels.coordinates, 0, "coordinate"),
        drive=recorder.statistics(labels.drives, size + 2 * lines, "drive") if labels.drives else None,
        checkpoints=recorder.checkpoints(),
        notes=ran.notes,
        labels=labels,
        tolerance=ran.pace.tolerance,
        interrupted=done < recorder.steps,
        orders=recorder.orders.result(recorder.edges) if recorder.orders else None,
    )


def _work(recorder: Recorder, ends: tuple[Floats, Floats], done: int) -> Work:
    arrays, size = recorder.system.arrays, recorder.size
    before, after = (
        stored_energy(arrays, time, state[:size], state[size : 2 * size])
        for time, state in zip((0.0, done * recorder.step), ends, strict=True)
    )
    driven, braked, dissipated, stiffness, error, frame = (float(work) for work in ends[1][2 * size : 2 * size + WORKS])
    return Work(driven, braked, dissipated, stiffness, error, frame, after - before, after)
