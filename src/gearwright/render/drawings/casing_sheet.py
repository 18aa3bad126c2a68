"""The sheet of the housing by itself: in section along the first shaft, and seen from its first end."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from gearwright.arrays import Floats
from gearwright.catalogue import centre_allowance
from gearwright.render.drawings.casing.casing_parts import SCREWS, SHOWN
from gearwright.render.drawings.casing.casing_section import casing_entities
from gearwright.render.drawings.casing.exits import closed_towards, exit_notes
from gearwright.render.drawings.casing.outside_tables import mounts_grid, standing_notes
from gearwright.render.drawings.casing.plane_section import (
    Casing,
    casing_of,
    end_outlines,
    holes_behind,
    screw_circles,
    span_of,
    uncut,
)
from gearwright.render.drawings.casing.web_section import web_nodes
from gearwright.render.drawings.sheet.compose import AIR, Content, Rows
from gearwright.render.drawings.sheet.crossing import segments
from gearwright.render.drawings.sheet.dimensions import arrow, extent
from gearwright.render.drawings.sheet.entities import (
    TEXT,
    Box,
    Distance,
    Entity,
    Layer,
    Path,
    Words,
    millimetres,
    trimmed,
)
from gearwright.render.drawings.sheet.frame import Title
from gearwright.render.drawings.sheet.tables import Grid
from gearwright.render.drawings.sheet.tolerances import HIGH, Tolerance, tolerance_frame
from gearwright.render.drawings.views.end_view import names_beside
from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.render.drawings.views.weights import made_of
from gearwright.render.schematic.layout import pair_meshes
from gearwright.shape import scene as scene_of
from gearwright.shape.solids import spans_in
from gearwright.shape.teeth import kind_of, sized_mesh
from gearwright.sizing import Sizing
from gearwright.sizing.casing import HOLE, Flanges
from gearwright.sizing.mass import carried_in_walls, weighed_flanges

NAME = "housing"
CENTRE_FIT = "js7"
"""Of centre distances where the design gives none; assumed (DIN 3964)."""
FLAT = 0.05
"""Flatness of joint faces [mm], assumed: what a liquid seal bridges."""
LEVEL = 8.0
"""Between parallel dimension lines [mm]."""
SQUARE = 1e-9
"""How far an axis may turn from the first one to be along it [-]."""


def casing_content(sizing: Sizing) -> Content | None:
    """Return what the sheet of the housing shows; None where the gearbox has none of its own, or no plane cuts it.

    Args:
        sizing: What was sized.
    """
    casing = casing_of(sizing, scene_of(sizing, detail="coarse")) if sizing.design.housing.own else None
    if casing is None:
        return None
    flanges = weighed_flanges(sizing)
    mass = sum(each for name, each in made_of(sizing).casing.items() if name != SCREWS)
    material = sizing.design.housing.material
    title = Title(sizing.design.name, "Housing", NAME, "Component drawing", material, f"{mass:.1f}")

    def views(scale: float) -> Rows:
        return [[_section(sizing, casing, scale), _end(sizing, casing, flanges, scale)]]

    grids = (_flange_grid(casing, flanges), _chambers(casing), _openings(casing), _webs(sizing, casing),
             mounts_grid(casing), _axes(sizing))  # fmt: skip
    return Content(
        NAME, title, views, tuple(grid for grid in grids if grid.rows), tuple(_notes(sizing, casing, flanges)),
        largest_scale=1.0, kind="housing", is_whole=True, projected=True,
    )  # fmt: skip


def _levels(sizing: Sizing, casing: Casing) -> dict[str, complex]:
    """Return shaft along the first one -> where it stands in the view from the first end [m]."""
    frames = sizing.arrangement.frames
    return {
        name: complex(casing.seen(np.array([frame.origin[1:]]))[0])
        for name, frame in frames.items() if abs(frame.along.x) > 1.0 - SQUARE
    }  # fmt: skip


def _section(sizing: Sizing, casing: Casing, scale: float) -> list[Entity]:
    entities: list[Entity] = [*casing_entities(casing.section, scale), *holes_behind(casing, scale)]
    entities += uncut(casing, scale)
    box = extent(entities)
    entities += _axis_lines(sizing, casing, box, scale)
    entities += _lengths(casing, box, scale)
    entities += _heights(sizing, casing, box, scale)
    node, half = casing.halves[0]
    top = scale * MM * complex(span_of(node, half)[1], spans_in(half.outer, [casing.leg])[-1][1])
    knee = complex(top.real, box[3] + HIGH)
    entities += [Path((top, knee), Layer.SYMBOL), arrow(top, (top - knee) / abs(top - knee), Layer.SYMBOL)]
    frame = Tolerance("flatness", FLAT)
    entities += tolerance_frame(knee + 1j * HIGH / 2.0, frame)
    middle = (box[0] + box[2]) / 2.0
    entities.append(Words(complex(middle, extent(entities)[3] + AIR), "Section along the first shaft", TEXT, "middle"))
    return entities


def _axis_lines(sizing: Sizing, casing: Casing, box: Box, scale: float) -> Iterator[Entity]:
    """Yield the axes along the first shaft that lie in the plane."""
    heights = {round(scale * MM * at.imag, 6) for at in _levels(sizing, casing).values() if abs(at.real) < 1e-6}
    for height in sorted(heights):
        yield Path((complex(box[0] - 4.0, height), complex(box[2] + 4.0, height)), Layer.CENTRE)


def _lengths(casing: Casing, box: Box, scale: float) -> Iterator[Entity]:
    """Yield the plate of the first end, joints and ends of chambers from the first end on, and the whole length."""
    spans = [span_of(*piece) for piece in casing.chambers]
    start, end = casing.start, max(span[1] for span in spans)
    joints = [span_of(*half)[0] for half in casing.halves[1::2]]
    steps = {round(place, 9) for place in (*joints, *(place for span in spans for place in span))}
    level = box[1] - LEVEL
    first = complex(scale * MM * start, box[1])
    for place in sorted(step for step in steps if start + 1e-4 < step < end - 1e-4):
        yield Distance(first, complex(scale * MM * place, box[1]), complex(0.0, level), 0.0, scale)
        level -= LEVEL
    yield Distance(first, complex(scale * MM * end, box[1]), complex(0.0, level), 0.0, scale)


def _heights(sizing: Sizing, casing: Casing, box: Box, scale: float) -> Iterator[Entity]:
    """Yield distances of axes in the plane, with what they may vary, and the whole height."""
    x, seen = box[0] - 10.0, set[tuple[float, float]]()
    levels = _levels(sizing, casing)
    for mesh in pair_meshes(sizing.train):
        one, other = (levels.get(node) for node in mesh.nodes[:2])
        if one is None or other is None or kind_of(sizing, mesh.stage) != "cylindrical":
            continue
        key = (round(one.imag, 6), round(other.imag, 6))
        if max(abs(one.real), abs(other.real)) > 1e-6 or key in seen or key[0] == key[1]:
            continue
        seen.add(key)
        distance = sized_mesh(sizing, mesh).centre_distance
        allowed = centre_allowance(distance, sizing.design.rules(mesh.stage).centre_allowance or CENTRE_FIT)
        low, high = (complex(box[0], scale * MM * at.imag) for at in (one, other))
        yield Distance(low, high, complex(x, 0.0), math.pi / 2.0, scale, "", f" ±{trimmed(MM * allowed, 4)}")
        x -= LEVEL
    yield Distance(complex(box[0], box[1]), complex(box[0], box[3]), complex(x, 0.0), math.pi / 2.0, scale)


def _end(sizing: Sizing, casing: Casing, flanges: Flanges, scale: float) -> list[Entity]:
    entities: list[Entity] = list(end_outlines(casing, scale))
    entities += screw_circles(casing, flanges.screws, HOLE * flanges.thread / 2.0, scale)
    box = extent(entities)
    named: dict[complex, list[str]] = {}
    for name, at in _levels(sizing, casing).items():
        named.setdefault(complex(round(scale * MM * at.real, 6), round(scale * MM * at.imag, 6)), []).append(name)
    for at in named:
        entities += [Path((at - way, at + way), Layer.CENTRE) for way in (8.0, 8.0j)]
    entities += names_beside([(at, ", ".join(names)) for at, names in named.items()], list(segments(entities)))
    low = complex(0.0, box[1] - LEVEL)
    entities.append(Distance(complex(box[0], box[1]), complex(box[2], box[1]), low, 0.0, scale))
    middle = (box[0] + box[2]) / 2.0
    entities.append(Words(complex(middle, box[3] + AIR), "From the first end", TEXT, "middle"))
    return entities


def _flange_grid(casing: Casing, flanges: Flanges) -> Grid:
    """Return every flange with its screws."""
    rows = []
    for k, (node, solid) in enumerate(casing.halves[::2], start=1):
        loops = [np.concatenate([loop, loop[:1]]) for loop in (solid.outer, solid.inner)]
        around = sum(float(np.sum(np.linalg.norm(np.diff(loop, axis=0), axis=1))) for loop in loops) / 2.0
        wide = _top(casing, solid.outer) - _top(casing, solid.inner)
        rows.append((
            f"{k}", trimmed(MM * (span_of(node, solid)[1] - casing.start), 1), millimetres(MM * wide),
            f"2 x {millimetres(MM * flanges.thickness)}", f"{flanges.screws} x M{trimmed(MM * flanges.thread, 1)}",
            trimmed(MM * around / flanges.screws, 1),
        ))  # fmt: skip
    return Grid("Flanges [mm]", tuple(rows), ("No.", "Joint at", "Width", "Thickness", "Screws", "Pitch"))


def _top(casing: Casing, loop: Floats) -> float:
    return float(np.max(casing.seen(loop).imag))


def _chambers(casing: Casing) -> Grid:
    """Return every chamber: from where to where along the first shaft, wall, how high and wide it is."""
    rows = []
    for k, (node, solid) in enumerate(casing.chambers, start=1):
        seen, wall = casing.seen(solid.outer), _top(casing, solid.outer) - _top(casing, solid.inner)
        places = (trimmed(MM * (at - casing.start), 1) for at in span_of(node, solid))
        sizes = (trimmed(MM * float(np.ptp(part)), 1) for part in (seen.imag, seen.real))
        rows.append((f"{k}", *places, millimetres(MM * wall), *sizes))
    return Grid("Chambers, outside [mm]", tuple(rows), ("No.", "From", "To", "Wall", "Height", "Width"))


def _openings(casing: Casing) -> Grid:
    """Return the round openings of plates, between chambers too, and of sides."""
    rows = list[tuple[str, float, float, float, float]]()
    for k, (node, solid) in enumerate(casing.chambers, start=1):
        for end, place in zip(solid.ends, span_of(node, solid), strict=True):
            for (y, z), radius in map(_circle, end.holes if end else ()):
                if radius is not None:
                    rows.append((f"{k}, plate", radius, place, y, z))
        for opening in solid.openings:
            y, z, x = opening.middle.tolist()
            rows.append((f"{k}, side", opening.radius, x + float(node.axes.origin[0]), y, z))
    lines = tuple(
        (name, f"Ø{trimmed(2.0 * MM * radius, 1)}", *(trimmed(MM * at, 2) for at in (x - casing.start, y, z)))
        for name, radius, x, y, z in rows
    )  # fmt: skip
    return Grid("Round openings [mm]", lines, ("Chamber", "Size", "x", "y", "z"))


def _circle(hole: Floats) -> tuple[list[float], float | None]:
    """Return middle and radius of the largest circle in a hole; no radius of what is not round [m]."""
    middle = hole.mean(axis=0)
    far = np.linalg.norm(hole - middle, axis=1)
    is_round = float(np.ptp(far)) < 1e-6 * float(far.mean())
    return middle.tolist(), float(far.mean()) * math.cos(math.pi / len(hole)) if is_round else None


def _webs(sizing: Sizing, casing: Casing) -> Grid:
    """Return the webs that carry bosses, seen from the first end: 0° points up, clockwise."""
    rows = []
    for web in (web for carried in carried_in_walls(sizing) for web in carried.webs):
        seen = complex(casing.seen(casing.foot + web.way[None, 1:])[0])
        turned = round(math.degrees(math.atan2(seen.real, seen.imag))) % 360
        where = f"{turned}°" if abs(web.way[0]) < SQUARE else "along the first shaft"
        sizes = (millimetres(MM * web.thickness), millimetres(MM * web.width), trimmed(MM * web.length, 1))
        rows.append((web.bearing, where, *sizes))
    return Grid("Webs of bosses [mm]", tuple(rows), ("Boss", "Way", "Thickness", "Width", "Length"))


def _axes(sizing: Sizing) -> Grid:
    """Return where axes along the first shaft stand."""
    rows = tuple((name, *(trimmed(MM * at, 3) for at in frame.origin[1:]))
                 for name, frame in sizing.arrangement.frames.items() if abs(frame.along.x) > 1.0 - SQUARE)  # fmt: skip
    return Grid("Axes along the first shaft [mm]", rows, ("Shaft", "y", "z"))


def _notes(sizing: Sizing, casing: Casing, flanges: Flanges) -> Iterator[str]:
    thread = f"M{trimmed(MM * flanges.thread, 1)}"
    yield (
        f"Shell of the complete mass, cut by a plane through the first axis. Flanges: {flanges.screws} screws {thread} "
        f"each (ISO 4017, 10.9, nuts ISO 4032, washers ISO 7089), holes Ø{trimmed(MM * HOLE * flanges.thread, 1)}."
    )
    if any(uncut(casing, 1.0)):
        yield "Dashed: chambers that the plane does not meet."
    if any(web_nodes(casing.scene)):
        yield "Webs of bosses: ways seen from the first end, clockwise from above; in the plane they are not hatched."
    yield "Lengths from the outside of the first end. y and z across the first shaft, as in the arrangement."
    yield f"Positions of axes by {CENTRE_FIT} (DIN 3964) where the design gives nothing; flatness of joints assumed."
    yield from exit_notes(closed_towards(sizing, casing.scene))
    yield from standing_notes(sizing, casing)
    hidden = [name for name in made_of(sizing).casing if name not in (*SHOWN, SCREWS)]
    if hidden:
        yield f"In the mass, not drawn: {', '.join(hidden)}. Radii and drafts are not sized."
    if sizing.bearings:
        yield "Bores of bearings with their fits: sheet housing-bores."
    else:
        yield "Bearings of shafts are not sized: their bores and bosses are not drawn."
