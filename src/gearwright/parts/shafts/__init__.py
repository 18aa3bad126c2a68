"""Shafts: equilibrium, bending, stress, notches, fatigue, critical speed.

What joins hubs to them is in `joints`.
"""

from gearwright.parts.shafts.beam import Diagram, PointLoads, bearing_reactions, diagram, supported
from gearwright.parts.shafts.critical_speed import critical_speed, lumped_shaft
from gearwright.parts.shafts.deflection import BentLine, Sections, bent_line, influence
from gearwright.parts.shafts.din743 import (
    Overload,
    ShaftSection,
    ShaftSteel,
    SteelGroup,
    blank_factor,
    din743_safety,
    section_factor,
    surface_factors,
    yield_limits,
)
from gearwright.parts.shafts.fatigue import (
    CRITERIA,
    NO_NOTCH,
    RELIABILITY_DEVIATES,
    FatigueStrength,
    SectionLoad,
    asme_safety,
    endurance_limit,
    gerber_safety,
    goodman_safety,
    section_stress,
    soderberg_safety,
    yield_safety,
)
from gearwright.parts.shafts.hub_notch import keyseat_concentration, keyway_factor, press_fit_factor, spline_factor
from gearwright.parts.shafts.notch import (
    LEAST_RADIUS,
    Concentration,
    Shoulder,
    fatigue_notch_factor,
    felt_concentration,
    notch_sensitivity,
    stress_concentration,
)
from gearwright.parts.shafts.shaft import (
    shaft_diameter,
    shaft_diameter_around,
    shaft_inertia,
    shaft_mass,
    shaft_stress,
    torsional_stiffness,
)

__all__ = [
    "CRITERIA",
    "LEAST_RADIUS",
    "NO_NOTCH",
    "RELIABILITY_DEVIATES",
    "BentLine",
    "Concentration",
    "Diagram",
    "FatigueStrength",
    "Overload",
    "PointLoads",
    "SectionLoad",
    "Sections",
    "ShaftSection",
    "ShaftSteel",
    "Shoulder",
    "SteelGroup",
    "asme_safety",
    "bearing_reactions",
    "bent_line",
    "blank_factor",
    "critical_speed",
    "diagram",
    "din743_safety",
    "endurance_limit",
    "fatigue_notch_factor",
    "felt_concentration",
    "gerber_safety",
    "goodman_safety",
    "influence",
    "keyseat_concentration",
    "keyway_factor",
    "lumped_shaft",
    "notch_sensitivity",
    "press_fit_factor",
    "section_factor",
    "section_stress",
    "shaft_diameter",
    "shaft_diameter_around",
    "shaft_inertia",
    "shaft_mass",
    "shaft_stress",
    "soderberg_safety",
    "spline_factor",
    "stress_concentration",
    "supported",
    "surface_factors",
    "torsional_stiffness",
    "yield_limits",
    "yield_safety",
]
