"""What acts on a shaft in every load case, held in balance by its bearings, and on the pins of compound sets.

What it does to them is for `shafts`.
"""

from gearwright.sizing.loads.forces import ShaftForces, rotor_side, shaft_forces
from gearwright.sizing.loads.planet_pins import (
    PinLoad,
    ToothForce,
    mesh_place,
    pin_length,
    pin_loads,
    steps_of,
    tooth_forces,
)
from gearwright.sizing.loads.shaft_loads import pure_torques, shaft_loads

__all__ = [
    "PinLoad",
    "ShaftForces",
    "ToothForce",
    "mesh_place",
    "pin_length",
    "pin_loads",
    "pure_torques",
    "rotor_side",
    "shaft_forces",
    "shaft_loads",
    "steps_of",
    "tooth_forces",
]
