"""Seconds of a mission with propeller, governor and machines on the rigid or elastic train.

The quasi-steady flight around them is in `mission`.
"""

from gearwright.mission.windows.governed import Trim, Window, governed_window, rotor_at, trim_at
from gearwright.mission.windows.window import DynamicWindow, fly_window, window_outputs, window_rules

__all__ = [
    "DynamicWindow",
    "Trim",
    "Window",
    "fly_window",
    "governed_window",
    "rotor_at",
    "trim_at",
    "window_outputs",
    "window_rules",
]
