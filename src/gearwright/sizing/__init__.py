"""From a design to a sized transmission."""

from gearwright.sizing.answers import (
    TEXT,
    AskedSpeed,
    MassPart,
    Named,
    Passing,
    asked_results,
    asked_speeds,
    bearing_forces,
    mass_groups,
    mass_parts,
    named_results,
    passing,
    pick,
    refuse_no_numbers,
    remarks,
    total_results,
)
from gearwright.sizing.arranged import Arrangement, Body, Direction, Frame, Point, ShaftPlan, Station, Turn
from gearwright.sizing.carrying import CarrierSizing, ShaftDiagram, ShaftSizing
from gearwright.sizing.chosen import TeethSearch
from gearwright.sizing.compound import pins_of, towards
from gearwright.sizing.insight import Beside, Influence, MeshBeside, MeshInfluences, influences, methods_beside
from gearwright.sizing.many import Sizings, Structure, in_lanes, size_many, structure_of
from gearwright.sizing.meshed import MeshSizing
from gearwright.sizing.mounted import BearingSizing, BuiltShaft, JointSizing, ShaftStep
from gearwright.sizing.result import GearSizing, MachineSizing, Sizing
from gearwright.sizing.size import size, size_unturned
from gearwright.sizing.summaries import (
    BevelPairData,
    CylindricalPairData,
    StageSummary,
    pair_data,
    stage_summaries,
)
from gearwright.sizing.tooth_play import Backlash, backlash_of, fit_of, play_in_motion, thickness_of
from gearwright.sizing.tooth_shape import cylindrical_gear, planet_positions, stated_pitch

__all__ = [
    "TEXT",
    "Arrangement",
    "AskedSpeed",
    "Backlash",
    "BearingSizing",
    "Beside",
    "BevelPairData",
    "Body",
    "BuiltShaft",
    "CarrierSizing",
    "CylindricalPairData",
    "Direction",
    "Frame",
    "GearSizing",
    "Influence",
    "JointSizing",
    "MachineSizing",
    "MassPart",
    "MeshBeside",
    "MeshInfluences",
    "MeshSizing",
    "Named",
    "Passing",
    "Point",
    "ShaftDiagram",
    "ShaftPlan",
    "ShaftSizing",
    "ShaftStep",
    "Sizing",
    "Sizings",
    "StageSummary",
    "Station",
    "Structure",
    "TeethSearch",
    "Turn",
    "asked_results",
    "asked_speeds",
    "backlash_of",
    "bearing_forces",
    "cylindrical_gear",
    "fit_of",
    "in_lanes",
    "influences",
    "mass_groups",
    "mass_parts",
    "methods_beside",
    "named_results",
    "pair_data",
    "passing",
    "pick",
    "pins_of",
    "planet_positions",
    "play_in_motion",
    "refuse_no_numbers",
    "remarks",
    "size",
    "size_many",
    "size_unturned",
    "stage_summaries",
    "stated_pitch",
    "structure_of",
    "thickness_of",
    "total_results",
    "towards",
]
