"""From a design to a sized transmission."""

from gearwright.sizing.result import CarrierSizing, GearSizing, MachineSizing, MeshSizing, ShaftSizing, Sizing
from gearwright.sizing.size import size

__all__ = ["CarrierSizing", "GearSizing", "MachineSizing", "MeshSizing", "ShaftSizing", "Sizing", "size"]
