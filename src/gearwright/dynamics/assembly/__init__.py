"""A sized design becomes a System: meshes, their places in space, planetary sets, and what is assumed on the way.

The builder that it fills is in `model`.
"""

from gearwright.dynamics.assembly.assemble import (
    Assumption,
    Driving,
    assemble,
    assumptions,
    loaded_bodies,
    untold_orders,
)
from gearwright.dynamics.assembly.meshes import bodies_of, compound_phases, contacts_of, gear_pairs, mesh_curve

__all__ = [
    "Assumption",
    "Driving",
    "assemble",
    "assumptions",
    "bodies_of",
    "compound_phases",
    "contacts_of",
    "gear_pairs",
    "loaded_bodies",
    "mesh_curve",
    "untold_orders",
]
