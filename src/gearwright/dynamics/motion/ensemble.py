"""Simulation of many systems of one structure as a batch, in vectors and on several cores."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field, replace
from typing import Final, Literal, NamedTuple

import numpy as np

from gearwright.base import DesignError, Floats, Problem, Shown, SolveError, one_blas_thread, verb
from gearwright.dynamics.codegen import (
    BLOCK,
    CHUNK,
    SINGLE,
    Compiled,
    Topology,
    aligned,
    compiled,
    parameter_rows,
    table_width,
    topology,
    wave_width,
    waves_of,
)
from gearwright.dynamics.equations import WORKS, unbalanced
from gearwright.dynamics.model import (
    Arrays,
    Labels,
    System,
    check_finite,
    check_structure,
    envelope,
    own_groups,
    refuse_not_finite,
    stacked,
)
from gearwright.dynamics.motion.marching import (
    COARSER,
    EXACT,
    GIVEN,
    PARTING,
    REFINED,
    REPEATED,
    SMOOTH,
    Error,
    Forces,
    apart,
    errors_of,
    finer,
    shortfall,
)
from gearwright.dynamics.motion.record import index_of
from gearwright.dynamics.motion.simulate import endless, equilibrium
from gearwright.dynamics.motion.steps import (
    RMS_SHARE,
    STABLE,
    Accuracy,
    Pace,
    check_duration,
    check_step,
    default_step,
    fastest_rate,
    may_take,
    whole_step,
)
from gearwright.dynamics.motion.taking import RUNAWAY

# ----------------------------------------------------------------------------------------------------------------------
# Side by side: trajectories of one structure in the lanes of vectors, marched block by block.
# ----------------------------------------------------------------------------------------------------------------------


Precision = Literal["double", "single"]
"""Of numbers that are marched."""
DOUBLE: Final = "double"
STEPS = 64 * BLOCK
"""Steps between two returns to Python: long enough that threads seldom wait for each other to leave it."""


def lanes_of(precision: Precision) -> int:
    """Return the trajectories in one vector.

    Args:
        precision: Of its numbers.
    """
    return CHUNK if precision == DOUBLE else SINGLE


class Timing(NamedTuple):
    """When, how many at once, and the clock if it is one for all lanes."""

    step: float
    settled: int
    steps: int
    lanes: int
    shared: Clock | None


class Clock:
    """Clock table of a block of steps: one for all lanes if they run at one speed, each lane's own if not.

    Angles are worked out in double precision, whatever that of their cosines and sines.
    """

    def __init__(self, members: Sequence[Arrays], shape: Topology, step: float, lanes: int) -> None:
        factor, count = np.array([arrays.profile.factor[0] for arrays in members]), len(members)
        self.rate = (np.array([arrays.tone_rate for arrays in members]).T * factor).ravel()
        self.step, self.waves, self.single = step, wave_width(shape, count, lanes), lanes == SINGLE
        self.table = aligned(2 * BLOCK + 1, table_width(shape, count, lanes), single=self.single)
        half = 0.5 * step * np.arange(len(self.table))
        self.table[:, : 2 * self.waves] = waves_of(np.outer(half, self.rate), self.waves)
        self.table[:, 2 * self.waves : 2 * self.waves + count] = factor

    def turns(self, first: int, count: int) -> Floats:
        """Return by how much the tones are to be turned for each block of some steps.

        Args:
            first: Step with which they begin.
            count: Steps.
        """
        begins = self.step * (first + BLOCK * np.arange(-(-count // BLOCK)))
        turns = aligned(len(begins), 2 * self.waves, single=self.single)
        turns[:] = waves_of(np.outer(begins, self.rate), self.waves)
        return turns


def run_lanes(
    code: Compiled, shape: Topology, group: Sequence[Arrays], timing: Timing, *, numbers: Floats, states: Floats
) -> tuple[Floats, Floats]:
    """March one vector of trajectories from their numbers and states; return their summaries and ends.

    Args:
        code: Of the structure.
        shape: Structure.
        group: Systems, at most as many as there are lanes.
        timing: When.
        numbers: A row for each.
        states: A row for each.

    Returns:
        Least, most, sum and sum of squares of line forces, shape (systems, 4, lines), and a row of states for each.
    """
    lanes = timing.lanes
    lane_numbers, lane_states = _as_lanes(numbers, lanes), _as_lanes(states, lanes)
    alike = lane_numbers[:, 0].copy()
    clock = timing.shared or Clock([*group, *[group[-1]] * (lanes - len(group))], shape, timing.step, lanes)
    first, block = 0, aligned(4, len(shape.lines), lanes, single=lanes == SINGLE)
    summary = np.zeros(block.shape)
    while first < timing.steps:
        if first in (0, timing.settled):
            summary[:] = _NOTHING
        stop = timing.settled if first < timing.settled else timing.steps
        count = min(STEPS, stop - first)
        block[:] = _NOTHING
        code.advance(count, alike, lane_numbers, clock.table, clock.turns(first, count), lane_states, block)
        np.minimum(summary[0], block[0], out=summary[0])
        np.maximum(summary[1], block[1], out=summary[1])
        summary[2:] += block[2:]
        first += count
    return summary.transpose(2, 0, 1)[: len(group)], lane_states.T[: len(group)].astype(np.float64)


_NOTHING = np.array([np.inf, -np.inf, 0.0, 0.0])[:, None, None]
"""Least, most, sum and sum of squares of nothing."""


def _as_lanes(rows: Floats, lanes: int) -> Floats:
    """Return rows side by side, a lane for each; missing ones repeat the last."""
    columns = aligned(rows.shape[1], lanes, single=lanes == SINGLE)
    with np.errstate(over="ignore", under="ignore"):
        columns[:] = np.vstack([rows, np.repeat(rows[-1:], lanes - len(rows), axis=0)]).T
    return columns


# ----------------------------------------------------------------------------------------------------------------------
# Ensembles: many systems of one structure side by side in vectors, spread over the processor's cores.
# ----------------------------------------------------------------------------------------------------------------------


SAMPLED = 8
"""Trajectories of single precision that are run again in double, spread over all: one vector."""
LEAST_STEPS = 16
"""Steps from which trajectories are compared with coarser ones [-]."""


@dataclass(frozen=True, eq=False, repr=False)
class Ensemble(Shown):
    """Line forces of many trajectories, from every step after the transient; shape (trajectories, lines) each."""

    mean: Floats
    """[N or N m]."""
    minimum: Floats
    """[N or N m]."""
    maximum: Floats
    """[N or N m]."""
    rms: Floats
    """Root mean square [N or N m]."""
    state: Floats
    """q and q̇ at the end, shape (trajectories, 2 coordinates)."""
    step: float
    """[s]."""
    labels: Labels
    """Names."""
    error: Floats = field(default_factory=lambda: np.zeros(0))
    """Measured error of the peaks of line forces over them [-], shape (trajectories,)."""
    rms_error: Floats = field(default_factory=lambda: np.zeros(0))
    """And of their root mean squares [-], shape (trajectories,)."""
    rounding: Error = EXACT
    """What single precision moves peaks and root mean squares by, over them [-]: the most among trajectories that were
    run again in double; part of both errors, 0 for double."""
    notes: tuple[str, ...] = ()
    """Trajectories whose error is larger than asked, or that never come to rest, and why."""

    def of(self, line: str) -> dict[str, Floats]:
        """Return mean, least, most and rms of one line's force, shape (trajectories,) each.

        Args:
            line: Its name.
        """
        column = index_of(line, self.labels.lines, "line")
        return {key: getattr(self, key)[:, column] for key in ("mean", "minimum", "maximum", "rms")}


@verb
@one_blas_thread()
def simulate_many(
    systems: Sequence[System],
    duration: float,
    *,
    step: float | Accuracy | None = None,
    settle: float = 0.0,
    start: Floats | None = None,
    threads: int | None = None,
    progress: Callable[[float], None] | None = None,
    precision: Precision = "double",
) -> Ensemble:
    """Return force statistics of many systems that differ in their numbers only.

    Single precision holds twice as many trajectories in a vector; phases of the tones, and sums over more than a block
    of steps, stay in double. What it costs is measured: some trajectories are run again in double at the same step.

    Args:
        systems: All of one structure: the same lines, tones and kinds of loads.
        duration: [s].
        step: [s], taken as it is, or an `Accuracy`, as in `simulate`: the smallest that any of them asks for.
        settle: Time at the beginning that the statistics leave out [s].
        start: q and q̇ of each, shape (systems, 2 coordinates); left out, static equilibrium.
        threads: Threads to use; left out, one for each core.
        progress: Called with the fraction done.
        precision: ``"double"``, or ``"single"``.

    Raises:
        DesignError: If structures differ (with the first that does), or step or duration cannot be; if a number has no
            place in single precision.
        SolveError: If a trajectory diverges, with its number and line; if single precision moves forces by more than
            the error that is asked, with the line.
    """
    if not systems:
        raise DesignError([Problem("systems", "there is none")])
    for system in systems:
        check_finite(system)
    asked = step if isinstance(step, Accuracy) else Accuracy()
    given = None if step is None or isinstance(step, Accuracy) else step
    taken = min(default_step(system.arrays, asked) for system in systems) if given is None else given
    taken = taken if given is not None else whole_step(duration, taken)
    march = _Marching(systems, duration, settle, _states(systems, start), threads, precision)
    found, other = march.at(taken, progress), march.beside(taken)
    for tried in range(REFINED + 1):
        error, order = _errors(systems, found, other)
        over = max(one.over(asked) for one in error)
        if over <= 1.0 or given is not None or tried == REFINED:
            break
        other, found = found, march.at(found.step * finer(over, order), progress)
    why = REPEATED if given is None else GIVEN
    rounding = march.rounding(found, asked)
    width = 2.0 * np.pi / duration
    notes = tuple(
        f"trajectory {number}: {note}"
        for number, (system, one, left) in enumerate(zip(systems, error, _left_over(systems), strict=True))
        for note in [*shortfall(one.plus(rounding), asked, why), *endless(system.arrays, width), *left]
    )
    measured = np.array(error) + rounding
    return replace(found, error=measured[:, 0], rms_error=measured[:, 1], rounding=rounding, notes=notes)


def _left_over(systems: Sequence[System]) -> list[list[str]]:
    """Return what the loads of each leave over, in words; members alike in what decides it are asked once."""
    found, answers = dict[bytes, list[str]](), list[list[str]]()
    for system in systems:
        arrays = system.arrays
        slipping, loads = arrays.damping * arrays.slip, arrays.loads[:3]
        numbers = (arrays.mass, arrays.line_weight, arrays.stiffness > 0.0, arrays.speed, slipping, *loads)
        key = b"".join([part.tobytes() for part in (*numbers, arrays.profile.factor)])
        if key not in found:
            left = unbalanced(system)
            found[key] = [f"at the start {left}; the train speeds up or slows down"] if left else []
        answers.append(found[key])
    return answers


def _errors(systems: Sequence[System], found: Ensemble, other: Ensemble) -> tuple[list[Error], int]:
    """Return the error of each trajectory, and the order by which they were judged."""
    play = np.array([system.arrays.backlash > 0.0 for system in systems])
    order = PARTING if np.any(found.minimum[play] <= 0.0) else SMOOTH
    mine, its = _forces(found), _forces(other)
    # Peaks between steps are of second order and not seen: half of what two runs differ by.
    mine = mine._replace(between=0.5 * np.abs(mine.peak - its.peak))
    return errors_of(mine, its, found.labels.line_units, ratio=other.step / found.step, order=order), order


def _forces(found: Ensemble) -> Forces:
    peak = np.maximum(np.abs(found.minimum), np.abs(found.maximum))
    return Forces(peak, found.rms, 0.0 * peak, 0.0 * peak)


class _Marching(NamedTuple):
    """What is marched over, at one step or another."""

    systems: Sequence[System]
    duration: float
    settle: float
    states: Floats
    threads: int | None
    precision: Precision = DOUBLE

    def beside(self, step: float) -> Ensemble:
        """Return the same at twice the step, or at half of it where that would blow up or miss what excites."""
        coarse = Pace(COARSER * step)
        members = [system.arrays for system in self.systems]
        stable = all(may_take(arrays, "runge-kutta", coarse) for arrays in _fastest(members))
        if stable and self.duration - self.settle >= LEAST_STEPS * step:
            with contextlib.suppress(SolveError, DesignError):
                return self.at(coarse.step)
        return self.at(step / COARSER)

    def at(self, step: float, progress: Callable[[float], None] | None = None) -> Ensemble:
        """Return the statistics at a step, their error not yet known."""
        members = [system.arrays for system in self.systems]
        family = stacked(members)
        _check_family(family)
        steps, first = check_duration(self.duration, step), 2 * round(self.settle / (2.0 * step))
        if not 0 <= first < steps:
            message = f"{self.settle:g} s; it must lie within the duration of {self.duration:g} s"
            raise DesignError([Problem("settle", message)])
        shape, (layout, rows) = topology(members[0]), parameter_rows(family, step)
        if self.precision != DOUBLE:
            _check_range(layout._asdict(), rows)
        varying = own_groups(family, layout, layout._fields, rows)
        numbers = np.broadcast_to(rows, (len(members), rows.shape[1]))
        if not all(0.0 < step * fastest_rate(arrays) <= STABLE for arrays in _fastest(members)):
            for arrays in members:
                check_step(arrays, step)
        lanes = lanes_of(self.precision)
        code = compiled(shape, layout, lanes, varying)
        clock = None if "clock" in varying else Clock(members[:1], shape, step, lanes)
        timing = Timing(step, first, steps, lanes, clock)
        groups = [slice(low, low + lanes) for low in range(0, len(members), lanes)]
        results = []
        with ThreadPoolExecutor(self.threads or os.cpu_count()) as pool:
            runs = [
                pool.submit(
                    run_lanes, code, shape, members[group], timing, numbers=numbers[group], states=self.states[group]
                )
                for group in groups
            ]
            for number, run in enumerate(runs, start=1):
                results.append(run.result())
                if progress is not None:
                    progress(number / len(runs))
        summary, ends = (np.concatenate(parts) for parts in zip(*results, strict=True))
        return _ensemble(self.systems[0].labels, summary, ends, step=step, count=steps - first)

    def rounding(self, found: Ensemble, asked: Accuracy) -> Error:
        """Return what single precision moves peaks and root mean squares by, measured on some trajectories.

        Raises:
            SolveError: If it is more than the error that is asked.
        """
        if self.precision == DOUBLE:
            return EXACT
        rows = np.unique(np.linspace(0, len(self.systems) - 1, SAMPLED).round().astype(int))
        double = self._replace(
            systems=[self.systems[row] for row in rows.tolist()], states=self.states[rows], precision=DOUBLE
        ).at(found.step)  # fmt: skip
        mine = Forces(*(part[rows] for part in _forces(found)))
        moved = apart(mine, _forces(double), found.labels.line_units)
        most = Error(*np.max(moved, axis=(1, 2)).tolist())
        if not most.over(asked) <= 1.0:
            _, row, line = np.unravel_index(int(np.argmax(moved)), moved.shape)
            raise SolveError(
                f"single precision moves peaks of line forces by {most.peak:.1e} and root mean squares by "
                f"{most.rms:.1e}, most on line {found.labels.lines[line]} of trajectory {rows[row]}; asked were "
                f'{asked.value:.1e} and {RMS_SHARE * asked.value:.1e}: take precision="double"'
            )
        return most


def ends_of(system: System, starts: Floats, duration: float, step: float) -> Floats:
    """Return q and q̇ of one system after a time, from many starts, shape (starts, 2 coordinates).

    Args:
        system: Bodies, lines, loads.
        starts: q and q̇, shape (starts, 2 coordinates).
        duration: [s].
        step: [s].
    """
    systems = [system] * len(starts)
    return _Marching(systems, duration, 0.0, _states(systems, starts), None).at(step).state


def _states(systems: Sequence[System], start: Floats | None) -> Floats:
    size = len(systems[0].arrays.mass)
    states = np.zeros((len(systems), 2 * size + WORKS))
    if start is None:
        states[:, :size] = [equilibrium(system) for system in systems]
    elif np.shape(start) != (len(systems), 2 * size):
        raise DesignError([Problem("start", f"its shape is {np.shape(start)}; it must be {(len(systems), 2 * size)}")])
    else:
        states[:, : 2 * size] = start
    return states


def _check_family(family: Arrays) -> None:
    check_structure(family)
    timed = family.loads.schedules.dof.size or family.drives.table.size
    if timed or np.any(family.profile.factor != family.profile.factor[:, :1]):
        message = "ensembles run at constant speed, without schedules and drives; use simulate"
        raise DesignError([Problem("systems", message)])


def _fastest(members: Sequence[Arrays]) -> Sequence[Arrays]:
    """Return systems none of which is slower than all members: one envelope, which spares most an eigenvalue problem.

    Only where they are alike in all but what an envelope has at its largest; else the members themselves.
    """
    family = stacked(members)
    alike = (
        family.mass, family.line_weight, family.speed, family.tone_rate, family.slip, *family.loads[1:3],
        family.gyroscopic.value, family.profile.factor,
    )  # fmt: skip
    return members if any(np.any(part != part[:1]) for part in alike) else [envelope(members[0], family)]


def _check_range(layout: Mapping[str, int], rows: Floats) -> None:
    """Refuse numbers that have no place in single precision."""
    size, kind = np.abs(rows), np.finfo(np.float32)
    wrong = (np.isfinite(size) & (size > kind.max)) | ((size > 0.0) & (size < kind.smallest_normal))
    if np.any(wrong):
        number, column = (int(place[0]) for place in np.nonzero(wrong))
        group = [name for name, first in layout.items() if first <= column][-1]
        message = f"{group} {rows[number, column]:.3g} has no place in single precision, which holds numbers from "
        message += f'{kind.smallest_normal:.2g} to {kind.max:.2g}; take precision="double"'
        raise DesignError([Problem(f"systems.{number}", message)])


def _ensemble(labels: Labels, summary: Floats, ends: Floats, *, step: float, count: int) -> Ensemble:
    minimum, maximum, total, square = summary.transpose(1, 0, 2)
    wrong = ~(np.isfinite(square) & (maximum < RUNAWAY) & (minimum > -RUNAWAY))
    if np.any(wrong):
        number, line = (int(place[0]) for place in np.nonzero(wrong))
        raise SolveError(
            f"trajectory {number} diverged on line {labels.lines[line]} (largest force {maximum[number, line]:.3g}); "
            f"take a smaller step than {step:.3g} s"
        )
    state = ends[:, : 2 * len(labels.coordinates)]
    refuse_not_finite(state, [*labels.coordinates, *(f"{name} (rate)" for name in labels.coordinates)], "end")
    return Ensemble(total / count, minimum, maximum, np.sqrt(square / count), state, step, labels)
