"""What the search for teeth works on: a front of partial choices as arrays, and one task per stage."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from gearwright.arrays import Bools, Floats, Ints
from gearwright.sizing.rating import Rating
from gearwright.spec import Pair, Planetary
from gearwright.train import Edge


@dataclass(frozen=True)
class Front:
    """All partial choices: every array has one entry per choice."""

    teeth: Mapping[str, Ints]
    """Gear -> tooth numbers."""
    speeds: Mapping[str, Floats]
    """Shaft -> speed that the teeth give [rad/s]."""
    cubes: Mapping[str, Floats]
    """Group of gears with one module -> m_n³ [m³]."""
    volumes: Mapping[str, Floats]
    """Group -> mass of its bodies over m_n³ [kg/m³]."""

    @property
    def mass(self) -> Floats:
        """Mass of the gears chosen so far [kg]."""
        parts = [self.cubes[group] * self.volumes[group] for group in self.cubes]
        return np.sum(parts, axis=0) if parts else np.zeros(1)

    def take(self, index: Ints | Bools) -> Front:
        """Return the choices of an index, repeated where it repeats them, or those that are marked."""
        picked = [
            {name: value[index] for name, value in part.items()} for part in (self.speeds, self.cubes, self.volumes)
        ]
        return Front({name: value[index] for name, value in self.teeth.items()}, *picked)


@dataclass(frozen=True)
class Task:
    """One stage of the search."""

    name: str
    stage: Pair | Planetary
    edge: Edge | None
    group: str
    rating: Rating
    torque: float
    """Largest nominal torque on the stage's reference gear per mesh, share and K_γ included [N m]."""
    speed: float
    """Nominal speed that belongs to it [rad/s]."""
    rolling: float
    """Nominal speed of pinion or sun against the carrier [rad/s]."""
