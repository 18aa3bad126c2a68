"""A sized design becomes a System: meshes, their places in space, planetary sets, and what is assumed on the way.

The builder that it fills is in `model`.
"""

from gearwright.dynamics.assembly.assemble import Driving, assemble, loaded_bodies
from gearwright.dynamics.assembly.assumptions import Assumption, assumptions
from gearwright.dynamics.assembly.compound_sets import compound_phases
from gearwright.dynamics.assembly.contacts import bodies_of, contacts_of
from gearwright.dynamics.assembly.meshes import gear_pairs, mesh_curve
from gearwright.dynamics.assembly.orders import untold_orders

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
