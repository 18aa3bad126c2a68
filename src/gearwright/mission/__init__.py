"""A mission flown by a sized gearbox: Mission x Sizing becomes a Flight."""

from gearwright.mission.aircraft import PhaseForces, phase_forces
from gearwright.mission.flight import Balance, Flight, PackWear, PhaseSummary, flight_series, phase_summaries
from gearwright.mission.fly import fly, fly_each
from gearwright.mission.gearbox import Oil, gearbox_of
from gearwright.mission.history import History, MachineHistory, MeshHistory, NodeHistory, Series
from gearwright.mission.lives.bearings import BearingDamage, BearingLives, bearing_lives
from gearwright.mission.lives.checks import flight_checks
from gearwright.mission.lives.damage import GearDamage, gear_damage, gear_damages, unrated_stages
from gearwright.mission.lives.flown_mix import FlownMix, fly_mix
from gearwright.mission.lives.life import LifeSizing, size_for_life
from gearwright.mission.lives.measured import DutySpectrum, MeasuredDuty, duty_spectrum, read_duty
from gearwright.mission.lives.mix import MixedLife, mixed_life
from gearwright.mission.lives.spectrum import DutyBin, bearing_spectra, mesh_spectrum, shaft_spectrum
from gearwright.mission.lives.verdict import Durability, PartLife, durability
from gearwright.mission.windows.governed import Window, governed_window, rotor_at, trim_at

__all__ = [
    "Balance",
    "BearingDamage",
    "BearingLives",
    "Durability",
    "DutyBin",
    "DutySpectrum",
    "Flight",
    "FlownMix",
    "GearDamage",
    "History",
    "LifeSizing",
    "MachineHistory",
    "MeasuredDuty",
    "MeshHistory",
    "MixedLife",
    "NodeHistory",
    "Oil",
    "PackWear",
    "PartLife",
    "PhaseForces",
    "PhaseSummary",
    "Series",
    "Window",
    "bearing_lives",
    "bearing_spectra",
    "durability",
    "duty_spectrum",
    "flight_checks",
    "flight_series",
    "fly",
    "fly_each",
    "fly_mix",
    "gear_damage",
    "gear_damages",
    "gearbox_of",
    "governed_window",
    "mesh_spectrum",
    "mixed_life",
    "phase_forces",
    "phase_summaries",
    "read_duty",
    "rotor_at",
    "shaft_spectrum",
    "size_for_life",
    "trim_at",
    "unrated_stages",
]
