"""Bounds on the rates and the damping of large systems, which take no eigenvalues: safe, and never far from them.

Source: Collatz 1942, Math. Z. 48, 221-226: the largest eigenvalue of a matrix without negative entries is at most
max (A x)_i / x_i for any positive x; those of A are at most those of |A|.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.model import CLUTCH, Arrays, holding

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
    stiff, damped, slipping = _clutches(arrays)
    square = _largest(_spread(arrays, arrays.stiffness * (1.0 + swing)), len(arrays.mass)) + stiff
    damping = _largest(_spread(arrays, arrays.damping), len(arrays.mass)) + max(0.0, float(np.max(own))) + damped
    half = 0.5 * (damping + _spin(arrays) * top)
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


def _largest(times: Callable[[Floats], Floats], size: int) -> float:
    """Return a bound on the largest eigenvalue of a matrix without negative entries."""
    vector, bound = np.ones(size), np.inf
    for _ in range(ROUNDS):
        product = times(vector)
        bound = min(bound, float(np.max(product / vector)))
        if not bound > 0.0:
            return 0.0
        vector = np.maximum(product / np.max(product), SMALLEST)
    return bound


def _clutches(arrays: Arrays) -> tuple[float, float, float]:
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


def _spin(arrays: Arrays) -> float:
    """Return a bound on the norm of the gyroscopic terms at the reference speeds [rad/s]: √(‖G‖₁ ‖G‖∞)."""
    row, column, value = arrays.gyroscopic
    size, root = len(arrays.mass), np.sqrt(arrays.mass)
    scaled = np.abs(value) / (root[row] * root[column])
    sums = [float(np.max(np.bincount(place, scaled, minlength=size), initial=0.0)) for place in (row, column)]
    return float(np.sqrt(sums[0] * sums[1]))
