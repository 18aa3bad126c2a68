"""Published gear ratings: example 1 of ISO/TR 6336-30, and the geometry factors of AGMA 908."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cache

from gearwright.catalogue import gear_steel
from gearwright.parts.agma2001 import HobbedPair, bending_geometry, pitting_geometry_factor
from gearwright.parts.gears import ISO53_D, CylindricalGear, GearPair
from gearwright.parts.iso6336 import MeshDuty, MeshQuality, PairRating, rate_pair
from gearwright.units import RPM
from gearwright.validate.case import Case

AGMA_FACTORS = (
    (21, 21, 0.33, 0.33, 0.078), (21, 26, 0.33, 0.35, 0.084), (26, 26, 0.35, 0.35, 0.079), (21, 35, 0.34, 0.37, 0.091),
    (26, 35, 0.36, 0.38, 0.088), (35, 35, 0.39, 0.39, 0.080), (21, 55, 0.34, 0.40, 0.102), (26, 55, 0.37, 0.41, 0.101),
    (35, 55, 0.40, 0.42, 0.095), (55, 55, 0.43, 0.43, 0.080), (21, 135, 0.35, 0.43, 0.118),
    (26, 135, 0.38, 0.44, 0.121), (35, 135, 0.41, 0.45, 0.120), (55, 135, 0.45, 0.47, 0.112),
    (135, 135, 0.49, 0.49, 0.080),
)  # fmt: skip
"""Teeth of pinion and gear, J of both, I: 20°, equal addenda, whole depth 2.25, highest single contact."""


@cache
def iso_rating() -> PairRating:
    """Return the rating of example 1: 17 and 103 teeth, 8 mm, 9000 N m at 360 rpm, 50 000 h, grade 5."""
    helix = math.radians(15.8)
    pair = GearPair(
        CylindricalGear(17, 8e-3, 0.1, helix_angle=helix, profile_shift=0.145, rack=ISO53_D),
        CylindricalGear(103, 8e-3, 0.1, helix_angle=helix, rack=ISO53_D),
        0.5,
    )
    steel = gear_steel("case-hardened", "MQ", 700.0)
    quality = MeshQuality(grade=5, flank_roughness=6e-6, tip_relief=70e-6, viscosity=320e-6)
    return rate_pair(pair, (steel, steel), MeshDuty(9000.0, 360.0 * RPM, 50_000 * 3600.0), quality=quality)


def _geometry() -> Sequence[float]:
    rated = iso_rating().pitting.geometry
    return [float(value) for value in (rated.zone, rated.elasticity / 1e3, rated.helix)]


def _film() -> Sequence[float]:
    strength = iso_rating().contact_strength[0]
    return [float(value) for value in (strength.lubricant, strength.speed, strength.roughness)]


def _stresses() -> Sequence[float]:
    rated = iso_rating().pitting
    return [float(value) / 1e6 for value in (rated.nominal_stress, *rated.permissible)]


def _loads() -> Sequence[float]:
    rated = iso_rating()
    return [float(value) for value in (rated.tangential_force, rated.speed, rated.dynamic.factor)]


def _bending() -> Sequence[float]:
    pairs = [HobbedPair((row[0], row[1])) for row in AGMA_FACTORS]
    return [float(bending_geometry(pair, gear).factor) for pair in pairs for gear in (0, 1)]


def _pitting() -> Sequence[float]:
    return [float(pitting_geometry_factor(HobbedPair((row[0], row[1])))) for row in AGMA_FACTORS]


_ISO = "ISO/TR 6336-30:2017, example 1"
CASES = (
    Case("Z_H, Z_E, Z_β", _ISO, "√N/mm for Z_E", (2.39533, 189.8117, 1.01944), _geometry, 1e-5, "six digits printed"),
    Case("Z_L, Z_v, Z_R", _ISO, "", (1.04739, 0.96911, 0.96599), _film, 1e-5, "five digits printed"),
    Case("F_t, v, K_v", _ISO, "N, m/s, –", (127352.0, 2.664, 1.003), _loads, 5e-4, "K_v and v have four digits"),
    Case("σ_H0, σ_HP1, σ_HP2", _ISO, "MPa", (1206.58207, 1338.48050, 1414.52551), _stresses, 1e-4,
         "the contact ratio there is rounded to three decimals"),
    Case("bending geometry factor J", "AGMA 908-B89", "", tuple(value for row in AGMA_FACTORS for value in row[2:4]),
         _bending, 0.0065, "two decimals, by charts", is_relative=False),
    Case("pitting geometry factor I", "AGMA 908-B89", "", tuple(row[4] for row in AGMA_FACTORS), _pitting, 5e-4,
         "three decimals", is_relative=False),
)  # fmt: skip
"""Published ratings."""
