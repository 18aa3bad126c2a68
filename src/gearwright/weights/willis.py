"""Willis's gear volume: what the gears of an arrangement add up to, as a multiple of 2 T / K.

The surface-durability factor K = F_t/(F d) · (m + 1)/m of a mesh (m ≥ 1, the pinion has d) gives the pinion
F d² = (2 T/K)(1 + 1/m). Adding F d² over every gear, each with K alike, leaves a bracket that depends on ratios alone.
The brackets were derived again from this definition; two public implementations agree with them.
"""

from __future__ import annotations

import math

from gearwright.units import INCH, POUND, POUND_FORCE

AIRCRAFT_DENSITY = 0.25 * POUND / INCH**3
"""Mass per Σ F d² of an aircraft gear drive [kg/m³]: 0.25 lb/in³; Willis gives 0.25 to 0.30."""
DEFAULT_K = 600.0 * POUND_FORCE / INCH**2
"""K factor at which drives are compared here [Pa]: 600 psi, an assumption within the span of aircraft gears."""
RING_FACTOR = 0.4
"""Share of a solid disc that a ring gear weighs (Willis 1963)."""


def bracket_double_reduction(first: float, overall: float) -> float:
    """Return Σ F d² K/(2 T) of two pairs in series.

    Args:
        first: Ratio m of the first pair [-].
        overall: Ratio of both M_0 [-].

    Source:
        Willis 1963; derived again: 1 + 1/m + 2m + m² + m²/M_0 + M_0 + M_0²/m.
    """
    m = first
    return 1.0 + 1.0 / m + 2.0 * m + m**2 + m**2 / overall + overall + overall**2 / m


def bracket_double_branch(first: float, overall: float) -> float:
    """Return Σ F d² K/(2 T) of two parallel paths of two pairs each, as in the PW100.

    Args:
        first: Ratio m of the first pairs [-].
        overall: Overall ratio M_0 [-].

    Source:
        Willis 1963; derived again: 1/2 + 1/(2m) + 2m + m² + m²/M_0 + M_0/2 + M_0²/(2m).
    """
    m = first
    return 0.5 + 0.5 / m + 2.0 * m + m**2 + m**2 / overall + 0.5 * overall + 0.5 * overall**2 / m


def bracket_epicyclic(planet: float, ring: float, planets: int) -> float:
    """Return Σ F d² K/(2 T) of a sun, its planets and their ring, with both ratios free.

    Args:
        planet: Planet diameter over sun diameter m_s [-].
        ring: Ring diameter over sun diameter M_r [-].
        planets: Number of planets b [-].

    Source:
        Willis 1963; derived again: 1/b + 1/(b m_s) + m_s + m_s² + 0.4 M_r²/b + 0.4 M_r²/(b m_s). Pulvirenti 2023,
        eq. 1.6, leaves the term 0.4 M_r²/b out.
    """
    rim = RING_FACTOR * ring**2
    return (1.0 + rim) / planets * (1.0 + 1.0 / planet) + planet + planet**2


def bracket_planetary(ratio: float, planets: int) -> float:
    """Return Σ F d² K/(2 T) of a planetary stage with a fixed ring: M_r = GR - 1 and m_s = (GR - 2)/2 by geometry.

    Args:
        ratio: Sun speed over carrier speed GR, above 2 [-].
        planets: Number of planets [-].

    Source:
        Willis 1963, with the planet's diameter from coaxiality.
    """
    return bracket_epicyclic((ratio - 2.0) / 2.0, ratio - 1.0, planets)


def lightest_planet(ring: float, planets: int) -> float:
    """Return the planet-to-sun ratio m_s that would be lightest were it free, 2 m_s³ + m_s² = (0.4 M_r² + 1)/b.

    Coaxial sun, planets and ring fix m_s; the optimum says which ratio suits that geometry.

    Args:
        ring: Ring diameter over sun diameter M_r [-].
        planets: Number of planets b [-].

    Source:
        Willis 1963; Pulvirenti 2023, eq. 1.5, is this for a star.
    """
    from scipy.optimize import brentq

    target = (RING_FACTOR * ring**2 + 1.0) / planets
    return float(brentq(lambda m: 2.0 * m**3 + m**2 - target, 0.0, 1.0 + math.sqrt(target)))


def mass_willis(
    torque: float, bracket: float, *, k_factor: float = DEFAULT_K, density: float = AIRCRAFT_DENSITY
) -> float:
    """Return the mass of a gear drive, a (2 T/K) times its bracket.

    Args:
        torque: Torque of the first pinion or sun T [N m].
        bracket: Of the arrangement [-].
        k_factor: Surface-durability factor K [Pa].
        density: Mass per Σ F d² a [kg/m³].

    Source:
        Willis 1963; in kg 0.2268 T[lb in]/K[psi] for a = 0.25 lb/in³ (Pulvirenti 2023, eq. 1.6).
    """
    return density * 2.0 * torque / k_factor * bracket
