"""Mass and inertia of gear bodies: discs and rings, to the circle that is the pitch circle without profile shift."""

from __future__ import annotations

import math


def disc_mass(diameter: float, width: float, density: float) -> float:
    """Return the mass of a solid disc [kg].

    Args:
        diameter: Outer diameter; of a gear that of its mean circle, d + 2 x m_n [m].
        width: Face width [m].
        density: ρ [kg/m³].

    Source: Pulvirenti 2023, eq. (3.3), π r² b ρ; its eq. (2.18) lacks the width and mixes radius and diameter.

    >>> round(disc_mass(0.2, 0.05, 7850.0), 3)
    12.331
    """
    return math.pi / 4.0 * diameter**2 * width * density


def disc_inertia(mass: float, diameter: float) -> float:
    """Return the polar inertia of a solid disc [kg m²].

    Args:
        mass: [kg].
        diameter: [m].

    Source: m d²/8; Pulvirenti 2023, eq. (3.6) (its appendix prints m d²/2 for the turbine).
    """
    return mass * diameter**2 / 8.0


def ring_mass(inner_diameter: float, wall: float, width: float, *, density: float) -> float:
    """Return the mass of a ring gear's body, from its pitch circle outwards [kg].

    Args:
        inner_diameter: Of its mean circle, d − 2 x m_n [m].
        wall: Radial thickness outside of it [m].
        width: Face width [m].
        density: ρ [kg/m³].

    Source: annulus; a wall of 3.95 m is the tooth's dedendum and AGMA 2001's backup ratio of 1.2.
    """
    inner = inner_diameter / 2.0
    return math.pi * ((inner + wall) ** 2 - inner**2) * width * density


def ring_inertia(mass: float, inner_diameter: float, wall: float) -> float:
    """Return the polar inertia of a ring [kg m²].

    Args:
        mass: [kg].
        inner_diameter: [m].
        wall: Radial thickness [m].

    Source: annulus, m (r_i² + r_o²) / 2.
    """
    inner = inner_diameter / 2.0
    return mass * (inner**2 + (inner + wall) ** 2) / 2.0
