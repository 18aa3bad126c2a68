"""Bevel and face gears: teeth on cones by their virtual spur gears, teeth on a face as racks, and the bodies behind.

Both stand with their axis along z, away from the mate: the mean point of the face at z = 0, tips towards −z.

These teeth are approximations. Bevel teeth have the profile of the virtual cylindrical gear of their back cone
(Tredgold), which differs from the octoid of a generated tooth by little, and spirals of constant angle instead of a
cutter's circle. Teeth of a face gear are, in every cylinder about its axis, those of the rack that the unrolled pinion
meshes with there; the curvature of the wheel's motion within the width of a tooth is left out.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.parts.bevel import BevelPair
from gearwright.parts.gears import BasicRack, TransverseTooth, transverse_form
from gearwright.shape.solids.solid import Section, Solid
from gearwright.shape.solids.toothed import Loop, loop_of

RIM = 1.2
"""Metal behind the roots over the depth of the teeth [-] (AGMA 2001-D04, backup ratio without loss of strength)."""
WEB = 0.3
"""Web over face width [-], an assumption where no web is sized."""
HUB = 1.25
"""Hub over bore [-], an assumption."""


class Fineness(NamedTuple):
    """How finely surfaces are cut."""

    fillet: int
    """Points on a fillet [-]."""
    flank: int
    """Points on a flank [-]."""
    circle: int
    """Corners of a circle [-]."""
    layer: float
    """Largest turn of a tooth between two sections [rad]."""
    slices: int
    """Sections along the face of a bevel or face gear, less one [-]."""


def bevel_gear(pair: BevelPair, side: int, *, hand: float, bore: float, fine: Fineness) -> Solid:
    """Return a bevel gear with its body.

    Args:
        pair: Its pair.
        side: 0 for the pinion, 1 for the wheel.
        hand: +1 for a right-hand spiral, −1 for a left-hand one, 0 for straight teeth.
        bore: Radius of what it sits on [m].
        fine: How finely.

    Source: Tredgold's virtual gear z/cos δ of the back cone; standard depth taper, ISO 23509:2016.
    """
    cone, mean = pair.pitch_angles[side], pair.mean_cone_distance
    form = bevel_form(pair, side, fillet=fine.fillet, flank=fine.flank)
    virtual = mean * math.tan(cone)
    loop = loop_of((form[0] - virtual, form[1] / math.cos(cone)), pair.teeth[side])
    ends = (mean - pair.face_width / 2.0, mean + pair.face_width / 2.0)
    count = fine.slices if hand else 1
    sections = [
        _on_cone(loop, cone, mean, far=float(far), turn=hand * spiral_turn(pair, side, float(far)))
        for far in np.linspace(*ends, count + 1)
    ]
    depth = float(form[0].max() - form[0].min())
    toe, heel = (
        _below(cone, mean, far, float(loop.radius.min()) - RIM * depth * far / mean, loop.radius.min()) for far in ends
    )
    return _backed(sections, loop, toe, heel, bore=bore, web=WEB * pair.face_width)


def bevel_form(pair: BevelPair, side: int, *, fillet: int, flank: int) -> tuple[Floats, Floats]:
    """Return one side of a tooth of the virtual cylindrical gear at the mean cone.

    Args:
        pair: The pair.
        side: 0 for the pinion, 1 for the wheel.
        fillet: Points on the fillet [-].
        flank: Points on the flank [-].

    Returns:
        Radii [m] and half angles [rad] from root to tip.
    """
    tooth, shift = pair.tooth, pair.tooth.profile_shift * (1.0 if side == 0 else -1.0)
    rack = BasicRack(pair.pressure_angle, tooth.addendum, tooth.dedendum, tooth.edge_radii[side])
    virtual = TransverseTooth(
        pair.teeth[side] / math.cos(pair.pitch_angles[side]), pair.mean_module, pair.spiral_angle, shift, rack=rack
    )
    return transverse_form(virtual, fillet=fillet, flank=flank)


def spiral_turn(pair: BevelPair, side: int, far: float) -> float:
    """Return by how much a right-hand tooth is turned about the axis, against the middle of the face [rad].

    Args:
        pair: The pair.
        side: 0 for the pinion, 1 for the wheel.
        far: Cone distance [m].

    Source: a line that crosses the cone's generators at β: dφ = tan β dR/(R sin δ).
    """
    return math.tan(pair.spiral_angle) * math.log(far / pair.mean_cone_distance) / math.sin(pair.pitch_angles[side])


def _on_cone(loop: Loop, cone: float, mean: float, *, far: float, turn: float) -> Section:
    """Return the outline at a cone distance; its radii are heights above the pitch cone at the mean one."""
    height = loop.radius * far / mean
    radius = far * math.sin(cone) + height * math.cos(cone)
    return Section(radius, loop.angle + turn, (far - mean) * math.cos(cone) - height * math.sin(cone))


def _below(cone: float, mean: float, far: float, height: float, least: float) -> tuple[float, float]:
    """Return z and radius of a point below the root on a back cone."""
    height = min(height, 1.02 * least * far / mean)
    return (far - mean) * math.cos(cone) - height * math.sin(cone), far * math.sin(cone) + height * math.cos(cone)


def face_wheel(pinion: TransverseTooth, teeth: int, *, width: float, bore: float, fine: Fineness) -> Solid:
    """Return the wheel of a face-gear pair whose shaper has the teeth of the pinion.

    Args:
        pinion: A spur gear.
        teeth: Of the wheel [-].
        width: Of its face about the pitch circle, as far as teeth are whole there [m].
        bore: Radius of what it sits on [m].
        fine: How finely.

    Source: Litvin and Fuentes 2004, chapter 18, in sections: cos α(R) = R_b/R with R_b = r_b z_2/z_1; inside R_b the
        shaper undercuts, outside teeth are pointed where their tops meet.
    """
    ratio, pitch = teeth / pinion.teeth, pinion.pitch_radius * teeth / pinion.teeth
    inner = max(pitch - width / 2.0, 1.002 * pinion.base_radius * ratio)
    outer = min(pitch + width / 2.0, pointed_radius(pinion, teeth))
    radii = np.linspace(inner, outer, fine.slices + 1)
    corner = np.tile(np.array([True, True, True, True]), teeth)
    sections = [_face_section(pinion, teeth, float(radius)) for radius in radii]
    root = pinion.rack.dedendum * pinion.module
    rim = RIM * (root + pinion.rack.addendum * pinion.module)
    loop = Loop(sections[0].radius, sections[0].angle, corner)
    toe, heel = (root + 0.4 * rim, float(inner)), (root + rim, float(outer))
    return _backed(sections, loop, toe, heel, bore=bore, web=0.6 * rim)


def pointed_radius(pinion: TransverseTooth, teeth: int) -> float:
    """Return where the teeth of a face gear become pointed, a tenth of a module of top left [m].

    Args:
        pinion: A spur gear.
        teeth: Of the wheel [-].
    """
    pitch = pinion.pitch_radius * teeth / pinion.teeth
    radii = np.linspace(pinion.base_radius * teeth / pinion.teeth * 1.001, 1.5 * pitch, 400)
    top = np.array([face_thickness(pinion, teeth, float(radius))[0] for radius in radii])
    return float(radii[np.nonzero(top > 0.05 * pinion.module)[0].max()])


def face_thickness(pinion: TransverseTooth, teeth: int, radius: float) -> tuple[float, float]:
    """Return half the thickness of a face gear's tooth at its top and at its root [m].

    Args:
        pinion: A spur gear.
        teeth: Of the wheel [-].
        radius: Of the cylinder in which it is cut [m].
    """
    roll = radius * pinion.teeth / teeth
    angle = math.acos(min(1.0, pinion.base_radius / roll))
    half = (math.pi / pinion.teeth - float(pinion.half_angles(np.asarray(roll)))) * roll
    rack, middle = pinion.rack, pinion.pitch_radius
    top, root = middle - rack.addendum * pinion.module, middle + rack.dedendum * pinion.module
    most = 0.98 * math.pi * roll / pinion.teeth
    return half + (top - roll) * math.tan(angle), min(half + (root - roll) * math.tan(angle), most)


def _face_section(pinion: TransverseTooth, teeth: int, radius: float) -> Section:
    top, root = face_thickness(pinion, teeth, radius)
    one = np.array([-root, -top, top, root]) / radius
    angle = (np.arange(teeth)[:, None] * (2.0 * math.pi / teeth) + one).ravel()
    tip, foot = -pinion.rack.addendum * pinion.module, pinion.rack.dedendum * pinion.module
    return Section(np.full(len(angle), radius), angle, np.tile(np.array([foot, tip, tip, foot]), teeth))


def _backed(
    sections: Sequence[Section], loop: Loop, toe: tuple[float, float], heel: tuple[float, float],
    *, bore: float, web: float,
) -> Solid:  # fmt: skip
    """Return teeth with what is behind them: a rim from toe to heel, a plate, a hub about the bore."""
    return Solid(tuple(_behind(toe, heel, bore, web)), tuple(sections), loop.edges)


def _behind(toe: tuple[float, float], heel: tuple[float, float], bore: float, web: float) -> list[tuple[float, float]]:
    """Return the way behind the teeth from heel to toe, z and radius [m]."""
    bore, hub = min(bore, 0.85 * toe[1]), HUB * bore
    if hub > 0.8 * toe[1] or bore <= 0.0:
        return [heel, (heel[0], bore), (toe[0], bore), toe]
    upper = min(toe[0] + web, heel[0])
    share = 1.0 if heel[0] == toe[0] else (upper - toe[0]) / (heel[0] - toe[0])
    under = (upper, toe[1] + share * (heel[1] - toe[1]))
    middle, half = (toe[0] + upper) / 2.0, max(1.6 * (upper - toe[0]), 1.2 * (hub - bore)) / 2.0
    low, high = middle - half, middle + half
    way = [heel] + ([under] if share < 1.0 else [])
    return [*way, (upper, hub), (high, hub), (high, bore), (low, bore), (low, hub), (toe[0], hub), toe]
