"""Scuffing of a rated bevel mesh by the integral temperature of its virtual cylindrical gears."""

from __future__ import annotations

from gearwright.parts.bevel import BevelRating, virtual_mesh
from gearwright.parts.iso6336 import RZ_OVER_RA
from gearwright.parts.scuffing import IntegralTemperature, ScuffingMesh, integral_temperature
from gearwright.sizing.rating.iso6336.scuffing import oil_of
from gearwright.sizing.rating.rules import Rating

SCUFFING = "ISO/TR 13989-2, 6.2"


def bevel_scuffing(rating: Rating, factors: BevelRating) -> IntegralTemperature:
    """Return the integral temperature of a bevel mesh and its safety, without relief of the tips.

    Args:
        rating: Resolved rules: roughness, class, oil.
        factors: As rated in the heaviest case.

    Source: ISO/TR 13989-2:2000, 6.2: the formulas of cylindrical gears with z_v, d_va, a_v, v_mt and
        w_Bt = K_A K_V K_Hβ K_Hα F_mt/(0.85 b).
    """
    rules, geometry = rating.rules.iso6336, virtual_mesh(factors.virtual)
    force = factors.tangential_force / float(geometry.face_width)
    scuffed = ScuffingMesh(
        geometry,
        specific_load=force * float(factors.loads.contact),
        nominal_load=force * float(factors.loads.application),
        speed=factors.speed,
        roughness=rules.flank_roughness / RZ_OVER_RA,
        grade=rules.tolerance_class,
        elastic_modulus=rating.material.elastic_modulus,
        poisson_ratio=rating.material.poisson_ratio,
    )
    return integral_temperature(scuffed, oil_of(rules))
