"""Sheets of the housing: by itself in section and from its end, and the bores of its bearings."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from gearwright.arrays import Floats
from gearwright.catalogue import centre_allowance, standard_tolerance
from gearwright.render.drawings.arrangement_view import names_beside
from gearwright.render.drawings.casing_section import SCREWS, SHOWN, casing_entities, web_nodes
from gearwright.render.drawings.entities import (
    HIGH,
    TEXT,
    TRIANGLE,
    Box,
    Distance,
    Entity,
    Hatch,
    Layer,
    Path,
    Tolerance,
    Words,
    arrow,
    datum,
    extent,
    millimetres,
    section_letters,
    tolerance_frame,
    trimmed,
)
from gearwright.render.drawings.paper import AIR, Content, Grid, Rows, Title, segments
from gearwright.render.drawings.plane_section import (
    Casing,
    casing_of,
    closed_towards,
    end_outlines,
    exit_notes,
    holes_behind,
    mounts_grid,
    screw_circles,
    span_of,
    standing_notes,
    uncut,
)
from gearwright.render.drawings.shaft_view import ACROSS, MM, OVERSHOOT, Axis, Mark, made_of, marked
from gearwright.render.skeleton import pair_meshes
from gearwright.render.style import spread
from gearwright.shape import scene as scene_of
from gearwright.shape.chambers import spans_in
from gearwright.shape.stands import kind_of, sized_mesh
from gearwright.sizing import BearingSizing, Sizing
from gearwright.sizing.casing import HOLE, Flanges
from gearwright.sizing.mass import carried_in_walls, weighed_flanges
from gearwright.sizing.shafts import Held, held_rings

# ----------------------------------------------------------------------------------------------------------------------
# The sheet of the housing by itself: in section along the first shaft, and seen from its first end.
# ----------------------------------------------------------------------------------------------------------------------


HOUSING_NAME = "housing"
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
    title = Title(sizing.design.name, "Housing", HOUSING_NAME, "Component drawing", material, f"{mass:.1f}")

    def views(scale: float) -> Rows:
        return [[_section(sizing, casing, scale), _end(sizing, casing, flanges, scale)]]

    grids = (_flange_grid(casing, flanges), _chambers(casing), _openings(casing), _webs(sizing, casing),
             mounts_grid(casing), _axes(sizing))  # fmt: skip
    return Content(
        HOUSING_NAME, title, views, tuple(grid for grid in grids if grid.rows),
        tuple(_notes_on_housing(sizing, casing, flanges)),
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


def _notes_on_housing(sizing: Sizing, casing: Casing, flanges: Flanges) -> Iterator[str]:
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


# ----------------------------------------------------------------------------------------------------------------------
# The sheet of the housing's bores: what every bearing is seated in, and how true bores stand to each other.
#
# The housing around them is on a sheet of its own.
# ----------------------------------------------------------------------------------------------------------------------


BORES_NAME = "housing-bores"
BORE_GRADE = 6
"""Of coaxiality, of what cover faces and shoulders may lean, and, by half, of flatness: usual for bearings of normal
accuracy, assumed."""
BORE_CLASS = "H7"
"""Of bores, for outer rings under a load that stands still; assumed (DIN 5425-1)."""
CENTRE_FIT_OF_BORES = "js7"
"""Of centre distances where the design gives none; assumed (DIN 3964)."""
WALL = 0.12
"""Wall of a bore that is drawn over its diameter: that of bosses as they are weighed."""
LIP = 5.0
"""Thickness of shoulders as drawn [mm]."""
LEVEL_OF_BORES = 8.0
"""Between parallel dimension lines [mm]."""


def housing_content(sizing: Sizing) -> Content | None:
    """Return what the sheet of the housing's bores shows; None where no bearings are sized.

    Args:
        sizing: What was sized.
    """
    held = [one for one in held_rings(sizing) if one.ring == "outer"]
    shafts = {shaft.name: sorted((one for one in sizing.bearings if one.shaft == shaft.name), key=_place)
              for shaft in sizing.built_shafts}  # fmt: skip
    shafts = {name: own for name, own in shafts.items() if own}
    if not shafts or not held:
        return None
    letters = _letters(sizing, shafts)
    title = Title(
        sizing.design.name, "Bores of the housing", BORES_NAME, "Component drawing", sizing.design.housing.material
    )

    def views(scale: float) -> Rows:
        drawn = [_view(sizing, own, held, letters, scale) for own in shafts.values()]
        return [drawn[k : k + 2] for k in range(0, len(drawn), 2)]

    return Content(
        BORES_NAME,
        title,
        views,
        (_bores(sizing, shafts, letters),),
        tuple(_notes_on_bores()),
        largest_scale=1.0,
        kind="housing",
    )


def _place(bearing: BearingSizing) -> float:
    return bearing.position


def _letters(sizing: Sizing, shafts: Mapping[str, Sequence[BearingSizing]]) -> dict[str, str]:
    """Return bearing -> letter of the datum that its bore is: both radial ones of every shaft."""
    radial = [one.name for own in shafts.values() for one in own if sizing.design.bearings[one.name].radial]
    return dict(zip(radial, section_letters(), strict=False))


def _axis_of(sizing: Sizing, own: Sequence[BearingSizing], letters: Mapping[str, str]) -> str:
    return "–".join(letters[one.name] for one in own if one.name in letters)


def true_to(sizing: Sizing, shaft: str) -> Tolerance | None:
    """Return how the axis of a shaft's bores may stand to that of the shaft before it; None of the first.

    The zone of a position is as wide as the centre distance may vary both ways. Axes of a bevel pair at 90° are square,
    over the length of the shaft between its bearings.

    Args:
        sizing: What was sized.
        shaft: Its name.
    """
    order = [one.name for one in sizing.built_shafts]
    for mesh in sizing.meshes:
        nodes = next(row.nodes[:2] for row in sizing.train.meshes if row.name == mesh.name)
        others = [name for name in nodes if name != shaft and name in order[: order.index(shaft)]]
        if not others or shaft not in nodes:
            continue
        if kind_of(sizing, mesh.stage) == "bevel" and _is_square(sizing, mesh.stage):
            seats = [one.position for one in sizing.bearings if one.shaft == shaft]
            square = standard_tolerance(max(seats) - min(seats), BORE_GRADE)
            return Tolerance("perpendicularity", MM * square, others[0])
        if kind_of(sizing, mesh.stage) == "cylindrical":
            fit = sizing.design.rules(mesh.stage).centre_allowance or CENTRE_FIT_OF_BORES
            allowance = centre_allowance(mesh.centre_distance, fit)
            return Tolerance("position", MM * 2.0 * allowance, others[0])
    return None


def _is_square(sizing: Sizing, stage: str) -> bool:
    angle = sizing.design.pairs[stage].axis_angle
    return angle is None or math.isclose(angle, math.pi / 2.0)


def _view(
    sizing: Sizing, own: Sequence[BearingSizing], held: Sequence[Held], letters: Mapping[str, str], scale: float
) -> list[Entity]:
    """Return the bores of one shaft in section, with what they must keep."""
    axis = Axis(0j, 1 + 0j, scale)
    start = MM * min(one.position - one.width / 2.0 for one in own)
    end = MM * max(one.position + one.width / 2.0 for one in own)
    more = (LIP + OVERSHOOT) / scale + LIP
    entities: list[Entity] = [Path((axis.at(start - more), axis.at(end + more)), Layer.CENTRE)]
    for bearing in own:
        entities += _bore(axis, bearing, [one for one in held if one.bearing == bearing.name])
    top = max(axis.scale * MM * one.outer_diameter * (0.5 + WALL) for one in own)
    marks = sorted(_marks(sizing, own, letters), key=lambda mark: mark.x)
    for mark, slot in zip(marks, spread([scale * mark.x for mark in marks], ACROSS), strict=True):
        entities += marked(axis, mark, slot, top)
    for one in own:
        if one.name in letters:
            x, foot = MM * one.position, axis.at(MM * one.position, -MM * one.outer_diameter * (0.5 + WALL))
            entities.append(Path((axis.at(x, -MM * one.outer_diameter / 2.0), foot), Layer.DIMENSION))
            entities += datum(foot, -1j, letters[one.name])
    level = axis.origin - 1j * (top + TRIANGLE + 2.0 + HIGH + 4.0)
    first = MM * (own[0].position - own[0].width / 2.0)
    places = sorted({round(MM * (one.position + half * one.width), 6) for one in own for half in (-0.5, 0.5)})
    for x in places:
        if x > first + 1e-6:
            beside = min(own, key=lambda one: abs(MM * one.position - x))
            foot = axis.at(x, -MM * beside.outer_diameter * (0.5 + WALL))
            datum_foot = axis.at(first, -MM * own[0].outer_diameter * (0.5 + WALL))
            entities.append(Distance(datum_foot, foot, level, 0.0, scale))
            level -= 1j * LEVEL_OF_BORES
    words = f"{own[0].shaft}: axis {_axis_of(sizing, own, letters)}"
    low = extent(entities)[1]
    entities.append(Words(axis.at((start + end) / 2.0).real + 1j * (low - 8.0), words, TEXT, "middle"))
    return entities


def _bore(axis: Axis, bearing: BearingSizing, held: Sequence[Held]) -> Iterator[Entity]:
    """Yield the wall around an outer ring in section, with shoulders where they hold it."""
    low, high = MM * (bearing.position - bearing.width / 2.0), MM * (bearing.position + bearing.width / 2.0)
    radius, outer = MM * bearing.outer_diameter / 2.0, MM * bearing.outer_diameter * (0.5 + WALL)
    lip = radius - MM * 0.175 * (bearing.outer_diameter - bearing.inner_diameter) / 2.0
    shoulders = {one.way for one in held if one.by == "a shoulder of the housing"}
    before, after = LIP * (-1 in shoulders), LIP * (1 in shoulders)
    for side in (1.0, -1.0):
        points = [(low - before, outer), (high + after, outer)]
        points += [(high + after, lip), (high, lip)] if after else []
        points += [(high, radius), (low, radius)]
        points += [(low, lip), (low - before, lip)] if before else []
        corners = tuple(axis.at(x, side * r) for x, r in points)
        yield Hatch(corners, math.pi / 4.0)
        yield Path(corners, Layer.OUTLINE, closed=True)
    for x in (low, high):
        yield Path((axis.at(x, -radius), axis.at(x, radius)), Layer.OUTLINE)


def _marks(sizing: Sizing, own: Sequence[BearingSizing], letters: Mapping[str, str]) -> Iterator[Mark]:
    """Yield the diameter of every bore, and how true it is to the others of its axis, and its axis to others."""
    radial = [one for one in own if one.name in letters]
    for one in own:
        size, x = MM * one.outer_diameter, MM * one.position
        yield Mark(x, size / 2.0, f" {BORE_CLASS}" if one.name in letters else " + 1 (free)")
        if one in radial[1:]:
            true = Tolerance(
                "coaxiality", MM * standard_tolerance(one.outer_diameter, BORE_GRADE), letters[radial[0].name]
            )
            yield Mark(x + 0.3 * MM * one.width, size / 2.0, "", tolerance=true)
    wanted = true_to(sizing, own[0].shaft)
    if wanted is not None and radial:
        mates = [one for one in sizing.bearings if one.shaft == wanted.datums and one.name in letters]
        named = wanted._replace(datums=_axis_of(sizing, sorted(mates, key=_place), letters))
        yield Mark(
            MM * (radial[0].position + 0.3 * radial[0].width), MM * radial[0].outer_diameter / 2.0, "", tolerance=named
        )
    faces = [(own[0], -1.0), (own[-1], 1.0)] if len(own) > 1 else [(own[0], 1.0)]
    for bearing, way in faces:
        x, radius = MM * (bearing.position + way * bearing.width / 2.0), MM * bearing.outer_diameter * (0.5 + WALL)
        lean = MM * standard_tolerance(bearing.outer_diameter, BORE_GRADE)
        yield Mark(x, radius, "", tolerance=Tolerance("perpendicularity", lean, _axis_of(sizing, own, letters)))
        yield Mark(x + way * 0.01, radius, "", tolerance=Tolerance("flatness", lean / 2.0))


def _bores(sizing: Sizing, shafts: Mapping[str, Sequence[BearingSizing]], letters: Mapping[str, str]) -> Grid:
    """Return every bore with its bearing, its datum, its size and limits."""
    rows = []
    for shaft, own in shafts.items():
        for one in own:
            limit = "" if one.name not in letters else f"+{1e6 * standard_tolerance(one.outer_diameter, 7):.0f} / 0"
            size, wide = f"Ø{millimetres(MM * one.outer_diameter)}", millimetres(MM * one.width)
            rows.append((shaft, one.name, one.designation, letters.get(one.name, ""), size, limit, wide))
    heads = ("Shaft", "Bearing", "Type", "Datum", "Bore", f"{BORE_CLASS}, µm", "Width")
    return Grid("Bores", tuple(rows), heads)


def _notes_on_bores() -> Iterator[str]:
    yield f"Bores {BORE_CLASS} for outer rings under a load that stands still (assumed; DIN 5425-1); Ra 1.6 (assumed)."
    grade = f"IT{BORE_GRADE}"
    yield f"Coaxiality and perpendicularity {grade}, flatness of faces for covers {grade}/2 (usual; assumed)."
    vary = f"as far as centre distances may vary, {CENTRE_FIT_OF_BORES} (DIN 3964) where nothing is given"
    yield f"Position of axes: {vary}."
    yield f"Axes of a bevel pair are square to {grade} of the distance of its bearings (assumed)."
    yield "Free bores have 1 mm more than their bearings, which bear no radial load. Frames at bores mean their axes."
    yield f"Walls and shoulders as wide as drawn ({LIP:g} mm) are not sized; the housing has its own sheet."
