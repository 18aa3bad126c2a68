"""Inertia estimates of the rotors at the ends of a train, for designs that do not give them."""

from __future__ import annotations

import math

RIM_SPEED = 350.0
"""Rim speed that sets a power turbine's diameter where none is given [m/s]; an assumption."""
DISC_THICKNESS_RATIO = 0.05
DISC_DENSITY = 8200.0
"""Nickel alloy [kg/m³]."""
BLADE_CHORD_RATIO = 0.08
"""Mean chord over propeller diameter, as of an activity factor near 110."""
BLADE_THICKNESS_RATIO = 0.06
BLADE_FILL = 0.7
"""Section area over chord times thickness."""
BLADE_DENSITY = 1500.0
"""Mean density of a composite blade [kg/m³]."""


def turbine_diameter(speed: float) -> float:
    """Return the disc diameter of a power turbine [m].

    Args:
        speed: Rated speed [rad/s].

    Source: rim speed of 350 m/s; an estimate.
    """
    return 2.0 * RIM_SPEED / speed


def turbine_inertia(diameter: float) -> float:
    """Return the polar inertia of a power turbine's disc [kg m²].

    Args:
        diameter: Disc diameter [m].

    Source: solid nickel disc, thickness 5 % of the diameter, m d²/8 (Pulvirenti 2023, appendix, prints 0.5 m d²).
    """
    mass = math.pi / 4.0 * diameter**2 * DISC_THICKNESS_RATIO * diameter * DISC_DENSITY
    return mass * diameter**2 / 8.0


def propeller_inertia(diameter: float, blades: int) -> float:
    """Return the polar inertia of a propeller [kg m²].

    Args:
        diameter: [m].
        blades: Number of blades [-].

    Source: uniform composite bars, B m R²/3; an estimate (12 kg a blade at 3.93 m).

    >>> round(propeller_inertia(3.93, 6), 1)  # 6 · 12.24 kg · (1.965 m)² / 3
    94.5
    """
    section = BLADE_FILL * BLADE_CHORD_RATIO * BLADE_THICKNESS_RATIO * BLADE_CHORD_RATIO * diameter**2
    blade = section * diameter / 2.0 * BLADE_DENSITY
    return blades * blade * (diameter / 2.0) ** 2 / 3.0
