"""Transient simulation of a system: initial conditions, tooth contact at the start, and sensitivity."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import lru_cache
from typing import Literal, NamedTuple

import numpy as np

from gearwright.base import (
    DesignError,
    Floats,
    Ints,
    Problem,
    SolveError,
    near,
    one_blas_thread,
    place_of_largest,
    verb,
)
from gearwright.dynamics.equations import (
    WORKS,
    Work,
    damped_rates,
    errors_at,
    line_forces,
    redundancy,
    statics,
    unbalanced,
)
from gearwright.dynamics.model import (
    Arrays,
    System,
    along_lines,
    check_finite,
    kept,
    plan_of,
    planned,
    refuse_not_finite,
)
from gearwright.dynamics.motion.exact import is_exact
from gearwright.dynamics.motion.marching import (
    CHAOTIC,
    COARSER,
    GIVEN,
    PARTED_REFINED,
    PARTING,
    REFINED,
    REPEATED,
    SECOND,
    SENSITIVE,
    SMOOTH,
    STOPPED,
    UNPREDICTABLE,
    Error,
    Pass,
    blocks,
    errors_of,
    finer,
    marched,
    parted,
    shortfall,
    stored_energy,
)
from gearwright.dynamics.motion.record import BLOCK, TOGETHER, Apart, Outputs, Recorder, Samples, Trace, line_numbers
from gearwright.dynamics.motion.steps import (
    ADAPTIVE,
    METHODS,
    Accuracy,
    Stepper,
    blank_record,
    damping_bound,
    default_step,
    excited_step,
    fastest_rate,
    may_take,
    pace_of,
    stepper,
    whole_step,
)
from gearwright.dynamics.motion.taking import RUNAWAY

# ----------------------------------------------------------------------------------------------------------------------
# Standing: the static equilibrium that runs begin from, and what of a system never comes to rest.
# ----------------------------------------------------------------------------------------------------------------------


UNDAMPED = 1e-9
"""Damping ratio below which a mode has none but that of rounding [-]."""


def equilibrium(system: System) -> Floats:
    """Return q in static equilibrium; loads that do not balance speed it up.

    Args:
        system: Bodies, lines, loads.

    Raises:
        SolveError: If a line would carry more than any gear comes near, with the line and its load.
    """
    found = kept(system.arrays, (statics,), lambda: statics(system, balance="accelerate"))
    place = place_of_largest(np.abs(found.force)) if len(found.force) else -1
    if place >= 0 and not abs(found.force[place]) < RUNAWAY:
        line, force = system.labels.lines[place], found.force[place]
        raise SolveError(
            f"the loads press line {line} with {force:.3g} before anything moves; at most {RUNAWAY:.0e} N or N m can "
            "be followed: look at the units of the loads"
        )
    return found.position


@planned
def endless(arrays: Arrays, width: float) -> list[str]:
    """Return what to say of modes without damping that a tone meets: their force grows as long as the run lasts.

    Args:
        arrays: The system's numbers.
        width: Distance of a mode from a tone below which they meet [rad/s].
    """
    notes = dict[str, None]()
    used = np.unique(np.concatenate([arrays.variation.tone, arrays.error.tone])).astype(int)
    if damping_bound(arrays, _slowest(arrays, used)) > UNDAMPED:  # far quicker than the modes
        return []
    for factor in {float(np.min(arrays.profile.factor)), float(np.max(arrays.profile.factor))}:
        rates = damped_rates(arrays, factor)
        for rate in rates[-rates.real < UNDAMPED * np.abs(rates)]:
            if np.any(np.abs(np.abs(arrays.tone_rate[used] * factor) - rate.imag) < width):
                hertz = rate.imag / (2.0 * np.pi)
                notes[
                    f"the mode at {hertz:.4g} Hz has no damping and is excited at its own frequency: its force grows "
                    "without end, and statistics are those of this start and this duration; give it damping"
                ] = None
    return list(notes)


def _slowest(arrays: Arrays, tones: Ints) -> float:
    """Return the slowest of some tones that turn, at the lowest speed [rad/s]; 0 without any."""
    rates = np.abs(np.outer(arrays.tone_rate[tones], arrays.profile.factor))
    return float(np.min(rates[rates > 0.0], initial=np.inf)) if np.any(rates > 0.0) else np.inf


# ----------------------------------------------------------------------------------------------------------------------
# Starts at which no tooth touches: named before anything is computed from them.
# ----------------------------------------------------------------------------------------------------------------------


NOTHING = 1e-9
"""Force of parallel lines over the largest that their stiffness and errors could give, that counts as none [-]."""
FELT = 1e-6
"""Length that the errors of a system without errors are taken as [m]."""


def slack_lines(system: System, position: Floats) -> tuple[str, ...]:
    """Return the lines with backlash if all of them stand between their flanks at time 0; else nothing.

    Args:
        system: Bodies, lines, loads.
        position: q at the start [rad or m], shape (coordinates,).
    """
    arrays = system.arrays
    play = arrays.backlash > 0.0
    deflection = along_lines(arrays, position) - errors_at(system, np.zeros(1))[0]
    open_ = (deflection < 0.0) & (deflection > -arrays.backlash)
    if not np.any(play) or not np.all(open_[play]):
        return ()
    return tuple(name for name, has in zip(system.labels.lines, play, strict=True) if has)


def check_shared_load(system: System, lines: Sequence[str]) -> None:
    """Refuse to share a load that is not there.

    Args:
        system: With its loads and errors.
        lines: Names of the parallel meshes.

    Raises:
        DesignError: If the lines together carry nothing when everything is slow: no share is defined.
    """
    shared, errors = line_numbers(system, lines), errors_at(system, np.zeros(1))[0]
    train = redundancy(system)
    force = line_forces(train, errors)[shared]
    stiffness = float(np.max(system.arrays.stiffness[shared]))
    scale = stiffness * max(FELT, float(np.max(np.abs(errors[shared]))))
    if abs(float(np.sum(force))) <= NOTHING * scale:
        message = f"{', '.join(lines)} carry nothing at the start, so there is nothing to share; give the case a load"
        raise DesignError([Problem("loads", message)])


# ----------------------------------------------------------------------------------------------------------------------
# Sensitivity: whether neighbouring motions part, so that a run may be judged by its statistics only.
# ----------------------------------------------------------------------------------------------------------------------


NUDGE = 1e-9
"""Distance of the twin's lines over their largest deflection, set again after each block [-]."""
PARTED = 1e3
"""Growth of the distance between the twins beyond which the motion counts as sensitive [-]."""
BLOCKS = 60
"""Blocks over which the twins run side by side."""
TURNING = 4
"""Blocks before, in which the twin turns to where it parts fastest."""
SEEN = BLOCK // 4
"""Rows at the end of a block over which the distance is looked at."""
SURE = 3.0
"""Standard deviations of its mean above zero from which an exponent counts as positive [-]."""


class Exponent(NamedTuple):
    """Largest Lyapunov exponent of a motion."""

    value: float
    """[1/s]."""
    uncertainty: float
    """Standard deviation of its mean over blocks [1/s]."""
    growth: float
    """Of the distance between neighbours while they were watched [-]."""

    @property
    def chaotic(self) -> bool:
        """Whether neighbours part beyond doubt."""
        return self.growth >= PARTED and self.value > SURE * self.uncertainty

    @property
    def words(self) -> str:
        """What a chaotic motion's reader must know."""
        return (
            f"chaotic: neighbouring motions part by a factor of e in {1.0 / self.value:.2g} s (largest exponent "
            f"+{self.value:.2g} ± {self.uncertainty:.1g} 1/s); means, root mean squares and distributions of a run "
            "that is long beside it hold, the waveform and single peaks are those of one motion among many"
        )


def largest_exponent(arrays: Arrays, advance: Stepper, first: int, state: Floats, step: float) -> Exponent:
    """Return the largest exponent of the motion that goes on from a run's end.

    Distances are of line deflections, so that rigid motions, which drift apart steadily, do not count.

    Args:
        arrays: The system's numbers.
        advance: Its stepper.
        first: Step at which the twins part.
        state: q, q̇, works and drives' states there.
        step: [s].

    Source: Benettin, Galgani, Giorgilli, Strelcyn 1980, Meccanica 15, 9-20: the twin is brought back after each block.
    """
    size, lines = len(arrays.mass), len(arrays.stiffness)
    twins, records = [state.copy(), state.copy()], [blank_record(arrays, BLOCK) for _ in range(2)]
    works, columns = slice(2 * size, 2 * size + WORKS), slice(2 * size + lines, 2 * (size + lines))
    growths = []
    for block in range(BLOCKS + TURNING):
        for twin, record in zip(twins, records, strict=True):
            advance(first + block * BLOCK, record, twin)
        if block == 0:
            scale = np.max(np.abs(records[0][:, columns]), axis=0)
            reach = np.max(np.abs(records[0][:, :size]), axis=0)
            twins[1][:size] += NUDGE * reach * np.random.default_rng(0).uniform(0.5, 1.0, size)
            continue
        apart = np.abs(records[1][-SEEN:, columns] - records[0][-SEEN:, columns])
        distance = float(np.max(np.divide(apart, scale, out=np.zeros_like(apart), where=scale > 0.0)))
        if not distance > 0.0:
            return Exponent(-np.inf, 0.0, 0.0)
        growths.append(np.log(distance / NUDGE))
        own = twins[1][works].copy()
        twins[1] = twins[0] + (twins[1] - twins[0]) * NUDGE / distance
        twins[1][works] = own
    growths, time = growths[TURNING:], BLOCK * step
    spread = float(np.std(growths)) / len(growths) ** 0.5
    return Exponent(float(np.mean(growths)) / time, spread / time, float(np.exp(min(np.sum(growths), 700.0))))


# ----------------------------------------------------------------------------------------------------------------------
# Simulate: a system's motion over a stretch of time.
# ----------------------------------------------------------------------------------------------------------------------


LARGEST_GENERATED = 250
"""Lines up to which code is generated for the structure whatever the run: a quarter of a second."""
WORTH_GENERATING = 15_000
"""Steps of a run from which code is generated for more lines: a line takes 1 ms to compile and saves 80 ns a step."""
LARGEST_COMPILED = 5000
"""Lines beyond which none is generated: it would take more than five seconds and gigabytes."""
STIFF = 2.5e6
"""Fastest rate above which implicit steps may pay [rad/s]."""
STIFF_GAIN = 40.0
"""How much longer an implicit step must be, since it costs so much more than an explicit one [-]."""

LEAST_STEPS = 16
"""Steps from which a run is compared with a coarser one [-]."""

USUAL = Outputs()
"""What is kept of a run where nothing is asked for."""

Start = Literal["static", "rigid"] | tuple[Floats, Floats]


class Ran(NamedTuple):
    """How a run went."""

    method: str
    """Kind of its steps."""
    error: Error
    """Measured."""
    exponent: Exponent | None
    """Of a motion whose teeth part."""
    notes: tuple[str, ...]
    """What a reader should know of it."""


@verb
@one_blas_thread()
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
    """Return the motion of a system, with statistics of every step, an energy balance and its measured error.

    A second run at another step measures the error of peaks and root mean squares over the whole run; if it is more
    than was asked, the run is repeated at finer steps, `REFINED` times at most, and what then falls short is noted.

    Args:
        system: Bodies, lines, loads.
        duration: [s].
        method: One of `METHODS`, or ``"auto"``, which says in the notes what it picked and why.
        step: [s], taken as it is, or an `Accuracy`; left out, peaks of line forces to 1 %, root mean squares to
            0.1 %. Adaptive methods take a number as the spacing of the instants that statistics and windows look at.
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
    system = replace(system, arrays=plan_of(system.arrays))
    kept(system.arrays, (check_finite,), lambda: check_finite(system))
    method, reason = _method(system.arrays, method, _steps(system.arrays, step, duration))
    state, outputs = _start(system, start), outputs or USUAL
    pace = pace_of(system, method, step, state)
    if step is None or isinstance(step, Accuracy):
        pace = pace._replace(step=whole_step(duration, pace.step))
    run = marched(system, method, pace, duration, start=state, outputs=outputs, progress=progress)
    run, error, exponent, short = _verified(run, step, duration, progress)
    left, slack = _standing(system, state[: len(system.arrays.mass)])
    notes = [reason, *short]
    notes += endless(system.arrays, 2.0 * np.pi / duration)
    notes += [f"at the start {left}; the train speeds up or slows down"] if left else []
    notes += [f"at the start no tooth touches: {', '.join(slack)} stand between their flanks"] if slack else []
    return _trace(run, Ran(method, error, exponent, (*notes, *_notes(run))))


def _standing(system: System, position: Floats) -> tuple[str, tuple[str, ...]]:
    """Return what the loads leave over at the start, in words, and the lines of a start at which no tooth touches."""
    names = system.labels.coordinates, system.labels.lines
    left = kept(system.arrays, (unbalanced, *names), lambda: unbalanced(system))
    slack = kept(system.arrays, (slack_lines, *names, position.tobytes()), lambda: slack_lines(system, position))
    return left, slack


def _verified(
    run: Pass, step: float | Accuracy | None, duration: float, progress: Callable[[float], None] | None
) -> tuple[Pass, Error, Exponent | None, list[str]]:
    """Return a run as accurate as asked, or as near as repetitions bring it, its error and what to say of it.

    A chaotic or sensitive one is repeated once, since steps that are too large may alone be what makes it so, or not;
    no step brings two runs of it together, so that what any two differ by counts.
    """
    asked = step if isinstance(step, Accuracy) else Accuracy()
    system, outputs, units = run.recorder.system, run.recorder.outputs, run.recorder.system.labels.line_units
    other, tried, before = _beside(run), 0, Error(0.0, 0.0)
    while True:
        exponent, apart = _exponent(run), _apart(run, other)
        order, ratio = _order(run.method, exponent, apart), other.pace.over(run.pace)
        error = errors_of(run.forces, other.forces, units, ratio=ratio, order=order)[0]
        if order == PARTING:  # root mean squares agree by chance, whole motions do not: they err by the second power
            error = error.least(Error(0.0, apart.rms / abs(ratio**SECOND - 1.0)))
        if order == CHAOTIC:
            error = before = error.least(before).least(TOGETHER if exponent and exponent.chaotic else apart)
        most = 0 if isinstance(step, float | int) or run.interrupted else _repetitions(order, exponent)
        if error.over(asked) <= 1.0 or tried >= most:
            break
        pace, other, tried = run.pace.times(finer(error.over(asked), order)), run, tried + 1
        run = marched(system, run.method, pace, duration, start=run.start, outputs=outputs, progress=progress)
    why = STOPPED if run.interrupted else UNPREDICTABLE if order == CHAOTIC else REPEATED if most else GIVEN
    told = [exponent.words] if exponent and exponent.chaotic else [parted(apart)] if order == CHAOTIC else []
    return run, error, exponent, [*told, *shortfall(error, asked, why)]


def _repetitions(order: int, exponent: Exponent | None) -> int:
    """Return how often a run may be repeated at a finer pace."""
    chaotic = exponent is not None and exponent.chaotic
    return 1 if chaotic else PARTED_REFINED if order == CHAOTIC else REFINED


def _apart(run: Pass, other: Pass) -> Apart:
    """Return how far two runs are from each other on the way, where teeth part."""
    return run.recorder.marks.apart(other.recorder.marks) if np.any(run.recorder.lost >= 0) else TOGETHER


def _exponent(run: Pass) -> Exponent | None:
    """Return how fast neighbours part where teeth do; else their distance follows from the modes' damping."""
    if not np.any(run.recorder.lost >= 0):
        return None
    return largest_exponent(run.recorder.system.arrays, run.advance, run.done, run.end, run.pace.step)


def _order(method: str, exponent: Exponent | None, apart: Apart) -> int:
    """Return the power of the step that the error follows."""
    if exponent is not None:
        return CHAOTIC if exponent.chaotic or apart.most > SENSITIVE else PARTING
    return SECOND if method == "implicit" else SMOOTH


def _beside(run: Pass) -> Pass:
    """Return the same run at another pace: a coarser one if that can be taken, else a finer."""
    recorder, method = run.recorder, run.method
    system, span = recorder.system, run.done * run.pace.step
    outputs = _statistics_from(float(recorder.edges[0]) * run.pace.step)
    if run.done >= LEAST_STEPS and may_take(system.arrays, method, run.pace.times(COARSER)):
        with contextlib.suppress(SolveError, DesignError):  # too coarse for its motion or its statistics
            return marched(system, method, run.pace.times(COARSER), span, start=run.start, outputs=outputs)
    outputs = outputs if outputs.start < span else _statistics_from(0.0)
    return marched(system, method, run.pace.times(1.0 / COARSER), span, start=run.start, outputs=outputs)


@lru_cache
def _statistics_from(start: float) -> Outputs:
    """Return what is kept of a run that another is compared with."""
    return Outputs(samples=2, start=start)


@verb
@one_blas_thread()
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
    low, high = recorder.frame.stretches[1].start, recorder.frame.stretches[1].stop
    place = int(np.searchsorted(trace.checkpoints.step, low, side="right")) - 1
    state = trace.checkpoints.state[place].copy()
    advance = stepper(system.arrays, trace.method, trace.step, tolerance=trace.tolerance)
    for first, count in blocks(int(trace.checkpoints.step[place]), steps):
        if first >= high:
            break
        advance(first, recorder.record[:count], state)
        recorder.take(first, count)
    return recorder.samples(1)


def _steps(arrays: Arrays, step: float | Accuracy | None, duration: float) -> float:
    """Return about how many explicit steps a run would take [-]; asked of large systems alone."""
    if len(arrays.stiffness) <= LARGEST_GENERATED:
        return 0.0
    asked = step if isinstance(step, Accuracy) else Accuracy()
    return duration / (step if isinstance(step, float | int) and step > 0.0 else default_step(arrays, asked))


def _method(arrays: Arrays, method: str, steps: float) -> tuple[str, str]:
    if method == "auto":
        if is_exact(arrays):
            return "exact", "exact step: constant stiffness and speed, no backlash, loads linear in speed"
        lines = len(arrays.stiffness)
        if lines > LARGEST_COMPILED or (lines > LARGEST_GENERATED and steps < WORTH_GENERATING):
            much = f"{lines} lines, above {LARGEST_COMPILED}, take too long to compile"
            brief = f"{lines} lines and fewer than {WORTH_GENERATING} steps: code of their own would not pay"
            return "runge-kutta generic", f"Runge–Kutta, generic code: {much if lines > LARGEST_COMPILED else brief}"
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
        state[:size] = equilibrium(system)
    elif start != "rigid":
        parts = [np.asarray(part, dtype=float) for part in start]
        if len(parts) != 2 or any(part.shape != (size,) or not np.all(np.isfinite(part)) for part in parts):
            message = f"give (position, velocity), {size} finite numbers each, or 'static' or 'rigid'"
            raise DesignError([Problem("start", message)])
        state[:size], state[size : 2 * size] = parts
    return state


def _notes(run: Pass) -> list[str]:
    recorder, done = run.recorder, run.done
    notes = [
        f"line {recorder.system.labels.lines[line]} first lost contact at {first * recorder.step:.6g} s"
        for line, first in zip(recorder.frame.gaps, recorder.lost, strict=True)
        if first >= 0
    ]
    if done < recorder.steps:
        late = "; its statistics had not begun" if done <= recorder.edges[0] else ""
        notes.append(f"interrupted at {done * recorder.step:.6g} s of {recorder.steps * recorder.step:.6g} s{late}")
    return notes


def _trace(run: Pass, ran: Ran) -> Trace:
    recorder, done = run.recorder, run.done
    size, labels = recorder.size, recorder.system.labels
    moved = [*labels.coordinates, *(f"{name} (rate)" for name in labels.coordinates)]
    refuse_not_finite(run.end[: 2 * size], moved, f"motion at {done * recorder.step:.4g} s")
    refuse_not_finite(ran.error, ["peaks", "root mean squares"], "error")
    lines = len(labels.lines)
    return Trace(
        method=ran.method,
        step=recorder.step,
        duration=done * recorder.step,
        error=ran.error.peak,
        rms_error=ran.error.rms,
        exponent=None if ran.exponent is None else ran.exponent.value,
        work=_work(run),
        samples=recorder.samples(),
        windows=tuple(recorder.samples(number) for number in range(1, len(recorder.tables))),
        force=recorder.statistics(labels.lines, size, "line"),
        deflection=recorder.statistics(labels.lines, size + lines, "line"),
        velocity=recorder.statistics(labels.coordinates, 0, "coordinate"),
        drive=recorder.statistics(labels.drives, size + 2 * lines, "drive") if labels.drives else None,
        checkpoints=recorder.checkpoints(),
        notes=ran.notes,
        labels=labels,
        tolerance=run.pace.tolerance,
        interrupted=run.interrupted,
        orders=recorder.orders.result(recorder.edges) if recorder.orders else None,
    )


def _work(run: Pass) -> Work:
    arrays, size = run.recorder.system.arrays, run.recorder.size
    before = stored_energy(arrays, 0.0, run.start)
    after = stored_energy(arrays, run.done * run.pace.step, run.end)
    driven, braked, dissipated, stiffness, error, frame = run.end[2 * size : 2 * size + WORKS].tolist()
    return Work(driven, braked, dissipated, stiffness, error, frame, after - before, after)
