"""Material properties of gears and shafts for strength rating, and conversion of steel hardness scales."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated

import numpy as np

from gearwright.units import Density, Number, Quantity, Ratio, Stress

# ----------------------------------------------------------------------------------------------------------------------
# The properties of a gear or shaft material that the rating methods need.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Hardness of steel in one scale from another: Vickers, Brinell, Rockwell C.
# ----------------------------------------------------------------------------------------------------------------------


BRINELL_PER_VICKERS = 0.95
"""HB over HV [-] (ISO 18265:2013, table A.1)."""
ROCKWELL = (
    20.3, 22.2, 24.0, 25.6, 27.1, 28.5, 29.8, 31.0, 32.2, 33.3, 34.4, 35.5, 36.6, 37.7, 38.8, 39.8, 40.8, 41.8, 42.7,
    43.6, 44.5, 45.3, 46.1, 46.9, 47.7, 48.4, 49.1, 49.8, 50.5, 51.1, 51.7, 52.3, 53.0, 53.6, 54.1, 54.7, 55.2, 55.7,
    56.3, 56.8, 57.3, 57.8, 58.3, 58.8, 59.2, 59.7, 60.1, 61.0, 61.8, 62.5, 63.3, 64.0, 64.7, 65.3, 65.9, 66.4, 67.0,
    67.5, 68.0,
)  # fmt: skip
"""HRC at each of `VICKERS` (ISO 18265:2013, table A.1: unalloyed and low-alloy steels)."""
VICKERS = (*range(240, 701, 10), *range(720, 941, 20))
"""HV [-]."""


def vickers_of_rockwell(hardness: float) -> float:
    """Return the Vickers hardness HV of steel with a Rockwell hardness C.

    Args:
        hardness: HRC [-].

    Source: ISO 18265:2013, table A.1, unalloyed and low-alloy steels; linear between its rows.
    Valid for: 20.3 to 68 HRC.

    >>> round(vickers_of_rockwell(60.1)), round(vickers_of_rockwell(61.0))
    (700, 720)
    """
    if not ROCKWELL[0] <= hardness <= ROCKWELL[-1]:
        raise ValueError(f"{hardness:g} HRC; ISO 18265 converts {ROCKWELL[0]:g} to {ROCKWELL[-1]:g}")
    return float(np.interp(hardness, ROCKWELL, VICKERS))
