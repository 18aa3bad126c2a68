"""Time integration in blocks by compiled code, stored energy, and rigid-body motion of a driven train."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from gearwright.base import Floats, Ints
from gearwright.dynamics.codegen import (
    CLOCK,
    Clocked,
    address,
    clock,
    compiled as generated,
    drive_width,
    parameters,
    set_clock,
    topology,
    unturned,
)
from gearwright.dynamics.codegen.loops import at, call, library, packed
from gearwright.dynamics.equations import WORKS, speed_factor, split_rigid
from gearwright.dynamics.model import Arrays, System, planned, profile_of
from gearwright.dynamics.motion.record import BLOCK, Apart, Outputs, Recorder
from gearwright.dynamics.motion.steps import (
    MARGIN,
    RMS_SHARE,
    Accuracy,
    Pace,
    Stepper,
    check_duration,
    generated_run,
    stepper,
)
from gearwright.dynamics.motion.taking import FUNCTIONS as TAKE, Taking, take
from gearwright.signals import answered

# ----------------------------------------------------------------------------------------------------------------------
# Accuracy: what is left of a run's error, measured on the whole run beside the same run at another pace.
# ----------------------------------------------------------------------------------------------------------------------


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
    return part / whole if whole > 0.0 else 0.0


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


# ----------------------------------------------------------------------------------------------------------------------
# Marching: one pass over a stretch of time at one pace, many blocks at a time in compiled code.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Held energy: what a system's bodies and lines hold at an instant, in translated Python.
# ----------------------------------------------------------------------------------------------------------------------


class Springs(NamedTuple):
    """Numbers of a system, as `Arrays` has them."""

    size: int
    """Coordinates."""
    lines: int
    mass: Floats
    speed: Floats
    stiffness: Floats
    backlash: Floats
    start: Ints
    """Of each line's weights, shape (lines + 1,)."""
    dof: Ints
    weight: Floats
    rate: Floats
    """Of the tones [rad/s]."""
    variation_start: Ints
    variation_tone: Ints
    variation_cosine: Floats
    variation_sine: Floats
    error_start: Ints
    error_tone: Ints
    error_cosine: Floats
    error_sine: Floats


def stored(c: Springs, factor: float, travel: float, state: Floats) -> float:
    """Return kinetic energy at absolute speed plus elastic energy [J] of (q, q̇) at a speed factor and its travel."""
    twice = 0.0
    for i in range(c.size):
        speed = c.speed[i] * factor + state[c.size + i]
        twice += c.mass[i] * speed * speed
    for j in range(c.lines):
        deflection, varied = 0.0, 1.0
        for i in range(c.start[j], c.start[j + 1]):
            deflection += c.weight[i] * state[c.dof[i]]
        for i in range(c.error_start[j], c.error_start[j + 1]):
            angle = c.rate[c.error_tone[i]] * travel
            deflection -= c.error_cosine[i] * math.cos(angle) + c.error_sine[i] * math.sin(angle)
        for i in range(c.variation_start[j], c.variation_start[j + 1]):
            angle = c.rate[c.variation_tone[i]] * travel
            varied += c.variation_cosine[i] * math.cos(angle) + c.variation_sine[i] * math.sin(angle)
        contact = max(deflection, 0.0)
        if deflection < -c.backlash[j]:
            contact = deflection + c.backlash[j]
        twice += c.stiffness[j] * varied * contact * contact
    return 0.5 * twice


def stored_energy(arrays: Arrays, time: float, state: Floats) -> float:
    """Return kinetic energy at absolute speed plus elastic energy [J].

    Args:
        arrays: The system's numbers.
        time: [s].
        state: q [rad or m] and q̇ [rad/s or m/s], shape (2 coordinates, …).
    """
    factor, _, travel = speed_factor(arrays.profile, time)
    _, place = _springs(arrays)
    return float(library(stored).function("stored")(place, factor, travel, address(state)))


@planned
def _springs(arrays: Arrays) -> tuple[Ints, int]:
    """Return the numbers as translated Python reads them, and where they stand."""
    a = arrays
    series = (*a.variation, *a.error)
    numbers = (a.mass, a.speed, a.stiffness, a.backlash, a.line_start, a.line_dof, a.line_weight, a.tone_rate, *series)
    given = packed(Springs(len(a.mass), len(a.stiffness), *numbers))
    return given, address(given)


# ----------------------------------------------------------------------------------------------------------------------
# The rigid motion of a driven train through time, in compiled code: what `rigid_pass` reads a speed profile from.
#
# The right-hand side is the structure's own generated code, behind its address; what is compiled besides is this loop.
# ----------------------------------------------------------------------------------------------------------------------


RIGID_BLOCK = 512
"""Steps between two settings of the clock."""


class Rigid(NamedTuple):
    """What the loop works with."""

    derivative: int
    """Address of the right-hand side."""
    numbers: Floats
    """Its parameters."""
    row: int
    """Numbers in a row of the clock table."""
    h: float
    """Step [s]."""
    size: int
    """Coordinates."""
    states: int
    """Of the drives."""
    past: int
    """Place of the drives' states in a state."""
    rigid: Floats
    """Rigid motion of unit mass, shape (coordinates,)."""
    mass: Floats
    state: Floats
    """(q, q̇, works, x) of a stage, with q at rest."""
    change: Floats
    """Its rate."""
    output: Floats
    """Line forces and deflections, and what the drives report."""
    motion: Floats
    """(ν, x), which is carried on."""
    inside: Floats
    """The same within a step."""
    total: Floats
    """Sum of its rates."""


def march_rigid(c: Rigid, table: Floats, count: int, speeds: Floats) -> None:
    """Carry (ν, x) on, and fill ν before each step and after the last."""
    for step in range(count):
        speeds[step] = c.motion[0]
        for i in range(c.states + 1):
            c.inside[i] = c.motion[i]
            c.total[i] = 0.0
        for stage in range(4):
            for i in range(c.size):
                c.state[c.size + i] = c.rigid[i] * c.inside[0]
            for i in range(c.states):
                c.state[c.past + i] = c.inside[1 + i]
            row = at(table, (2 * step + (stage + 1) // 2) * c.row)
            call(c.derivative, c.numbers, row, c.state, c.change, c.output)
            share = 2.0 if stage == 1 or stage == 2 else 1.0
            reach = c.h if stage == 2 else 0.5 * c.h
            for k in range(c.states + 1):
                rate = 0.0
                if k == 0:
                    for i in range(c.size):
                        rate += c.rigid[i] * c.mass[i] * c.change[c.size + i]
                else:
                    rate = c.change[c.past + k - 1]
                c.total[k] += share * rate
                c.inside[k] = c.motion[k] + reach * rate
        for i in range(c.states + 1):
            c.motion[i] += c.h / 6.0 * c.total[i]
    speeds[count] = c.motion[0]


def rigid_speeds(arrays: Arrays, rigid: Floats, h: float, steps: int) -> Floats:
    """Return ν before every step and after the last, shape (steps + 1,).

    Args:
        arrays: The system's numbers, at a constant speed factor.
        rigid: Its rigid motion, of unit mass, shape (coordinates,).
        h: Step [s].
        steps: How many.
    """
    shape, (layout, numbers) = topology(arrays), parameters(arrays, h)
    code, now = generated(shape, layout), clock(arrays, h, RIGID_BLOCK)
    size, states = len(rigid), len(arrays.drives.start)
    past, reports = 2 * size + WORKS, 2 * len(shape.lines) + drive_width(shape)
    speeds, motion = np.zeros(steps + 1), np.concatenate([[0.0], arrays.drives.start])
    table = now(0, min(RIGID_BLOCK, steps))[0]
    course = Rigid(
        code.derivative, numbers, table.shape[1], h, size, states, past, rigid, arrays.mass, np.zeros(past + states),
        np.zeros(past + states), np.zeros(reports), motion, motion.copy(), motion.copy(),
    )  # fmt: skip
    given, march = packed(course), library(march_rigid).function("march_rigid")
    for first in range(0, steps, RIGID_BLOCK):
        count = min(RIGID_BLOCK, steps - first)
        table = now(first, count)[0]  # its tones need no turning: what lines pull along a rigid motion adds up to zero
        march(address(given), address(table), count, address(speeds) + 8 * first)
    return speeds


# ----------------------------------------------------------------------------------------------------------------------
# Rigid pass: how a driven train's speed goes when nothing twists, so that mesh phases follow it.
#
# Tones run with the speed profile, and a governed speed is not known before. The rigid motion takes part in the same
# right-hand side (line forces do no work on it), a thousand times slower than the teeth; what it finds becomes the
# profile of the elastic run, which then measures only what the rigid motion leaves out.
# ----------------------------------------------------------------------------------------------------------------------


STEP = 1e-3
"""Step of the rigid pass [s]: actuators of propellers are slower by far."""
POINTS = 1000
"""Most points of the profile."""


def followed(system: System, duration: float) -> System:
    """Return a system whose speed profile follows the rigid motion that its drives and loads give it.

    Args:
        system: With one rigid motion at most; with more (a clutch that slips) it keeps its profile.
        duration: [s].
    """
    rigid = split_rigid(system.arrays)[0]
    if rigid.shape[1] != 1 or not np.any(system.arrays.speed):
        return system
    time, factor = rigid_factor(system.arrays, rigid, duration)
    return with_profile(system, list(zip(time.tolist(), factor.tolist(), strict=True)))


def with_profile(system: System, points: Sequence[tuple[float, float]]) -> System:
    """Return a system with another speed profile.

    Args:
        system: Bodies, lines, loads, drives.
        points: (time [s], speed factor [-]).
    """
    return replace(system, arrays=system.arrays._replace(profile=profile_of(points)))


def rigid_factor(arrays: Arrays, rigid: Floats, duration: float) -> tuple[Floats, Floats]:
    """Return time [s] and speed over reference speed [-] of the one rigid motion, shape (points,).

    Args:
        arrays: The system's numbers, with a constant speed factor at which it starts.
        rigid: Its rigid motion, of unit mass, shape (coordinates, 1).
        duration: [s].

    Source: classical fourth-order Runge–Kutta of Rᵀ M R ν̇ = Rᵀ Q with θ̇ = Ω s + R ν.
    """
    steps = max(1, round(duration / STEP))
    motion = rigid_speeds(arrays, rigid[:, 0].copy(), duration / steps, steps)
    fastest = int(np.argmax(np.abs(arrays.speed)))
    factor = arrays.profile.factor[0] + rigid[fastest, 0] * motion / arrays.speed[fastest]
    stride = max(1, -(-steps // POINTS))
    time = np.linspace(0.0, duration, steps + 1)
    return time[::stride], factor[::stride]
