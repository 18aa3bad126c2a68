"""Steady state: the periodic motion by shooting, and its Floquet multipliers.

One period is integrated from a start and from starts displaced along each state, eight at a time; Newton moves the
start until the motion closes. The derivative of end by start is the monodromy matrix, whose eigenvalues tell whether
the motion is stable: all within the unit circle, but for those of rigid motions, which are left out.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import gcd, lcm

import numpy as np

from gearwright.arrays import Complexes, Floats
from gearwright.dynamics.equations import split_rigid, statics
from gearwright.dynamics.model import Arrays, System
from gearwright.dynamics.motion import Outputs, Samples, default_step, simulate, simulate_many
from gearwright.errors import DesignError, Problem, SolveError
from gearwright.showing import Shown
from gearwright.verbs import verb

CLOSED = 1e-9
"""Gap between end and start of the period over the size of the motion, at which it counts as closed [-]."""
ROUNDS = 30
"""Newton rounds before giving up."""
NUDGE = 1e-6
"""Displacement of a start, over the size of its kind of state, for the derivative [-]."""
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
def periodic(system: System, *, period: float | None = None, step: float | None = None) -> Orbit:
    """Return the periodic motion near static equilibrium.

    Args:
        system: At constant speed.
        period: [s]; left out, the time after which all tones repeat, which with hunting teeth may be long.
        step: Largest step [s]; the period is cut into equal ones.

    Raises:
        SolveError: If Newton's method does not close the motion; under heavy contact loss there may be several
            motions, or none of this period.
    """
    arrays = system.arrays
    period = common_period(arrays) if period is None else period
    steps = int(np.ceil(period / (default_step(arrays) if step is None else step)))
    start = np.zeros(2 * len(arrays.mass))
    start[: len(arrays.mass)] = statics(system, balance="accelerate").position
    for _ in range(ROUNDS):
        end, matrix, scale = _period(system, start, period, steps)
        gap = (end - start) / scale
        if np.max(np.abs(gap)) < CLOSED:
            return _orbit(system, start, matrix, period=period, steps=steps)
        # Rigid motions may start anywhere: the shortest step leaves them where they are.
        change = np.linalg.lstsq(np.eye(len(start)) - matrix / scale[:, None] * scale, gap, rcond=1e-9)[0]
        start = start + change * scale
    raise SolveError(
        f"no motion of period {period:.4g} s closed in {ROUNDS} rounds; the gap is {np.max(np.abs(gap)):.1e}"
    )


def _period(system: System, start: Floats, period: float, steps: int) -> tuple[Floats, Floats, Floats]:
    """Return the end of a period, its derivative by the start, and the size of each state."""
    size = len(start) // 2
    position = np.max(np.abs(start[:size]))
    rate = 2.0 * np.pi / period
    scale = np.repeat([position, max(position * rate, float(np.max(np.abs(start[size:]))))], size)
    starts = np.vstack([start, start + NUDGE * np.diag(scale), start - NUDGE * np.diag(scale)])
    ends = simulate_many([system] * len(starts), period, step=period / steps, start=starts).state
    many = len(start)
    matrix = (ends[1 : many + 1] - ends[many + 1 :]).T / (2.0 * NUDGE * scale)
    return ends[0], matrix, scale


def _orbit(system: System, start: Floats, matrix: Floats, *, period: float, steps: int) -> Orbit:
    size = len(start) // 2
    outputs = Outputs(windows=((0.0, period),))
    ends = (start[:size], start[size:])
    trace = simulate(system, period, step=period / steps, start=ends, outputs=outputs, method="runge-kutta")
    elastic = split_rigid(system.arrays)[1]
    basis = np.kron(np.eye(2), elastic)
    inverse = np.kron(np.eye(2), elastic.T * system.arrays.mass)
    multipliers = np.linalg.eigvals(inverse @ matrix @ basis).astype(np.complex128)
    order = np.argsort(-np.abs(multipliers))
    return Orbit(period, trace.whole().windows[0], multipliers[order], matrix)
