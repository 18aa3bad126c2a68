"""Where bodies and teeth that turn against each other stand into each other, and how deep."""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import combinations
from typing import NamedTuple

import numpy as np

from gearwright.base import HOUSING, Bools, Floats, Kind, Role, largest_first
from gearwright.parts.bevel_geometry import BevelPair, bevel_form
from gearwright.parts.gears import TransverseTooth, face_reach, face_thickness, transverse_form
from gearwright.shape.bodies import Leaning, leanings
from gearwright.shape.casings import FLANGES, SCREW
from gearwright.shape.chambers import Chamber, depth_in
from gearwright.shape.scene import Phases, helix_rate, phases_of, turn_about_axis
from gearwright.shape.solids import Solid, spiral_turn
from gearwright.shape.stands import Contact, Node, Scene, contacts_of, kind_of, stands_of
from gearwright.sizing import GearSizing, Sizing
from gearwright.sizing.mass import bevel_cones, pinion_of, tooth_of
from gearwright.spec import GROUND

# ----------------------------------------------------------------------------------------------------------------------
# Where bodies that turn against each other stand into each other, by the points of one in the section of the other.
#
# A body is seen as what it sweeps about its own axis: of gears what lies below their roots, so that teeth in mesh,
# which `meshing` and `crossing` look at, do not count.
# ----------------------------------------------------------------------------------------------------------------------


TOUCH = 1e-5
"""How deep points may stand in another body by rounding and by chords [m]."""
CORNERS, MANY = 8, 13
"""Points of the outline of a bridge, and along each of its edges [-]."""


class Overlap(NamedTuple):
    """Two bodies in one place."""

    one: str
    other: str
    """Names of nodes."""
    depth: float
    """How deep a point of one stands in the other [m]."""


def overlaps(sizing: Sizing, scene: Scene) -> tuple[Overlap, ...]:
    """Return which bodies that turn against each other, or covers and walls, stand into each other, the deepest first.

    Args:
        sizing: As sized.
        scene: Of it.
    """
    nodes = [node for node in scene.nodes
             if isinstance(scene.solids.get(node.surface), Solid) and (node.part.number or 1) == 1]  # fmt: skip
    moves = {node.name: _moves(sizing, node) for node in nodes}
    found = []
    for one, other in combinations(nodes, 2):
        if moves[one.name] != moves[other.name] and _near(scene, one, other):
            depth = max(_deep(scene, one, other), _deep(scene, other, one))
            if depth > TOUCH:
                found.append(Overlap(one.name, other.name, depth))
    moving = [node for node in nodes if any(node.spins.values()) or node.on or node.look == "holder"]
    found += _into_walls(scene, [*moving, *(node for node in scene.nodes if node.look == SCREW)])
    return tuple(largest_first(found, lambda overlap: overlap.depth))


def _into_walls(scene: Scene, bodies: list[Node]) -> Iterator[Overlap]:
    """Yield what stands in a wall or a plate of the housing, at rest."""
    walls = [(node, chamber) for node in scene.nodes if isinstance(chamber := scene.solids.get(node.surface), Chamber)]
    for node in bodies:
        points = scene.surfaces[node.surface].points @ node.axes.turned.T + node.axes.origin
        for wall, chamber in walls:
            if node.look == SCREW and FLANGES in wall.name:  # through whose halves it goes
                continue
            depth = depth_in((points - wall.axes.origin) @ wall.axes.turned, chamber, TOUCH)
            if depth > TOUCH:
                yield Overlap(node.name, wall.name, depth)


def _moves(sizing: Sizing, node: Node) -> str:
    """Return what a body turns with: a shaft, a planet, the carrier that it is on, or the ground."""
    if node.part == HOUSING:
        return GROUND
    if node.look == "shaft" or node.part.kind is Kind.SHAFT:
        return node.part.name
    if node.part.kind is Kind.CARRIER:
        return next(carrier.shaft for carrier in sizing.carriers if carrier.part == node.part)
    if node.part.kind is Kind.BEARING and not node.on:
        return next(bearing.shaft for bearing in sizing.bearings if bearing.name == node.part.name)
    gear = next((gear for gear in sizing.gears if node.part in [gear.part, *map(gear.body, gear.shafts)]), None)
    if gear is None or node.look == "bearing":  # of a planet
        return f"planets of {node.on}"
    return f"planets of {node.on}" if gear.role is Role.PLANET else node.part.branch or gear.shafts[0] or GROUND


def _near(scene: Scene, one: Node, other: Node) -> bool:
    """Tell whether balls around two bodies meet."""
    sizes = [float(np.max(np.linalg.norm(scene.surfaces[node.surface].points, axis=1))) for node in (one, other)]
    return float(np.linalg.norm(one.axes.origin - other.axes.origin)) < sum(sizes)


def _deep(scene: Scene, one: Node, other: Node) -> float:
    """Return how deep the points of one body stand in what another one sweeps [m]; 0 outside."""
    solid = _solid(scene, other)
    if solid.sections and len(solid.sections[0].radius) == CORNERS:  # a bridge, which sweeps nothing about itself
        return 0.0
    points = _points(scene, one) @ one.axes.turned.T + one.axes.origin
    own = (points - other.axes.origin) @ other.axes.turned
    section = _section(solid)
    seen = np.stack([own[:, 2], np.hypot(own[:, 0], own[:, 1])], axis=1)
    inside = _inside(seen, section)
    return float(np.max(_edge(seen[inside], section), initial=0.0))


def _points(scene: Scene, node: Node) -> Floats:
    """Return points on a body about its own axis [m]; on the edges of a bridge, many."""
    solid = _solid(scene, node)
    if not solid.sections or len(solid.sections[0].radius) != CORNERS:
        return scene.surfaces[node.surface].points
    low, high = (section.points for section in (solid.sections[0], solid.sections[-1]))
    share = np.linspace(0.0, 1.0, MANY)[:, None, None]
    around = low + share * (np.roll(low, -1, axis=0) - low)
    return np.asarray((around[:, None] + share[:, None] * np.array([0.0, 0.0, high[0, 2] - low[0, 2]])).reshape(-1, 3))


def _solid(scene: Scene, node: Node) -> Solid:
    solid = scene.solids[node.surface]
    assert isinstance(solid, Solid)  # no chamber of a housing, which stands still
    return solid


def _section(solid: Solid) -> Floats:
    """Return the corners of what a body sweeps in the half-plane through its axis: place and radius [m]."""
    corners = list(solid.profile)
    for section in solid.sections[:: len(solid.sections) - 1] if solid.sections else ():
        k = int(np.argmax(section.radius) if solid.inside else np.argmin(section.radius))
        corners.append((float(section.height[k]), float(section.radius[k])))
    if solid.sections and solid.inside:
        corners[-2:] = corners[:-3:-1]
    return np.array(corners)


def _inside(points: Floats, corners: Floats) -> Bools:
    """Return which points lie within a closed chain of lines: a line crosses it an odd number of times."""
    odd = np.zeros(len(points), dtype=bool)
    for (z, r), (onward, out) in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        if z == onward:
            continue
        across = (points[:, 0] >= min(z, onward)) & (points[:, 0] < max(z, onward))
        odd ^= across & (points[:, 1] < r + (out - r) * (points[:, 0] - z) / (onward - z))
    return odd


def _edge(points: Floats, corners: Floats) -> Floats:
    """Return how far points are from a closed chain of lines; what lies on the axis is no edge [m]."""
    near = np.full(len(points), np.inf)
    for start, end in _edges(corners):
        way = end - start
        share = np.clip((points - start) @ way / max(float(way @ way), 1e-30), 0.0, 1.0)
        near = np.minimum(near, np.linalg.norm(points - start - share[:, None] * way, axis=1))
    return near


def _edges(corners: Floats) -> Iterator[tuple[Floats, Floats]]:
    for start, end in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        if start[1] or end[1]:
            yield start, end


# ----------------------------------------------------------------------------------------------------------------------
# How deep two meshing gears on parallel axes stand in each other, by their outlines in polar coordinates.
# ----------------------------------------------------------------------------------------------------------------------


FLANK_POINTS = 40
"""Points on a fillet and on a flank [-]."""
TEETH_BESIDE = np.arange(-6, 7)
"""Teeth beside the touching point that are looked at; no mesh has more in contact."""


class Planar(NamedTuple):
    """The meshes of parallel axes, and how their gears stand and lean."""

    contacts: tuple[Contact, ...]
    phases: Phases
    leaning: Mapping[str, Leaning]


def planar_contacts(sizing: Sizing) -> Planar:
    """Return the meshes of parallel axes, with how their gears stand and lean.

    Args:
        sizing: As sized.
    """
    stands = stands_of(sizing)
    leaning, contacts = leanings(sizing, stands), contacts_of(sizing, stands)
    phases = phases_of(sizing, stands, contacts, {name: lean.turning for name, lean in leaning.items()})
    planar = tuple(contact for contact in contacts if kind_of(sizing, contact.mesh.stage) == "cylindrical")
    return Planar(planar, phases, leaning)


def deepest(sizing: Sizing, contact: Contact, planar: Planar, moments: Sequence[float]) -> float:
    """Return how deep teeth stand in each other at moments of the case that speaks for the design [m].

    Args:
        sizing: As sized.
        contact: A mesh of parallel axes.
        planar: Of the sizing.
        moments: [s].
    """
    pair, phases = (contact.first, contact.second), planar.phases
    teeth = [tooth_of(sizing, stand.gear) for stand in pair]
    forms = [transverse_form(tooth, fillet=FLANK_POINTS, flank=FLANK_POINTS) for tooth in teeth]
    flow, carrier = sizing.reference, contact.mesh.nodes[2]
    base = phases.senses[carrier] * flow.speeds[carrier]
    speeds = [phases.senses[stand.node] * flow.speeds[stand.node] - base for stand in pair]
    between = pair[1].axes.origin - pair[0].axes.origin
    apart = complex(*(float(between @ pair[0].axes.turned[:, k]) for k in (0, 1)))
    lean = helix_rate(pair[1], planar.leaning[pair[1].name].turning) * contact.offset
    worst = -1.0
    for moment in moments:
        turned = [phases.turned[stand.name] + speed * moment for stand, speed in zip(pair, speeds, strict=True)]
        turned[1] -= lean
        for one, other, there in ((0, 1, -apart), (1, 0, apart)):
            radius, half = forms[one]
            pitch = 2.0 * math.pi / teeth[one].teeth
            first = round((contact.angles[one] - turned[one]) / pitch)
            angle = turned[one] + pitch * (first + TEETH_BESIDE)[:, None, None] + np.stack([half, -half])
            seen = (radius * np.exp(1j * angle) + there).ravel()
            worst = max(worst, _depth_in_outline(seen * np.exp(-1j * turned[other]), teeth[other], forms[other]))
    return worst


def _depth_in_outline(points: Floats, tooth: TransverseTooth, form: tuple[Floats, Floats]) -> float:
    """Return how deep points, complex, stand in a gear whose tooth 0 stands about the angle 0 [m]."""
    radius, half = form
    order = np.argsort(radius)
    far, pitch = np.abs(points), 2.0 * math.pi / tooth.teeth
    beside = np.abs(np.angle(points) - np.round(np.angle(points) / pitch) * pitch)
    between = (far >= radius.min()) & (far <= radius.max())
    flank = (np.interp(far, radius[order], half[order]) - beside) * far * math.cos(tooth.pressure_angle)
    root = tooth.side * (tooth.root_radius - far)
    return float(max(np.max(flank[between], initial=-1.0), np.max(root, initial=-1.0)))


# ----------------------------------------------------------------------------------------------------------------------
# How deep the teeth of gears on crossing axes stand in each other, as far as their approximation lets them.
#
# Points on the flanks of one gear are seen in the frame of the other, where a tooth is as thick as its outline says:
# of a bevel gear on its back cone, of the wheel of a face gear in a cylinder about its axis.
# ----------------------------------------------------------------------------------------------------------------------


POINTS, SLICES = 24, 9
"""Points on a fillet and on a flank, and sections along the face [-]."""
NEAR = 4
"""Teeth beside the touching point that are looked at [-]."""

Depth = Callable[[Floats], Floats]
"""Points in the frame of a gear, shape (n, 3) -> how deep each stands in its teeth, negative outside [m]."""


def crossed_depths(sizing: Sizing, scene: Scene, moments: Sequence[float]) -> dict[str, float]:
    """Return mesh on crossing axes -> how deep its teeth stand in each other at the worst moment [m].

    Args:
        sizing: As sized.
        scene: Of it.
        moments: Of the case that speaks for the design [s].
    """
    stands = stands_of(sizing)
    hands = {name: lean.hand for name, lean in leanings(sizing, stands).items()}
    found: dict[str, float] = {}
    for contact in contacts_of(sizing, stands):
        if kind_of(sizing, contact.mesh.stage) != "cylindrical":
            name = f"{contact.first.name} and {contact.second.name}"
            found[name] = max(_deepest(sizing, scene, contact, hands, moment) for moment in moments)
    return found


def _deepest(sizing: Sizing, scene: Scene, contact: Contact, hands: dict[str, float], moment: float) -> float:
    """Return how deep either gear's points stand in the other's teeth at a moment [m]."""
    worst = -1.0
    for one, other in ((contact.first, contact.second), (contact.second, contact.first)):
        here, there = scene.by_name[one.name], scene.by_name[other.name]
        points = _space(here, _flanks(sizing, one.gear, hands[one.name]), scene.cases[0], moment)
        near = np.argsort(np.linalg.norm(points.mean(axis=1) - _touch(contact), axis=1))[: 2 * NEAR + 1]
        seen = _frame(there, points[near].reshape(-1, 3), scene.cases[0], moment)
        worst = max(worst, float(np.max(_depth(sizing, other.gear, hands[other.name])(seen))))
    return worst


def _touch(contact: Contact) -> Floats:
    """Return the middle of where two gears touch [m]."""
    stand, angle = contact.first, contact.angles[0]
    way = math.cos(angle) * stand.axes.turned[:, 0] + math.sin(angle) * stand.axes.turned[:, 1]
    return np.asarray(stand.axes.origin + stand.gear.pitch_diameter / 2.0 * way)


def _space(node: Node, points: Floats, case: str, moment: float) -> Floats:
    turned = node.axes.turned @ turn_about_axis(node.phase + node.spins[case] * moment)
    return np.asarray(points @ turned.T + node.axes.origin)


def _frame(node: Node, points: Floats, case: str, moment: float) -> Floats:
    turned = node.axes.turned @ turn_about_axis(node.phase + node.spins[case] * moment)
    return np.asarray((points - node.axes.origin) @ turned)


def _flanks(sizing: Sizing, gear: GearSizing, hand: float) -> Floats:
    """Return points on every tooth in the gear's frame, shape (teeth, points, 3) [m]."""
    kind, starts = kind_of(sizing, gear.stage), np.arange(gear.teeth) * 2.0 * math.pi / gear.teeth
    if kind == "bevel":
        radius, angle, height = _cone_points(bevel_cones(sizing, gear.stage), _side(gear), hand)
    elif gear.role is Role.WHEEL:
        pinion = pinion_of(sizing, gear)
        radius, angle, height = _face_points(tooth_of(sizing, pinion), gear.teeth, pinion.face_width)
    else:
        form, half = transverse_form(tooth_of(sizing, gear), fillet=POINTS, flank=POINTS)
        levels = np.linspace(-0.5, 0.5, SLICES) * gear.face_width
        radius, angle = np.tile(form, 2 * SLICES), np.tile(np.concatenate([half, -half]), SLICES)
        height = np.repeat(levels, 2 * len(form))
    turned = starts[:, None] + angle
    return np.stack([radius * np.cos(turned), radius * np.sin(turned), np.broadcast_to(height, turned.shape)], axis=2)


def _cone_points(pair: BevelPair, side: int, hand: float) -> tuple[Floats, Floats, Floats]:
    """Return radii, angles and places of points on both flanks of a bevel tooth."""
    form, half = bevel_form(pair, side, fillet=POINTS, flank=POINTS)
    cone, mean = pair.pitch_angles[side], pair.mean_cone_distance
    rise, both = np.tile(form - mean * math.tan(cone), 2), np.concatenate([half, -half]) / math.cos(cone)
    radius, angle, height = [], [], []
    for far in np.linspace(mean - pair.face_width / 2.0, mean + pair.face_width / 2.0, SLICES):
        above = rise * far / mean
        radius.append(far * math.sin(cone) + above * math.cos(cone))
        angle.append(both + hand * spiral_turn(pair, side, float(far)))
        height.append((far - mean) * math.cos(cone) - above * math.sin(cone))
    return np.concatenate(radius), np.concatenate(angle), np.concatenate(height)


def _face_points(pinion: TransverseTooth, teeth: int, width: float) -> tuple[Floats, Floats, Floats]:
    """Return radii, angles and places of points on both flanks of a tooth of a face gear."""
    tip, foot = -pinion.rack.addendum * pinion.module, pinion.rack.dedendum * pinion.module
    share = np.linspace(0.0, 1.0, POINTS)
    radius, angle, height = [], [], []
    for far in np.linspace(*face_reach(pinion, teeth, width), SLICES):
        top, root = face_thickness(pinion, teeth, float(far))
        half = (top + share * (root - top)) / far
        radius.append(np.full(2 * POINTS, far))
        angle.append(np.concatenate([half, -half]))
        height.append(np.tile(tip + share * (foot - tip), 2))
    return np.concatenate(radius), np.concatenate(angle), np.concatenate(height)


def _depth(sizing: Sizing, gear: GearSizing, hand: float) -> Depth:
    """Return the rule by which points in the frame of a gear stand in its teeth."""
    if kind_of(sizing, gear.stage) == "bevel":
        return _in_cone(bevel_cones(sizing, gear.stage), _side(gear), hand)
    if gear.role is Role.WHEEL:
        pinion = pinion_of(sizing, gear)
        return _in_face(tooth_of(sizing, pinion), gear.teeth, pinion.face_width)
    return _in_cylinder(tooth_of(sizing, gear), gear.face_width)


def _in_cone(pair: BevelPair, side: int, hand: float) -> Depth:
    form, half = bevel_form(pair, side, fillet=POINTS, flank=POINTS)
    cone, mean, order = pair.pitch_angles[side], pair.mean_cone_distance, np.argsort(form)
    lean, tiny = math.cos(pair.pressure_angle) * math.cos(pair.spiral_angle), 1e-3 * mean

    def depth(points: Floats) -> Floats:
        radius, angle = np.hypot(points[:, 0], points[:, 1]), np.arctan2(points[:, 1], points[:, 0])
        far = radius * math.sin(cone) + points[:, 2] * math.cos(cone) + mean * math.cos(cone) ** 2
        above = (radius * math.cos(cone) - points[:, 2] * math.sin(cone)) - mean * math.sin(cone) * math.cos(cone)
        virtual = above * mean / far + mean * math.tan(cone)
        turn = hand * math.tan(pair.spiral_angle) * np.log(np.maximum(far, tiny) / mean) / math.sin(cone)
        wide = np.interp(virtual, form[order], half[order]) / math.cos(cone)
        deep = (wide - _beside(angle - turn, pair.teeth[side])) * radius * lean
        inside = (abs(far - mean) <= pair.face_width / 2.0) & (virtual <= form.max())
        return np.where(inside, np.where(virtual < form.min(), (form.min() - virtual) * far / mean, deep), -1.0)

    return depth


def _in_face(pinion: TransverseTooth, teeth: int, width: float) -> Depth:
    tip, foot = -pinion.rack.addendum * pinion.module, pinion.rack.dedendum * pinion.module
    inner, outer = face_reach(pinion, teeth, width)

    def depth(points: Floats) -> Floats:
        radius, angle = np.hypot(points[:, 0], points[:, 1]), np.arctan2(points[:, 1], points[:, 0])
        found, here = np.full(len(points), -1.0), (radius >= inner) & (radius <= outer) & (points[:, 2] >= tip)
        radius, angle, place = radius[here], angle[here], points[here, 2]
        ends = np.array([face_thickness(pinion, teeth, float(one)) for one in radius]).reshape(-1, 2)
        wide = ends[:, 0] + np.clip((place - tip) / (foot - tip), 0.0, 1.0) * (ends[:, 1] - ends[:, 0])
        deep = (wide - _beside(angle, teeth) * radius) * math.cos(pinion.pressure_angle)
        found[here] = np.where(place > foot, place - foot, deep)
        return found

    return depth


def _in_cylinder(tooth: TransverseTooth, width: float) -> Depth:
    form, half = transverse_form(tooth, fillet=POINTS, flank=POINTS)
    order = np.argsort(form)

    def depth(points: Floats) -> Floats:
        radius, angle = np.hypot(points[:, 0], points[:, 1]), np.arctan2(points[:, 1], points[:, 0])
        wide = np.interp(radius, form[order], half[order])
        deep = (wide - _beside(angle, int(tooth.teeth))) * radius * math.cos(tooth.pressure_angle)
        deep = np.where(radius < form.min(), form.min() - radius, deep)
        return np.where((abs(points[:, 2]) <= width / 2.0) & (radius <= form.max()), deep, -1.0)

    return depth


def _beside(angle: Floats, teeth: int) -> Floats:
    """Return how far angles are from the middle of the nearest tooth [rad]."""
    pitch = 2.0 * math.pi / teeth
    return np.asarray(np.abs(angle - np.round(angle / pitch) * pitch))


def _side(gear: GearSizing) -> int:
    return 0 if gear.role is Role.PINION else 1
