"""From a design to a sized transmission."""

from gearwright.sizing.breakdown import AskedSpeed, MassPart, asked_speeds, bearing_forces, mass_parts
from gearwright.sizing.gate import refuse_no_numbers
from gearwright.sizing.margins import Margin, margins
from gearwright.sizing.mounted import BearingSizing, BuiltShaft, Check, JointSizing, ShaftStep
from gearwright.sizing.named import TEXT, Named, named_results, pick, total_results
from gearwright.sizing.pair_data import BevelPairData, CylindricalPairData, pair_data
from gearwright.sizing.profile_shifts import profile_shift
from gearwright.sizing.result import (
    CarrierSizing,
    GearSizing,
    MachineSizing,
    MeshSizing,
    ShaftDiagram,
    ShaftSizing,
    Sizing,
)
from gearwright.sizing.size import size
from gearwright.sizing.stage_summary import StageSummary, stage_summaries

__all__ = [
    "TEXT",
    "AskedSpeed",
    "BearingSizing",
    "BevelPairData",
    "BuiltShaft",
    "CarrierSizing",
    "Check",
    "CylindricalPairData",
    "GearSizing",
    "JointSizing",
    "MachineSizing",
    "Margin",
    "MassPart",
    "MeshSizing",
    "Named",
    "ShaftDiagram",
    "ShaftSizing",
    "ShaftStep",
    "Sizing",
    "StageSummary",
    "asked_speeds",
    "bearing_forces",
    "margins",
    "mass_parts",
    "named_results",
    "pair_data",
    "pick",
    "profile_shift",
    "refuse_no_numbers",
    "size",
    "stage_summaries",
    "total_results",
]
