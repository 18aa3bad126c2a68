"""Gear geometry for the rating standards, rim thickness, and required modules and face widths."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from gearwright.base import Floats, Problem, Role
from gearwright.parts.bevel_geometry import BevelPair, BevelTooth, cone_forces
from gearwright.parts.gears import ISO53_A, ToothShift, least_teeth
from gearwright.parts.iso6336 import MeshGeometry, ShaperCutter, Value, as_value, rim_factor, shifted_mesh
from gearwright.sizing.rating.protocol import Rating
from gearwright.spec.design import GearRules, working_angle

# ----------------------------------------------------------------------------------------------------------------------
# The geometry of gears as standards see it, from a stage's rules: cylindrical meshes, bevel pairs by their mean cone.
#
# A bevel gear is carried by its mean cone: module m_mn, helix angle β_m, diameter d_m = m_mn z / cos β_m.
# ----------------------------------------------------------------------------------------------------------------------


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


def mean_module(teeth: tuple[int, int], outer_module: float, face_width: Any, rating: Rating) -> Any:
    """Return the mean normal module m_mn of a bevel pair [m].

    Args:
        teeth: z_1, z_2 [-].
        outer_module: Outer transverse module m_et [m].
        face_width: b, a number or an array [m].
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
    return cylindrical_teeth(teeth, rating, internal=internal).of_size(as_value(module), as_value(face_width))


def cylindrical_teeth(teeth: tuple[ArrayLike, ArrayLike], rating: Rating, *, internal: bool) -> MeshGeometry:
    """Return the teeth of one cylindrical mesh, or of an array of them, with a module of 1 m.

    Args:
        teeth: z_1, z_2, both positive [-].
        rating: Resolved rules: angles and profile shifts.
        internal: The second gear is a ring.

    Source: ISO 21771:2007.
    """
    first, second = teeth
    tool = rating.rules.iso6336.ring_cutter if internal else None
    form = _Form(
        internal,
        rating.shifts.mesh(internal=internal),
        rating.shifts.centre,
        (rating.rules.pressure_angle, rating.helix_angle),
        None if tool is None else (tool.teeth, tool.shift, tool.tip_radius),
    )
    return (_teeth_of_one if type(first) is type(second) is int else _teeth)(first, second, form)


class _Form(NamedTuple):
    """What the teeth of a mesh are like, beside their numbers."""

    internal: bool
    shifts: tuple[ToothShift, ToothShift]
    centre: float | None
    angles: tuple[float, float]
    """α_n, β [rad]."""
    cutter: tuple[int, float, float] | None
    """Of the ring: z_0, x_0 [-] and the radius of its tip over the module [-]."""


def _teeth(first: ArrayLike, second: ArrayLike, form: _Form) -> MeshGeometry:
    pinion, wheel = as_value(first), as_value(second)
    mesh = shifted_mesh(
        (pinion, -wheel if form.internal else wheel),
        form.shifts,
        form.centre,
        pressure_angle=form.angles[0],
        helix_angle=form.angles[1],
    )
    if form.cutter is None:
        return mesh
    teeth, shift, tip_radius = form.cutter
    per_tooth = mesh.virtual_teeth[1] / mesh.teeth[1]
    ring = replace(mesh.proportions[1], fillet_radius=tip_radius, cutter=ShaperCutter(teeth * per_tooth, shift))
    return replace(mesh, proportions=(mesh.proportions[0], ring))


_teeth_of_one = lru_cache(maxsize=1024)(_teeth)
"""Of one mesh, which many sizes have."""


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


# ----------------------------------------------------------------------------------------------------------------------
# Rims of gears as their design states them: rings by their wall, wheels and planets where a rim is given.
# ----------------------------------------------------------------------------------------------------------------------


RIMMED = (Role.WHEEL, Role.PLANET)
"""Gears whose rim `rim_ratio` states."""
LEAST_RING = 1.75
"""Rim of rings that the standard rates, over the module [-]."""
BACKUP = 1.2
"""Rim below the roots over the tooth height where the design says nothing [-]: the least without loss of strength,
AGMA 2001-D04, rim thickness factor."""
THINNEST_RIM = 0.5
"""Rim below the roots over the tooth height, at least [-]: where Y_B ends, ISO 6336-3:2019, clause 9."""
RACEWAY = 0.66
"""Raceway of a planet's bearing in the planet over its pitch diameter where no bore is given [-], an estimate."""
TOOTH_HEIGHT = ISO53_A.addendum + ISO53_A.dedendum
"""Tooth height h_t of ISO 53, profile A, over the module [-]."""


def rim_below_roots(rating: Rating, role: Role, *, internal: bool = False) -> float | None:
    """Return the rim below the roots of a gear over its module s_R/m_n [-]; None where its body is solid.

    Args:
        rating: Resolved rules.
        role: Of the gear.
        internal: Whether it is a ring.

    Source: ISO 53, profile A: roots lie 1.25 m_n inside the pitch circle, of rings outside it.
    """
    rules = rating.rules
    if internal:
        return rules.rim_thickness_ratio - ISO53_A.dedendum
    return None if role not in RIMMED or rules.rim_ratio is None else rules.rim_ratio * TOOTH_HEIGHT


def body_inside(rating: Rating, role: Role, teeth: Value, module: Value, *, internal: bool = False) -> Value | None:
    """Return the inner diameter of a gear's body or rim, of a ring its outer one, where the design gives none [m].

    Pinions and suns count as solid: what their shafts add in mass they add in stiffness. Wheels have a rim of
    `rim_ratio`, or of 1.2 tooth heights over their web; planets the raceway of a bearing, at most to such a rim.

    Args:
        rating: Resolved rules.
        role: Of the gear.
        teeth: z, positive [-].
        module: m_n [m].
        internal: Whether it is a ring.

    Source: ISO 6336-1:2006, clause 6.5.9 (d_i of the rim); 0.66 d by bearings of planets, an estimate.
    """
    rules = rating.rules
    pitch = np.asarray(teeth) * module / math.cos(rating.helix_angle)
    if internal:
        return as_value(pitch + 2.0 * rules.rim_thickness_ratio * module)
    if role not in RIMMED or rating.kind == "face":
        return None
    if role is Role.WHEEL and rules.rim_ratio is None and rules.web_thickness_ratio >= 1.0:
        return None
    rim = BACKUP if rules.rim_ratio is None else rules.rim_ratio
    inside = np.maximum(pitch - 2.0 * (ISO53_A.dedendum + rim * TOOTH_HEIGHT) * module, 0.0)
    if role is Role.PLANET and rules.rim_ratio is None:
        return as_value(np.minimum(inside, RACEWAY * pitch))
    return as_value(inside)


def rim_factors(rating: Rating, roles: tuple[Role, Role], *, internal: bool) -> tuple[float, float]:
    """Return the rim thickness factors Y_B of both gears of a mesh [-].

    Args:
        rating: Resolved rules.
        roles: What both gears are in their stage.
        internal: Whether the second gear is a ring.

    Source: ISO 6336-3:2006, clause 9.

    Raises:
        DesignError: Rims that are too thin for the standard, which `ring_problems` names before.
    """
    first, second = (_factor(rating, role, internal=internal and gear == 1) for gear, role in enumerate(roles))
    return first, second


def ring_problems(rating: Rating) -> Iterator[Problem]:
    """Yield a rim of a ring that is too thin for the standard, by the key that states it.

    Args:
        rating: Resolved rules of a stage with a ring.

    Source: ISO 6336-3:2006, clause 9.
    """
    rim = rim_below_roots(rating, Role.RING, internal=True)
    if rim is not None and rim <= LEAST_RING:
        given, least = rating.rules.rim_thickness_ratio, LEAST_RING + ISO53_A.dedendum
        why = f"{given:g} leaves a rim that ISO 6336-3, clause 9 does not rate; give more than {least:.4g}"
        yield Problem("gears.rim_thickness_ratio", why)


def _factor(rating: Rating, role: Role, *, internal: bool) -> float:
    """Y_B of one gear."""
    if (rim := rim_below_roots(rating, role, internal=internal)) is None:
        return 1.0
    return _rim_factor(rim, internal=internal)


@lru_cache(maxsize=256)
def _rim_factor(rim: float, *, internal: bool) -> float:
    """Y_B by the rim below the roots over the module, which all gears of a rule have."""
    return float(np.asarray(rim_factor(rim, TOOTH_HEIGHT, 1.0, internal=internal)))


# ----------------------------------------------------------------------------------------------------------------------
# What gears as they are made weigh over discs and annuli, before anything is known that they sit on.
# ----------------------------------------------------------------------------------------------------------------------


RIM = 1.25 + 1.2 * 2.25
"""Wall of a gear from its pitch circle to the inside of its rim, over the module [-]: the tooth's root, and a backing
of 1.2 tooth heights (AGMA 2001-D04)."""
AROUND = 1.8
"""Shafts and carriers of compound sets over the cube of the diameter of the largest gear [kg/m³], to rank their sizes;
fitted to sizes of sets at random."""
BEARING_GAP = 0.5
"""Part of the room inside a planet's rim that neither its bearing nor its pin fills [-], an estimate."""


def made_share(role: Role, teeth: int, rules: GearRules) -> float:
    """Return what a gear as it is made weighs over its disc or annulus, by the estimate of the search [-].

    Args:
        role: Of the gear.
        teeth: Its number [-].
        rules: Of its stage.
    """
    room = max(teeth - 2.0 * RIM, 0.0)
    inside = room * room / (teeth * teeth)
    if role is Role.PLANET:
        return 1.0 - BEARING_GAP * inside
    webbed = role is Role.WHEEL and rules.web_ratio == 1.0
    return 1.0 - (1.0 - rules.web_thickness_ratio) * inside if webbed else 1.0


# ----------------------------------------------------------------------------------------------------------------------
# How large gears are made that a standard rates: standard modules, face widths, what a load spectrum asks of them.
#
# The sizing asks it once for every stage, the search for teeth once for every pair of tooth numbers of bevel gears.
# ----------------------------------------------------------------------------------------------------------------------


STANDARD_MODULES = (
    1.0, 1.125, 1.25, 1.375, 1.5, 1.75, 2.0, 2.25, 2.5, 2.75, 3.0, 3.5, 4.0, 4.5, 5.0, 5.5, 6.0, 7.0, 8.0, 9.0, 10.0,
    11.0, 12.0, 14.0, 16.0, 18.0, 20.0, 22.0, 25.0, 28.0, 32.0, 36.0, 40.0, 45.0, 50.0,
)  # fmt: skip
"""Modules of series I and II [mm] (ISO 54:1996; ISO 678:1996 for bevel gears, outer transverse)."""
_MM = 1e-3
CORRECTIONS = 6
"""Corrections of a module under the load spectrum; each closes most of what is left."""
LARGER = (1.02, 1.06, 1.18)
"""By what a module is tried larger that is not rounded; a standard one, by as many steps [-]."""
JUST = 1e-6
"""Part by which a gap may miss: what an exact module leaves of rounding and of its last correction [-]."""
NEXT = 1e-6
"""Part by which more is asked than a module to have the next one rounded [-]."""
LEFT = 2.0
"""How far later corrections may lead, over the last one [-]: twice as far as where each closed but half."""

Gap = Callable[[float, float], float]
"""Module and face width [m] -> by what factor the loads of a stage could grow [-]."""


def next_standard(needed: float) -> float:
    """Return the next standard module [m]; above all of them the needed one.

    Args:
        needed: Module that meshes ask for [m].
    """
    return next((standard * _MM for standard in STANDARD_MODULES if standard * _MM >= needed * (1.0 - 1e-9)), needed)


def under_spectrum(module: float, ratio: float, gap: Gap, rounded: Callable[[float], float] | None = None) -> float:
    """Return the module with which every asked safety is just met under all cases of the life [m].

    Args:
        module: That meets them in the heaviest case [m].
        ratio: λ = b/m_n [-].
        gap: Of the stage.
        rounded: To what a module is rounded afterwards; no more corrections are made than it can tell apart.
    """
    for _ in range(CORRECTIONS):
        before, module = module, module / math.cbrt(gap(module, ratio * module))
        left = LEFT * abs(module - before)
        if rounded is not None and left < module / 2.0 and rounded(module - left) == rounded(module + left):
            break
    return module


def strong_enough(module: float, gap: Callable[[float], float], *, standard: bool) -> float:
    """Return a module, or a larger one that meets the safeties at its greatest face width [m].

    Near a resonance of the mesh a standard module may bear less than the smaller one that is needed; and a face that
    is cut to whole millimetres bears less than the one for which a module was found. The first stays where none of the
    next few bears what is asked.

    Args:
        module: That is needed, rounded where it is to be a standard one [m].
        gap: Module [m] -> by what factor the loads of its stage could grow at its greatest face width [-].
        standard: Modules are standard ones; else the least that is strong enough is found.
    """
    weak = module
    for tried in _tries(module, standard=standard):
        if gap(tried) >= 1.0 - JUST:
            return tried if standard else _least(weak, tried, gap)
        weak = tried
    return module


def _tries(module: float, *, standard: bool) -> list[float]:
    """Return a module and the next larger ones to try [m]."""
    tries = [module]
    for larger in LARGER:
        tries.append(next_standard(tries[-1] * (1.0 + NEXT)) if standard else larger * module)
    return tries


def _least(weak: float, strong: float, gap: Callable[[float], float]) -> float:
    """Return a module that is just strong enough between one that is too weak and one that is not [m]."""
    while strong - weak > JUST * strong:
        middle = (weak + strong) / 2.0
        weak, strong = (weak, middle) if gap(middle) >= 1.0 else (middle, strong)
    return strong


def least_width(rating: Rating, module: float) -> float:
    """Return the least face width that is chosen [m]: as usual, of helical teeth with the asked overlap.

    Args:
        rating: Resolved rules.
        module: m_n [m].
    """
    lean, rules = math.sin(rating.helix_angle), rating.proportions
    usual = module if rules is None else rules.narrowest_modules * module
    overlapping = rating.rules.overlap_ratio * math.pi * module / lean if lean else 0.0
    return max(overlapping, usual)


def least_bevel_width(teeth: tuple[int, int], outer: float, rating: Rating) -> float:
    """Return the least face width that is chosen for a bevel pair of an outer module, whose mean module it is over [m].

    Args:
        teeth: z_1, z_2 [-].
        outer: Outer transverse module m_et [m].
        rating: Resolved rules.

    Source: b = λ m_mn, of which m_mn falls linearly with b (`mean_module`).
    """
    ratio, thin = least_width(rating, 1.0), float(mean_module(teeth, outer, 0.0, rating))
    falls = (thin - float(mean_module(teeth, outer, outer, rating))) / outer
    return ratio * thin / (1.0 + ratio * falls)


def narrowest(least: float, widest: float, gap: Callable[[float], float]) -> float:
    """Return the least face width in whole millimetres that meets the safeties, or the most that is allowed [m].

    Args:
        least: To look from [m].
        widest: To look to [m].
        gap: Factor by which the loads could grow at a face width [-].
    """
    low, high = math.ceil(min(least, widest) / _MM - 1e-9), max(math.floor(widest / _MM + 1e-9), 1)
    while low < high:
        middle = (low + high) // 2
        if gap(middle * _MM) >= 1.0:
            high = middle
        else:
            low = middle + 1
    return high * _MM


def whole(width: float) -> float:
    """Return the most whole millimetres in a face width, one at least [m].

    Args:
        width: [m].
    """
    return narrowest(width, width, lambda _: 1.0)


def bevel_module(teeth: tuple[int, int], outer: float, ratio: float, rating: Rating, gap: Gap) -> float:
    """Return an outer module of a bevel pair, or a larger one that meets the safeties at its widest face [m].

    Args:
        teeth: z_1, z_2 [-].
        outer: Outer transverse module m_et, rounded where the rules ask for standard ones [m].
        ratio: λ = b/m_mn of the widest [-].
        rating: Resolved rules.
        gap: Of the stage.
    """

    def bears(tried: float) -> float:
        width = widest_bevel(teeth, tried, ratio, rating)
        width = whole(width) if rating.width_is_open else width
        return gap(mean_module(teeth, tried, width, rating), width)

    rules = rating.proportions
    return outer if rules is None else strong_enough(outer, bears, standard=rules.standard_modules)


def bevel_width(teeth: tuple[int, int], outer: float, ratio: float, rating: Rating, gap: Gap) -> float:
    """Return the face width of a bevel pair of an outer module: the widest, or the least that meets the safeties [m].

    A narrower face of the same outer module has a larger mean module, hence bears little less and weighs less.

    Args:
        teeth: z_1, z_2 [-].
        outer: Outer transverse module m_et [m].
        ratio: λ = b/m_mn of the widest [-].
        rating: Resolved rules.
        gap: Of the stage.
    """
    width = widest_bevel(teeth, outer, ratio, rating)
    if not rating.width_is_open:
        return width
    least = least_bevel_width(teeth, outer, rating)
    return narrowest(least, width, lambda tried: gap(mean_module(teeth, outer, tried, rating), tried))


def widest_bevel(teeth: tuple[int, int], outer: float, ratio: float, rating: Rating) -> float:
    """Return the widest face of a bevel pair of an outer module [m].

    Args:
        teeth: z_1, z_2 [-].
        outer: Outer transverse module m_et [m].
        ratio: λ = b/m_mn of the widest [-].
        rating: Resolved rules.
    """
    cone = float(cone_ratio(*teeth)) * outer
    return ratio * outer / (1.0 / math.cos(rating.helix_angle) + 0.5 * ratio * outer / cone)
