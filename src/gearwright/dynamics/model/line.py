"""What joins bodies, as a researcher writes it: a line with stiffness, damping, backlash, variation and errors."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.model.system import NOBODY, Owner

Kind = Literal["mesh", "shaft", "support", "damper", "line"]


@dataclass(frozen=True)
class DampingRatio:
    """Damping as a share of the critical one: c = 2 ζ √(k m_eff) with 1/m_eff = d·M⁻¹d."""

    value: float
    """ζ [-]."""

    def damper(self, stiffness: float, mobility: float) -> float:
        """Return c [N s/m or N m s/rad].

        Args:
            stiffness: k [N/m or N m/rad].
            mobility: 1/m_eff = d·M⁻¹d [1/kg or 1/(kg m²)].
        """
        return 2.0 * self.value * math.sqrt(stiffness / mobility)


@dataclass(frozen=True)
class Periodic:
    """A quantity that repeats with an angle: constant + Σ_n a_n cos nψ + b_n sin nψ, ψ = φ + offset, n = 1, 2, …"""

    phase: Mapping[str, int] = field(default_factory=dict)
    """φ as integers of rotations: teeth for a mesh ({"sun": 28, "carrier": -28}), 1 for run-out."""
    cosine: Sequence[float] = ()
    """a_1, a_2, …: [-] relative to the mean stiffness, or [m or rad] for an error."""
    sine: Sequence[float] = ()
    """b_1, b_2, …, in the unit of a."""
    offset: float = 0.0
    """Angle added to φ [rad]: 2π times the relative mesh phase."""
    constant: float = 0.0
    """Part that does not change; only for errors."""

    def harmonics(self) -> tuple[Floats, Floats]:
        """Return cosine and sine coefficients in φ itself, with the offset worked in, shape (orders,) each."""
        orders = max(len(self.cosine), len(self.sine))
        a, b = np.zeros(orders), np.zeros(orders)
        a[: len(self.cosine)] = self.cosine
        b[: len(self.sine)] = self.sine
        angle = self.offset * np.arange(1, orders + 1)
        return a * np.cos(angle) + b * np.sin(angle), b * np.cos(angle) - a * np.sin(angle)

    def minimum(self) -> float:
        """Return the smallest value over a turn of φ, sampled at 64 points of the highest order."""
        a, b = self.harmonics()
        angle = np.outer(
            2.0 * np.pi * np.linspace(0.0, 1.0, 64 * max(len(a), 1), endpoint=False), np.arange(1, len(a) + 1)
        )
        return self.constant + float(np.min(np.cos(angle) @ a + np.sin(angle) @ b))


@dataclass(frozen=True)
class Line:
    """One spring and damper between coordinates: a mesh's line of action, a shaft's twist, a bearing's direction."""

    name: str
    """Unique name."""
    weights: Mapping[str, float]
    """d: deflection per coordinate, by coordinate name [m/rad for a mesh, - for a shaft or support]."""
    stiffness: float
    """Mean stiffness [N/m, or N m/rad if the deflection is an angle]; 0 for a damper, and for nothing else."""
    damping: float | DampingRatio = 0.0
    """c [N s/m or N m s/rad], or a share of the critical damping."""
    backlash: float = 0.0
    """Dead zone [m or rad]: 0 is linear; infinity never touches on its back. Force is zero for −backlash < δ < 0."""
    variation: Periodic | None = None
    """Stiffness over its mean, less 1, against the mesh phase."""
    errors: Sequence[Periodic] = ()
    """Errors that add up to e(φ) [m or rad]; a positive one opens the line."""
    kind: Kind = "line"
    """What it stands for, for tables and figures."""
    owner: Owner = NOBODY
    """Whose it is."""
    turns_along: bool = False
    """Whether its other end turns with the rigid motion, as a heavy machine does: it holds what turns beside it."""
