"""What a flight does to gears and bearings: spectra, damage, lives, and the part that fails first.

Flying itself is in `mission`.
"""

from gearwright.mission.lives.bearings import USUAL_RELIABILITY, BearingDamage, BearingLives, bearing_lives
from gearwright.mission.lives.checks import flight_checks
from gearwright.mission.lives.damage import GearDamage, gear_damage, gear_damages, unrated_stages
from gearwright.mission.lives.duties import seat_duties
from gearwright.mission.lives.flown_mix import FlownMix, bearings_of, fly_mix
from gearwright.mission.lives.life import LifeSizing, size_for_life
from gearwright.mission.lives.load_lives import LoadLife, load_lives
from gearwright.mission.lives.measured import DutySpectrum, MeasuredDuty, duty_spectrum, read_duty, torque_cycles
from gearwright.mission.lives.mix import MixedLife, mixed_life
from gearwright.mission.lives.spectrum import DutyBin, bearing_spectra, mesh_spectrum, shaft_spectrum
from gearwright.mission.lives.verdict import ENDLESS, Durability, PartLife, durability

__all__ = [
    "ENDLESS",
    "USUAL_RELIABILITY",
    "BearingDamage",
    "BearingLives",
    "Durability",
    "DutyBin",
    "DutySpectrum",
    "FlownMix",
    "GearDamage",
    "LifeSizing",
    "LoadLife",
    "MeasuredDuty",
    "MixedLife",
    "PartLife",
    "bearing_lives",
    "bearing_spectra",
    "bearings_of",
    "durability",
    "duty_spectrum",
    "flight_checks",
    "fly_mix",
    "gear_damage",
    "gear_damages",
    "load_lives",
    "mesh_spectrum",
    "mixed_life",
    "read_duty",
    "seat_duties",
    "shaft_spectrum",
    "size_for_life",
    "torque_cycles",
    "unrated_stages",
]
