"""Sensitivity: whether neighbouring motions part, so that a run may be judged by its statistics only."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.equations import WORKS
from gearwright.dynamics.model import Arrays
from gearwright.dynamics.motion.record import BLOCK
from gearwright.dynamics.motion.steps import Stepper, blank_record

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
