"""First critical speed in bending of masses on a shaft."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem
from gearwright.parts.shafts.deflection import Sections


def critical_speed(coefficients: Floats, masses: ArrayLike) -> float:
    """Return the first critical speed of masses on a shaft without gyroscopic effect [rad/s].

    Args:
        coefficients: From `influence` [m/N], (n, n).
        masses: [kg], (n,).

    Source: largest root of |δ_ij m_j − I/ω²| = 0 (Budynas & Nisbett, Shigley, eqs (7-26) to (7-28)).
    """
    weights = np.asarray(masses, dtype=float)
    if weights.min(initial=0.0) < 0.0 or weights.sum() <= 0.0:
        raise DesignError([Problem("masses", f"{weights.tolist()} kg given; none is below 0, and some are above")])
    roots = np.sqrt(weights)
    return float(1.0 / math.sqrt(np.linalg.eigvalsh(roots[:, None] * coefficients * roots)[-1]))


def lumped_shaft(sections: Sections, density: float, *, pieces: int = 40) -> tuple[Floats, Floats]:
    """Return a shaft's own mass as points: places [m] and masses [kg], each (pieces,).

    Args:
        sections: Of the shaft [m].
        density: ρ [kg/m³].
        pieces: Equal lengths [-].

    Source: ρ π/4 (d² − d_i²) L of the cylinder in the middle of each piece.
    """
    edges = np.linspace(sections.edges[0], sections.edges[-1], pieces + 1)
    middle = (edges[:-1] + edges[1:]) / 2.0
    within = np.searchsorted(sections.edges, middle, side="right") - 1
    area = math.pi / 4.0 * (sections.diameter**2 - sections.bore**2)[within]
    return middle, density * area * np.diff(edges)
