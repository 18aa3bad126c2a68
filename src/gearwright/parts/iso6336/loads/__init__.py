"""Part 1: what a mesh carries and how unevenly, K_V to K_Fα, with the deviations and springs that they start from."""

from gearwright.parts.iso6336.loads.distribution import (
    CENTRED,
    CORRECTED_AND_CROWNED,
    CROWNED,
    UNMODIFIED,
    FaceLoadFactor,
    Misalignment,
    PinionShaft,
    TransverseLoadFactor,
    deflection_misalignment,
    face_load_factor,
    lead_allowance,
    transverse_load_factor,
)
from gearwright.parts.iso6336.loads.dynamic import (
    DynamicFactor,
    MeshDeviations,
    dynamic_factor,
    reduced_mass,
    running_in_allowance,
)
from gearwright.parts.iso6336.loads.dynamic_by_speed import (
    FASTEST,
    DynamicFactorBySpeed,
    dynamic_factor_by_speed,
)
from gearwright.parts.iso6336.loads.mesh_loads import (
    USUAL,
    MeshDuty,
    MeshQuality,
    Steels,
    load_cycles,
    load_distribution,
    specific_load,
)
from gearwright.parts.iso6336.loads.stiffness import MeshSprings, mesh_springs
from gearwright.parts.iso6336.loads.tolerances import flank_tolerances

__all__ = [
    "CENTRED",
    "CORRECTED_AND_CROWNED",
    "CROWNED",
    "FASTEST",
    "UNMODIFIED",
    "USUAL",
    "DynamicFactor",
    "DynamicFactorBySpeed",
    "FaceLoadFactor",
    "MeshDeviations",
    "MeshDuty",
    "MeshQuality",
    "MeshSprings",
    "Misalignment",
    "PinionShaft",
    "Steels",
    "TransverseLoadFactor",
    "deflection_misalignment",
    "dynamic_factor",
    "dynamic_factor_by_speed",
    "face_load_factor",
    "flank_tolerances",
    "lead_allowance",
    "load_cycles",
    "load_distribution",
    "mesh_springs",
    "reduced_mass",
    "running_in_allowance",
    "specific_load",
    "transverse_load_factor",
]
