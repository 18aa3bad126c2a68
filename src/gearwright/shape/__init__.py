"""Solids of a sized gearbox: tooth outlines, bodies, shafts, carriers, where they stand and how they turn; GLB files.

Envelopes and places are `sizing`'s; pages and drawings that show solids are `render`'s.
"""

from gearwright.shape.bodies import CHAMBER, COLLAR, WEB
from gearwright.shape.casings import FLANGES, MOUNT, RIB, SCREW, screw_places
from gearwright.shape.scene import COLOURS, DETAILS, SolidMass, casing_masses, glb, scene, short_of, solid_masses
from gearwright.shape.stands import (
    Contact,
    Node,
    Scene,
    Stand,
    contacts_of,
    cylindrical_gear,
    halves_of,
    hand_of,
    is_internal,
    kind_of,
    sized_mesh,
    stands_of,
)
from gearwright.shape.surfaces import Edges, Surface, edges_of
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
    "Contact",
    "Edges",
    "Node",
    "Scene",
    "SolidMass",
    "Stand",
    "Surface",
    "bevel_pair",
    "casing_masses",
    "contacts_of",
    "cylindrical_gear",
    "edges_of",
    "glb",
    "halves_of",
    "hand_of",
    "is_internal",
    "kind_of",
    "scene",
    "screw_places",
    "short_of",
    "sized_mesh",
    "solid_masses",
    "stands_of",
]
