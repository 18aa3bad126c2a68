"""Solids of a sized gearbox: tooth outlines, bodies, shafts, carriers, where they stand and how they turn; GLB files.

Envelopes and places are `sizing`'s; pages and drawings that show solids are `render`'s.
"""

from gearwright.shape.casings.flanges import FLANGES, screw_places
from gearwright.shape.casings.mounts import MOUNT
from gearwright.shape.casings.ribs import RIB
from gearwright.shape.casings.screws import SCREW
from gearwright.shape.contacts import Contact, contacts_of
from gearwright.shape.glb import COLOURS, glb
from gearwright.shape.housing import CHAMBER, COLLAR, WEB
from gearwright.shape.masses import SolidMass, casing_masses, short_of, solid_masses
from gearwright.shape.record import Node, Scene
from gearwright.shape.scene import DETAILS, scene
from gearwright.shape.solids import Edges, Surface, edges_of
from gearwright.shape.stands import Stand, stands_of
from gearwright.shape.teeth import (
    bevel_pair,
    cylindrical_gear,
    halves_of,
    hand_of,
    is_internal,
    kind_of,
    sized_mesh,
)

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
