"""Steels of gears by ISO 6336-5, their S-N curves and Miner's sum; no geometry and no loads."""

from gearwright.parts.iso6336.steels.damage import StressBin, damage_part, damage_parts, spectrum_damage
from gearwright.parts.iso6336.steels.life import (
    LIFE_AT_1E10,
    bending_life_curve,
    contact_life_curve,
    endurable_cycles,
    knee_curve,
    life_curves,
    life_factor,
)
from gearwright.parts.iso6336.steels.strength import (
    STRESS_CORRECTION_TEST_GEAR,
    GearSteel,
    LifeCurve,
    StrengthLine,
    Treatment,
    allowable_stress,
)

__all__ = [
    "LIFE_AT_1E10",
    "STRESS_CORRECTION_TEST_GEAR",
    "GearSteel",
    "LifeCurve",
    "StrengthLine",
    "StressBin",
    "Treatment",
    "allowable_stress",
    "bending_life_curve",
    "contact_life_curve",
    "damage_part",
    "damage_parts",
    "endurable_cycles",
    "knee_curve",
    "life_curves",
    "life_factor",
    "spectrum_damage",
]
