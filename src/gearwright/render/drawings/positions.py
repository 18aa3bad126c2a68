"""Where shafts lie in the plane of a drawing, and where its section runs through space."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, pairwise, permutations
from typing import NamedTuple

import numpy as np

from gearwright.base import Floats, Kind, smallest_first
from gearwright.render.drawings.entities import TEXT, Entity, Layer, Path, Words, arrow
from gearwright.render.drawings.shaft_view import MM
from gearwright.render.skeleton import pair_meshes
from gearwright.shape.chambers import Leg, spans_in
from gearwright.shape.stands import gear_of, halves_of, kind_of, sized_mesh
from gearwright.sizing import Frame, Sizing
from gearwright.sizing.casing import boss_bodies
from gearwright.sizing.mass.bodies import bevel_cones as bevel_pair
from gearwright.sizing.places import PLATE_GAP as GAP, runs
from gearwright.sizing.shafts import holders_of
from gearwright.spec import GROUND
from gearwright.train import Mesh

# ----------------------------------------------------------------------------------------------------------------------
# Where a shaft lies in the plane of a drawing beside those of parallel axes with which it meshes.
# ----------------------------------------------------------------------------------------------------------------------


TRUE = 0.05
"""How far two gears in mesh may stand from where they mesh before a note says so [mm]."""


@dataclass(frozen=True)
class Lying:
    """A shaft in the plane of the drawing."""

    origin: complex
    """Of its first end [mm]."""
    along: complex
    """Direction to its second end [-]."""
    start: float
    """Where it is drawn from [mm from its first end]."""
    end: float
    """Where it is drawn to [mm from its first end]."""

    def at(self, x: float, radius: float = 0.0) -> complex:
        """Return a point in the plane [mm].

        Args:
            x: From the first end [mm].
            radius: To the left of the axis [mm].
        """
        return self.origin + self.along * complex(x, radius)


@dataclass(frozen=True)
class Join:
    """A mesh that joins a new shaft to one that lies already."""

    mesh: Mesh
    side: int
    """Of the mesh whose shaft lies, 0 or 1."""
    lying: Lying
    """The shaft that lies."""
    at: float
    """Middle of its gear [mm from its first end]."""
    new_at: float
    """Middle of the gear on the new shaft [mm from its first end]."""
    length: float
    """Of the new shaft [mm]."""

    @property
    def new(self) -> str:
        """The new shaft."""
        return self.mesh.nodes[1 - self.side]

    def lay(self, origin: complex, along: complex) -> Lying:
        """Return the new shaft.

        Args:
            origin: Of its first end [mm].
            along: Direction to its second end [-].
        """
        return Lying(origin, along, 0.0, self.length)


def parallel(
    sizing: Sizing, joins: Sequence[Join], shafts: Mapping[str, Lying], places: Mapping[str, Mapping[str, float]]
) -> Lying:
    """Return a shaft that meshes with others: where its gears cover least, then where most of its distances are true.

    Args:
        sizing: What was sized.
        joins: Its meshes with shafts that lie already, the first of parallel axes.
        shafts: That lie already.
        places: Shaft -> gear -> middle of its width [mm from the first end].
    """
    kind = kind_of(sizing, joins[0].mesh.stage)
    widths = _widths(sizing, joins[0].new, places)
    alike = [one for one in joins if kind_of(sizing, one.mesh.stage) == kind]
    choices = []
    for one in alike:
        lying, apart = one.lying, centre_distance(sizing, one.mesh)
        others = [(shaft, _widths(sizing, name, places)) for name, shaft in shafts.items() if shaft is not lying]
        for sign in (1.0, -1.0):
            choice = one.lay(lying.at(one.at - one.new_at, sign * apart), lying.along)
            over = sum(_overlap(choice, widths, other, far) for other, far in others)
            true = sum(abs(_beside_by(choice, each) - centre_distance(sizing, each.mesh)) < TRUE for each in alike)
            off = _off(sizing, joins[0].new, choice, shafts)
            choices.append((over if over > TRUE else 0.0, -true, round(off, 3), choice))
    return min(choices, key=lambda choice: choice[:3])[3]


def _off(sizing: Sizing, new: str, choice: Lying, shafts: Mapping[str, Lying]) -> float:
    """Return by how much distances to shafts along a new one would not be those in space, added up [mm]."""
    frames, off = sizing.arrangement.frames, 0.0
    for name, lying in shafts.items():
        way = np.array(frames[name].along)
        if abs((lying.along * choice.along.conjugate()).imag) < 1e-6:
            between = np.array(frames[new].origin) - np.array(frames[name].origin)
            apart = MM * float(np.linalg.norm(between - (between @ way) * way))
            off += abs(abs(((choice.origin - lying.origin) * lying.along.conjugate()).imag) - apart)
    return off


def _beside_by(choice: Lying, join: Join) -> float:
    """Return how far a shaft would lie from one that it meshes with [mm]."""
    return abs(((choice.origin - join.lying.origin) * join.lying.along.conjugate()).imag)


def centre_distance(sizing: Sizing, mesh: Mesh) -> float:
    """Return the centre distance of a mesh [mm].

    Args:
        sizing: What was sized.
        mesh: Of parallel axes.
    """
    return MM * sized_mesh(sizing, mesh).centre_distance


Widths = list[tuple[float, float, float]]
"""From where to where along a shaft a gear on it is, and its radius [mm]."""


def _widths(sizing: Sizing, shaft: str, places: Mapping[str, Mapping[str, float]]) -> Widths:
    found = []
    for gear in sizing.gears:
        if shaft in gear.shafts and gear.name in places[shaft]:
            middle, half = places[shaft][gear.name], MM * gear.face_width * halves_of(gear) / 2.0
            found.append((middle - half, middle + half, MM * gear.pitch_diameter / 2.0))
    return found


def _overlap(shaft: Lying, widths: Widths, other: Lying, far: Widths) -> float:
    """Return how far the gears of two parallel shafts cover each other, side by side [mm]; 0 for shafts that cross."""
    way = other.along * shaft.along.conjugate()
    if abs(way.imag) > 1e-6:
        return 0.0
    off = (other.origin - shaft.origin) * shaft.along.conjugate()
    over = [
        radius + wide - abs(off.imag)
        for low, high, radius in widths for start, end, wide in far
        if max(low, min(start * way.real, end * way.real) + off.real)
        < min(high, max(start * way.real, end * way.real) + off.real) - TRUE
    ]  # fmt: skip
    return max([0.0, *over])


# ----------------------------------------------------------------------------------------------------------------------
# Where the shafts of a train lie in the plane of a general arrangement, unfolded where no plane holds all axes.
# ----------------------------------------------------------------------------------------------------------------------


_SQUARE = 1e-9
"""One less the cosine of the angle between axes below which they are parallel [-]."""
PLATE_GAP = MM * GAP
"""Between planets and the plate of their carrier [mm]."""


@dataclass(frozen=True)
class Positions:
    """Where everything lies."""

    shafts: Mapping[str, Lying]
    places: Mapping[str, Mapping[str, float]]
    """Shaft -> gear, carrier, machine or clutch -> middle of its width [mm from the first end]."""
    notes: tuple[str, ...] = ()
    """What the plane does not show as it is."""
    unfolded: tuple[str, ...] = ()
    """Mesh rows that are not at their true distance in the plane."""
    exact: bool = True
    """False where some centre distance is not true in the plane."""


def positions(sizing: Sizing) -> Positions:
    """Return where shafts lie: as they stand, those beside each other turned about their mates into one plane.

    Args:
        sizing: What was sized.
    """
    along = sizing.arrangement.plans
    places = {
        name: {part: MM * x for part, x in plan.places.items()} | dict(_in_sets(sizing, name))
        for name, plan in along.items()
    }
    lengths = {name: MM * plan.length for name, plan in along.items()}
    shafts: dict[str, Lying] = {}
    meshes = list(pair_meshes(sizing.train))
    while waiting := [name for name in sizing.design.shafts if name not in shafts]:
        mesh = next((mesh for mesh in meshes if (mesh.nodes[0] in shafts) != (mesh.nodes[1] in shafts)), None)
        lined = next((pair for pair in _in_line(sizing) if (pair[0] in shafts) != (pair[1] in shafts)), None)
        if mesh is not None:
            new = mesh.nodes[1] if mesh.nodes[0] in shafts else mesh.nodes[0]
            shafts[new] = _beside(sizing, list(_joins(meshes, new, shafts, places, lengths[new])), shafts, places)
        elif lined is not None:
            known, new = lined if lined[0] in shafts else lined[::-1]
            shafts[new] = _beyond(sizing, shafts[known], known, new)
        else:
            # Nothing joins it to the others: it lies below them.
            shafts[waiting[0]] = Lying(-1j * 300.0 * len(shafts), 1 + 0j, 0.0, lengths[waiting[0]])
    plane = Positions(_as_drawn(sizing, shafts), places)
    unfolded = tuple(mesh for mesh in meshes if _is_unfolded(sizing, mesh, plane))
    notes = [
        f"Unfolded: {mesh.name} ({mesh.nodes[0]}, {mesh.nodes[1]}) is not at its true distance in this plane."
        for mesh in unfolded
    ]
    notes += [*_turned(sizing, plane), *_apart(sizing)]
    return replace(plane, notes=tuple(notes), unfolded=tuple(mesh.name for mesh in unfolded), exact=not unfolded)


def _as_drawn(sizing: Sizing, shafts: Mapping[str, Lying]) -> dict[str, Lying]:
    """Return shafts, those of a first sizing from where to where their solids reach."""
    built = {shaft.name for shaft in sizing.built_shafts}
    ends: dict[str, list[float]] = {}
    for run in runs(sizing)[0]:
        if run.shaft not in built:
            ends.setdefault(run.shaft, []).extend(MM * place for step in run.steps for place in step[:2])
    return {
        name: replace(lying, start=min(ends[name]), end=max(ends[name])) if ends.get(name) else lying
        for name, lying in shafts.items()
    }


def _in_sets(sizing: Sizing, shaft: str) -> Iterator[tuple[str, float]]:
    """Yield the gears and carriers of the sets on a shaft's axis, each with its middle [mm from the first end]."""
    frame = sizing.arrangement.frames[shaft]
    stages = [name for name, stage in sizing.design.sets.items() if shaft in stage.members]
    for body in sizing.arrangement.bodies:
        if body.part.name in stages and body.part.kind in (Kind.GEAR, Kind.CARRIER):
            start = (np.array(body.origin) - np.array(frame.origin)) @ np.array(frame.along)
            yield str(body.part), MM * (float(start) + body.length / 2.0)


def _in_line(sizing: Sizing) -> Iterator[tuple[str, str]]:
    """Yield shafts of one axis that a set or a clutch joins, two at a time."""
    groups = [stage.members for stage in sizing.design.sets.values()]
    groups += [(link.driving, link.driven) for link in sizing.design.links.values()]
    for group in groups:
        yield from permutations(dict.fromkeys(name for name in group if name != GROUND), 2)


def _beyond(sizing: Sizing, lying: Lying, known: str, new: str) -> Lying:
    """Return a shaft on the axis of one that lies already, as far along it as it stands in space."""
    frames, length = sizing.arrangement.frames, sizing.arrangement.plans[new].length
    step = (np.array(frames[new].origin) - np.array(frames[known].origin)) @ np.array(frames[known].along)
    return Lying(lying.at(MM * float(step)), lying.along, 0.0, MM * length)


def _joins(
    meshes: Sequence[Mesh],
    new: str,
    shafts: Mapping[str, Lying],
    places: Mapping[str, Mapping[str, float]],
    length: float,
) -> Iterator[Join]:
    """Yield the meshes that join a new shaft to those that lie already."""
    for mesh in meshes:
        for side in (0, 1):
            known = mesh.nodes[side]
            if mesh.nodes[1 - side] == new and known in shafts:
                at, new_at = places[known][mesh.gears[side]], places[new][mesh.gears[1 - side]]
                yield Join(mesh, side, shafts[known], at, new_at, length)


def _beside(
    sizing: Sizing, joins: Sequence[Join], shafts: Mapping[str, Lying], places: Mapping[str, Mapping[str, float]]
) -> Lying:
    """Return a shaft that meshes with others that lie already."""
    join = joins[0]
    kind = kind_of(sizing, join.mesh.stage)
    if kind == "bevel":
        return _bevel(sizing, join, _sheet(sizing, shafts))
    if kind == "face":
        return _face(sizing, join, _sheet(sizing, shafts))
    return parallel(sizing, joins, shafts, places)


def _sheet(sizing: Sizing, shafts: Mapping[str, Lying]) -> Floats | None:
    """Return the direction in space that looks out of the sheet: square to two shafts that cross; None without such."""
    frames = sizing.arrangement.frames
    for one, other in combinations(shafts, 2):
        turn = (shafts[one].along.conjugate() * shafts[other].along).imag
        if abs(turn) > _SQUARE:
            out = math.copysign(1.0, turn) * np.cross(frames[one].along, frames[other].along)
            if (length := float(np.linalg.norm(out))) > _SQUARE:
                return np.asarray(out / length)
    return None


def _bevel(sizing: Sizing, join: Join, sheet: Floats | None) -> Lying:
    """Return the other shaft of a bevel pair: through the common apex, to the side on which it stands.

    The first one that crosses another lies with its second end upwards or to the right.
    """
    pair, stage = bevel_pair(sizing, join.mesh.stage), sizing.design.pairs[join.mesh.stage]
    reach = [MM * pair.mean_cone_distance * math.cos(angle) for angle in pair.pitch_angles]
    sense = [1.0 if apex == "second" else -1.0 for apex in (stage.pinion_apex, stage.wheel_apex)]
    lying, side, other = join.lying, join.side, 1 - join.side
    apex = lying.at(join.at + sense[side] * reach[side])
    turns = [cmath.rect(1.0, sign * pair.shaft_angle) for sign in (1.0, -1.0)]
    # Both gears lie on the apex's same side: the angle between the ways from the apex to them is the shaft angle.
    ways = [-sense[side] * lying.along * turn for turn in turns]
    left = 0.0
    if sheet is not None:
        known, new = (np.array(sizing.arrangement.frames[join.mesh.nodes[k]].along) for k in (join.side, 1 - join.side))
        left = float(np.cross(sheet, known) @ new)
    choices = [-sense[other] * way for way in ways]
    along = max(choices, key=lambda way: (round((way / lying.along).imag * left, 6), round(way.imag, 6), way.real))
    return join.lay(apex - along * (join.new_at + sense[other] * reach[other]), along)


def _face(sizing: Sizing, join: Join, sheet: Floats | None) -> Lying:
    """Return the other shaft of a face-gear pair: across, the middle of the pinion on the wheel's pitch circle.

    The first wheel's second end lies to the right of its pinion's way; which sides touch is as in space.
    """
    pinion, wheel = (MM * gear_of(sizing, name).pitch_diameter / 2.0 for name in join.mesh.gears)
    frames = [sizing.arrangement.frames[node] for node in join.mesh.nodes[:2]]
    ways = [np.array(frame.along) for frame in frames]
    places = [
        sizing.arrangement.plans[node].places[gear]
        for node, gear in zip(join.mesh.nodes, join.mesh.gears, strict=False)
    ]
    middles = [np.array(frame.origin) + place * way for frame, place, way in zip(frames, places, ways, strict=True)]
    beside, above = (math.copysign(size, float((middles[1] - middles[0]) @ way))
                     for size, way in zip((wheel, pinion), ways, strict=True))  # fmt: skip
    turn = -1j if sheet is None else 1j * math.copysign(1.0, float(np.cross(ways[0], ways[1]) @ sheet))
    across = join.lying.along if join.side == 0 else join.lying.along / turn
    step = across * (beside + turn * above)
    middle, along = join.lying.at(join.at), across * (turn if join.side == 0 else 1.0)
    middle += step if join.side == 0 else -step
    return join.lay(middle - along * join.new_at, along)


def _between(mesh: Mesh, plane: Positions) -> complex:
    """Return the way from gear a to gear b of a mesh, along and across its axes [mm]."""
    ends = zip(mesh.nodes, mesh.gears, strict=False)
    first, second = (plane.shafts[node].at(plane.places[node][gear]) for node, gear in ends)
    return (second - first) * plane.shafts[mesh.nodes[0]].along.conjugate()


def _is_unfolded(sizing: Sizing, mesh: Mesh, plane: Positions) -> bool:
    """Tell whether a mesh is not at its true distance in the plane."""
    if kind_of(sizing, mesh.stage) != "cylindrical":
        return False
    return abs(abs(_between(mesh, plane).imag) - centre_distance(sizing, mesh)) > TRUE


def _turned(sizing: Sizing, plane: Positions) -> Iterator[str]:
    """Yield the shafts that are not where they stand, but turned about their mates into the plane of the drawing.

    The plane is that of the first two axes which are not one; in it lies what keeps its distance square to it.
    """
    frames = sizing.arrangement.frames
    along = np.array(frames[sizing.design.shafts[0]].along)
    crossing = [name for name in plane.shafts if abs(np.array(frames[name].along) @ along) < 1.0 - _SQUARE]
    if not crossing:
        return
    square = np.cross(along, np.array(frames[crossing[0]].along))
    square /= np.linalg.norm(square)
    level = np.array(frames[crossing[0]].origin) @ square
    for name in plane.shafts:
        off = MM * float(np.array(frames[name].origin) @ square - level)
        if abs(off) > TRUE:
            yield f"Shaft {name} is turned into this plane: it stands {abs(off):.4g} mm off it."


def _apart(sizing: Sizing) -> Iterator[str]:
    """Yield a note for every mesh whose gears do not stand beside each other."""
    for name, off in sizing.arrangement.apart.items():
        yield f"The sizing puts the gears of {name} {MM * abs(off):.1f} mm apart along their axes."


# ----------------------------------------------------------------------------------------------------------------------
# Where the section that a general arrangement shows runs through space, so that a housing is cut where it lies.
#
# Axes along the first shaft are corners of a way across it: from one to the next the section is the plane of both, as
# an unfolded section has it. Where shafts stand square to the first one on a side on which other axes lie, the
# section steps from one plane to the other. It is a true section or none.
# ----------------------------------------------------------------------------------------------------------------------


BESIDE = 0.02
"""From a joint to a step of the section [m]: beyond flanges of common screws."""
FLAT = 1e-9
"""How far a unit vector's part may be from what it should be [-]."""


class Lane(NamedTuple):
    """A stretch of the section along the first shaft that is cut along one way across it."""

    start: float
    """Along the first shaft [m]; −inf of the first one."""
    end: float
    """[m]; inf of the last one."""
    legs: tuple[Leg, ...]
    """Along the way, a place is its height on the sheet [m]."""


class _Across(NamedTuple):
    """A shaft that crosses the first one's direction on the sheet."""

    level: int
    """Number of the axis along the first shaft through which its plane goes."""
    up: Floats
    """What the sheet has upwards, across the first shaft [-], shape (2,)."""
    span: tuple[float, float]
    """What it takes along the first shaft, with its bearings [m]."""
    reach: tuple[float, float]
    """From and to on the sheet's height [m]."""


def lanes(sizing: Sizing, plane: Positions, joints: Sequence[float] = ()) -> tuple[Lane, ...] | None:
    """Return where the section runs, from the first end to the last; None where no true section is what is drawn.

    Args:
        sizing: What was sized.
        plane: Where shafts lie on the sheet.
        joints: Places along the first shaft beside which the section does not step [m].
    """
    frames, flat = sizing.arrangement.frames, dict[str, Lying]()
    for name, lying in plane.shafts.items():
        if abs(lying.along.imag) < FLAT:
            flat[name] = lying
    corners = _corners(frames, flat)
    if corners is None:
        return None
    across = []
    for name, lying in plane.shafts.items():
        if name not in flat:
            one = _across(sizing, name, lying, corners)
            if one is None:
                return None
            across.append(one)
    axes = _axes(sizing, plane, flat)
    return _laid(corners, across, _spans(flat), joints, axes)


class _Axis(NamedTuple):
    """A shaft along the first one."""

    name: str
    height: float
    """On the sheet [m]."""
    foot: Floats
    """Where it stands across the first shaft [m], shape (2,)."""
    reach: float
    """Largest radius on it [m]."""

    def is_crossed(self, leg: Leg) -> bool:
        """Tell whether a leg cuts bodies about it where the sheet does not show them."""
        low, high = max(leg.low, self.height - self.reach), min(leg.high, self.height + self.reach)
        beside = float(np.linalg.norm(leg.foot + self.height * leg.along - self.foot))
        if MM * beside < TRUE and low < high:
            return False
        nearest = min(max(float((self.foot - leg.foot) @ leg.along), leg.low), leg.high)
        return float(np.linalg.norm(leg.foot + nearest * leg.along - self.foot)) < self.reach - TRUE / MM


def _axes(sizing: Sizing, plane: Positions, names: Iterable[str]) -> list[_Axis]:
    frames = sizing.arrangement.frames
    reach = {name: max((body.radius for body in sizing.arrangement.bodies if body.shaft == name), default=0.0)
             for name in names}  # fmt: skip
    return [_Axis(name, plane.shafts[name].origin.imag / MM, np.array(frames[name].origin[1:]), reach[name])
            for name in names]  # fmt: skip


def crossed(sizing: Sizing, plane: Positions, ways: Sequence[Lane]) -> list[str]:
    """Return the shafts whose bodies the section cuts in legs in which the sheet does not show them.

    Args:
        sizing: What was sized.
        plane: Where shafts lie on the sheet.
        ways: From `lanes`.
    """
    level = [name for name, lying in plane.shafts.items() if abs(lying.along.imag) < FLAT]
    return [axis.name for axis in _axes(sizing, plane, level) if any(axis.is_crossed(leg) for leg in ways[0].legs)]


Corners = list[tuple[float, Floats]]
"""Axes along the first shaft: height on the sheet [m], and where it stands across that shaft [m], from below."""


def _corners(frames: Mapping[str, Frame], flat: Mapping[str, Lying]) -> Corners | None:
    """Return the axes along the first shaft; None where the sheet has one of them, or two side by side, elsewhere."""
    found: Corners = []
    for name, lying in flat.items():
        frame, height = frames[name], lying.origin.imag / MM
        if abs(frame.along.x - lying.along.real) > FLAT or abs(MM * frame.origin.x - lying.origin.real) > TRUE:
            return None
        found.append((height, np.array(frame.origin[1:])))
    found = smallest_first(found, lambda corner: corner[0])
    for (low, one), (high, other) in pairwise(found):
        if MM * abs(float(np.linalg.norm(other - one)) - (high - low)) > TRUE:
            return None
    kept = [found[0]] if found else []
    for corner in found[1:]:
        if MM * (corner[0] - kept[-1][0]) > TRUE:
            kept.append(corner)
    return kept or None


def _spans(flat: Mapping[str, Lying]) -> list[tuple[float, float, float]]:
    """Return height, start and end of every shaft along the first one [m]."""
    ends = [(lying.origin.imag, *sorted((lying.at(lying.start).real, lying.at(lying.end).real)))
            for lying in flat.values()]  # fmt: skip
    return [(height / MM, low / MM, high / MM) for height, low, high in ends]


def _across(sizing: Sizing, name: str, lying: Lying, corners: Corners) -> _Across | None:
    """Return a shaft across the first one's direction; None where the sheet does not have it where it stands."""
    frame = sizing.arrangement.frames[name]
    ways = np.array(frame.along[1:]) * math.copysign(1.0, lying.along.imag)
    if abs(frame.along.x - lying.along.real) > FLAT or abs(MM * frame.origin.x - lying.origin.real) > TRUE:
        return None
    up, origin, height = ways / float(np.linalg.norm(ways)), np.array(frame.origin[1:]), lying.origin.imag / MM
    at = next((k for k, (level, foot) in enumerate(corners)
               if MM * float(np.linalg.norm(origin - foot - (height - level) * up)) < TRUE), None)  # fmt: skip
    if at is None:
        return None
    bodies = [body for body in sizing.arrangement.bodies if body.shaft == name and str(body.part.kind) != "gear"]
    bosses = boss_bodies(sizing, holders_of(sizing))
    wide = max([0.0, *(body.radius for body in (*bodies, *bosses.values()) if body.shaft == name)])
    ends = [lying.at(end) / MM for end in (lying.start, lying.end)]
    xs, ys = sorted(end.real for end in ends), sorted(end.imag for end in ends)
    return _Across(at, up, (xs[0] - wide, xs[1] + wide), (ys[0], ys[1]))


def _laid(
    corners: Corners,
    across: list[_Across],
    spans: list[tuple[float, float, float]],
    joints: Sequence[float],
    axes: Sequence[_Axis],
) -> tuple[Lane, ...] | None:
    """Return the lanes: one, or two where shafts across stand beside what is on their side of an axis."""
    first = across[0].up if across else np.array([1.0, 0.0])
    base = _Way.of(corners, first)
    if not across:
        base = base.freed(axes)
    stepped: list[_Across] = []
    for one in across:
        if base.holds(one):
            continue
        beyond = base.beyond(one)
        if beyond is None:
            stepped.append(one)
        else:
            base = beyond
    if not stepped:
        return (Lane(-math.inf, math.inf, base.legs),)
    other = stepped[0]
    if len(stepped) > 1 or not all(base.beyond(one) or base.holds(one) for one in across if one not in stepped):
        return None
    level = corners[other.level][0]
    aside = [span for span in spans if abs(span[0] - level) > TRUE / MM]
    low, high = min(span[1] for span in aside), max(span[2] for span in aside)
    way = _Way(corners[other.level : other.level + 1], (-other.up, other.up))
    if high < other.span[0]:
        step = _step(high, other.span[0], joints)
        return (Lane(-math.inf, step, base.legs), Lane(step, math.inf, way.legs))
    if low > other.span[1]:
        step = _step(other.span[1], low, joints)
        return (Lane(-math.inf, step, way.legs), Lane(step, math.inf, base.legs))
    return None


def _step(low: float, high: float, joints: Sequence[float]) -> float:
    """Return the middle between two places, or a place beside it that is further from joints [m]."""
    tried = [low + share * (high - low) for share in (0.5, 0.375, 0.625, 0.25, 0.75)]
    far = [min((abs(step - joint) for joint in joints), default=math.inf) for step in tried]
    return next((step for step, room in zip(tried, far, strict=True) if room > BESIDE), tried[far.index(max(far))])


class _Way(NamedTuple):
    """A way across the first shaft: its corners, and how it goes on below the first and above the last one."""

    corners: Corners
    beyond_ends: tuple[Floats, Floats]
    """Unit vectors out of both ends [-]."""

    @staticmethod
    def of(corners: Corners, up: Floats) -> _Way:
        """Return the way through all corners, at both ends straight on; of one corner that of a direction."""
        if len(corners) == 1:
            return _Way(corners, (-up, up))
        steps = [(other[1] - one[1]) / (other[0] - one[0]) for one, other in pairwise(corners)]
        return _Way(corners, (-steps[0], steps[-1]))

    def freed(self, axes: Sequence[_Axis]) -> _Way:
        """Return the way with ends that are turned, as little as can be, where straight on they cut other bodies."""
        ends = list(self.beyond_ends)
        for k in (0, 1):
            straight = ends[k]
            for turn in sorted(np.radians(np.arange(-165.0, 180.0, 15.0)), key=abs):
                cos, sin = math.cos(turn), math.sin(turn)
                ends[k] = np.array([cos * straight[0] - sin * straight[1], sin * straight[0] + cos * straight[1]])
                leg = _Way(self.corners, (ends[0], ends[1])).legs[-k]
                if not any(axis.is_crossed(leg) for axis in axes):
                    break
            else:
                ends[k] = straight
        return _Way(self.corners, (ends[0], ends[1]))

    @property
    def legs(self) -> tuple[Leg, ...]:
        """Its straight pieces, from below."""
        low, high = self.corners[0], self.corners[-1]
        below, above = -self.beyond_ends[0], self.beyond_ends[1]
        found = [Leg(-math.inf, low[0], low[1] - low[0] * below, below)]
        for (start, one), (end, other) in pairwise(self.corners):
            along = (other - one) / (end - start)
            found.append(Leg(start, end, one - start * along, along))
        return (*found, Leg(high[0], math.inf, high[1] - high[0] * above, above))

    def at(self, height: float) -> Floats:
        """Return where the way is at a height of the sheet [m]."""
        leg = next(leg for leg in self.legs if height <= leg.high)
        return leg.foot + height * leg.along

    def holds(self, one: _Across) -> bool:
        """Tell whether a shaft lies in the section as it runs."""
        level, foot = self.corners[one.level]
        return all(
            MM * float(np.linalg.norm(self.at(height) - foot - (height - level) * one.up)) < TRUE
            for height in (*one.reach, *(corner for corner, _ in self.corners if one.reach[0] < corner < one.reach[1]))
        )

    def beyond(self, one: _Across) -> _Way | None:
        """Return the way turned beyond its last corner on one side into the plane of a shaft that lies there alone."""
        level = self.corners[one.level][0]
        if one.level == len(self.corners) - 1 and one.reach[0] > level:
            return _Way(self.corners, (self.beyond_ends[0], one.up))
        if one.level == 0 and one.reach[1] < level:
            return _Way(self.corners, (-one.up, self.beyond_ends[1]))
        return None


# ----------------------------------------------------------------------------------------------------------------------
# Where an unfolded section runs, in the view along the first shaft: a cutting plane with corners (ISO 128-3).
# ----------------------------------------------------------------------------------------------------------------------


LETTER = "B"
"""Of the section."""
BEYOND, STROKE, CORNER = 3.0, 6.0, 3.0
"""From the outline to the strokes at both ends, how long those are, and each of the two strokes of a corner [mm]."""
STRAIGHT = 1e-9
"""How far directions of two legs may differ that are one [-]."""


def cutting_way(sizing: Sizing, plane: Positions, covers: Sequence[Floats]) -> tuple[complex, ...]:
    """Return from where to where the section runs, over its corners; nothing where it is one plane, or steps.

    Args:
        sizing: What was sized.
        plane: Where shafts lie on the sheet.
        covers: Outlines of the housing's pieces across the first shaft [m], shape (n, 2) each.

    Returns:
        Points across the first shaft, y to the right and z upwards [mm].
    """
    ways = lanes(sizing, plane)
    if ways is None or len(ways) != 1 or not covers:
        return ()
    legs = ways[0].legs
    if all(abs(float(leg.along @ legs[0].along)) > 1.0 - STRAIGHT for leg in legs):
        return ()
    spans = [span for loop in covers for span in spans_in(loop, legs)]
    heights = [min(span[0] for span in spans), *(leg.high for leg in legs[:-1]), max(span[1] for span in spans)]
    points = [legs[0].foot + heights[0] * legs[0].along]
    points += [leg.foot + height * leg.along for leg, height in zip(legs, heights[1:], strict=True)]
    return tuple(MM * complex(*point.tolist()) for point in points)


def way_marks(way: Sequence[complex]) -> Iterator[Entity]:
    """Yield the strokes at both ends and corners of a section, arrows along which it is seen, and its letters.

    Args:
        way: Its corners from below on the sheet of the section [mm of paper].
    """
    for point, other, sense in ((way[0], way[1], -1.0), (way[-1], way[-2], 1.0)):
        out = (point - other) / abs(point - other)
        looking = -1j * sense * out
        inner, foot = point + BEYOND * out, point + (BEYOND + 0.75 * STROKE) * out
        yield Path((inner, inner + STROKE * out), Layer.OUTLINE)
        yield from (Path((foot, foot - 7.0 * looking), Layer.SYMBOL), arrow(foot, looking, Layer.SYMBOL))
        yield Words(foot - 10.0 * looking - 1j * TEXT / 2.0, LETTER, TEXT, "middle", layer=Layer.SYMBOL)
    for (before, corner), (_, behind) in pairwise(pairwise(way)):
        first, second = ((end - corner) / abs(end - corner) for end in (before, behind))
        if abs(first + second) > STRAIGHT:
            yield Path((corner + CORNER * first, corner, corner + CORNER * second), Layer.OUTLINE)
