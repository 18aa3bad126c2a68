"""What users write: the design file, its types, its reader and its JSON Schema."""

from gearwright.spec.design import (
    GROUND,
    Clutch,
    Design,
    Drive,
    GearRules,
    Motor,
    Pair,
    Planetary,
    Propeller,
    Turbine,
)
from gearwright.spec.read import parse, read
from gearwright.spec.schema import schema

__all__ = [
    "GROUND",
    "Clutch",
    "Design",
    "Drive",
    "GearRules",
    "Motor",
    "Pair",
    "Planetary",
    "Propeller",
    "Turbine",
    "parse",
    "read",
    "schema",
]
