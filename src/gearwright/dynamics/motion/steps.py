"""Time steps: integration schemes, step size from accuracy and stability, and eigenvalue bounds.

What is kept of them is in `record`; whole runs are in `motion` itself.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from gearwright.base import DesignError, Floats, Ints, Problem, SolveError
from gearwright.dynamics.codegen import (
    SIDE,
    Clocked,
    Compiled,
    Size,
    aligned,
    clock,
    clocked,
    compiled,
    parameters,
    record_width,
    recurrence,
    table_width,
    topology,
)
from gearwright.dynamics.equations import damped_rates, line_state, linear, statics
from gearwright.dynamics.model import (
    CLUTCH,
    LARGE,
    Arrays,
    System,
    entry_matrix,
    holding,
    kept,
    line_matrix,
    planned,
    top_rate,
)
from gearwright.dynamics.motion import exact
from gearwright.dynamics.motion.record import BLOCK

# ----------------------------------------------------------------------------------------------------------------------
# Steppers: each fills a block of rows (q, q̇, line forces, deflections) and carries the state on.
#
# A stepper is a plain function of (first step, record, state). Blocks begin at multiples of `BLOCK`, so that a run that
# is taken up again at a checkpoint repeats itself bit for bit.
# ----------------------------------------------------------------------------------------------------------------------


Stepper = Callable[[int, Floats, Floats], None]
RUNGE_KUTTA = ("runge-kutta", "runge-kutta generic")
"""Methods of fixed steps that a system's fastest mode limits."""
ADAPTIVE = ("tsit5", "tsit5 generic")
"""Methods that choose their own steps."""
METHODS = ("exact", *RUNGE_KUTTA, *ADAPTIVE, "implicit")
"""Names of the methods; those without ``generic`` run code that is generated for the system's structure."""


def blank_record(arrays: Arrays, steps: int) -> Floats:
    """Return rows for a stepper to fill: q, q̇, line forces, deflections, and zeros up to a whole vector.

    Args:
        arrays: The system's numbers.
        steps: Rows.
    """
    return aligned(steps, kept(arrays, (record_width,), lambda: record_width(topology(arrays))))


def blank_summary(width: int) -> Floats:
    """Return the summary of no rows, shape (4, width).

    Args:
        width: Numbers in a row.
    """
    summary = np.zeros((4, width))
    summary[0], summary[1] = np.inf, -np.inf
    return summary


def stepper(arrays: Arrays, method: str, h: float, *, tolerance: float = 0.0) -> Stepper:
    """Return the stepper of a method.

    Args:
        arrays: The system's numbers.
        method: One of `METHODS`.
        h: Step [s]; for adaptive methods the spacing of the record's rows.
        tolerance: Root of the energy that the error of one adaptive step may hold [√J].
    """
    if method in ADAPTIVE:
        return _adaptive(arrays, h, tolerance, generic=method != ADAPTIVE[0])
    builders = {"exact": _exact, "runge-kutta": _generated, "runge-kutta generic": _generic, "implicit": _implicit}
    return builders[method](arrays, h)


class GeneratedRun(NamedTuple):
    """What a run by generated code is made of."""

    code: int
    """Address of what advances a block."""
    numbers: Floats
    """Its parameters."""
    clock: Clocked
    """Of this run alone."""
    given: Ints
    """The same as compiled code reads it."""


def generated_run(arrays: Arrays, h: float) -> GeneratedRun:
    """Return what a run by generated code is made of.

    Args:
        arrays: The system's numbers.
        h: Step [s].
    """
    return GeneratedRun(_code(arrays, h).address, parameters(arrays, h)[1], *clocked(arrays, h, BLOCK))


def _code(arrays: Arrays, h: float) -> Compiled:
    return kept(arrays, (compiled,), lambda: compiled(topology(arrays), parameters(arrays, h)[0]))


def _generated(arrays: Arrays, h: float) -> Stepper:
    numbers, code, now = parameters(arrays, h)[1], _code(arrays, h), clock(arrays, h, BLOCK)

    def advance(first: int, record: Floats, state: Floats) -> None:
        table, turn = now(first, len(record))
        code.advance(len(record), numbers, numbers, table, turn, state, record)

    return advance


def _generic(arrays: Arrays, h: float) -> Stepper:
    # Loaded here because the generated code does without it, and compiling it the first time takes seconds.
    from gearwright.dynamics.equations import kernel

    instants = kernel.empty_instant(arrays), kernel.empty_instant(arrays)

    def advance(first: int, record: Floats, state: Floats) -> None:
        kernel.runge_kutta(arrays, instants, first, h, record, state)

    return advance


def _adaptive(arrays: Arrays, h: float, tolerance: float, *, generic: bool) -> Stepper:
    from gearwright.dynamics.equations import kernel
    from gearwright.dynamics.motion import integrators

    shape = topology(arrays)
    layout, numbers = parameters(arrays, h)
    code = None if generic else compiled(shape, layout)
    row, now = np.zeros(table_width(shape)), kernel.empty_instant(arrays)
    limit = integrators.limits(arrays, tolerance)

    def advance(first: int, record: Floats, state: Floats) -> None:
        right = integrators.Right(code.derivative if code else 0, numbers, row, now)
        _, done, reached = integrators.march_adaptive(arrays, right, first, h, limit, record, state)
        if not done:
            raise SolveError(f"the run diverged at {reached:.6g} s: no step is short enough; it needs more damping")

    return advance


def _implicit(arrays: Arrays, h: float) -> Stepper:
    from gearwright.dynamics.equations import kernel
    from gearwright.dynamics.motion import integrators

    now, damping = kernel.empty_instant(arrays), linear(arrays, float(arrays.profile.factor[0])).damping

    def advance(first: int, record: Floats, state: Floats) -> None:
        integrators.march_implicit(arrays, now, first, h, damping, record, state)

    return advance


def _exact(arrays: Arrays, h: float) -> Stepper:
    carry = exact.propagator(arrays, h, int(np.log2(BLOCK)))
    kept, width = 2 * len(arrays.mass), record_width(topology(arrays))
    size = Size(len(carry.step), kept, len(carry.output), width)
    run, block = recurrence(carry.powers[SIDE.bit_length() - 1], carry.output, size), aligned(BLOCK, width)
    eight = exact.first_powers(carry, SIDE)

    def advance(first: int, record: Floats, state: Floats) -> None:
        start = exact.extended_state(arrays, first * h, state)
        room = record if len(record) % SIDE == 0 else block[: -(-len(record) // SIDE) * SIDE]
        run((eight @ start).reshape(SIDE, -1), room)
        if room is not record:
            record[:] = room[: len(record)]
        works, end = exact.works_during(carry, start, len(record))
        state[:kept] = end[:kept]
        state[kept:] += works

    return advance


# ----------------------------------------------------------------------------------------------------------------------
# Bounds on the rates and the damping of large systems, which take no eigenvalues: safe, and never far from them.
#
# Source: Collatz 1942, Math. Z. 48, 221-226: the largest eigenvalue of a matrix without negative entries is at most
# max (A x)_i / x_i for any positive x; those of A are at most those of |A|.
# ----------------------------------------------------------------------------------------------------------------------


ROUNDS = 40
"""Rounds of the power iteration that brings a bound down."""
SMALLEST = 1e-30
"""Share of the largest entry below which none of the iterated vector falls [-]."""


def rate_bound(arrays: Arrays) -> float:
    """Return a bound on the fastest rate |λ| of the system [rad/s], every stiffness at its top.

    Args:
        arrays: The system's numbers.

    Source:
        Energy bound of the damped system: |λ| ≤ d/2 + √(d²/4 + ω²), d the largest eigenvalue of the damping.
    """
    line = np.repeat(np.arange(len(arrays.stiffness)), np.diff(arrays.variation.start))
    terms = np.hypot(arrays.variation.cosine, arrays.variation.sine)
    swing = np.bincount(line, terms, minlength=len(arrays.stiffness))
    top = float(np.max(np.abs(arrays.profile.factor)))
    own = (arrays.loads.damping + 2.0 * arrays.loads.quadratic * np.abs(arrays.speed) * top) / arrays.mass
    stiff, damped, slipping = _clutch_bounds(arrays)
    square = _largest_bound(_spread(arrays, arrays.stiffness * (1.0 + swing)), len(arrays.mass)) + stiff
    damping = _largest_bound(_spread(arrays, arrays.damping), len(arrays.mass)) + max(0.0, float(np.max(own))) + damped
    half = 0.5 * (damping + _spin_bound(arrays) * top)
    return max(slipping, float(half + np.sqrt(half**2 + square)))


def damping_bound(arrays: Arrays, rate: float) -> float:
    """Return what the damping ratio of a mode of some rate is at least [-]; 0 where lines alone do not tell it.

    With c ≥ β k for every line and loads that do not drive, a mode has φᵀ B φ ≥ β ω², hence ζ ≥ β ω/2.

    Args:
        arrays: The system's numbers.
        rate: ω [rad/s].
    """
    held, loads = holding(arrays), arrays.loads
    if np.any(loads.damping < 0.0) or np.any(loads.quadratic < 0.0) or len(arrays.gyroscopic.value):
        return 0.0
    return 0.5 * rate * float(np.min(arrays.damping[held] / arrays.stiffness[held], initial=np.inf))


def _spread(arrays: Arrays, value: Floats) -> Callable[[Floats], Floats]:
    """Return what multiplies by |D|ᵀ diag(value) |D|, D by the root of the masses."""
    line = np.repeat(np.arange(len(value)), np.diff(arrays.line_start))
    weight, dof = np.abs(arrays.line_weight) / np.sqrt(arrays.mass[arrays.line_dof]), arrays.line_dof

    def times(vector: Floats) -> Floats:
        along = value * np.bincount(line, weight * vector[dof], minlength=len(value))
        return np.asarray(np.bincount(dof, weight * along[line], minlength=len(vector)), dtype=np.float64)

    return times


def _largest_bound(times: Callable[[Floats], Floats], size: int) -> float:
    """Return a bound on the largest eigenvalue of a matrix without negative entries."""
    vector, bound = np.ones(size), np.inf
    for _ in range(ROUNDS):
        product = times(vector)
        bound = min(bound, float(np.max(product / vector)))
        if not bound > 0.0:
            return 0.0
        vector = np.maximum(product / np.max(product), SMALLEST)
    return bound


def _clutch_bounds(arrays: Arrays) -> tuple[float, float, float]:
    """Return what clutches that stick add to square and damping, and the fastest rate k/c of one that slips [1/s]."""
    table, place, stiff, damped, fastest = arrays.drives.table, 2, 0.0, 0.0, 0.0
    while place < len(table):
        if table[place + 1] == CLUTCH:
            first, second, (stiffness, damping) = int(table[place + 2]), int(table[place + 4]), table[place + 8 :][:2]
            mobility = 1.0 / arrays.mass[first] + 1.0 / arrays.mass[second]
            stiff, damped = stiff + float(stiffness * mobility), damped + float(damping * mobility)
            fastest = max(fastest, float(stiffness / damping))
        place += int(table[place])
    return stiff, damped, fastest


def _spin_bound(arrays: Arrays) -> float:
    """Return a bound on the norm of the gyroscopic terms at the reference speeds [rad/s]: √(‖G‖₁ ‖G‖∞)."""
    row, column, value = arrays.gyroscopic
    size, root = len(arrays.mass), np.sqrt(arrays.mass)
    scaled = np.abs(value) / (root[row] * root[column])
    sums = [float(np.max(np.bincount(place, scaled, minlength=size), initial=0.0)) for place in (row, column)]
    return float(np.sqrt(sums[0] * sums[1]))


# ----------------------------------------------------------------------------------------------------------------------
# Time step: what accuracy asks for and what stability allows.
# ----------------------------------------------------------------------------------------------------------------------


STABLE = 2.78
"""Step times fastest rate up to which the classical fourth-order Runge–Kutta method is stable on either axis [-].

Source: Hairer, Wanner 1996, Solving Ordinary Differential Equations II, IV.2: 2.785 on the real axis, 2.828 on the
imaginary.
"""
COMFORTABLE = 1.0
"""The same for the default step: at 2.0 the fastest modes are stable but line forces off by 1e-2, at 1.0 by 1e-3."""
STEPS_PER_CYCLE = 6.0 + 0.5 * (5.0**0.5 - 1.0)
"""Steps in a cycle of the highest harmonic: no fraction of whole numbers, so that peaks are met in every phase."""
EXCITED = 1.25
"""Rate of a mode over the highest harmonic's up to which it may ring: stiffness and contact shift both [-]."""
AIM = 0.25
"""Share of the error that is asked which the step aims at, so that the measured one, which is larger, holds too [-]."""
LEAST_DAMPING = 1e-3
"""Damping ratio that modes without damping are taken to have: no force settles there, whatever the step [-]."""
IMPLICIT_STEPS_PER_CYCLE = 40.0
"""The same for the implicit second-order step."""
MARGIN = 0.8
"""What the step is shortened by, so that the error comes out below what was asked [-]."""
ROUNDING = 1e-11
"""Accuracy that rounding allows [-]."""
SEEN = 2.5
"""Highest harmonic's rate times the step below which it is still followed: half a cycle is 3.14 [-]."""
RMS_SHARE = 0.1
"""Error allowed in the root mean square over that allowed in peaks [-]."""
LARGEST_RUN = 1e10
"""Steps that one run may take: about an hour for a small train."""

_top_rate = planned(top_rate)


class Pace(NamedTuple):
    """How finely a run goes."""

    step: float
    """Time step; for adaptive methods the spacing of the rows [s]."""
    tolerance: float = 0.0
    """Root of the energy that the error of one adaptive step may hold; 0 for fixed steps [√J]."""

    def times(self, factor: float) -> Pace:
        """Return a coarser pace, or with a factor below one a finer: a fourth-order method errs by its fourth power.

        Args:
            factor: On the step [-].
        """
        return Pace(self.step * factor, self.tolerance * factor**4)

    def over(self, other: Pace) -> float:
        """Return this pace over another, as the factor that `times` would take [-].

        Args:
            other: Of the same method.
        """
        return self.step / other.step


@dataclass(frozen=True)
class Accuracy:
    """Asks for forces: the peak of every line right to a share of it, its root mean square to a tenth of that share.

    A line that carries next to nothing is judged beside the others of its kind.
    """

    value: float = 0.01
    """Largest error of a peak over the peak [-]."""

    def __post_init__(self) -> None:
        if not isinstance(self.value, float | int) or not ROUNDING < self.value < 1.0:
            message = f"accuracy {self.value}; it must be a number between {ROUNDING:g} and 1"
            raise DesignError([Problem("step", message)])


@planned
def fastest_rate(arrays: Arrays) -> float:
    """Return a bound on the fastest rate |λ| of the system [rad/s], every stiffness at its top.

    Args:
        arrays: The system's numbers.

    Source:
        Energy bound of the damped system: |λ| ≤ d/2 + √(d²/4 + ω²), d the largest eigenvalue of the damping.
    """
    if len(arrays.mass) > LARGE:
        return rate_bound(arrays)
    root = np.sqrt(arrays.mass)
    matrix = line_matrix(arrays) / root
    terms = np.hypot(arrays.variation.cosine, arrays.variation.sine)
    row = np.repeat(np.arange(len(arrays.stiffness)), np.diff(arrays.variation.start))
    swing = np.zeros(len(arrays.stiffness))
    np.add.at(swing, row, terms)
    square = _largest(matrix.T @ ((arrays.stiffness * (1.0 + swing))[:, None] * matrix))
    top = float(np.max(np.abs(arrays.profile.factor)))
    damping = matrix.T @ (arrays.damping[:, None] * matrix)
    damping += np.diag((arrays.loads.damping + 2.0 * arrays.loads.quadratic * np.abs(arrays.speed) * top) / arrays.mass)
    stiff, damped, slipping = _clutches(arrays, root)
    square, damping = square + _largest(stiff), damping + damped
    half = 0.5 * (_largest(damping) + _spin(arrays, root) * top)
    return max(slipping, float(half + np.sqrt(half**2 + max(square, 0.0))))


def _clutches(arrays: Arrays, root: Floats) -> tuple[Floats, Floats, float]:
    """Return stiffness and damping of clutches that stick, and the fastest rate k/c of one that slips [1/s]."""
    size, place, fastest, table = len(root), 2, 0.0, arrays.drives.table
    stiff, damped = np.zeros((2, size, size))
    while place < len(table):
        if table[place + 1] == CLUTCH:
            weight = np.zeros(size)
            first, second, (stiffness, damping) = int(table[place + 2]), int(table[place + 4]), table[place + 8 :][:2]
            weight[first], weight[second] = 1.0 / root[first], -1.0 / root[second]
            stiff += stiffness * np.outer(weight, weight)
            damped += damping * np.outer(weight, weight)
            fastest = max(fastest, float(stiffness / damping))
        place += int(table[place])
    return stiff, damped, fastest


def _spin(arrays: Arrays, root: Floats) -> float:
    """Return the norm of the gyroscopic terms at the reference speeds [rad/s]."""
    if len(arrays.gyroscopic.value) == 0:
        return 0.0
    return float(np.linalg.norm(entry_matrix(arrays.gyroscopic, len(root)) / np.outer(root, root), 2))


def _largest(matrix: Floats) -> float:
    return float(np.linalg.eigvalsh(matrix)[-1])


@planned
def default_step(arrays: Arrays, asked: Accuracy = Accuracy()) -> float:
    """Return the step for explicit integration [s]: for the harmonics, the fastest mode, and modes that may ring.

    Args:
        arrays: The system's numbers.
        asked: Accuracy of the forces.
    """
    fastest, excited = fastest_rate(arrays), _top_rate(arrays)
    stable = COMFORTABLE / fastest if fastest else np.inf
    return float(min(stable, 2.0 * np.pi / (STEPS_PER_CYCLE * excited), _ringing_step(arrays, excited, asked))
                 if excited else stable)  # fmt: skip


def _ringing_step(arrays: Arrays, excited: float, asked: Accuracy) -> float:
    """Return the step at which modes that the harmonics may meet ring as their physical damping lets them.

    A step shifts a mode by (ω h)⁴/120 and damps it by (ω h)⁵/144, which moves a force on the flank of a resonance
    by up to the shift over 2 ζ.

    Source: amplification of the classical fourth-order method, e^z (1 − z⁵/120 + z⁶/144 …), at z = i ω h.
    """
    if len(arrays.mass) > LARGE:
        fastest = min(EXCITED * excited, fastest_rate(arrays))
        least = max(damping_bound(arrays, fastest), LEAST_DAMPING)
        return float((240.0 * AIM * asked.value * least) ** 0.25 / fastest)
    slowest, quickest = float(np.min(arrays.profile.factor)), float(np.max(arrays.profile.factor))
    step = np.inf
    for factor in {slowest, quickest}:
        rate = damped_rates(arrays, factor)
        rings = rate[np.abs(rate) <= EXCITED * excited]
        damping = np.maximum(-rings.real / np.abs(rings), LEAST_DAMPING)
        step = min(step, float(np.min((240.0 * AIM * asked.value * damping) ** 0.25 / np.abs(rings), initial=np.inf)))
    return step


def excited_step(arrays: Arrays) -> float:
    """Return the step that resolves what excites, whatever the modes [s].

    Args:
        arrays: The system's numbers.

    Raises:
        DesignError: If nothing excites: then the step must be given.
    """
    excited = _top_rate(arrays) / (2.0 * np.pi)
    if not excited:
        raise DesignError([Problem("step", "nothing in the system sets a time scale for implicit steps; give one")])
    return 1.0 / (IMPLICIT_STEPS_PER_CYCLE * excited)


def check_step(arrays: Arrays, step: float) -> None:
    """Refuse a step at which explicit integration would blow up.

    Args:
        arrays: The system's numbers.
        step: [s].

    Raises:
        DesignError: Naming the step that would do.
    """
    fastest = fastest_rate(arrays)
    if not 0.0 < step * fastest <= STABLE:
        largest, good = STABLE / fastest, default_step(arrays)
        message = f"{step:.3g} s is outside what is stable, 0 to {largest:.3g} s; a step of {good:.3g} s would do"
        raise DesignError([Problem("step", message)])


def whole_step(duration: float, step: float) -> float:
    """Return the largest step that is not larger and cuts the duration into an even number [s].

    Args:
        duration: [s].
        step: [s].

    Raises:
        DesignError: If the duration cannot be.
    """
    check_duration(duration, step)
    return duration / (2.0 * float(np.ceil(0.5 * duration / step * (1.0 - ROUNDING))))


def may_take(arrays: Arrays, method: str, pace: Pace) -> bool:
    """Tell whether steps at a pace would neither blow up nor miss what excites.

    Args:
        arrays: The system's numbers.
        method: One of `METHODS`.
        pace: How finely.
    """
    met = _top_rate(arrays) * pace.step < SEEN
    return met and ("runge-kutta" not in method or pace.step * fastest_rate(arrays) <= MARGIN * STABLE)


def check_duration(duration: float, step: float) -> int:
    """Return the number of steps of a run.

    Args:
        duration: [s].
        step: [s].

    Raises:
        DesignError: If the duration is not positive, or so long that no one would wait for it.
    """
    if not 0.0 < duration < np.inf:
        raise DesignError([Problem("duration", f"{duration:g} s; it must be positive and finite")])
    if duration / step > LARGEST_RUN:
        message = f"{duration:.3g} s takes {duration / step:.2g} steps; at most {LARGEST_RUN * step:.3g} s at this step"
        raise DesignError([Problem("duration", message)])
    return max(1, round(duration / step))


# ----------------------------------------------------------------------------------------------------------------------
# Pacing: how finely a run goes, from what is asked, by fixed steps and by adaptive ones.
# ----------------------------------------------------------------------------------------------------------------------


TOLERANCE = 1e-5
"""Root of the energy in an adaptive step's error over that of the energy held: line forces within about 1e-4 [-]."""
TOLERANT = 1e-3
"""Error of line forces at that tolerance, with room [-]."""


def pace_of(system: System, method: str, step: float | Accuracy | None, state: Floats) -> Pace:
    """Return how finely a run goes.

    Args:
        system: Bodies, lines, loads.
        method: One of `METHODS`.
        step: As in `simulate`.
        state: q, q̇ and works at the start.

    Raises:
        DesignError: If the step cannot be, with the one that would do.
    """
    arrays = system.arrays
    if step is None or isinstance(step, Accuracy):
        asked = step or Accuracy()
        step = excited_step(arrays) if method == "implicit" else default_step(arrays, asked)
        share = min(1.0, AIM * asked.value / TOLERANT)
        return Pace(step, share * _tolerance(system, state) if method in ADAPTIVE else 0.0)
    if method in RUNGE_KUTTA:
        check_step(arrays, step)
    elif not 0.0 < step < np.inf:
        raise DesignError([Problem("step", f"{step:g} s; it must be positive and finite")])
    return Pace(step, _tolerance(system, state) if method in ADAPTIVE else 0.0)


def _tolerance(system: System, state: Floats) -> float:
    """Return the tolerance of adaptive steps: a share of the energy that loads, errors, slip and the start hold."""
    arrays, size = system.arrays, len(system.arrays.mass)
    position, velocity = state[:size], state[size : 2 * size]
    at_rest = statics(system, balance="accelerate").position
    states = (line_state(arrays, 0.0, where, 0.0 * where) for where in (position, at_rest))
    energy = max(float(np.sum(lines.stiffness * lines.contact**2)) for lines in states)
    mobility = np.sum(line_matrix(arrays) ** 2 / arrays.mass, axis=1)
    slipping = float(np.sum((arrays.profile.factor[0] * arrays.slip) ** 2 / mobility))
    energy = 0.5 * (energy + float(np.sum(arrays.mass * velocity**2)) + slipping)
    if not energy > 0.0:
        message = "tsit5 measures its error by the energy of loads, errors and start; there is none: use runge-kutta"
        raise DesignError([Problem("method", message)])
    return TOLERANCE * float(np.sqrt(energy))
