"""Internal geometry, Hertzian contact, load ratings, speeds and masses of rolling bearings."""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import StrEnum
from types import MappingProxyType
from typing import Literal, NamedTuple

import numpy as np

from gearwright.base import RPM, Angle, Floats, Length, Number, Problem, Ratio, SolveError, refuse

# ----------------------------------------------------------------------------------------------------------------------
# What is inside a rolling bearing: its rolling elements and the curvature of its raceways.
# ----------------------------------------------------------------------------------------------------------------------


class BearingKind(StrEnum):
    """Kinds of radial rolling bearings that gearwright rates."""

    DEEP_GROOVE = "deep-groove ball"
    FOUR_POINT = "four-point contact ball"
    CYLINDRICAL = "cylindrical roller"
    TAPER = "taper roller"

    @property
    def is_ball(self) -> bool:
        """True where the rolling elements touch the raceways at points."""
        return self in (BearingKind.DEEP_GROOVE, BearingKind.FOUR_POINT)


@dataclass(frozen=True)
class BearingGeometry:
    """Rolling elements and raceways, as the ratings of ISO 281 and ISO 76 see them."""

    kind: BearingKind
    elements: Number
    """Rolling elements of one row Z [-]."""
    diameter: Length
    """Ball diameter D_w, or mean diameter of the rollers D_we [m]."""
    pitch_diameter: Length
    """D_pw [m]."""
    contact_angle: Angle = 0.0
    """Nominal contact angle α [rad]."""
    roller_length: Length = 0.0
    """Effective length of the rollers L_we [m]; 0 for balls."""
    rows: Number = 1
    """Rows i [-]; a four-point contact bearing counts as two, because its balls work in both directions."""
    inner_conformity: Ratio = 0.52
    """Groove radius of the inner ring over ball diameter r_i/D_w [-]."""
    outer_conformity: Ratio = 0.53
    """Groove radius of the outer ring over ball diameter r_e/D_w [-]."""

    def __post_init__(self) -> None:
        """Refuse what cannot be built."""
        problems = []
        if self.elements < 3:
            problems.append(Problem("elements", f"{self.elements:g} given; a ring needs 3 rolling elements or more"))
        if not 0.0 < self.diameter < self.pitch_diameter:
            message = f"{1e3 * self.diameter:g} mm given; allowed: above 0, below the pitch diameter"
            problems.append(Problem("diameter", message))
        if not self.kind.is_ball and self.roller_length <= 0.0:
            problems.append(Problem("roller_length", f"{1e3 * self.roller_length:g} mm given; rollers need a length"))
        if self.kind is BearingKind.TAPER and not 0.0 < self.contact_angle < math.pi / 4.0:
            message = f"{math.degrees(self.contact_angle):g}° given; a taper bearing has more than 0° and less than 45°"
            problems.append(Problem("contact_angle", message))
        if min(self.inner_conformity, self.outer_conformity) <= 0.5:
            message = (
                f"{min(self.inner_conformity, self.outer_conformity):g} given; a groove is wider than its ball: > 0.5"
            )
            problems.append(Problem("conformity", message))
        refuse(problems)

    @property
    def curvature_ratio(self) -> float:
        """γ = D_w cos α / D_pw [-]."""
        return self.diameter * math.cos(self.contact_angle) / self.pitch_diameter

    @property
    def conformity_ratio(self) -> float:
        """(r_i/r_e) (2 r_e − D_w)/(2 r_i − D_w) [-]."""
        inner, outer = self.inner_conformity, self.outer_conformity
        return inner / outer * (2.0 * outer - 1.0) / (2.0 * inner - 1.0)


# ----------------------------------------------------------------------------------------------------------------------
# Hertz's contact of a ball and its two raceways: how far they approach, and how hard they press.
#
# A ball in a groove touches it over an ellipse. Its axes follow from the sum and the difference of the curvatures
# alone.
# ----------------------------------------------------------------------------------------------------------------------


_ROUNDING = 1e-14
"""Step at which the search for ln χ and the means of an elliptic integral end [-]."""
_STEPS = 20
"""Of that search at most: half a dozen end it, but for nearly round contacts, where rounding is larger."""
_NEARLY_ROUND = 1e-4
"""F(ρ) below which ln χ = 4/3 F(ρ) holds to rounding, and the equation's difference of integrals is all rounding."""


class Curvature(NamedTuple):
    """Curvatures of a ball and a raceway where they touch."""

    total: float
    """Σρ [1/m]."""
    difference: float
    """Relative difference F(ρ) [-]."""


class Contacts(NamedTuple):
    """Curvatures at both raceways."""

    inner: Curvature
    """At the inner ring."""
    outer: Curvature
    """At the outer ring."""


def ball_contacts(geometry: BearingGeometry) -> Contacts:
    """Return the curvatures of a ball against both raceways.

    Args:
        geometry: Of a ball bearing [m].

    Source: ISO/TS 16281:2008: Σρ_i = 2/D_w (2 + γ/(1−γ) − D_w/(2 r_i)), outer ring with −γ/(1+γ) and r_e.
    """
    gamma, ball = geometry.curvature_ratio, geometry.diameter
    return Contacts(
        _curvature(gamma / (1.0 - gamma), 0.5 / geometry.inner_conformity, ball),
        _curvature(-gamma / (1.0 + gamma), 0.5 / geometry.outer_conformity, ball),
    )


def _curvature(rolling: float, groove: float, ball: float) -> Curvature:
    total = 2.0 + rolling - groove
    return Curvature(2.0 / ball * total, (rolling + groove) / total)


def ellipse_ratio(difference: float) -> float:
    """Return the ratio of the axes of the contact ellipse χ [-].

    Args:
        difference: Relative difference of the curvatures F(ρ) [-], 0 for a circle.

    Source: ISO/TS 16281:2008: 1 − 2/(χ²−1) (K(χ)/E(χ) − 1) = F(ρ), after Hertz 1882; by secants of ln(1 − F) over
        ln χ, which is nearly straight: of slope −3/4 at a circle and towards −2 for long ellipses.

    >>> round(ellipse_ratio(0.0), 3)
    1.0
    """
    if difference < _NEARLY_ROUND:
        return math.exp(4.0 / 3.0 * difference)
    wanted = math.log1p(-difference)
    before, here = -wanted, -4.0 / 3.0 * wanted
    missed = _log_remainder(before) - wanted
    for _ in range(_STEPS):
        last, missed = missed, _log_remainder(here) - wanted
        if missed == last:
            break
        before, here = here, here - missed * (here - before) / (missed - last)
        if abs(here - before) < _ROUNDING:
            break
    return math.exp(here)


def _log_remainder(log_ratio: float) -> float:
    """Return ln(1 − F(ρ)) of a contact ellipse of a ratio ln χ."""
    first, second = _integrals(math.exp(log_ratio))
    return math.log(2.0 / math.expm1(2.0 * log_ratio) * (first / second - 1.0))


def _integrals(ratio: float) -> tuple[float, float]:
    """Return the complete elliptic integrals K(χ) and E(χ) of the modulus √(1 − 1/χ²).

    Source: Abramowitz, Stegun 1964, 17.6.3 and 17.6.4, by the arithmetic-geometric mean.
    """
    mean, geometric, left, weight = 1.0, 1.0 / ratio, 1.0 - 1.0 / ratio**2, 0.5
    missing = weight * left
    while left > _ROUNDING**2:
        mean, geometric, left = 0.5 * (mean + geometric), math.sqrt(mean * geometric), (0.5 * (mean - geometric)) ** 2
        weight *= 2.0
        missing += weight * left
    first = 0.5 * math.pi / mean
    return first, first * (1.0 - missing)


def load_deflection_constant(contacts: Contacts, *, elastic_modulus: float, poisson_ratio: float) -> float:
    """Return the constant of Q = c_P δ^(3/2) for a ball between both raceways [N/m^1.5].

    Args:
        contacts: From `ball_contacts` [1/m].
        elastic_modulus: E of balls and rings [Pa].
        poisson_ratio: ν of balls and rings [-].

    Source: ISO/TS 16281:2008, with π √2 / 3 = 1.481 where the standard prints 1.48.
    """
    approach = sum(_approach(contact) for contact in contacts)
    return math.pi * math.sqrt(2.0) / 3.0 * elastic_modulus / (1.0 - poisson_ratio**2) / math.sqrt(approach) ** 3


def _approach(contact: Curvature) -> float:
    ratio = ellipse_ratio(contact.difference)
    first, second = _integrals(ratio)
    return first * math.cbrt(contact.total / (ratio**2 * second))


def load_at_pressure(contact: Curvature, pressure: float, *, elastic_modulus: float, poisson_ratio: float) -> float:
    """Return the load of a contact at which the pressure in its middle reaches a value [N].

    Args:
        contact: Curvatures [1/m].
        pressure: Greatest pressure p [Pa].
        elastic_modulus: E of both bodies [Pa].
        poisson_ratio: ν of both bodies [-].

    Source: Hertz 1882; semi-axes √[3](2 χ² E(χ)/π · 3 Q (1−ν²)/(E Σρ)) and 1/χ of it, p = 3 Q / (2 π a b).
    """
    ratio = ellipse_ratio(contact.difference)
    area = math.cbrt((2.0 * _integrals(ratio)[1] / math.pi) ** 2 * ratio)
    compliance = 3.0 * (1.0 - poisson_ratio**2) / (elastic_modulus * contact.total)
    return (2.0 * math.pi / 3.0 * pressure * area) ** 3 * compliance**2


# ----------------------------------------------------------------------------------------------------------------------
# Load ratings of rolling bearings from what is inside them: ISO 281 (dynamic) and ISO 76 (static).
#
# The standards print the factors f_c and f_0 in tables. Here they come from the formulas behind the tables, which round
# to every printed value of f_c; the formulas work in N and mm, and the functions below in SI.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# What a rolling bearing must bear so as not to skid, and how fast it may turn.
# ----------------------------------------------------------------------------------------------------------------------


REFERENCE_VISCOSITY = 12e-6
"""Of the oil of the reference conditions at 70 °C, radial bearings [m²/s] (ISO 15312)."""
REFERENCE_LOAD = 0.05
"""Radial load of the reference conditions over C_0 [-] (ISO 15312)."""
_HEAT_FLOW, _WIDEST = 0.016e6, 0.05
"""Reference heat flow density [W/m²] up to a surface [m²] (ISO 15312), from which on it falls."""
_FALL = -0.34
_ROUNDS = 80


Lubrication = Literal["grease", "jet", "under-race"]
"""How oil comes to a bearing: packed with grease, by jets from the side, or through its inner ring."""


class SpeedLimit(NamedTuple):
    """What n d_m a kind of bearing bears [mm/min]."""

    usual: float
    """Without more ado."""
    careful: float
    """With a cage guided on lands, accurate parts, clean and cool oil."""


SPEED_LIMITS = MappingProxyType(
    {
        ("grease", "ball"): SpeedLimit(0.5e6, 0.7e6),
        ("grease", "roller"): SpeedLimit(0.3e6, 0.5e6),
        ("grease", "taper"): SpeedLimit(0.3e6, 0.5e6),
        ("jet", "ball"): SpeedLimit(1.2e6, 1.8e6),
        ("jet", "roller"): SpeedLimit(1.0e6, 1.5e6),
        ("jet", "taper"): SpeedLimit(0.5e6, 0.8e6),
        ("under-race", "ball"): SpeedLimit(2.0e6, 3.0e6),
        ("under-race", "roller"): SpeedLimit(2.0e6, 3.0e6),
        ("under-race", "taper"): SpeedLimit(1.0e6, 2.4e6),
    }
)
"""Lubrication and what rolls -> limits; of taper rollers under the races with oil to their rib, too."""


def speed_limit(kind: BearingKind, lubrication: Lubrication) -> SpeedLimit:
    """Return the n d_m that a bearing bears [mm/min].

    Args:
        kind: Of bearing [-].
        lubrication: How oil comes to it [-].

    Source: usual speeds of makers' catalogues, oil or grease of the trade; oil under the races after tests of NASA
        with ball and roller (to 3e6) and taper bearings with fed ribs (to 2.4e6). Estimates: the maker says better.
    """
    rolls = "ball" if kind.is_ball else "taper" if kind is BearingKind.TAPER else "roller"
    return SPEED_LIMITS[lubrication, rolls]


def least_load(rating: float, kind: BearingKind) -> float:
    """Return the load below which rolling elements may skid [N].

    Args:
        rating: C [N].
        kind: Of bearing [-].

    Source: general rule of makers' catalogues (SKF, Rolling bearings, requisite minimum load): 0.01 C for ball, 0.02 C
        for roller bearings.

    >>> least_load(60e3, BearingKind.CYLINDRICAL)
    1200.0
    """
    return (0.01 if kind.is_ball else 0.02) * rating


def speed_factor(speed: float, bore: float, outer_diameter: float) -> float:
    """Return the speed factor n d_m [mm/min].

    Args:
        speed: [rad/s].
        bore: d [m].
        outer_diameter: D [m].

    Source: n (d + D)/2 in 1/min and mm, as makers' catalogues have it.
    """
    return abs(speed) / RPM * 1e3 * (bore + outer_diameter) / 2.0


def reference_heat(bore: float, outer_diameter: float, width: float) -> float:
    """Return the heat that a radial bearing gives off under reference conditions [W].

    Args:
        bore: d [m].
        outer_diameter: D [m].
        width: B [m].

    Source: ISO 15312:2003: q_r A_r, A_r = π B (D + d), q_r = 0.016 W/mm² up to 50 000 mm², then falling by
        (A_r/50 000)^-0.34.
    """
    surface = math.pi * width * (outer_diameter + bore)
    return _HEAT_FLOW * surface * math.pow(max(surface / _WIDEST, 1.0), _FALL)


def thermal_reference_speed(
    bore: float, outer_diameter: float, width: float, *, static_rating: float, oil_factor: float, load_factor: float
) -> float:
    """Return the speed at which a radial bearing warms to 70 °C under reference conditions [rad/s].

    Args:
        bore: d [m].
        outer_diameter: D [m].
        width: B [m].
        static_rating: C_0 [N].
        oil_factor: f_0r of its series [-].
        load_factor: f_1r of its series [-].

    Source: ISO 15312:2003: π n/(30·10³) (1e-7 f_0r (ν_r n)^(2/3) d_m³ + f_1r P_1r d_m) = q_r A_r, with 12 mm²/s, 5 %
        of C_0 and 20 °C around.

    Valid for: oil bath or circulating oil at 70 °C; oil that carries heat away allows more.
    """
    heat, diameter = reference_heat(bore, outer_diameter, width), 1e3 * (bore + outer_diameter) / 2.0
    loaded = 1e-3 * load_factor * REFERENCE_LOAD * static_rating * diameter
    idle = 1e-10 * oil_factor * (REFERENCE_VISCOSITY * 1e6 / RPM) ** (2.0 / 3.0) * diameter**3
    speed = (heat / idle) ** 0.6  # without load, hence from above
    for _ in range(_ROUNDS):  # Newton on a convex function
        excess = speed * (idle * speed ** (2.0 / 3.0) + loaded) - heat
        step = excess / (5.0 / 3.0 * idle * speed ** (2.0 / 3.0) + loaded)
        speed -= step
        if step < 1e-13 * speed:
            break
    return float(speed)


# ----------------------------------------------------------------------------------------------------------------------
# What the parts of a rolling bearing weigh: rings, rolling elements and cage, as cylinders and spheres.
# ----------------------------------------------------------------------------------------------------------------------


STEEL_DENSITY = 7850.0
"""Of rings and cages [kg/m³]."""
CERAMIC_DENSITY = 3200.0
"""Of silicon nitride rollers, Si3N4 [kg/m³]."""
CERAMIC_MODULUS, CERAMIC_POISSON = 310e9, 0.27
"""Elastic constants of silicon nitride [Pa, -]."""
STEEL_MODULUS, STEEL_POISSON = 206e9, 0.3
"""Elastic constants of bearing steel [Pa, -]."""
CAGE_SHARE = 0.4
"""Part of the room that rolling elements leave between the raceways which a cage takes, an assumption [-]."""


class RollingWeights(NamedTuple):
    """What each part of a rolling bearing weighs [kg]."""

    inner_ring: float
    """0 where the shaft is the raceway."""
    outer_ring: float
    """0 where the bore around is the raceway."""
    elements: float
    cage: float

    @property
    def total(self) -> float:
        """All together [kg]."""
        return sum(self)


def rolling_weights(
    inside: BearingGeometry, bore: float, outer_diameter: float, width: float, *, density: float = STEEL_DENSITY
) -> RollingWeights:
    """Return what the parts of a bearing weigh.

    Args:
        inside: Its rolling elements.
        bore: d [m].
        outer_diameter: D [m].
        width: Of the rings [m].
        density: Of the rolling elements [kg/m³].

    Source: cylinders between d, D_pw − D_w, D_pw + D_w and D; a cage that takes `CAGE_SHARE` of what is left between.
    """
    inner, outer = inside.pitch_diameter - inside.diameter, inside.pitch_diameter + inside.diameter
    length = inside.diameter if inside.kind.is_ball else inside.roller_length
    one = (2.0 / 3.0 if inside.kind.is_ball else 1.0) * math.pi / 4.0 * inside.diameter**2 * length
    elements = inside.elements * one * (inside.rows if not inside.kind.is_ball else 1)
    between = math.pi / 4.0 * (outer**2 - inner**2) * length * (inside.rows if not inside.kind.is_ball else 1)
    return RollingWeights(
        inner_ring=STEEL_DENSITY * math.pi / 4.0 * max(inner**2 - bore**2, 0.0) * width,
        outer_ring=STEEL_DENSITY * math.pi / 4.0 * max(outer_diameter**2 - outer**2, 0.0) * width,
        elements=density * elements,
        cage=STEEL_DENSITY * CAGE_SHARE * (between - elements),
    )


def turning_inertia(weights: RollingWeights, inside: BearingGeometry, outer_diameter: float) -> float:
    """Return the inertia of what turns when the outer ring does, at its speed [kg m²].

    Args:
        weights: Of the bearing's parts.
        inside: Its rolling elements.
        outer_diameter: D [m].

    Source: annulus of the outer ring, and a ring of elements and cage at D_pw that turns at (1 + γ)/2 of its speed.
    """
    outer = inside.pitch_diameter + inside.diameter
    ring = weights.outer_ring * (outer_diameter**2 + outer**2) / 8.0
    share = (1.0 + inside.curvature_ratio) / 2.0
    return ring + (weights.elements + weights.cage) * (inside.pitch_diameter / 2.0) ** 2 * share**2


def ceramic_share() -> float:
    """Return the load of a ceramic roller on steel over that of a steel one at the same pressure [-].

    Stiffer rollers press harder: so much less load gives the same pressure, and here it is taken for the same life.
    ISO 20056-1 takes ratings of hybrid bearings as of steel ones: this is on the safe side.

    Source: Hertz, line contact: p² ∝ Q/(1/E'_1 + 1/E'_2), with E' = E/(1 − ν²).

    >>> round(ceramic_share(), 2)
    0.84
    """
    steel = (1.0 - STEEL_POISSON**2) / STEEL_MODULUS
    return (steel + (1.0 - CERAMIC_POISSON**2) / CERAMIC_MODULUS) / (2.0 * steel)


# ----------------------------------------------------------------------------------------------------------------------
# How a ball bearing shares its load among its balls: ISO/TS 16281, with clearance, axial load and tilt.
#
# The inner ring moves against the outer one in five ways: along x and y, along its axis, and it tilts in the planes x-a
# and y-a. A ball at the angle φ from x is squeezed by what that does to the distance of the two groove centres there.
# Displacements are counted from the middle of the clearance, where no ball touches.
# ----------------------------------------------------------------------------------------------------------------------


RING_MODULUS, RING_POISSON = 210e9, 0.3
"""Elastic constants of bearing steel [Pa, -]."""
_SCHEDULES = tuple(
    tuple(first * ratio**step for step in range(count))
    for first, ratio, count in ((10.0, 0.1, 12), (10.0, 0.3, 26), (100.0, 0.4, 36))
)
"""Springs that hold the ring while its place is sought, share of the load per A moved; the next set if one fails."""
_NEWTON_STEPS = 40
"""Newton steps at most for each spring."""
BALANCED = 1e-8
"""Unbalanced load over the load, above which equilibrium is not reached [-]."""


class RingLoad(NamedTuple):
    """What the shaft puts on the inner ring."""

    x: float = 0.0
    """Radial force F_x [N]; the first ball stands at x."""
    y: float = 0.0
    """Radial force F_y [N]."""
    axial: float = 0.0
    """F_a [N]."""
    moment_x: float = 0.0
    """Couple that tilts in the plane of x and the axis [N m]."""
    moment_y: float = 0.0
    """Couple that tilts in the plane of y and the axis [N m]."""


class RingMotion(NamedTuple):
    """Where the inner ring goes, from the middle of the clearance."""

    x: float
    """[m]"""
    y: float
    """[m]"""
    axial: float
    """[m]"""
    tilt_x: float
    """In the plane of x and the axis [rad]."""
    tilt_y: float
    """In the plane of y and the axis [rad]."""

    @property
    def radial(self) -> float:
        """Radial displacement δ_r [m]."""
        return math.hypot(self.x, self.y)

    @property
    def tilt(self) -> float:
        """Misalignment ψ [rad]."""
        return math.hypot(self.tilt_x, self.tilt_y)


class LoadDistribution(NamedTuple):
    """A loaded ball bearing in equilibrium."""

    motion: RingMotion
    """Where the inner ring stands [m, rad]."""
    force: Floats
    """Load of every ball Q_j [N], (Z,)."""
    contact_angle: Floats
    """Contact angle of every ball α_j [rad], (Z,)."""


class _Balls(NamedTuple):
    """A bearing as its equilibrium sees it; lengths in units of A, the distance of the groove centres."""

    angle: Floats
    radial: float
    """A cos α_0 over A: what the clearance leaves of it [-]."""
    tilt_arm: float
    """R_i over A [-]."""
    couple_arm: float
    """D_pw / 2 over A [-]."""
    stiffness: float
    """c_P A^1.5 [N]."""
    distance: float
    """A [m]."""


def load_distribution(geometry: BearingGeometry, load: RingLoad, *, clearance: float) -> LoadDistribution:
    """Return the loads of the balls of a deep groove bearing and the motion of its inner ring.

    Args:
        geometry: Rolling elements and grooves [m].
        load: On the inner ring [N, N m].
        clearance: Radial operating clearance s [m].

    Source: ISO/TS 16281:2008; equilibrium about D_pw/2, tilt about R_i, as the standard has them.

    Valid for: rigid rings, slow turning (no centrifugal load of the balls).

    Raises:
        DesignError: If the clearance is negative or wider than the grooves, or if nothing loads the bearing.
        SolveError: If no equilibrium is found.
    """
    _check(geometry, load, clearance)
    balls = _balls(geometry, clearance)
    wanted = np.array(load) / np.array([1.0, 1.0, 1.0, balls.distance, balls.distance])
    moved = _equilibrium(balls, wanted)
    residual = float(np.abs(_unbalance(moved, balls, wanted)[0]).max())
    if residual > BALANCED:
        message = f"no equilibrium of the bearing under {tuple(map(float, load))} N, N m"
        raise SolveError(f"{message}: {residual:.2g} of the load is left over")
    squeeze, radial, axial = _squeeze(moved, balls)
    lengths = np.array([balls.distance, balls.distance, balls.distance, 1.0, 1.0])
    motion = RingMotion(*(moved * lengths).tolist())
    return LoadDistribution(motion, balls.stiffness * squeeze**1.5, np.arctan2(axial, radial))


def _equilibrium(balls: _Balls, wanted: Floats) -> Floats:
    """Return the motion that balances the load, or the best found.

    Clearance leaves the balls free, so that nothing holds the ring at first. Weak springs to the housing do, and are
    slackened step by step until only the balls are left.
    """
    arms = np.array([1.0, 1.0, 1.0, balls.tilt_arm, balls.tilt_arm])
    motion = np.zeros(5)
    for schedule in _SCHEDULES:
        motion = np.zeros(5)
        for spring in (*schedule, 0.0):
            motion = _settled(motion, balls, wanted, springs=np.diag(spring * arms**2))
        if np.abs(_unbalance(motion, balls, wanted)[0]).max() < BALANCED:
            break
    return motion


def _settled(motion: Floats, balls: _Balls, wanted: Floats, *, springs: Floats) -> Floats:
    """Return a motion after Newton steps, each taken only as far as it lessens what is left over."""
    residual, slope = _unbalance(motion, balls, wanted)
    residual, slope = residual + springs @ motion, slope + springs
    for _ in range(_NEWTON_STEPS):
        if np.linalg.norm(residual) < 1e-3 * BALANCED:
            break
        step = np.linalg.lstsq(slope, -residual)[0]
        for halving in range(14):
            trial = motion + 0.5**halving * step
            new, tangent = _unbalance(trial, balls, wanted)
            new += springs @ trial
            if np.linalg.norm(new) < np.linalg.norm(residual):
                motion, residual, slope = trial, new, tangent + springs
                break
        else:
            break
    return motion


def _check(geometry: BearingGeometry, load: RingLoad, clearance: float) -> None:
    problems = []
    widest = 2.0 * _groove_distance(geometry)
    if not 0.0 <= clearance < widest:
        message = f"{1e6 * clearance:g} µm given; allowed: 0 to {1e6 * widest:.0f} µm (use 0 for a preloaded bearing)"
        problems.append(Problem("clearance", message))
    if not any(load):
        problems.append(Problem("load", "nothing loads the bearing; give a force or a couple"))
    refuse(problems)


def _groove_distance(geometry: BearingGeometry) -> float:
    """Return A = r_i + r_e − D_w."""
    return (geometry.inner_conformity + geometry.outer_conformity - 1.0) * geometry.diameter


def _balls(geometry: BearingGeometry, clearance: float) -> _Balls:
    distance = _groove_distance(geometry)
    radial = 1.0 - clearance / (2.0 * distance)
    stiffness = load_deflection_constant(
        ball_contacts(geometry), elastic_modulus=RING_MODULUS, poisson_ratio=RING_POISSON
    )
    groove = (geometry.inner_conformity - 0.5) * geometry.diameter * radial
    return _Balls(
        angle=2.0 * math.pi * np.arange(geometry.elements) / geometry.elements,
        radial=radial,
        tilt_arm=(geometry.pitch_diameter / 2.0 + groove) / distance,
        couple_arm=geometry.pitch_diameter / 2.0 / distance,
        stiffness=stiffness * distance**1.5,
        distance=distance,
    )


def _squeeze(motion: Floats, balls: _Balls) -> tuple[Floats, Floats, Floats]:
    """Return the approach of every ball and the two legs of its groove centres' distance, all over A."""
    cosine, sine = np.cos(balls.angle), np.sin(balls.angle)
    radial = balls.radial + motion[0] * cosine + motion[1] * sine
    axial = motion[2] + balls.tilt_arm * (np.sin(motion[3]) * cosine + np.sin(motion[4]) * sine)
    return np.maximum(np.hypot(radial, axial) - 1.0, 0.0), radial, axial


def _unbalance(motion: Floats, balls: _Balls, wanted: Floats) -> tuple[Floats, Floats]:
    """Return what the balls bear less the load, over the load, and its derivatives."""
    squeeze, radial, axial = _squeeze(motion, balls)
    length = np.hypot(radial, axial)
    along = np.stack([radial, axial]) / length
    across = np.stack([-along[1], along[0]])
    spring, string = 1.5 * np.sqrt(squeeze), squeeze**1.5 / length
    local = spring * along[:, None] * along + string * across[:, None] * across
    cosine, sine, zeros = np.cos(balls.angle), np.sin(balls.angle), np.zeros(len(balls.angle))
    ones = zeros + 1.0
    round_ring = np.stack([cosine, sine])
    moves = np.array([[*round_ring, zeros, zeros, zeros], [zeros, zeros, ones, *(balls.tilt_arm * round_ring)]])
    bears = np.array([[*round_ring, zeros, zeros, zeros], [zeros, zeros, ones, *(balls.couple_arm * round_ring)]])
    moves[1, 3:] *= np.cos(motion[3:])[:, None]
    size = np.abs(wanted).max() / balls.stiffness
    force = np.einsum("dkj,dj->k", bears, squeeze**1.5 * along) / size - wanted / (size * balls.stiffness)
    return force, np.einsum("dkj,dej,elj->kl", bears, local, moves) / size
