"""Scuffing of cylindrical pairs by flash and by integral temperature (ISO/TS 6336-20 and -21).

Pitting and bending are in `iso6336`.
"""

from gearwright.parts.scuffing.flash_temperature import (
    SPRAY,
    FlashEdition,
    FlashTemperature,
    Oil,
    ScuffingMesh,
    flash_temperature,
    load_sharing,
    lubricant_factor_scuffing,
    thermo_elastic_factor,
)
from gearwright.parts.scuffing.integral_temperature import (
    IntegralTemperature,
    contact_ratio_factor_integral,
    integral_temperature,
    relieved_part,
)

__all__ = [
    "SPRAY",
    "FlashEdition",
    "FlashTemperature",
    "IntegralTemperature",
    "Oil",
    "ScuffingMesh",
    "contact_ratio_factor_integral",
    "flash_temperature",
    "integral_temperature",
    "load_sharing",
    "lubricant_factor_scuffing",
    "relieved_part",
    "thermo_elastic_factor",
]
