"""Planetary sets: which teeth can be put together, how their meshes follow each other, and what carries the planets.

Their kinematics are `train`'s, their motion is for `dynamics`.
"""

from gearwright.parts.planetary.assembly import (
    ADDENDUMS,
    assembles,
    even_positions,
    most_planet_teeth,
    most_planets,
    nearest_positions,
    neighbours_clear,
    tip_gap,
)
from gearwright.parts.planetary.carrier import (
    eye_stress,
    eye_wall,
    hole_pressure,
    pin_bore,
    pin_diameter,
    pin_mass,
    pin_stress,
    plate_mass,
    plate_shear_stress,
)
from gearwright.parts.planetary.compound import (
    CompoundSet,
    module_ratios,
    pin_angles,
    pin_radii,
    planes,
    reaches,
    touching,
)
from gearwright.parts.planetary.compound_assembly import Turns, can_assemble, fitting_turns
from gearwright.parts.planetary.load_factor import (
    clocking_load_factor,
    path_stiffness,
    pin_error_share,
    pin_error_within,
    tolerance_load_factor,
)
from gearwright.parts.planetary.phasing import (
    PlanetPhases,
    excited_modes,
    planet_phases,
    sun_to_ring_phase,
)

__all__ = [
    "ADDENDUMS",
    "CompoundSet",
    "PlanetPhases",
    "Turns",
    "assembles",
    "can_assemble",
    "clocking_load_factor",
    "even_positions",
    "excited_modes",
    "eye_stress",
    "eye_wall",
    "fitting_turns",
    "hole_pressure",
    "module_ratios",
    "most_planet_teeth",
    "most_planets",
    "nearest_positions",
    "neighbours_clear",
    "path_stiffness",
    "pin_angles",
    "pin_bore",
    "pin_diameter",
    "pin_error_share",
    "pin_error_within",
    "pin_mass",
    "pin_radii",
    "pin_stress",
    "planes",
    "planet_phases",
    "plate_mass",
    "plate_shear_stress",
    "reaches",
    "sun_to_ring_phase",
    "tip_gap",
    "tolerance_load_factor",
    "touching",
]
