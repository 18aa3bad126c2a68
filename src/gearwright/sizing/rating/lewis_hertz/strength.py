"""Allowables, form factors and widths of the first sizing, and the modules that a torque per tooth asks for."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from gearwright.arrays import Floats
from gearwright.parts import contact_strength
from gearwright.parts.gears import (
    ContactAngles,
    Numbers,
    contact_angles,
    lewis_form_factor,
    module_hertz,
    module_lewis,
    virtual_teeth,
)
from gearwright.sizing.rating.rules import Ask, Rating
from gearwright.sizing.rating.standard_teeth import push_angle
from gearwright.spec import GearRules

SPUR_WIDTH_RATIO = 10.0
"""λ = b/m_n of spur gears where nothing else is said (Pulvirenti 2023 leaves λ open; 10 is usual for aircraft)."""


def width_ratio(rules: GearRules, helix: float) -> float:
    """Return λ = b/m_n [-] of the first sizing: given, or from the overlap ratio, or that of spur gears.

    Args:
        rules: As the design gives them.
        helix: β [rad].

    Source: Pulvirenti 2023, eq. (2.3), which fixes λ = ε_β π / sin β for helical gears.
    """
    if rules.face_width_ratio is not None:
        return rules.face_width_ratio
    return rules.overlap_ratio * math.pi / math.sin(helix) if helix else SPUR_WIDTH_RATIO


def bending_allowable(rating: Rating, *, idler: bool) -> float:
    """Return R_p0.2 over its factor [Pa], of idlers their share of it.

    Args:
        rating: Resolved rules.
        idler: A gear of the mesh is loaded on both flanks.
    """
    whole = (rating.material.yield_strength or 0.0) / rating.rules.bending_safety
    return whole * (rating.rules.idler_factor if idler else 1.0)


def contact_allowable(rating: Rating) -> float:
    """Return 2.5 HB over its factor [Pa].

    Args:
        rating: Resolved rules.
    """
    return contact_strength(rating.material.surface_hardness or 0.0) / rating.rules.contact_safety


def angles_of(rating: Rating) -> ContactAngles:
    """Return the angles of the contact formula.

    Args:
        rating: Resolved rules.
    """
    rules = rating.rules
    return contact_angles(rules.pressure_angle, rating.helix_angle, transverse=rules.contact_angles == "transverse")


def working_angles(rating: Rating, ask: Ask, *, stretch: float) -> ContactAngles:
    """Return the angles of the contact formula at the working pitch circles.

    Args:
        rating: Resolved rules.
        ask: Teeth of both gears.
        stretch: Working pitch diameter over z m_n [-].

    Source: ISO 21771:2007, tan β_w = tan β d_w/d, tan α_wn = tan α_wt cos β_w.
    """
    if rating.shifts.centre is None:
        return angles_of(rating)
    first, second = (int(teeth) for teeth in ask.teeth)
    helix = math.atan(math.tan(rating.helix_angle) * stretch * math.cos(rating.helix_angle))
    angle = math.tan(push_angle(first, second, rating, internal=ask.internal)) * math.cos(helix)
    return contact_angles(math.atan(angle), helix, transverse=rating.rules.contact_angles == "transverse")


def form_factor(teeth: Numbers, rating: Rating) -> Numbers:
    """Return the Lewis form factor at the virtual tooth number [-].

    Args:
        teeth: z [-].
        rating: Resolved rules.
    """
    if not isinstance(teeth, np.ndarray):
        return _form_factor(teeth, rating.helix_angle, rating.rules.pressure_angle)
    return lewis_form_factor(virtual_teeth(teeth, rating.rules.pressure_angle, rating.helix_angle))


@lru_cache(maxsize=4096)
def _form_factor(teeth: float, helix: float, pressure_angle: float) -> float:
    """Return the form factor of one gear; those of a study repeat."""
    return float(lewis_form_factor(virtual_teeth(teeth, pressure_angle, helix)))


def first_modules(ask: Ask, rating: Rating) -> tuple[Floats, Floats]:
    """Return the modules that Lewis's bending and Hertz's contact ask of a mesh [m].

    Args:
        ask: Load and teeth. An internal gear is not the weaker in bending, and its curvature is negative.
        rating: Resolved rules.
    """
    pinion, wheel = ask.teeth
    bending = module_lewis(
        ask.per_tooth,
        form_factor(np.minimum(pinion, wheel), rating),
        ask.width_ratio,
        allowable=bending_allowable(rating, idler=any(ask.idlers)),
        helix_angle=rating.helix_angle,
    )
    contact = module_hertz(
        ask.per_tooth,
        1.0 / pinion - 1.0 / wheel if ask.internal else 1.0 / pinion + 1.0 / wheel,
        ask.width_ratio,
        allowable=contact_allowable(rating),
        elastic_modulus=rating.material.elastic_modulus,
        poisson_ratio=rating.material.poisson_ratio,
        angles=angles_of(rating),
        helix_angle=rating.helix_angle,
    )
    return bending, contact
