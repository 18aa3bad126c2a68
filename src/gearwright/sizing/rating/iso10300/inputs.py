"""What ISO 10300 is told of a bevel stage beside its steel: duty, flanks, roots and oil."""

from __future__ import annotations

import math

from gearwright.parts.bevel import (
    BOTH_OVERHUNG,
    HIGH_CROWNING,
    LOW_CROWNING,
    ONE_OVERHUNG,
    STRADDLE,
    BevelDuty,
    BevelPair,
    BevelSurfaces,
    bevel_pitch_tolerance,
)
from gearwright.sizing.rating.iso6336.inputs import SQUARE_MM
from gearwright.sizing.rating.rules import Rating

USUAL_CLASS = 5
"""Tolerance class of ISO 17485 where none is stated [-]."""
_MOUNTING = {"straddle": STRADDLE, "one-overhung": ONE_OVERHUNG, "both-overhung": BOTH_OVERHUNG}


def bevel_duty(rating: Rating, pair: BevelPair, torque: float, speed: float) -> BevelDuty:
    """Return what a bevel mesh carries.

    Args:
        rating: Resolved rules.
        pair: Its geometry.
        torque: On the pinion, of one mesh, load factor included [N m].
        speed: Of the pinion [rad/s].
    """
    rules = rating.rules.iso6336
    return BevelDuty(
        torque,
        speed,
        bevel_pitch_tolerance(pair.mean_diameters[1], pair.mean_module, rules.tolerance_class or USUAL_CLASS),
        application_factor=rating.service.application_factor,
        mounting=_MOUNTING[rules.mounting],
        cutter_radius=math.inf if rating.rules.cutter_radius is None else rating.rules.cutter_radius,
    )


def bevel_surfaces(rating: Rating) -> BevelSurfaces:
    """Return flanks, roots and oil of a bevel stage.

    Args:
        rating: Resolved rules.
    """
    rules = rating.rules.iso6336
    exponent = HIGH_CROWNING if rules.profile_crowning == "high" else LOW_CROWNING
    return BevelSurfaces(rules.flank_roughness, rules.root_roughness, rules.oil_viscosity * SQUARE_MM, exponent)
