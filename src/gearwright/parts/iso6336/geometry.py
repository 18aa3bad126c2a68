"""Geometry for rating by ISO 6336: the pair, the choice of method for each factor, and the form of the tooth root."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from enum import Enum
from functools import cached_property, wraps
from typing import Annotated, Any, Concatenate, NamedTuple, ParamSpec, TypeAlias, TypeVar

import numpy as np

from gearwright.base import Floats, Origin, Problem, Quantity, SolveError, refuse
from gearwright.parts.gears import GearPair, ToothShift

# ----------------------------------------------------------------------------------------------------------------------
# What the rating of a cylindrical pair needs to know of its geometry, for one pair or for an array of them.
#
# Every field may be a number or an array, so that thousands of variants are rated at once. Teeth are signed as in
# ISO 21771: an internal wheel has z_2 < 0 and with it a negative gear ratio; lengths are positive.
# ----------------------------------------------------------------------------------------------------------------------


Value: TypeAlias = float | Floats
"""A number, or an array of them over variants."""


def as_value(result: Any) -> Value:
    """Return a result as a plain number where it is one, and as an array where it is one.

    Args:
        result: What a formula over numbers or arrays gave.

    Source: none; it undoes the arrays without dimension that NumPy makes of numbers.
    """
    value: Value = np.asarray(result, dtype=np.float64)[()]
    return value


@dataclass(frozen=True)
class ShaperCutter:
    """The pinion-shaped cutter of a ring; the radius of its tip is the tooth's fillet radius."""

    teeth: Value
    """z_0 [-]."""
    shift: Value = 0.0
    """x_0 [-]; 0 where the cutter is half worn."""


@dataclass(frozen=True)
class ToothProportions:
    """Tooth of one gear, in normal modules."""

    dedendum: Value = 1.25
    """Dedendum of the basic rack h_fP* [-]."""
    fillet_radius: Value = 0.38
    """Fillet radius of the basic rack ρ_fP* [-]."""
    profile_shift: Value = 0.0
    """x [-]."""
    undercut: Value = 0.0
    """Residual undercut of a protuberance tool s_pr* [-]."""
    cutter: ShaperCutter | None = None
    """Shaper cutter of a ring; None: its fillet radius is what the tool leaves."""


_ANGLES = (
    "side", "ratio", "transverse_angle", "base_helix_angle", "working_angle", "tip_tangents", "addendum_contact_ratios",
    "transverse_contact_ratio", "virtual_teeth",
)  # fmt: skip
"""What is the same of teeth of every module and face width."""
_LENGTHS = ("pitch_diameters", "base_diameters", "tooth_heights")
"""What goes with the module, of both gears."""


@dataclass(frozen=True)
class MeshGeometry:
    """A pair of cylindrical gears as ISO 6336 sees it."""

    teeth: tuple[Value, Value]
    """z_1, z_2 [-]; z_2 < 0 for an internal wheel."""
    module: Value
    """m_n [m]."""
    face_width: Value
    """Common face width b [m]."""
    centre_distance: Value
    """Working centre distance a_w [m], positive."""
    tip_radii: tuple[Value, Value]
    """r_a1, r_a2 [m]."""
    helix_angle: Value = 0.0
    """β at the reference cylinder [rad]."""
    pressure_angle: Value = np.pi / 9.0
    """α_n [rad]."""
    proportions: tuple[ToothProportions, ToothProportions] = (ToothProportions(), ToothProportions())
    """Tooth proportions of the two gears."""
    form: MeshGeometry | None = field(default=None, init=False, compare=False, repr=False)
    """The same teeth of a module of 1 m, of which this is a size; None: it is no size of others."""
    kept: dict[tuple[Any, ...], Any] = field(default_factory=dict, init=False, compare=False, repr=False)
    """What functions `of_form` and `of_contact` gave of it."""

    def of_size(self, module: Value, face_width: Value) -> MeshGeometry:
        """Return the same teeth in another size; what depends on neither module nor width is computed once for all.

        Args:
            module: m_n [m]; that of these teeth is 1 m.
            face_width: b [m].
        """
        radii, centre = (self.tip_radii[0] * module, self.tip_radii[1] * module), self.centre_distance * module
        angles = self.helix_angle, self.pressure_angle
        sized = MeshGeometry(self.teeth, module, face_width, centre, radii, *angles, self.proportions)
        known: dict[str, Any] = {name: getattr(self, name) for name in _ANGLES}
        for name in _LENGTHS:
            first, second = getattr(self, name)
            known[name] = first * module, second * module
        sized.__dict__.update(known, relative_curvature=self.relative_curvature * module, form=self)
        return sized

    @cached_property
    def side(self) -> Value:
        """+1 for an external pair, −1 for an internal one [-]."""
        return np.sign(self.teeth[1])

    @property
    def is_spur(self) -> bool:
        """Whether it is known to have straight teeth, all of an array."""
        return type(self.helix_angle) is float and self.helix_angle == 0.0

    @cached_property
    def ratio(self) -> Value:
        """Gear ratio u = z_2/z_1 [-], negative for an internal pair."""
        return self.teeth[1] / self.teeth[0]

    @cached_property
    def transverse_angle(self) -> Value:
        """α_t [rad], tan α_t = tan α_n / cos β."""
        return np.arctan(np.tan(self.pressure_angle) / np.cos(self.helix_angle))

    @cached_property
    def base_helix_angle(self) -> Value:
        """β_b [rad], sin β_b = sin β cos α_n."""
        return as_value(np.arcsin(np.sin(self.helix_angle) * np.cos(self.pressure_angle)))

    @cached_property
    def pitch_diameters(self) -> tuple[Value, Value]:
        """Reference diameters d = |z| m_n / cos β [m]."""
        module = self.module / np.cos(self.helix_angle)
        return np.abs(self.teeth[0]) * module, np.abs(self.teeth[1]) * module

    @cached_property
    def base_diameters(self) -> tuple[Value, Value]:
        """d_b = d cos α_t [m]."""
        cosine = np.cos(self.transverse_angle)
        return self.pitch_diameters[0] * cosine, self.pitch_diameters[1] * cosine

    @cached_property
    def working_angle(self) -> Value:
        """α_wt [rad], cos α_wt = (d_b2 ± d_b1) / (2 a_w)."""
        first, second = self.base_diameters
        return np.arccos((second + self.side * first) / (2.0 * self.centre_distance))

    @cached_property
    def tangent_distance(self) -> Value:
        """Distance between the tangent points of both base circles T_1T_2 = a_w sin α_wt [m]; negative within a ring.

        With it the radii of curvature ρ_1 + ρ_2 = T_1T_2 of internal pairs are those of external ones: ρ_2 < 0, hollow.
        """
        return self.side * self.centre_distance * np.sin(self.working_angle)

    @cached_property
    def rolls(self) -> bool:
        """Whether contact ends before the base circles' tangent points; beyond, tips interfere and nothing rolls."""
        reach = self.tangent_distance
        first, second = (0.5 * base * tip for base, tip in zip(self.base_diameters, self.tip_tangents, strict=True))
        before = np.where(self.side > 0.0, np.maximum(first, second) < reach, second > -reach)
        return bool(np.all(before))

    @cached_property
    def base_pitch(self) -> Value:
        """Transverse base pitch p_bt [m]."""
        return np.pi * self.base_diameters[0] / self.teeth[0]

    @cached_property
    def tip_tangents(self) -> tuple[Value, Value]:
        """tan α_a at the two tips, √((d_a/d_b)² − 1) [-]."""
        return (
            np.sqrt((2.0 * self.tip_radii[0] / self.base_diameters[0]) ** 2 - 1.0),
            np.sqrt((2.0 * self.tip_radii[1] / self.base_diameters[1]) ** 2 - 1.0),
        )

    @cached_property
    def addendum_contact_ratios(self) -> tuple[Value, Value]:
        """Contact ratio that each gear's addendum gives, ε_1 and ε_2 [-] (ISO/TS 6336-21)."""
        tangent = np.tan(self.working_angle)
        first = self.teeth[0] / (2.0 * np.pi) * (self.tip_tangents[0] - tangent)
        second = self.teeth[1] / (2.0 * np.pi) * (self.tip_tangents[1] - tangent)
        return first, second

    @cached_property
    def transverse_contact_ratio(self) -> Value:
        """ε_α [-]."""
        return self.addendum_contact_ratios[0] + self.addendum_contact_ratios[1]

    @cached_property
    def overlap_ratio(self) -> Value:
        """ε_β = b sin β / (π m_n) [-]."""
        if self.is_spur:
            return 0.0
        return self.face_width * np.sin(self.helix_angle) / (np.pi * self.module)

    @cached_property
    def total_contact_ratio(self) -> Value:
        """ε_γ = ε_α + ε_β [-]."""
        return self.transverse_contact_ratio + self.overlap_ratio

    @cached_property
    def virtual_teeth(self) -> tuple[Value, Value]:
        """z_n = z / (cos² β_b cos β) [-]."""
        cosine = np.cos(self.base_helix_angle) ** 2 * np.cos(self.helix_angle)
        return self.teeth[0] / cosine, self.teeth[1] / cosine

    @cached_property
    def relative_curvature(self) -> Value:
        """Radius of relative curvature at the pitch point ρ_red = ρ_1 ρ_2 / (ρ_1 + ρ_2) [m] (ISO 6336-2, clause 12)."""
        first = 0.5 * self.base_diameters[0] * np.tan(self.working_angle)
        second = 0.5 * self.side * self.base_diameters[1] * np.tan(self.working_angle)
        return first * second / (first + second)

    @cached_property
    def tooth_heights(self) -> tuple[Value, Value]:
        """Tooth heights h from root to tip [m]."""
        first = self.tip_radii[0] - self._root_radius(0, 1.0)
        return first, self.side * (self.tip_radii[1] - self._root_radius(1, self.side))

    def _root_radius(self, gear: int, side: Value) -> Value:
        """Root radius of one gear [m]."""
        tooth = self.proportions[gear]
        return 0.5 * self.pitch_diameters[gear] - side * (tooth.dedendum - tooth.profile_shift) * self.module


Given = ParamSpec("Given")
Found = TypeVar("Found")


def of_form(
    function: Callable[Concatenate[MeshGeometry, Given], Found],
) -> Callable[Concatenate[MeshGeometry, Given], Found]:
    """Return a function of a mesh, whose result depends on neither module nor face width, that keeps what it gave.

    Sizes of one mesh have it in common: it is computed with a module of 1 m.

    Args:
        function: Of a mesh and of what can be looked up.

    Source: none; it keeps what formulas gave.
    """

    @wraps(function)
    def looked_up(mesh: MeshGeometry, /, *given: Given.args, **named: Given.kwargs) -> Found:
        return _kept(mesh.form or mesh, function, *given, **named)

    return looked_up


def of_contact(
    function: Callable[Concatenate[MeshGeometry, Given], Found],
) -> Callable[Concatenate[MeshGeometry, Given], Found]:
    """Return a function of a mesh, whose result depends on its size by its overlap alone, that keeps what it gave.

    Spur gears have none: sizes of one mesh have it in common.

    Args:
        function: Of a mesh and of what can be looked up.

    Source: none; it keeps what formulas gave.
    """

    @wraps(function)
    def looked_up(mesh: MeshGeometry, /, *given: Given.args, **named: Given.kwargs) -> Found:
        return _kept(mesh.form if mesh.form is not None and mesh.is_spur else mesh, function, *given, **named)

    return looked_up


def _kept(
    mesh: MeshGeometry,
    function: Callable[Concatenate[MeshGeometry, Given], Found],
    *given: Given.args,
    **named: Given.kwargs,
) -> Found:
    """Return what a function gave of a mesh, or gives now."""
    key = (function.__name__, given, *named.items())
    if key not in mesh.kept:
        mesh.kept[key] = function(mesh, *given, **named)
    found: Found = mesh.kept[key]
    return found


def shifted_mesh(
    teeth: tuple[Value, Value],
    shifts: tuple[ToothShift, ToothShift],
    centre: float | None,
    *,
    pressure_angle: float,
    helix_angle: float = 0.0,
    module: Value = 1.0,
    face_width: Value = 10.0,
) -> MeshGeometry:
    """Return a pair, or an array of pairs, with the basic rack 1.25/0.38 of ISO 53, profile A.

    Args:
        teeth: z_1, z_2, the latter negative for an internal gear [-].
        shifts: Profile shifts and tip alterations of both gears.
        centre: Working centre distance over the module a_w/m_n [-]; None: the reference one.
        pressure_angle: α_n [rad].
        helix_angle: β [rad].
        module: m_n [m].
        face_width: b [m].

    Source: ISO 21771:2007.
    """
    side = np.sign(teeth[1])
    first, second = (0.5 * np.abs(number) * module / np.cos(helix_angle) for number in teeth)
    heights = [1.0 + shift.profile_shift + shift.tip_alteration for shift in shifts]
    return MeshGeometry(
        teeth=teeth,
        module=module,
        face_width=face_width,
        centre_distance=second + side * first if centre is None else centre * module,
        tip_radii=(first + heights[0] * module, second + side * heights[1] * module),
        helix_angle=helix_angle,
        pressure_angle=pressure_angle,
        proportions=(
            ToothProportions(profile_shift=shifts[0].profile_shift),
            ToothProportions(profile_shift=shifts[1].profile_shift),
        ),
    )


def mesh_geometry(pair: GearPair) -> MeshGeometry:
    """Return what ISO 6336 needs of a pair, after refusing teeth that it does not cover.

    Args:
        pair: The pair, gear 1 external.

    Source: ISO 21771:2007.

    Raises:
        DesignError: undercut teeth, tips that reach beyond the tangent points of the base circles, ε_α below 1.
    """
    refuse(_undercut(pair) + _interference(pair))
    gears = (pair.driver, pair.driven)
    return MeshGeometry(
        teeth=(pair.driver.teeth, pair.driven.teeth),
        module=pair.driver.module,
        face_width=pair.face_width,
        centre_distance=pair.centre_distance,
        tip_radii=(gears[0].tip_radius, gears[1].tip_radius),
        helix_angle=pair.driver.helix_angle,
        pressure_angle=pair.driver.rack.pressure_angle,
        proportions=(
            ToothProportions(gears[0].rack.dedendum, gears[0].rack.fillet_radius, gears[0].profile_shift),
            ToothProportions(gears[1].rack.dedendum, gears[1].rack.fillet_radius, gears[1].profile_shift),
        ),
    )


def _undercut(pair: GearPair) -> list[Problem]:
    """Gears whose roots the tool undercuts: the root formulas of ISO 6336-3 do not hold for them."""
    return [
        Problem(
            f"{name}.profile_shift",
            f"x = {gear.profile_shift:.4g} undercuts {gear.teeth} teeth; needs {gear.undercut_shift:.3f} or more teeth",
        )
        for name, gear in (("driver", pair.driver), ("driven", pair.driven))
        if gear.profile_shift < gear.undercut_shift - 1e-12
    ]


def _interference(pair: GearPair) -> list[Problem]:
    """Tips that reach below the mate's base circle, and meshes that lose contact."""
    reach = pair.centre_distance * np.sin(pair.working_pressure_angle)
    problems = []
    for name, gear in (("driver", pair.driver), ("driven", pair.driven)):
        tip = np.sqrt(max(gear.tip_radius**2 - gear.base_radius**2, 0.0))
        beyond = tip > reach * (1.0 + 1e-12) if pair.side > 0 else name == "driven" and tip < reach * (1.0 - 1e-12)
        if beyond:
            limit = 1e3 * float(np.hypot(gear.base_radius, reach))
            bound = "at most" if pair.side > 0 else "at least"
            message = (
                f"tip radius {1e3 * gear.tip_radius:.5g} mm interferes with the mate's root; "
                f"use {bound} {limit:.5g} mm or shift the profiles"
            )
            problems.append(Problem(f"{name}.tip_radius", message))
    if not problems and not pair.transverse_contact_ratio >= 1.0:
        ratio = f"contact ratio {pair.transverse_contact_ratio:.3f} given"
        problems.append(Problem("contact_ratio", f"{ratio}; ISO 6336 needs at least 1: longer teeth or less shift"))
    return problems


# ----------------------------------------------------------------------------------------------------------------------
# Which method of ISO 6336 gives a factor where the standard offers several.
# ----------------------------------------------------------------------------------------------------------------------


class RatingMethod(Enum):
    """Methods of ISO 6336 by which a factor is had; A, by measurement, is none that a formula gives."""

    B = "B"
    """The usual one."""
    C = "C"
    """The simpler one: fewer inputs, more on the safe side."""


@dataclass(frozen=True)
class Choices:
    """Method of the factors that have a choice."""

    dynamic: RatingMethod = RatingMethod.B
    """Of K_V: by resonance and deviations, or by the speed v z_1 alone."""
    root: RatingMethod = RatingMethod.B
    """Of Y_F and Y_S: load at the outer point of single contact, or at the tip with Y_ε."""
    least_dynamic: float = 1.0
    """K_V below which none counts [-]: by an analysis of the whole train, as method A has it."""


USUAL_CHOICES = Choices()
"""Method B throughout."""


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


@of_form
def loaded_sections(
    mesh: MeshGeometry, method: RatingMethod, edition: Edition = Edition.ISO2019
) -> tuple[RootSection, RootSection]:
    """Return the critical sections of both gears of a mesh, with the load where a method puts it.

    Args:
        mesh: The pair.
        method: B or C.
        edition: As `root_section` takes it.

    Source: ISO 6336-3:2019, clause 6 (method B); ISO 6336-3:1996, clause 5 (method C).
    """
    return root_section(loaded_tooth(mesh, 0, method), edition), root_section(loaded_tooth(mesh, 1, method), edition)


def loaded_tooth(mesh: MeshGeometry, gear: int, method: RatingMethod) -> LoadedTooth:
    """Return a tooth with the load where a method puts it.

    Args:
        mesh: The pair.
        gear: 0 for the pinion, 1 for the wheel.
        method: B or C.

    Source: ISO 6336-3:2019, clause 6 (method B); ISO 6336-3:1996, clause 5 (method C).
    """
    return tip_loaded(mesh, gear) if method is RatingMethod.C else outer_single_contact(mesh, gear)


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
    theta = _tangent_angle(drop, 2.0 / z_n * (0.5 * np.pi - _corner(loaded, tooth)) - opening, z_n)
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
    theta, double, per_tooth = -constant, 2.0 * drop, 2.0 * drop / teeth
    moving: Any = 1.0
    for _ in range(_TANGENT_STEPS):
        slope = 1.0 - double / (teeth * np.cos(theta) ** 2)
        step = moving * (theta - per_tooth * np.tan(theta) + constant) / slope
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
