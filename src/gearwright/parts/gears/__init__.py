"""Cylindrical gears: involute, one gear, two in mesh, their bodies, and the first stresses of Lewis and Hertz.

Rating by a standard lives in `iso6336` and `agma2001`, cones in `bevel`, mesh stiffness in `stiffness`.
"""

from gearwright.parts.gears.cylindrical_gear import (
    ISO53_A,
    ISO53_D,
    BasicRack,
    CylindricalGear,
    half_angle_at,
    pressure_angle_at,
    tip_thickness,
)
from gearwright.parts.gears.gear_body import disc_inertia, disc_mass, ring_inertia, ring_mass
from gearwright.parts.gears.gear_pair import GearPair, contact_radii
from gearwright.parts.gears.hertz import (
    HERTZ_COEFFICIENT,
    ContactAngles,
    Numbers,
    contact_angles,
    contact_stress,
    hertz_coefficient,
    module_hertz,
)
from gearwright.parts.gears.internal_interference import (
    Room,
    assembly_room,
    interference,
    involute_clearance,
    involute_room,
    radial_assembly_gap,
    tip_clearance_angle,
    tip_room,
)
from gearwright.parts.gears.involute import (
    base_helix_angle,
    involute,
    involute_angle,
    least_profile_shift,
    least_teeth,
    shift_sum,
    transverse_pressure_angle,
    virtual_teeth,
    working_pressure_angle,
)
from gearwright.parts.gears.lewis import FEWEST_TEETH, bending_stress_lewis, lewis_form_factor, module_lewis
from gearwright.parts.gears.tooth_allowance import feed_grade, least_backlash, runout_tolerance, span_allowances
from gearwright.parts.gears.tooth_form import ToothForm, load_point, tooth_form
from gearwright.parts.gears.tooth_measurement import ball_measurement, span_measurement, spanned_teeth
from gearwright.parts.gears.working_centre import (
    UNSHIFTED,
    ToothShift,
    reference_centre,
    shifts_at,
    tip_shortening,
    working_angle_at,
    working_centre,
)

__all__ = [
    "FEWEST_TEETH",
    "HERTZ_COEFFICIENT",
    "ISO53_A",
    "ISO53_D",
    "UNSHIFTED",
    "BasicRack",
    "ContactAngles",
    "CylindricalGear",
    "GearPair",
    "Numbers",
    "Room",
    "ToothForm",
    "ToothShift",
    "assembly_room",
    "ball_measurement",
    "base_helix_angle",
    "bending_stress_lewis",
    "contact_angles",
    "contact_radii",
    "contact_stress",
    "disc_inertia",
    "disc_mass",
    "feed_grade",
    "half_angle_at",
    "hertz_coefficient",
    "interference",
    "involute",
    "involute_angle",
    "involute_clearance",
    "involute_room",
    "least_backlash",
    "least_profile_shift",
    "least_teeth",
    "lewis_form_factor",
    "load_point",
    "module_hertz",
    "module_lewis",
    "pressure_angle_at",
    "radial_assembly_gap",
    "reference_centre",
    "ring_inertia",
    "ring_mass",
    "runout_tolerance",
    "shift_sum",
    "shifts_at",
    "span_allowances",
    "span_measurement",
    "spanned_teeth",
    "tip_clearance_angle",
    "tip_room",
    "tip_shortening",
    "tip_thickness",
    "tooth_form",
    "transverse_pressure_angle",
    "virtual_teeth",
    "working_angle_at",
    "working_centre",
    "working_pressure_angle",
]
