"""What part of its power a mesh loses, by the method that is asked for."""

from __future__ import annotations

import math
from enum import Enum
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.parts.losses.mesh import Friction, ToothContact, mesh_friction

SLOWEST, FASTEST = 2.0, 25.0
"""Pitch-line velocities between which ISO/TR 14179-1 gives a friction [m/s]."""
LEAST_INTENSITY, MOST_INTENSITY = 1.4e6, 14e6
"""Load intensities K between which ISO/TR 14179-1 gives a friction [Pa]."""
_LEAST_FRICTION, _MOST_FRICTION = 0.0, 0.2
_FILM_TRACTION = 9.0e7
"""Rolling traction over film thickness and face width [N/m²] (Anderson and Loewenthal, after Crook)."""
_POINTS = 200
"""Points of the path of contact at which the loss is taken [-]."""
_LEAST_VELOCITY = 1e-3
"""Velocity below which a mesh loses as at this one [m/s]."""


class MeshLaw(Enum):
    """Whose loss of a mesh."""

    SCHLENK = "schlenk"
    """Schlenk's friction and Ohlendorf's loss factor: ISO/TR 14179-2:2001."""
    NIEMANN_WINTER = "niemann-winter"
    """Niemann and Winter's friction and Ohlendorf's loss factor."""
    ISO_TR_14179_1 = "iso-tr-14179-1"
    """ISO/TR 14179-1:2001, after AGMA: friction by oil, load intensity and velocity, and a mechanical advantage."""
    ANDERSON_LOEWENTHAL = "anderson-loewenthal"
    """NASA TP-1622: sliding by Benedict and Kelley and rolling traction, along the path of contact."""


class MeshDuty(NamedTuple):
    """What a mesh bears."""

    line_load: float
    """F_bt/b [N/m]."""
    face_width: float
    """b [m]."""
    velocity: float
    """Pitch-line velocity v [m/s]."""


class OilState(NamedTuple):
    """The oil between the teeth, and the teeth themselves."""

    viscosity: float
    """Dynamic viscosity at its temperature η [Pa s]."""
    density: float
    """[kg/m³]"""
    roughness: float
    """Mean arithmetic roughness of both flanks R_a [m]."""
    lubricant_factor: float = 1.0
    """X_L of Schlenk, and of Niemann and Winter [-]: 1 for mineral oils."""


def mesh_loss_part(contact: ToothContact, duty: MeshDuty, oil: OilState, *, law: MeshLaw = MeshLaw.SCHLENK) -> float:
    """Return the part of its power that a mesh loses [-].

    Args:
        contact: Of the pair.
        duty: Load and velocity.
        oil: Between the teeth.
        law: Whose.

    Source: Schlenk, or Niemann and Winter: μ_mz H_V (`mesh_friction`, `tooth_loss_factor`); `iso_tr_14179_1_part`,
        `anderson_loewenthal_part`.
    """
    if law is MeshLaw.ISO_TR_14179_1:
        return iso_tr_14179_1_part(contact, duty, oil)
    if law is MeshLaw.ANDERSON_LOEWENTHAL:
        return anderson_loewenthal_part(contact, duty, oil)
    friction = mesh_friction(
        contact, duty.line_load, duty.velocity,
        viscosity=oil.viscosity, roughness=oil.roughness, law=Friction(law.value),
    )  # fmt: skip
    return friction * oil.lubricant_factor * contact.loss_factor


def load_intensity(contact: ToothContact, line_load: float) -> float:
    """Return the load intensity K of a mesh [Pa].

    Args:
        contact: Of the pair.
        line_load: F_bt/b [N/m].

    Source: ISO/TR 14179-1:2001: 1000 T_1 (z_1 + z_2)/(2 b r_w1² z_2) in N m and mm: F_t/(2 b)
        (1/r_w1 + 1/r_w2).
    """
    return 0.5 * abs(line_load) * math.cos(contact.pressure_angle) * contact.closing


def iso_tr_14179_1_part(contact: ToothContact, duty: MeshDuty, oil: OilState) -> float:
    """Return the part of its power that a mesh loses by ISO/TR 14179-1 [-].

    Args:
        contact: Of the pair.
        duty: Load and velocity.
        oil: Between the teeth.

    Source: ISO/TR 14179-1:2001: f_m cos² β/M, f_m = ν^-0.223 K^-0.40/(3.239 V^0.70) in mm²/s, N/mm² and m/s,
        M = 2 cos α_w (H_s + H_t)/(H_s² + H_t²), H the path before and after the pitch point times 1/r_w1 + 1/r_w2.

    Valid for: V of 2 to 25 m/s and K of 1.4 to 14 N/mm²; outside it is taken at the nearest end.
    """
    velocity = min(max(abs(duty.velocity), SLOWEST), FASTEST)
    intensity = min(max(load_intensity(contact, duty.line_load), LEAST_INTENSITY), MOST_INTENSITY)
    viscosity = oil.viscosity / oil.density * 1e6
    friction = viscosity**-0.223 * (intensity * 1e-6) ** -0.40 / (3.239 * velocity**0.70)
    slides = [abs(length) * contact.closing for length in contact.path]
    advantage = 2.0 * math.cos(contact.pressure_angle) * sum(slides) / sum(slide**2 for slide in slides)
    return float(friction * math.cos(contact.helix) ** 2 / advantage)


def anderson_loewenthal_part(contact: ToothContact, duty: MeshDuty, oil: OilState) -> float:
    """Return the part of its power that a mesh loses by sliding and by rolling [-].

    Args:
        contact: Of the pair.
        duty: Load and velocity.
        oil: Between the teeth.

    Source: Anderson and Loewenthal, NASA TP-1622 (1980): sliding with f = 0.0127 lg(29.66 w/(μ V_S V_T²)) of Benedict
        and Kelley (N/m, mPa s, m/s), rolling traction 9e7 h b with h = 2.051e-7 (V_T μ)^0.67 F^-0.067 ρ^0.464 (mPa s,
        N, m); here at points of the path, pairs in contact sharing the load equally, in place of their means.

    Valid for: spur gears; helical ones as their transverse section. f is held between 0 and 0.2.
    """
    velocity, width = max(abs(duty.velocity), _LEAST_VELOCITY), duty.face_width
    total = abs(duty.line_load) * width
    if total == 0.0:
        return 0.0
    place, pairs = _pairs_in_contact(contact)
    slides, rolls, curvature = _kinematics(contact, place, velocity)
    load = total / pairs
    oil_mpas = oil.viscosity * 1e3
    with np.errstate(divide="ignore"):
        inner = 29.66 * load / width / (oil_mpas * slides * rolls**2)
    friction = np.clip(0.0127 * np.log10(inner), _LEAST_FRICTION, _MOST_FRICTION)
    film = 2.051e-7 * (rolls * oil_mpas) ** 0.67 * load**-0.067 * curvature**0.464
    power = friction * load * slides + _FILM_TRACTION * film * width * rolls
    in_contact = sum(abs(length) for length in contact.path) / contact.base_pitch
    return float(np.mean(power) * in_contact / (total * math.cos(contact.pressure_angle) * velocity))


def _pairs_in_contact(contact: ToothContact) -> tuple[Floats, Floats]:
    """Return places on the path from the pitch point [m] and how many pairs of teeth touch when one is there."""
    approach, recess = contact.path
    place = (np.arange(_POINTS) + 0.5) / _POINTS * (approach + recess) - approach
    reach = math.ceil((approach + recess) / contact.base_pitch)
    shifted = place[:, None] + contact.base_pitch * np.arange(-reach, reach + 1)[None, :]
    return place, np.sum((shifted >= -approach) & (shifted <= recess), axis=1).astype(float)


def _kinematics(contact: ToothContact, place: Floats, velocity: float) -> tuple[Floats, Floats, Floats]:
    """Return sliding and summed rolling velocity [m/s] and reduced radius of curvature [m] at places of the path."""
    first, second = contact.radii
    lean = math.sin(contact.pressure_angle)
    curvatures = first * lean + place, second * lean - place
    slides = velocity * np.abs(place) * contact.closing
    rolls = np.abs(velocity * (curvatures[0] / first + curvatures[1] / second))
    return slides, rolls, np.abs(curvatures[0] * curvatures[1] / (curvatures[0] + curvatures[1]))
