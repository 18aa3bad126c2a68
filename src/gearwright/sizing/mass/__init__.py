"""What a gearbox weighs with everything in it, part by part, each with its origin and how well it is known.

The mass of gears, shafts and carriers by which designs are chosen is `Sizing.mass`; statistics are `weights`'s.
"""

from gearwright.sizing.mass.beside import Statistics, band_of, requirement_of, statistics_beside
from gearwright.sizing.mass.bodies import (
    bevel_cones,
    bevel_dish,
    bevel_hub,
    bevel_web,
    gear_blanks,
    ring_outside,
    tooth_of,
)
from gearwright.sizing.mass.cages import BRIDGE, Bridge, Cage, Plate, cage_of
from gearwright.sizing.mass.calibration import CALIBRATED, Calibration
from gearwright.sizing.mass.complete import complete_mass, summed
from gearwright.sizing.mass.flanges import HOLE, LENGTH, Flanges, flanges_of, screw_volume
from gearwright.sizing.mass.housed import bosses_of, cover_at, housed
from gearwright.sizing.mass.housing import MOUNTS, RIBS, Wall, reaction_torque, wall_of
from gearwright.sizing.mass.made import as_made
from gearwright.sizing.mass.oil_system import oil_flow
from gearwright.sizing.mass.record import GROUPS, CompleteMass, MassGroup, MassItem
from gearwright.sizing.mass.shell import Shell, Stretch, outline_of, shell_around, stretches_around
from gearwright.sizing.sealing import Leaving, leaving_of

__all__ = [
    "BRIDGE",
    "CALIBRATED",
    "GROUPS",
    "HOLE",
    "LENGTH",
    "MOUNTS",
    "RIBS",
    "Bridge",
    "Cage",
    "Calibration",
    "CompleteMass",
    "Flanges",
    "Leaving",
    "MassGroup",
    "MassItem",
    "Plate",
    "Shell",
    "Statistics",
    "Stretch",
    "Wall",
    "as_made",
    "band_of",
    "bevel_cones",
    "bevel_dish",
    "bevel_hub",
    "bevel_web",
    "bosses_of",
    "cage_of",
    "complete_mass",
    "cover_at",
    "flanges_of",
    "gear_blanks",
    "housed",
    "leaving_of",
    "oil_flow",
    "outline_of",
    "reaction_torque",
    "requirement_of",
    "ring_outside",
    "screw_volume",
    "shell_around",
    "statistics_beside",
    "stretches_around",
    "summed",
    "tooth_of",
    "wall_of",
]
