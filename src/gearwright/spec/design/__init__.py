"""What a user writes of a transmission: stages, machines, shafts, supports, bearings, tolerances, rules.

What can be wrong with it beyond its types is in `checks`.
"""

from gearwright.spec.design.cases import Case, Drive
from gearwright.spec.design.design import GROUND, Design
from gearwright.spec.design.dynamics import DynamicsRules, MeshCurve
from gearwright.spec.design.epicyclics import CentralGear, Epicyclic, PlanetGear
from gearwright.spec.design.gears import SUN_LIMITS, GearRules
from gearwright.spec.design.given import NO_ORIGIN, WEIGHED, Given, given_values
from gearwright.spec.design.limits import Allowed, allowed_for, allowed_in_case
from gearwright.spec.design.machines import (
    MACHINES,
    Accessory,
    Airscrew,
    ElectricMachine,
    Generator,
    Limit,
    Load,
    Machine,
    Motor,
    Propeller,
    Rotor,
    Turbine,
)
from gearwright.spec.design.materials import LifeLineRules, MaterialRules
from gearwright.spec.design.methods import RATINGS, RatingMethod, method_of, uncovered
from gearwright.spec.design.mounting import LOCATES, BearingSeat, Joint
from gearwright.spec.design.profile_shifts import (
    PAIR_ROLES,
    SET_ROLES,
    StageShifts,
    stage_shifts,
    working_angle,
)
from gearwright.spec.design.service import Service
from gearwright.spec.design.shafts import NOTHING_GIVEN, ShaftLayout, Support
from gearwright.spec.design.sharing import module_owners
from gearwright.spec.design.spectrum import RATED, case_named, cases_of, drives_of, shares_of
from gearwright.spec.design.stages import Clutch, Damper, Pair, Planetary
from gearwright.spec.design.standards import Agma2001Rules, Iso6336Rules
from gearwright.spec.design.tolerance import PartErrors

__all__ = [
    "GROUND",
    "LOCATES",
    "MACHINES",
    "NOTHING_GIVEN",
    "NO_ORIGIN",
    "PAIR_ROLES",
    "RATED",
    "RATINGS",
    "SET_ROLES",
    "SUN_LIMITS",
    "WEIGHED",
    "Accessory",
    "Agma2001Rules",
    "Airscrew",
    "Allowed",
    "BearingSeat",
    "Case",
    "CentralGear",
    "Clutch",
    "Damper",
    "Design",
    "Drive",
    "DynamicsRules",
    "ElectricMachine",
    "Epicyclic",
    "GearRules",
    "Generator",
    "Given",
    "Iso6336Rules",
    "Joint",
    "LifeLineRules",
    "Limit",
    "Load",
    "Machine",
    "MaterialRules",
    "MeshCurve",
    "Motor",
    "Pair",
    "PartErrors",
    "PlanetGear",
    "Planetary",
    "Propeller",
    "RatingMethod",
    "Rotor",
    "Service",
    "ShaftLayout",
    "StageShifts",
    "Support",
    "Turbine",
    "allowed_for",
    "allowed_in_case",
    "case_named",
    "cases_of",
    "drives_of",
    "given_values",
    "method_of",
    "module_owners",
    "shares_of",
    "stage_shifts",
    "uncovered",
    "working_angle",
]
