"""Critical section of a tooth by ISO 6336-3: 30° tangents for external, 60° for internal teeth; Y_F and Y_S.

The tooth is that of the equivalent spur gear with z_n teeth; internal gears keep the standard's negative z_n and
diameters inside these formulas. Lengths are in normal modules.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum
from typing import Annotated, Any, NamedTuple

import numpy as np

from gearwright.errors import SolveError
from gearwright.parts.iso6336.geometry import MeshGeometry, ToothProportions, Value
from gearwright.parts.iso6336.shaped_root import shaped_fillet
from gearwright.units import Origin, Quantity

_PART3 = "ISO 6336-3:2019, clause 6"
_STEPS = 25
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
    for _ in range(_STEPS):
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
