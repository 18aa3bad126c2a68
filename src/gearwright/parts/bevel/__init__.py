"""Bevel gears: cones, virtual cylindrical gears, and rating by ISO 10300, method B1.

Factors that ISO 10300 takes from ISO 6336 are in `iso6336`.
"""

from gearwright.parts.bevel.bending import bevel_bending, contact_ratio_factor_bending, spiral_angle_factor
from gearwright.parts.bevel.blank import BevelBlank, bevel_blank, least_cutter_radius, mean_thickness
from gearwright.parts.bevel.body import WEB, bevel_dishes, bevel_form, bevel_volume, bevel_way, lightened_web
from gearwright.parts.bevel.geometry import (
    WIDEST,
    WIDEST_MODULES,
    BevelForces,
    BevelPair,
    BevelTooth,
    Hand,
    Rotation,
    bevel_forces,
    cone_forces,
    gleason_profile_shift,
)
from gearwright.parts.bevel.pitting import (
    BOTH_OVERHUNG,
    ONE_OVERHUNG,
    STRADDLE,
    BevelDuty,
    bevel_load_factors,
    bevel_pitting,
    mid_zone_factor,
)
from gearwright.parts.bevel.profile import BevelProfile, bevel_profile, face_and_root
from gearwright.parts.bevel.rating import BevelRating, BevelSurfaces, bevel_pitch_tolerance, rate_bevel
from gearwright.parts.bevel.virtual import EFFECTIVE_WIDTH, HIGH_CROWNING, LOW_CROWNING, VirtualPair, virtual_mesh

__all__ = [
    "BOTH_OVERHUNG",
    "EFFECTIVE_WIDTH",
    "HIGH_CROWNING",
    "LOW_CROWNING",
    "ONE_OVERHUNG",
    "STRADDLE",
    "WEB",
    "WIDEST",
    "WIDEST_MODULES",
    "BevelBlank",
    "BevelDuty",
    "BevelForces",
    "BevelPair",
    "BevelProfile",
    "BevelRating",
    "BevelSurfaces",
    "BevelTooth",
    "Hand",
    "Rotation",
    "VirtualPair",
    "bevel_bending",
    "bevel_blank",
    "bevel_dishes",
    "bevel_forces",
    "bevel_form",
    "bevel_load_factors",
    "bevel_pitch_tolerance",
    "bevel_pitting",
    "bevel_profile",
    "bevel_volume",
    "bevel_way",
    "cone_forces",
    "contact_ratio_factor_bending",
    "face_and_root",
    "gleason_profile_shift",
    "least_cutter_radius",
    "lightened_web",
    "mean_thickness",
    "mid_zone_factor",
    "rate_bevel",
    "spiral_angle_factor",
    "virtual_mesh",
]
