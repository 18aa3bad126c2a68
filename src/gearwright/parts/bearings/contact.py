"""Hertz's contact of a ball and its two raceways: how far they approach, and how hard they press.

A ball in a groove touches it over an ellipse. Its axes follow from the sum and the difference of the curvatures alone.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from gearwright.parts.bearings.rolling_bearing import BearingGeometry

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
