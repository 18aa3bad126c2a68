"""Generated tooth form: involute flank and root fillet in both sections, and teeth and body of face gears."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from gearwright.base import DesignError, Floats, Ints, Problem
from gearwright.parts.gears.cylindrical_gear import (
    BasicRack,
    CylindricalGear,
    involute,
    least_profile_shift,
    transverse_pressure_angle,
    virtual_teeth,
)

# ----------------------------------------------------------------------------------------------------------------------
# The outline of one tooth in its normal section: involute flank and root fillet, ready to be bent.
#
# A tooth stands on the chord that joins its two fillets where they meet the root circle. Heights are counted from that
# chord along the tooth's centre line, towards its tip for external and internal teeth alike.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# The outline of one tooth in its transverse section, as its tool leaves it: involute flank and the envelope of a tip.
#
# External teeth are cut by their basic rack, whose rounded tip is an ellipse in the transverse section of a helical
# gear; internal ones by a shaper cutter that rolls inside them. Tooth numbers need not be whole, as those of virtual
# gears.
# ----------------------------------------------------------------------------------------------------------------------


_FINE = 64
"""Points from which the wanted ones are chosen, on the fillet and on the flank [-]."""
SHAPER_SHARE, LEAST_SHAPER, LEAST_GAP = 0.5, 5, 8
"""Teeth of the shaper over those of its ring; its least number, and how many fewer than the ring's it has at least [-]:
an assumption, within what makers of cutters list."""


class TransverseTooth(NamedTuple):
    """What the outline of a tooth follows from."""

    teeth: float
    """z, positive; of a virtual gear not whole [-]."""
    module: float
    """Normal module m_n [m]."""
    helix_angle: float = 0.0
    """β [rad]."""
    profile_shift: float = 0.0
    """x; positive where it thickens the tooth [-]."""
    tip_alteration: float = 0.0
    """k [-]."""
    rack: BasicRack = BasicRack()
    side: int = 1
    """+1 external, −1 internal [-]."""
    shaper: float = 0.0
    """Teeth of the shaper that cuts an internal gear; 0: half as many as it has itself [-]."""

    @property
    def pitch_radius(self) -> float:
        """r [m]."""
        return 0.5 * self.teeth * self.module / math.cos(self.helix_angle)

    @property
    def pressure_angle(self) -> float:
        """α_t [rad]."""
        return transverse_pressure_angle(self.rack.pressure_angle, self.helix_angle)

    @property
    def base_radius(self) -> float:
        """r_b [m]."""
        return self.pitch_radius * math.cos(self.pressure_angle)

    @property
    def tip_radius(self) -> float:
        """r_a [m]."""
        return self.pitch_radius + self.side * (self.rack.addendum + self.profile_shift + self.tip_alteration) * (
            self.module
        )

    @property
    def root_radius(self) -> float:
        """r_f [m]."""
        return self.pitch_radius - self.side * (self.rack.dedendum - self.profile_shift) * self.module

    def half_angles(self, radius: Floats) -> Floats:
        """Return half the angle that a tooth takes between its involutes at radii [rad].

        Args:
            radius: At least the base radius [m], any shape.

        Source: ISO 21771:2007, ψ = (π + 4 x tan α_n)/(2 z) ± (inv α_t − inv α_y).
        """
        angle = np.arccos(np.minimum(1.0, self.base_radius / radius))
        at_pitch = (math.pi + 4.0 * self.profile_shift * math.tan(self.rack.pressure_angle)) / (2.0 * self.teeth)
        return np.asarray(at_pitch + self.side * (involute(self.pressure_angle) - (np.tan(angle) - angle)))


def transverse_form(tooth: TransverseTooth, *, fillet: int, flank: int) -> tuple[Floats, Floats]:
    """Return radii and half angles of one side of a tooth, from its root to its tip.

    Args:
        tooth: The tooth.
        fillet: Points on the fillet, the root's end among them [-].
        flank: Points on the involute, the tip's end among them [-].

    Returns:
        Radii [m] and half angles [rad], shape (fillet + flank,); fewer where the fillet is short.

    Source: law of gearing: the normal of the envelope runs through the pole (Litvin and Fuentes 2004, chapter 6).

    Raises:
        DesignError: A tip that is pointed below its circle, or a rack's tip that is too narrow for its rounding.
    """
    radius, angle = _cut_by_rack(tooth) if tooth.side > 0 else _cut_by_shaper(tooth)
    flanks = np.linspace(radius[-1], tooth.tip_radius, _FINE)
    half = tooth.half_angles(flanks)
    if half[-1] <= 0.0:
        raise DesignError(
            [Problem("profile_shift", "the tooth is pointed below its tip circle; shorten or shift less")]
        )
    low = np.unique(_spread(radius, angle, fillet))
    high = np.linspace(0, _FINE - 1, flank + 1).round().astype(int)[1:]
    return np.concatenate((radius[low], flanks[high])), np.concatenate((angle[low], half[high]))


@lru_cache(maxsize=1024)
def outline_area(tooth: TransverseTooth) -> float:
    """Return the area of one tooth between its root and tip circles, with the fillets that its tool leaves [m²].

    Args:
        tooth: The tooth.

    Source: area of a profile, A = ∫ 2 ψ(r) r dr = ∫ ψ d(r²), by trapezia over the points of `transverse_form`.

    >>> tooth = TransverseTooth(10_000, 1e-3)  # nearly a rack: thicker below the pitch line, where there is more of it
    >>> corner = math.radians(35.0)
    >>> rack = 2.25 * math.pi / 2.0 + (1.25**2 - 1.0) * math.tan(math.radians(20.0))
    >>> expected = rack + 2.0 * 0.38**2 * (math.tan(corner) - corner)
    >>> round(1e6 * outline_area(tooth) / expected, 3)
    1.0
    """
    radius, half = transverse_form(tooth, fillet=_FINE, flank=_FINE)
    return abs(float(np.sum(0.5 * (half[1:] + half[:-1]) * np.diff(radius**2))))


def form_radius(tooth: TransverseTooth) -> float:
    """Return where the involute of a tooth begins, beside the fillet that its tool leaves [m].

    Args:
        tooth: The tooth.

    Source: as `transverse_form`.
    """
    return float((_cut_by_rack(tooth) if tooth.side > 0 else _cut_by_shaper(tooth))[0][-1])


def widest_rounding(rack: BasicRack) -> float:
    """Return the fillet radius at which the tip of a rack is fully rounded [-].

    Args:
        rack: The rack.

    Source: half its space at the tip, π/4 − h_f tan α, holds ρ (1 − sin α)/cos α (ISO 53:1998, figure 1).

    >>> round(widest_rounding(BasicRack()), 3)  # of 20° and 1.25: 0.472 modules, ISO 53:1998, 4.6
    0.472
    """
    half = math.pi / 4.0 - rack.dedendum * math.tan(rack.pressure_angle)
    return half * math.cos(rack.pressure_angle) / (1.0 - math.sin(rack.pressure_angle))


def _spread(radius: Floats, angle: Floats, points: int) -> Ints:
    """Return which points of a curve stand evenly along it."""
    along = np.cumsum(np.hypot(np.diff(radius), radius[1:] * np.diff(angle)))
    along = np.concatenate(([0.0], along))
    places = np.linspace(0.0, along[-1], points) - 1e-15
    return np.asarray(np.searchsorted(along, places).clip(0, len(radius) - 1))


def _cut_by_rack(tooth: TransverseTooth) -> tuple[Floats, Floats]:
    """Return the fillet that the rack's tip leaves; of undercut teeth as far as it leaves less than the involute."""
    rack, module, slope = tooth.rack, tooth.module, math.cos(tooth.helix_angle)
    sine = math.sin(rack.pressure_angle)
    flat = math.pi / 4.0 - rack.dedendum * math.tan(rack.pressure_angle)
    flat -= rack.fillet_radius * (1.0 - sine) / math.cos(rack.pressure_angle)
    if flat < 0.0:
        raise DesignError([Problem("rack.fillet_radius", f"the rack's tip is {-2.0 * flat:.3g} modules too narrow")])
    normal = np.linspace(0.5 * math.pi, rack.pressure_angle, _FINE)
    # Of the tip's rounding, in the normal section: beside the middle of the space, and below the pitch line.
    beside = (flat + rack.fillet_radius * np.cos(normal)) * module / slope
    below = (rack.dedendum - tooth.profile_shift - rack.fillet_radius * (1.0 - np.sin(normal))) * module
    reach = (
        below * np.cos(normal) * slope / np.sin(normal)
    )  # where the normal meets the pole, n_t = (cos θ, sin θ/cos β)
    x, y = reach, tooth.pitch_radius - below
    roll = (reach - beside) / tooth.pitch_radius
    radius, angle = np.hypot(x, y), math.pi / tooth.teeth - (np.arctan2(x, y) - roll)
    if below[-1] > tooth.pitch_radius * math.sin(tooth.pressure_angle) ** 2:  # undercut
        kept = (radius < tooth.base_radius) | (angle < tooth.half_angles(np.maximum(radius, tooth.base_radius)))
        radius, angle = radius[kept], angle[kept]
    return radius, angle


def _cut_by_shaper(tooth: TransverseTooth) -> tuple[Floats, Floats]:
    """Return the fillet that a shaper's rounded tip leaves in a ring, whose root circle its tip reaches."""
    teeth = tooth.shaper or SHAPER_SHARE * tooth.teeth
    teeth = max(min(teeth, tooth.teeth - LEAST_GAP), LEAST_SHAPER)
    rack, module = tooth.rack, tooth.module
    cutter = TransverseTooth(teeth, module, tooth.helix_angle, rack=rack)
    distance = tooth.pitch_radius - cutter.pitch_radius  # the ring's shift is the cutter's: no play between them
    cutter = cutter._replace(profile_shift=-tooth.profile_shift)
    reach, rounding = tooth.root_radius - distance, rack.fillet_radius * module
    rounding, middle = _rounding(cutter, reach, rounding)
    ratio = cutter.teeth / tooth.teeth
    # Centre of the rounding at its place in the cutter, turned; the envelope lies beyond it on the line from the pole.
    turn = np.linspace(0.0, math.pi / 3.0, 8 * _FINE)
    centre = distance + (reach - rounding) * np.exp(1j * turn)
    away = centre - tooth.pitch_radius
    touch = centre + rounding * away / np.abs(away)
    angle = np.angle(touch) - ratio * (turn - middle)  # in the ring, from the middle of the space
    radius, half = np.abs(touch), math.pi / tooth.teeth - angle
    whole = radius > max(tooth.base_radius, tooth.tip_radius)
    radius, half = radius[whole], half[whole]
    last = int(np.argmin((half - tooth.half_angles(radius)) * radius))  # where the envelope touches the flank
    return radius[: last + 1], half[: last + 1]


def _rounding(cutter: TransverseTooth, reach: float, rounding: float) -> tuple[float, float]:
    """Return the radius of a cutter's tip rounding and the angle of its centre from the middle of the tooth.

    The rounding touches tip circle and flank; where the tip is too narrow, both roundings of a tooth are one.
    """
    for _ in range(12):
        centre = reach - rounding
        along = math.sqrt(max(centre**2 - cutter.base_radius**2, 0.0))
        # The flank's normal through the centre is a tangent of the base circle: the flank lies `rounding` further on.
        foot = (along + rounding) / cutter.base_radius
        at_base = float(cutter.half_angles(np.asarray(cutter.base_radius)))
        middle = at_base - (foot - math.atan2(along, cutter.base_radius))
        if middle >= 0.0:
            return rounding, middle
        rounding *= 0.8
    return rounding, max(middle, 0.0)


# ----------------------------------------------------------------------------------------------------------------------
# The wheel of a face gear: teeth as racks in cylinders about its axis, and the body behind them.
#
# It stands with its axis along z, away from its pinion: the pitch plane at z = 0, tips towards −z. In every cylinder
# about its axis its teeth are those of the rack that the unrolled pinion meshes with there; the curvature of the
# wheel's motion within the width of a tooth is left out.
# ----------------------------------------------------------------------------------------------------------------------


RIM = 1.2
"""Metal behind the roots over the depth of the teeth [-] (AGMA 2001-D04, backup ratio without loss of strength)."""
HUB = 1.25
"""Hub over bore [-], an assumption."""
NEXT = 0.98
"""Hub over the radius inside the rim, at most [-]."""
_STRIPS = 65
"""Cylinders in which teeth are weighed [-]."""


def face_reach(pinion: TransverseTooth, teeth: int, width: float) -> tuple[float, float]:
    """Return the radii between which teeth of a face gear are whole [m].

    Args:
        pinion: A spur gear.
        teeth: Of the wheel [-].
        width: Of its face about the pitch circle [m].

    Source: Litvin and Fuentes 2004, chapter 18: inside R_b = r_b z_2/z_1 the shaper undercuts, outside teeth are
        pointed where their tops meet.
    """
    ratio, pitch = teeth / pinion.teeth, pinion.pitch_radius * teeth / pinion.teeth
    inner = max(pitch - width / 2.0, 1.002 * pinion.base_radius * ratio)
    return inner, min(pitch + width / 2.0, pointed_radius(pinion, teeth))


def face_way(pinion: TransverseTooth, teeth: int, *, width: float, bore: float) -> list[tuple[float, float]]:
    """Return the way behind the teeth of a face gear from its outside to its inside, z and radius [m].

    Args:
        pinion: A spur gear.
        teeth: Of the wheel [-].
        width: Of its face about the pitch circle [m].
        bore: Radius of what it sits on [m].

    Source: rim 1.2 times the depth of the teeth behind the roots (AGMA 2001-D04).
    """
    inner, outer = face_reach(pinion, teeth, width)
    root = pinion.rack.dedendum * pinion.module
    rim = RIM * (root + pinion.rack.addendum * pinion.module)
    return way_behind((root + 0.4 * rim, inner), (root + rim, outer), bore, web=0.6 * rim)


def face_crown(pinion: TransverseTooth, teeth: int, width: float) -> float:
    """Return the volume of the teeth of a face gear, from their roots to their tips [m³].

    Args:
        pinion: A spur gear.
        teeth: Of the wheel [-].
        width: Of its face about the pitch circle [m].

    Source: trapezia in cylinders about the axis, summed over their radii.
    """
    radii = np.linspace(*face_reach(pinion, teeth, width), _STRIPS)
    depth = (pinion.rack.addendum + pinion.rack.dedendum) * pinion.module
    areas = np.array([depth * sum(face_thickness(pinion, teeth, float(radius))) for radius in radii])
    return teeth * float(np.sum(0.5 * (areas[1:] + areas[:-1]) * np.diff(radii)))


def pointed_radius(pinion: TransverseTooth, teeth: int) -> float:
    """Return where the teeth of a face gear become pointed, a tenth of a module of top left [m].

    Args:
        pinion: A spur gear.
        teeth: Of the wheel [-].

    Source: as `face_reach`.
    """
    pitch = pinion.pitch_radius * teeth / pinion.teeth
    radii = np.linspace(pinion.base_radius * teeth / pinion.teeth * 1.001, 1.5 * pitch, 400)
    top = np.array([face_thickness(pinion, teeth, float(radius))[0] for radius in radii])
    return float(radii[np.nonzero(top > 0.05 * pinion.module)[0].max()])


def face_thickness(pinion: TransverseTooth, teeth: int, radius: float) -> tuple[float, float]:
    """Return half the thickness of a face gear's tooth at its top and at its root [m].

    Args:
        pinion: A spur gear.
        teeth: Of the wheel [-].
        radius: Of the cylinder in which it is cut [m].

    Source: Litvin and Fuentes 2004, chapter 18, in sections: cos α(R) = R_b/R.
    """
    roll = radius * pinion.teeth / teeth
    angle = math.acos(min(1.0, pinion.base_radius / roll))
    half = (math.pi / pinion.teeth - float(pinion.half_angles(np.asarray(roll)))) * roll
    rack, middle = pinion.rack, pinion.pitch_radius
    top, root = middle - rack.addendum * pinion.module, middle + rack.dedendum * pinion.module
    most = 0.98 * math.pi * roll / pinion.teeth
    return half + (top - roll) * math.tan(angle), min(half + (root - roll) * math.tan(angle), most)


class SeatHub(NamedTuple):
    """A hub over its seat, from the middle of the face away from the mate [m]."""

    low: float
    """Where it begins."""
    high: float
    """Where it ends."""
    radius: float
    """Outside; at most what the rim leaves."""


def _under_rim(
    toe: tuple[float, float], heel: tuple[float, float], upper: float, dish: float
) -> tuple[float, tuple[float, float]]:
    """Return which share of a rim a plate takes, and where its back meets it, z and radius [m]."""
    long = heel[0] - toe[0]
    if long == 0.0:
        return 1.0, (upper, heel[1])
    # On the rim z = upper − dish (r − r_toe), with r − r_toe in proportion to z − z_toe.
    share = min((upper - toe[0]) / long / (1.0 + dish * (heel[1] - toe[1]) / long), 1.0)
    return share, (toe[0] + share * long, toe[1] + share * (heel[1] - toe[1]))


def dishes_behind(
    toe: tuple[float, float],
    heel: tuple[float, float],
    bore: float,
    *,
    web: float,
    seat: SeatHub | None = None,
) -> tuple[float, float] | None:
    """Return the least and the largest dish with which a plate meets rim and hub with all of its thickness [-].

    Args:
        toe: Where the rim ends under the inner end of the teeth, z and radius [m].
        heel: The same under the outer end [m].
        bore: Radius of what the gear sits on [m].
        web: Thickness of the plate [m].
        seat: The hub where its seat is sized; None: about the plate, in proportion to the bore.

    Returns:
        None where rim and hub meet, so that there is no plate.

    Source: geometry: along the hub the plate moves by dish times its height; its back leaves the rim at the heel
        where it leans back by what the rim is longer along z over what the rim rises.
    """
    bore, hub = _hub(toe, bore, seat)
    if hub is None or hub >= toe[1]:
        return None
    upper = min(toe[0] + web, heel[0])
    low, high = _along(toe[0], upper, bore, hub, seat)
    height, rise = toe[1] - hub, heel[1] - toe[1]
    least = (low - toe[0]) / height
    return max(least, (upper - heel[0]) / rise) if rise > 0.0 else least, (high - upper) / height


def _hub(toe: tuple[float, float], bore: float, seat: SeatHub | None) -> tuple[float, float | None]:
    """Return the radii of bore and hub [m]; no hub where it meets the rim, or the gear has no bore."""
    bore = min(bore, 0.85 * toe[1])
    hub = HUB * bore if seat is None else max(min(seat.radius, NEXT * toe[1]), bore)
    return bore, None if (seat is None and hub > 0.8 * toe[1]) or bore <= 0.0 else hub


def _along(low: float, high: float, bore: float, hub: float, seat: SeatHub | None) -> tuple[float, float]:
    """Return the ends of a hub about a plate from low to high, or of the seat that is sized [m]."""
    if seat is not None:
        return seat.low, seat.high
    middle, half = (low + high) / 2.0, max(1.6 * (high - low), 1.2 * (hub - bore)) / 2.0
    return middle - half, middle + half


def way_behind(
    toe: tuple[float, float],
    heel: tuple[float, float],
    bore: float,
    *,
    web: float,
    seat: SeatHub | None = None,
    dish: float = 0.0,
) -> list[tuple[float, float]]:
    """Return the way behind teeth on a cone or a face from heel to toe: a rim, a plate, a hub about the bore.

    Args:
        toe: Where the rim ends under the inner end of the teeth, z and radius [m].
        heel: The same under the outer end [m].
        bore: Radius of what the gear sits on [m].
        web: Thickness of the plate [m].
        seat: The hub where its seat is sized; None: about the plate, in proportion to the bore.
        dish: By how much the plate leans along z towards the hub [-]; its thickness along z is kept.

    Returns:
        One that goes straight to the bore where rim and hub meet, or the gear has no bore.

    Raises:
        DesignError: A plate that leans so far that it does not meet rim and hub with all of its thickness; with how
            far it may.

    Source: geometry.
    """
    limits = dishes_behind(toe, heel, bore, web=web, seat=seat) if dish else None
    if limits is not None and not limits[0] <= dish <= limits[1]:
        raise DesignError([Problem("dish", f"{dish:g} given; must be from {limits[0]:.4g} to {limits[1]:.4g}")])
    bore, hub = _hub(toe, bore, seat)
    if hub is None:
        return [heel, (heel[0], bore), (toe[0], bore), toe]
    upper = min(toe[0] + web, heel[0])
    share, under = _under_rim(toe, heel, upper, dish)
    low, high = _along(toe[0], upper, bore, hub, seat)
    way = [heel] + ([under] if share < 1.0 else [])
    lean = dish * (toe[1] - hub)
    back, front = upper + lean, toe[0] + lean
    return [*way, (back, hub), (high, hub), (high, bore), (low, bore), (low, hub), (front, hub), toe]
