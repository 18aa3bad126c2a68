"""The section of a face gear's wheel, as it is weighed, with its dimensions from the plane of its pitch circle."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from gearwright.identity import Role
from gearwright.parts.gears import TransverseTooth, face_reach, face_way
from gearwright.render.drawings.sheet.entities import Distance, Entity, Layer, Path
from gearwright.render.drawings.sheet.tolerances import datum
from gearwright.render.drawings.views.gear_dimensions import LEAN, runout_beside, thickness
from gearwright.render.drawings.views.gear_parts import Hub
from gearwright.render.drawings.views.gear_view import bore_edges, hatched, line
from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.render.drawings.views.shaft_view import OVERSHOOT, Axis
from gearwright.render.drawings.views.weights import made_of
from gearwright.shape.stands import stands_of
from gearwright.shape.teeth import kind_of
from gearwright.sizing import GearSizing, Sizing
from gearwright.sizing.mass import pinion_of, tooth_of

ASIDE, STEP = 9.0, 8.0
"""From a part to its first dimension line, and from each to the next [mm]."""


class FaceTeeth(NamedTuple):
    """Between which radii, and how far before and behind the plane of its pitch circle, a face gear has its teeth."""

    pinion: TransverseTooth
    """That its shaper is."""
    reach: tuple[float, float]
    """[mm]"""
    tip: float
    """Before the plane, towards the pinion [mm]."""
    root: float
    """Behind it [mm]."""


def is_face_wheel(sizing: Sizing, gear: GearSizing) -> bool:
    """Tell whether a gear is the wheel of a face-gear pair.

    Args:
        sizing: What was sized.
        gear: One of its gears.
    """
    return kind_of(sizing, gear.stage) == "face" and gear.role is Role.WHEEL


def face_teeth(sizing: Sizing, gear: GearSizing) -> FaceTeeth:
    """Return the teeth of the wheel of a face-gear pair.

    Args:
        sizing: What was sized.
        gear: The wheel.
    """
    mate = pinion_of(sizing, gear)
    tooth = tooth_of(sizing, mate)
    inner, outer = face_reach(tooth, gear.teeth, mate.face_width)
    tip, root = (MM * height * tooth.module for height in (tooth.rack.addendum, tooth.rack.dedendum))
    return FaceTeeth(tooth, (MM * inner, MM * outer), tip, root)


def toward_pinion(sizing: Sizing, gear: GearSizing, shaft: str) -> float:
    """Return +1 where the teeth of a wheel look towards its shaft's second end, −1 where towards the first.

    Args:
        sizing: What was sized.
        gear: The wheel of a face-gear pair.
        shaft: That carries it.
    """
    stands = {stand.node: stand for stand in stands_of(sizing) if stand.gear.stage == gear.stage}
    own = stands[shaft]
    mate = next(stand for stand in stands.values() if stand.gear.role is Role.PINION)
    return math.copysign(1.0, float((mate.axes.origin - own.axes.origin) @ own.axes.along))


def face_section(sizing: Sizing, gear: GearSizing, hub: Hub, axis: Axis, *, toward: float, lean: float) -> list[Entity]:
    """Return the wheel of a face-gear pair in section, both halves; x = 0 is the plane of its pitch circle.

    Args:
        sizing: What was sized.
        gear: The wheel.
        hub: Its bore.
        axis: Where its axis lies.
        toward: +1 where its teeth look along the axis, −1 where against it [-].
        lean: Angle of the hatching [rad].
    """
    teeth, way = face_teeth(sizing, gear), _way(sizing, gear, hub)
    inner, outer = teeth.reach
    tooth = [complex(teeth.root, inner), complex(-teeth.tip, inner), complex(-teeth.tip, outer),
             complex(teeth.root, outer)]  # fmt: skip
    entities: list[Entity] = []
    for side in (1.0, -1.0):
        below = [_placed(corner, toward, side) for corner in (tooth[0], tooth[3], *way)]
        entities += [hatched(axis, below, lean), line(axis, [_placed(corner, toward, side) for corner in tooth])]
        entities.append(line(axis, below, closed=True))
        more = 2.0 / axis.scale
        ends = [_placed(complex(0.0, radius), toward, side) for radius in (inner - more, outer + more)]
        entities.append(line(axis, ends, Layer.PITCH))
    return entities


def _placed(corner: complex, toward: float, side: float) -> complex:
    return complex(-toward * corner.real, side * corner.imag)


def _way(sizing: Sizing, gear: GearSizing, hub: Hub) -> list[complex]:
    """Return the way behind the teeth from their outside to their inside, with the bore that is drawn [mm]."""
    teeth, bore = face_teeth(sizing, gear), made_of(sizing).blanks[gear.name].bore_radius
    points = face_way(teeth.pinion, gear.teeth, width=pinion_of(sizing, gear).face_width, bore=bore)
    inner = min(radius for _, radius in points)
    return [complex(MM * z, hub.bore / 2.0 if radius == inner else MM * radius) for z, radius in points]


def face_view(sizing: Sizing, gear: GearSizing, hub: Hub, axis: Axis) -> list[Entity]:
    """Return the wheel of a face-gear pair in section with its dimensions.

    Args:
        sizing: What was sized.
        gear: The wheel.
        hub: Its bore.
        axis: On paper.
    """
    teeth, way = face_teeth(sizing, gear), _way(sizing, gear, hub)
    inner, outer = teeth.reach
    bored = [corner.real for corner in way if corner.imag <= hub.bore / 2.0]
    ends = (min(-teeth.tip, *(corner.real for corner in way)), max(corner.real for corner in way))
    beyond = OVERSHOOT / axis.scale
    entities: list[Entity] = [Path((axis.at(ends[0] - beyond), axis.at(ends[1] + beyond)), Layer.CENTRE)]
    entities += face_section(sizing, gear, hub, axis, toward=-1.0, lean=LEAN)
    entities += bore_edges(axis, (min(bored), max(bored)), hub)
    right, left = axis.at(ends[1]).real + ASIDE, axis.at(ends[0]).real - ASIDE
    back, front = way[0], way[-1]
    radii = sorted({corner.imag for corner in way if hub.bore / 2.0 < corner.imag < inner})
    across = [(max(bored), hub.bore / 2.0)] if hub.bore else []
    across += [(max(corner.real for corner in way if corner.imag == radius), radius) for radius in radii[:1]]
    across.append((back.real, outer))
    for row, (x, radius) in enumerate(across):
        suffix = f" {hub.tolerance}" if hub.tolerance and row == 0 else ""
        entities.append(_across(axis, x, radius, right + STEP * row, suffix))
    entities.append(_across(axis, -teeth.tip, inner, left, ""))
    if hub.bore:
        entities += datum(complex(right, axis.at(0.0, -hub.bore / 2.0).imag), -1j, "A")
        face = axis.at(back.real, -0.9 * outer)
        entities += runout_beside(face, max(right + STEP * len(across), face.real + ASIDE), outer)
    flat = [corner.real for corner in way if radii and corner.imag == radii[0]]
    if radii and min(flat) < front.real:
        entities += thickness(axis, (front.real, back.real), (radii[0], inner))
    entities += _lengths(axis, teeth, (back.real, *((min(bored), max(bored)) if hub.bore else ())))
    return entities


def _across(axis: Axis, x: float, radius: float, at: float, suffix: str) -> Distance:
    low, high = axis.at(x, -radius), axis.at(x, radius)
    return Distance(low, high, complex(at, 0.0), math.pi / 2.0, axis.scale, "Ø", suffix)


def _lengths(axis: Axis, teeth: FaceTeeth, backs: tuple[float, ...]) -> Iterator[Entity]:
    """Yield how far tips and backs lie from the plane of the pitch circle, which the assembly distance is to."""
    inner, outer = teeth.reach
    plane, level = axis.at(0.0, -outer), axis.at(0.0, -outer).imag - ASIDE
    yield Distance(axis.at(-teeth.tip, -outer), axis.at(backs[0], -outer), complex(0.0, level), 0.0, axis.scale)
    for row, back in enumerate(sorted(set(backs)), 1):
        foot = axis.at(back, -outer if back == backs[0] else -inner)
        yield Distance(plane, foot, complex(0.0, level - STEP * row), 0.0, axis.scale)
