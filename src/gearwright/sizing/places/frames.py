"""Positions of shafts and gears in space: parallel, intersecting and coaxial axes, and bevel cones."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from gearwright.base import DesignError, Floats, Role, carrier_part
from gearwright.parts.bevel_geometry import BevelPair
from gearwright.sizing.arrangement import NO_ANGLES, Moves, arrange
from gearwright.sizing.axis_order import set_length, slots
from gearwright.sizing.rating import Context, geometry as standard_teeth
from gearwright.sizing.result import Arrangement, Direction, Frame, GearSizing, Point
from gearwright.spec import GROUND
from gearwright.spec.design import NOTHING_GIVEN
from gearwright.train import Mesh

# ----------------------------------------------------------------------------------------------------------------------
# The cones of a sized bevel pair.
# ----------------------------------------------------------------------------------------------------------------------


def bevel_cones(context: Context, gears: Mapping[str, GearSizing], stage: str) -> BevelPair:
    """Return the cones of a bevel pair; its gears are sized at their mean cones.

    Args:
        context: What sizing reads.
        gears: By name.
        stage: The pair.
    """
    mesh = next(mesh for mesh in context.train.meshes if mesh.stage == stage)
    pinion, wheel = (gears[name] for name in mesh.gears)
    return standard_teeth.bevel_pair(
        (pinion.teeth, wheel.teeth), pinion.module, pinion.face_width, context.ratings[stage]
    )


# ----------------------------------------------------------------------------------------------------------------------
# Where every shaft lies in space: parallel beside its mates, across them in bevel and face meshes, in line in sets.
#
# A mesh, a planetary set or a clutch places the shaft at its other end; the first shaft of the design lies along x.
# What an axis in the cross-section is to its neighbour (`arrangement.axes`) it is in space: the direction in which
# two shafts meet there is the direction in which they meet here, so that loads and places agree.
# ----------------------------------------------------------------------------------------------------------------------


BESIDE = 5e-5
"""How far two gears in mesh may stand from each other along their axes before it is told [m]."""


@dataclass(frozen=True)
class _Join:
    """What places one shaft by another."""

    first: str
    second: str
    at: tuple[float, float]
    """Where they meet, along each [m]."""
    mesh: Mesh | None = None
    """None where they lie in line."""


def frames_of(context: Context, gears: Mapping[str, GearSizing], arrangement: Arrangement) -> dict[str, Frame]:
    """Return the axes of every shaft in space.

    Args:
        context: What sizing reads.
        gears: By name.
        arrangement: Its axes and plans.
    """
    joins = [*_meshes(context, arrangement), *_sets(context, gears, arrangement), *_links(context, arrangement)]
    frames: dict[str, Frame] = {}
    for name in context.design.shafts:
        if name not in frames:
            frames[name] = _free(arrangement.axes[name])
        while join := next((join for join in joins if (join.first in frames) != (join.second in frames)), None):
            side = 0 if join.first in frames else 1
            known, new = (join.first, join.second)[:: 1 if side == 0 else -1]
            frames[new] = _placed(context, gears, arrangement, join, side, frames[known])
    return frames


def apart_of(
    context: Context, gears: Mapping[str, GearSizing], arrangement: Arrangement, frames: Mapping[str, Frame]
) -> dict[str, float]:
    """Return mesh row -> how far its gears stand from where they mesh, along their axes [m].

    Args:
        context: What sizing reads.
        gears: By name.
        arrangement: Its axes and plans.
        frames: From `frames_of`.
    """
    found = {}
    for join in _meshes(context, arrangement):
        if join.mesh is not None and context.design.pairs[join.mesh.stage].kind != "face":
            wanted = _placed(context, gears, arrangement, join, 0, frames[join.first])
            stands = frames[join.second]
            off = float((np.array(stands.origin) - np.array(wanted.origin)) @ np.array(wanted.along))
            if abs(off) > BESIDE:
                found[join.mesh.name] = off
    return found


def _free(axis: complex) -> Frame:
    origin = Point(0.0, axis.real, axis.imag)
    return Frame(origin, Direction(1.0, 0.0, 0.0), Direction(0.0, 1.0, 0.0), Direction(0.0, 0.0, 1.0))


def _meshes(context: Context, arrangement: Arrangement) -> Iterator[_Join]:
    plans = arrangement.plans
    for mesh in context.train.meshes:
        first, second = mesh.nodes[:2]
        if mesh.stage in context.design.pairs and first in plans and second in plans:
            yield _Join(first, second, (plans[first].places[mesh.gears[0]], plans[second].places[mesh.gears[1]]), mesh)


def _sets(context: Context, gears: Mapping[str, GearSizing], arrangement: Arrangement) -> Iterator[_Join]:
    """Yield the shafts of every planetary set in line, each at the set's middle."""
    for stage in context.design.sets:
        members = list(set_members(context, gears, arrangement, stage))
        for shaft, middle in members[1:]:
            if shaft != members[0][0]:
                yield _Join(members[0][0], shaft, (members[0][1], middle))


def set_members(
    context: Context, gears: Mapping[str, GearSizing], arrangement: Arrangement, stage: str
) -> Iterator[tuple[str, float]]:
    """Yield every shaft of a planetary set, with where the set's middle lies along it [m].

    A set at the end of a shaft of a first sizing lies beyond that end.

    Args:
        context: What sizing reads.
        gears: By name.
        arrangement: Its plans.
        stage: Name of the set.
    """
    design, places = context.design, slots(context, gears, stage, turned=stage in arrangement.turned)
    labels = {gear.name: gear.nodes for gear in context.train.gears if gear.stage == stage and gear.role != Role.PLANET}
    labels[str(carrier_part(stage))] = (design.sets[stage].carrier,)
    half = set_length(context, gears, stage) / 2.0
    for label, nodes in labels.items():
        for shaft in nodes:
            if shaft not in arrangement.plans:
                continue
            plan = arrangement.plans[shaft]
            at = plan.places[label] - places.get(label, 0.0)
            if not plan.seats:
                at = -half if plan.places[label] <= 0.0 else plan.length + half if at >= plan.length - half else at
            yield shaft, at


def _links(context: Context, arrangement: Arrangement) -> Iterator[_Join]:
    for name, link in context.design.links.items():
        if link.driving in arrangement.plans and link.driven in arrangement.plans:
            at = (arrangement.plans[link.driving].places[name], arrangement.plans[link.driven].places[name])
            yield _Join(link.driving, link.driven, at)


def _placed(
    context: Context, gears: Mapping[str, GearSizing], arrangement: Arrangement, join: _Join, side: int, known: Frame
) -> Frame:
    """Return the frame of the shaft at the other end of a join."""
    kind = "" if join.mesh is None else context.design.pairs[join.mesh.stage].kind
    ends = (join.first, join.second)
    between = arrangement.axes[ends[1 - side]] - arrangement.axes[ends[side]]
    if kind == "bevel" and join.mesh is not None:
        return _crossed(context, gears, join, side, known=known, toward=between / abs(between))
    if kind == "face" and join.mesh is not None:
        return _across(gears, join, side, known=known, between=between)
    step = join.at[side] - join.at[1 - side]
    along = np.array(known.origin) + step * np.array(known.along)
    origin = along + (between.real * np.array(known.across) + between.imag * np.array(known.up))
    return Frame(_point(origin), known.along, known.across, known.up)


def _crossed(
    context: Context, gears: Mapping[str, GearSizing], join: _Join, side: int, *, known: Frame, toward: complex
) -> Frame:
    """Return the other shaft of a bevel pair, through the common apex.

    From the apex, this gear lies along e and the other one along e' = cos Σ e + sin Σ u, with u the direction in which
    they touch; the other shaft's own direction of touch is that part of e which is square to e'.
    """
    assert join.mesh is not None
    pair, stage = bevel_cones(context, gears, join.mesh.stage), context.design.pairs[join.mesh.stage]
    sense = [1.0 if apex == "second" else -1.0 for apex in (stage.pinion_apex, stage.wheel_apex)]
    reach = [pair.mean_cone_distance * math.cos(angle) for angle in pair.pitch_angles]
    touch = toward.real * np.array(known.across) + toward.imag * np.array(known.up)
    here, angle = -sense[side] * np.array(known.along), pair.shaft_angle
    there = math.cos(angle) * here + math.sin(angle) * touch
    back = (here - math.cos(angle) * there) / math.sin(angle)
    apex = np.array(known.origin) + (join.at[side] + sense[side] * reach[side]) * np.array(known.along)
    other = 1 - side
    along = -sense[other] * there
    origin = apex - (join.at[other] + sense[other] * reach[other]) * along
    return _turned(origin, along, back, -toward)


def _across(gears: Mapping[str, GearSizing], join: _Join, side: int, *, known: Frame, between: complex) -> Frame:
    """Return the other shaft of a face-gear pair: the middle of the pinion's face on the wheel's pitch circle."""
    assert join.mesh is not None
    pinion, wheel = (gears[name].pitch_diameter / 2.0 for name in join.mesh.gears)
    toward = between / abs(between)
    touch = toward.real * np.array(known.across) + toward.imag * np.array(known.up)
    middle = np.array(known.origin) + join.at[side] * np.array(known.along)
    out = toward if side == 1 else -toward  # as the wheel sees it
    away = 1.0 if out.real + out.imag > 0.0 else -1.0  # the side to which the pinion pushes the wheel, as in its loads
    if side == 1:
        along = away * touch
        place = middle + wheel * touch - away * pinion * np.array(known.along)
        return _turned(place - join.at[0] * along, along, away * np.array(known.along), -toward)
    along, radial = away * touch, away * np.array(known.along)
    place = middle + pinion * touch - wheel * radial
    return _turned(place - join.at[1] * along, along, radial, -toward)


def _turned(origin: Floats, along: Floats, touch: Floats, toward: complex) -> Frame:
    """Return the frame whose cross-section shows a direction in space as a given direction."""
    side = np.cross(along, touch)
    across, up = toward.real * touch - toward.imag * side, toward.imag * touch + toward.real * side
    return Frame(_point(origin), _direction(along), _direction(across), _direction(up))


def _point(place: Floats) -> Point:
    return Point(*(float(value) for value in place))


def _direction(vector: Floats) -> Direction:
    return Direction(*(float(value) for value in vector))


# ----------------------------------------------------------------------------------------------------------------------
# Gears of first sizings moved along their shafts to where they mesh.
#
# Where meshes close a loop, the gears of the last one may stand beside each other along their axes, as shafts without
# bearings or places of their own have equal gaps. A gear that has no other mesh, on such a shaft, then moves to its
# mate.
# ----------------------------------------------------------------------------------------------------------------------


def arrange_meshing(
    context: Context, gears: tuple[GearSizing, ...], angles: Mapping[str, float] = NO_ANGLES
) -> Arrangement:
    """Return axes and plans in which gears in mesh stand beside each other, as far as open places give it.

    Args:
        context: What sizing reads.
        gears: From `size_gears`.
        angles: Shaft -> direction of its axis from its mate, where the design leaves it open [rad].

    Raises:
        DesignError: As `arrange`.
    """
    arrangement = arrange(context, gears, angles)
    rows = [mesh for mesh in context.train.meshes if mesh.stage in context.design.pairs]
    if not _closes(context, rows):
        return arrangement
    moves: Moves = {}
    for _ in rows:
        closer = _closer(context, gears, angles, rows, arrangement, moves)
        if closer is None:
            break
        arrangement, moves = closer
    return arrangement


def _closes(context: Context, rows: list[Mesh]) -> bool:
    """Tell whether meshes close a loop of shafts, which sets and clutches join, too."""
    design, known = context.design, dict[str, str]()

    def root(shaft: str) -> str:
        while known.get(shaft, shaft) != shaft:
            shaft = known[shaft]
        return shaft

    joined = [stage.members for stage in design.sets.values()]
    joined += [(link.driving, link.driven) for link in design.links.values()]
    for first, *others in ([shaft for shaft in members if shaft != GROUND] for members in joined):
        known |= {root(other): root(first) for other in others if root(other) != root(first)}
    for mesh in rows:
        first, second = root(mesh.nodes[0]), root(mesh.nodes[1])
        if first == second:
            return True
        known[second] = first
    return False


def _closer(
    context: Context,
    gears: tuple[GearSizing, ...],
    angles: Mapping[str, float],
    rows: list[Mesh],
    arrangement: Arrangement,
    moves: Moves,
) -> tuple[Arrangement, Moves] | None:
    """Return the arrangement with one more gear moved to its mate, and all moves; None where none can be."""
    by_name = {gear.name: gear for gear in gears}
    frames = frames_of(context, by_name, arrangement)
    apart = apart_of(context, by_name, arrangement, frames)
    for mesh in rows:
        for shaft, gear in _open_ends(context, rows, mesh, arrangement) if mesh.name in apart else ():
            moved = _moved(moves, shaft, gear, frames, off=apart[mesh.name], mesh=mesh)
            try:
                return arrange(context, gears, angles, moved), moved
            except DesignError:  # it has no room on its shaft
                continue
    return None


def _open_ends(context: Context, rows: list[Mesh], mesh: Mesh, arrangement: Arrangement) -> Iterator[tuple[str, str]]:
    """Yield shaft and gear of the ends of a mesh that may move along their shafts."""
    for shaft, gear in zip(mesh.nodes[:2], mesh.gears, strict=True):
        layout = context.design.layout.get(shaft, NOTHING_GIVEN)
        meshes = sum((shaft, gear) in zip(row.nodes[:2], row.gears, strict=True) for row in rows)
        given = gear in layout.places or f"{shaft}.length" in context.given or layout.first_bearing is not None
        if meshes == 1 and not given and layout.second_bearing is None and not arrangement.plans[shaft].seats:
            yield shaft, gear


def _moved(moves: Moves, shaft: str, gear: str, frames: Mapping[str, Frame], *, off: float, mesh: Mesh) -> Moves:
    """Return moves with one more: the second shaft of the mesh stands too far on by so much, along itself."""
    first, second = (frames[node].along for node in mesh.nodes[:2])
    alike = 1.0 if sum(one * other for one, other in zip(first, second, strict=True)) > 0.0 else -1.0
    by = off * alike if shaft == mesh.nodes[0] else -off
    return {**moves, (shaft, gear): moves.get((shaft, gear), 0.0) + by}
