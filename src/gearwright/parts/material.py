"""The properties of a gear or shaft material that the rating methods need."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from gearwright.units import Density, Number, Quantity, Ratio, Stress


@dataclass(frozen=True)
class Material:
    """A steel, as far as it is known: what is not known is None, and a method that needs it says so."""

    name: str
    """Name in the catalogue."""
    elastic_modulus: Stress
    """Young's modulus E [Pa]."""
    poisson_ratio: Ratio
    """Poisson's ratio ν [-]."""
    density: Density
    """Density ρ [kg/m³]."""
    yield_strength: Annotated[float | None, Quantity("stress")] = None
    """0.2 % proof stress R_p0.2 of the core [Pa]."""
    surface_hardness: Annotated[float | None, Quantity("number")] = None
    """Brinell-equivalent hardness of the flank, HB [-]."""
    ultimate_strength: Annotated[float | None, Quantity("stress")] = None
    """Tensile strength R_m of the core [Pa]."""
    group: str | None = None
    """How its strength falls with size: a name of `SteelGroup` of DIN 743."""
    source: str = ""
    """Where the values come from."""

    @property
    def shear_modulus(self) -> float:
        """G = E / (2 (1 + ν)) [Pa]."""
        return self.elastic_modulus / (2.0 * (1.0 + self.poisson_ratio))


CONTACT_STRENGTH_PER_HARDNESS: Number = 2.5e6
"""Static contact strength σ_H0 = 2.5 HB in MPa, here in Pa per HB (Pulvirenti 2023, eq. 2.2)."""


def contact_strength(hardness: float) -> float:
    """Return the contact pressure σ_H0 that a flank of given hardness bears [Pa].

    Args:
        hardness: Brinell-equivalent hardness HB [-].

    Source: Pulvirenti 2023, eq. (2.2), σ_H0 = 2.5 HB in N/mm².

    >>> contact_strength(600.0)
    1500000000.0
    """
    return CONTACT_STRENGTH_PER_HARDNESS * hardness
