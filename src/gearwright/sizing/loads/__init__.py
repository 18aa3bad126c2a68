"""What acts on a shaft in every load case, held in balance by its bearings.

What it does to the shaft is for `shafts`.
"""

from gearwright.sizing.loads.forces import ShaftForces, rotor_side, shaft_forces
from gearwright.sizing.loads.shaft_loads import pure_torques, shaft_loads

__all__ = ["ShaftForces", "pure_torques", "rotor_side", "shaft_forces", "shaft_loads"]
