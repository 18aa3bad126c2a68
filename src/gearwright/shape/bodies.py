"""The solids of gears, shafts, carriers and housings."""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple
from zlib import crc32

import numpy as np

from gearwright.base import HOUSING, Floats, Kind, PartId, Role
from gearwright.parts.bevel_geometry import Hand, bevel_way
from gearwright.parts.gears import Blank, transverse_form
from gearwright.shape.casings import (
    FLANGES,
    MOUNT,
    RIB,
    SCREW,
    Joint,
    Taken,
    flange_halves,
    flange_screw,
    lugs_on,
    placed_screws,
    ribs_on,
    rods_of,
)
from gearwright.shape.chambers import Chamber, End, Opening, chamber_volume, has_room, round_hole
from gearwright.shape.solids import (
    Arm,
    Fastener,
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
from gearwright.shape.stands import Axes, Node, Stand, axes_at, halves_of, hand_of, kind_of, meshes_of, middle_of
from gearwright.sizing import Body, CarrierSizing, Direction, GearSizing, Point, Sizing, Station
from gearwright.sizing.arrangement import helix_hand
from gearwright.sizing.casing import RingSeat, bosses_of, cover_at, housed, lands_of, ring_cuts, shell_of
from gearwright.sizing.housing_shell import (
    LEAST,
    SAME,
    SAME_CORNER as NEAR,
    Stretch,
    fits,
    inside_of,
    loop_around,
    rooms_around,
)
from gearwright.sizing.inner_walls import inner_walls
from gearwright.sizing.mass import (
    MOUNTS,
    RIBS,
    Bridge,
    Cage,
    Plate,
    bevel_cones as bevel_pair,
    bevel_dish,
    bevel_hub,
    bevel_web,
    carried_in_walls,
    pinion_of,
    ring_outside,
    tooth_of,
    weighed_flanges,
    weighed_wall,
)
from gearwright.sizing.places import Bell, Run
from gearwright.sizing.shafts import Holder, Leaving, holders_of, leaving_of

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
    return None if outer - inner < LEAST_RING else bearing(inner, outer, halves * gear.face_width)


# ----------------------------------------------------------------------------------------------------------------------
# The solids of a housing: the shell that is weighed, chamber by chamber, its flanges, bosses around bearings.
# ----------------------------------------------------------------------------------------------------------------------


BEFORE = 1e-3
"""Between a wall and the end of what turns before it [m], an assumption."""
LIP = 2e-4
"""How far a plate stands inside of its own wall [m]."""
SAME_WAY = 1e-9
"""How far directions of one line may differ [-]."""
CHAMBER, COLLAR, WEB, INNER = "chamber", "collar", "web", "inner wall"
"""What pieces of the shell, tubes and flat walls that carry bosses, and walls between stages are named."""
BESIDE = 5e-4
"""Between a cover and the hole of the wall in which it lies [m], an assumption."""
SPANNER = 0.02
"""Between the edge of an opening in a side and the screws of a flange [m], an assumption."""
AROUND = 1.06
"""Hole for a shaft over the shaft's diameter [-]: as much as the housing leaves around what turns."""


STEPS, ALIKE = 8, 1e-3
"""How often a wall is tried, and how near the metal is to what is weighed [-]."""
Hole = tuple[tuple[float, float], Floats, tuple[float, ...]]
"""Where along the first shaft plates may stand that it goes through, middle across it and radii of a hole, of which the
first that fits is taken [m]."""
Ways = tuple[list[Hole], list[tuple[Opening, ...]]]
"""Through plates, and through walls, of which the first that fits is taken."""


class Piece(NamedTuple):
    """A solid of the housing and where it stands."""

    name: str
    key: str
    """Equal solids share one."""
    solid: Chamber | Solid | Fastener
    axes: Axes


def housing_nodes(
    sizing: Sizing, drawn: tuple[Run, ...], inside: Iterable[tuple[Node, Solid]]
) -> Iterator[tuple[Node, Chamber | Solid | Fastener]]:
    """Yield the housing's pieces; none where the gearbox has none of its own.

    Args:
        sizing: As sized.
        drawn: Shafts as they are drawn.
        inside: Bodies on shafts and carriers, about their own axes, with their solids.
    """
    still = dict.fromkeys(sizing.flows, 0.0)
    bodies = [*housed(sizing), *(_envelope(node, solid, _within(sizing, node)) for node, solid in inside)]
    for piece in _pieces(sizing, drawn, bodies) if sizing.design.housing.own else ():
        look = SCREW if isinstance(piece.solid, Fastener) else "housing"
        yield Node(piece.name, HOUSING, look, piece.key, piece.axes, 0.0, still), piece.solid


def _within(sizing: Sizing, node: Node) -> tuple[float, float]:
    """Return between which places about its own z a body is in the housing: a shaft less the ends that leave [m]."""
    low, high = -math.inf, math.inf
    for leaving in leaving_of(sizing) if node.look == "shaft" else ():
        if leaving.shaft == node.part.name:
            frame = sizing.arrangement.frames[leaving.shaft]
            middle = float((node.axes.origin - np.array(frame.origin)) @ np.array(frame.along))
            low, high = (low, leaving.start - middle) if leaving.start else (leaving.end - middle, high)
    return low, high


def _envelope(node: Node, solid: Solid, within: tuple[float, float]) -> Body:
    """Return the circles between which a body lies, as far as it is in the housing, with room for its ends."""
    circles = list(solid.profile)
    for section in solid.sections[:: max(len(solid.sections) - 1, 1)]:
        radius = float(section.radius.max())
        circles += [(float(section.height.min()), radius), (float(section.height.max()), radius)]
    places = [place for place, _ in circles]
    room = {min(places): min(places) - BEFORE, max(places): max(places) + BEFORE}
    circles = [(min(max(room.get(place, place), within[0]), within[1]), radius) for place, radius in circles]
    low = min(place for place, _ in circles)
    stations = tuple(Station(place - low, radius) for place, radius in sorted(circles))
    axis = node.axes.along
    return Body(HOUSING, "", "", Point(*(node.axes.origin + low * axis)), Direction(*axis), stations)


def _pieces(sizing: Sizing, drawn: tuple[Run, ...], bodies: Sequence[Body]) -> Iterator[Piece]:
    shell = shell_of(sizing)
    weighed = wall = weighed_wall(sizing).thickness
    stretches = _beside_rings(rooms_around(bodies, wall), ring_cuts(sizing))
    metal = shell.area * wall if sizing.design.housing.wall is None else None
    through = [*_leaving(sizing, drawn), *_leaving_built(sizing)], list(_across(sizing))
    wall, chambers = _as_weighed(stretches, through, wall, metal)
    axes = Axes(np.zeros(3), np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]))
    for k, chamber in enumerate(chambers):
        name = f"housing, {CHAMBER} {k + 1}"
        yield Piece(name, name, chamber, axes)
    flanges = weighed_flanges(sizing)
    taken = [list(_outside(stretch, through, wall)) for stretch in stretches]
    halves = list(flange_halves(flanges, stretches, wall, taken, ring_cuts(sizing)))
    for k, (place, key, half) in enumerate(halves):
        moved = Axes(np.array([place, 0.0, 0.0]), axes.turned)
        yield Piece(f"housing, {FLANGES} {k // 2 + 1}{'ab'[k % 2]}", f"housing {FLANGES}{key}", half, moved)
    screw = flange_screw(flanges.thread)
    for name, at in placed_screws(flanges, [(place, half) for place, _, half in halves[1::2]]):
        yield Piece(name, f"housing {SCREW}", screw, Axes(at, axes.turned))
    yield from _standing(sizing, drawn, chambers, halves, metal or shell.area * wall)
    bosses = bosses_of(sizing, holders_of(sizing))
    for part, body in bearing_bodies(sizing):
        name, span = f"housing, boss of {part}", (-body.length / 2.0, body.length / 2.0)
        boss = tube(span, bosses[part.name] / 2.0, body.radius)
        yield Piece(name, name, boss, axes_at(sizing.arrangement.frames[body.shaft], middle_of(body)))
    yield from _carrying(sizing)
    for k, inner in enumerate((one for one in inner_walls(sizing, weighed) if one.fits), start=1):
        name, moved = f"housing, {INNER} {k}", Axes(np.array([inner.span[0], 0.0, 0.0]), axes.turned)
        yield Piece(name, name, Chamber(inner.outer, inner.inner, (0.0, inner.span[1] - inner.span[0])), moved)
    for land in lands_of(sizing, weighed):
        for k, piece in enumerate(land.pieces, start=1):
            name, width = f"housing, land {k}, {land.seat.ring.name}", piece.span[1] - piece.span[0]
            moved = Axes(np.array([piece.span[0], 0.0, 0.0]), axes.turned)
            yield Piece(name, name, Chamber(piece.outer, piece.inner, (0.0, width)), moved)


def _beside_rings(stretches: list[Stretch], cuts: Sequence[tuple[float, float]]) -> list[Stretch]:
    """Return cross-sections without those lengths on which a ring stands in place of the wall."""
    found = list(stretches)
    for low, high in cuts:
        parts = [(one, (one.start, min(one.end, low)), (max(one.start, high), one.end)) for one in found]
        found = [one._replace(start=start, end=end) for one, *spans in parts for start, end in spans if end > start]
    return found


def _outside(own: Stretch, leaving: Ways, wall: float) -> Iterator[tuple[float, float]]:
    """Yield between which places ends of shafts and their covers stand outside of the wall of a cross-section [m]."""
    outside = inside_of(own, wall) + wall
    for (low, high), middle, radii in leaving[0]:
        if not fits(outside, middle, max(radii)):
            yield low, high
    for choices in leaving[1]:
        radius = max(opening.radius for opening in choices) + SPANNER
        yield float(choices[0].middle[2]) - radius, float(choices[0].middle[2]) + radius


def _carrying(sizing: Sizing) -> Iterator[Piece]:
    """Yield the collars and webs that carry bosses."""
    for carried in carried_in_walls(sizing):
        for k, collar in enumerate(carried.collars, start=1):
            name, half = f"housing, {COLLAR} {k} of {collar.bearing}", (collar.span[1] - collar.span[0]) / 2.0
            frame = sizing.arrangement.frames[collar.shaft]
            middle = np.asarray(frame.origin) + (collar.span[0] + half) * np.asarray(frame.along)
            yield Piece(name, name, tube((-half, half), collar.outer, collar.inner), axes_at(frame, middle))
        for k, web in enumerate(carried.webs, start=1):
            name = f"housing, {WEB} {k} of {web.bearing}"
            axes = Axes(web.start + web.length / 2.0 * web.way, np.column_stack([web.along, -web.across, web.way]))
            yield Piece(name, name, block(web.thickness, web.width, web.length), axes)


def _standing(
    sizing: Sizing, drawn: tuple[Run, ...], chambers: list[Chamber], halves: list[tuple[float, str, Chamber]],
    skin: float,
) -> Iterator[Piece]:  # fmt: skip
    """Yield mounts and ribs on the outside, as heavy as they are weighed for a shell of so much metal [m³]."""
    flanges = weighed_flanges(sizing)
    joints = [Joint(int(key) - 1, place, half) for place, key, half in halves[1::2]]
    wall = float(np.max(chambers[0].outer[:, 0]) - np.max(chambers[0].inner[:, 0]))
    rods = rods_of(sizing, drawn)
    lugs = lugs_on(chambers, joints, MOUNTS * skin, rods)
    for k, lug in enumerate(lugs):
        form = crc32(np.round(lug.outline, 8).tobytes())
        yield Piece(f"housing, {MOUNT} {k + 1}", f"housing {MOUNT} {form}", *lug.placed)
    taken = [Taken(lug.foot, lug.span, lug.width / 2.0) for lug in lugs]
    ribs = ribs_on(chambers, joints, flanges, wall, RIBS * skin, rods=rods, taken=taken)
    for k, (size, solid, axes) in enumerate(ribs):
        yield Piece(f"housing, {RIB} {k + 1}", f"housing {RIB} {size}", solid, axes)


def _as_weighed(
    stretches: list[Stretch], leaving: Ways, wall: float, metal: float | None
) -> tuple[float, list[Chamber]]:
    """Return the wall with which the chambers have the metal that is weighed, A t of a thin shell, and the chambers.

    A wall that the design gives stands: no metal is asked for.
    """
    for _ in range(STEPS):
        chambers = [_chamber(stretches, k, wall, leaving) for k in range(len(stretches))]
        share = metal / sum(map(chamber_volume, chambers)) if metal else 1.0
        if abs(share - 1.0) < ALIKE:
            break
        wall *= share
    return wall, chambers


def _chamber(stretches: list[Stretch], k: int, wall: float, leaving: Ways) -> Chamber:
    """Return a chamber; the plate of a step belongs to its wider side, and stands beside what turns in it."""
    own, span, ends = stretches[k], [stretches[k].start, stretches[k].end], list[End | None]()
    for side, way in ((0, -1), (1, 1)):
        beside = stretches[k + way] if 0 <= k + way < len(stretches) else None
        plane = span[side]
        if beside is not None and abs(plane - (beside.start if way > 0 else beside.end)) > SAME:  # a ring between
            ends.append(None)
            continue
        wider = beside is None or bool(np.any(own.reach > beside.reach + SAME))
        if not wider:
            span[side] -= way * wall
            ends.append(None)
            continue
        span[side] += way * wall
        holes = [] if beside is None else [loop_around(np.minimum(inside_of(own, wall) - LIP, inside_of(beside, wall)))]
        for (low, high), middle, radii in leaving[0]:
            is_there = low - LEAST * wall < plane < high + LEAST * wall
            for radius in radii if is_there else ():
                through = beside is not None and fits(beside.reach + wall, middle, -radius)
                if not through and fits(inside_of(own, wall), middle, radius):
                    holes.append(round_hole(middle, radius))
                    break
        ends.append(End(wall, tuple(holes)))
    inside = inside_of(own, wall)
    found = Chamber(loop_around(inside + wall), loop_around(inside), (span[0], span[1]), (ends[0], ends[1]))
    fitting = [[opening for opening in choices if has_room(found, opening)] for choices in leaving[1]]
    return found._replace(openings=tuple(choices[0] for choices in fitting if choices))


def _leaving(sizing: Sizing, drawn: tuple[Run, ...]) -> Iterator[Hole]:
    """Yield the holes for ends of shafts of a first sizing along the first one that join machines [m]."""
    ends: dict[tuple[float, ...], Hole] = {}
    built = {shaft.name for shaft in sizing.built_shafts}
    for machine, shaft in sizing.train.machines.items():
        if shaft in built:
            continue
        frame, runs = sizing.arrangement.frames[shaft], [run for run in drawn if run.shaft == shaft]
        if abs(frame.along.x) < 1.0 - SAME_WAY or not runs:
            continue
        steps = [step for run in runs for step in run.steps]
        low, high = min(steps), max(steps, key=lambda step: step[1])
        place = sizing.arrangement.plans[shaft].places[machine]
        end, radius = (low[0], low[2]) if place - low[0] < high[1] - place else (high[1], high[2])
        place = frame.origin.x + end * frame.along.x
        found = ((place, place), np.array([frame.origin.y, frame.origin.z]), (AROUND * radius,))
        key = tuple(np.round([place, *found[1]], 4))
        ends[key] = max(ends.get(key, found), found, key=lambda one: one[2])  # one shaft within the other
    yield from ends.values()


def _passing(sizing: Sizing) -> Iterator[tuple[Leaving, tuple[float, ...]]]:
    """Yield the ends of shafts that leave, and radii of holes: for the cover there, for what goes round there [m]."""
    holders = holders_of(sizing)
    for leaving in leaving_of(sizing):
        around = [holder.outer / 2.0 for holder in holders
                  if holder.shaft == leaving.shaft and holder.turns
                  and holder.start > leaving.start - NEAR and holder.end < leaving.end + NEAR]  # fmt: skip
        cover = cover_at(holders, leaving)
        wide = () if cover is None else (cover.outer / 2.0 + BESIDE,)
        yield leaving, (*wide, AROUND * max([leaving.radius, *around]))


def _leaving_built(sizing: Sizing) -> Iterator[Hole]:
    """Yield the holes for ends of built shafts along the first one that leave towards machines [m]."""
    for leaving, radii in _passing(sizing):
        frame = sizing.arrangement.frames[leaving.shaft]
        if abs(frame.along.x) > 1.0 - SAME_WAY:
            places = sorted(frame.origin.x + at * frame.along.x for at in (leaving.start, leaving.end))
            yield (places[0], places[1]), np.array([frame.origin.y, frame.origin.z]), radii


def _across(sizing: Sizing) -> Iterator[tuple[Opening, ...]]:
    """Yield the openings for ends of built shafts square to the first one, of which the first that fits is taken."""
    for leaving, radii in _passing(sizing):
        frame = sizing.arrangement.frames[leaving.shaft]
        if abs(frame.along.x) < SAME_WAY:
            sign, place = (1.0, leaving.start) if leaving.start else (-1.0, leaving.end)
            along, origin = (np.array([one.y, one.z, one.x]) for one in (frame.along, frame.origin))
            yield tuple(Opening(sign * along[:2], origin + place * along, radius) for radius in radii)
