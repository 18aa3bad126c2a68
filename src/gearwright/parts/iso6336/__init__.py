"""Rating of cylindrical gears by ISO 6336, factor by factor, with the tolerances of ISO 1328 that it starts from.

Scuffing has a folder of its own; bevel gears are in `bevel`.
"""

from gearwright.parts.iso6336.balanced_shifts import BALANCES, balanced_shift, specific_slidings
from gearwright.parts.iso6336.bending import (
    bending_size_factor,
    contact_ratio_factor_root,
    deep_tooth_factor,
    helix_factor,
    load_sharing_factor,
    notch_sensitivity_factor,
    rim_factor,
    surface_factor,
)
from gearwright.parts.iso6336.damage import StressBin, damage_parts, spectrum_damage
from gearwright.parts.iso6336.distribution import (
    CENTRED,
    CORRECTED_AND_CROWNED,
    CROWNED,
    UNMODIFIED,
    Misalignment,
    PinionShaft,
    deflection_misalignment,
    face_load_factor,
    lead_allowance,
    transverse_load_factor,
)
from gearwright.parts.iso6336.dynamic import MeshDeviations, dynamic_factor, reduced_mass, running_in_allowance
from gearwright.parts.iso6336.film import (
    equivalent_roughness,
    lubricant_factor,
    roughness_factor,
    speed_factor,
    work_hardening_factor,
)
from gearwright.parts.iso6336.geometry import (
    MeshGeometry,
    ToothProportions,
    Value,
    as_value,
    mesh_geometry,
    shifted_mesh,
)
from gearwright.parts.iso6336.life import (
    bending_life_curve,
    contact_life_curve,
    endurable_cycles,
    knee_curve,
    life_curves,
    life_factor,
)
from gearwright.parts.iso6336.loads import MeshDuty, MeshQuality, Steels
from gearwright.parts.iso6336.pitting import LoadFactors, elasticity_factor, pitting_rating, single_contact_factors
from gearwright.parts.iso6336.rating import PairRating, rate_mesh, rate_pair
from gearwright.parts.iso6336.root import (
    Edition,
    LoadedTooth,
    RootSection,
    outer_single_contact,
    root_section,
    shaped_fillet_radius,
)
from gearwright.parts.iso6336.stiffness import MeshSprings, mesh_springs
from gearwright.parts.iso6336.strength import (
    STRESS_CORRECTION_TEST_GEAR,
    GearSteel,
    LifeCurve,
    StrengthLine,
    Treatment,
    allowable_stress,
)

__all__ = [
    "BALANCES",
    "CENTRED",
    "CORRECTED_AND_CROWNED",
    "CROWNED",
    "STRESS_CORRECTION_TEST_GEAR",
    "UNMODIFIED",
    "Edition",
    "GearSteel",
    "LifeCurve",
    "LoadFactors",
    "LoadedTooth",
    "MeshDeviations",
    "MeshDuty",
    "MeshGeometry",
    "MeshQuality",
    "MeshSprings",
    "Misalignment",
    "PairRating",
    "PinionShaft",
    "RootSection",
    "Steels",
    "StrengthLine",
    "StressBin",
    "ToothProportions",
    "Treatment",
    "Value",
    "allowable_stress",
    "as_value",
    "balanced_shift",
    "bending_life_curve",
    "bending_size_factor",
    "contact_life_curve",
    "contact_ratio_factor_root",
    "damage_parts",
    "deep_tooth_factor",
    "deflection_misalignment",
    "dynamic_factor",
    "elasticity_factor",
    "endurable_cycles",
    "equivalent_roughness",
    "face_load_factor",
    "helix_factor",
    "knee_curve",
    "lead_allowance",
    "life_curves",
    "life_factor",
    "load_sharing_factor",
    "lubricant_factor",
    "mesh_geometry",
    "mesh_springs",
    "notch_sensitivity_factor",
    "outer_single_contact",
    "pitting_rating",
    "rate_mesh",
    "rate_pair",
    "reduced_mass",
    "rim_factor",
    "root_section",
    "roughness_factor",
    "running_in_allowance",
    "shaped_fillet_radius",
    "shifted_mesh",
    "single_contact_factors",
    "specific_slidings",
    "spectrum_damage",
    "speed_factor",
    "surface_factor",
    "transverse_load_factor",
    "work_hardening_factor",
]
