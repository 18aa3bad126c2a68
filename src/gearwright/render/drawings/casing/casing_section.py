"""The housing as the arrangement's section cuts it: chambers, flanges and bosses are one part up to joints."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np

from gearwright.render.drawings.casing.outside_view import rib_outlines
from gearwright.render.drawings.casing.screw_view import screw_entities
from gearwright.render.drawings.casing.section_path import Lane, crossed, lanes
from gearwright.render.drawings.casing.web_section import Line, webs_across, webs_along
from gearwright.render.drawings.sheet.entities import Entity, Hatch, Layer, Path
from gearwright.render.drawings.views.positions import Positions
from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.shape import FLANGES, Node, Scene, short_of
from gearwright.shape import scene as scene_of
from gearwright.shape.solids import Chamber, Cut, Rectangle, Solid, bored, cut_chamber, spans_in, united, without
from gearwright.sizing import Sizing
from gearwright.sizing.casing import HOLE, Flanges
from gearwright.sizing.mass import carried_in_walls, weighed_flanges

LEAN, SPACING = math.pi / 4.0, 4.0
"""Of the hatching of the housing [rad] and [mm]: wider than that of gears; parts beside a joint lean the other way."""
OVER = 2.4
"""Half a centre line of a screw over the thickness of a half of its flange [-]."""
SQUARE = 1e-9
"""How far an axis on the sheet may turn from upright or level [-]."""


@dataclass(frozen=True)
class CasingSection:
    """What the section cuts of the housing, in metres of the part at the places of the sheet."""

    cuts: tuple[Cut, ...]
    """Its parts, between joints along the first shaft."""
    steps: tuple[float, ...]
    """Where the section steps from one plane to another [m]."""
    flat: bool
    """Whether it is one plane."""
    leaning: tuple[tuple[complex, ...], ...]
    """Outlines of bosses on axes that lean on the sheet [mm]."""

    webs: tuple[Line, ...] = ()
    """Edges of webs along which the section lies [m]."""
    screws: tuple[tuple[complex, complex], ...] = ()
    """Centre lines of screws in flanges, through both halves, heads and nuts [mm]."""
    holes: tuple[Rectangle, ...] = ()
    """Clearance holes around them [m]."""
    ribs: tuple[tuple[complex, ...], ...] = ()
    """Outlines of ribs beside it [mm]."""
    short: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    """What is drawn otherwise than weighed -> both masses [kg]."""
    thread: float = 0.0
    """Diameter of the screws that are drawn [mm]; 0 where their holes are alone."""

    wall: float = 0.0
    """Thickness of the wall as it is drawn [m]."""
    crossed: tuple[str, ...] = ()
    """Shafts whose bodies it also cuts where the sheet does not show them."""

    @property
    def screw(self) -> complex:
        """Where the item number of a flange's screw points [mm]: the highest one."""
        return (
            max((start + end for start, end in self.screws), key=lambda twice: (round(twice.imag, 6), twice.real)) / 2.0
        )

    @property
    def anchor(self) -> complex:
        """Where the item number points [mm]: into the longest wall."""
        rectangles = [one for cut in self.cuts for one in cut.rectangles]
        longest = max(rectangles, key=lambda one: (round(one.end - one.start, 6), one.high))
        return MM * complex(0.7 * longest.start + 0.3 * longest.end, (longest.low + longest.high) / 2.0)


def casing_section(sizing: Sizing, plane: Positions) -> CasingSection | None:
    """Return the housing in the section of the general arrangement; None where there is none or no true section of it.

    Args:
        sizing: What was sized.
        plane: Where shafts lie.
    """
    if not sizing.design.housing.own or lanes(sizing, plane) is None:
        return None
    scene = scene_of(sizing, detail="coarse")
    ways = lanes(sizing, plane, joints_of(scene)) or ()
    nodes = [node for node in scene.nodes if node.look == "housing"]
    rectangles: list[Rectangle] = []
    for node in nodes:
        solid = scene.solids[node.surface]
        if isinstance(solid, Chamber):
            cut = _cut(node, solid, ways)
            if cut is None:
                return None
            rectangles += cut
    rectangles += webs_across(scene, ways)
    leaning = []
    for corners in _bosses(sizing, scene, plane):
        turn = (corners[1] - corners[0]) / abs(corners[1] - corners[0])
        if min(abs(turn.real), abs(turn.imag)) < SQUARE:
            xs, ys = (sorted(part / MM for part in parts)
                      for parts in ([c.real for c in corners], [c.imag for c in corners]))  # fmt: skip
            rectangles.append(Rectangle(xs[0], xs[-1], ys[0], ys[-1]))
        else:
            leaning.append(corners)
    steps = tuple(lane.end for lane in ways[:-1])
    legs = [leg for lane in ways for leg in lane.legs]
    flat = all(abs(float(leg.along @ legs[0].along)) > 1.0 - SQUARE for leg in legs)
    flanges = weighed_flanges(sizing)
    screws = tuple(screw_lines(scene, ways))
    holes = screw_holes(screws, flanges)
    cuts = tuple(united(bored(rectangles, holes), joints_of(scene)))
    ribs, short = rib_outlines(scene, ways, screws, MM * flanges.thread), short_of(sizing, scene)
    return CasingSection(
        cuts, steps, flat, tuple(leaning), tuple(webs_along(scene, ways, rectangles)), screws, holes, ribs, short,
        MM * flanges.thread, _wall_of(scene), tuple(crossed(sizing, plane, ways)),
    )  # fmt: skip


def _wall_of(scene: Scene) -> float:
    """Return the thickness of a housing's wall, which is that of its plates [m]."""
    chambers = [solid for node in scene.nodes if isinstance(solid := scene.solids.get(node.surface), Chamber)]
    return next(end.thickness for chamber in chambers for end in chamber.ends if end)


def _cut(node: Node, chamber: Chamber, ways: tuple[Lane, ...]) -> list[Rectangle] | None:
    """Return what the section cuts of a chamber; None where it meets an opening that it does not lie along."""
    found, at = [], float(node.axes.origin[0])
    for lane in ways:
        cut = cut_chamber(chamber, lane.legs)
        if cut is None:
            return None
        for one in cut:
            start, end = max(one.start + at, lane.start), min(one.end + at, lane.end)
            if start < end:
                found.append(Rectangle(start, end, one.low, one.high))
    return found


def screw_lines(scene: Scene, ways: tuple[Lane, ...]) -> Iterator[tuple[complex, complex]]:
    """Yield the centre lines of screws where a section cuts flanges, as if it met one there [mm].

    Args:
        scene: With the housing.
        ways: Where the section runs, from the first end to the last.
    """
    for node in (node for node in scene.nodes if node.look == "housing" and FLANGES in node.name):
        half, at = scene.solids[node.surface], float(node.axes.origin[0])
        joint = any(abs(at - place) < SQUARE for place in joints_of(scene))
        lane = next(lane for lane in ways if at <= lane.end)
        if joint and isinstance(half, Chamber):
            reach = OVER * half.span[1]
            for low, high in without(spans_in(half.outer, lane.legs), spans_in(half.inner, lane.legs)):
                yield tuple(MM * complex(x, (low + high) / 2.0) for x in (at - reach, at + reach))  # type: ignore[misc]


def screw_holes(lines: Sequence[tuple[complex, complex]], flanges: Flanges) -> tuple[Rectangle, ...]:
    """Return the clearance holes around the centre lines of screws, through both halves of flanges.

    Args:
        lines: Their centre lines [mm].
        flanges: As they are weighed.
    """
    middles = [(start + end) / (2.0 * MM) for start, end in lines]
    reach, half = flanges.thickness, HOLE * flanges.thread / 2.0
    return tuple(Rectangle(at.real - reach, at.real + reach, at.imag - half, at.imag + half) for at in middles)


def joints_of(scene: Scene) -> list[float]:
    """Return where halves of flanges meet, along the first shaft [m].

    Args:
        scene: With the housing.
    """
    halves = [node for node in scene.nodes if node.look == "housing" and FLANGES in node.name]
    places = sorted(float(node.axes.origin[0]) for node in halves)
    return places[1::2]


def _bosses(sizing: Sizing, scene: Scene, plane: Positions) -> Iterator[tuple[complex, ...]]:
    """Yield the outlines of both halves of every boss and collar on the sheet [mm]."""
    for bearing in sizing.bearings:
        node = scene.by_name.get(f"housing, boss of {bearing.name}")
        solid = scene.solids[node.surface] if node else None
        if node is None or not isinstance(solid, Solid):
            continue
        frame, lying = sizing.arrangement.frames[bearing.shaft], plane.shafts[bearing.shaft]
        middle = float((node.axes.origin - np.array(frame.origin)) @ np.array(frame.along))
        for side in (1.0, -1.0):
            yield tuple(lying.at(MM * (middle + z), side * MM * radius) for z, radius in solid.profile[:-1])
    for collar in (one for carried in carried_in_walls(sizing) for one in carried.collars):
        lying, (low, high) = plane.shafts[collar.shaft], collar.span
        around = ((low, collar.inner), (low, collar.outer), (high, collar.outer), (high, collar.inner))
        for side in (1.0, -1.0):
            yield tuple(lying.at(MM * place, side * MM * radius) for place, radius in around)


def casing_entities(section: CasingSection, scale: float) -> Iterator[Entity]:
    """Yield a housing in section; where the section steps, a chain line parts its planes.

    Args:
        section: What is cut.
        scale: mm of paper per mm [-].
    """
    paper = scale * MM
    for k, cut in enumerate(section.cuts):
        lean = LEAN if k % 2 == 0 else math.pi - LEAN
        for one in cut.rectangles:
            corners = (complex(one.start, one.low), complex(one.end, one.low),
                       complex(one.end, one.high), complex(one.start, one.high))  # fmt: skip
            yield Hatch(tuple(paper * corner for corner in corners), lean, SPACING)
        for loop in cut.loops:
            yield from _outline([paper * complex(*corner) for corner in loop], [paper * at for at in section.steps])
    for start, end in section.webs:
        yield Path((paper * start, paper * end), Layer.OUTLINE)
    for outline in section.ribs:
        yield Path(tuple(scale * corner for corner in outline), Layer.OUTLINE, closed=True)
    for start, end in section.screws:
        yield Path((scale * start, scale * end), Layer.CENTRE)
        if section.thread:
            yield from screw_entities(scale * (start + end) / 2.0, scale * section.thread)
    for outline in section.leaning:
        boss = tuple(scale * corner for corner in outline)
        yield from (Hatch(boss, LEAN, SPACING), Path(boss, Layer.OUTLINE, closed=True))


def _outline(corners: list[complex], steps: list[float]) -> Iterator[Path]:
    """Yield an outline; its sides where the section steps are no edges of the part."""
    sides = list(pairwise([*corners, corners[0]]))
    stepped = [any(abs(end.real - at) < 1e-6 for at in steps) and abs(end.real - start.real) < 1e-6
               for start, end in sides]  # fmt: skip
    if not any(stepped):
        yield Path(tuple(corners), Layer.OUTLINE, closed=True)
        return
    first = stepped.index(True)
    run: list[complex] = []
    for (start, end), is_step in zip(sides[first:] + sides[:first], stepped[first:] + stepped[:first], strict=True):
        if is_step:
            if run:
                yield Path(tuple(run), Layer.OUTLINE)
            yield Path((start, end), Layer.CENTRE)
            run = []
        else:
            run = [*(run or [start]), end]
    if run:
        yield Path(tuple(run), Layer.OUTLINE)
