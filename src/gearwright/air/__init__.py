"""The air around the aircraft: standard atmosphere and airspeeds."""

from gearwright.air.airspeed import calibrated_of_true, stagnation_ratios, true_of_calibrated
from gearwright.air.along import air_along, stagnation_along, true_along
from gearwright.air.atmosphere import Air, air_at

__all__ = [
    "Air",
    "air_along",
    "air_at",
    "calibrated_of_true",
    "stagnation_along",
    "stagnation_ratios",
    "true_along",
    "true_of_calibrated",
]
