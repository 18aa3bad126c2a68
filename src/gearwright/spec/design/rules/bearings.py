"""How rolling bearings are judged: by which life, and by which limits of load and speed."""

from __future__ import annotations

from types import MappingProxyType
from typing import Literal

from pydantic import Field

from gearwright.parts.bearings import Lubrication
from gearwright.parts.losses import TURBINE_OIL
from gearwright.spec.record import Record
from gearwright.units import Density, Ratio

Dirt = Literal[
    "extreme", "high", "normal", "slight", "typical", "severe", "beta-6-200", "beta-12-200", "beta-25-75", "beta-40-75"
]
"""How clean the oil is, by a word of ISO 281:2007, table 13, or by the filter of circulating oil, annex A.4."""


class BearingRules(Record):
    """How rolling bearings are judged, of shafts and planets."""

    life: Literal["basic", "modified"] = Field(
        "basic",
        description="Life that is asked: L_10h, or L_nmh = a_1 a_ISO L_10h by [oil] (ISO 281:2007); both are shown",
    )
    reliability: Ratio = Field(0.9, ge=0.9, le=0.999, description="Part of the bearings that reach the modified life")
    limits: bool = Field(
        False, description="Check least load against skidding and thermal reference speed (ISO 15312) too"
    )
    lubrication: Lubrication = Field(
        "jet",
        description="How oil comes to bearings: limits their n d_m; under-race: through inner rings, to taper ribs",
    )
    speed_factor: float | None = Field(
        None, ge=1e4, le=4e6, description="Largest n d_m from the maker; left out: by kind and lubrication [mm/min]"
    )


GRADE_KEYS = MappingProxyType({"oil_viscosity": "viscosity_40", "oil_viscosity_100": "viscosity_100"})
"""Rule of ISO 6336 -> what [oil] says of the same."""
WARMTH_KEYS = MappingProxyType({"oil_temperature": "temperature"})
"""Likewise of its temperature."""


VISCOSITY_40, VISCOSITY_100 = (1e6 * viscosity for viscosity in TURBINE_OIL)
"""Of the oil where a design says none, at bearings and teeth [mm²/s]."""
OIL_TEMPERATURE = 90.0
"""Likewise its temperature, an assumption [°C]."""


class OilOfDesign(Record):
    """The oil at bearings and teeth, for lives, losses and, where [gears.iso6336] says no other, films and scuffing."""

    viscosity_40: float = Field(VISCOSITY_40, ge=2, le=2000, description="Kinematic viscosity at 40 °C [mm²/s]")
    viscosity_100: float = Field(VISCOSITY_100, ge=1, le=200, description="Kinematic viscosity at 100 °C [mm²/s]")
    density: Density = Field(950.0, ge=500, le=1500, description="At its temperature")
    temperature: float = Field(OIL_TEMPERATURE, ge=-40, le=200, description="At bearings and teeth [°C]")
    cleanliness: Dirt = Field(
        "normal", description="Contamination factor e_C: a word of ISO 281:2007, table 13, or the filter of its annex A"
    )
