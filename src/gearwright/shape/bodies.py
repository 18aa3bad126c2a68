"""The solids of gears, shafts and carriers."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.identity import Kind, PartId, Role
from gearwright.parts.bevel_geometry import Hand, bevel_way
from gearwright.parts.gears import Blank, transverse_form
from gearwright.shape.solids import (
    Arm,
    Fineness,
    Outline,
    Solid,
    bearing,
    bevel_gear,
    block,
    disc_gear,
    face_wheel,
    loop_of,
    plate,
    ring_gear,
    stepped,
    tube,
    turned,
)
from gearwright.shape.stands import Axes, Stand, halves_of, hand_of, kind_of, meshes_of
from gearwright.sizing import CarrierSizing, GearSizing, Sizing
from gearwright.sizing.arrangement import helix_hand
from gearwright.sizing.casing import RingSeat
from gearwright.sizing.mass import (
    Bridge,
    Cage,
    Plate,
    bevel_dish,
    bevel_hub,
    bevel_web,
    pinion_of,
    ring_outside,
    tooth_of,
)
from gearwright.sizing.mass.bodies import bevel_cones as bevel_pair
from gearwright.sizing.places import Bell, Run
from gearwright.sizing.result import Body
from gearwright.sizing.shafts import Holder

# ----------------------------------------------------------------------------------------------------------------------
# The solids of gears: teeth of their tools over bodies as they are weighed.
# ----------------------------------------------------------------------------------------------------------------------


LEAST_FLANK = 2
"""Points on a flank of a ring, at least [-]; its hollow flanks are flatter than those of planets, and need one less."""


class Leaning(NamedTuple):
    """How the teeth of a gear lean."""

    hand: float
    """+1 right, −1 left, 0 straight."""
    is_double: bool
    """Whether the other half leans the other way."""

    @property
    def turning(self) -> float:
        """By which it counts in the phase of a mesh; that of a double helix or of a cone is counted at its middle."""
        return 0.0 if self.is_double else self.hand


def leanings(sizing: Sizing, stands: tuple[Stand, ...]) -> dict[str, Leaning]:
    """Return gear where it stands -> how its teeth lean.

    Args:
        sizing: As sized.
        stands: Its gears.
    """
    found: dict[str, Leaning] = {}
    for stand in stands:
        gear = stand.gear
        if kind_of(sizing, gear.stage) == "bevel":
            hand = hand_of(sizing, gear, stand.node)
            found[stand.name] = Leaning(0.0 if hand is None else 1.0 if hand is Hand.RIGHT else -1.0, is_double=True)
        elif gear.helix_angle == 0.0:
            found[stand.name] = Leaning(0.0, is_double=False)
        elif gear.stage in sizing.design.pairs:
            hand_of_helix = helix_hand(sizing.design, sizing.train, sizing.flows, stand.node)
            found[stand.name] = Leaning(hand_of_helix, is_double=halves_of(gear) > 1)
        else:
            found[stand.name] = Leaning(1.0 if gear.role is Role.SUN else -1.0, is_double=False)
    return found


def gear_solid(sizing: Sizing, stand: Stand, leaning: Leaning, blanks: Mapping[str, Blank], *, fine: Fineness) -> Solid:
    """Return the solid of a gear.

    Args:
        sizing: As sized.
        stand: Where it stands.
        leaning: How its teeth lean.
        blanks: Gear -> its body.
        fine: How finely.
    """
    gear, kind = stand.gear, kind_of(sizing, stand.gear.stage)
    if kind == "bevel":
        pair, side = bevel_pair(sizing, gear.stage), meshes_of(sizing, gear.name)[0][1]
        bore = blanks[gear.name].bore_radius
        web = bevel_web(sizing, gear, bore)
        hub, dish = bevel_hub(sizing, gear, bore), bevel_dish(sizing, gear)
        way = bevel_way(pair, side, bore, web, hub, dish=dish)
        return bevel_gear(pair, side, way, hand=leaning.hand, fine=fine)
    if kind == "face" and gear.role is Role.WHEEL:
        pinion = pinion_of(sizing, gear)
        bore, width = blanks[gear.name].bore_radius, pinion.face_width
        return face_wheel(tooth_of(sizing, pinion), gear.teeth, width=width, bore=bore, fine=fine)
    tooth = tooth_of(sizing, gear)
    flank = fine.flank if tooth.side > 0 else max(fine.flank - 1, LEAST_FLANK)
    loop = loop_of(transverse_form(tooth, fillet=fine.fillet, flank=flank), gear.teeth)
    levels = _levels(gear, leaning, fine.layer, halves=halves_of(gear))
    if tooth.side < 0:
        return ring_gear(loop, levels, ring_outside(sizing, gear))
    return disc_gear(loop, levels, _doubled(blanks[gear.name], halves_of(gear)))


def _levels(gear: GearSizing, leaning: Leaning, layer: float, *, halves: int) -> list[tuple[float, float]]:
    """Return places along the axis, and how far the teeth are turned there."""
    half = halves * gear.face_width / 2.0
    rate = leaning.hand * math.tan(gear.helix_angle) / (gear.pitch_diameter / 2.0)
    count = max(1, math.ceil(abs(rate) * half / layer)) * (2 if rate else 1)
    if not rate:
        return [(-half, 0.0), (half, 0.0)]
    places = [half * (2.0 * k / count - 1.0) for k in range(count + 1)]
    return [(place, rate * (abs(place) if leaning.is_double else place)) for place in places]


def _doubled(blank: Blank, halves: int) -> Blank:
    """Return a body as wide as all halves."""
    return blank._replace(width=halves * blank.width, web_width=halves * blank.web_width)


# ----------------------------------------------------------------------------------------------------------------------
# The solids of shafts: their steps, bearings, bells of rings.
# ----------------------------------------------------------------------------------------------------------------------


def shaft_solid(run: Run, middle: float) -> Solid:
    """Return the solid of a shaft about its middle.

    Args:
        run: As drawn.
        middle: Place that becomes z = 0, from its first end [m].
    """
    return stepped([(low - middle, high - middle, radius) for low, high, radius in run.steps], run.bore)


def bell_solid(bell: Bell) -> Solid:
    """Return the solid of a ring's bell about the middle of its ring.

    Args:
        bell: As sized.
    """
    corners = [(place - bell.middle, radius) for place, radius in bell.section]
    way = corners if bell.disc[1] > bell.disc[0] else corners[::-1]
    return Solid((*way, way[0]))


def seat_solids(seat: RingSeat) -> tuple[Solid, Solid]:
    """Return the splines of a ring as a tube to half of their height, and its keeper, about its middle.

    Args:
        seat: As sized.
    """
    teeth = turned([(*seat.spline, seat.teeth.shaft_root / 2.0, seat.middle)])
    return teeth, turned([(*seat.keeper, seat.clear, seat.outside)])


def bearing_solid(body: Body) -> Solid:
    """Return the envelope of a bearing.

    Args:
        body: Where it stands.
    """
    return bearing(body.bore, body.radius, body.length)


def bearing_bodies(sizing: Sizing) -> Iterator[tuple[PartId, Body]]:
    """Yield every bearing of a shaft with its envelope.

    Args:
        sizing: As sized.
    """
    yield from ((body.part, body) for body in sizing.arrangement.bodies if body.part.kind is Kind.BEARING)


def holder_solid(holder: Holder) -> Solid:
    """Return a part that holds a bearing, about its middle.

    Args:
        holder: As sized.
    """
    middle, half = (holder.start + holder.end) / 2.0, (holder.end - holder.start) / 2.0
    if not holder.stepped:
        return tube((-half, half), holder.outer / 2.0, holder.bore / 2.0)
    rings = ((ring.start - middle, ring.end - middle, ring.bore / 2.0, ring.outer / 2.0) for ring in holder.rings)
    return turned(tuple(rings))


# ----------------------------------------------------------------------------------------------------------------------
# The solids of carriers: both plates, pins and bridges between them, and what planets turn on.
# ----------------------------------------------------------------------------------------------------------------------


LEAST_RING = 5e-4
"""Room between pin and planet below which nothing is drawn in it [m]."""


def held_at(cage: Cage, axes: Axes, planets: Sequence[Stand]) -> tuple[Arm, ...]:
    """Return what the plates of a carrier hold, about its axis: eyes around pins by their angles, then bridges.

    Args:
        cage: As made.
        axes: Of the carrier.
        planets: That it carries.
    """
    off = {(stand.node, stand.place): stand.axes.origin - axes.origin for stand in planets}
    eye = cage.pin_diameter / 2.0 + cage.eye_wall
    pins = sorted(Arm(axes.angle(way), math.hypot(*(axes.turned.T @ way)[:2]), eye) for way in off.values())
    if cage.bridge is None:
        return tuple(pins)
    angles = [pin.angle for pin in pins]
    following = [*angles[1:], angles[0] + 2.0 * math.pi]
    inner, end = (cage.bridge.radius + way * cage.bridge.depth / 2.0 for way in (-1.0, 1.0))
    half = cage.bridge.width / 2.0
    between = [0.5 * (one + other) for one, other in zip(angles, following, strict=True)]
    return (*pins, *(Arm(angle, end, half, inner, is_round=False) for angle in between))


def plate_outline(own: Plate) -> Outline:
    """Return what a plate of a carrier is cut to.

    Args:
        own: As made.
    """
    return Outline(own.body.radius, own.bore, own.fill)


def plate_solid(cage: Cage, own: Plate, held: Sequence[Arm], segments: int) -> Solid:
    """Return a plate of a carrier: arms to what it holds, with holes for its pins and for what goes through it.

    Args:
        cage: As made.
        own: One of its plates.
        held: Its pins and bridges.
        segments: Corners of a circle.
    """
    return plate(held, plate_outline(own), own.body.length, pin=cage.pin_diameter / 2.0, segments=segments)


def pin_solid(cage: Cage, axes: Axes) -> Solid:
    """Return a pin, through its plates.

    Args:
        cage: As made.
        axes: Where it is drawn about.
    """
    return tube(_between(cage, cage.whole, axes), cage.pin_diameter / 2.0, cage.pin_bore / 2.0)


def bridge_solid(cage: Cage, bridge: Bridge) -> Solid:
    """Return a bridge about its middle, away from the carrier's axis along x.

    Args:
        cage: As made.
        bridge: Of it.
    """
    return block(bridge.width, bridge.depth, cage.span[1] - cage.span[0])


def bridge_axes(cage: Cage, radius: float, axes: Axes, angle: float) -> Axes:
    """Return where a bridge stands.

    Args:
        cage: As made.
        radius: Of its middle [m].
        axes: Of the carrier.
        angle: About the carrier's axis [rad].
    """
    cosine, sine = math.cos(angle), math.sin(angle)
    turned = axes.turned @ np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])
    middle = sum(_between(cage, cage.span, axes)) / 2.0
    return Axes(axes.origin + radius * turned[:, 0] + middle * axes.along, turned)


def _between(cage: Cage, span: tuple[float, float], axes: Axes) -> tuple[float, float]:
    """Return where a span of the first plate's axis begins and ends along another one, from its origin [m]."""
    body = cage.plates[0].body
    ends = [float((np.asarray(body.origin) + far * np.asarray(body.direction) - axes.origin) @ axes.along)
            for far in span]  # fmt: skip
    return min(ends), max(ends)


def planet_bearing(carrier: CarrierSizing, gear: GearSizing, blank: Blank, halves: int) -> Solid | None:
    """Return the envelope of what a planet turns on; None where there is no room between planet and pin.

    Args:
        carrier: As sized.
        gear: The planet.
        blank: Its body.
        halves: 2 of a double-helical planet.
    """
    inner, outer = carrier.pin_diameter / 2.0, blank.bore_radius
    if outer - inner < LEAST_RING:
        return None
    return bearing(inner, outer, halves * gear.face_width)
