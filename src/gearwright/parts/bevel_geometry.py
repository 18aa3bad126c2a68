"""Geometry of straight and spiral bevel gears without offset: cones, blanks, teeth, forces and bodies."""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum
from functools import cached_property
from typing import Annotated

from gearwright.base import DesignError, Floats, Origin, Problem, Quantity, refuse
from gearwright.parts.gears import (
    BasicRack,
    SeatHub,
    TransverseTooth,
    dishes_behind,
    least_profile_shift,
    outline_area,
    revolved_volume,
    transverse_form,
    way_behind,
)
from gearwright.parts.iso6336 import Value

# ----------------------------------------------------------------------------------------------------------------------
# Straight and spiral bevel gears without offset: cones, mean cone, forces by hand and rotation.
#
# Lengths are those of the mean cone (middle of the face) unless they are called outer. Axial forces are positive away
# from the apex, radial forces positive towards the gear's own axis.
# ----------------------------------------------------------------------------------------------------------------------


WIDEST = 1.0 / 3.0
"""Greatest face width over the outer cone distance b/R_e [-] (ISO 23509:2016, annex B)."""
WIDEST_MODULES = 10.0
"""Greatest face width over the outer transverse module b/m_et [-] (ISO 23509:2016, annex B)."""


class Hand(Enum):
    """Hand of spiral."""

    LEFT = "left"
    """Teeth lean to the left when seen from the apex side, face up."""
    RIGHT = "right"
    """Teeth lean to the right."""


class Rotation(Enum):
    """Direction of rotation, looking from the back (the large end) towards the apex."""

    CLOCKWISE = "clockwise"
    """With the clock."""
    COUNTERCLOCKWISE = "counterclockwise"
    """Against the clock."""


@dataclass(frozen=True)
class BevelTooth:
    """Tooth proportions in mean normal modules, and the tool that cuts them."""

    addendum: float = 1.0
    """Basic addendum k_hap [-]."""
    dedendum: float = 1.25
    """Basic dedendum k_hfp [-]."""
    profile_shift: float = 0.0
    """Profile shift of the pinion x_hm1 [-]; the wheel has its opposite."""
    thickness_shifts: tuple[float, float] = (0.0, 0.0)
    """Thickness modification x_sm1 and x_sm2 [-]."""
    edge_radii: tuple[float, float] = (0.3, 0.3)
    """Cutter edge radii ρ_a0 over the module [-]."""


@dataclass(frozen=True)
class BevelPair:
    """A pair of bevel gears as its drawing states it."""

    teeth: tuple[int, int]
    """z_1, z_2 [-]."""
    outer_module: float
    """Outer transverse module m_et [m]."""
    face_width: float
    """Face width b [m]."""
    spiral_angle: float = 0.0
    """Mean spiral angle β_m [rad]; 0 for straight teeth."""
    pressure_angle: float = math.radians(20.0)
    """Normal pressure angle α_n [rad]."""
    shaft_angle: float = math.pi / 2.0
    """Shaft angle Σ [rad]."""
    tooth: BevelTooth = BevelTooth()
    """Tooth proportions."""

    def __post_init__(self) -> None:
        refuse(_limits(self))

    @cached_property
    def pitch_angles(self) -> tuple[float, float]:
        """Pitch angles δ_1 and δ_2 [rad], tan δ_1 = sin Σ/(cos Σ + z_2/z_1)."""
        first = math.atan2(math.sin(self.shaft_angle), math.cos(self.shaft_angle) + self.teeth[1] / self.teeth[0])
        return first, self.shaft_angle - first

    @cached_property
    def outer_diameters(self) -> tuple[float, float]:
        """Outer pitch diameters d_e [m]."""
        return self.teeth[0] * self.outer_module, self.teeth[1] * self.outer_module

    @cached_property
    def outer_cone_distance(self) -> float:
        """R_e [m]."""
        return self.outer_diameters[0] / (2.0 * math.sin(self.pitch_angles[0]))

    @cached_property
    def mean_cone_distance(self) -> float:
        """R_m = R_e − b/2 [m]."""
        return self.outer_cone_distance - 0.5 * self.face_width

    @cached_property
    def mean_diameters(self) -> tuple[float, float]:
        """Mean pitch diameters d_m [m]."""
        scale = self.mean_cone_distance / self.outer_cone_distance
        return self.outer_diameters[0] * scale, self.outer_diameters[1] * scale

    @cached_property
    def mean_module(self) -> float:
        """Mean normal module m_mn = m_et cos β_m R_m/R_e [m]."""
        return self.outer_module * math.cos(self.spiral_angle) * self.mean_cone_distance / self.outer_cone_distance

    @cached_property
    def addenda(self) -> tuple[float, float]:
        """Mean addenda h_am [m]."""
        k, x = self.tooth.addendum, self.tooth.profile_shift
        return (k + x) * self.mean_module, (k - x) * self.mean_module

    @cached_property
    def dedenda(self) -> tuple[float, float]:
        """Mean dedenda h_fm [m]."""
        k, x = self.tooth.dedendum, self.tooth.profile_shift
        return (k - x) * self.mean_module, (k + x) * self.mean_module


def gleason_profile_shift(teeth: tuple[int, int]) -> float:
    """Return the profile shift of the pinion x_hm1 that a pair at right angles is usually cut with [-].

    Args:
        teeth: z_1, z_2 [-].

    Source: ISO 23509:2016, table 4, x_hm1 = k_d (1/2 − c_ham) with k_d = 2; C.3.2.3, c_ham = 0.210 + 0.290 (z_1/z_2)².
    Valid for: shafts at right angles.

    >>> round(gleason_profile_shift((14, 39)), 3)  # ISO/TR 10300-30:2024, sample 1
    0.505
    """
    return 2.0 * (0.5 - (0.210 + 0.290 * (teeth[0] / teeth[1]) ** 2))


@dataclass(frozen=True)
class BevelForces:
    """Forces of a bevel mesh on its two gears, at the mean diameters."""

    tangential: Annotated[float, Quantity("force"), Origin("F_mt = 2 T_1/d_m1", "ISO 10300-1:2023, eq. 1")]
    """Tangential force at the mean cone F_mt [N], on both gears."""
    axial: Annotated[
        tuple[float, float],
        Quantity("force"),
        Origin("F_a = F_mt/cos β_m (tan α_n sin δ ± sin β_m cos δ)", "ISO 23509:2016"),
    ]
    """Axial forces on pinion and wheel, away from the apex positive [N]."""
    radial: Annotated[
        tuple[float, float],
        Quantity("force"),
        Origin("F_r = F_mt/cos β_m (tan α_n cos δ ∓ sin β_m sin δ)", "ISO 23509:2016"),
    ]
    """Radial forces on pinion and wheel, towards their own axes positive [N]."""


def bevel_forces(pair: BevelPair, torque: float, *, hand: Hand, rotation: Rotation) -> BevelForces:
    """Return the forces on both gears when the pinion drives.

    Args:
        pair: The pair.
        torque: Torque on the pinion T_1 [N m].
        hand: Hand of the pinion's spiral; the wheel has the other. Without effect on straight teeth.
        rotation: Rotation of the pinion, seen from its back.

    Returns:
        With a left-hand pinion that drives clockwise (or right-hand and counterclockwise) the spiral pushes the
        pinion away from the apex, which keeps backlash.

    Source: ISO 23509:2016, annex D: F_a = F_mt/cos β_m (tan α_n sin δ ± sin β_m cos δ),
        F_r = F_mt/cos β_m (tan α_n cos δ ∓ sin β_m sin δ), upper signs for the pushed driver, lower for its wheel.

    >>> pair = BevelPair((17, 43), 8.5e-3, 51e-3, math.radians(35.0))
    >>> forces = bevel_forces(pair, 2031.1, hand=Hand.LEFT, rotation=Rotation.CLOCKWISE)
    >>> [round(force / 1e3, 1) for force in (forces.tangential, *forces.axial)]
    [32.3, 26.3, 5.0]
    """
    sign = 1.0 if (hand is Hand.LEFT) == (rotation is Rotation.CLOCKWISE) else -1.0
    force = 2.0 * torque / pair.mean_diameters[0]
    (axial_1, radial_1), (axial_2, radial_2) = (
        cone_forces(force, cone, pressure_angle=pair.pressure_angle, spiral_angle=pair.spiral_angle, pushed=pushed)
        for cone, pushed in zip(pair.pitch_angles, (sign, -sign), strict=True)
    )
    return BevelForces(force, (float(axial_1), float(axial_2)), (float(radial_1), float(radial_2)))


def cone_forces(
    force: Value, cone: float, *, pressure_angle: float, spiral_angle: float, pushed: Value = 1.0
) -> tuple[Value, Value]:
    """Return the axial force away from the apex and the radial force towards its axis on one bevel gear [N].

    Args:
        force: Tangential force at the mean cone F_mt [N].
        cone: Pitch angle δ of the gear [rad].
        pressure_angle: α_n [rad].
        spiral_angle: β_m [rad].
        pushed: +1 where the spiral pushes this gear away from the apex, −1 where it draws it in [-].

    Source: ISO 23509:2016, annex D: F_a = F_mt/cos β_m (tan α_n sin δ ± sin β_m cos δ),
        F_r = F_mt/cos β_m (tan α_n cos δ ∓ sin β_m sin δ).
    """
    scale, tangent = force / math.cos(spiral_angle), math.tan(pressure_angle)
    lean = pushed * math.sin(spiral_angle)
    axial = scale * (tangent * math.sin(cone) + lean * math.cos(cone))
    return axial, scale * (tangent * math.cos(cone) - lean * math.sin(cone))


def _limits(pair: BevelPair) -> list[Problem]:
    """What no bevel pair may be."""
    checks = (
        ("teeth", "", "at least 5 teeth each, the pinion first", 5 <= pair.teeth[0] <= pair.teeth[1]),
        ("outer_module", "m", "above 0", 0.0 < pair.outer_module < math.inf),
        ("face_width", "m", "above 0", pair.face_width > 0.0),
        ("spiral_angle", "rad", "from 0 to 45°", 0.0 <= pair.spiral_angle <= math.pi / 4.0),
        ("shaft_angle", "rad", "above 0 and below π", 0.0 < pair.shaft_angle < math.pi),
    )
    if all(good for *_, good in checks):
        return _too_wide(pair) + _undercut(pair)
    wrong = ((name, unit, getattr(pair, name), allowed) for name, unit, allowed, good in checks if not good)
    return [
        Problem(name, f"{f'{value:.4g} {unit}' if unit else value} given; must be {allowed}")
        for name, unit, value, allowed in wrong
    ]


def _too_wide(pair: BevelPair) -> list[Problem]:
    """Faces that reach too near to the apex."""
    limit = min(WIDEST * pair.outer_cone_distance, WIDEST_MODULES * pair.outer_module)
    if pair.face_width <= limit * (1.0 + 1e-9):
        return []
    message = (
        f"{1e3 * pair.face_width:.4g} mm given with a cone distance of {1e3 * pair.outer_cone_distance:.4g} mm; "
        f"use at most {1e3 * limit:.4g} mm (R_e/3 and 10 m_et)"
    )
    return [Problem("face_width", message)]


def _undercut(pair: BevelPair) -> list[Problem]:
    """Gears whose virtual pinion the cutter undercuts."""
    problems = []
    for gear, sign in ((0, 1.0), (1, -1.0)):
        virtual = pair.teeth[gear] / math.cos(pair.pitch_angles[gear])
        edge = pair.tooth.edge_radii[gear] * (1.0 - math.sin(pair.pressure_angle))
        straight = pair.tooth.dedendum - edge
        needed = least_profile_shift(
            virtual, straight, pressure_angle=pair.pressure_angle, helix_angle=pair.spiral_angle
        )
        shift = sign * pair.tooth.profile_shift
        if shift < needed - 1e-9 and virtual > 0.0:
            message = (
                f"x_hm{gear + 1} = {shift:.4g} undercuts {pair.teeth[gear]} teeth (virtual {virtual:.1f}); "
                f"needs {needed:.3f} or more teeth"
            )
            problems.append(Problem(f"{('pinion', 'wheel')[gear]}_shift", message))
    return problems


# ----------------------------------------------------------------------------------------------------------------------
# The blank of a bevel gear without offset by ISO 23509: tip and root cones, depths, spiral angles along the face.
# ----------------------------------------------------------------------------------------------------------------------


_SOURCE = "ISO 23509:2016"
_REACH = 1.001
"""How much larger than the least a cutter must be to end within the face [-]."""
Both = tuple[float, float]
"""Of pinion and wheel."""


@dataclass(frozen=True)
class BevelBlank:
    """Cones, depths and diameters of both gears of a pair."""

    root_angle_below: Annotated[Both, Quantity("angle"), Origin("θ_f", f"{_SOURCE}, annex C.5")]
    """Dedendum angles θ_f1, θ_f2 [rad]."""
    tip_angle: Annotated[Both, Quantity("angle"), Origin("δ_a = δ + θ_a, θ_a of the mate's θ_f", f"{_SOURCE}, eq. 140")]
    """Face angles δ_a1, δ_a2 [rad]."""
    root_angle: Annotated[Both, Quantity("angle"), Origin("δ_f = δ − θ_f", f"{_SOURCE}, eq. 141")]
    """Root angles δ_f1, δ_f2 [rad]."""
    outer_addendum: Annotated[Both, Quantity("length"), Origin("h_ae = h_am + b tan θ_a/2", f"{_SOURCE}, 7.7")]
    """At the outer end h_ae [m]."""
    outer_dedendum: Annotated[Both, Quantity("length"), Origin("h_fe = h_fm + b tan θ_f/2", f"{_SOURCE}, 7.7")]
    """At the outer end h_fe [m]."""
    outer_tip_diameter: Annotated[Both, Quantity("length"), Origin("d_ae = d_e + 2 h_ae cos δ", f"{_SOURCE}, 7.9")]
    """Diameters over the tips at the outer end d_ae [m]."""
    inner_tip_diameter: Annotated[Both, Quantity("length"), Origin("d_ai = d_i + 2 h_ai cos δ", f"{_SOURCE}, 7.9")]
    """At the inner end d_ai [m]."""
    thickness: Annotated[Both, Quantity("length"), Origin("s_mn = m_mn (π/2 + 2 (x_sm + x_hm tan α_n))", _SOURCE)]
    """Mean normal circular tooth thicknesses s_mn [m]."""
    outer_spiral_angle: Annotated[float, Quantity("angle"), Origin("β_e", f"{_SOURCE}, eq. 183")]
    """Spiral angle at the outer end β_e [rad]."""
    inner_spiral_angle: Annotated[float, Quantity("angle"), Origin("β_i", f"{_SOURCE}, eq. 184")]
    """Spiral angle at the inner end β_i [rad]."""


def bevel_blank(pair: BevelPair, cutter_radius: float | None = None) -> BevelBlank:
    """Return the blanks of a pair.

    Args:
        pair: The pair.
        cutter_radius: r_c0 of face-milled spiral teeth [m]; None: roots point to the apex and β is that of a cone.

    Source: ISO 23509:2016, clause 7 with a = 0: tips are parallel to the mate's root.
    Valid for: shafts at right angles, both ends within the cutter's reach.

    Raises:
        DesignError: A cutter smaller than `least_cutter_radius`.

    >>> pair = BevelPair((14, 39), 176.893e-3 / 39, 25.4e-3, math.radians(35.0))
    >>> round(math.degrees(bevel_blank(pair, 114.3e-3).outer_spiral_angle), 3)  # annex F.2: 36.846
    36.846
    """
    least = least_cutter_radius(pair)
    if cutter_radius is not None and pair.spiral_angle and cutter_radius < least:
        message = f"{1e3 * cutter_radius:.4g} mm given; ISO 23509, annex C.5 and eq. 183 ask for {1e3 * least:.4g} mm"
        raise DesignError([Problem("cutter_radius", message)])
    below = dedendum_angles(pair, cutter_radius)
    half, ends = 0.5 * pair.face_width, (pair.outer_cone_distance, pair.mean_cone_distance - 0.5 * pair.face_width)
    above = below[1], below[0]
    cosines = [math.cos(cone) for cone in pair.pitch_angles]
    rises, drops = [half * math.tan(angle) for angle in above], [half * math.tan(angle) for angle in below]
    outer = [height + rise for height, rise in zip(pair.addenda, rises, strict=True)]
    inner = [height - rise for height, rise in zip(pair.addenda, rises, strict=True)]
    small = [diameter * ends[1] / ends[0] for diameter in pair.outer_diameters]
    angles = [_spiral_at(pair, cutter_radius, end) for end in ends]
    return BevelBlank(
        below,
        (pair.pitch_angles[0] + above[0], pair.pitch_angles[1] + above[1]),
        (pair.pitch_angles[0] - below[0], pair.pitch_angles[1] - below[1]),
        (outer[0], outer[1]),
        (pair.dedenda[0] + drops[0], pair.dedenda[1] + drops[1]),
        (pair.outer_diameters[0] + 2.0 * outer[0] * cosines[0], pair.outer_diameters[1] + 2.0 * outer[1] * cosines[1]),
        (small[0] + 2.0 * inner[0] * cosines[0], small[1] + 2.0 * inner[1] * cosines[1]),
        (mean_thickness(pair, 0), mean_thickness(pair, 1)),
        angles[0],
        angles[1],
    )


def dedendum_angles(pair: BevelPair, cutter_radius: float | None = None) -> Both:
    """Return the dedendum angles θ_f1 and θ_f2 [rad].

    Args:
        pair: The pair.
        cutter_radius: r_c0 of face-milled spiral teeth, which are then cut duplex [m]; None: standard taper.

    Source: ISO 23509:2016, annex C.5: standard θ_f = atan(h_fm/R_m); duplex
        Σθ_f = 90° m_et/(R_e tan α_n cos β_m) (1 − R_m sin β_m/r_c0), θ_f1 = Σθ_f h_am2/h_mw.
    """
    cone = pair.mean_cone_distance
    if cutter_radius is None or pair.spiral_angle == 0.0:
        return math.atan(pair.dedenda[0] / cone), math.atan(pair.dedenda[1] / cone)
    least = cone * math.sin(pair.spiral_angle)
    total = 0.5 * math.pi * pair.outer_module * (1.0 - least / cutter_radius)
    total /= pair.outer_cone_distance * math.tan(pair.pressure_angle) * math.cos(pair.spiral_angle)
    part = pair.addenda[1] / sum(pair.addenda)
    return total * part, total * (1.0 - part)


def least_cutter_radius(pair: BevelPair) -> float:
    """Return the smallest cutter radius with which spiral teeth neither deepen towards the apex nor end too soon [m].

    Args:
        pair: The pair.

    Source: ISO 23509:2016, annex C.5: r_c0 ≥ R_m sin β_m; eqs 183 and 184: sin β_e < 1, sin β_i > −1.
    """
    mean, outer = pair.mean_cone_distance, pair.outer_cone_distance
    inner, lean = outer - pair.face_width, mean * math.sin(pair.spiral_angle)
    ends = (outer**2 - mean**2) / (outer - lean), (mean**2 - inner**2) / (inner + lean)
    return max(lean, *(_REACH * 0.5 * end for end in ends))


def mean_thickness(pair: BevelPair, gear: int) -> float:
    """Return the mean normal circular thickness of a tooth s_mn [m].

    Args:
        pair: The pair.
        gear: 0 for the pinion, 1 for the wheel.

    Source: ISO 23509:2016, s_mn = m_mn (π/2 + 2 (x_sm + x_hm tan α_n)).
    """
    shift = pair.tooth.profile_shift if gear == 0 else -pair.tooth.profile_shift
    widening = pair.tooth.thickness_shifts[gear] + shift * math.tan(pair.pressure_angle)
    return pair.mean_module * (0.5 * math.pi + 2.0 * widening)


def _spiral_at(pair: BevelPair, cutter_radius: float | None, cone: float) -> float:
    """Spiral angle at a cone distance (eqs 183 and 184); the mean one where no cutter says otherwise."""
    if cutter_radius is None or pair.spiral_angle == 0.0:
        return pair.spiral_angle
    mean = pair.mean_cone_distance
    sine = 2.0 * mean * cutter_radius * math.sin(pair.spiral_angle) - mean**2 + cone**2
    return math.asin(sine / (2.0 * cone * cutter_radius))


# ----------------------------------------------------------------------------------------------------------------------
# The outline of a bevel gear's teeth in its axial plane, ended by back cones square to the pitch cone.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class BevelProfile:
    """Corners of a bevel tooth: distance along the axis, away from the apex, from the mean point, and radius."""

    small: tuple[complex, complex]
    """Tip and pitch point of the small end [m]."""
    large: tuple[complex, complex]
    """Tip and pitch point of the large end [m]."""
    roots: tuple[complex, complex]
    """Root at the small and the large end [m]."""
    apex: float
    """Where the apex lies along the axis, negative [m]."""

    def scaled(self, factor: float) -> BevelProfile:
        """Return the same in another unit or size.

        Args:
            factor: New over old lengths [-].
        """
        small, large, roots = ((factor * pair[0], factor * pair[1]) for pair in (self.small, self.large, self.roots))
        return BevelProfile(small, large, roots, factor * self.apex)


def face_and_root(pair: BevelPair, side: int) -> tuple[float, float]:
    """Return face and root cone angle of a bevel gear whose teeth taper towards the apex [rad].

    Args:
        pair: The pair.
        side: 0 for the pinion, 1 for the wheel.

    Source: ISO 23509:2016, standard depth taper: δ_a = δ + atan(h_am/R_m), δ_f = δ − atan(h_fm/R_m).
    """
    pitch, distance = pair.pitch_angles[side], pair.mean_cone_distance
    return pitch + math.atan(pair.addenda[side] / distance), pitch - math.atan(pair.dedenda[side] / distance)


def bevel_profile(pair: BevelPair, side: int) -> BevelProfile:
    """Return the corners of a bevel gear's teeth.

    Args:
        pair: The pair.
        side: 0 for the pinion, 1 for the wheel.

    Source: ISO 23509:2016, cones about one apex; back cones square to the pitch cone at R_m ± b/2.
    """
    pitch, mean = pair.pitch_angles[side], pair.mean_cone_distance
    face, root = face_and_root(pair, side)
    shift = mean * math.cos(pitch)

    def corner(distance: float, angle: float) -> complex:
        reach = distance / math.cos(angle - pitch)
        return complex(reach * math.cos(angle) - shift, reach * math.sin(angle))

    near, far = (mean + sign * pair.face_width / 2.0 for sign in (-1.0, 1.0))
    return BevelProfile(
        small=(corner(near, face), corner(near, pitch)),
        large=(corner(far, face), corner(far, pitch)),
        roots=(corner(near, root), corner(far, root)),
        apex=-shift,
    )


# ----------------------------------------------------------------------------------------------------------------------
# Teeth of a bevel gear by Tredgold's virtual gear, the body behind them, and what both fill.
#
# A gear stands with its axis along z, away from its mate: the mean point of its face at z = 0, tips towards −z.
# ----------------------------------------------------------------------------------------------------------------------


RIM = 1.2
"""Metal behind the roots over the depth of the teeth [-] (AGMA 2001-D04, backup ratio without loss of strength)."""
WEB = 0.3
"""Web over face width [-], an assumption where no web is sized."""
_THINNEST, _WHOLE, _HALVINGS = 0.15, 2.0, 24
"""Webs over face widths between which one is looked for, and how often their distance is halved [-]."""


def virtual_tooth(pair: BevelPair, side: int) -> TransverseTooth:
    """Return the tooth of the virtual cylindrical gear at the mean cone.

    Args:
        pair: The pair.
        side: 0 for the pinion, 1 for the wheel.

    Source: Tredgold's virtual gear z/cos δ of the back cone.
    """
    tooth, shift = pair.tooth, pair.tooth.profile_shift * (1.0 if side == 0 else -1.0)
    rack = BasicRack(pair.pressure_angle, tooth.addendum, tooth.dedendum, tooth.edge_radii[side])
    teeth = pair.teeth[side] / math.cos(pair.pitch_angles[side])
    return TransverseTooth(teeth, pair.mean_module, pair.spiral_angle, shift, rack=rack)


def bevel_form(pair: BevelPair, side: int, *, fillet: int, flank: int) -> tuple[Floats, Floats]:
    """Return one side of a tooth of the virtual cylindrical gear at the mean cone.

    Args:
        pair: The pair.
        side: 0 for the pinion, 1 for the wheel.
        fillet: Points on the fillet [-].
        flank: Points on the flank [-].

    Returns:
        Radii [m] and half angles [rad] from root to tip.

    Source: as `virtual_tooth` and `gearwright.parts.gears.tooth_form`.
    """
    return transverse_form(virtual_tooth(pair, side), fillet=fillet, flank=flank)


def bevel_way(
    pair: BevelPair, side: int, bore: float, web: float = WEB, seat: SeatHub | None = None, *, dish: float = 0.0
) -> list[tuple[float, float]]:
    """Return the way behind the teeth from the large end to the small one, z and radius [m].

    Args:
        pair: The pair.
        side: 0 for the pinion, 1 for the wheel.
        bore: Radius of what the gear sits on [m].
        web: Thickness of the plate between rim and hub over the face width [-].
        seat: The hub where its seat is sized.
        dish: By how much the plate leans away from the apex towards the hub [-].

    Source: cones about the apex, ISO 23509:2016; rim 1.2 times the depth of the teeth behind the roots (AGMA 2001-D04).
    """
    toe, heel = _rim(pair, side)
    return way_behind(toe, heel, bore, web=web * pair.face_width, seat=seat, dish=dish)


def bevel_dishes(
    pair: BevelPair, side: int, bore: float, web: float, seat: SeatHub | None
) -> tuple[float, float] | None:
    """Return the least and the largest dish with which the plate meets rim and hub with all of its thickness [-].

    Args:
        pair: The pair.
        side: 0 for the pinion, 1 for the wheel.
        bore: Radius of what the gear sits on [m].
        web: Thickness of the plate between rim and hub over the face width [-].
        seat: The hub where its seat is sized.

    Returns:
        None where rim and hub meet, so that there is no plate.

    Source: as `bevel_way`.
    """
    toe, heel = _rim(pair, side)
    return dishes_behind(toe, heel, bore, web=web * pair.face_width, seat=seat)


def _rim(pair: BevelPair, side: int) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return where the rim ends under the inner and the outer end of the teeth, z and radius [m]."""
    tooth, mean = virtual_tooth(pair, side), pair.mean_cone_distance
    back = tooth.root_radius - RIM * (tooth.tip_radius - tooth.root_radius) - tooth.pitch_radius
    inner, outer = (_under(pair, side, far, back * far / mean) for far in _ends(pair))
    return inner, outer


def bevel_volume(
    pair: BevelPair, side: int, bore: float, web: float = WEB, seat: SeatHub | None = None, *, dish: float = 0.0
) -> float:
    """Return what a bevel gear fills: its teeth, and the body under their roots [m³].

    Args:
        pair: The pair.
        side: 0 for the pinion, 1 for the wheel.
        bore: Radius of what the gear sits on [m].
        web: Thickness of the plate between rim and hub over the face width [-].
        seat: The hub where its seat is sized.
        dish: By how much the plate leans away from the apex towards the hub [-].

    Source: teeth that taper to the apex are a pyramid's frustum, V = z A (R_e³ − R_i³)/(3 R_m²), as every point of a
        back cone is R from the apex along its normal; frusta of cones behind them.
    """
    return _crown(pair, side) + _under_roots(pair, side, bore, web, seat, dish=dish)


def _crown(pair: BevelPair, side: int) -> float:
    """Return what the teeth of a bevel gear fill [m³]."""
    tooth, mean, (inner, outer) = virtual_tooth(pair, side), pair.mean_cone_distance, _ends(pair)
    return pair.teeth[side] * outline_area(tooth) * (outer**3 - inner**3) / (3.0 * mean**2)


def _under_roots(
    pair: BevelPair, side: int, bore: float, web: float, seat: SeatHub | None, *, dish: float = 0.0
) -> float:
    """Return what the body under the roots of a bevel gear fills [m³]."""
    tooth, mean = virtual_tooth(pair, side), pair.mean_cone_distance
    root = (tooth.root_radius - tooth.pitch_radius) / mean
    roots = [_under(pair, side, far, root * far) for far in _ends(pair)]
    return revolved_volume([*bevel_way(pair, side, bore, web, seat, dish=dish), *roots])


def lightened_web(pair: BevelPair, side: int, bore: float, share: float, seat: SeatHub | None = None) -> float:
    """Return the web, over the face width, with which a gear fills a share of what it fills without a web [-].

    Args:
        pair: The pair.
        side: 0 for the pinion, 1 for the wheel.
        bore: Radius of what the gear sits on [m].
        share: Of the volume with a plate as thick as the rim is long [-]; the nearest that a web gives.
        seat: The hub where its seat is sized.

    Source: `bevel_volume` by bisection, of a straight web, which a dished one weighs as much as but for its ends.
    """
    low, high, crown = _THINNEST, _WHOLE, _crown(pair, side)
    target = share * (crown + _under_roots(pair, side, bore, high, seat))
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if crown + _under_roots(pair, side, bore, middle, seat) > target else (middle, high)
    return 0.5 * (low + high)


def _ends(pair: BevelPair) -> tuple[float, float]:
    """Return the cone distances of both ends of the face [m]."""
    return pair.mean_cone_distance - pair.face_width / 2.0, pair.mean_cone_distance + pair.face_width / 2.0


def _under(pair: BevelPair, side: int, far: float, height: float) -> tuple[float, float]:
    """Return z and radius of a point on a back cone, so high above the pitch cone."""
    cone = pair.pitch_angles[side]
    along = (far - pair.mean_cone_distance) * math.cos(cone) - height * math.sin(cone)
    return along, far * math.sin(cone) + height * math.cos(cone)
