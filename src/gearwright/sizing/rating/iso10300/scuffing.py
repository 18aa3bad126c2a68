"""Scuffing of a rated bevel mesh by the temperatures of its virtual cylindrical gears."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.parts.bevel import BevelRating, virtual_mesh
from gearwright.parts.iso6336 import RZ_OVER_RA
from gearwright.parts.scuffing import IntegralTemperature, ScuffingMesh, integral_temperature
from gearwright.sizing.rating.iso6336.inputs import steel_of
from gearwright.sizing.rating.iso6336.scuffing import FlashPeak, flash_peak, oil_of
from gearwright.sizing.rating.iso10300.inputs import USUAL_CLASS
from gearwright.sizing.rating.rules import Rating

SCUFFING = ("ISO/TR 13989-2, 6.2", "ISO/TS 6336-20 on the virtual cylindrical gears")
"""Of the integral and of the flash temperature."""
_SAMPLES = 21
"""Places of half the path at which the load over the zone of action is looked at; straight between them."""


class BevelTemperatures(NamedTuple):
    """Both temperatures of a bevel mesh."""

    integral: IntegralTemperature | None
    """By the integral temperature; None where contact lies on one side of the pitch point alone."""
    flash: FlashPeak | None
    """By the flash temperature; None where tips of the virtual gears interfere."""


def bevel_scuffing(rating: Rating, factors: BevelRating) -> BevelTemperatures:
    """Return the temperatures of a bevel mesh and its safeties, without relief of the tips.

    Args:
        rating: Resolved rules: roughness, class, oil.
        factors: As rated in the heaviest case.

    Source: ISO/TR 13989-2:2000, 6.2: the formulas of cylindrical gears with z_v, d_va, a_v, v_mt and
        w_Bt = K_A K_V K_Hβ K_Hα F_mt/(0.85 b); the flash temperature on the same gears, by ISO/TS 6336-20, is no
        document's: ISO/TS 10300-20 was not at hand.
    """
    rules, steel, geometry = rating.rules.iso6336, steel_of(rating), virtual_mesh(factors.virtual)
    force = factors.tangential_force / float(geometry.face_width)
    scuffed = ScuffingMesh(
        geometry,
        specific_load=force * float(factors.loads.contact),
        nominal_load=force * float(factors.loads.application),
        speed=factors.speed,
        roughness=rules.flank_roughness / RZ_OVER_RA,
        grade=rules.tolerance_class or USUAL_CLASS,
        elastic_modulus=steel.elastic_modulus,
        poisson_ratio=steel.poisson_ratio,
    )
    oil = oil_of(rules)
    around = min(float(ratio) for ratio in geometry.addendum_contact_ratios) > 0.0
    integral = integral_temperature(scuffed, oil) if around else None
    if not geometry.rolls:
        return BevelTemperatures(integral, None)

    def sharing(place: Floats) -> Floats:
        along = np.linspace(0.0, 0.5, _SAMPLES)  # even about the middle
        shares = [factors.virtual.load_share(part * factors.virtual.path) for part in along]
        return np.asarray(np.interp(np.abs((place - place[0]) / (place[-1] - place[0]) - 0.5), along, shares))

    return BevelTemperatures(integral, flash_peak(scuffed, oil, sharing))
