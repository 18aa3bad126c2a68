"""Planetary sets: which teeth can be put together, how their meshes follow each other, and what carries the planets.

Their kinematics are `train`'s, their motion is for `dynamics`.
"""

from gearwright.parts.planetary.assembly import ADDENDUMS, assembles, most_planets, neighbours_clear
from gearwright.parts.planetary.carrier import pin_diameter, pin_mass, pin_stress, plate_mass, plate_shear_stress
from gearwright.parts.planetary.load_factor import pin_error_share
from gearwright.parts.planetary.phasing import (
    PlanetPhases,
    even_positions,
    excited_modes,
    planet_phases,
    sun_to_ring_phase,
)

__all__ = [
    "ADDENDUMS",
    "PlanetPhases",
    "assembles",
    "even_positions",
    "excited_modes",
    "most_planets",
    "neighbours_clear",
    "pin_diameter",
    "pin_error_share",
    "pin_mass",
    "pin_stress",
    "planet_phases",
    "plate_mass",
    "plate_shear_stress",
    "sun_to_ring_phase",
]
