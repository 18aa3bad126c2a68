"""The geometry of gears as standards see it, from a stage's rules: cylindrical meshes, bevel pairs by their mean cone.

A bevel gear is carried by its mean cone: module m_mn, helix angle β_m, diameter d_m = m_mn z / cos β_m.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from gearwright.arrays import Floats
from gearwright.parts.bevel import BevelPair, BevelTooth, cone_forces
from gearwright.parts.gears import least_teeth
from gearwright.parts.iso6336 import MeshGeometry, ShaperCutter, Value, shifted_mesh
from gearwright.sizing.rating.rules import Rating
from gearwright.spec.design import working_angle


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
        teeth,
        outer,
        face_width,
        spiral_angle=rating.helix_angle,
        pressure_angle=rating.rules.pressure_angle,
        tooth=BevelTooth(profile_shift=rating.shifts.gears[0].profile_shift),
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

    Source: ISO 21771:2007, z_min = 2 (h* − x_hm1) cos β / sin² α_t, with the cutter of `BevelTooth`.
    """
    tool, angle = BevelTooth(), rating.rules.pressure_angle
    straight = tool.dedendum - tool.edge_radii[0] * (1.0 - math.sin(angle)) - rating.shifts.gears[0].profile_shift
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
        rating: Resolved rules: angles and profile shifts.
        internal: The second gear is a ring.

    Source: ISO 21771:2007.
    """
    pinion, wheel, size, width = np.broadcast_arrays(
        *(np.asarray(numbers, dtype=float) for numbers in (*teeth, module, face_width))
    )
    mesh = shifted_mesh(
        (pinion, -wheel if internal else wheel),
        rating.shifts.mesh(internal=internal),
        rating.shifts.centre,
        pressure_angle=rating.rules.pressure_angle,
        helix_angle=rating.helix_angle,
        module=size,
        face_width=width,
    )
    return _shaped(mesh, rating) if internal else mesh


def _shaped(mesh: MeshGeometry, rating: Rating) -> MeshGeometry:
    """Return a mesh whose ring is cut by the stage's shaper cutter, if its rules have one."""
    tool = rating.rules.iso6336.ring_cutter
    if tool is None:
        return mesh
    per_tooth = mesh.virtual_teeth[1] / mesh.teeth[1]
    cutter = ShaperCutter(tool.teeth * per_tooth, tool.shift)
    ring = replace(mesh.proportions[1], fillet_radius=tool.tip_radius, cutter=cutter)
    return replace(mesh, proportions=(mesh.proportions[0], ring))


def working_radii(first: float, second: float, rating: Rating, *, internal: bool, module: float) -> tuple[float, float]:
    """Return the radii of the working pitch circles r_w of a cylindrical mesh [m].

    Args:
        first: z_1 [-].
        second: z_2, positive [-].
        rating: Resolved rules.
        internal: The second gear is a ring.
        module: m_n [m].

    Source: ISO 21771:2007, r_w1 = a_w z_1/(z_1 + z_2), with z_2 negative inside a ring; r where nothing is shifted.
    """
    if rating.shifts.centre is None:
        scale = module / (2.0 * math.cos(rating.helix_angle))
        return first * scale, second * scale
    scale = rating.shifts.centre * module / (second - first if internal else second + first)
    return first * scale, second * scale


def push_angle(first: float, second: float, rating: Rating, *, internal: bool) -> float:
    """Return the working transverse pressure angle of a cylindrical mesh, at which its teeth push α_wt [rad].

    Args:
        first: z_1 [-].
        second: z_2, positive [-].
        rating: Resolved rules.
        internal: The second gear is a ring.

    Source: ISO 21771:2007, cos α_wt = a cos α_t/a_w.
    """
    total = int(first - second if internal else first + second)
    return working_angle(rating.rules, total, rating.shifts, rating.helix_angle)
