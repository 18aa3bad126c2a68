"""First sizing of a planet carrier: cantilever pins in bending, a plate that carries the torque."""

from __future__ import annotations

import math

WIDEST_PIN_BORE = 0.8
"""Bore of a pin over its diameter, at most: thinner walls go out of round under rollers or film, an assumption [-]."""
LEAST_EYE = 0.25
"""Metal outside the hole of a pin over the diameter that a solid pin needs, at least [-]: an estimate."""


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


def eye_wall(force: float, thickness: float, shear: float, *, needed: float) -> float:
    """Return the metal that a plate needs outside the hole of a pin [m].

    Args:
        force: Of one planet on its pin; one plate bears all of it, as the cantilever has it [N].
        thickness: Of the plate [m].
        shear: Allowable shear stress [Pa].
        needed: Diameter of a solid pin that is strong enough [m].

    Source: equilibrium of a block that a pin tears out of an eye along two planes, F = 2 w t τ; by Tresca both sides of
        the eye in tension, F = 2 w t σ, then bear twice as much. At least `LEAST_EYE` of a solid pin, an estimate.

    Valid for: lugs under a force towards their edge, without the stress concentration at the hole.

    >>> round(1e3 * eye_wall(29428.0, 4.2e-3, 196.25e6, needed=18.58e-3), 2)
    17.85
    """
    return max(force / (2.0 * thickness * shear), LEAST_EYE * needed)


def eye_stress(force: float, thickness: float, wall: float) -> float:
    """Return the shear stress along both planes by which a pin would tear out of its eye [Pa].

    Args:
        force: Of one planet on its pin [N].
        thickness: Of the plate [m].
        wall: Metal outside the hole [m].

    Source: equilibrium, τ = F/(2 w t).
    """
    return force / (2.0 * wall * thickness)


def hole_pressure(force: float, diameter: float, thickness: float) -> float:
    """Return the pressure of a pin in the hole of its plate [Pa].

    Args:
        force: Of one planet on its pin [N].
        diameter: Of the pin [m].
        thickness: Of the plate [m].

    Source: force over the projected area, p = F/(d t).
    """
    return force / (diameter * thickness)


def plate_mass(radius: float, thickness: float, density: float, *, fill: float) -> float:
    """Return the mass of the carrier's plate [kg].

    Args:
        radius: Outer radius, pin circle plus half a pin and the metal outside it [m].
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
