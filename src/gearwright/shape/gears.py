"""The solids of gears: teeth of their tools over bodies as they are weighed."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

from gearwright.identity import Role
from gearwright.parts.bevel import Hand, bevel_way
from gearwright.parts.gears import Blank, transverse_form
from gearwright.shape.solids import Fineness, Solid, bevel_gear, disc_gear, face_wheel, loop_of, ring_gear
from gearwright.shape.stands import Stand
from gearwright.shape.teeth import bevel_pair, halves_of, hand_of, kind_of, meshes_of
from gearwright.sizing import GearSizing, Sizing
from gearwright.sizing.arrangement import helix_hand
from gearwright.sizing.mass import bevel_dish, bevel_hub, bevel_web, pinion_of, ring_outside, tooth_of

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
