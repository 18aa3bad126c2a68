"""Steady state under errors and varying mesh stiffness: harmonic balance with mesh sidebands, all lines in contact.

With contact held the system is linear, so that every error frequency is its own problem. The varying stiffness spreads
it to the sidebands ω + Σ n_m Ω_m around it (Ω_m: mesh frequencies). Without sidebands this is the frequency response at
mean stiffness, with the slow limit of the closed form.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Complexes, Floats
from gearwright.dynamics.equations.linear import linear
from gearwright.dynamics.equations.modes import split_rigid
from gearwright.dynamics.model import Arrays, Series, System, line_matrix
from gearwright.errors import DesignError, Problem

SAME = 1e-9
"""Relative distance under which two frequencies are one [-]."""
LARGEST = 6000
"""Unknowns of one balance: beyond, integration is quicker."""


class SteadyForces(NamedTuple):
    """Elastic line forces as a sum of harmonics."""

    rate: Floats
    """Circular frequencies, also negative ones [rad/s], shape (harmonics,)."""
    amplitude: Complexes
    """f(t) = Re Σ amplitude e^(iωt) [N or N m], shape (harmonics, lines)."""

    def at(self, time: Floats) -> Floats:
        """Return the forces at some instants [N or N m], shape (instants, lines).

        Args:
            time: [s], shape (instants,).
        """
        return np.asarray((np.exp(1j * np.outer(time, self.rate)) @ self.amplitude).real)


def steady_forces(system: System, *, sidebands: int = 3) -> SteadyForces:
    """Return the steady elastic line forces under constant loads, errors and varying stiffness.

    Args:
        system: At reference speed, all lines in contact.
        sidebands: Largest Σ |n_m|; 0 takes the mean stiffness.

    Raises:
        DesignError: If there are so many mesh frequencies that the balance would be too large.

    Source: harmonic balance of a linear system with periodic coefficients (Hill 1886), one sideband order at a time.
    """
    arrays = system.arrays
    meshes = _spectrum(arrays, arrays.variation)
    stiffness = {rate: value * arrays.stiffness for rate, value in meshes.items()}
    shifts = _shifts(tuple(rate for rate in stiffness if rate > 0.0), sidebands)
    if not sidebands:
        stiffness = {}
    unknowns = len(shifts) * len(arrays.mass)
    if unknowns > LARGEST:
        message = f"{sidebands} sidebands of all meshes make {unknowns} unknowns; take fewer, or method 'dynamics'"
        raise DesignError([Problem("sidebands", message)])
    balance = _Balance(system, stiffness)
    parts = [balance.solve(base, shifts, error) for base, error in _bases(arrays)]
    return SteadyForces(np.concatenate([rate for rate, _ in parts]), np.concatenate([force for _, force in parts]))


def _spectrum(arrays: Arrays, series: Series) -> dict[float, Complexes]:
    """Return circular frequency -> two-sided amplitude of each line's series; equal frequencies are one."""
    lines = len(arrays.stiffness)
    spectrum: dict[float, Complexes] = {}
    line = np.repeat(np.arange(lines), np.diff(series.start))
    for j, tone, a, b in zip(line, series.tone, series.cosine, series.sine, strict=True):
        rate = float(arrays.tone_rate[tone] * arrays.profile.factor[0])
        for sign in (1.0, -1.0) if rate else (1.0,):
            place = _same(sign * rate, spectrum)
            spectrum.setdefault(place, np.zeros(lines, dtype=np.complex128))
            spectrum[place][j] += (a - 1j * sign * b) / (2.0 if rate else 1.0)
    return spectrum


def _same(rate: float, spectrum: dict[float, Complexes]) -> float:
    return next((known for known in spectrum if abs(known - rate) <= SAME * max(abs(known), abs(rate))), rate)


def _bases(arrays: Arrays) -> Iterator[tuple[float, Complexes]]:
    """Yield the error frequencies, zero first, with one-sided complex amplitudes."""
    spectrum = _spectrum(arrays, arrays.error)
    yield 0.0, spectrum.get(0.0, np.zeros(len(arrays.stiffness), dtype=np.complex128))
    for rate, amplitude in spectrum.items():
        if rate > 0.0:
            yield rate, 2.0 * amplitude


def _shifts(meshes: tuple[float, ...], sidebands: int) -> Floats:
    """Return Σ n_m Ω_m for all Σ |n_m| up to the order; multiples of a mesh frequency are its own harmonics."""
    ground = [
        rate for rate in meshes
        if not any(slower < rate and abs(rate / slower - round(rate / slower)) < SAME for slower in meshes)
    ]  # fmt: skip
    orders = range(-sidebands, sidebands + 1)
    counts = [count for count in product(orders, repeat=len(ground)) if sum(map(abs, count)) <= sidebands]
    return np.array(sorted({round(float(np.dot(count, ground)), 9) if count else 0.0 for count in counts}))


class _Balance:
    """The system in its elastic motions, ready for one frequency after the other."""

    def __init__(self, system: System, stiffness: dict[float, Complexes]) -> None:
        arrays, model = system.arrays, linear(system.arrays)
        _, elastic = split_rigid(arrays)
        self.matrix = line_matrix(arrays) @ elastic
        self.mass = elastic.T @ (model.mass[:, None] * elastic)
        self.damping = elastic.T @ model.damping @ elastic
        self.stiffness = elastic.T @ model.stiffness @ elastic
        self.load = elastic.T @ arrays.loads.constant
        self.mean, self.damper, self.varying = arrays.stiffness, arrays.damping, stiffness

    def solve(self, base: float, shifts: Floats, error: Complexes) -> tuple[Floats, Complexes]:
        """Return the frequencies around one error frequency and the elastic line forces there."""
        rates = base + shifts
        size, centre = len(self.mass), int(np.argmin(np.abs(shifts)))
        coupling = self._coupling(shifts)
        left = np.zeros((len(rates), size, len(rates), size), dtype=np.complex128)
        right = np.zeros((len(rates), size), dtype=np.complex128)
        for i, rate in enumerate(rates):
            left[i, :, i] = self.stiffness + 1j * rate * self.damping - rate**2 * self.mass
            for k, values in coupling[i].items():
                left[i, :, k] += self.matrix.T @ (values[:, None] * self.matrix)
            right[i] = self.matrix.T @ (self._values(coupling, i, centre) * error)
        right[centre] += self.matrix.T @ (1j * base * self.damper * error)
        right[centre] += self.load if base == 0.0 else 0.0
        shape = len(rates) * size
        position = np.linalg.solve(left.reshape(shape, shape), right.ravel()).reshape(len(rates), size)
        stretch = position @ self.matrix.T
        stretch[centre] -= error
        force = stretch * self.mean
        for i, row in enumerate(coupling):
            for k, values in row.items():
                force[i] += values * stretch[k]
        return rates, force

    def _coupling(self, shifts: Floats) -> list[dict[int, Complexes]]:
        """Return for each frequency which others reach it, and through which stiffness."""
        coupling: list[dict[int, Complexes]] = [{} for _ in shifts]
        for i, to in enumerate(shifts):
            for k, source in enumerate(shifts):
                for rate, values in self.varying.items():
                    if abs(to - source - rate) < 1e-6:
                        coupling[i][k] = values
        return coupling

    def _values(self, coupling: list[dict[int, Complexes]], i: int, centre: int) -> Complexes:
        """Return the stiffness through which an error at the centre reaches a frequency."""
        mean = self.mean.astype(np.complex128) if i == centre else np.zeros(len(self.mean), dtype=np.complex128)
        return mean + coupling[i].get(centre, 0.0)
