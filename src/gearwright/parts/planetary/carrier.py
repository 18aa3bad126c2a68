"""First sizing of a planet carrier: cantilever pins in bending, a plate that carries the torque."""

from __future__ import annotations

import math

WIDEST_PIN_BORE = 0.8
"""Bore of a pin over its diameter, at most: thinner walls go out of round under rollers or film, an assumption [-]."""


def pin_diameter(force: float, face_width: float, allowable: float) -> float:
    """Return the diameter of a cantilever planet pin [m].

    Args:
        force: Of one planet on its pin: T_c/(N r_c) from the teeth and m r_c ω_c² from the planet, at right angles [N].
        face_width: Planet face width; the force acts at its middle [m].
        allowable: Allowable bending stress [Pa].

    Source: cantilever beam, d³ = 32 M/(π σ) with M = F b/2; Pulvirenti 2023, §2.4 (model), with the force 2 F_t.
    """
    return math.cbrt(32.0 * force * face_width / 2.0 / (math.pi * allowable))


def pin_bore(diameter: float, needed: float) -> float:
    """Return the bore that a pin may have which is thicker than its strength asks [m].

    Args:
        diameter: Of the pin, as its bearing asks [m].
        needed: Of a solid pin that is strong enough [m].

    Source: equal section moduli: 1 − κ⁴ = (d_needed/d)³; at most `WIDEST_PIN_BORE`.
    """
    spare = max(1.0 - (needed / diameter) ** 3, 0.0)
    return diameter * min(math.pow(spare, 0.25), WIDEST_PIN_BORE)


def pin_stress(force: float, face_width: float, diameter: float, *, bore: float = 0.0) -> float:
    """Return the bending stress of a cantilever planet pin at its root [Pa].

    Args:
        force: Of one planet on its pin, at the middle of the face width [N].
        face_width: Planet face width [m].
        diameter: Of the pin [m].
        bore: Of a hollow pin [m].

    Source: cantilever beam, σ = 32 (F b/2) / (π d³), of a hollow one over 1 − κ⁴.
    """
    return 32.0 * force * face_width / 2.0 / (math.pi * diameter**3 * (1.0 - (bore / diameter) ** 4))


def pin_mass(diameter: float, face_width: float, density: float, *, bore: float = 0.0) -> float:
    """Return the mass of one planet pin of the planet's width [kg].

    Args:
        diameter: [m].
        face_width: [m].
        density: ρ [kg/m³].
        bore: Of a hollow pin [m].

    Source: cylinder.
    """
    return math.pi / 4.0 * (diameter**2 - bore**2) * face_width * density


def plate_mass(radius: float, thickness: float, density: float, *, fill: float) -> float:
    """Return the mass of the carrier's plate [kg].

    Args:
        radius: Outer radius, pin circle plus half a pin [m].
        thickness: [m].
        density: ρ [kg/m³].
        fill: Share of the disc that is not cut out [-].

    Source: disc.
    """
    return math.pi * radius**2 * thickness * density * fill


def plate_shear_stress(torque: float, hub_diameter: float, thickness: float) -> float:
    """Return the shear stress in the plate where it meets its shaft [Pa].

    Args:
        torque: Carrier torque T_c [N m].
        hub_diameter: Diameter of the shaft that the plate is one piece with [m].
        thickness: Plate thickness [m].

    Source: torque over the cylinder of the hub, τ = 2 T_c / (π d² t); the carrier's plate bears T_c, which Pulvirenti
        2023, §2.4 leaves out.
    """
    return 2.0 * torque / (math.pi * hub_diameter**2 * thickness)
