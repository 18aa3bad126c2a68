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
    pinion_of,
    ring_outside,
    tooth_of,
)
from gearwright.sizing.mass.cages import BRIDGE, Bridge, Cage, Plate, cage_of
from gearwright.sizing.mass.calibration import CALIBRATED, Calibration
from gearwright.sizing.mass.complete import complete_mass, summed
from gearwright.sizing.mass.dishes import refuse_dishes
from gearwright.sizing.mass.gears import bell_name, seat_names
from gearwright.sizing.mass.housing import (
    MOUNTS,
    RIBS,
    Wall,
    carried_in_walls,
    held_torques,
    reaction_torque,
    wall_of,
    weighed_flanges,
    weighed_wall,
)
from gearwright.sizing.mass.made import as_made
from gearwright.sizing.mass.oil_system import oil_flow
from gearwright.sizing.mass.record import GROUPS, TRAIN, CompleteMass, MassGroup, MassItem

__all__ = [
    "BRIDGE",
    "CALIBRATED",
    "GROUPS",
    "MOUNTS",
    "RIBS",
    "TRAIN",
    "Bridge",
    "Cage",
    "Calibration",
    "CompleteMass",
    "MassGroup",
    "MassItem",
    "Plate",
    "Statistics",
    "Wall",
    "as_made",
    "band_of",
    "bell_name",
    "bevel_cones",
    "bevel_dish",
    "bevel_hub",
    "bevel_web",
    "cage_of",
    "carried_in_walls",
    "complete_mass",
    "gear_blanks",
    "held_torques",
    "oil_flow",
    "pinion_of",
    "reaction_torque",
    "refuse_dishes",
    "requirement_of",
    "ring_outside",
    "seat_names",
    "statistics_beside",
    "summed",
    "tooth_of",
    "wall_of",
    "weighed_flanges",
    "weighed_wall",
]
