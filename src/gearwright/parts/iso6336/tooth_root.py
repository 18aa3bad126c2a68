"""Form and stress correction factors of ISO 6336-3, and root fillets of shaper-cut internal gears."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum
from typing import Annotated, Any, NamedTuple

import numpy as np

from gearwright.base import Origin, Quantity, SolveError
from gearwright.parts.iso6336.geometry import MeshGeometry, ShaperCutter, ToothProportions, Value, as_value

# ----------------------------------------------------------------------------------------------------------------------
# The fillet that a shaper cutter leaves in a ring: the envelope of the cutter's rounded tip as both roll.
#
# Lengths are in normal modules, tooth numbers those of the equivalent spur gears and positive; the ring's centre is the
# origin, the cutter's lies on the x axis, and the pole where their generating circles touch.
# ----------------------------------------------------------------------------------------------------------------------


_ENVELOPE_STEPS = 40
_TANGENT = np.pi / 6.0
"""The normal of the critical section's fillet point against the tooth's centre line: its tangent lies at 60° to it."""


class ShapedFillet(NamedTuple):
    """Where the 60° tangent touches the fillet of a ring, over the module."""

    chord: Value
    """s_Fn/m_n [-]."""
    radius: Value
    """ρ_F/m_n [-]."""
    height: Value
    """Distance of the critical section from the ring's centre along the tooth's centre line [-]."""
    normal: Value
    """Angle of the fillet's normal to the line of centres ϑ [rad]."""


class _Tip(NamedTuple):
    """The rounding of the cutter's tip, and where the cutter stands in the ring."""

    centre: Value
    """Generating centre distance a_0/m_n [-]."""
    pole: Value
    """Of the pole from the ring's centre [-]."""
    reach: Value
    """Of the rounding's centre from the cutter's centre [-]."""
    angle: Value
    """Half angle between the centres of a tooth's two roundings [rad]."""


def shaped_fillet(tooth: ToothProportions, teeth: Value, pressure_angle: Value) -> ShapedFillet:
    """Return where the 60° tangent touches the fillet that a shaper cutter generates.

    Args:
        tooth: Of the ring, with its cutter; its fillet radius is that of the cutter's tip, its dedendum gives the root
            circle.
        teeth: z_n of the ring, positive [-].
        pressure_angle: α_n [rad].

    Source: law of gearing: the normal of the fillet runs through the pole (Litvin and Fuentes 2004, section 6.4); with
        Euler and Savary's ρ_F = ρ_a0 + (1 − z_0/z_n) l/(dη/dφ).

    Raises:
        SolveError: a tip that has no room for its two roundings, or no tangent point on the fillet.
    """
    cutter = tooth.cutter
    assert cutter is not None
    tip, turn = _tip(tooth, cutter, teeth, pressure_angle), cutter.teeth / teeth
    roll: Value = 0.0
    for _ in range(_ENVELOPE_STEPS):
        lean, rate, _ = _normal(tip, roll)
        step = (lean - turn * roll - np.pi / teeth - _TANGENT) / (rate - turn)
        roll = roll - np.clip(step, -0.5 * np.pi / cutter.teeth, 0.5 * np.pi / cutter.teeth)
        if np.all(np.abs(step) < 1e-14):
            break
    lean, rate, length = _normal(tip, roll)
    if not np.all(np.abs(lean - turn * roll - np.pi / teeth - _TANGENT) < 1e-9):
        raise SolveError(
            "no 60° tangent on the fillet that this cutter leaves; give fewer teeth or a smaller tip radius"
        )
    across = tip.reach * np.sin(tip.angle + roll) + tooth.fillet_radius * np.sin(lean)
    along = tip.centre + tip.reach * np.cos(tip.angle + roll) + tooth.fillet_radius * np.cos(lean)
    behind = np.arctan2(across, along) - turn * roll - np.pi / teeth
    distance = np.hypot(across, along)
    return ShapedFillet(
        chord=as_value(-2.0 * distance * np.sin(behind)),
        radius=as_value(tooth.fillet_radius + (1.0 - turn) * length / (rate - turn)),
        height=as_value(distance * np.cos(behind)),
        normal=as_value(lean),
    )


def _tip(tooth: ToothProportions, cutter: ShaperCutter, teeth: Value, pressure_angle: Value) -> _Tip:
    """Place the cutter by inv α_w0 = inv α_n − 2 tan α_n (x_0 + x)/(z_n − z_0), its tip on the ring's root circle."""
    slope, difference = 2.0 * np.tan(pressure_angle), teeth - cutter.teeth
    generating = _involute(pressure_angle) - slope * (cutter.shift + tooth.profile_shift) / difference
    working = _involute_angle(generating, pressure_angle)
    centre = 0.5 * difference * np.cos(pressure_angle) / np.cos(working)
    reach = 0.5 * teeth + tooth.dedendum - tooth.profile_shift - centre - tooth.fillet_radius
    base = 0.5 * cutter.teeth * np.cos(pressure_angle)
    thickness = (0.5 * np.pi + slope * cutter.shift) / cutter.teeth + _involute(pressure_angle)
    angle = thickness - _involute(np.arccos(base / reach)) - tooth.fillet_radius / base
    if not np.all(angle >= 0.0):
        raise SolveError("its tip is too narrow for this radius; give a smaller tip radius")
    return _Tip(centre, centre * teeth / difference, reach, angle)


def _normal(tip: _Tip, roll: Value) -> tuple[Value, Value, Value]:
    """Lean η of the normal to the line of centres [rad], dη/dφ [-], distance from rounding to pole [-]."""
    angle = tip.angle + roll
    along = tip.centre - tip.pole + tip.reach * np.cos(angle)
    across = tip.reach * np.sin(angle)
    square = along**2 + across**2
    rate = tip.reach * ((tip.centre - tip.pole) * np.cos(angle) + tip.reach) / square
    return np.arctan2(across, along), rate, np.sqrt(square)


def _involute(angle: Value) -> Value:
    """Return inv α = tan α − α, for one angle or an array of them [rad]."""
    return as_value(np.tan(angle) - angle)


def _involute_angle(value: Value, start: Value) -> Value:
    """Return the angle of an involute near the pressure angle [rad], by Newton's iteration."""
    angle = start
    for _ in range(_ENVELOPE_STEPS):
        angle = angle - (_involute(angle) - value) / np.tan(angle) ** 2
    return angle


# ----------------------------------------------------------------------------------------------------------------------
# Critical section of a tooth by ISO 6336-3: 30° tangents for external, 60° for internal teeth; Y_F and Y_S.
#
# The tooth is that of the equivalent spur gear with z_n teeth; internal gears keep the standard's negative z_n and
# diameters inside these formulas. Lengths are in normal modules.
# ----------------------------------------------------------------------------------------------------------------------


_PART3 = "ISO 6336-3:2019, clause 6"
_TANGENT_STEPS = 25
_NO_TOOTH = "tooth root: no tangent point on the fillet; check dedendum, fillet radius and profile shift"


class Edition(Enum):
    """Edition of the standard: of ISO 6336-3, its load sharing, helix factor and fillets of rings; or DIN 3990."""

    DIN1987 = 1987
    """DIN 3990: roots as in 2006, external gears; no drop of the strength beyond the knee, Z_X from m_n = 10 mm, Z_W by
    hardness alone, Z_β = √cos β."""
    ISO2006 = 2006
    """With its correction of 2007: no f_ε; Y_β = 1 − ε_β β/120°; |z_n| in ρ_F, for rings too; shaped rings by ρ_fPv."""
    ISO2019 = 2019
    """f_ε in Y_F; Y_β = (1 − ε_β β/120°)/cos³ β; a ring's z_n is negative in ρ_F as everywhere; shaped rings by the
    contour that their cutter generates."""


@dataclass(frozen=True)
class RootSection:
    """The critical section of one tooth and how the load bends it."""

    tangent_angle: Annotated[Value, Quantity("angle"), Origin("ϑ = 2 G/z_n tan ϑ − H", _PART3)]
    """Auxiliary angle of the tangent point ϑ [rad]."""
    chord: Annotated[Value, Quantity("ratio"), Origin("s_Fn/m_n", _PART3)]
    """Thickness of the critical section over the module s_Fn/m_n [-]."""
    fillet_radius: Annotated[Value, Quantity("ratio"), Origin("ρ_F/m_n", _PART3)]
    """Radius of the fillet at the tangent point over the module ρ_F/m_n [-]."""
    lever: Annotated[Value, Quantity("ratio"), Origin("h_Fe/m_n", _PART3)]
    """Bending moment arm over the module h_F/m_n [-]."""
    load_angle: Annotated[Value, Quantity("angle"), Origin("α_Fen = α_en − γ_e", _PART3)]
    """Angle of the load to the tooth's normal α_Fen [rad]."""
    form: Annotated[Value, Quantity("ratio"), Origin("Y_F = 6 h_Fe cos α_Fen / (s_Fn² cos α_n)", _PART3)]
    """Form factor Y_F, without the load sharing factor f_ε [-]."""
    notch: Annotated[Value, Quantity("ratio"), Origin("q_s = s_Fn/(2 ρ_F)", "ISO 6336-3:2019, clause 7")]
    """Notch parameter q_s [-]."""
    stress_correction: Annotated[
        Value, Quantity("ratio"), Origin("Y_S = (1.2 + 0.13 L) q_s^(1/(1.21 + 2.3/L))", "ISO 6336-3:2019, clause 7")
    ]
    """Stress correction factor Y_S [-]."""


@dataclass(frozen=True)
class LoadedTooth:
    """One tooth of the equivalent spur gear, and the circle at which the load acts."""

    teeth: Value
    """z_n [-], negative for internal teeth."""
    load_diameter: Value
    """Diameter of the circle through the load over the module, d_en/m_n [-], negative for internal teeth."""
    pressure_angle: Value
    """α_n [rad]."""
    tooth: ToothProportions
    """Proportions; of internal teeth with their cutter, or with the fillet radius that it leaves."""
    thickness_shift: Value = 0.0
    """Thickness modification coefficient x_s, used by bevel gears [-]."""
    force_angle: Value | None = None
    """Pressure angle in the denominator of Y_F [rad]; None: `pressure_angle`."""


def shaped_fillet_radius(tooth: ToothProportions, cutter_teeth: Value, cutter_shift: Value = 0.0) -> Value:
    """Return the fillet radius that a shaper cutter leaves on an internal gear, over the module ρ_fPv/m_n.

    Args:
        tooth: Proportions of the internal gear.
        cutter_teeth: z_0 [-].
        cutter_shift: x_0 [-].

    Source: ISO 6336-3:2006, clause 6.2.2, ρ_fP + (x_0 + h_fP − ρ_fP)^1.95 / (3.156 · 1.036^z_0), in modules.
    """
    height = cutter_shift + tooth.dedendum - tooth.fillet_radius
    return tooth.fillet_radius + height**1.95 / (3.156 * 1.036**cutter_teeth)


def outer_single_contact(mesh: MeshGeometry, gear: int) -> LoadedTooth:
    """Return a tooth loaded at its outer point of single pair contact.

    Args:
        mesh: The pair.
        gear: 0 for the pinion, 1 for the wheel.

    Source: ISO 6336-3:2019, clause 6.4, d_en with ε_αn = ε_α/cos² β_b.
    """
    sign = np.sign(mesh.teeth[gear])
    z_n = mesh.virtual_teeth[gear]
    tip = 2.0 * (mesh.tip_radii[gear] - 0.5 * mesh.pitch_diameters[gear]) / mesh.module + np.abs(z_n)
    base = np.abs(z_n) * np.cos(mesh.pressure_angle)
    ratio = mesh.transverse_contact_ratio / np.cos(mesh.base_helix_angle) ** 2
    reach = np.sqrt(0.25 * (tip**2 - base**2)) - sign * np.pi * np.cos(mesh.pressure_angle) * (ratio - 1.0)
    diameter = np.copysign(2.0 * np.sqrt(reach**2 + 0.25 * base**2), sign)
    return LoadedTooth(z_n, diameter, mesh.pressure_angle, mesh.proportions[gear])


def tip_loaded(mesh: MeshGeometry, gear: int) -> LoadedTooth:
    """Return a tooth loaded at its tip, as method C has it.

    Args:
        mesh: The pair.
        gear: 0 for the pinion, 1 for the wheel.

    Source: ISO 6336-3:1996, clause 5 (method C); DIN 3990-3:1987, clause 3.3: d_an of the equivalent spur gear. Rings
        have d_an of their own tip, with the critical section of their fillet.
    """
    z_n = mesh.virtual_teeth[gear]
    tip = 2.0 * (mesh.tip_radii[gear] - 0.5 * mesh.pitch_diameters[gear]) / mesh.module + np.abs(z_n)
    return LoadedTooth(z_n, np.copysign(tip, z_n), mesh.pressure_angle, mesh.proportions[gear])


def root_section(loaded: LoadedTooth, edition: Edition = Edition.ISO2019) -> RootSection:
    """Return the critical section, Y_F and Y_S of a loaded tooth.

    Args:
        loaded: The tooth and where the load acts.
        edition: Edition that gives ρ_F of rings: the correction of 2007 takes |z_n|, which makes their fillets twice as
            round and Y_S a quarter smaller.

    Source: ISO 6336-3:2019, clauses 6 and 7 (2006: the same without f_ε, and for rings |z_n| in ρ_F).
    Valid for: teeth without undercut, fillets made by a rack or shaper, 1 ≤ q_s < 8.

    Raises:
        SolveError: when the tangent point is not found, which means that the proportions make no tooth.

    >>> pinion = LoadedTooth(20.0, 22.0, np.radians(20.0), ToothProportions())
    >>> round(float(root_section(pinion).form), 3)
    2.8
    """
    shaped = loaded.tooth.cutter is not None and edition is Edition.ISO2019
    tangent = _shaped_tangent(loaded) if shaped else _rolled_tangent(loaded, edition)
    angle, gamma = _load_angle(loaded)
    arm = (np.cos(gamma) - np.sin(gamma) * np.tan(angle)) * loaded.load_diameter
    chord, fillet, lever = tangent.chord, tangent.fillet, 0.5 * (arm - tangent.diameter)
    if not np.all((chord > 0.0) & (lever > 0.0) & (fillet > 0.0)):
        raise SolveError(_NO_TOOTH)
    force = loaded.pressure_angle if loaded.force_angle is None else loaded.force_angle
    form = 6.0 * lever * np.cos(angle) / (chord**2 * np.cos(force))
    notch = chord / (2.0 * fillet)
    correction = _stress_correction(chord / lever, notch)
    return RootSection(tangent.angle, chord, fillet, lever, angle, form, notch, correction)


class _Tangent(NamedTuple):
    """Where the tangent of the critical section touches the fillet, over the module."""

    angle: Value
    """ϑ [rad]."""
    chord: Value
    """s_Fn/m_n [-]."""
    fillet: Value
    """ρ_F/m_n [-]."""
    diameter: Value
    """Twice the distance of the section from the gear's centre, negative for internal teeth [-]."""


def _rolled_tangent(loaded: LoadedTooth, edition: Edition) -> _Tangent:
    """Touch the fillet that a rack leaves, or the rack that stands for a shaper cutter by its ρ_fPv."""
    tooth, z_n = _by_rack(loaded.tooth), loaded.teeth
    drop = tooth.fillet_radius - tooth.dedendum + tooth.profile_shift
    internal = np.asarray(z_n) < 0
    opening = np.where(internal, np.pi / 6.0, np.pi / 3.0)
    turned = 2.0 / z_n * (0.5 * np.pi - _corner(loaded, tooth)) - opening
    theta = _tangent_angle(drop, turned, z_n)
    cosine = np.cos(theta)
    offset = drop / cosine - tooth.fillet_radius
    chord = z_n * np.sin(opening - theta) + np.where(internal, 1.0, np.sqrt(3.0)) * offset
    rolling = z_n if edition is Edition.ISO2019 else np.abs(z_n)
    fillet = tooth.fillet_radius + 2.0 * drop**2 / (cosine * (rolling * cosine**2 - 2.0 * drop))
    diameter = z_n * np.cos(opening - theta) + np.where(internal, np.sqrt(3.0), 1.0) * offset
    return _Tangent(theta, chord, fillet, diameter)


def _by_rack(tooth: ToothProportions) -> ToothProportions:
    """Return a tooth with the fillet radius of the rack that stands for its shaper cutter."""
    if tooth.cutter is None:
        return tooth
    return replace(tooth, fillet_radius=shaped_fillet_radius(tooth, tooth.cutter.teeth, tooth.cutter.shift))


def _shaped_tangent(loaded: LoadedTooth) -> _Tangent:
    """Touch the fillet that the shaper cutter generates."""
    touched = shaped_fillet(loaded.tooth, np.abs(loaded.teeth), loaded.pressure_angle)
    return _Tangent(touched.normal, touched.chord, touched.radius, -2.0 * touched.height)


def _corner(loaded: LoadedTooth, tooth: ToothProportions) -> Value:
    """Auxiliary length E over the module: half width of the rack's tip between the centres of its roundings."""
    alpha = loaded.pressure_angle
    return (
        np.pi / 4.0
        - loaded.thickness_shift
        - tooth.dedendum * np.tan(alpha)
        + tooth.undercut / np.cos(alpha)
        - (1.0 - np.sin(alpha)) * tooth.fillet_radius / np.cos(alpha)
    )


def _tangent_angle(drop: Value, constant: Value, teeth: Value) -> Value:
    """Solve ϑ = 2 G/z_n tan ϑ − H by Newton's iteration, for all variants at once; each stops where it is found."""
    theta = -constant
    moving: Any = 1.0
    for _ in range(_TANGENT_STEPS):
        slope = 1.0 - 2.0 * drop / (teeth * np.cos(theta) ** 2)
        step = moving * (theta - 2.0 * drop / teeth * np.tan(theta) + constant) / slope
        theta = theta - step
        moving = np.abs(step) >= 1e-14
        if not _any(moving):
            break
    if not np.all((theta > 0.0) & (theta < 0.5 * np.pi)):
        raise SolveError(_NO_TOOTH)
    return theta


def _any(moving: Any) -> bool:
    return bool(np.any(moving))


def _load_angle(loaded: LoadedTooth) -> tuple[Value, Value]:
    """Angle of the load α_Fen and half angle of the tooth γ_e at the load [rad]."""
    at_load = np.arccos(loaded.teeth * np.cos(loaded.pressure_angle) / loaded.load_diameter)
    shift = loaded.tooth.profile_shift * np.tan(loaded.pressure_angle) + loaded.thickness_shift
    involutes = np.tan(loaded.pressure_angle) - loaded.pressure_angle - np.tan(at_load) + at_load
    gamma = (0.5 * np.pi + 2.0 * shift) / loaded.teeth + involutes
    return at_load - gamma, gamma


def _stress_correction(slenderness: Value, notch: Value) -> Value:
    """Y_S with L = s_Fn/h_Fe and the notch parameter q_s."""
    return (1.2 + 0.13 * slenderness) * notch ** (1.0 / (1.21 + 2.3 / slenderness))
