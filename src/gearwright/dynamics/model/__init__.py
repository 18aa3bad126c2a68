"""A drive train as bodies, lines, loads and drives: what a researcher writes, and the flat arrays that it becomes.

Nothing is solved here; a sizing becomes a model in `assembly`.
"""

from gearwright.dynamics.model.beam import Segment, bending_shaft
from gearwright.dynamics.model.contact import (
    AXES,
    Carried,
    Contact,
    Turns,
    contact_errors,
    crossing_axis,
    face_push_direction,
    push_direction,
    shift_weights,
)
from gearwright.dynamics.model.drives import (
    CLUTCH,
    HEADER,
    MACHINE,
    OUTPUTS,
    OUTSIDE_MAP,
    PROPELLER,
    Acting,
    ClutchDrive,
    Curve,
    MachineDrive,
    PropellerDrive,
    drive_effects,
    points_of,
)
from gearwright.dynamics.model.family import check_structure, envelope, own_groups, stacked, weight_numbers
from gearwright.dynamics.model.finite import check_finite, finite_numbers, refuse_not_finite
from gearwright.dynamics.model.flatten import profile_of
from gearwright.dynamics.model.line import DampingRatio, Line, Periodic
from gearwright.dynamics.model.model import Model
from gearwright.dynamics.model.planetary import add_planetary
from gearwright.dynamics.model.planetary_set import Member, PlanetarySet, PlanetError, rotational
from gearwright.dynamics.model.system import (
    Arrays,
    Drives,
    Entries,
    Floats,
    Ints,
    Labels,
    Profile,
    Schedules,
    Series,
    System,
    Tone,
    entry_matrix,
    line_matrix,
    top_rate,
)

__all__ = [
    "AXES",
    "CLUTCH",
    "HEADER",
    "MACHINE",
    "OUTPUTS",
    "OUTSIDE_MAP",
    "PROPELLER",
    "Acting",
    "Arrays",
    "Carried",
    "ClutchDrive",
    "Contact",
    "Curve",
    "DampingRatio",
    "Drives",
    "Entries",
    "Floats",
    "Ints",
    "Labels",
    "Line",
    "MachineDrive",
    "Member",
    "Model",
    "Periodic",
    "PlanetError",
    "PlanetarySet",
    "Profile",
    "PropellerDrive",
    "Schedules",
    "Segment",
    "Series",
    "System",
    "Tone",
    "Turns",
    "add_planetary",
    "bending_shaft",
    "check_finite",
    "check_structure",
    "contact_errors",
    "crossing_axis",
    "drive_effects",
    "entry_matrix",
    "envelope",
    "face_push_direction",
    "finite_numbers",
    "line_matrix",
    "own_groups",
    "points_of",
    "profile_of",
    "push_direction",
    "refuse_not_finite",
    "rotational",
    "shift_weights",
    "stacked",
    "top_rate",
    "weight_numbers",
]
