"""Load-sharing coefficients: which share of the load each parallel line carries, at an instant, over a tooth cycle."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gearwright.dynamics.codegen import speed_factors
from gearwright.dynamics.equations import dead_zone
from gearwright.dynamics.model import Arrays, Floats, Ints, Series, System
from gearwright.dynamics.motion import Samples, index_of
from gearwright.errors import DesignError, Problem


def line_numbers(system: System, names: Sequence[str]) -> Ints:
    """Return the places of lines in the arrays.

    Args:
        system: Where they are looked up.
        names: Of parallel lines.
    """
    return np.array([index_of(name, system.labels.lines, "line") for name in names], dtype=np.int64)


def share_coefficients(force: Floats) -> Floats:
    """Return the load-sharing coefficients of parallel lines, b = n F / Σ F; 1 is an equal share [-].

    Args:
        force: Of the n lines [N], shape (..., n).

    Source: Wang, Zhao, Tao, Jia & Guo, eq. 13, for any number of paths.
    """
    return np.asarray(force.shape[-1] * force / np.sum(force, axis=-1, keepdims=True))


def mesh_load_factor(force: Floats) -> float:
    """Return K_γ: the largest force of parallel meshes over their mean [-].

    Args:
        force: Of the n lines [N], shape (..., n).

    Source: ISO 6336-1:2006, clause 4, mesh load factor.
    """
    return float(np.max(share_coefficients(force)))


def tooth_cycle_means(time: Floats, force: Floats, period: float) -> Floats:
    """Return the forces over each tooth cycle: their means in a window of one mesh period [N].

    Args:
        time: Evenly spaced [s], shape (instants,).
        force: Of the n lines [N], shape (instants, n).
        period: Of the mesh [s].

    Returns:
        Shape (instants − window + 1, n); the window is moved on by one instant at a time.

    Raises:
        DesignError: If the period does not fit the instants.
    """
    spacing = (time[-1] - time[0]) / (len(time) - 1)
    window = round(period / spacing)
    if not 1 < window < len(time):
        message = f"a mesh period of {period:.3g} s does not fit {len(time)} instants {spacing:.3g} s apart"
        raise DesignError([Problem("period", message)])
    total = np.cumsum(np.vstack([np.zeros(force.shape[1]), force]), axis=0)
    return np.asarray((total[window:] - total[:-window]) / window)


def tooth_cycle_shares(time: Floats, force: Floats, period: float) -> Floats:
    """Return the coefficients over each tooth cycle: of the means of the forces in a window of one mesh period.

    Args:
        time: Evenly spaced [s], shape (instants,).
        force: Of the n lines [N], shape (instants, n).
        period: Of the mesh [s].

    Returns:
        [-], shape (instants − window + 1, n).

    Source: Wang, Zhao, Tao, Jia & Guo, eq. 13, "for each tooth frequency cycle", read as the mean.
    """
    return share_coefficients(tooth_cycle_means(time, force, period))


def elastic_forces(system: System, samples: Samples) -> Floats:
    """Return the elastic part of the line forces, k(φ) g(δ) [N or N m], shape (instants, lines).

    Args:
        system: Whose motion it is.
        samples: Instants of a trace.
    """
    stiffness = stiffness_at(system, samples.time)
    return np.asarray(stiffness * dead_zone(samples.line_deflection, system.arrays.backlash))


def stiffness_at(system: System, time: Floats) -> Floats:
    """Return the stiffnesses of all lines at some instants [N/m or N m/rad], shape (instants, lines).

    Args:
        system: Whose lines.
        time: [s], shape (instants,).
    """
    arrays = system.arrays
    _, _, travel = speed_factors(arrays.profile, time)
    return np.asarray(arrays.stiffness * (1.0 + _series(arrays, arrays.variation, travel)))


def errors_at(system: System, time: Floats) -> Floats:
    """Return the errors of all lines at some instants [m or rad], shape (instants, lines).

    Args:
        system: Whose errors.
        time: [s], shape (instants,).
    """
    _, _, travel = speed_factors(system.arrays.profile, time)
    return _series(system.arrays, system.arrays.error, travel)


def _series(arrays: Arrays, series: Series, travel: Floats) -> Floats:
    """Fourier sums of all lines at many travels, shape (travels, lines)."""
    lines = len(series.start) - 1
    angle = np.outer(travel, arrays.tone_rate)
    cosine, sine = np.zeros((2, angle.shape[1], lines))
    line = np.repeat(np.arange(lines), np.diff(series.start))
    np.add.at(cosine, (series.tone, line), series.cosine)
    np.add.at(sine, (series.tone, line), series.sine)
    return np.asarray(np.cos(angle) @ cosine + np.sin(angle) @ sine)
