"""Ribs on the outside of a housing, as heavy as they are weighed: along its walls, and on plates beside narrower walls.

Those along a wall stand between the screws of its flange, up to its face where there is room; those on a plate reach
from the narrower wall to the plate's rim.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats, following
from gearwright.shape.casings.flanges import screw_loop, screw_places
from gearwright.shape.casings.outside import (
    AIR,
    Foot,
    Gap,
    Joint,
    Rods,
    Taken,
    around_loop,
    feet_at,
    gaps_of,
    in_space,
    is_open,
    length_of,
    sheets_on,
)
from gearwright.shape.solids import Chamber, Solid, block
from gearwright.shape.stands import Axes
from gearwright.sizing.casing import WASHER, Flanges

RIB = "rib"
"""What ribs are named."""
THICK = 1.0
"""Thickness of a rib over the wall's [-]: as the estimate of their mass has it."""
PITCHES = (12.0, 10.0, 8.0, 6.5, 5.0, 4.0, 3.0)
"""From rib to rib over the wall [-], of which the widest is taken with which ribs are no higher than wanted."""
WANTED, MOST = 2.5, 5.0
"""Height of a rib over the wall that is wanted, and the most as the estimate of their mass has it [-]."""
LESS = 0.85
"""How much of what could stand on walls is counted on: openings, mounts and shafts take some [-]."""
SIDE = 0.9
"""Thickness over the width of the side that a rib stands on, at most [-]."""
FEWEST, APART = 4, 2.5
"""Ribs around a wall, at least, and from rib to rib around the narrower one over their thickness [-]."""
NEAR = 1e-9
"""Places that are nearer are one [m]."""
_HALVINGS = 40


class Rib(NamedTuple):
    """A rib where it stands."""

    foot: Foot
    span: tuple[float, float]
    """Along the first shaft; of a rib on a plate the room that it has there, from the plate on [m]."""
    reach: float = 0.0
    """Of a rib on a plate: out of the narrower wall [m]; 0 of one along a wall."""
    beside: float = 0.0
    """Width of the flange that one along a wall stands beside [m]."""

    @property
    def room(self) -> float:
        """How high it may be [m]: on a plate as far as the wall beside it is free, else half of its length."""
        length = abs(self.span[1] - self.span[0])
        return length if self.reach else max(length / 2.0, self.beside)

    @property
    def length(self) -> float:
        """Along what it stands on [m]."""
        return self.reach or abs(self.span[1] - self.span[0])

    def height(self, wanted: float) -> float:
        """Return how high it is [m]: as high as all, as far as it has room.

        Args:
            wanted: Height of all [m].
        """
        return min(wanted, self.room)

    def sheet(self, height: float) -> tuple[float, float, float]:
        """Return from where to where along the first shaft it stands, and how far out of the wall [m].

        Args:
            height: Of it [m].
        """
        if not self.reach:
            return (*self.span, height)
        way = math.copysign(height, self.span[1] - self.span[0])
        return self.span[0] + 0.1 * way, self.span[0] + way, self.reach

    def axes(self, height: float) -> Axes:
        """Return where its block stands: x upwards from what it is on, z along that.

        Args:
            height: Of it [m].
        """
        y, z = self.foot.out.tolist()
        if not self.reach:
            turned = np.array([[0.0, 0.0, 1.0], [y, -z, 0.0], [z, y, 0.0]])
            return Axes(in_space(self.foot, sum(self.span) / 2.0, height / 2.0), turned)
        way = 1.0 if self.span[1] > self.span[0] else -1.0
        turned = np.array([[way, 0.0, 0.0], [0.0, way * z, y], [0.0, -way * y, z]])
        return Axes(in_space(self.foot, self.span[0] + way * height / 2.0, self.reach / 2.0), turned)


def ribs_on(
    chambers: Sequence[Chamber], joints: Sequence[Joint], flanges: Flanges, wall: float, volume: float,
    *, rods: Rods, taken: Sequence[Taken],
) -> Iterator[tuple[str, Solid, Axes]]:  # fmt: skip
    """Yield size, solid and place of every rib; none where no wall has room.

    Args:
        chambers: Of the housing.
        joints: Its flanges.
        flanges: As they are weighed.
        wall: Thickness of the wall [m].
        volume: Of all ribs [m³].
        rods: What leaves the housing.
        taken: Where mounts stand.
    """
    sides = [float(np.linalg.norm(following(one.outer) - one.outer, axis=1).max()) for one in chambers]
    thick, gaps = min(THICK * wall, SIDE * max(sides)), list(gaps_of(chambers, joints, MOST * wall))
    wanted = WANTED * wall
    widest = [rib for rib, _ in _all(chambers, gaps, joints, flanges, (thick, PITCHES[0] * wall))]
    least = thick * _standing(widest, wanted) * PITCHES[0] / volume
    found: list[Rib] = []
    for pitch in (next((pitch for pitch in PITCHES if pitch < LESS * least), PITCHES[-1]), PITCHES[-1]):
        ribs = list(_all(chambers, gaps, joints, flanges, (thick, pitch * wall)))
        found = _free(ribs, (thick, wanted), rods, taken)
        if thick * _standing(found, MOST * wall) >= volume:
            break
    high = _height(found, volume / thick, MOST * wall)
    solids: dict[str, Solid] = {}
    for rib in found:
        tall = rib.height(high)
        key = f"{1e6 * tall:.1f} {1e6 * rib.length:.1f}"
        solids[key] = solids.get(key) or block(thick, tall, rib.length)
        yield key, solids[key], rib.axes(tall)


def _sides(ribs: Sequence[Rib]) -> tuple[Floats, Floats]:
    """Return how long ribs are, and how high they may be [m], shape (n,) each."""
    return np.array([rib.length for rib in ribs]), np.array([rib.room for rib in ribs])


def _standing(ribs: Sequence[Rib], height: float) -> float:
    """Return the area of the sides of ribs [m²]."""
    length, room = _sides(ribs)
    return float(np.sum(length * np.minimum(room, height)))


def _height(ribs: Sequence[Rib], area: float, most: float) -> float:
    """Return how high ribs are whose sides have an area, as far as each has room [m]."""
    length, room = _sides(ribs)
    low, high = 0.0, most
    for _ in range(_HALVINGS if float(np.sum(length * np.minimum(room, most))) > area else 0):
        height = (low + high) / 2.0
        low, high = (low, height) if float(np.sum(length * np.minimum(room, height))) > area else (height, high)
    return high


def _all(
    chambers: Sequence[Chamber], gaps: Sequence[Gap], joints: Sequence[Joint], flanges: Flanges,
    size: tuple[float, float],
) -> Iterator[tuple[Rib, Chamber]]:  # fmt: skip
    """Yield ribs where they could stand, each with the wall that its foot is on, those on plates first."""
    for gap in gaps:
        for k, span in ((gap.chamber - 1, (gap.start, gap.end)), (gap.chamber + 1, (gap.end, gap.start))):
            if 0 <= k < len(chambers) and abs(chambers[k].span[0 if k > gap.chamber else 1] - span[0]) < NEAR:
                yield from ((rib, chambers[gap.chamber]) for rib in _on_plate(chambers, gap.chamber, k, span, size))
    for gap in gaps:
        yield from ((rib, chambers[gap.chamber]) for rib in _in_gap(chambers[gap.chamber], gap, joints, flanges, size))


def _on_plate(
    chambers: Sequence[Chamber], own: int, wide: int, span: tuple[float, float], size: tuple[float, float]
) -> Iterator[Rib]:
    """Yield ribs on a plate, from the narrower wall beside it to its rim."""
    narrow, rim = chambers[own].outer, chambers[wide].outer
    around = length_of(narrow)
    number = min(round((around + length_of(rim)) / (2.0 * size[1])), int(around / (APART * size[0])))
    way = following(rim) - rim
    out = np.stack([way[:, 1], -way[:, 0]], axis=1)
    for foot in feet_at(narrow, around_loop(narrow, np.arange(number) / max(number, 1), half=True)):
        ahead = out @ foot.out > 0.0
        edges = foot.point + np.array([[-0.5], [0.5]]) * size[0] * foot.along
        room = np.sum((rim[ahead] - edges[:, None]) * out[ahead], axis=2) / (out[ahead] @ foot.out)
        if room.min() > size[0] and abs(span[1] - span[0]) > size[0]:
            yield Rib(foot, span, float(room.min()))


def _in_gap(
    chamber: Chamber, gap: Gap, joints: Sequence[Joint], flanges: Flanges, size: tuple[float, float]
) -> Iterator[Rib]:
    """Yield ribs along a wall, a pitch apart: between screws up to the faces of flanges, else short of their heads."""
    thick, pitch = size
    number = max(round(length_of(chamber.outer) / pitch), FEWEST)
    own = [joint.half for joint in joints if joint.chamber == gap.chamber]
    points, screws, wide = around_loop(chamber.outer, np.arange(number) / number, half=True), np.empty((0, 2)), 0.0
    if own:
        between = np.unique(np.round(np.arange(number) * flanges.screws / number)) / flanges.screws
        points, screws = around_loop(screw_loop(own[0]), between), screw_places(own[0], flanges.screws)
        wide = float(own[0].outer[:, 0].max() - own[0].inner[:, 0].max())
    for foot in feet_at(chamber.outer, points, thick / 2.0):
        off = screws - foot.point
        beside = np.abs(off @ foot.along)[off @ foot.out > 0.0]
        free = bool(np.all(beside > thick / 2.0 + WASHER[0] * flanges.thread / 2.0 + AIR / 2.0))
        span = (gap.low, gap.high) if free else (gap.start, gap.end)
        if span[1] - span[0] > thick:
            yield Rib(foot, span, beside=wide)


def _free(
    ribs: Sequence[tuple[Rib, Chamber]], size: tuple[float, float], rods: Rods, taken: Sequence[Taken]
) -> list[Rib]:
    """Return ribs in whose way nothing stands: no opening, no shaft or cover, no mount, no rib on a plate."""
    if not ribs:
        return []
    half, height = size[0] / 2.0, size[1]
    sheets = np.array([rib.sheet(rib.height(height)) for rib, _ in ribs])
    hit = rods.meet(sheets_on([rib.foot for rib, _ in ribs], sheets[:, :2], sheets[:, 2]), half)
    there = [*taken, *(Taken(rib.foot, (min(rib.span), max(rib.span)), half) for rib, _ in ribs if rib.reach)]
    points, out = (np.array([getattr(rib.foot, name) for rib, _ in ribs]) for name in ("point", "out"))
    spans = np.sort(np.array([rib.span for rib, _ in ribs]), axis=1)
    on_plate = np.array([rib.reach > 0.0 for rib, _ in ribs])
    for k, one in enumerate(there):
        beside = np.abs((points - one.foot.point) @ one.foot.along) < one.half + half + AIR
        past = (spans[:, 0] < one.span[1]) & (one.span[0] < spans[:, 1]) & (out @ one.foot.out > 0.0)
        hit |= beside & past & ~(on_plate & (k >= len(taken)))
    return [rib for (rib, chamber), is_hit, (low, high) in zip(ribs, hit, spans.tolist(), strict=True)
            if not is_hit and not is_open(chamber, rib.foot, half, (low, high))]  # fmt: skip
