"""The air around the aircraft: standard atmosphere, airspeeds, and what a drag polar makes of them."""

from gearwright.air.airspeed import calibrated_of_true, stagnation_ratios, true_of_calibrated
from gearwright.air.along import air_along, stagnation_along, true_along
from gearwright.air.atmosphere import Air, air_at, height, sound_speed
from gearwright.air.polar import Polar, drag_force, dynamic_force, stall_speed

__all__ = [
    "Air",
    "Polar",
    "air_along",
    "air_at",
    "calibrated_of_true",
    "drag_force",
    "dynamic_force",
    "height",
    "sound_speed",
    "stagnation_along",
    "stagnation_ratios",
    "stall_speed",
    "true_along",
    "true_of_calibrated",
]
