"""Sensitivity: whether neighbouring motions part, so that a run may be judged by its statistics only."""

from __future__ import annotations

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.model import Arrays
from gearwright.dynamics.motion.record import BLOCK
from gearwright.dynamics.motion.steps import Stepper, blank_record

NUDGE = 1e-9
"""Displacement of the twin's lines over their largest deflection [-]."""
PARTED = 1e3
"""Growth of the distance between the twins beyond which the motion counts as sensitive [-]."""
BLOCKS = 60
"""Blocks over which the twins run side by side."""


def parting(arrays: Arrays, advance: Stepper, first: int, state: Floats, step: float) -> tuple[float, float]:
    """Return by what factor the distance between a run's end and a displaced twin grows as both run on, and how fast.

    Distances are of line deflections, so that rigid motions, which drift apart steadily, do not count. They stop
    growing when the twins are as far apart as the motion is large.

    Args:
        arrays: The system's numbers.
        advance: Its stepper.
        first: Step at which the twins part.
        state: q, q̇ and works there.
        step: [s].

    Returns:
        The factor [-], and the mean rate up to a tenth of it [1/s], about the largest Lyapunov exponent.
    """
    size, lines = len(arrays.mass), len(arrays.stiffness)
    twins = [state.copy(), state.copy()]
    records = [blank_record(arrays, BLOCK) for _ in twins]
    columns = slice(2 * size + lines, 2 * (size + lines))
    apart = []
    for block in range(BLOCKS):
        for twin, record in zip(twins, records, strict=True):
            advance(first + block * BLOCK, record, twin)
        if block == 0:
            scale = np.max(np.abs(records[0][:, :size]), axis=0)
            twins[1][:size] += NUDGE * scale * np.random.default_rng(0).uniform(0.5, 1.0, size)
        else:
            apart.append(float(np.max(np.abs(records[1][:, columns] - records[0][:, columns]))))
    if not apart[0] > 0.0:
        return 1.0, 0.0
    growth = np.array(apart[1:]) / apart[0]
    grown = int(np.argmax(growth >= 0.1 * np.max(growth)))
    return float(np.max(growth)), float(np.log(max(growth[grown], 1e-300)) / ((grown + 1) * BLOCK * step))
