"""From a design to a sized transmission."""

from gearwright.sizing.mounted import BearingSizing, BuiltShaft, Check, JointSizing, ShaftStep
from gearwright.sizing.named import TEXT, Named, named_results, pick, total_results
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

__all__ = [
    "TEXT",
    "BearingSizing",
    "BuiltShaft",
    "CarrierSizing",
    "Check",
    "GearSizing",
    "JointSizing",
    "MachineSizing",
    "MeshSizing",
    "Named",
    "ShaftDiagram",
    "ShaftSizing",
    "ShaftStep",
    "Sizing",
    "named_results",
    "pick",
    "size",
    "total_results",
]
