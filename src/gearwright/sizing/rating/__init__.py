"""How a stage is rated: its rules resolved, the module that they ask for, and meshes rated by ISO 6336 and ISO 10300.

The formulas are in `parts`.
"""

from gearwright.sizing.rating.context import Context, Demand, context_of, demands_of, row_ask, width_ratio_of
from gearwright.sizing.rating.mesh_rating import MeshRating, Strain, rate_row, strains_under, stresses_of
from gearwright.sizing.rating.modules import modules
from gearwright.sizing.rating.rules import Ask, Rating, form_factor, rating_of, width_ratio
from gearwright.sizing.rating.standard_teeth import (
    bevel_pair,
    bevel_push,
    cone_ratio,
    cylindrical_mesh,
    fewest_virtual_teeth,
    mean_module,
    stage_width_ratio,
    steel_of,
)

__all__ = [
    "Ask",
    "Context",
    "Demand",
    "MeshRating",
    "Rating",
    "Strain",
    "bevel_pair",
    "bevel_push",
    "cone_ratio",
    "context_of",
    "cylindrical_mesh",
    "demands_of",
    "fewest_virtual_teeth",
    "form_factor",
    "mean_module",
    "modules",
    "rate_row",
    "rating_of",
    "row_ask",
    "stage_width_ratio",
    "steel_of",
    "strains_under",
    "stresses_of",
    "width_ratio",
    "width_ratio_of",
]
