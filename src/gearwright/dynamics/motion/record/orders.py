"""Order amplitudes: how much of a line's force follows each tone, summed up as the run goes.

Least squares on constant, cosine and sine of every tone. Each block adds a product to its bin's normal equations, whose
size does not depend on how long the run is. Speed may change, since angles count and not frequencies.
"""

from __future__ import annotations

import numpy as np

from gearwright.arrays import Floats, Ints
from gearwright.dynamics.equations import speed_factors
from gearwright.dynamics.model import System
from gearwright.dynamics.motion.record.trace import Orders, index_of

ALIKE = 1e-10
"""Share of the largest eigenvalue below which tones cannot be told apart in a bin; they share the amplitude [-]."""


class OrderSums:
    """Normal equations of the lines that were asked for, one set for each bin."""

    def __init__(self, system: System, names: tuple[str, ...], *, step: float, bins: int) -> None:
        self.system, self.names, self.step = system, names, step
        self.columns = np.array([index_of(name, system.labels.lines, "line") for name in names], dtype=np.int64)
        self.turning = np.flatnonzero(system.arrays.tone_rate)
        width = 1 + 2 * len(self.turning)
        self.gram, self.share = np.zeros((bins, width, width)), np.zeros((bins, width, len(names)))

    def add(self, place: int, first: int, forces: Floats) -> None:
        """Add steps to a bin.

        Args:
            place: Bin.
            first: Step of the first row.
            forces: Of all lines, shape (steps, lines).
        """
        arrays = self.system.arrays
        time = np.asarray((first + np.arange(len(forces))) * self.step, dtype=np.float64)
        travel = speed_factors(arrays.profile, time)[2]
        wave = np.exp(1j * np.outer(travel, arrays.tone_rate[self.turning]))
        basis = np.hstack([np.ones((len(wave), 1)), wave.real, wave.imag])
        self.gram[place] += basis.T @ basis
        self.share[place] += basis.T @ forces[:, self.columns]

    def result(self, edges: Ints) -> Orders:
        """Return the amplitudes.

        Args:
            edges: Steps at which bins begin and end.
        """
        tones, bins = len(self.turning), len(edges) - 1
        inverse = np.linalg.pinv(self.gram[:bins], rcond=ALIKE, hermitian=True)
        sums = np.swapaxes(inverse @ self.share[:bins], 1, 2)
        amplitude = (sums[:, :, 1 : 1 + tones] - 1j * sums[:, :, 1 + tones :]).astype(np.complex128)
        labels = tuple(self.system.labels.tones[number] for number in self.turning)
        return Orders(self.names, labels, edges.astype(np.float64) * self.step, amplitude)
