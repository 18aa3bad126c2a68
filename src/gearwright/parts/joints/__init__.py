"""What joins a hub to its shaft: keys, splines, press fits.

The notches that they make in the shaft are in `shafts`.
"""

from gearwright.parts.joints.key import LONGEST_BEARING, KeySection, bearing_length, key_length, key_pressure
from gearwright.parts.joints.press_fit import (
    FitPart,
    centrifugal_loss,
    fit_interference,
    fit_pressure,
    fit_torque,
    hub_stress,
    shaft_fit_stress,
)
from gearwright.parts.joints.spline import MODULES, SHORTEST_RATIO, Spline, spline, spline_length, spline_pressure

__all__ = [
    "LONGEST_BEARING",
    "MODULES",
    "SHORTEST_RATIO",
    "FitPart",
    "KeySection",
    "Spline",
    "bearing_length",
    "centrifugal_loss",
    "fit_interference",
    "fit_pressure",
    "fit_torque",
    "hub_stress",
    "key_length",
    "key_pressure",
    "shaft_fit_stress",
    "spline",
    "spline_length",
    "spline_pressure",
]
