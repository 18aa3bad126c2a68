"""Propellers from their blades: sections, geometry, blade-element momentum in every state of the stream, maps.

Charts and maps themselves are read beside this room; what a file says of a blade is read by the catalogue.
"""

from gearwright.machines.propellers.blade import BladeShape, activity_factor, generic_blade, integrated_lift
from gearwright.machines.propellers.continued import continued, element_map
from gearwright.machines.propellers.elements import Loads, loads
from gearwright.machines.propellers.feather import Feathered, feathered
from gearwright.machines.propellers.incidence import Inclined, inclined
from gearwright.machines.propellers.sections import SectionLoads, section_loads

__all__ = [
    "BladeShape",
    "Feathered",
    "Inclined",
    "Loads",
    "SectionLoads",
    "activity_factor",
    "continued",
    "element_map",
    "feathered",
    "generic_blade",
    "inclined",
    "integrated_lift",
    "loads",
    "section_loads",
]
