"""Solids of a sized gearbox: tooth outlines, bodies, shafts, carriers, where they stand and how they turn; GLB files.

Envelopes and places are `sizing`'s; pages and drawings that show solids are `render`'s.
"""

from gearwright.shape.glb import COLOURS, glb
from gearwright.shape.masses import SolidMass, solid_masses
from gearwright.shape.record import Node, Scene
from gearwright.shape.scene import DETAILS, scene
from gearwright.shape.solids import Edges, Surface, edges_of

__all__ = [
    "COLOURS",
    "DETAILS",
    "Edges",
    "Node",
    "Scene",
    "SolidMass",
    "Surface",
    "edges_of",
    "glb",
    "scene",
    "solid_masses",
]
