"""A mission flown by a sized gearbox: Mission x Sizing becomes a Flight."""

from gearwright.mission.aircraft import PhaseForces, phase_forces
from gearwright.mission.flight import (
    Balance,
    Flight,
    History,
    MachineHistory,
    MeshHistory,
    NodeHistory,
    PackWear,
    PhaseSummary,
    Series,
    flight_series,
    phase_summaries,
)
from gearwright.mission.fly import fly, fly_each
from gearwright.mission.gearbox import gearbox_of
from gearwright.mission.lives.bearings import BearingDamage, BearingLives, bearing_lives
from gearwright.mission.lives.damage import (
    DutyBin,
    GearDamage,
    bearing_spectra,
    gear_damage,
    gear_damages,
    mesh_spectrum,
    shaft_spectrum,
    unrated_stages,
)
from gearwright.mission.lives.life import (
    Durability,
    FlownMix,
    LifeSizing,
    MixedLife,
    PartLife,
    durability,
    flight_checks,
    fly_mix,
    mixed_life,
    size_for_life,
)
from gearwright.mission.lives.measured import DutySpectrum, MeasuredDuty, duty_spectrum, read_duty
from gearwright.mission.windows.window import Window, governed_window, rotor_at, trim_at
from gearwright.sizing.losses import Oil

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
