"""Mesh stiffness against the mesh phase: by ISO 6336-1, by strain energy, by closed forms.

What it does to a train is for `dynamics`.
"""

from gearwright.parts.stiffness.curve import StiffnessCurve, sampled_curve, stiffness_at
from gearwright.parts.stiffness.energy import (
    contact_compliance,
    mesh_cycle_energy,
    mesh_stiffness_energy,
    pair_stiffness,
)
from gearwright.parts.stiffness.iso6336 import (
    LINEAR_LOAD,
    THEORY_TO_MEASUREMENT,
    GearBlank,
    MeshStiffness,
    blank_factor,
    load_factor,
    mesh_curve_iso6336,
    mesh_stiffness_iso6336,
    modulus_factor,
    rack_factor,
    theoretical_stiffness,
)
from gearwright.parts.stiffness.kuang_yang import (
    cut_square_wave,
    mesh_stiffness_kuang_yang,
    tooth_stiffness_kuang_yang,
)
from gearwright.parts.stiffness.passing_pairs import pair_curve, rectangular_curve
from gearwright.parts.stiffness.tooth_compliance import (
    SHEAR_FACTOR,
    half_plane_foundation,
    held_body_foundation,
    tooth_compliance,
)

__all__ = [
    "LINEAR_LOAD",
    "SHEAR_FACTOR",
    "THEORY_TO_MEASUREMENT",
    "GearBlank",
    "MeshStiffness",
    "StiffnessCurve",
    "blank_factor",
    "contact_compliance",
    "cut_square_wave",
    "half_plane_foundation",
    "held_body_foundation",
    "load_factor",
    "mesh_curve_iso6336",
    "mesh_cycle_energy",
    "mesh_stiffness_energy",
    "mesh_stiffness_iso6336",
    "mesh_stiffness_kuang_yang",
    "modulus_factor",
    "pair_curve",
    "pair_stiffness",
    "rack_factor",
    "rectangular_curve",
    "sampled_curve",
    "stiffness_at",
    "theoretical_stiffness",
    "tooth_compliance",
    "tooth_stiffness_kuang_yang",
]
