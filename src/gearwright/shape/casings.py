"""Pieces of housings that are no chambers: flanges, screws, mounts, ribs; which a housing has is for `housing`."""

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.base import Bools, Floats, following, largest, largest_first, smallest
from gearwright.shape.chambers import Chamber, without
from gearwright.shape.solids import Fastener, Layer, Section, Solid, block
from gearwright.shape.stands import Axes
from gearwright.sizing import Sizing
from gearwright.sizing.casing import HEAD, HOLE, LENGTH, NUT, THICKNESS, WASHER, Flanges
from gearwright.sizing.housing_shell import SAME, SAME_CORNER as NEAR, Stretch, inside_of, loop_around, ways_of
from gearwright.sizing.places import Run
from gearwright.sizing.shafts import holders_of

# ----------------------------------------------------------------------------------------------------------------------
# Flanges of a housing: where along it they stand, their halves, and where their screws are.
# ----------------------------------------------------------------------------------------------------------------------


SIDES = 48
"""Directions in which loops around a housing are measured [-]."""
FLANGES = "flange"
"""What halves of flanges are named."""
NEARLY = (0.8, 0.6, 0.4, 0.0)
"""Perimeter over the longest one from which a cross-section carries flanges [-]: the width of flanges grows with it."""
ENDS = ((THICKNESS + WASHER[1] + HEAD[1]) / THICKNESS, (LENGTH - WASHER[1]) / THICKNESS - 1.0)
"""From the joint to the outside of a screw's head and to the end of its thread, over the thickness of a half [-]."""
ROOM = 1.05 * sum(ENDS)
"""From flange to flange over the thickness of a half [-]: halves, heads and ends of screws, and some air."""


Span = tuple[float, float]


def flange_halves(
    flanges: Flanges, stretches: Sequence[Stretch], wall: float, taken: Sequence[Sequence[Span]],
    rings: Sequence[Span] = (),
) -> Iterator[tuple[float, str, Chamber]]:  # fmt: skip
    """Yield place, key and solid of both halves of every flange, as heavy as they are weighed.

    Args:
        flanges: As they are weighed.
        stretches: Cross-sections of the housing, each within the wider one beside it.
        wall: Thickness of the wall [m].
        taken: Of every cross-section, between which places something stands outside of its wall [m].
        rings: Between which places a ring stands in place of the wall, with a flange on either side [m].
    """
    for k, place in _joints(stretches, flanges, wall, taken, rings):
        solid = _flange(inside_of(stretches[k], wall) + wall, flanges.face, flanges.thickness)
        yield place - flanges.thickness, f" {k + 1}", solid
        yield place, f" {k + 1}", solid


def _joints(
    stretches: Sequence[Stretch], flanges: Flanges, wall: float, taken: Sequence[Sequence[Span]], rings: Sequence[Span]
) -> list[tuple[int, float]]:
    """Return number of the cross-section and place of every flange, from the first end to the last [m].

    Those that hold rings stand beside them, the others between.
    """
    thick = flanges.thickness
    edges = [edge for low, high in rings for edge in (low - thick, high + thick)]
    held = [(_nearest(stretches, edge), edge) for edge in edges]
    spans = [[(edge - thick, edge + thick) for j, edge in held if j == k] for k in range(len(stretches))]
    others = [[*own, *more] for own, more in zip(taken, spans, strict=True)]
    return sorted([*held, *_spread(stretches, flanges.number - len(held), thick, wall, others)], key=lambda one: one[1])


def _nearest(stretches: Sequence[Stretch], place: float) -> int:
    """Return number of the cross-section in which a place along the first shaft is, or to which it is nearest."""
    off = [max(one.start - place, place - one.end, 0.0) for one in stretches]
    return smallest(range(len(off)), lambda k: off[k])


def _spread(
    stretches: Sequence[Stretch], count: int, thick: float, wall: float, taken: Sequence[Sequence[Span]]
) -> list[tuple[int, float]]:
    """Return where flanges stand apart around cross-sections nearly as long around as the longest one.

    Where there is no room for screws between them, they stand around shorter ones, too.
    """
    longest, found = max(one.perimeter for one in stretches), list[tuple[int, float]]()
    room = 1.05 * ENDS[1] * thick
    plain = [_beside_plates(stretches, k, room + wall) for k in range(len(stretches))]
    clear = [_beside(span, held, room) for span, held in zip(plain, taken, strict=True)]
    free = clear if any(low <= high for low, high in clear) else plain
    for least in NEARLY:
        wide = [k for k, one in enumerate(stretches) if one.perimeter >= least * longest and free[k][0] <= free[k][1]]
        if not wide:
            continue
        ends = np.cumsum([stretches[k].length for k in wide])
        found = []
        for share in np.linspace(0.0, float(ends[-1]), count):
            j = int(np.searchsorted(ends, share - NEAR))
            place = stretches[wide[j]].end + share - float(ends[j])
            low, high = free[wide[j]]
            found.append((wide[j], min(max(place, low), high)))
        if all(other[1] - one[1] > ROOM * thick for one, other in pairwise(found)):
            break
    return found


def _beside_plates(stretches: Sequence[Stretch], k: int, room: float) -> tuple[float, float]:
    """Return from where to where a flange may stand: away from plates of wider chambers beside its own [m]."""
    own, low, high = stretches[k], stretches[k].start, stretches[k].end
    if k > 0 and np.any(stretches[k - 1].reach > own.reach + SAME):
        low += room
    if k + 1 < len(stretches) and np.any(stretches[k + 1].reach > own.reach + SAME):
        high -= room
    return low, high


def _beside(free: Span, taken: Sequence[Span], room: float) -> Span:
    """Return the longest piece of a stretch on which a flange is clear of what stands outside of the wall [m]."""
    if not taken or free[0] > free[1]:
        return free
    left = without([free], [(low - room, high + room) for low, high in taken])
    return largest(left, lambda span: span[1] - span[0]) if left else (free[0], free[0] - room)


def _flange(reach: Floats, face: float, thick: float) -> Chamber:
    """Return one half of a flange around a wall: as wide as its face is large [m²]."""
    inner = loop_around(reach)
    around = float(np.sum(np.linalg.norm(np.roll(inner, -1, axis=0) - inner, axis=1)))
    more = len(reach) * math.tan(math.pi / len(reach))
    wide = (math.sqrt(around**2 + 4.0 * more * face) - around) / (2.0 * more)
    return Chamber(loop_around(reach + wide), inner, (0.0, thick))


def screw_loop(half: Chamber) -> Floats:
    """Return the middle of a flange's face, along which its screws stand [m], shape (n, 2).

    Args:
        half: One half of the flange.
    """
    ways = ways_of(SIDES)
    return loop_around(np.asarray([(ways @ one.T).max(axis=1) for one in (half.outer, half.inner)]).mean(axis=0))


def screw_places(half: Chamber, number: int) -> Floats:
    """Return where the screws of a flange stand, equally far apart along the middle of its face [m], shape (n, 2).

    Args:
        half: One half of the flange.
        number: Of screws.
    """
    loop = screw_loop(half)
    closed = np.concatenate([loop, loop[:1]])
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(closed, axis=0), axis=1))])
    at = (np.arange(number) + 0.5) * along[-1] / number
    return np.stack([np.interp(at, along, closed[:, 0]), np.interp(at, along, closed[:, 1])], axis=1)


# ----------------------------------------------------------------------------------------------------------------------
# The screws of flanges as bodies: hexagon head, shank, nut and two washers, as heavy as they are weighed.
# ----------------------------------------------------------------------------------------------------------------------


SCREW = "screw"
"""What screws of flanges are named, and painted as."""


def flange_screw(thread: float) -> Fastener:
    """Return a screw about its own axis, the joint of its flange at z = 0, its head before it.

    Args:
        thread: Its diameter [m].
    """
    radius, washer, nut = thread / 2.0, WASHER[1] * thread, NUT[1] * thread
    face, head = THICKNESS * thread, HEAD[1] * thread
    below = -face - washer
    return Fastener((
        Layer(below - head, below, HEAD[0] * radius, is_hexagon=True),
        Layer(below, below + LENGTH * thread, radius),
        Layer(below, -face, WASHER[0] * radius, HOLE * radius),
        Layer(face, face + washer, WASHER[0] * radius, HOLE * radius),
        Layer(face + washer, face + washer + nut, NUT[0] * radius, radius, is_hexagon=True),
    ))  # fmt: skip


def placed_screws(flanges: Flanges, halves: Sequence[tuple[float, Chamber]]) -> Iterator[tuple[str, Floats]]:
    """Yield name and place of every screw: along the first shaft, then across it [m], shape (3,).

    Args:
        flanges: As they are weighed.
        halves: Where the joint of every flange stands along the first shaft [m], and a half of it.
    """
    for k, (joint, half) in enumerate(halves):
        for j, place in enumerate(screw_places(half, flanges.screws)):
            yield f"housing, {SCREW} {k + 1}.{j + 1}", np.array([joint, *place])


# ----------------------------------------------------------------------------------------------------------------------
# The outside of a housing's walls: where flanges leave them free, feet on them, and what stands in their way.
# ----------------------------------------------------------------------------------------------------------------------


AIR = 1e-3
"""Between what stands on a wall and heads of screws, shafts and covers beside it, an assumption [m]."""


class Joint(NamedTuple):
    """A flange where it stands."""

    chamber: int
    """Number of the chamber that it is around, from 0 on."""
    place: float
    """Along the first shaft [m]."""
    half: Chamber
    """One half of it."""


class Gap(NamedTuple):
    """A free length of a wall."""

    chamber: int
    """Its number, from 0 on."""
    start: float
    """Beyond heads and ends of screws, along the first shaft [m]."""
    end: float
    """[m]"""
    low: float
    """Up to the face of the flange, between screws [m]."""
    high: float
    """[m]"""


class Foot(NamedTuple):
    """A place on a wall."""

    point: Floats
    """Across the first shaft [m], shape (2,)."""
    out: Floats
    """Square to the wall [-], shape (2,)."""

    @property
    def along(self) -> Floats:
        """Unit vector along the wall, counter-clockwise [-], shape (2,)."""
        return np.array([-self.out[1], self.out[0]])


class Taken(NamedTuple):
    """What stands on a wall."""

    foot: Foot
    span: tuple[float, float]
    """Along the first shaft [m]."""
    half: float
    """Half of its width along the wall [m]."""


class Rods(NamedTuple):
    """Cylinders in space: shafts as they are drawn, and covers."""

    origin: Floats
    """[m], shape (n, 3)."""
    along: Floats
    """[-], shape (n, 3)."""
    length: Floats
    """[m], shape (n,)."""
    radius: Floats
    """[m], shape (n,)."""

    def meet(self, points: Floats, half: float) -> Bools:
        """Tell which of several bodies stand in one of them, or too near to one, shape (m,).

        Args:
            points: Of each body, in the middle of its width [m], shape (m, n, 3).
            half: Half of that width [m].
        """
        off = points[:, :, None, :] - self.origin
        height = np.einsum("mnrk,rk->mnr", off, self.along)
        beside = np.linalg.norm(off - height[..., None] * self.along, axis=3)
        room = half + AIR
        inside: Bools = (height > -room) & (height < self.length + room) & (beside < self.radius + room)
        return np.asarray(inside.any(axis=(1, 2)))


def gaps_of(chambers: Sequence[Chamber], joints: Sequence[Joint], room: float = math.inf) -> Iterator[Gap]:
    """Yield the free lengths of all walls, from the first end on.

    Args:
        chambers: Of the housing.
        joints: Its flanges.
        room: How far out of a wall what stands on it reaches: flanges of wider chambers further out are not in its way
            [m].
    """
    for k, chamber in enumerate(chambers):
        low = start = chamber.span[0]
        for joint in sorted(joints, key=lambda joint: joint.place):
            thick, own = joint.half.span[1], joint.chamber == k
            before, behind = joint.place - ENDS[0] * thick - AIR, joint.place + ENDS[1] * thick + AIR
            if not own and _past(chamber.outer, joint.half.inner) > room:
                continue
            if behind < chamber.span[0] or before > chamber.span[1]:
                continue
            if before > start:
                yield Gap(k, start, before, low, joint.place - thick if own else before)
            start, low = max(start, behind), max(low, joint.place + thick if own else behind)
        if chamber.span[1] > start:
            yield Gap(k, start, chamber.span[1], low, chamber.span[1])


def _past(one: Floats, other: Floats) -> float:
    """Return how far another loop reaches beyond one, where it does least [m]."""
    ways = ways_of(48)
    return float(np.min((ways @ other.T).max(axis=1) - (ways @ one.T).max(axis=1)))


def feet_at(loop: Floats, points: Floats, half: float = 0.0) -> list[Foot]:
    """Return the places on sides of a loop that are nearest to points outside of it; none on sides that are too narrow.

    Args:
        loop: Convex, counter-clockwise [m], shape (n, 2).
        points: [m], shape (m, 2).
        half: How far from both ends of its side a place must be [m].
    """
    way = following(loop) - loop
    length = np.linalg.norm(way, axis=1)
    way = way / length[:, None]
    out = np.stack([way[:, 1], -way[:, 0]], axis=1)
    sides = np.argmax(points @ out.T - np.sum(loop * out, axis=1), axis=1)
    at = np.sum((points - loop[sides]) * way[sides], axis=1)
    at = np.clip(at, half, np.maximum(length[sides] - half, half))
    feet = loop[sides] + at[:, None] * way[sides]
    return [Foot(feet[k], out[side]) for k, side in enumerate(sides) if length[side] >= 2.0 * half]


def around_loop(loop: Floats, shares: Floats, *, half: bool = False) -> Floats:
    """Return points of a loop [m], shape (n, 2).

    Args:
        loop: Its corners [m], shape (m, 2).
        shares: Of its length, from its first corner on [-], shape (n,).
        half: Whether they count from the middle of its last side instead, in which rounds look along y.
    """
    closed = np.concatenate([loop, loop[:1]])
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(closed, axis=0), axis=1))])
    before = float(np.linalg.norm(loop[0] - loop[-1])) / 2.0 if half else 0.0
    at = np.mod(shares * along[-1] - before, along[-1])
    return np.stack([np.interp(at, along, closed[:, 0]), np.interp(at, along, closed[:, 1])], axis=1)


def length_of(loop: Floats) -> float:
    """Return the length of a closed loop [m].

    Args:
        loop: Its corners [m], shape (n, 2).
    """
    return float(np.sum(np.linalg.norm(following(loop) - loop, axis=1)))


def is_open(chamber: Chamber, foot: Foot, half: float, span: tuple[float, float]) -> bool:
    """Tell whether an opening of a wall lies beneath what would stand on it.

    Args:
        chamber: The wall.
        foot: Where it would stand.
        half: Half of its width along the wall [m].
        span: From where to where along the first shaft [m].
    """
    for opening in chamber.openings:
        beside = abs(float((foot.point - opening.middle[:2]) @ opening.along)) - opening.radius
        past = max(span[0] - opening.middle[2], opening.middle[2] - span[1]) - opening.radius
        if float(foot.out @ opening.way) > 0.0 and beside < half + AIR and past < AIR:
            return True
    return False


def rods_of(sizing: Sizing, drawn: Sequence[Run]) -> Rods:
    """Return shafts and covers as cylinders.

    Args:
        sizing: As sized.
        drawn: Shafts as they are drawn.
    """
    frames = sizing.arrangement.frames
    steps = [(run.shaft, *step) for run in drawn for step in run.steps]
    steps += [(one.shaft, one.start, one.end, one.outer / 2.0) for one in holders_of(sizing) if one.kind == "cover"]
    along = np.array([frames[shaft].along for shaft, *_ in steps]).reshape(-1, 3)
    origin = np.array([frames[shaft].origin for shaft, *_ in steps]).reshape(-1, 3)
    numbers = np.array([numbers for _, *numbers in steps]).reshape(-1, 3)
    return Rods(origin + numbers[:, :1] * along, along, numbers[:, 1] - numbers[:, 0], numbers[:, 2])


def in_space(foot: Foot, x: float, up: float) -> Floats:
    """Return a place above a wall in space [m], shape (3,).

    Args:
        foot: On the wall.
        x: Along the first shaft [m].
        up: Out of the wall [m].
    """
    return np.array([x, *(foot.point + up * foot.out)])


def sheets_on(feet: Sequence[Foot], x: Floats, up: Floats) -> Floats:
    """Return points of rectangles that stand on walls in space [m], shape (n, 15, 3).

    Args:
        feet: Where, n of them.
        x: From where to where along the first shaft [m], shape (n, 2).
        up: How high out of the wall [m], shape (n,).
    """
    points, out = (np.array([getattr(foot, name) for foot in feet]) for name in ("point", "out"))
    along = x[:, :1] + np.linspace(0.0, 1.0, 5) * (x[:, 1:] - x[:, :1])
    high = np.linspace(0.1, 1.0, 3) * up[:, None]
    across = points[:, None] + high[:, :, None] * out[:, None]
    shape = (len(feet), 5, 3)
    found = np.empty((*shape, 3))
    found[..., 0], found[..., 1:] = along[:, :, None], across[:, None]
    return found.reshape(len(feet), 15, 3)


def turned(foot: Foot) -> Floats:
    """Return directions about a place on a wall as columns: out of it, along it, along the first shaft, shape (3, 3).

    Args:
        foot: The place.
    """
    return np.column_stack([[0.0, *foot.out], [0.0, *foot.along], [1.0, 0.0, 0.0]])


def quarter_turns(count: int) -> Floats:
    """Return angles of a half circle from −90° to 90° [rad], shape (n,).

    Args:
        count: How many parts it has.
    """
    return np.linspace(-math.pi / 2.0, math.pi / 2.0, count + 1)


# ----------------------------------------------------------------------------------------------------------------------
# Mounts of a housing: four lugs on its largest wall with room, each with a hole along the first shaft, as weighed.
# ----------------------------------------------------------------------------------------------------------------------


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
    long = DEPTH * lug_width(volume)
    roomy = [gap for gap in gaps if gap.end - gap.start >= long]
    for gap in (*roomy, *largest_first(gaps, lambda gap: gap.end - gap.start)):
        for shift in range(SHIFTS):
            found = _lugs(chambers[gap.chamber], gap, volume, shift / (LUGS * SHIFTS))
            if found and all(_is_free(chambers[gap.chamber], lug, rods) for lug in found):
                return found
    return ()


def lug_width(volume: float) -> float:
    """Return the width of lugs on a flat wall [m].

    Args:
        volume: Of all of them [m³].
    """
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

    width = lug_width(volume)
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


# ----------------------------------------------------------------------------------------------------------------------
# Ribs on the outside of a housing, as heavy as they are weighed: along its walls, and on plates beside narrower walls.
#
# Those along a wall stand between the screws of its flange, up to its face where there is room; those on a plate reach
# from the narrower wall to the plate's rim.
# ----------------------------------------------------------------------------------------------------------------------


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
SAME_PLACE = 1e-9
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
            if 0 <= k < len(chambers) and abs(chambers[k].span[0 if k > gap.chamber else 1] - span[0]) < SAME_PLACE:
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
