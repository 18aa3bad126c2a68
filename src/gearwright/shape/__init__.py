"""Solids of a sized gearbox: tooth outlines, bodies, shafts, carriers, where they stand and how they turn; GLB files.

Envelopes and places are `sizing`'s; pages and drawings that show solids are `render`'s.
"""

from gearwright.shape.bodies import CHAMBER, COLLAR, WEB, held_at, plate_outline
from gearwright.shape.casings import FLANGES, MOUNT, RIB, SCREW, screw_places
from gearwright.shape.scene import COLOURS, DETAILS, SolidMass, casing_masses, glb, scene, short_of, solid_masses
from gearwright.shape.stands import (
    Contact,
    Node,
    Scene,
    Stand,
    axes_at,
    contacts_of,
    cylindrical_gear,
    halves_of,
    hand_of,
    is_internal,
    kind_of,
    middle_of,
    set_frame,
    sized_mesh,
    stands_of,
)
from gearwright.shape.surfaces import Bores, Edges, Surface, around, circle, edges_of
from gearwright.sizing.mass.bodies import bevel_cones as bevel_pair

__all__ = [
    "CHAMBER",
    "COLLAR",
    "COLOURS",
    "DETAILS",
    "FLANGES",
    "MOUNT",
    "RIB",
    "SCREW",
    "WEB",
    "Bores",
    "Contact",
    "Edges",
    "Node",
    "Scene",
    "SolidMass",
    "Stand",
    "Surface",
    "around",
    "axes_at",
    "bevel_pair",
    "casing_masses",
    "circle",
    "contacts_of",
    "cylindrical_gear",
    "edges_of",
    "glb",
    "halves_of",
    "hand_of",
    "held_at",
    "is_internal",
    "kind_of",
    "middle_of",
    "plate_outline",
    "scene",
    "screw_places",
    "set_frame",
    "short_of",
    "sized_mesh",
    "solid_masses",
    "stands_of",
]
