"""Forced response at operating speed: what varying stiffness and stated errors add to the mean force of every mesh."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from gearwright.arrays import Complexes, Ints
from gearwright.blas_threads import one_blas_thread
from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.equations import linear, statics
from gearwright.dynamics.model import System, line_matrix
from gearwright.sizing import Sizing
from gearwright.verbs import verb

UNLOADED = 1e-3
"""Mean force of a mesh over the largest one below which it bears nothing that a factor could count [-]."""


@verb
@one_blas_thread()
def forced_factors(sizing: Sizing, case: str) -> dict[str, float]:
    """Return by how much the steady vibration of a load case raises the force of every mesh row that bears load [-].

    The amplitudes of all tones are added up, as if they met: with teeth that keep contact no instant is worse.

    Args:
        sizing: As sized.
        case: Load case.

    Source: linear response at mean stiffness to the first order of what varies: M ẍ + B ẋ + K x = -Dᵀ (k_n δ_0 - k e_n)
        at every tone; ISO 6336-1:2006, clause 6, method A asks for such an analysis of the whole system.
    """
    system = assemble(sizing, case)
    mean = np.abs(statics(system, balance="accelerate").force)
    swing = np.abs(_line_forces(system)).sum(axis=0)
    meshes = np.array([kind == "mesh" for kind in system.labels.line_kinds])
    least = UNLOADED * float(np.max(mean[meshes], initial=0.0))
    factors = {}
    for mesh in sizing.meshes:
        places = [place for place in system.labels.places_of(mesh.part) if mean[place] > least]
        if places:
            factors[mesh.name] = max(1.0 + float(swing[place] / mean[place]) for place in places)
    return factors


def _line_forces(system: System) -> Complexes:
    """Return the complex amplitude of every line's force at every tone [N or N m], shape (tones, lines)."""
    arrays, matrix, model = system.arrays, line_matrix(system.arrays), linear(system.arrays)
    exciting = _exciting(system)
    rates = np.abs(arrays.tone_rate[: len(exciting)]) * float(arrays.profile.factor[0])
    loud = np.any(exciting != 0.0, axis=1) & (rates > 0.0)
    exciting, rates = exciting[loud], rates[loud]
    left = model.stiffness + 1j * rates[:, None, None] * model.damping
    left = left - (rates**2)[:, None, None] * np.diag(model.mass)
    moved = np.linalg.solve(left, -(exciting @ matrix)[:, :, None])[:, :, 0]
    dynamic = arrays.stiffness + 1j * rates[:, None] * arrays.damping
    return np.asarray(exciting + dynamic * (moved @ matrix.T))


def _exciting(system: System) -> Complexes:
    """Return what varying stiffness at the static deflection and errors put on each line, shape (tones, lines)."""
    arrays = system.arrays
    exciting = np.zeros((len(system.labels.tones), len(arrays.stiffness)), dtype=np.complex128)
    force = statics(system, balance="accelerate").force
    for series, scale in ((arrays.variation, force), (arrays.error, -arrays.stiffness)):
        for row, place in _terms(series.start):
            tone = int(series.tone[place])
            sign = 1.0 if arrays.tone_rate[tone] >= 0.0 else -1.0
            exciting[tone, row] += scale[row] * complex(series.cosine[place], -sign * series.sine[place])
    return exciting


def _terms(start: Ints) -> Iterator[tuple[int, int]]:
    for row in range(len(start) - 1):
        for place in range(int(start[row]), int(start[row + 1])):
            yield row, place
