"""Planet carriers: pins, plates, bridges between two plates, and how far planets tilt under torque."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from gearwright.base import Floats

# ----------------------------------------------------------------------------------------------------------------------
# First sizing of a planet carrier: cantilever pins in bending, a plate that carries the torque.
# ----------------------------------------------------------------------------------------------------------------------


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


PIN_BORE = 0.6
"""Bore of pins that two plates hold over their diameter [-], an estimate; thicker by 1/∛(1 − κ⁴) they are as strong."""
BRIDGE = 0.5
"""Depth of a carrier's bridge over a planet's diameter [-], an estimate from drawings of two-plate carriers."""
BESIDE = 1e-3
"""Room between a bridge and each planet beside it [m], an assumption."""


def bridge_thickness(force: float, length: float, depth: float, allowable: float) -> float:
    """Return the thickness around the axis that a bridge between two plates needs [m].

    Args:
        force: Around the axis that crosses to the second plate through it, T/(2 N r) [N].
        length: Between both plates [m].
        depth: Away from the axis [m].
        allowable: Bending stress [Pa].

    Source: beam with both ends held that shift by each other, M = F L/2; t = √(6 M/(h σ)).

    >>> round(1e3 * bridge_thickness(10e3, 0.08, 0.06, 400e6), 3)
    10.0
    """
    return math.sqrt(6.0 * force * length / 2.0 / (depth * allowable))


def shared_lever(width: float, thickness: float) -> float:
    """Return the bending moment of a pin that two plates hold, over half of its force [m], as `pin_diameter` takes it.

    Args:
        width: Of the planet, over which the force is spread [m].
        thickness: Of a plate, in whose middle the pin is held [m].

    Source: beam on two supports L = b + t apart under a force spread over b, M = F/4 (L − b/2); between F b/8, of
        plates without thickness, and F L/4, of a force at one place.

    Valid for: a force in the middle between both plates; pins that turn freely in them, which is the larger moment.

    >>> round(shared_lever(0.08, 0.01), 4)
    0.025
    """
    return (width + thickness - width / 2.0) / 2.0


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
        force: Of one planet on its pin; what one plate bears of it: half, where two hold the pin [N].
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


_HUB = 2.16
"""Diameter of a shaft as it is sized by its torque over ∛(T/σ) [-]."""


class Plate(NamedTuple):
    """Of what and how the plates of carriers are made."""

    allowable: float
    """Stress of pins and plate [Pa]."""
    density: float
    """[kg/m³]"""
    ratio: float
    """Thickness over the face width of the planets, at least [-]."""
    fill: float
    """Share of the plate that is not cut out [-]."""
    turns: bool
    """Whether a shaft stands in the plate, 2.16 ∛(T/σ) thick as it is sized."""


def first_carrier_mass(
    loads: Sequence[tuple[float, float]], radius: Floats, face_width: Floats, tips: tuple[Floats, Floats, Floats],
    *, planet: Floats, planets: int, plate: Plate,
) -> Floats:  # fmt: skip
    """Return about what the carriers of arrays of simple sets weigh, to rank them: pins, two plates, bridges [kg].

    Args:
        loads: Torque [N m], K_γ included, and speed [rad/s] of the carrier in every case.
        radius: Of the circle of pins [m].
        face_width: Of the planets [m].
        tips: Radii of the tips of sun, planets and ring [m].
        planet: Mass of one planet [kg].
        planets: Their number [-].
        plate: Of the carrier.

    Source: as `pin_diameter`, with `shared_lever` where planets leave room for bridges, `hole_pressure`,
        `plate_shear_stress`, `eye_wall` and `plate_mass`; bridges as wide as neighbouring planets leave on their chord.
    """
    allowable = plate.allowable
    forces = [np.hypot(torque / (planets * radius), planet * radius * speed**2) for torque, speed in loads]
    sun, own, ring = tips
    chord = np.maximum(2.0 * (radius * math.sin(math.pi / planets) - own), 0.0)
    plates = np.where(chord > 0.0, 2.0, 1.0)
    thinnest = plate.ratio * face_width / plates
    force, lever = np.maximum.reduce(forces), np.where(chord > 0.0, (face_width / 2.0 + thinnest) / 2.0, face_width)
    needed = np.cbrt(16.0 * force * lever / (math.pi * allowable))
    pin, force = needed / np.where(chord > 0.0, math.cbrt(1.0 - PIN_BORE**4), 1.0), force / plates
    hub = 4.0 / (math.pi * _HUB**2) * math.cbrt(max(torque for torque, _ in loads) / allowable) if plate.turns else 0.0
    thinnest = np.maximum(thinnest, force / (pin * allowable))
    thickness = np.maximum(thinnest, hub)
    wall = np.maximum(force / (np.where(chord > 0.0, thinnest, thickness) * allowable), LEAST_EYE * needed)
    discs = math.pi * (radius + pin / 2.0 + wall) ** 2 * (thickness + thinnest) * plate.fill
    middle = radius * math.cos(math.pi / planets)
    outer = np.minimum(middle + BRIDGE * own, np.sqrt(np.maximum(ring**2 - chord**2 / 4.0, 0.0)))
    bridge = chord * np.maximum(outer - np.maximum(middle - BRIDGE * own, sun), 0.0)
    section = np.where(chord > 0.0, 1.0 - PIN_BORE**2, 1.0) * math.pi / 4.0 * pin**2
    posts = planets * face_width * (section + bridge)
    return np.asarray(plate.density * (posts + discs))
