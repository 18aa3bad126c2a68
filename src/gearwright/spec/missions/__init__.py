"""What users write of a mission: its phases, the aircraft or rotorcraft, limits, governors and windows.

Power systems are in `spec/power`; the checks of a whole mission and its reader in `spec/flying`.
"""

from gearwright.spec.missions.aircraft import GROUND_KINDS, Aircraft, Flaps, PhaseKind, Setting
from gearwright.spec.missions.mission import (
    NO_MAP,
    BatteryRules,
    BearingLifeRules,
    EngineRules,
    GearLifeRules,
    Mission,
    MotorRules,
    OilRules,
    Phase,
    engine_out,
)
from gearwright.spec.missions.rotorcraft import Rotorcraft
from gearwright.spec.missions.windows import GovernorRules, WindowRules, window_problems

__all__ = [
    "GROUND_KINDS",
    "NO_MAP",
    "Aircraft",
    "BatteryRules",
    "BearingLifeRules",
    "EngineRules",
    "Flaps",
    "GearLifeRules",
    "GovernorRules",
    "Mission",
    "MotorRules",
    "OilRules",
    "Phase",
    "PhaseKind",
    "Rotorcraft",
    "Setting",
    "WindowRules",
    "engine_out",
    "window_problems",
]
