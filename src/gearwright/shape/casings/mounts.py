"""Mounts of a housing: four lugs on its largest wall with room, each with a hole along the first shaft, as weighed."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats, following
from gearwright.ranking import largest_first
from gearwright.shape.casings.outside import (
    Foot,
    Gap,
    Joint,
    Rods,
    around_loop,
    feet_at,
    gaps_of,
    in_space,
    is_open,
    length_of,
    quarter_turns,
    sheets_on,
    turned,
)
from gearwright.shape.solids import Chamber, Section, Solid
from gearwright.shape.stands import Axes

MOUNT = "mount"
"""What lugs are named."""
LUGS = 4
"""Of a housing [-], an assumption."""
DEPTH, CENTRE, BOLT = 0.5, 0.6, 0.35
"""Length of a lug along the first shaft, height of its hole over the wall and diameter of that, over its width [-],
assumptions; a wall without room has shorter ones."""
SHIFTS, PARTS = 12, 12
"""Places around a quarter of a wall that are tried, and parts of a lug's round end [-]."""
STEEP = 0.5
"""How far a wall may fall away beneath a lug over its width [-]."""
STEPS, ALIKE = 40, 1e-5
"""How often a width is tried, and how near the volume is to what is weighed [-]."""


class Lug(NamedTuple):
    """A lug where it stands."""

    foot: Foot
    span: tuple[float, float]
    """Along the first shaft [m]."""
    width: float
    """[m]"""
    outline: Floats
    """About its hole: out of the wall and along it, counter-clockwise [m], shape (n, 2)."""

    @property
    def placed(self) -> tuple[Solid, Axes]:
        """Its solid about its hole, and where that is."""
        height = (self.span[1] - self.span[0]) / 2.0
        radius, angle = np.linalg.norm(self.outline, axis=1), np.unwrap(np.arctan2(*self.outline.T[::-1]))
        ends = [Section(radius, angle, np.full(len(radius), place)) for place in (-height, height)]
        edges: Bools = np.ones(len(radius), dtype=bool)
        edges[2 : PARTS + 1] = False
        bore = BOLT * self.width / 2.0
        solid = Solid(((height, bore), (-height, bore)), tuple(ends), edges)
        return solid, Axes(in_space(self.foot, sum(self.span) / 2.0, CENTRE * self.width), turned(self.foot))


def lugs_on(
    chambers: Sequence[Chamber], joints: Sequence[Joint], volume: float, rods: Rods
) -> tuple[Lug, ...]:  # fmt: skip
    """Return the lugs of a housing; none where no wall has room.

    Args:
        chambers: Of the housing.
        joints: Its flanges.
        volume: Of all lugs [m³].
        rods: What leaves the housing.
    """
    gaps = largest_first(gaps_of(chambers, joints), lambda gap: length_of(chambers[gap.chamber].outer))
    long = DEPTH * _width(volume)
    roomy = [gap for gap in gaps if gap.end - gap.start >= long]
    for gap in (*roomy, *largest_first(gaps, lambda gap: gap.end - gap.start)):
        for shift in range(SHIFTS):
            found = _lugs(chambers[gap.chamber], gap, volume, shift / (LUGS * SHIFTS))
            if found and all(_is_free(chambers[gap.chamber], lug, rods) for lug in found):
                return found
    return ()


def _width(volume: float) -> float:
    """Return the width of lugs on a flat wall [m]."""
    return float((volume / (LUGS * DEPTH * (CENTRE + math.pi / 8.0 - math.pi / 4.0 * BOLT**2))) ** (1.0 / 3.0))


def _lugs(chamber: Chamber, gap: Gap, volume: float, shift: float) -> tuple[Lug, ...]:
    """Return lugs in a gap, as wide as their volume asks; none where the wall falls away beneath them."""
    points = around_loop(chamber.outer, (np.arange(LUGS) + 0.5) / LUGS + shift, half=True)
    feet = feet_at(chamber.outer, points)
    room, middle = gap.end - gap.start, (gap.start + gap.end) / 2.0

    def all_of(width: float) -> tuple[Lug, ...]:
        half = min(DEPTH * width, room) / 2.0
        return tuple(Lug(foot, (middle - half, middle + half), width, _outline(chamber.outer, foot, width))
                     for foot in feet)  # fmt: skip

    width = _width(volume)
    for _ in range(STEPS):
        found = all_of(width)
        share = volume / sum(map(_volume, found))
        width *= share ** (1.0 / 3.0 if DEPTH * width < room else 1.0 / 2.0)
        if abs(share - 1.0) < ALIKE:
            break
    deepest = min(float(lug.outline[:, 0].min()) for lug in found)
    wide = found[0].width > length_of(chamber.outer) / (2.0 * LUGS)
    return () if wide or deepest < -(CENTRE + STEEP) * found[0].width else found


def _outline(loop: Floats, foot: Foot, width: float) -> Floats:
    """Return a lug about its hole: along the wall, up both sides and round."""
    way = following(loop) - loop
    out = np.stack([way[:, 1], -way[:, 0]], axis=1) / np.linalg.norm(way, axis=1, keepdims=True)
    reach, facing = np.sum(loop * out, axis=1), out @ foot.out
    half, centre = width / 2.0, CENTRE * width

    def depth(beside: Floats) -> Floats:
        """Return how far the wall is out beside its foot [m]."""
        across = foot.point + beside[:, None] * foot.along
        room = (reach - across @ out.T)[:, facing > 1e-6] / facing[facing > 1e-6]
        return np.asarray(room.min(axis=1))

    corners = (loop - foot.point) @ foot.along
    front = (loop - foot.point) @ foot.out > -width
    chain = np.sort(corners[front & (np.abs(corners) < half - 1e-3 * width)])[::-1]
    sides = np.array([-half, half])
    low = depth(np.concatenate([sides, chain])) - centre
    turn = quarter_turns(PARTS)
    end = half * np.stack([np.cos(turn), np.sin(turn)], axis=1)
    base = np.concatenate([[[low[1], half]], np.column_stack([low[2:], chain]), [[low[0], -half]]])
    middles = (base[:-1] + base[1:]) / 2.0  # straight sides have middles: they are no arcs about the hole
    return np.concatenate([base[-1:], end, np.stack([base[:-1], middles], axis=1).reshape(-1, 2)])


def _volume(lug: Lug) -> float:
    after = following(lug.outline)
    area = float(np.sum(lug.outline[:, 0] * after[:, 1] - lug.outline[:, 1] * after[:, 0]) / 2.0)
    return (area - math.pi / 4.0 * (BOLT * lug.width) ** 2) * (lug.span[1] - lug.span[0])


def _is_free(chamber: Chamber, lug: Lug, rods: Rods) -> bool:
    """Tell whether nothing stands in a lug's way, the head of its bolt before and behind it included."""
    half = lug.width / 2.0
    if is_open(chamber, lug.foot, half, lug.span):
        return False
    return not rods.meet(sheets_on([lug.foot], np.array([lug.span]), np.array([(CENTRE + 0.5) * lug.width])), half)[0]
