"""Load-sharing coefficients: which share of the load each parallel line carries, at an instant, over a tooth cycle."""

from __future__ import annotations

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.equations import dead_zone, stiffness_at
from gearwright.dynamics.model import System
from gearwright.dynamics.motion import Samples
from gearwright.errors import DesignError, Problem


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
