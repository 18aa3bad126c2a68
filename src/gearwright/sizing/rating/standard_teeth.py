"""The geometry of gears as standards see it, from a stage's rules: cylindrical meshes, bevel pairs by their mean cone.

A bevel gear is carried by its mean cone: module m_mn, helix angle β_m, diameter d_m = m_mn z / cos β_m.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from gearwright.arrays import Floats
from gearwright.parts.bevel import BevelPair, BevelTooth, cone_forces
from gearwright.parts.gears import least_teeth
from gearwright.parts.iso6336 import MeshGeometry, ToothProportions, Value
from gearwright.sizing.rating.rules import Rating


def widest_ratio(rating: Rating, small: Floats) -> Floats:
    """Return λ = b/m_n of the widest cylindrical gears that the rules of a stage allow [-].

    Args:
        rating: Resolved rules of a method with rules on proportions.
        small: Teeth of pinion or sun [-].

    Source: b ≤ 20 m_n and b ≤ 0.8 d_1 unless the design says otherwise.
    """
    rules = rating.proportions
    assert rules is not None
    return np.minimum(rules.widest_modules, rules.widest_diameters * small / math.cos(rating.helix_angle))


def cone_ratio(first: ArrayLike, second: ArrayLike) -> Floats:
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
