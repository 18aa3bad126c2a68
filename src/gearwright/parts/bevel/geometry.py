"""Straight and spiral bevel gears without offset: cones, mean cone, forces by hand and rotation.

Lengths are those of the mean cone (middle of the face) unless they are called outer. Axial forces are positive away
from the apex, radial forces positive towards the gear's own axis.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum
from functools import cached_property
from typing import Annotated

from gearwright.errors import Problem, refuse
from gearwright.parts.gears import least_profile_shift
from gearwright.parts.iso6336 import Value
from gearwright.units import Origin, Quantity

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
