"""Seconds of a mission with propeller, governor and machines on the rigid or elastic train.

The quasi-steady flight around them is in `mission`.
"""

from gearwright.mission.windows.window import (
    BegunWindow,
    DynamicWindow,
    PropellerTrim,
    Window,
    begun_window,
    fly_window,
    governed_window,
    rotor_at,
    trim_at,
    window_outputs,
    window_rules,
)

__all__ = [
    "BegunWindow",
    "DynamicWindow",
    "PropellerTrim",
    "Window",
    "begun_window",
    "fly_window",
    "governed_window",
    "rotor_at",
    "trim_at",
    "window_outputs",
    "window_rules",
]
