"""How far one tooth gives under load: a cantilever of its true outline, fillet included, on an elastic body."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import Problem, refuse
from gearwright.parts.gears import ToothForm, load_point
from gearwright.parts.material import Material

SHEAR_FACTOR = 1.2
"""Shear coefficient of a rectangular section [-] (Tian 2004)."""
_SECTIONS = 24  # Gauss points along the tooth; 96 change a compliance by less than 1e-4

_BODY = np.array(
    [
        [-5.574e-5, -1.9986e-3, -2.3015e-4, 4.7702e-3, 0.0271, 6.8045],
        [60.111e-5, 28.100e-3, -83.431e-4, -9.9256e-3, 0.1624, 0.9086],
        [-50.952e-5, 185.50e-3, 0.0538e-4, 53.300e-3, 0.2895, 0.9236],
        [-6.2042e-5, 9.0889e-3, -4.0964e-4, 7.8297e-3, -0.1472, 0.6904],
    ]
)
"""Rows L*, M*, P*, Q*; columns A to F (Sainsot, Velex & Duverger 2004, table 1)."""


@dataclass(frozen=True)
class ToothCompliance:
    """Deflection of one tooth per unit normal force and unit length of contact, at given contact points."""

    bending: Floats
    """Bending of the cantilever [m²/N], shape (n,)."""
    shear: Floats
    """Shear [m²/N], shape (n,)."""
    compression: Floats
    """Compression along the tooth's centre line [m²/N], shape (n,)."""
    foundation: Floats
    """Tilt and shift of the tooth's root in the gear body [m²/N], shape (n,)."""

    @property
    def total(self) -> Floats:
        """Sum [m²/N], shape (n,)."""
        return self.bending + self.shear + self.compression + self.foundation


def tooth_compliance(
    form: ToothForm, radius: Floats, *, material: Material, bore_radius: float | None = None
) -> ToothCompliance:
    """Return the compliance of one tooth loaded at given radii.

    Args:
        form: Outline of the tooth.
        radius: Radii of the equivalent spur gear at which the flank is touched [m], shape (n,).
        material: For E and ν; plane stress.
        bore_radius: Radius at which an external gear's body is held [m]; None: the tooth stands on a half plane.

    Source: Yang & Lin 1987 (bending, compression), Tian 2004 (shear); for the foundation see `half_plane_foundation`
        and `held_body_foundation`.
    """
    height, half, angle = load_point(form, radius)
    nodes, weights = np.polynomial.legendre.leggauss(_SECTIONS)
    section = np.outer(height, 0.5 * (1.0 + nodes))
    step = np.outer(height, 0.5 * weights)
    width = 2.0 * np.interp(section, form.height, form.half_thickness)
    cosine, sine = np.cos(angle), np.sin(angle)
    moment = cosine[:, None] * (height[:, None] - section) - (sine * half)[:, None]
    young = material.elastic_modulus
    if bore_radius is None:
        foundation = half_plane_foundation(form, radius, material=material)
    else:
        foundation = held_body_foundation(form, radius, material=material, bore_radius=bore_radius)
    return ToothCompliance(
        bending=np.sum(step * 12.0 * moment**2 / width**3, axis=1) / young,
        shear=SHEAR_FACTOR * cosine**2 * np.sum(step / width, axis=1) / material.shear_modulus,
        compression=sine**2 * np.sum(step / width, axis=1) / young,
        foundation=foundation,
    )


def half_plane_foundation(form: ToothForm, radius: Floats, *, material: Material) -> Floats:
    """Return the compliance of a tooth's root in a half plane: external gears with a thick body, and rings.

    Args:
        form: Outline of the tooth.
        radius: Radii at which the flank is touched [m], shape (n,).
        material: For E and ν; plane stress.

    Returns:
        Deflection along the line of action per unit force and length [m²/N], shape (n,).

    Source: O'Donnell 1960 and 1963 (foundation of a cantilever), as used by Cornell 1981, J. Mech. Des. 103, for narrow
        faces: cos² α/E [5.306 (l/h)² + 2 (1 − ν) l/h + 1.534 (1 + 0.4167 tan² α/(1 + ν))].
    """
    lever, angle = _lever(form, radius)
    ratio, nu = lever / form.root_chord, material.poisson_ratio
    axial = 1.534 * (1.0 + 0.4167 * np.tan(angle) ** 2 / (1.0 + nu))
    terms = 5.306 * ratio**2 + 2.0 * (1.0 - nu) * ratio + axial
    return np.asarray(np.cos(angle) ** 2 / material.elastic_modulus * terms)


def held_body_foundation(form: ToothForm, radius: Floats, *, material: Material, bore_radius: float) -> Floats:
    """Return the compliance of a tooth's root in a disc that is held at its bore, the disc's twist included.

    Args:
        form: Outline of an external tooth.
        radius: Radii at which the flank is touched [m], shape (n,).
        material: For E; plane stress.
        bore_radius: Radius at which the body is held [m].

    Returns:
        Deflection along the line of action per unit force and length [m²/N], shape (n,).

    Source: Sainsot, Velex & Duverger 2004, J. Mech. Des. 126, 748-752, table 1.
    Valid for: 1.4 ≤ r_f/r_bore ≤ 7 and 0.01 ≤ θ_f ≤ 0.12 rad.

    Raises:
        DesignError: outside that range.
    """
    ratio, half_angle = form.root_radius / bore_radius, form.root_half_angle
    problems = _outside_body(ratio, half_angle)
    if form.side < 0:
        problems = [
            Problem("bore_radius", "given for an internal gear; a ring's teeth stand on a half plane, leave it out")
        ]
    refuse(problems)
    terms = np.array([half_angle**-2, ratio**2, ratio / half_angle, 1.0 / half_angle, ratio, 1.0])
    l_star, m_star, p_star, q_star = _BODY @ terms
    lever, angle = _lever(form, radius)
    reach = lever / form.root_chord
    bracket = l_star * reach**2 + m_star * reach + p_star * (1.0 + q_star * np.tan(angle) ** 2)
    return np.asarray(np.cos(angle) ** 2 / material.elastic_modulus * bracket)


def _lever(form: ToothForm, radius: Floats) -> tuple[Floats, Floats]:
    """Height above the root circle where the force crosses the tooth's centre line [m], and the force's angle [rad]."""
    height, half, angle = load_point(form, radius)
    rise = form.side * form.root_radius * (1.0 - math.cos(form.root_half_angle))
    return height - half * np.tan(angle) - rise, angle


def _outside_body(ratio: float, half_angle: float) -> list[Problem]:
    """Problems with the range of the fit."""
    fix = "leave the bore radius out to use the half plane"
    problems = []
    if not 1.4 <= ratio <= 7.0:
        problems.append(
            Problem("bore_radius", f"root to bore radius is {ratio:.3g}; the fit holds from 1.4 to 7, {fix}")
        )
    if not 0.01 <= half_angle <= 0.12:
        message = (
            f"the root's half angle is {half_angle:.3g} rad; the fit holds from 0.01 to 0.12 (z above about 25), {fix}"
        )
        problems.append(Problem("bore_radius", message))
    return problems
