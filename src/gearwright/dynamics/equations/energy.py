"""Energy: where the work of a run came from and where it went, and whether it adds up."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from gearwright.units import Energy, Origin, Quantity

WORKS = 6
"""Energies that run along with the state: all of `Work` but what is stored."""


ROUNDING = 1e-11
"""Share of the energy that is held which counts as rounding: a train at rest on its rigid motion moves none [-]."""


@dataclass(frozen=True)
class Work:
    """Energy balance of a run, from its start to its end."""

    driven: Energy
    """Work of loads that drive their coordinate [J]."""
    braked: Energy
    """Work taken out by loads that resist [J]."""
    dissipated: Annotated[float, Quantity("energy"), Origin("∫ Σ c δ̇² dt", "energy balance of the lines")]
    """Heat in the lines' dampers [J]."""
    stiffness: Annotated[float, Quantity("energy"), Origin("∫ Σ ½ k̇ g² dt", "energy balance of the lines")]
    """Work of the changing stiffness [J]."""
    error: Annotated[float, Quantity("energy"), Origin("−∫ Σ ė f dt", "energy balance of the lines")]
    """Work of errors that move under force [J]."""
    frame: Energy
    """Work that keeps a rotating frame at its speed [J]."""
    stored: Energy
    """Growth of kinetic and elastic energy [J]."""
    held: Energy
    """Kinetic and elastic energy at the end [J]: what rounding is measured by."""

    @property
    def imbalance(self) -> float:
        """What does not add up, over all the work that was moved [-]; zero where it is only rounding."""
        gain = self.driven - self.braked - self.dissipated + self.stiffness + self.error + self.frame
        moved = sum(abs(work) for work in (self.driven, self.braked, self.dissipated, self.stored))
        missing = abs(gain - self.stored)
        return missing / moved if missing > ROUNDING * self.held else 0.0
