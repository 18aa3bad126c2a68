"""A mission flown by a sized gearbox: Mission x Sizing becomes a Flight."""

from gearwright.mission.damage import GearDamage, gear_damage
from gearwright.mission.flight import Balance, Flight, PhaseSummary, phase_summaries
from gearwright.mission.fly import fly
from gearwright.mission.governed import Window, governed_window, rotor_at, trim_at
from gearwright.mission.life import LifeSizing, size_for_life
from gearwright.mission.spectrum import DutyBin, mesh_spectrum, shaft_spectrum

__all__ = [
    "Balance",
    "DutyBin",
    "Flight",
    "GearDamage",
    "LifeSizing",
    "PhaseSummary",
    "Window",
    "fly",
    "gear_damage",
    "governed_window",
    "mesh_spectrum",
    "phase_summaries",
    "rotor_at",
    "shaft_spectrum",
    "size_for_life",
    "trim_at",
]
