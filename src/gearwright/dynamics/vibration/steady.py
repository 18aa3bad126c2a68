"""Periodic steady state by shooting, and its stability by Floquet multipliers."""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from math import gcd, lcm

import numpy as np

from gearwright.arrays import Complexes, Floats
from gearwright.blas_threads import one_blas_thread
from gearwright.dynamics.equations import WORKS, linear, split_rigid, state_matrix, stiffness_at, unbalanced
from gearwright.dynamics.model import Arrays, System, entry_matrix, line_matrix
from gearwright.dynamics.motion import (
    BLOCK,
    GIVEN,
    PARTING,
    SMOOTH,
    Accuracy,
    Error,
    Forces,
    Samples,
    blank_record,
    default_step,
    endless,
    ends_of,
    equilibrium,
    errors_of,
    shortfall,
    stepper,
)
from gearwright.errors import DesignError, Problem, SolveError
from gearwright.showing import Shown
from gearwright.verbs import verb

# ----------------------------------------------------------------------------------------------------------------------
# Variation: how motions beside a periodic one go, which decides whether it is stable.
#
# A disturbance obeys η̇ = A(t) η, A from the stiffness of the lines that touch at that instant of the orbit. Over two
# of its steps A is taken to its fourth order in time and solved by the exponential of a matrix, so that a constant A
# is exact and no step damps what the system does not.
# ----------------------------------------------------------------------------------------------------------------------


NODES = (slice(0, -1, 2), slice(1, None, 2), slice(2, None, 2))
"""First, middle and last instants of each two steps."""


def every_step(system: System, start: Floats, step: float, steps: int) -> Samples:
    """Return every instant of a motion from q and q̇ at time 0.

    Args:
        system: Bodies, lines, loads.
        start: q and q̇, shape (2 coordinates,).
        step: [s].
        steps: How many.
    """
    arrays = system.arrays
    size, lines = len(arrays.mass), len(arrays.stiffness)
    advance, record = stepper(arrays, "runge-kutta", step), blank_record(arrays, steps + 1)
    state = np.concatenate([start, np.zeros(WORKS)])
    for first in range(0, len(record), BLOCK):
        advance(first, record[first : first + BLOCK], state)
    ends = [size, 2 * size, 2 * size + lines, 2 * size + 2 * lines]
    position, velocity, force, deflection, _ = np.split(np.asarray(record), ends, axis=1)
    drive = np.zeros((steps + 1, 0))
    time = np.asarray(step * np.arange(steps + 1), dtype=np.float64)
    return Samples(time, position, velocity, force, deflection, system.labels, drive)


def monodromy(system: System, samples: Samples) -> Floats:
    """Return the derivative of a motion's end by its start, shape (2 coordinates, 2 coordinates).

    Args:
        system: At constant speed.
        samples: Every step of the motion, an even number of them.

    Source: Magnus series to fourth order with Simpson's nodes, Blanes, Casas, Oteo & Ros 2009, Phys. Rep. 470, 151,
        section 5.
    """
    from scipy import linalg  # statics, whose layer this is, do without it

    arrays = system.arrays
    stiffness, share = stiffness_at(system, samples.time), _touching(arrays, samples.line_deflection)
    first, middle, last = (_matrices(arrays, share * stiffness[nodes]) for nodes in NODES)
    step = 2.0 * float(samples.time[1] - samples.time[0])
    exponents = step / 6.0 * (first + 4.0 * middle + last) - step**2 / 12.0 * (first @ last - last @ first)
    total = np.eye(2 * len(arrays.mass))
    with one_blas_thread():
        for turn in linalg.expm(exponents):
            total = turn @ total
    return np.asarray(total)


def _touching(arrays: Arrays, deflection: Floats) -> Floats:
    """Return the share of each two steps in which lines touch, shape (steps / 2, lines).

    Between instants a deflection is taken as straight, so that flanks part and meet inside a step.
    """
    low, high = np.minimum(deflection[:-1], deflection[1:]), np.maximum(deflection[:-1], deflection[1:])
    gap = np.minimum(high, 0.0) - np.maximum(low, -arrays.backlash)
    length = high - low
    still = np.where(gap > 0.0, 1.0, 0.0)
    opened = np.divide(np.maximum(gap, 0.0), length, out=still, where=length > 0.0)
    touching = np.where(arrays.backlash > 0.0, 1.0 - opened, 1.0)
    return np.asarray(0.5 * (touching[::2] + touching[1::2]))


def _matrices(arrays: Arrays, stiffness: Floats) -> Floats:
    """Return A at many instants, shape (instants, 2 coordinates, 2 coordinates)."""
    factor, size = float(arrays.profile.factor[0]), len(arrays.mass)
    matrix = line_matrix(arrays)
    turned = factor**2 * entry_matrix(arrays.centripetal, size)
    found = np.repeat(state_matrix(linear(arrays, factor))[None], len(stiffness), axis=0)
    held = np.einsum("li,tl,lj->tij", matrix, stiffness, matrix, optimize=True) - turned
    found[:, size:, :size] = -held / arrays.mass[:, None]
    return np.asarray(found)


# ----------------------------------------------------------------------------------------------------------------------
# Steady state: the periodic motion by shooting, and its Floquet multipliers.
#
# One period is integrated from a start and from starts displaced along each state, eight at a time; Newton moves the
# start until the motion closes. The monodromy matrix, from the equations of what is next to the motion (`variation`),
# has eigenvalues that tell whether it is stable: all within the unit circle, but for those of rigid motions, left out.
# ----------------------------------------------------------------------------------------------------------------------


CLOSED = 1e-9
"""Gap between end and start of the period over the size of the motion, at which it counts as closed [-]."""
ROUNDS = 30
"""Newton rounds before giving up."""
STILL = 1e-6
"""Size of the states of what stands still, without load and error [m or rad]."""
NUDGE = 1e-6
"""Displacement of a start, over the size of its kind of state, for the derivative [-]."""
HALVED = 6
"""Times that the steps of a period are halved, whatever their number."""
QUICK = 30_000
"""Steps of a period up to which they are halved on, since they cost little: contact converges by second order."""
LOCKED = 1e-2
"""Angle by which an undamped mode may leave a tone in a period and still count as met by it [rad]."""
SETTLING = 64
"""Periods that a motion is left to itself where Newton's method does not find it from static equilibrium."""
MULTIPLIER_ROUNDING = 1e-10
"""What rounding leaves of the size of a multiplier [-]."""
LARGEST_DENOMINATOR = 10_000
"""Teeth: ratios of tones are fractions of whole numbers no larger."""


@dataclass(frozen=True, eq=False, repr=False)
class Orbit(Shown):
    """A periodic motion, measured from the rigid one."""

    period: float
    """[s]."""
    samples: Samples
    """Every step of one period."""
    multipliers: Complexes
    """Floquet multipliers, largest first, shape (2 coordinates,); those of rigid motions (1) are left out."""
    monodromy: Floats
    """Derivative of the end of a period by its start, shape (2 coordinates, 2 coordinates)."""
    error: float = 0.0
    """Measured error of the peaks of line forces over them [-]."""
    rms_error: float = 0.0
    """And of their root mean squares [-]."""
    multiplier_error: float = 0.0
    """How far the size of the largest multiplier may be off [-]."""
    notes: tuple[str, ...] = ()
    """What is less sure than was asked, and why."""

    @property
    def stable(self) -> bool:
        """Whether every disturbance dies out."""
        return bool(np.all(np.abs(self.multipliers) < 1.0))


def common_period(arrays: Arrays) -> float:
    """Return the time after which all tones repeat together [s].

    Args:
        arrays: The system's numbers, at constant speed.

    Raises:
        DesignError: If nothing turns, or the speed changes.
    """
    used = np.unique(np.concatenate([arrays.variation.tone, arrays.error.tone])).astype(int)
    rates = np.abs(arrays.tone_rate[used]) * float(arrays.profile.factor[0])
    rates = rates[rates > 0.0]
    if not len(rates) or np.any(arrays.profile.factor != arrays.profile.factor[0]):
        raise DesignError([Problem("period", "no tone turns at constant speed; a periodic motion needs one")])
    ratios = [Fraction(float(rate / rates[0])).limit_denominator(LARGEST_DENOMINATOR) for rate in rates]
    bottom = lcm(*(ratio.denominator for ratio in ratios))
    top = gcd(*(int(ratio * bottom) for ratio in ratios))
    return float(2.0 * np.pi / rates[0] * bottom / top)


@verb
@one_blas_thread()
def periodic(system: System, *, period: float | None = None, step: float | Accuracy | None = None) -> Orbit:
    """Return the periodic motion near static equilibrium.

    The period is cut finer until forces, and whether multipliers lie within the unit circle, are as sure as was asked.

    Args:
        system: At constant speed.
        period: [s]; left out, the time after which all tones repeat, which with hunting teeth may be long.
        step: Largest step [s], taken as it is; the period is cut into equal ones. Or an `Accuracy`, as in `simulate`.

    Raises:
        SolveError: If Newton's method does not close the motion; under heavy contact loss there may be several
            motions, or none of this period.
    """
    arrays = system.arrays
    asked = step if isinstance(step, Accuracy) else Accuracy()
    given = None if step is None or isinstance(step, Accuracy) else step
    period = common_period(arrays) if period is None else period
    for path, value in (("period", period), ("step", period if given is None else given)):
        if not 0.0 < value < np.inf:
            raise DesignError([Problem(path, f"{value:g} s; it must be positive and finite")])
    steps = 2 * int(np.ceil(0.5 * period / (default_step(arrays, asked) if given is None else given)))
    start = np.zeros(2 * len(arrays.mass))
    start[: len(arrays.mass)] = equilibrium(system)
    orbit = _orbit(system, _closed(system, start, period, steps), period=period, steps=steps)
    most = 2 * steps if given is not None else max(steps * 2**HALVED, QUICK)
    while steps < most:
        steps, other = 2 * steps, orbit
        orbit = _orbit(system, _closed(system, _start(other), period, steps), period=period, steps=steps)
        error, uncertain = _error(arrays, orbit, other), _uncertain(orbit, other)
        sure = abs(float(np.max(np.abs(orbit.multipliers), initial=0.0)) - 1.0) > uncertain
        if error.over(asked) <= 1.0 and sure:
            break
    notes = [] if sure else [f"the largest multiplier is 1 to within {uncertain:.1e}: on the border of stability"]
    notes += shortfall(error, asked, f"{steps} steps did not bring it down" if given is None else GIVEN)
    return replace(orbit, error=error.peak, rms_error=error.rms, multiplier_error=uncertain, notes=tuple(notes))


def _closed(system: System, start: Floats, period: float, steps: int) -> Floats:
    """Return the start of a motion that repeats itself: by Newton's method, then from where the motion goes by itself.

    Raises:
        SolveError: If neither closes.
    """
    gap = np.inf
    for wait in (0, SETTLING):
        left = ends_of(system, start[None], wait * period, period / steps)[0] if wait else start
        found, gap = _newton(system, left, period, steps)
        if gap < CLOSED:
            return found
    reasons = [*endless(system.arrays, LOCKED / period), *filter(None, [unbalanced(system)])]
    missed = (
        f"no motion of period {period:.4g} s closed, neither in {ROUNDS} rounds of Newton's method nor after "
        f"{SETTLING} periods; the gap is {gap:.1e}: try a multiple of the period, or simulate"
    )
    raise SolveError("; ".join([*reasons, missed]))


def _newton(system: System, start: Floats, period: float, steps: int) -> tuple[Floats, float]:
    """Return the start of a motion that nearly repeats itself, and the gap that is left."""
    for _ in range(ROUNDS):
        end, matrix, scale = _period(system, start, period, steps)
        gap = (end - start) / scale
        if np.max(np.abs(gap)) < CLOSED:
            break
        # Rigid motions may start anywhere: the shortest step leaves them where they are.
        change = np.linalg.lstsq(np.eye(len(start)) - matrix / scale[:, None] * scale, gap, rcond=1e-9)[0]
        start = start + change * scale
    return start, float(np.max(np.abs(gap)))


def _period(system: System, start: Floats, period: float, steps: int) -> tuple[Floats, Floats, Floats]:
    """Return the end of a period, its derivative by the start, and the size of each state."""
    size = len(start) // 2
    position = float(np.max(np.abs(start[:size]))) or STILL
    rate = 2.0 * np.pi / period
    scale = np.repeat([position, max(position * rate, float(np.max(np.abs(start[size:]))))], size)
    starts = np.vstack([start, start + NUDGE * np.diag(scale), start - NUDGE * np.diag(scale)])
    ends = ends_of(system, starts, period, period / steps)
    many = len(start)
    matrix = (ends[1 : many + 1] - ends[many + 1 :]).T / (2.0 * NUDGE * scale)
    return ends[0], matrix, scale


def _start(orbit: Orbit) -> Floats:
    return np.concatenate([orbit.samples.position[0], orbit.samples.velocity[0]])


def _orbit(system: System, start: Floats, *, period: float, steps: int) -> Orbit:
    """Return the orbit from its start, with the multipliers of what is next to it."""
    arrays = system.arrays
    samples = every_step(system, start, period / steps, steps)
    matrix = monodromy(system, samples)
    elastic = split_rigid(arrays)[1]
    basis = np.kron(np.eye(2), elastic)
    inverse = np.kron(np.eye(2), elastic.T * arrays.mass)
    multipliers = np.linalg.eigvals(inverse @ matrix @ basis).astype(np.complex128)
    order = np.argsort(-np.abs(multipliers))
    return Orbit(period, samples, multipliers[order], matrix)


def _forces(orbit: Orbit) -> Forces:
    force = orbit.samples.line_force[:-1]
    size, lines = np.abs(force), np.arange(force.shape[1])
    place, rms = np.argmax(size, axis=0), np.sqrt(np.mean(force**2, axis=0))[None]
    before, peak, after = (force[(place + shift) % len(force), lines] for shift in (-1, 0, 1))
    return Forces(np.abs(peak)[None], rms, 0.125 * np.abs(before - 2.0 * peak + after)[None], 0.0 * rms)


def _error(arrays: Arrays, orbit: Orbit, other: Orbit) -> Error:
    """Return the error of forces, from the orbit at twice the step."""
    units, order = orbit.samples.labels.line_units, PARTING if _parts(arrays, orbit) else SMOOTH
    return errors_of(_forces(orbit), _forces(other), units, ratio=2.0, order=order)[0]


def _parts(arrays: Arrays, orbit: Orbit) -> bool:
    """Whether teeth part."""
    return bool(np.any(orbit.samples.line_deflection[:, arrays.backlash > 0.0] <= 0.0))


def _uncertain(orbit: Orbit, other: Orbit) -> float:
    """Return how far the size of the largest multiplier may be off, from the orbit at twice the step [-]."""
    one, two = (float(np.max(np.abs(found.multipliers), initial=0.0)) for found in (orbit, other))
    return abs(one - two) + MULTIPLIER_ROUNDING
