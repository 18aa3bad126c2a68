"""Power lost in a gear mesh: the tooth-loss factor and the mean friction of the teeth."""

from __future__ import annotations

import math
from enum import Enum
from typing import NamedTuple

from gearwright.parts.gears import UNSHIFTED, ToothShift, base_helix_angle, transverse_pressure_angle

_LEAST_ROLLING = 1e-3
"""Sum of the rolling speeds below which the friction formula is held [m/s]; at rest it would grow without bound."""
HIGHEST_FRICTION = 0.2
"""Friction at which the formula is held: boundary lubrication of steel [-]; an assumption."""


class ToothContact(NamedTuple):
    """What friction and loss of a pair of cylindrical gears depend on."""

    loss_factor: float
    """H_V [-]."""
    curvature: float
    """Reduced radius of curvature at the pitch point ρ_redC [m]."""
    pressure_angle: float
    """Working transverse pressure angle α_wt [rad]."""
    base_helix: float
    """β_b [rad]."""
    pinion_diameter: float
    """Reference diameter of the smaller gear d_1 [m]."""
    radii: tuple[float, float] = (math.inf, math.inf)
    """Working pitch radii r_w1 and r_w2, the latter negative for an internal gear [m]."""
    path: tuple[float, float] = (0.0, 0.0)
    """Path of contact before and after the pitch point [m]."""
    base_pitch: float = math.inf
    """Transverse base pitch p_bt [m]."""
    helix: float = 0.0
    """β [rad]."""

    @property
    def closing(self) -> float:
        """How much faster than the pitch line the flanks part for every metre from the pitch point [1/m]."""
        return abs(1.0 / self.radii[0] + 1.0 / self.radii[1])


class Friction(Enum):
    """Whose mean coefficient of friction."""

    SCHLENK = "schlenk"
    """Schlenk 1994, as in ISO/TR 14179-2: R_a^¼."""
    NIEMANN_WINTER = "niemann-winter"
    """Niemann and Winter: roughness against the pinion's size, as DIN 3990-4 has it."""


def tooth_loss_factor(teeth: tuple[float, float], base_helix: float, *, approach: float, recess: float) -> float:
    """Return the tooth-loss factor H_V [-]: the mean of sliding over rolling, weighted with the load.

    Args:
        teeth: z_1 and z_2, the latter negative for an internal gear [-].
        base_helix: β_b [rad].
        approach: Part of the contact ratio before the pitch point ε_2 [-]; negative where the path starts behind it.
        recess: Part after it ε_1 [-]; negative where the path ends before it.

    Source: Ohlendorf (1958), π (1/z_1 + 1/z_2)/cos β_b · (1 - ε_α + ε_1² + ε_2²), which is the integral of the sliding
        for parts of 0 to 1 and ε_α of 1 to 2; the same integral, equal pairs sharing the load equally, elsewhere.

    Valid for: ε_α from 1 on; below, Ohlendorf's formula without a meaning of its own.

    >>> round(tooth_loss_factor((16, 24), 0.0, approach=0.707, recess=0.728), 3)
    0.195
    """
    holds = min(approach, recess) >= 0.0 and max(approach, recess) <= 1.0
    shape = _closed_sliding if holds or approach + recess < 1.0 else _sliding
    return math.pi * abs(1.0 / teeth[0] + 1.0 / teeth[1]) / math.cos(base_helix) * shape(approach, recess)


def ohlendorf_loss_factor(teeth: tuple[float, float], base_helix: float, *, approach: float, recess: float) -> float:
    """Return H_V by Ohlendorf's formula wherever the pitch point lies [-], as commercial reports print it.

    Args:
        teeth: z_1 and z_2, the latter negative for an internal gear [-].
        base_helix: β_b [rad].
        approach: ε_2 [-].
        recess: ε_1 [-].

    Source: `tooth_loss_factor`, which leaves the formula where a part is below 0 or above 1.
    """
    scale = math.pi * abs(1.0 / teeth[0] + 1.0 / teeth[1]) / math.cos(base_helix)
    return scale * _closed_sliding(approach, recess)


def _closed_sliding(approach: float, recess: float) -> float:
    """Ohlendorf's closed form of `_sliding`."""
    return 1.0 - (approach + recess) + approach**2 + recess**2


def _sliding(approach: float, recess: float) -> float:
    """Twice the integral of the distance to the pitch point over the path, each pair bearing its share of the load."""
    pairs = math.floor(approach + recess)
    more = approach + recess - pairs
    crowded = sum(_distance(place - approach, place - approach + more) for place in range(pairs + 1))
    return 2.0 * (_distance(-approach, recess) / pairs - crowded / (pairs * (pairs + 1)))


def _distance(start: float, end: float) -> float:
    """∫ |x| dx."""
    return 0.5 * (end * abs(end) - start * abs(start))


def tip_contact_ratio(teeth: float, tip_radius: float, base_radius: float, working_angle: float) -> float:
    """Return the part of the transverse contact ratio that the tip of one gear adds [-].

    Args:
        teeth: z, negative for an internal gear [-].
        tip_radius: r_a [m].
        base_radius: r_b [m].
        working_angle: α_wt [rad].

    Source: ISO 21771:2007: z/(2π) (tan α_a - tan α_wt).
    """
    reach = math.sqrt(max((tip_radius / base_radius) ** 2 - 1.0, 0.0))
    return teeth / (2.0 * math.pi) * (reach - math.tan(working_angle))


def tooth_contact(
    teeth: tuple[int, int],
    module: float,
    *,
    pressure_angle: float,
    helix_angle: float = 0.0,
    shifts: tuple[ToothShift, ToothShift] = (UNSHIFTED, UNSHIFTED),
    working_angle: float | None = None,
) -> ToothContact:
    """Return the contact of a pair without backlash on its working centre distance.

    Args:
        teeth: z_1 and z_2, the latter negative for an internal gear [-].
        module: m_n [m].
        pressure_angle: α_n [rad].
        helix_angle: β [rad].
        shifts: Of both gears.
        working_angle: α_wt [rad]; None: the reference centre distance.

    Source: ISO 21771:2007, addendum of one module; `tooth_loss_factor`.
    """
    reference = transverse_pressure_angle(pressure_angle, helix_angle)
    angle = reference if working_angle is None else working_angle
    radii = [0.5 * module * z / math.cos(helix_angle) for z in teeth]
    heights = [1.0 + shift.profile_shift + shift.tip_alteration for shift in shifts]
    tips = [radius + module * height for radius, height in zip(radii, heights, strict=True)]
    ratios = [
        tip_contact_ratio(z, abs(tip), abs(radius) * math.cos(reference), angle)
        for z, tip, radius in zip(teeth, tips, radii, strict=True)
    ]
    base = base_helix_angle(pressure_angle, helix_angle)
    stretch = 1.0 if working_angle is None else math.cos(reference) / math.cos(angle)
    curvature = stretch * radii[0] * radii[1] / (radii[0] + radii[1]) * math.sin(angle) / math.cos(base)
    pitch = math.pi * module * math.cos(reference) / math.cos(helix_angle)
    return ToothContact(
        loss_factor=tooth_loss_factor(teeth, base, approach=ratios[1], recess=ratios[0]),
        curvature=curvature,
        pressure_angle=angle,
        base_helix=base,
        pinion_diameter=2.0 * min(abs(radius) for radius in radii),
        radii=(stretch * radii[0], stretch * radii[1]),
        path=(ratios[1] * pitch, ratios[0] * pitch),
        base_pitch=pitch,
        helix=helix_angle,
    )


def mesh_friction(
    contact: ToothContact,
    line_load: float,
    velocity: float,
    *,
    viscosity: float,
    roughness: float,
    law: Friction = Friction.SCHLENK,
) -> float:
    """Return the mean coefficient of friction of a mesh μ_mz [-].

    Args:
        contact: Of the pair.
        line_load: F_bt/b [N/m], with the application factor and that of load sharing where they are known.
        velocity: Pitch-line velocity v [m/s].
        viscosity: Dynamic viscosity of the oil at its temperature η [Pa s].
        roughness: Mean arithmetic roughness of both flanks R_a [m].
        law: Whose.

    Source: Schlenk (1994): 0.048 (F_bt/b/(v_ΣC ρ_redC))^0.2 η^-0.05 R_a^0.25 with N/mm, m/s, mm, mPa s, µm, and
        v_ΣC = 2 v sin α_wt; a mineral oil without factor X_L. Niemann and Winter (2003): 0.045, and 3.8 (R_a/d_1)^0.25
        in place of R_a^0.25, with d_1 in mm. Both held at 0.2.
    """
    rolling = max(2.0 * abs(velocity) * math.sin(contact.pressure_angle), _LEAST_ROLLING)
    loading = abs(line_load) * 1e-3 / (rolling * contact.curvature * 1e3)
    oil, surface = math.pow(viscosity * 1e3, -0.05), math.pow(roughness * 1e6, 0.25)
    if law is Friction.SCHLENK:
        return min(0.048 * math.pow(loading, 0.2) * oil * surface, HIGHEST_FRICTION)
    size = 3.8 * math.pow(contact.pinion_diameter * 1e3, -0.25)
    return min(0.045 * math.pow(loading, 0.2) * oil * size * surface, HIGHEST_FRICTION)


def mesh_efficiency(contact: ToothContact, friction: float) -> float:
    """Return the efficiency of a mesh: power out of its teeth over power into them, relative to the carrier [-].

    Args:
        contact: Of the pair.
        friction: μ_mz [-].

    Source: P_VZP = P μ_mz H_V; ISO/TR 14179-2:2001.
    """
    return 1.0 - friction * contact.loss_factor
