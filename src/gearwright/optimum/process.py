"""Gaussian processes: what a result may be at places that were not looked at, and how far that is off where they were.

Source: Rasmussen, Williams 2006, Gaussian Processes for Machine Learning, MIT Press: eq. 2.25 and 2.26 (prediction),
4.17 (Matérn, ν = 5/2), 5.8 (likelihood), 5.12 (each left out). The variance is the likeliest one for the lengths.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.blas_threads import one_blas_thread

LENGTHS = (0.05, 20.0)
"""Least and largest length over which a result changes, over a freedom's range [-]."""
NOISE = (1e-8, 1.0)
"""Least and largest part of the variance that places do not explain: steps of modules and teeth [-]."""


class Process(NamedTuple):
    """What is known of one result by places and its values there."""

    places: Floats
    """Shape (n, freedoms)."""
    logs: Floats
    """Logarithms of a length for every freedom, and of the noise."""
    mean: float
    scale: float
    variance: float
    """Of the values over their scale [-]."""
    factor: Floats
    """Lower Cholesky factor of the correlations, shape (n, n)."""
    weights: Floats
    """Correlations' inverse times the values over their scale, shape (n,)."""

    @one_blas_thread()
    def at(self, places: Floats) -> tuple[Floats, Floats]:
        """Return mean and standard deviation of the result at places.

        Args:
            places: Shape (rows, freedoms).
        """
        from scipy.linalg import solve_triangular

        across = _correlation(places, self.places, self.logs[:-1])
        spread = solve_triangular(self.factor, across.T, lower=True)
        left = np.maximum(1.0 - np.einsum("ij,ij->j", spread, spread), 0.0)
        return self.mean + self.scale * (across @ self.weights), self.scale * np.sqrt(self.variance * left)

    @property
    @one_blas_thread()
    def left_out(self) -> Floats:
        """By how much the others foretell each value wrong, lengths kept, shape (n,)."""
        from scipy.linalg import cho_solve

        inverse = cho_solve((self.factor, True), np.eye(len(self.places)))
        return np.asarray(self.scale * self.weights / np.diag(inverse))


@one_blas_thread()
def fitted(places: Floats, values: Floats, start: Floats | None = None) -> Process:
    """Return the process of values at places, with the likeliest lengths and noise.

    Args:
        places: Shape (n, freedoms), n of 2 or more.
        values: Shape (n,).
        start: Logarithms where the likeliest are looked for; left out: halves of ranges, and little noise.
    """
    from scipy.optimize import minimize

    freedoms = places.shape[1]
    start = np.log([0.5] * freedoms + [1e-3]) if start is None else start
    bounds = [tuple(map(math.log, LENGTHS))] * freedoms + [tuple(map(math.log, NOISE))]
    found = minimize(lambda logs: _unlikely(places, values, logs), start, method="L-BFGS-B", bounds=bounds,
                     options={"maxiter": 30})  # fmt: skip
    return conditioned(places, values, found.x)


@one_blas_thread()
def conditioned(places: Floats, values: Floats, logs: Floats) -> Process:
    """Return the process of values at places with given lengths and noise.

    Args:
        places: Shape (n, freedoms).
        values: Shape (n,).
        logs: Logarithms of a length for every freedom, and of the noise.
    """
    from scipy.linalg import cho_solve

    mean, scale = float(values.mean()), float(values.std()) or 1.0
    own = (values - mean) / scale
    matrix = _correlation(places, places, logs[:-1]) + math.exp(logs[-1]) * np.eye(len(places))
    factor: Floats = np.linalg.cholesky(matrix + NOISE[0] * np.eye(len(places))).astype(np.float64)
    weights = cho_solve((factor, True), own)
    return Process(places, logs, mean, scale, max(float(own @ weights) / len(own), 1e-12), factor, weights)


def _unlikely(places: Floats, values: Floats, logs: Floats) -> float:
    """Return the negative logarithm of the likelihood but for a constant."""
    own = conditioned(places, values, logs)
    return float(0.5 * len(values) * math.log(own.variance) + np.log(np.diag(own.factor)).sum())


def _correlation(one: Floats, other: Floats, logs: Floats) -> Floats:
    """Return Matérn's correlation of places, ν = 5/2, shape (one, other)."""
    lengths = np.exp(logs)
    square = np.square((one[:, None] - other[None]) / lengths).sum(axis=2)
    far = np.sqrt(5.0 * square)
    return np.asarray((1.0 + far + 5.0 / 3.0 * square) * np.exp(-far))
