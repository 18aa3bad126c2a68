"""Where the parts of a train stand on paper, and the signs of a skeleton diagram."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

from gearwright.base import Kind, Role, largest_first
from gearwright.render import style as theme
from gearwright.render.vector.figure import DARK_STEEL, DEEP_STEEL, PALE_STEEL, Axes, circle
from gearwright.sizing import GearSizing
from gearwright.spec import GROUND
from gearwright.train import Attachment, Mesh, Train, attachments

# ----------------------------------------------------------------------------------------------------------------------
# Where the parts of a train stand on paper: columns along the axis, a height for each axis, nested hollow shafts.
#
# Coordinates are mm of paper. Shafts that a planetary set or a clutch joins share an axis; a pair puts its axes apart
# by the centre distance. Where parallel paths meet again, no plane shows all centre distances: heights are then a
# compromise, each mesh is drawn in its true ratio, and `Layout.exact` is False.
# ----------------------------------------------------------------------------------------------------------------------


GAP = 21.0
"""Between columns, room for a label [mm]."""
MACHINE_HALF, CLUTCH_HALF, STAGE_HALF = 10.0, 4.0, 9.0
"""Least half widths of columns [mm]."""
TALLEST, LARGEST = 105.0, 36.0
"""Most height of the axes together, and largest radius [mm]."""
CONSUMERS: Mapping[str, int] = {"load": 4, "propeller": 5, "rotor": 5}
"""Kinds of machines that stand behind their stages -> rank there."""
TRUE = 0.01
"""Deviation of a centre distance up to which the drawing counts as to scale [-]."""


@dataclass(frozen=True)
class Outline:
    """What of a gear is drawn."""

    radius: float
    """Pitch radius [m]."""
    width: float
    """Face width [m]."""
    rim: float = 0.0
    """Wall of a ring [m]."""


DEFAULT_OUTLINES: Mapping[Role, Outline] = {
    Role.SUN: Outline(0.045, 0.02), Role.PLANET: Outline(0.050, 0.02), Role.RING: Outline(0.145, 0.02, 0.008),
    Role.PINION: Outline(0.040, 0.02), Role.WHEEL: Outline(0.120, 0.02),
}  # fmt: skip
"""Proportions where nothing is sized."""


@dataclass(frozen=True)
class Place:
    """A column of the drawing."""

    x: float
    """Its middle [mm]."""
    half: float
    """Half its width [mm]."""


@dataclass(frozen=True)
class Layout:
    """Where everything is."""

    places: Mapping[str, Place]
    """Machine, stage or clutch -> column."""
    heights: Mapping[str, float]
    """Shaft -> height of its axis [mm]."""
    levels: Mapping[str, int]
    """Shaft -> 0 on the axis, 1, 2, … for hollow shafts around it."""
    spans: Mapping[str, tuple[float, float]]
    """Shaft -> its ends [mm]."""
    outlines: Mapping[str, Outline]
    """Gear -> what is drawn of it."""
    widths: Mapping[str, float]
    """Stage -> face width of its widest gear [m]."""
    scale: float
    """Paper over part [mm/m]."""
    exact: bool
    """All centre distances are to scale."""

    @property
    def width(self) -> float:
        """Of the drawing [mm]."""
        return max(place.x + place.half for place in self.places.values())

    def gaps(self) -> list[float]:
        """Return the middles of the free stretches between columns [mm]."""
        edges = sorted({(place.x - place.half, place.x + place.half) for place in self.places.values()})
        return [(end + start) / 2.0 for (_, end), (start, _) in pairwise(edges) if start > end]


def element(seat: Attachment) -> str:
    """Return the machine, stage or clutch that a part belongs to.

    Args:
        seat: The part.
    """
    return seat.stage or seat.part.name


def lay_out(train: Train, gears: Sequence[GearSizing], kinds: Mapping[str, str]) -> Layout:
    """Return where everything stands.

    Args:
        train: The graph.
        gears: Sized gears; none: default proportions.
        kinds: Machine -> turbine, motor or propeller, as far as known.
    """
    outlines = {gear.name: DEFAULT_OUTLINES[gear.role] for gear in train.gears}
    outlines |= {gear.name: Outline(gear.pitch_diameter / 2.0, gear.face_width, gear.rim) for gear in gears}
    seats = [seat for seat in attachments(train) if seat.shaft != GROUND]
    axis = _axes(train, seats)
    heights = _heights(train, axis, outlines)
    scale = _scale(heights, outlines)
    places = _places(train, seats, axis, outlines=outlines, scale=scale, kinds=kinds)
    spans = {shaft: _span(shaft, seats, places) for shaft in axis}
    return Layout(
        places=places,
        heights={shaft: heights[axis[shaft]] * scale for shaft in axis},
        levels=_levels(axis, spans),
        spans=spans,
        outlines=outlines,
        widths={stage: _width(stage, train, outlines) for stage in dict.fromkeys(mesh.stage for mesh in train.meshes)},
        scale=scale,
        exact=all(_is_true(mesh, axis, heights, outlines) for mesh in pair_meshes(train)),
    )


def pair_meshes(train: Train) -> Iterator[Mesh]:
    """Yield the meshes of pairs, whose axes stand still.

    Args:
        train: The graph.
    """
    for mesh in train.meshes:
        if all(train.gear(gear).role is not Role.PLANET for gear in mesh.gears):
            yield mesh


def _axes(train: Train, seats: Sequence[Attachment]) -> dict[str, int]:
    """Return shaft -> number of its axis line."""
    axis = {shaft: k for k, shaft in enumerate(node for node in train.nodes if _is_shaft(node, train))}
    joined = [{seat.shaft for seat in seats if element(seat) == name} for name in _coaxial(train, seats)]
    for shafts in joined:
        lowest = min(axis[shaft] for shaft in shafts)
        merged = {axis[shaft] for shaft in shafts}
        axis = {shaft: lowest if number in merged else number for shaft, number in axis.items()}
    return axis


def _is_shaft(node: str, train: Train) -> bool:
    return all(node not in gear.nodes for gear in train.gears if gear.role is Role.PLANET)


def _coaxial(train: Train, seats: Sequence[Attachment]) -> list[str]:
    """Return the planetary sets, clutches and dampers."""
    sets = {gear.stage for gear in train.gears if gear.role is Role.PLANET}
    return list(
        dict.fromkeys(
            element(seat) for seat in seats if seat.stage in sets or seat.member in (Kind.CLUTCH, Kind.DAMPER)
        )
    )


def centre_distance(mesh: Mesh, outlines: Mapping[str, Outline]) -> float:
    """Return the centre distance of a mesh [m].

    Args:
        mesh: Of a pair.
        outlines: Gear -> what is drawn of it.
    """
    first, second = (outlines[gear].radius for gear in mesh.gears)
    return abs(second - mesh.sign * first)


def _heights(train: Train, axis: Mapping[str, int], outlines: Mapping[str, Outline]) -> dict[int, float]:
    """Return axis -> height [m]: apart by the centre distance, and back towards the middle where paths meet."""
    heights = {axis[next(iter(axis))]: 0.0}
    direction = {axis[next(iter(axis))]: 0.0}
    meshes = list(pair_meshes(train))
    while True:
        stage = next((mesh.stage for mesh in meshes if _is_open(mesh, axis, heights)), None)
        if stage is None:
            break
        joined: dict[int, list[tuple[int, float]]] = {}
        for mesh in meshes:
            ends = [axis[node] for node in mesh.nodes[:2]]
            for known, new in (ends, ends[::-1]):
                if mesh.stage == stage and known in heights and new not in heights:
                    joined.setdefault(new, []).append((known, centre_distance(mesh, outlines)))
        for place, (new, origins) in enumerate(joined.items()):
            heights[new], direction[new] = _height(origins, heights, direction, place=place, among=len(joined))
    for shaft in axis:
        if axis[shaft] not in heights:
            heights[axis[shaft]] = min(heights.values()) - max(outline.radius for outline in outlines.values())
    return heights


def _is_open(mesh: Mesh, axis: Mapping[str, int], heights: Mapping[int, float]) -> bool:
    return (axis[mesh.nodes[0]] in heights) != (axis[mesh.nodes[1]] in heights)


def _height(
    origins: list[tuple[int, float]], heights: Mapping[int, float], direction: Mapping[int, float],
    *, place: int, among: int,
) -> tuple[float, float]:  # fmt: skip
    """Return height and direction of a new axis: the place-th among those that one stage joins."""
    if len(origins) > 1:
        folded = [heights[known] - (distance if heights[known] > 0.0 else -distance) for known, distance in origins]
        return sum(folded) / len(folded), 0.0
    known, distance = origins[0]
    side = direction[known] or -1.0 if among == 1 else (1.0, -1.0)[place % 2]
    return heights[known] + side * distance * (1 + place // 2), side


def _is_true(
    mesh: Mesh, axis: Mapping[str, int], heights: Mapping[int, float], outlines: Mapping[str, Outline]
) -> bool:
    drawn = abs(heights[axis[mesh.nodes[0]]] - heights[axis[mesh.nodes[1]]])
    return abs(drawn - centre_distance(mesh, outlines)) <= TRUE * centre_distance(mesh, outlines)


def _scale(heights: Mapping[int, float], outlines: Mapping[str, Outline]) -> float:
    largest = max((outline.radius + outline.rim for outline in outlines.values()), default=0.1)
    spread = max(heights.values()) - min(heights.values()) + 2.0 * largest
    return 1.0 / max(largest / LARGEST, spread / TALLEST)


def _places(
    train: Train, seats: Sequence[Attachment], axis: Mapping[str, int],
    *, outlines: Mapping[str, Outline], scale: float, kinds: Mapping[str, str],
) -> dict[str, Place]:  # fmt: skip
    """Return the columns: from the turbines on, machines before their stages, propellers last."""
    distance = _distances(train, seats, kinds)
    machines = set(train.machines)
    leaf = _leaves(seats, distance, kinds, machines)

    def rank(name: str) -> tuple[int, int]:
        if name in leaf:
            return distance[leaf[name]], 1
        if name in machines:
            return distance[name], CONSUMERS.get(kinds.get(name, ""), 0)
        return distance[name], 2 if name in leaf.values() else 3

    lines = {name: {axis[seat.shaft] for seat in seats if element(seat) == name} for name in distance}
    slots: list[list[str]] = []
    for name in sorted(distance, key=rank):
        beside = slots[-1] if slots and all(rank(earlier) == rank(name) for earlier in slots[-1]) else []
        if beside and all(lines[name].isdisjoint(lines[earlier]) for earlier in beside):
            beside.append(name)
        else:
            slots.append([name])
    half = {name: _half(name, train, outlines, scale) for name in distance}
    places, x = {}, 0.0
    for slot in slots:
        widest = max(half[name] for name in slot)
        places.update({name: Place(x + widest, widest) for name in slot})
        x += 2.0 * widest + GAP
    return places


def _distances(train: Train, seats: Sequence[Attachment], kinds: Mapping[str, str]) -> dict[str, int]:
    """Return element -> shafts between it and the nearest turbine (or motor, or the first machine)."""
    names = list(dict.fromkeys(element(seat) for seat in seats))
    sources = [name for name in names if kinds.get(name) == "turbine"]
    sources = sources or [name for name in names if kinds.get(name) == "motor"] or names[:1]
    distance = dict.fromkeys(sources, 0)
    while True:
        reached = {seat.shaft: distance[element(seat)] for seat in reversed(seats) if element(seat) in distance}
        new = {element(seat): reached[seat.shaft] + 1 for seat in seats
               if seat.shaft in reached and element(seat) not in distance}  # fmt: skip
        if not new:
            break
        nearest = min(new.values())
        distance |= {name: steps for name, steps in new.items() if steps == nearest}
    far = max(distance.values(), default=0) + 1
    return {name: distance.get(name, far) for name in names}


def _leaves(
    seats: Sequence[Attachment], distance: Mapping[str, int], kinds: Mapping[str, str], machines: set[str]
) -> dict[str, str]:
    """Return machine -> stage for those that feed a stage from a shaft of their own; they stand just before it."""
    leaf = {}
    for name in machines:
        shaft = next(seat.shaft for seat in seats if seat.member is Kind.MACHINE and seat.part.name == name)
        beside = [element(seat) for seat in seats if seat.shaft == shaft and element(seat) != name]
        nearer = beside and all(distance[neighbour] < distance[name] for neighbour in beside)
        if nearer and kinds.get(name) not in CONSUMERS:
            leaf[name] = min(beside, key=distance.__getitem__)
    return leaf


def _half(name: str, train: Train, outlines: Mapping[str, Outline], scale: float) -> float:
    if name in train.machines:
        return MACHINE_HALF
    width = _width(name, train, outlines)
    return CLUTCH_HALF if not width else max(STAGE_HALF, _columns(name, train) * width * scale / 2.0 + 5.0)


def _columns(stage: str, train: Train) -> int:
    """Return how many gears stand side by side: halves of a pair, suns and rings of a compound set, and its web."""
    if _is_pair(stage, train):
        return max(mesh.count for mesh in train.meshes if mesh.stage == stage)
    central = [gear for gear in train.gears if gear.stage == stage and gear.own and gear.role is not Role.PLANET]
    return len(central) + 1 if central else 1


def _width(stage: str, train: Train, outlines: Mapping[str, Outline]) -> float:
    return max((outlines[gear.name].width for gear in train.gears if gear.stage == stage), default=0.0)


def _is_pair(name: str, train: Train) -> bool:
    return all(gear.role is not Role.PLANET for gear in train.gears if gear.stage == name)


def _span(shaft: str, seats: Sequence[Attachment], places: Mapping[str, Place]) -> tuple[float, float]:
    on = [places[element(seat)].x for seat in seats if seat.shaft == shaft]
    return (min(on), max(on)) if on else (0.0, 0.0)


def _levels(axis: Mapping[str, int], spans: Mapping[str, tuple[float, float]]) -> dict[str, int]:
    """Return shaft -> level: the longest of an axis inside; those that do not meet share a level."""
    levels: dict[str, int] = {}
    for shaft in largest_first(axis, lambda name: spans[name][1] - spans[name][0]):
        taken = {
            levels[other] for other in levels
            if axis[other] == axis[shaft]
            and min(spans[other][1], spans[shaft][1]) - max(spans[other][0], spans[shaft][0]) > 1.0
        }  # fmt: skip
        levels[shaft] = next(level for level in range(len(axis) + 1) if level not in taken)
    return levels


# ----------------------------------------------------------------------------------------------------------------------
# The signs of a skeleton diagram: gears as bars of pitch radius and face width, carriers, ground, machines.
# ----------------------------------------------------------------------------------------------------------------------


THIN, LINE, BOLD = 0.7, 1.3, 2.2
"""Line widths [pt]."""
HOLLOW = 2.2
"""Distance from one level of nested shafts to the next [mm]."""
LEAST_WIDTH, LEAST_WALL = 2.0, 1.4
"""Least width of a gear and wall of a ring [mm]."""
MACHINE_HEIGHT = 10.0
"""Half the height of a motor [mm]."""
WALL = 2.0
"""Depth of the ground's hatching [mm]."""


@dataclass(frozen=True)
class Member:
    """A sun, ring or carrier."""

    grounded: bool
    side: float
    """Where its shaft leaves: −1 left, +1 right."""
    level: int
    """Of its shaft."""


@dataclass(frozen=True)
class PlanetaryShape:
    """A planetary set on paper."""

    x: float
    y: float
    sun: float
    """Radii [mm]."""
    planet: float
    ring: float
    wall: float
    """Of the ring [mm]."""
    width: float
    """Of the gears [mm]."""
    members: Mapping[Role | Kind, Member]
    """sun, ring and carrier."""


FILLS = {
    Role.SUN: DARK_STEEL, Role.PLANET: PALE_STEEL, Role.RING: DEEP_STEEL, Role.PINION: DARK_STEEL,
    Role.WHEEL: theme.STEEL,
}  # fmt: skip
"""Shade of each kind of gear, so that neighbours differ."""

Spot = tuple[float, float, float, float]
"""Left, low, width, height [mm]."""


def bar(axes: Axes, spot: Spot, role: Role) -> None:
    """Draw a gear seen from its side.

    Args:
        axes: In mm of paper.
        spot: Where.
        role: What kind of gear.
    """
    axes.rectangle(spot[:2], *spot[2:], fc=FILLS[role], ec=theme.INK, lw=THIN, zorder=4)


def line(axes: Axes, points: list[tuple[float, float]], width: float = LINE) -> None:
    """Draw a shaft, an arm or a web.

    Args:
        axes: In mm of paper.
        points: [mm].
        width: [pt].
    """
    axes.plot([x for x, _ in points], [y for _, y in points], color=theme.INK, lw=width, zorder=5)


def ground(axes: Axes, spot: Spot) -> None:
    """Draw the hatching of what stands still.

    Args:
        axes: In mm of paper.
        spot: Where.
    """
    axes.rectangle(spot[:2], *spot[2:], hatched=True, zorder=3)


def planetary(axes: Axes, shape: PlanetaryShape) -> None:
    """Draw a planetary set, above and below its axis.

    Args:
        axes: In mm of paper.
        shape: The set.
    """
    half = shape.width / 2.0
    bar(axes, (shape.x - half, shape.y - shape.sun, shape.width, 2.0 * shape.sun), Role.SUN)
    pin = shape.sun + shape.planet
    for up in (1.0, -1.0):
        middle = shape.y + up * pin
        bar(axes, (shape.x - half, middle - shape.planet, shape.width, 2.0 * shape.planet), Role.PLANET)
        low = shape.y + up * shape.ring - (0.0 if up > 0.0 else shape.wall)
        bar(axes, (shape.x - half, low, shape.width, shape.wall), Role.RING)
        _ring(axes, shape, up)
        _carrier(axes, shape, up, middle)
    sun = shape.members[Role.SUN]
    if sun.grounded:
        reach = shape.x + sun.side * (half + 5.0)
        line(axes, [(shape.x, shape.y), (reach, shape.y)], BOLD)
        ground(axes, (min(reach, reach + sun.side * WALL), shape.y - 3.0, WALL, 6.0))
        line(axes, [(reach, shape.y - 3.0), (reach, shape.y + 3.0)], THIN)


def _ring(axes: Axes, shape: PlanetaryShape, up: float) -> None:
    ring, half = shape.members[Role.RING], shape.width / 2.0
    outer = shape.y + up * (shape.ring + shape.wall)
    if ring.grounded:
        ground(axes, (shape.x - half - 2.5, min(outer, outer + up * WALL), shape.width + 5.0, WALL))
        line(axes, [(shape.x - half - 2.5, outer), (shape.x + half + 2.5, outer)], LINE)
        return
    web, middle = shape.x + ring.side * (half + 5.0), shape.y + up * (shape.ring + shape.wall / 2.0)
    line(axes, [(shape.x + ring.side * half, middle), (web, middle), (web, shape.y + up * ring.level * HOLLOW)], BOLD)


def _carrier(axes: Axes, shape: PlanetaryShape, up: float, middle: float) -> None:
    carrier, half = shape.members[Kind.CARRIER], shape.width / 2.0
    arm = shape.x + carrier.side * (half + 2.5)
    line(axes, [(shape.x - carrier.side * (half + 1.2), middle), (arm, middle)], BOLD)
    if carrier.grounded:
        ground(axes, (min(arm, arm + carrier.side * WALL), middle - 3.0, WALL, 6.0))
        line(axes, [(arm, middle - 3.0), (arm, middle + 3.0)], LINE)
    else:
        line(axes, [(arm, middle + up * 0.4), (arm, shape.y + up * carrier.level * HOLLOW)], BOLD)


def wheel(
    axes: Axes, at: tuple[float, float], reach: tuple[float, float], *, width: float, halves: int, role: Role
) -> None:
    """Draw a gear of a pair, two halves with their opposite hands where it is double-helical.

    Args:
        axes: In mm of paper.
        at: Where its axis is (x, y) [mm].
        reach: Radius below and above its axis [mm].
        width: Of one half [mm].
        halves: 1 or 2.
        role: Pinion or wheel.
    """
    x, y = at
    down, up = reach
    gap = 1.0 if halves > 1 else 0.0
    left = x - (halves * width + (halves - 1) * gap) / 2.0
    for half in range(halves):
        start = left + half * (width + gap)
        bar(axes, (start, y - down, width, down + up), role)
        if halves > 1:
            slope = min(0.5 * width, 0.3 * (down + up)) * (1.0 if half == 0 else -1.0)
            for share in (0.22, 0.5, 0.78):
                height = y - down + share * (down + up)
                axes.plot([start, start + width], [height - slope / 2.0, height + slope / 2.0], color=theme.MUTED,
                          lw=0.5, zorder=4.5)  # fmt: skip


def internal_wheel(axes: Axes, at: tuple[float, float], radius: float, width: float) -> None:
    """Draw an internal gear, its toothed ring on the side of its pinion.

    Args:
        axes: In mm of paper.
        at: Where its axis is (x, y) [mm].
        radius: Signed: positive if the pinion is above the axis [mm].
        width: [mm].
    """
    x, y = at
    wall = 3.0 if radius > 0.0 else -3.0
    bar(axes, (x - width / 2.0, min(y + radius, y + radius + wall), width, abs(wall)), Role.RING)
    web = x + width / 2.0 + 2.5
    line(axes, [(x + width / 2.0, y + radius + wall / 2.0), (web, y + radius + wall / 2.0), (web, y)], BOLD)


def machine(axes: Axes, at: tuple[float, float], kind: str, *, at_left: bool, around: bool) -> None:
    """Draw a machine: a turbine widens along its flow, a motor is a box, a propeller has blades.

    Args:
        axes: In mm of paper.
        at: Where its shaft is (x, y) [mm].
        kind: turbine, motor or propeller; anything else is a plain box.
        at_left: It sits at the left end of its shaft.
        around: Its shaft goes on to both sides.
    """
    x, y = at
    if kind == "turbine" and not around:
        near, far = (x + 8.0, x - 8.0) if at_left else (x - 8.0, x + 8.0)
        _solid(axes, [(far, y - 5.0), (near, y - 10.0), (near, y + 10.0), (far, y + 5.0)])
    elif kind in ("propeller", "rotor"):
        for up in (1.0, -1.0):
            axes.shape(
                circle((x, y + up * 15.0), 4.0, 25.0), cubic=True, fc=theme.STEEL, ec=theme.INK, lw=LINE, zorder=6
            )
        nose = 1.0 if not at_left else -1.0
        _solid(axes, [(x - nose * 3.0, y - 3.5), (x - nose * 3.0, y + 3.5), (x + nose * 7.0, y)])
    else:
        height, depth = MACHINE_HEIGHT, 4.5 if around else 6.0
        box = [(x - 7.0, y - height), (x + 7.0, y - height), (x + 7.0, y + height), (x - 7.0, y + height)]
        axes.shape(box, fc=theme.STEEL, ec=theme.INK, lw=LINE, zorder=4.6 if around else 6.0)
        for side in (depth, -depth):
            axes.plot([x - 7.0, x + 7.0], [y + side, y + side], color=theme.INK, lw=THIN, zorder=6.1)


def _solid(axes: Axes, corners: list[tuple[float, float]]) -> None:
    axes.shape(corners, fc=theme.STEEL, ec=theme.INK, lw=LINE, zorder=6.2)


def clutch(axes: Axes, at: tuple[float, float], *, overrunning: bool, open_now: bool) -> None:
    """Draw a clutch: two plates, with an arrow head if it transmits only one way.

    Args:
        axes: In mm of paper.
        at: Its middle (x, y) [mm].
        overrunning: It transmits only from driving to driven.
        open_now: It does not transmit in this case.
    """
    x, y = at
    gap = 1.8 if open_now else 0.8
    for side in (-gap, gap):
        line(axes, [(x + side, y - 4.0), (x + side, y + 4.0)], BOLD)
    if overrunning:
        axes.shape([(x - 1.5, y + 5.0), (x - 1.5, y + 8.0), (x + 2.0, y + 6.5)], fc=theme.INK, zorder=5)


def damper(axes: Axes, at: tuple[float, float]) -> None:
    """Draw a viscous damper: a piston in an open cylinder.

    Args:
        axes: In mm of paper.
        at: Its middle (x, y) [mm].
    """
    x, y = at
    line(axes, [(x + 2.0, y + 3.0), (x - 1.6, y + 3.0), (x - 1.6, y - 3.0), (x + 2.0, y - 3.0)], BOLD)
    line(axes, [(x + 0.8, y - 2.0), (x + 0.8, y + 2.0)], BOLD)
