"""Profile shifts of stages from what their design gives, and the teeth that cannot be.

The search for tooth numbers is in `sizing`.
"""

from gearwright.spec.design.teeth.compound_shifts import CompoundShifts, compound_shifts, relative_modules
from gearwright.spec.design.teeth.profile_shifts import PAIR_ROLES, SET_ROLES, StageShifts, stage_shifts, working_angle

__all__ = [
    "PAIR_ROLES",
    "SET_ROLES",
    "CompoundShifts",
    "StageShifts",
    "compound_shifts",
    "relative_modules",
    "stage_shifts",
    "working_angle",
]
