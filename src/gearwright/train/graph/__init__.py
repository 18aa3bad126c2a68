"""The train as a graph: what has teeth, and the rows that they make. Speeds and torques on it are for `flow`."""

from gearwright.train.graph.epicyclics import epicyclic_gears, epicyclic_meshes
from gearwright.train.graph.toothed import EXTERNAL, INTERNAL, Gear, Mesh
from gearwright.train.graph.train import Damper, Joint, Train, build_train, gear_of, gears_of, shafts_of

__all__ = [
    "EXTERNAL",
    "INTERNAL",
    "Damper",
    "Gear",
    "Joint",
    "Mesh",
    "Train",
    "build_train",
    "epicyclic_gears",
    "epicyclic_meshes",
    "gear_of",
    "gears_of",
    "shafts_of",
]
