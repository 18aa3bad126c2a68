"""What a user writes of a transmission: stages, machines, shafts, supports, bearings, tolerances, rules.

What can be wrong with it beyond its types is in `checks`.
"""

from gearwright.spec.design.design import GROUND, Design
from gearwright.spec.design.dynamics import DynamicsRules, MeshCurve
from gearwright.spec.design.epicyclics import CentralGear, Epicyclic, PlanetGear
from gearwright.spec.design.gears import GearRules
from gearwright.spec.design.given import NO_ORIGIN, Given, given_values
from gearwright.spec.design.machines import Drive, Motor, Propeller, Turbine
from gearwright.spec.design.materials import LifeLineRules, MaterialRules
from gearwright.spec.design.methods import RATINGS, RatingMethod, method_of, uncovered
from gearwright.spec.design.mounting import LOCATES, BearingSeat, Joint
from gearwright.spec.design.service import Service
from gearwright.spec.design.shafts import NOTHING_GIVEN, ShaftLayout, Support
from gearwright.spec.design.sharing import module_owners
from gearwright.spec.design.stages import Clutch, Damper, Pair, Planetary
from gearwright.spec.design.standards import Agma2001Rules, Iso6336Rules
from gearwright.spec.design.tolerance import PartErrors

__all__ = [
    "GROUND",
    "LOCATES",
    "NOTHING_GIVEN",
    "NO_ORIGIN",
    "RATINGS",
    "Agma2001Rules",
    "BearingSeat",
    "CentralGear",
    "Clutch",
    "Damper",
    "Design",
    "Drive",
    "DynamicsRules",
    "Epicyclic",
    "GearRules",
    "Given",
    "Iso6336Rules",
    "Joint",
    "LifeLineRules",
    "MaterialRules",
    "MeshCurve",
    "Motor",
    "Pair",
    "PartErrors",
    "PlanetGear",
    "Planetary",
    "Propeller",
    "RatingMethod",
    "Service",
    "ShaftLayout",
    "Support",
    "Turbine",
    "given_values",
    "method_of",
    "module_owners",
    "uncovered",
]
