"""What a flight does to gears and bearings: spectra, damage, lives, and the part that fails first.

Flying itself is in `mission`.
"""

from gearwright.mission.lives.bearings import USUAL_RELIABILITY, BearingDamage, BearingLives, bearing_lives, seat_duties
from gearwright.mission.lives.damage import (
    DutyBin,
    GearDamage,
    LoadLife,
    bearing_spectra,
    gear_damage,
    gear_damages,
    load_lives,
    mesh_spectrum,
    shaft_spectrum,
    unrated_stages,
)
from gearwright.mission.lives.housing import (
    Assumed,
    HousingSection,
    housing_assumptions,
    housing_checks,
    housing_sections,
    known_sections,
)
from gearwright.mission.lives.life import (
    ENDLESS,
    Durability,
    FlownMix,
    LifeSizing,
    MixedLife,
    PartLife,
    bearings_of,
    durability,
    flight_checks,
    fly_mix,
    mixed_life,
    size_for_life,
)
from gearwright.mission.lives.measured import DutySpectrum, MeasuredDuty, duty_spectrum, read_duty, torque_cycles
from gearwright.mission.lives.upkeep import Upkeep, upkeep_checks, upkeep_of

__all__ = [
    "ENDLESS",
    "USUAL_RELIABILITY",
    "Assumed",
    "BearingDamage",
    "BearingLives",
    "Durability",
    "DutyBin",
    "DutySpectrum",
    "FlownMix",
    "GearDamage",
    "HousingSection",
    "LifeSizing",
    "LoadLife",
    "MeasuredDuty",
    "MixedLife",
    "PartLife",
    "Upkeep",
    "bearing_lives",
    "bearing_spectra",
    "bearings_of",
    "durability",
    "duty_spectrum",
    "flight_checks",
    "fly_mix",
    "gear_damage",
    "gear_damages",
    "housing_assumptions",
    "housing_checks",
    "housing_sections",
    "known_sections",
    "load_lives",
    "mesh_spectrum",
    "mixed_life",
    "read_duty",
    "seat_duties",
    "shaft_spectrum",
    "size_for_life",
    "torque_cycles",
    "unrated_stages",
    "upkeep_checks",
    "upkeep_of",
]
