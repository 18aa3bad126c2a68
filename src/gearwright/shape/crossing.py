"""How deep the teeth of gears on crossing axes stand in each other, as far as their approximation lets them.

Points on the flanks of one gear are seen in the frame of the other, where a tooth is as thick as its outline says: of a
bevel gear on its back cone, of the wheel of a face gear in a cylinder about its axis.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np

from gearwright.arrays import Floats
from gearwright.identity import Role
from gearwright.parts.bevel import BevelPair, bevel_form
from gearwright.parts.gears import TransverseTooth, face_reach, face_thickness, transverse_form
from gearwright.shape.contacts import Contact, contacts_of
from gearwright.shape.gears import leanings
from gearwright.shape.record import Node, Scene
from gearwright.shape.solids import spiral_turn
from gearwright.shape.stands import stands_of
from gearwright.shape.teeth import kind_of
from gearwright.sizing import GearSizing, Sizing
from gearwright.sizing.mass import bevel_cones, pinion_of, tooth_of

POINTS, SLICES = 24, 9
"""Points on a fillet and on a flank, and sections along the face [-]."""
NEAR = 4
"""Teeth beside the touching point that are looked at [-]."""

Depth = Callable[[Floats], Floats]
"""Points in the frame of a gear, shape (n, 3) -> how deep each stands in its teeth, negative outside [m]."""


def crossed_depths(sizing: Sizing, scene: Scene, moments: Sequence[float]) -> dict[str, float]:
    """Return mesh on crossing axes -> how deep its teeth stand in each other at the worst moment [m].

    Args:
        sizing: As sized.
        scene: Of it.
        moments: Of the case that speaks for the design [s].
    """
    stands = stands_of(sizing)
    hands = {name: lean.hand for name, lean in leanings(sizing, stands).items()}
    found: dict[str, float] = {}
    for contact in contacts_of(sizing, stands):
        if kind_of(sizing, contact.mesh.stage) != "cylindrical":
            name = f"{contact.first.name} and {contact.second.name}"
            found[name] = max(_deepest(sizing, scene, contact, hands, moment) for moment in moments)
    return found


def _deepest(sizing: Sizing, scene: Scene, contact: Contact, hands: dict[str, float], moment: float) -> float:
    """Return how deep either gear's points stand in the other's teeth at a moment [m]."""
    worst = -1.0
    for one, other in ((contact.first, contact.second), (contact.second, contact.first)):
        here, there = scene.by_name[one.name], scene.by_name[other.name]
        points = _space(here, _flanks(sizing, one.gear, hands[one.name]), scene.cases[0], moment)
        near = np.argsort(np.linalg.norm(points.mean(axis=1) - _touch(contact), axis=1))[: 2 * NEAR + 1]
        seen = _frame(there, points[near].reshape(-1, 3), scene.cases[0], moment)
        worst = max(worst, float(np.max(_depth(sizing, other.gear, hands[other.name])(seen))))
    return worst


def _touch(contact: Contact) -> Floats:
    """Return the middle of where two gears touch [m]."""
    stand, angle = contact.first, contact.angles[0]
    way = math.cos(angle) * stand.axes.turned[:, 0] + math.sin(angle) * stand.axes.turned[:, 1]
    return np.asarray(stand.axes.origin + stand.gear.pitch_diameter / 2.0 * way)


def _about(angle: float) -> Floats:
    cosine, sine = math.cos(angle), math.sin(angle)
    return np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])


def _space(node: Node, points: Floats, case: str, moment: float) -> Floats:
    turned = node.axes.turned @ _about(node.phase + node.spins[case] * moment)
    return np.asarray(points @ turned.T + node.axes.origin)


def _frame(node: Node, points: Floats, case: str, moment: float) -> Floats:
    turned = node.axes.turned @ _about(node.phase + node.spins[case] * moment)
    return np.asarray((points - node.axes.origin) @ turned)


def _flanks(sizing: Sizing, gear: GearSizing, hand: float) -> Floats:
    """Return points on every tooth in the gear's frame, shape (teeth, points, 3) [m]."""
    kind, starts = kind_of(sizing, gear.stage), np.arange(gear.teeth) * 2.0 * math.pi / gear.teeth
    if kind == "bevel":
        radius, angle, height = _cone_points(bevel_cones(sizing, gear.stage), _side(gear), hand)
    elif gear.role is Role.WHEEL:
        pinion = pinion_of(sizing, gear)
        radius, angle, height = _face_points(tooth_of(sizing, pinion), gear.teeth, pinion.face_width)
    else:
        form, half = transverse_form(tooth_of(sizing, gear), fillet=POINTS, flank=POINTS)
        levels = np.linspace(-0.5, 0.5, SLICES) * gear.face_width
        radius, angle = np.tile(form, 2 * SLICES), np.tile(np.concatenate([half, -half]), SLICES)
        height = np.repeat(levels, 2 * len(form))
    turned = starts[:, None] + angle
    return np.stack([radius * np.cos(turned), radius * np.sin(turned), np.broadcast_to(height, turned.shape)], axis=2)


def _cone_points(pair: BevelPair, side: int, hand: float) -> tuple[Floats, Floats, Floats]:
    """Return radii, angles and places of points on both flanks of a bevel tooth."""
    form, half = bevel_form(pair, side, fillet=POINTS, flank=POINTS)
    cone, mean = pair.pitch_angles[side], pair.mean_cone_distance
    rise, both = np.tile(form - mean * math.tan(cone), 2), np.concatenate([half, -half]) / math.cos(cone)
    radius, angle, height = [], [], []
    for far in np.linspace(mean - pair.face_width / 2.0, mean + pair.face_width / 2.0, SLICES):
        above = rise * far / mean
        radius.append(far * math.sin(cone) + above * math.cos(cone))
        angle.append(both + hand * spiral_turn(pair, side, float(far)))
        height.append((far - mean) * math.cos(cone) - above * math.sin(cone))
    return np.concatenate(radius), np.concatenate(angle), np.concatenate(height)


def _face_points(pinion: TransverseTooth, teeth: int, width: float) -> tuple[Floats, Floats, Floats]:
    """Return radii, angles and places of points on both flanks of a tooth of a face gear."""
    tip, foot = -pinion.rack.addendum * pinion.module, pinion.rack.dedendum * pinion.module
    share = np.linspace(0.0, 1.0, POINTS)
    radius, angle, height = [], [], []
    for far in np.linspace(*face_reach(pinion, teeth, width), SLICES):
        top, root = face_thickness(pinion, teeth, float(far))
        half = (top + share * (root - top)) / far
        radius.append(np.full(2 * POINTS, far))
        angle.append(np.concatenate([half, -half]))
        height.append(np.tile(tip + share * (foot - tip), 2))
    return np.concatenate(radius), np.concatenate(angle), np.concatenate(height)


def _depth(sizing: Sizing, gear: GearSizing, hand: float) -> Depth:
    """Return the rule by which points in the frame of a gear stand in its teeth."""
    if kind_of(sizing, gear.stage) == "bevel":
        return _in_cone(bevel_cones(sizing, gear.stage), _side(gear), hand)
    if gear.role is Role.WHEEL:
        pinion = pinion_of(sizing, gear)
        return _in_face(tooth_of(sizing, pinion), gear.teeth, pinion.face_width)
    return _in_cylinder(tooth_of(sizing, gear), gear.face_width)


def _in_cone(pair: BevelPair, side: int, hand: float) -> Depth:
    form, half = bevel_form(pair, side, fillet=POINTS, flank=POINTS)
    cone, mean, order = pair.pitch_angles[side], pair.mean_cone_distance, np.argsort(form)
    lean, tiny = math.cos(pair.pressure_angle) * math.cos(pair.spiral_angle), 1e-3 * mean

    def depth(points: Floats) -> Floats:
        radius, angle = np.hypot(points[:, 0], points[:, 1]), np.arctan2(points[:, 1], points[:, 0])
        far = radius * math.sin(cone) + points[:, 2] * math.cos(cone) + mean * math.cos(cone) ** 2
        above = (radius * math.cos(cone) - points[:, 2] * math.sin(cone)) - mean * math.sin(cone) * math.cos(cone)
        virtual = above * mean / far + mean * math.tan(cone)
        turn = hand * math.tan(pair.spiral_angle) * np.log(np.maximum(far, tiny) / mean) / math.sin(cone)
        wide = np.interp(virtual, form[order], half[order]) / math.cos(cone)
        deep = (wide - _beside(angle - turn, pair.teeth[side])) * radius * lean
        inside = (abs(far - mean) <= pair.face_width / 2.0) & (virtual <= form.max())
        return np.where(inside, np.where(virtual < form.min(), (form.min() - virtual) * far / mean, deep), -1.0)

    return depth


def _in_face(pinion: TransverseTooth, teeth: int, width: float) -> Depth:
    tip, foot = -pinion.rack.addendum * pinion.module, pinion.rack.dedendum * pinion.module
    inner, outer = face_reach(pinion, teeth, width)

    def depth(points: Floats) -> Floats:
        radius, angle = np.hypot(points[:, 0], points[:, 1]), np.arctan2(points[:, 1], points[:, 0])
        found, here = np.full(len(points), -1.0), (radius >= inner) & (radius <= outer) & (points[:, 2] >= tip)
        radius, angle, place = radius[here], angle[here], points[here, 2]
        ends = np.array([face_thickness(pinion, teeth, float(one)) for one in radius]).reshape(-1, 2)
        wide = ends[:, 0] + np.clip((place - tip) / (foot - tip), 0.0, 1.0) * (ends[:, 1] - ends[:, 0])
        deep = (wide - _beside(angle, teeth) * radius) * math.cos(pinion.pressure_angle)
        found[here] = np.where(place > foot, place - foot, deep)
        return found

    return depth


def _in_cylinder(tooth: TransverseTooth, width: float) -> Depth:
    form, half = transverse_form(tooth, fillet=POINTS, flank=POINTS)
    order = np.argsort(form)

    def depth(points: Floats) -> Floats:
        radius, angle = np.hypot(points[:, 0], points[:, 1]), np.arctan2(points[:, 1], points[:, 0])
        wide = np.interp(radius, form[order], half[order])
        deep = (wide - _beside(angle, int(tooth.teeth))) * radius * math.cos(tooth.pressure_angle)
        deep = np.where(radius < form.min(), form.min() - radius, deep)
        return np.where((abs(points[:, 2]) <= width / 2.0) & (radius <= form.max()), deep, -1.0)

    return depth


def _beside(angle: Floats, teeth: int) -> Floats:
    """Return how far angles are from the middle of the nearest tooth [rad]."""
    pitch = 2.0 * math.pi / teeth
    return np.asarray(np.abs(angle - np.round(angle / pitch) * pitch))


def _side(gear: GearSizing) -> int:
    return 0 if gear.role is Role.PINION else 1
