"""What turns a transmission and how long: machines with their limits, load cases, hours of service.

Which case speaks for a design is in `spectrum`, which knows the design.
"""

from gearwright.spec.design.duty.cases import Case, Drive, Spectrum
from gearwright.spec.design.duty.limits import Allowed, allowed_for, allowed_in_case
from gearwright.spec.design.duty.machines import (
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
    SpeedRules,
    Turbine,
)
from gearwright.spec.design.duty.service import Service

__all__ = [
    "MACHINES",
    "Accessory",
    "Airscrew",
    "Allowed",
    "Case",
    "Drive",
    "ElectricMachine",
    "Generator",
    "Limit",
    "Load",
    "Machine",
    "Motor",
    "Propeller",
    "Rotor",
    "Service",
    "Spectrum",
    "SpeedRules",
    "Turbine",
    "allowed_for",
    "allowed_in_case",
]
