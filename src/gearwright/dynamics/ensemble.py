"""Ensembles: many systems of one structure side by side, eight to a vector, spread over the processor's cores."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from gearwright.dynamics.energy import WORKS
from gearwright.dynamics.generate import state_width, table_width
from gearwright.dynamics.native import Compiled, aligned, compiled
from gearwright.dynamics.recorder import RUNAWAY
from gearwright.dynamics.statics import statics
from gearwright.dynamics.stepsize import STABLE, check_duration, check_step, default_step, fastest_rate
from gearwright.dynamics.system import Arrays, Floats, Labels, System
from gearwright.dynamics.topology import Topology, fingerprint, parameters, topology
from gearwright.dynamics.trace import index_of
from gearwright.errors import DesignError, Problem, SolveError

LANES = 8
"""Trajectories in one vector."""
STEPS = 1024
"""Steps between two settings of the clock: long enough that threads seldom wait for each other to leave Python."""


@dataclass(frozen=True, eq=False)
class Ensemble:
    """Line forces of many trajectories, from every step after the transient; shape (trajectories, lines) each."""

    mean: Floats
    """[N or N m]."""
    least: Floats
    """[N or N m]."""
    most: Floats
    """[N or N m]."""
    rms: Floats
    """Root mean square [N or N m]."""
    state: Floats
    """q and q̇ at the end, shape (trajectories, 2 coordinates)."""
    step: float
    """[s]."""
    labels: Labels
    """Names."""

    def of(self, line: str) -> dict[str, Floats]:
        """Return mean, least, most and rms of one line's force, shape (trajectories,) each.

        Args:
            line: Its name.
        """
        column = index_of(line, self.labels.lines, "line")
        return {key: getattr(self, key)[:, column] for key in ("mean", "least", "most", "rms")}


def simulate_many(
    systems: Sequence[System],
    duration: float,
    *,
    step: float | None = None,
    settle: float = 0.0,
    start: Floats | None = None,
    threads: int | None = None,
    progress: Callable[[float], None] | None = None,
) -> Ensemble:
    """Return force statistics of many systems that differ in their numbers only.

    Args:
        systems: All of one structure: the same lines, tones and kinds of loads.
        duration: [s].
        step: [s]; left out, the smallest that any of them asks for.
        settle: Time at the beginning that the statistics leave out [s].
        start: q and q̇ of each, shape (systems, 2 coordinates); left out, static equilibrium.
        threads: Threads to use; left out, one for each core.
        progress: Called with the fraction done.

    Raises:
        DesignError: If structures differ (with the first that does), or step or duration cannot be.
        SolveError: If a trajectory diverges, with its number and line.
    """
    shape = _shape(systems)
    step = min(default_step(system.arrays) for system in systems) if step is None else step
    steps, first = check_duration(duration, step), round(settle / step)
    if not 0 <= first < steps:
        raise DesignError([Problem("settle", f"{settle:g} s; it must lie within the duration of {duration:g} s")])
    states = _states(systems, start)
    groups = [slice(low, low + LANES) for low in range(0, len(systems), LANES)]
    numbers = np.array([parameters(system.arrays, step)[1] for system in systems])
    own = _own(systems, numbers)
    _check(systems, step, own)
    code = compiled(shape, parameters(systems[0].arrays, step)[0], LANES, own)
    results, members = [], [system.arrays for system in systems]
    clock = _Timing(step, first, steps, "clock" not in own)
    with ThreadPoolExecutor(threads or os.cpu_count()) as pool:
        runs = [
            pool.submit(_run, code, shape, members[group], (numbers[group], states[group]), clock) for group in groups
        ]
        for number, run in enumerate(runs, start=1):
            results.append(run.result())
            if progress is not None:
                progress(number / len(runs))
    summary, ends = (np.concatenate([result[part] for result in results]) for part in range(2))
    return _ensemble(systems[0].labels, summary, ends, (step, steps - first))


def _shape(systems: Sequence[System]) -> Topology:
    if not systems:
        raise DesignError([Problem("systems", "there is none")])
    first = fingerprint(systems[0].arrays)
    for number, system in enumerate(systems):
        if fingerprint(system.arrays) != first:
            message = "its structure differs from the first one's: lines, backlash or none, tones, kinds of loads"
            raise DesignError([Problem(f"systems.{number}", message)])
    return topology(systems[0].arrays)


def _states(systems: Sequence[System], start: Floats | None) -> Floats:
    size = len(systems[0].arrays.mass)
    states = np.zeros((len(systems), 2 * size + WORKS))
    if start is None:
        states[:, :size] = [statics(system, balance="accelerate").position for system in systems]
    elif np.shape(start) != (len(systems), 2 * size):
        raise DesignError([Problem("start", f"its shape is {np.shape(start)}; it must be {(len(systems), 2 * size)}")])
    else:
        states[:, : 2 * size] = start
    return states


class _Timing(NamedTuple):
    """When, and whether for all lanes alike."""

    step: float
    settled: int
    steps: int
    shared: bool


def _run(
    code: Compiled, shape: Topology, group: Sequence[Arrays], rows: tuple[Floats, Floats], clock: _Timing
) -> tuple[Floats, Floats]:
    """March one vector of trajectories from their numbers and states; missing ones repeat the last."""
    step, settled, steps, shared = clock
    own, states = (np.vstack([each, np.repeat(each[-1:], LANES - len(group), axis=0)]) for each in rows)
    lanes = [*group, *[group[-1]] * (LANES - len(group))]
    numbers = aligned(*own.T.shape)
    numbers[:] = own.T
    alike = numbers[:, 0].copy()
    state = aligned(state_width(shape, LANES))
    width = states.shape[1]
    state[: width * LANES] = states.T.ravel()
    table = aligned(2 * STEPS + 1, table_width(shape), 1 if shared else LANES)
    fill = _Clock(lanes, step, shared=shared)
    first, summary = 0, np.zeros(0)
    while first < steps:
        if first == 0 or first == settled:
            summary = aligned(4, len(shape.lines), LANES)
            summary[0], summary[1] = np.inf, -np.inf
        stop = settled if first < settled else steps
        count = min(STEPS, stop - first)
        fill(first, table[: 2 * count + 1])
        code.advance(count, alike, numbers, table, state, state, summary)
        first += count
    ends = state[: width * LANES].reshape(width, LANES).T[: len(group)]
    return summary.transpose(2, 0, 1)[: len(group)], ends


class _Clock:
    """Fills the clock table: one for all lanes if they run at one speed, each lane's own if not."""

    def __init__(self, lanes: Sequence[Arrays], step: float, *, shared: bool) -> None:
        self.step, self.shared = step, shared
        self.factor = np.array([arrays.profile.factor[0] for arrays in lanes])
        self.rate = np.array([arrays.tone_rate for arrays in lanes]).T * self.factor
        if shared:
            self.rate, self.factor = self.rate[:, :1], self.factor[:1]
        half = 0.5 * step * np.arange(2 * STEPS + 1)
        self.turned = np.exp(1j * half[:, None, None] * self.rate)

    def __call__(self, first: int, table: Floats) -> None:
        tones = 2 * len(self.rate)
        phasor = self.turned[: len(table)] * np.exp(1j * self.rate * (first * self.step))
        table[:, 0:tones:2], table[:, 1:tones:2] = phasor.real, phasor.imag
        table[:, tones] = self.factor


def _own(systems: Sequence[System], numbers: Floats) -> frozenset[str]:
    """Return which groups of numbers differ from system to system."""
    clocks = set()
    for system in systems:
        arrays = system.arrays
        timed = len(arrays.loads.schedules.dof) or len(arrays.drives.table)
        if timed or np.any(arrays.profile.factor != arrays.profile.factor[0]):
            message = "ensembles run at constant speed, without schedules and drives; use simulate"
            raise DesignError([Problem("systems", message)])
        clocks.add((float(arrays.profile.factor[0]), arrays.tone_rate.tobytes()))
    layout = parameters(systems[0].arrays, 1.0)[0]
    differs = np.any(numbers != numbers[0], axis=0)
    ends = [*layout[1:], len(differs)]
    groups = zip(layout._fields, layout, ends, strict=True)
    own = {name for name, start, end in groups if np.any(differs[start:end])}
    return frozenset(own | {"clock"} if len(clocks) > 1 else own)


def _check(systems: Sequence[System], step: float, own: frozenset[str]) -> None:
    """Refuse a step that is too large for any; one envelope over all spares most an eigenvalue problem for each."""
    if not own & _SHAPING and 0.0 < step * fastest_rate(_envelope([system.arrays for system in systems])) <= STABLE:
        return
    for system in systems:
        check_step(system.arrays, step)


_SHAPING = frozenset({"weight", "mobility", "speed", "loss", "quadratic", "gyroscopic", "clock"})
"""Numbers for which no envelope is taken; the fastest rate rises with all others that it depends on."""


def _envelope(group: Sequence[Arrays]) -> Arrays:
    """Return arrays with the largest stiffness, swing and damping of each line."""
    first = group[0]
    swing = np.max([np.hypot(arrays.variation.cosine, arrays.variation.sine) for arrays in group], axis=0)
    return first._replace(
        stiffness=np.max([arrays.stiffness for arrays in group], axis=0),
        damping=np.max([arrays.damping for arrays in group], axis=0),
        variation=first.variation._replace(cosine=swing, sine=np.zeros_like(swing)),
    )


def _ensemble(labels: Labels, summary: Floats, ends: Floats, clock: tuple[float, int]) -> Ensemble:
    step, count = clock
    least, most, total, square = (summary[:, part] for part in range(4))
    wrong = ~(np.isfinite(square) & (most < RUNAWAY) & (least > -RUNAWAY))
    if np.any(wrong):
        number, line = (int(place[0]) for place in np.nonzero(wrong))
        raise SolveError(
            f"trajectory {number} diverged on line {labels.lines[line]} (largest force {most[number, line]:.3g}); "
            f"take a smaller step than {step:.3g} s"
        )
    state = ends[:, : 2 * len(labels.coordinates)]
    return Ensemble(total / count, least, most, np.sqrt(square / count), state, step, labels)
