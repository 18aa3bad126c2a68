"""Where the shafts of a train lie in the plane of a general arrangement, unfolded where no plane holds all axes."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, permutations

import numpy as np

from gearwright.arrays import Floats
from gearwright.identity import Kind
from gearwright.render.drawings.views.laid.beside import TRUE, Join, Lying, centre_distance, parallel
from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.render.schematic.layout import pair_meshes
from gearwright.shape.teeth import bevel_pair, gear_of, kind_of
from gearwright.sizing import Sizing
from gearwright.sizing.places import PLATE_GAP as GAP
from gearwright.sizing.places import runs
from gearwright.spec import GROUND
from gearwright.train import Mesh

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
