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

from gearwright.parts.bevel import BevelPair, bevel_form
from gearwright.parts.gears import TransverseTooth, face_reach, face_thickness, face_way
from gearwright.shape.solids.solid import Section, Solid
from gearwright.shape.solids.toothed import Loop, loop_of


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


def bevel_gear(pair: BevelPair, side: int, way: Sequence[tuple[float, float]], *, hand: float, fine: Fineness) -> Solid:
    """Return a bevel gear with its body.

    Args:
        pair: Its pair.
        side: 0 for the pinion, 1 for the wheel.
        way: Behind its teeth, `bevel_way`.
        hand: +1 for a right-hand spiral, −1 for a left-hand one, 0 for straight teeth.
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
    return Solid(tuple(way), tuple(sections), loop.edges)


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


def face_wheel(pinion: TransverseTooth, teeth: int, *, width: float, bore: float, fine: Fineness) -> Solid:
    """Return the wheel of a face-gear pair whose shaper has the teeth of the pinion.

    Args:
        pinion: A spur gear.
        teeth: Of the wheel [-].
        width: Of its face about the pitch circle, as far as teeth are whole there [m].
        bore: Radius of what it sits on [m].
        fine: How finely.

    Source: as `gearwright.parts.gears.face_thickness`.
    """
    radii = np.linspace(*face_reach(pinion, teeth, width), fine.slices + 1)
    corner = np.tile(np.array([True, True, True, True]), teeth)
    sections = [_face_section(pinion, teeth, float(radius)) for radius in radii]
    return Solid(tuple(face_way(pinion, teeth, width=width, bore=bore)), tuple(sections), corner)


def _face_section(pinion: TransverseTooth, teeth: int, radius: float) -> Section:
    top, root = face_thickness(pinion, teeth, radius)
    one = np.array([-root, -top, top, root]) / radius
    angle = (np.arange(teeth)[:, None] * (2.0 * math.pi / teeth) + one).ravel()
    tip, foot = -pinion.rack.addendum * pinion.module, pinion.rack.dedendum * pinion.module
    return Section(np.full(len(angle), radius), angle, np.tile(np.array([foot, tip, tip, foot]), teeth))
