"""Load ratings of rolling bearings from what is inside them: ISO 281 (dynamic) and ISO 76 (static).

The standards print the factors f_c and f_0 in tables. Here they come from the formulas behind the tables, which round
to every printed value of f_c; the formulas work in N and mm, and the functions below in SI.
"""

from __future__ import annotations

import math

from gearwright.parts.bearings.contact import ball_contacts, load_at_pressure
from gearwright.parts.bearings.rolling_bearing import BearingGeometry, BearingKind

_MM = 1e3
"""Millimetres in a metre: the factors of ISO 281 and ISO 76 belong to N and mm."""

BALL_CONSTANT = 0.41 * 98.0665
"""Constant of f_c for radial ball bearings [N, mm] (ISO/TR 1281-1:2021; ball bearing constant of ISO 281)."""
BALL_REDUCTION = 0.95
"""λ: what a real bearing of one or two rows carries of the ideal one [-] (ISO/TR 1281-1:2021)."""
LARGE_BALL = 25.4
"""Ball diameter above which ratings grow less steeply [mm] (ISO 281:2007, 5.1)."""
ROLLER_CONSTANT = 207.9
"""Constant of f_c for radial roller bearings [N, mm] (Lundberg & Palmgren 1952; Harris, Rolling Bearing Analysis)."""
ROLLER_REDUCTION = 0.83
"""λν: share of the ideal line contact [-] (ISO/TR 1281-1:2021)."""
MODERN_STEEL = {
    BearingKind.DEEP_GROOVE: 1.3,
    BearingKind.FOUR_POINT: 1.3,
    BearingKind.CYLINDRICAL: 1.1,
    BearingKind.TAPER: 1.1,
}
"""b_m: contemporary steel and manufacture [-] (ISO 281:2007, tables 1 and 6)."""
STATIC_PRESSURE_BALL = 4200e6
"""Pressure in the heaviest loaded ball contact at C_0 [Pa] (ISO 76:2006, 3.2)."""
STATIC_SHARE = 5.0
"""Stribeck's constant: heaviest loaded ball carries 5 F_r / (Z cos α) [-] (ISO/TR 10657:2021)."""
STATIC_MODULUS, STATIC_POISSON = 207e9, 0.3
"""Elastic constants of the steel behind f_0 [Pa, -] (ISO/TR 10657:2021)."""


def ball_dynamic_factor(geometry: BearingGeometry) -> float:
    """Return the factor f_c of a radial ball bearing [N, mm].

    The table of ISO 281 holds for grooves of 0.52 D_w and less on the inner and 0.53 D_w on the outer ring; it is made
    with 0.52 on both, because a wider groove outside does not decide the life of a bearing made so.

    Args:
        geometry: Rolling elements [m].

    Source: ISO/TR 1281-1:2021; table 2 of ISO 281:2007 with r_i = r_e = 0.52 D_w.
    """
    gamma, inner = geometry.curvature_ratio, geometry.inner_conformity
    rings = 1.04 * ((1.0 - gamma) / (1.0 + gamma)) ** 1.72
    combined = (1.0 + rings ** (10.0 / 3.0)) ** -0.3
    shape = gamma**0.3 * (1.0 - gamma) ** 1.39 / math.cbrt(1.0 + gamma)
    return float(BALL_CONSTANT * BALL_REDUCTION * combined * shape * (2.0 * inner / (2.0 * inner - 1.0)) ** 0.41)


def roller_dynamic_factor(geometry: BearingGeometry) -> float:
    """Return the factor f_c of a radial roller bearing [N, mm].

    Args:
        geometry: Rolling elements [m].

    Source: ISO/TR 1281-1:2021; table 7 of ISO 281:2007.
    """
    gamma = geometry.curvature_ratio
    rings = 1.04 * ((1.0 - gamma) / (1.0 + gamma)) ** (143.0 / 108.0)
    shape = gamma ** (2.0 / 9.0) * (1.0 - gamma) ** (29.0 / 27.0) / (1.0 + gamma) ** 0.25
    return float(ROLLER_CONSTANT * ROLLER_REDUCTION * shape * (1.0 + rings**4.5) ** (-2.0 / 9.0))


def dynamic_rating(geometry: BearingGeometry) -> float:
    """Return the basic dynamic radial load rating C_r [N]: the load under which 90 % reach a million turns.

    Args:
        geometry: Rolling elements [m].

    Source: ISO 281:2007, 5.1 (balls): b_m f_c (i cos α)^0.7 Z^(2/3) D_w^1.8, above 25.4 mm 3.647 D_w^1.4;
        7.1 (rollers): b_m f_c (i L_we cos α)^(7/9) Z^(3/4) D_we^(29/27).
    """
    along = geometry.rows * math.cos(geometry.contact_angle)
    element, quality = geometry.diameter * _MM, MODERN_STEEL[geometry.kind]
    if not geometry.kind.is_ball:
        length = (along * geometry.roller_length * _MM) ** (7.0 / 9.0)
        size = geometry.elements**0.75 * element ** (29.0 / 27.0)
        return float(quality * roller_dynamic_factor(geometry) * length * size)
    size = element**1.8 if element <= LARGE_BALL else 3.647 * element**1.4
    return float(quality * ball_dynamic_factor(geometry) * along**0.7 * geometry.elements ** (2.0 / 3.0) * size)


def ball_static_factor(geometry: BearingGeometry) -> float:
    """Return the factor f_0 of a radial ball bearing [N/mm²].

    Args:
        geometry: Rolling elements [m].

    Source: ISO/TR 10657:2021: the load that presses the worse of both contacts with 4200 MPa, over 5 D_w².
    """
    load = min(
        load_at_pressure(contact, STATIC_PRESSURE_BALL, elastic_modulus=STATIC_MODULUS, poisson_ratio=STATIC_POISSON)
        for contact in ball_contacts(geometry)
    )
    return load / (STATIC_SHARE * (geometry.diameter * _MM) ** 2)


def static_rating(geometry: BearingGeometry) -> float:
    """Return the basic static radial load rating C_0r [N]: the load that dents a raceway by 1e-4 of an element.

    Args:
        geometry: Rolling elements [m].

    Source: ISO 76:2006, 5.1 (balls): f_0 i Z D_w² cos α; 7.1 (rollers): 44 (1 − D_we cos α/D_pw) i Z L_we D_we cos α.
    """
    along = geometry.rows * geometry.elements * math.cos(geometry.contact_angle)
    element = geometry.diameter * _MM
    if geometry.kind.is_ball:
        return ball_static_factor(geometry) * along * element**2
    return 44.0 * (1.0 - geometry.curvature_ratio) * along * geometry.roller_length * _MM * element


def fatigue_load_limit(static: float, geometry: BearingGeometry) -> float:
    """Return the load C_u below which a clean and well lubricated bearing does not tire [N].

    Args:
        static: C_0 [N].
        geometry: Kind and pitch diameter [m].

    Source: ISO 281:2007, annex B (simplified): C_0/22 (balls) and C_0/8.2 (rollers), above D_pw = 100 mm times
        (100/D_pw)^0.5 and (100/D_pw)^0.3.
    """
    divisor, exponent = (22.0, 0.5) if geometry.kind.is_ball else (8.2, 0.3)
    return float(static / divisor * min(1.0, 0.1 / geometry.pitch_diameter) ** exponent)
