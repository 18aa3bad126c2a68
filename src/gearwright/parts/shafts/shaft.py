"""Shafts under bending and torsion by Tresca: stress, diameter, mass, torsional stiffness; solid or hollow."""

from __future__ import annotations

import math


def shaft_stress(bending_moment: float, torque: float, diameter: float, *, bore: float = 0.0) -> float:
    """Return Tresca's equivalent stress at the surface [Pa].

    Args:
        bending_moment: [N m].
        torque: [N m].
        diameter: Outer diameter [m].
        bore: Inner diameter [m].

    Source: Pulvirenti 2023, eq. (2.47): √(σ_b² + 4 τ²) with σ_b = 32 M/(π d³), τ = 16 T/(π d³).
    """
    section = math.pi * (diameter**4 - bore**4) / (32.0 * diameter)
    return math.hypot(bending_moment, torque) / section


def shaft_diameter(bending_moment: float, torque: float, allowable: float, *, bore_ratio: float = 0.0) -> float:
    """Return the smallest outer diameter that bears bending and torsion [m].

    Args:
        bending_moment: [N m].
        torque: [N m].
        allowable: Allowable stress [Pa].
        bore_ratio: Bore over outer diameter [-].

    Source: Pulvirenti 2023, eq. (2.47) solved for d.

    >>> round(1e3 * shaft_diameter(0.0, 499.43, 785e6 / 2), 2)
    23.49
    """
    load = 32.0 * math.hypot(bending_moment, torque) / (math.pi * allowable * (1.0 - bore_ratio**4))
    return math.cbrt(load)


def shaft_diameter_around(bore: float, bending_moment: float, torque: float, *, allowable: float) -> float:
    """Return the smallest outer diameter around a given bore that bears bending and torsion [m].

    Args:
        bore: Inner diameter [m].
        bending_moment: [N m].
        torque: [N m].
        allowable: Allowable stress [Pa].

    Source: Pulvirenti 2023, eq. (2.47) for a ring: d⁴ − 32 √(M² + T²) d / (π σ) − d_i⁴ = 0, by Newton from above.

    >>> round(1e3 * shaft_diameter_around(15e-3, 0.0, 499.43, allowable=785e6 / 2), 2)
    24.67
    """
    solid = 32.0 * math.hypot(bending_moment, torque) / (math.pi * allowable)
    diameter = math.cbrt(solid) + bore
    for _ in range(50):
        step = (diameter**4 - solid * diameter - bore**4) / (4.0 * diameter**3 - solid) if diameter else 0.0
        diameter -= step
        if step <= 1e-15 * diameter:
            break
    return diameter


def shaft_mass(diameter: float, length: float, density: float, *, bore: float = 0.0) -> float:
    """Return the mass of a shaft of one diameter [kg].

    Args:
        diameter: Outer diameter [m].
        length: [m].
        density: ρ [kg/m³].
        bore: Inner diameter [m].

    Source: cylinder.
    """
    return math.pi / 4.0 * (diameter**2 - bore**2) * length * density


def shaft_inertia(mass: float, diameter: float, *, bore: float = 0.0) -> float:
    """Return the polar inertia of a shaft of one diameter [kg m²].

    Args:
        mass: [kg].
        diameter: Outer diameter [m].
        bore: Inner diameter [m].

    Source: cylinder, m (d_o² + d_i²) / 8.
    """
    return mass * (diameter**2 + bore**2) / 8.0


def torsional_stiffness(diameter: float, length: float, shear_modulus: float, *, bore: float = 0.0) -> float:
    """Return the torsional stiffness of a shaft of one diameter [N m/rad].

    Args:
        diameter: Outer diameter [m].
        length: [m].
        shear_modulus: G [Pa].
        bore: Inner diameter [m].

    Source: Pulvirenti 2023, eq. (3.12): K = π G d⁴ / (32 L).
    """
    return math.pi * shear_modulus * (diameter**4 - bore**4) / (32.0 * length)
