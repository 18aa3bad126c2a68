"""The air around the aircraft: standard atmosphere and airspeeds."""

from gearwright.air.airspeed import calibrated_of_true, stagnation_ratios, true_of_calibrated
from gearwright.air.atmosphere import Air, air_at

__all__ = ["Air", "air_at", "calibrated_of_true", "stagnation_ratios", "true_of_calibrated"]
