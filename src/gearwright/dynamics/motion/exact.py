"""Exact steps for constant stiffness: one matrix carries state, constant loads and tones over any time.

With linear lines and harmonic errors, z = (q, q̇, 1, cos φ, sin φ) obeys ż = A z, so z(t + h) = expm(A h) z(t): the step
makes no error. The works are quadratic in z and double with the step as Φ does.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwright.base import Floats, Ints, one_blas_thread
from gearwright.dynamics.model import Arrays, entry_matrix, line_matrix, planned


class Propagator(NamedTuple):
    """What carries a block of steps."""

    step: Floats
    """expm(A h), shape (extended states, extended states)."""
    output: Floats
    """Line forces and deflections from z, shape (2 lines, extended states)."""
    powers: tuple[Floats, ...]
    """expm(A h 2^i) for i = 0, 1, …"""
    works: tuple[Floats, ...]
    """Quadratic forms of z whose values are the works during 2^i steps, shape (6, extended, extended) each."""


@planned
def is_exact(arrays: Arrays) -> bool:
    """Tell whether the exact step applies: constant stiffness and speed, loads linear in speed, no backlash or drives.

    Args:
        arrays: The system's numbers.
    """
    linear = not (np.any(arrays.backlash > 0.0) or len(arrays.variation.tone) or np.any(arrays.loads.quadratic))
    steady = len(arrays.loads.schedules.dof) == 0 and bool(np.all(arrays.profile.factor == arrays.profile.factor[0]))
    return linear and steady and len(arrays.drives.table) == 0


def extended_state(arrays: Arrays, time: float, state: Floats) -> Floats:
    """Return z = (q, q̇, 1, cos φ, sin φ), shape (extended states,).

    Args:
        arrays: The system's numbers.
        time: [s].
        state: q and q̇ (and anything after them), shape (at least 2 coordinates,).
    """
    parts = [state[: 2 * len(arrays.mass)], np.ones(1)]
    if len(arrays.error.tone):
        angle = arrays.tone_rate[_tones(arrays)] * arrays.profile.factor[0] * time
        parts += [np.cos(angle), np.sin(angle)]
    return np.concatenate(parts)


def propagator(arrays: Arrays, h: float, doublings: int) -> Propagator:
    """Return the exact step and its powers.

    Args:
        arrays: The system's numbers, such that `is_exact`.
        h: Step [s].
        doublings: Powers kept: works of blocks of up to 2^doublings steps.
    """
    from scipy import linalg

    rate, rows = _extended(arrays)
    with one_blas_thread():
        powers, works = [linalg.expm(rate * h)], [_works(arrays, rate, rows, h)]
        for _ in range(doublings):
            works.append(_twice(works[-1], powers[-1]))
            powers.append(powers[-1] @ powers[-1])
    return Propagator(powers[0], np.vstack([rows.force, rows.deflection]), tuple(powers), tuple(works))


def _twice(works: Floats, carry: Floats) -> Floats:
    """Return the works of twice the time; most systems have no use for all six."""
    both = works.copy()
    for number in np.flatnonzero(np.any(works, axis=(1, 2))):
        both[number] += carry.T @ works[number] @ carry
    return both


def works_during(carry: Propagator, start: Floats, steps: int) -> tuple[Floats, Floats]:
    """Return the works during a number of steps [J], shape (6,), and z after them: powers of two at a time.

    Args:
        carry: Step, powers and works.
        start: z at the first step, shape (extended states,).
        steps: Number of steps.
    """
    total = np.zeros(len(carry.works[0]))
    for i, (power, works) in enumerate(zip(carry.powers, carry.works, strict=True)):
        if steps >> i & 1:
            total += (works.reshape(-1, len(start)) @ start).reshape(len(total), -1) @ start
            start = power @ start
    return total, start


def first_powers(carry: Propagator, count: int) -> Floats:
    """Return what carries z to each of the first steps, expm(A h i) for i = 0, 1, … below each other.

    Args:
        carry: Step, powers and works.
        count: How many.
    """
    powers = [np.eye(len(carry.step))]
    for _ in range(1, count):
        powers.append(carry.step @ powers[-1])
    return np.vstack(powers)


class _Rows(NamedTuple):
    """Quantities that are linear in z."""

    force: Floats
    deflection: Floats
    rate: Floats
    error_rate: Floats
    load: Floats
    velocity: Floats
    frame: Floats


def _extended(arrays: Arrays) -> tuple[Floats, _Rows]:
    """Return A and the rows that read quantities from z."""
    size, rates = len(arrays.mass), arrays.tone_rate[_tones(arrays)]
    tones = len(rates)
    width = 2 * size + 1 + 2 * tones
    factor = float(arrays.profile.factor[0])
    turning = np.zeros((2 * tones, 2 * tones))
    turning[:tones, tones:] = np.diag(-rates * factor)
    turning[tones:, :tones] = np.diag(rates * factor)
    error = _error_rows(arrays, width)
    error_rate = np.zeros_like(error)
    error_rate[:, 2 * size + 1 :] = error[:, 2 * size + 1 :] @ turning
    matrix = line_matrix(arrays)
    deflection, rate = -error, -error_rate
    deflection[:, :size] += matrix
    rate[:, size : 2 * size] += matrix
    rate[:, 2 * size] += factor * arrays.slip
    force = arrays.stiffness[:, None] * deflection + arrays.damping[:, None] * rate
    velocity = np.eye(size, width, size)
    load = -arrays.loads.damping[:, None] * velocity
    load[:, 2 * size] = arrays.loads.constant
    frame = factor**2 * entry_matrix(arrays.centripetal, size) @ np.eye(size, width)
    frame -= factor * entry_matrix(arrays.gyroscopic, size) @ velocity
    slope = np.zeros((width, width))
    slope[:size] = velocity
    slope[size : 2 * size] = (load + frame - matrix.T @ force) / arrays.mass[:, None]
    slope[2 * size + 1 :, 2 * size + 1 :] = turning
    return slope, _Rows(force, deflection, rate, error_rate, load, velocity, frame)


def _tones(arrays: Arrays) -> Ints:
    """Return the tones that errors use; those of a stiffness that does not vary would only cost time."""
    return np.unique(arrays.error.tone)


def _error_rows(arrays: Arrays, width: int) -> Floats:
    error, tones, first = arrays.error, _tones(arrays), 2 * len(arrays.mass) + 1
    rows = np.zeros((len(error.start) - 1, width))
    line = np.repeat(np.arange(len(rows)), np.diff(error.start))
    place = first + np.searchsorted(tones, error.tone)
    np.add.at(rows, (line, place), error.cosine)
    np.add.at(rows, (line, place + len(tones)), error.sine)
    return rows


def _works(arrays: Arrays, rate: Floats, rows: _Rows, h: float) -> Floats:
    """Return ∫ expm(Aᵀs) W expm(As) ds over a step for the power forms W: Gauss on a short piece, then doubling."""
    size = len(arrays.mass)
    total = rows.velocity.copy()
    total[:, 2 * size] += arrays.speed * arrays.profile.factor[0]
    drives = arrays.loads.constant * arrays.speed >= 0.0
    forms = np.array(
        [
            rows.load[drives].T @ total[drives],
            -rows.load[~drives].T @ total[~drives],
            rows.rate.T @ (arrays.damping[:, None] * rows.rate),
            np.zeros_like(rate),
            -rows.error_rate.T @ rows.force,
            rows.frame.T @ rows.velocity,
        ]
    )
    fastest = float(np.max(np.abs(np.linalg.eigvals(rate))))
    halvings = max(0, int(np.ceil(np.log2(max(fastest * h, 1e-300) / 0.5))))
    return _doubled(rate * (h / 2**halvings), forms * (h / 2**halvings), halvings)


def _doubled(rate: Floats, forms: Floats, halvings: int) -> Floats:
    from scipy import linalg

    nodes, weights = np.polynomial.legendre.leggauss(6)
    sums = np.zeros_like(forms)
    for node, weight in zip(nodes, weights, strict=True):
        carry = linalg.expm(rate * 0.5 * (node + 1.0))
        sums += 0.5 * weight * (carry.T @ forms @ carry)
    carry = linalg.expm(rate)
    for _ in range(halvings):
        sums = _twice(sums, carry)
        carry = carry @ carry
    return sums
