"""Gears as ISO 6336 and ISO 10300 see them: geometry, steel, quality and duty from a stage's rules.

A bevel gear is carried by its mean cone: module m_mn, helix angle β_m, diameter d_m = m_mn z / cos β_m.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from gearwright.catalogue import rated_steel
from gearwright.parts.bevel import (
    BOTH_OVERHUNG,
    ONE_OVERHUNG,
    STRADDLE,
    WIDEST_MODULES,
    BevelDuty,
    BevelPair,
    BevelSurfaces,
    BevelTooth,
    bevel_pitch_tolerance,
    cone_forces,
)
from gearwright.parts.gears import least_teeth
from gearwright.parts.iso6336 import (
    CENTRED,
    CORRECTED_AND_CROWNED,
    CROWNED,
    UNMODIFIED,
    GearSteel,
    MeshDuty,
    MeshGeometry,
    MeshQuality,
    PinionShaft,
    ToothProportions,
    Value,
)
from gearwright.sizing.rating.rules import Array, Rating

USUAL_BEVEL_WIDTH = 0.30
"""Face width of bevel gears over the outer cone distance b/R_e [-] (ISO 23509:2016, annex B)."""
IDLER_MEAN_STRESS = 0.7
"""Y_M of gears that are loaded on both flanks [-] (ISO 6336-3:2019, annex B)."""
_HELIX = {"none": UNMODIFIED, "crowning": CROWNED, "corrected": CORRECTED_AND_CROWNED}
_MOUNTING = {"straddle": STRADDLE, "one-overhung": ONE_OVERHUNG, "both-overhung": BOTH_OVERHUNG}
_SQUARE_MM = 1e-6


def stage_width_ratio(rating: Rating, small: ArrayLike, large: ArrayLike) -> Array:
    """Return λ = b/m_n of a stage [-]: given, or the widest that the rules of its rating allow.

    Args:
        rating: Resolved rules.
        small: Teeth of pinion or sun [-].
        large: Teeth of wheel or planet [-].

    Source: b ≤ 20 m_n and b ≤ 0.8 d_1 unless the design says otherwise; bevel gears b = min(0.30 R_e, 10 m_et)
        (ISO 23509:2016, annex B).
    """
    first, second = np.broadcast_arrays(np.asarray(small, dtype=float), np.asarray(large, dtype=float))
    if rating.given_width_ratio is not None:
        return np.full(first.shape, rating.given_width_ratio)
    if rating.kind == "bevel":
        cones = cone_ratio(first, second)
        share = np.minimum(USUAL_BEVEL_WIDTH, WIDEST_MODULES / cones)
        return np.asarray(share * cones / (math.cos(rating.helix_angle) * (1.0 - 0.5 * share)))
    rules = rating.rules.iso6336
    return np.minimum(rules.widest_modules, rules.widest_diameters * first / math.cos(rating.helix_angle))


def cone_ratio(first: ArrayLike, second: ArrayLike) -> Array:
    """Return R_e/m_et of a bevel pair on square axes [-].

    Args:
        first: z_1 [-].
        second: z_2 [-].

    Source: ISO 23509:2016, R_e = d_e1/(2 sin δ_1), hence √(z_1² + z_2²)/2.
    """
    return np.asarray(0.5 * np.hypot(first, second))


def bevel_pair(teeth: tuple[int, int], module: float, face_width: float, rating: Rating) -> BevelPair:
    """Return a bevel pair from its mean normal module.

    Args:
        teeth: z_1, z_2 [-].
        module: Mean normal module m_mn [m].
        face_width: b [m].
        rating: Resolved rules.

    Source: ISO 23509:2016: m_mn = m_et cos β_m (1 − b/(2 R_e)), hence m_et = m_mn/cos β_m + b/(2 R_e/m_et).

    Raises:
        DesignError: A face that reaches too near to the apex, undercut teeth.
    """
    outer = module / math.cos(rating.helix_angle) + face_width / (2.0 * float(cone_ratio(*teeth)))
    return BevelPair(
        teeth, outer, face_width, spiral_angle=rating.helix_angle, pressure_angle=rating.rules.pressure_angle
    )


def bevel_push(rating: Rating, force: Value, slope: float, *, pushed: Value = 1.0) -> tuple[Value, Value]:
    """Return the axial force away from the apex and the radial force towards its axis on one gear of a bevel mesh [N].

    Args:
        rating: Resolved rules: pressure and spiral angle.
        force: Tangential force at the mean cone [N].
        slope: Its teeth over those of its mate, tan δ on square axes [-].
        pushed: +1 where the spiral pushes this gear away from the apex, −1 where it draws it in [-].
    """
    return cone_forces(
        force,
        math.atan(slope),
        pressure_angle=rating.rules.pressure_angle,
        spiral_angle=rating.helix_angle,
        pushed=pushed,
    )


def fewest_virtual_teeth(rating: Rating) -> float:
    """Return the virtual tooth number z/cos δ below which the cutter undercuts a bevel pinion [-].

    Args:
        rating: Resolved rules: pressure and spiral angle.

    Source: ISO 21771:2007, z_min = 2 h* cos β / sin² α_t, with the cutter of `BevelTooth`.
    """
    tool, angle = BevelTooth(), rating.rules.pressure_angle
    straight = tool.dedendum - tool.edge_radii[0] * (1.0 - math.sin(angle))
    return least_teeth(straight, pressure_angle=angle, helix_angle=rating.helix_angle)


def mean_module(teeth: tuple[int, int], outer_module: float, face_width: float, rating: Rating) -> float:
    """Return the mean normal module m_mn of a bevel pair [m].

    Args:
        teeth: z_1, z_2 [-].
        outer_module: Outer transverse module m_et [m].
        face_width: b [m].
        rating: Resolved rules.

    Source: ISO 23509:2016, m_mn = m_et cos β_m R_m/R_e.
    """
    return math.cos(rating.helix_angle) * (outer_module - face_width / (2.0 * float(cone_ratio(*teeth))))


def cylindrical_mesh(
    teeth: tuple[ArrayLike, ArrayLike],
    module: ArrayLike,
    face_width: ArrayLike,
    rating: Rating,
    *,
    internal: bool = False,
) -> MeshGeometry:
    """Return one cylindrical mesh, or an array of them, with the basic rack 1.25/0.38 of ISO 53, profile A.

    Args:
        teeth: z_1, z_2, both positive [-].
        module: m_n [m].
        face_width: b [m].
        rating: Resolved rules: angles, and the profile shift x of pinions, −x of their wheels.
        internal: The second gear is a ring.

    Source: ISO 21771:2007.
    """
    side = -1.0 if internal else 1.0
    pinion, wheel, size, width = np.broadcast_arrays(
        *(np.asarray(numbers, dtype=float) for numbers in (*teeth, module, face_width))
    )
    shift = 0.0 if internal else rating.rules.profile_shift
    first, second = (0.5 * teeth_of_gear * size / math.cos(rating.helix_angle) for teeth_of_gear in (pinion, wheel))
    return MeshGeometry(
        teeth=(pinion, side * wheel),
        module=size,
        face_width=width,
        centre_distance=second + side * first,
        tip_radii=(first + (1.0 + shift) * size, second + side * (1.0 - shift) * size),
        helix_angle=rating.helix_angle,
        pressure_angle=rating.rules.pressure_angle,
        proportions=(ToothProportions(profile_shift=shift), ToothProportions(profile_shift=-shift)),
    )


def steel_of(rating: Rating) -> GearSteel:
    """Return the steel of a stage as ISO 6336 rates it.

    Args:
        rating: Resolved rules.

    Raises:
        DesignError: Unknown class or grade, or a hardness outside the grade's range.
    """
    rules = rating.rules.iso6336
    return rated_steel(rating.material, rules.steel, rules.grade, hardness=rules.hardness_hv)


def quality_of(rating: Rating, *, idlers: tuple[bool, bool], shaft: PinionShaft = CENTRED) -> MeshQuality:
    """Return how the flanks of a stage are made and mounted.

    Args:
        rating: Resolved rules.
        idlers: Which of the two gears is loaded on both flanks.
        shaft: Where the pinion sits on its shaft.
    """
    rules = rating.rules.iso6336
    means = [IDLER_MEAN_STRESS if idler else 1.0 for idler in idlers]
    return MeshQuality(
        grade=rules.tolerance_class,
        flank_roughness=rules.flank_roughness,
        root_roughness=rules.root_roughness,
        helix=_HELIX[rules.helix_modification],
        shaft=shaft,
        viscosity=rules.oil_viscosity * _SQUARE_MM,
        mean_stresses=(means[0], means[1]),
    )


def duty_of(
    rating: Rating, torque: ArrayLike, speed: ArrayLike, *, life: ArrayLike, passes: tuple[float, float]
) -> MeshDuty:
    """Return what a cylindrical mesh carries.

    Args:
        rating: Resolved rules.
        torque: On the first gear, of one mesh, load factor included [N m].
        speed: Of the first gear against the carrier [rad/s].
        life: Time under that load [s].
        passes: Mates that a tooth of each gear meets in a turn [-].
    """
    return MeshDuty(
        np.asarray(torque, dtype=float) / rating.load_factor,
        np.asarray(speed, dtype=float),
        np.asarray(life, dtype=float),
        application_factor=rating.service.application_factor,
        mesh_load_factor=rating.load_factor,
        meshes_per_turn=passes,
    )


def bevel_duty(rating: Rating, pair: BevelPair, torque: float, speed: float) -> BevelDuty:
    """Return what a bevel mesh carries.

    Args:
        rating: Resolved rules.
        pair: Its geometry.
        torque: On the pinion, of one mesh, load factor included [N m].
        speed: Of the pinion [rad/s].
    """
    rules = rating.rules.iso6336
    return BevelDuty(
        torque,
        speed,
        bevel_pitch_tolerance(pair.mean_diameters[1], pair.mean_module, rules.tolerance_class),
        application_factor=rating.service.application_factor,
        mounting=_MOUNTING[rules.mounting],
        density=rating.material.density,
    )


def bevel_surfaces(rating: Rating) -> BevelSurfaces:
    """Return flanks, roots and oil of a bevel stage.

    Args:
        rating: Resolved rules.
    """
    rules = rating.rules.iso6336
    return BevelSurfaces(rules.flank_roughness, rules.root_roughness, rules.oil_viscosity * _SQUARE_MM)
