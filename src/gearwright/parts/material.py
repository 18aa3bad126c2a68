"""The properties of a gear or shaft material that the rating methods need."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated

from gearwright.units import Density, Number, Quantity, Ratio, Stress

STEEL_MODULUS: Stress = 206e9
"""E of steel in the formulas of gears, E_St [Pa] (ISO 6336-1, clause 9; ISO 6336-2, table of Z_E)."""
STEEL_POISSON: Ratio = 0.3
"""ν of steel there [-] (ISO 6336-2, table of Z_E)."""
STEEL_DENSITY: Density = 7830.0
"""ρ of steel there [kg/m³] (ISO 6336-1, clause 6)."""


@dataclass(frozen=True)
class LifeLine:
    """The S-N line of a flank or a root up to its knee, beyond which it bends towards 1e10 cycles and goes on."""

    knee_cycles: Number
    """Cycles at which the steel bears its strength σ_Hlim or σ_Flim [-]."""
    exponent: Ratio
    """p of N ~ σ^(−p) below the knee [-]."""
    static_factor: Annotated[float | None, Quantity("ratio")] = None
    """What few cycles may add: largest stress over the strength [-]; None: that of the treatment."""
    factor_at_1e10: Annotated[float | None, Quantity("ratio")] = None
    """Stress over the strength at 1e10 cycles [-]; None: that of the standard."""


@dataclass(frozen=True)
class Material:
    """A steel, as far as it is known: what is not known is None, and a method that needs it says so."""

    name: str
    """Name in the catalogue, or in the design that states it."""
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
    hardness: Annotated[float | None, Quantity("number")] = None
    """Vickers hardness of the flank, HV [-]."""
    steel: str | None = None
    """Its class in the table of ISO 6336-5, which sets its life curves and factors of size, surface and notch."""
    grade: str | None = None
    """Material quality ML, MQ or ME of ISO 6336-5."""
    contact_strength: Annotated[float | None, Quantity("stress")] = None
    """σ_Hlim [Pa]; None: that of its class, grade and hardness."""
    bending_strength: Annotated[float | None, Quantity("stress")] = None
    """σ_Flim [Pa]; None: that of its class, grade and hardness."""
    contact_life: LifeLine | None = None
    """S-N line of the flank; None: that of its class."""
    bending_life: LifeLine | None = None
    """S-N line of the root; None: that of its class."""
    melting: str | None = None
    """How clean it is molten, such as VAR."""
    source: str = ""
    """Where the values come from that have no source of their own."""
    sources: Mapping[str, str] = field(default_factory=dict, hash=False)
    """Property -> its own source."""
    estimated: Mapping[str, str] = field(default_factory=dict, hash=False)
    """Property that no source gives -> the rule by which it is estimated."""

    def source_of(self, key: str) -> str:
        """Return where a property comes from, or by which rule it is estimated.

        Args:
            key: Such as ``"density"``.
        """
        return self.estimated.get(key) or self.sources.get(key) or self.source

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
