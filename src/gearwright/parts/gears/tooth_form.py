"""The outline of one tooth in its normal section: involute flank and root fillet, ready to be bent.

A tooth stands on the chord that joins its two fillets where they meet the root circle. Heights are counted from that
chord along the tooth's centre line, towards its tip for external and internal teeth alike.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem
from gearwright.parts.gears.cylindrical_gear import CylindricalGear
from gearwright.parts.gears.involute import involute, least_profile_shift, virtual_teeth

_POINTS = 400  # of the outline, half on the fillet: bending compliance to 1e-4 against 1600 points


@dataclass(frozen=True)
class ToothForm:
    """Half of a symmetric tooth of the equivalent spur gear."""

    side: int
    """+1 for external teeth, −1 for internal ones [-]."""
    base_radius: float
    """Base radius of the equivalent spur gear [m]."""
    root_radius: float
    """Its root radius [m]."""
    base_half_angle: float
    """Half angle of the tooth at the base circle, ψ_b [rad] (extrapolated for internal teeth)."""
    root_half_angle: float
    """Half angle where the fillet meets the root circle, θ_f [rad]."""
    height: Floats
    """Heights of the outline above the root chord [m], shape (n,), increasing."""
    half_thickness: Floats
    """Half thickness of the tooth at these heights [m], shape (n,)."""

    @property
    def root_chord(self) -> float:
        """Thickness of the tooth at its root chord S_f [m]."""
        return 2.0 * self.root_radius * math.sin(self.root_half_angle)


def tooth_form(gear: CylindricalGear) -> ToothForm:
    """Return the outline of a gear's tooth in the normal section.

    Args:
        gear: External, cut by its basic rack; or internal, with a circular fillet of the rack's fillet radius.

    Returns:
        The form of the equivalent spur gear, z_n teeth of module m_n.

    Source: rack-generated fillet as ISO 6336-3:2006, clause 6; circle between flank and root circle
        for internal teeth.

    Raises:
        DesignError: when the root space has no room for the fillet.
    """
    teeth = virtual_teeth(abs(gear.teeth), gear.rack.pressure_angle, gear.helix_angle)
    return _external(gear, teeth) if gear.side > 0 else _internal(gear, teeth)


def load_point(form: ToothForm, radius: Floats) -> tuple[Floats, Floats, Floats]:
    """Return where and how a normal force acts on the tooth when it touches at given radii.

    Args:
        form: The tooth.
        radius: Radii of the equivalent spur gear at which the flank is touched [m], shape (n,).

    Returns:
        Height above the root chord [m], half thickness there [m], and the angle between force and root chord [rad].

    Source: Weber & Banaschek 1953, geometry of the loaded tooth; α_y − ψ_y for external, α_y + ψ_y for internal teeth.
    """
    pressure = np.arccos(np.minimum(1.0, form.base_radius / radius))
    half_angle = form.base_half_angle - form.side * (np.tan(pressure) - pressure)
    height = form.side * (radius * np.cos(half_angle) - form.root_radius * math.cos(form.root_half_angle))
    return height, radius * np.sin(half_angle), pressure - form.side * half_angle


def _external(gear: CylindricalGear, teeth: float) -> ToothForm:
    """Tooth cut by a rack: trochoid of the rack's rounded tip, then involute."""
    pitch = 0.5 * teeth * gear.module
    base, base_half = _base(gear, teeth)
    radius, half_angle = _trochoid(gear, teeth)
    if gear.profile_shift < least_profile_shift(
        teeth, gear.rack.straight_dedendum, pressure_angle=gear.rack.pressure_angle, helix_angle=0.0
    ):
        # Undercut: the trochoid is the flank only as far as it leaves less tooth than the involute does.
        kept = (radius < base) | (half_angle < base_half - _involutes(base / np.maximum(radius, base)))
        radius, half_angle = radius[kept], half_angle[kept]
    flank = np.linspace(radius[-1], pitch + (gear.tip_radius - gear.pitch_radius), _POINTS // 2)[1:]
    return _form(
        1,
        base,
        base_half,
        radius=np.concatenate((radius, flank)),
        half_angle=np.concatenate((half_angle, base_half - _involutes(base / flank))),
    )


def _trochoid(gear: CylindricalGear, teeth: float) -> tuple[Floats, Floats]:
    """Radii [m] and half angles [rad] of the fillet that the rack's rounded tip envelops, from the root upwards."""
    rack, pitch = gear.rack, 0.5 * teeth * gear.module
    tangent, sine = math.tan(rack.pressure_angle), math.sin(rack.pressure_angle)
    # Half width of the flat at the rack's tip: its corners have their centres there.
    flat = math.pi / 4.0 - rack.dedendum * tangent - rack.fillet_radius * (1.0 - sine) / math.cos(rack.pressure_angle)
    if flat < 0.0:
        message = (
            f"{rack.fillet_radius:.4g} modules given; the rack's tip is {-2.0 * flat:.3g} modules too narrow for it"
        )
        raise DesignError([Problem("rack.fillet_radius", message)])
    depth = (rack.dedendum - rack.fillet_radius - gear.profile_shift) * gear.module
    normal = np.linspace(0.5 * math.pi, rack.pressure_angle, _POINTS // 2)
    roll = (depth / np.tan(normal) - flat * gear.module) / pitch
    reach = depth / np.sin(normal) + rack.fillet_radius * gear.module
    x, y = reach * np.cos(normal), pitch - reach * np.sin(normal)
    # The gear turns by `roll` while the rack moves; angles are counted from the middle of the tooth space.
    return np.hypot(x, y), math.pi / teeth - (np.arctan2(x, y) - roll)


def _internal(gear: CylindricalGear, teeth: float) -> ToothForm:
    """Tooth of a ring: involute, then a circle that touches the flank and the root circle."""
    pitch = 0.5 * teeth * gear.module
    base, base_half = _base(gear, teeth)
    root = pitch + (gear.rack.dedendum - gear.profile_shift) * gear.module
    tip = pitch - (gear.pitch_radius - gear.tip_radius)
    fillet = gear.rack.fillet_radius * gear.module
    if root - fillet <= base:
        raise DesignError([Problem("profile_shift", "the ring's root lies inside its base circle; shift less")])
    # The circle's centre lies on the flank's normal, which is a tangent of the base circle.
    centre = math.sqrt((root - fillet) ** 2 - base**2)
    foot = base_half + (centre + fillet) / base
    centre_half = foot - math.atan(centre / base)
    if centre_half > math.pi / teeth:
        message = f"{gear.rack.fillet_radius:.4g} modules given; the ring's root space is too narrow for it"
        raise DesignError([Problem("rack.fillet_radius", message)])
    # The arc is followed from its highest point in the tooth's own frame, where the root chord touches it.
    turn = np.linspace(0.0, foot - 0.5 * math.pi, _POINTS // 2)
    x = (root - fillet) * math.sin(centre_half) + fillet * np.sin(turn)
    y = (root - fillet) * math.cos(centre_half) + fillet * np.cos(turn)
    flank = np.linspace(math.hypot(base, centre + fillet), max(tip, base), _POINTS // 2)[1:]
    return _form(
        -1,
        base,
        base_half,
        radius=np.concatenate((np.hypot(x, y), flank)),
        half_angle=np.concatenate((np.arctan2(x, y), base_half + _involutes(base / flank))),
    )


def _form(side: int, base: float, base_half: float, *, radius: Floats, half_angle: Floats) -> ToothForm:
    """Turn polar points, from the root circle to the tip, into the record."""
    if half_angle[-1] <= 0.0:
        raise DesignError(
            [Problem("profile_shift", "the tooth is pointed below its tip circle; shorten it or shift less")]
        )
    upright = radius * np.cos(half_angle)
    if np.any(half_angle <= 0.0) or np.any(side * np.diff(upright) <= 0.0):
        raise DesignError(
            [Problem("profile_shift", "the rack undercuts the tooth away; shift more or take more teeth")]
        )
    return ToothForm(
        side=side,
        base_radius=base,
        root_radius=float(radius[0]),
        base_half_angle=base_half,
        root_half_angle=float(half_angle[0]),
        height=side * (upright - upright[0]),
        half_thickness=radius * np.sin(half_angle),
    )


def _base(gear: CylindricalGear, teeth: float) -> tuple[float, float]:
    """Base radius of the equivalent spur gear [m] and half angle of its tooth there [rad]."""
    angle = gear.rack.pressure_angle
    at_pitch = (math.pi + 4.0 * gear.profile_shift * math.tan(angle)) / (2.0 * teeth)
    return 0.5 * teeth * gear.module * math.cos(angle), at_pitch + gear.side * involute(angle)


def _involutes(cosine: Floats) -> Floats:
    """Involute function of the angles with given cosines, elementwise."""
    angle = np.arccos(np.minimum(1.0, cosine))
    return np.asarray(np.tan(angle) - angle)
