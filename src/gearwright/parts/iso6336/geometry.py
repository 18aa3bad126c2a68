"""Geometry of cylindrical gear pairs for rating by ISO 6336, and the choice of method for each factor."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from functools import cached_property
from typing import Any, TypeAlias

import numpy as np

from gearwright.base import Floats, Problem, refuse
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

    @cached_property
    def side(self) -> Value:
        """+1 for an external pair, −1 for an internal one [-]."""
        return np.sign(self.teeth[1])

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
