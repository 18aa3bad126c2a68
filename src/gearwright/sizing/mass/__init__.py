"""What a gearbox weighs with everything in it, part by part, each with its origin and how well it is known.

The mass of gears, shafts and carriers by which designs are chosen is `Sizing.mass`; statistics are `weights`'s.
"""

from gearwright.sizing.mass.beside import Statistics, band_of, requirement_of, statistics_beside
from gearwright.sizing.mass.calibration import CALIBRATED, Calibration
from gearwright.sizing.mass.complete import complete_mass, summed
from gearwright.sizing.mass.gears import gear_blank, gear_blanks
from gearwright.sizing.mass.housing import Wall, reaction_torque, wall_of
from gearwright.sizing.mass.made import as_made
from gearwright.sizing.mass.oil_system import oil_flow
from gearwright.sizing.mass.record import GROUPS, CompleteMass, MassGroup, MassItem
from gearwright.sizing.mass.rotating import BRIDGE
from gearwright.sizing.mass.shell import Shell, shell_around

__all__ = [
    "BRIDGE",
    "CALIBRATED",
    "GROUPS",
    "Calibration",
    "CompleteMass",
    "MassGroup",
    "MassItem",
    "Shell",
    "Statistics",
    "Wall",
    "as_made",
    "band_of",
    "complete_mass",
    "gear_blank",
    "gear_blanks",
    "oil_flow",
    "reaction_torque",
    "requirement_of",
    "shell_around",
    "statistics_beside",
    "summed",
    "wall_of",
]
