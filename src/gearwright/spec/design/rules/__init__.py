"""How things are rated, proportioned and modelled: gears and their standards, materials, errors, dynamics.

What is rated stands in the design itself; what a method covers in `methods`.
"""

from gearwright.spec.design.rules.bands import ForbiddenBand
from gearwright.spec.design.rules.bearings import GRADE_KEYS, WARMTH_KEYS, BearingRules, OilOfDesign
from gearwright.spec.design.rules.dynamics import DynamicsRules, MeshCurve, PlanetaryBearings
from gearwright.spec.design.rules.gears import SUN_LIMITS, GearRules, TeethRules, ThicknessFit
from gearwright.spec.design.rules.housing import HousingMaterial, HousingRules
from gearwright.spec.design.rules.losses import FrictionName, LossRules, SealName, TorqueName, WindageName
from gearwright.spec.design.rules.materials import LifeLineRules, MaterialRules
from gearwright.spec.design.rules.methods import (
    CYLINDRICAL,
    INTERNAL,
    RATINGS,
    RatingMethod,
    method_of,
    uncovered,
)
from gearwright.spec.design.rules.standards import (
    Agma2001Rules,
    Agma2003Rules,
    AgmaWheelSteel,
    Iso6336Rules,
    WheelSteel,
)
from gearwright.spec.design.rules.tolerance import PartErrors

__all__ = [
    "CYLINDRICAL",
    "GRADE_KEYS",
    "INTERNAL",
    "RATINGS",
    "SUN_LIMITS",
    "WARMTH_KEYS",
    "Agma2001Rules",
    "Agma2003Rules",
    "AgmaWheelSteel",
    "BearingRules",
    "DynamicsRules",
    "ForbiddenBand",
    "FrictionName",
    "GearRules",
    "HousingMaterial",
    "HousingRules",
    "Iso6336Rules",
    "LifeLineRules",
    "LossRules",
    "MaterialRules",
    "MeshCurve",
    "OilOfDesign",
    "PartErrors",
    "PlanetaryBearings",
    "RatingMethod",
    "SealName",
    "TeethRules",
    "ThicknessFit",
    "TorqueName",
    "WheelSteel",
    "WindageName",
    "method_of",
    "uncovered",
]
