"""How a stage is rated: its rules resolved, and methods in one dict, each in a folder of its own with its own record.

The formulas are in `parts`. `protocol` says what a method does, `methods` has all of them.
"""

from gearwright.sizing.rating.context import (
    Context,
    Demand,
    Known,
    context_of,
    demands_of,
    reverse_parts,
    row_ask,
)
from gearwright.sizing.rating.factors import Factor, factor_rows
from gearwright.sizing.rating.lewis_hertz import width_ratio
from gearwright.sizing.rating.methods import ELEMENTWISE, METHODS, method_for, modules, stage_width_ratio
from gearwright.sizing.rating.protocol import (
    LEAST_TORQUE,
    ClassDamage,
    Damage,
    Load,
    LoadedMesh,
    Making,
    MeshRating,
    MeshSpectrum,
    Method,
    Unloaded,
)
from gearwright.sizing.rating.rims import rim_below_roots
from gearwright.sizing.rating.rows import rate_row, row_reserve, scuffing_ratio
from gearwright.sizing.rating.rules import Ask, Rating, rating_of
from gearwright.sizing.rating.standard_teeth import (
    bevel_pair,
    bevel_push,
    cone_ratio,
    cylindrical_mesh,
    fewest_virtual_teeth,
    mean_module,
    push_angle,
    working_radii,
)
from gearwright.sizing.rating.widths import (
    CORRECTIONS,
    JUST,
    NEXT,
    STANDARD_MODULES,
    STEPS_UP,
    Gap,
    bevel_width,
    narrowest,
    next_standard,
    overlap_width,
    strong_enough,
    under_spectrum,
)

__all__ = [
    "CORRECTIONS",
    "ELEMENTWISE",
    "JUST",
    "LEAST_TORQUE",
    "METHODS",
    "NEXT",
    "STANDARD_MODULES",
    "STEPS_UP",
    "Ask",
    "ClassDamage",
    "Context",
    "Damage",
    "Demand",
    "Factor",
    "Gap",
    "Known",
    "Load",
    "LoadedMesh",
    "Making",
    "MeshRating",
    "MeshSpectrum",
    "Method",
    "Rating",
    "Unloaded",
    "bevel_pair",
    "bevel_push",
    "bevel_width",
    "cone_ratio",
    "context_of",
    "cylindrical_mesh",
    "demands_of",
    "factor_rows",
    "fewest_virtual_teeth",
    "mean_module",
    "method_for",
    "modules",
    "narrowest",
    "next_standard",
    "overlap_width",
    "push_angle",
    "rate_row",
    "rating_of",
    "reverse_parts",
    "rim_below_roots",
    "row_ask",
    "row_reserve",
    "scuffing_ratio",
    "stage_width_ratio",
    "strong_enough",
    "under_spectrum",
    "width_ratio",
    "working_radii",
]
