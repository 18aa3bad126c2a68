"""The general arrangement: every shaft with its gears and bearings in one plane, and a list of parts."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gearwright.base import GEARBOX, Floats, Status, carrier_part
from gearwright.catalogue import centre_allowance, standard_tolerance
from gearwright.catalogue.standard_parts import BORE, ROUGHNESS, SHAFT
from gearwright.render.drawings.arrangement_view import (
    Item,
    Outside,
    axis_of,
    end_view,
    is_square,
    is_turned,
    names_beside,
    planetary_parts,
    shaft_parts,
    standing_ring,
)
from gearwright.render.drawings.casing_section import (
    SCREWS,
    SHOWN,
    CasingSection,
    casing_entities,
    casing_items,
    casing_notes,
    casing_section,
    web_nodes,
)
from gearwright.render.drawings.entities import (
    HIGH,
    SMALL,
    TEXT,
    TRIANGLE,
    Arc,
    Box,
    Distance,
    Entity,
    GeometricTolerance,
    Hatch,
    Layer,
    Path,
    Words,
    arrow,
    datum,
    drawn,
    extent,
    millimetres,
    section_letters,
    tolerance_frame,
    trimmed,
)
from gearwright.render.drawings.paper import (
    AIR,
    Content,
    Rows,
    Segment,
    SheetTable,
    Title,
    balloons,
    clear_of,
    segments,
    texts,
)
from gearwright.render.drawings.plane_section import (
    Casing,
    TrueSection,
    casing_of,
    closed_towards,
    cutting_line,
    end_outlines,
    exit_notes,
    holes_behind,
    mounts_grid,
    screw_circles,
    seen_from_second_end,
    span_of,
    standing_notes,
    true_entities,
    true_items,
    true_section,
    uncut,
)
from gearwright.render.drawings.positions import LETTER as SECTION, Positions, cutting_way, positions, way_marks
from gearwright.render.drawings.shaft_view import ACROSS, MM, OVERSHOOT, Callout, SheetAxis, made_of, marked
from gearwright.render.skeleton import pair_meshes
from gearwright.render.style import overlap, spread
from gearwright.shape import Scene, kind_of, sized_mesh
from gearwright.shape.chambers import spans_in
from gearwright.sizing import BearingSizing, Sizing
from gearwright.sizing.casing import HOLE, Flanges, bolted_rings, ring_seats
from gearwright.sizing.mass import carried_in_walls, weighed_flanges
from gearwright.sizing.places import CLAUSE, bells
from gearwright.sizing.shafts import Held, held_rings, sealed_exits, unsealed_exits
from gearwright.spec import GROUND

# ----------------------------------------------------------------------------------------------------------------------
# What a general arrangement says of its sets: how rings and carriers are held, and what it does not draw.
# ----------------------------------------------------------------------------------------------------------------------


def set_notes(sizing: Sizing, *, cut: bool) -> Iterator[str]:
    """Yield what has to be said of planetary and compound sets.

    Args:
        sizing: What was sized.
        cut: Whether the section shows the housing.
    """
    if any(gear.rim and GROUND in gear.shafts for gear in sizing.gears):
        where = "in lands of the housing" if cut else "in the housing"
        if list(ring_seats(sizing)):
            splines = "splines (as DIN 5480-1, cut at half of their height)"
            yield f"Rings that stand have {splines} {where}; keepers by screws."
        elif bolted_rings(sizing):
            yield "Rings that stand are bolted between two housings, as their wall; screws through them are not sized."
        else:
            yield "What holds rings that stand is not sized, and not drawn."
    if names := [carrier.stage for carrier in sizing.carriers if carrier.shaft == GROUND]:
        yield f"What holds the standing carrier of {', '.join(names)} in the housing is not sized, and not drawn."
    if list(bells(sizing)):
        yield "Bells of rings: thickness by torque; what joins them to ring and shaft is not sized, and not drawn."
    if names := [name for name in sizing.design.sets if name not in sizing.design.planetaries]:
        yield f"Planets and carrier of {', '.join(names)} are not drawn in this section."


# ----------------------------------------------------------------------------------------------------------------------
# The general arrangement: every shaft with its gears and bearings in one plane, item numbers and a list of parts.
# ----------------------------------------------------------------------------------------------------------------------


NAME = "arrangement"
ARROW_NAME, LETTER, LENGTH = "A", 5.0, 12.0
"""Of the view along the first shaft: its letter, how high that is, how long its arrow [mm]."""
BEYOND = 8.0
"""From the outermost item numbers to lengths over all [mm]."""
DOT = 1.5
"""Room for the dot at the end of a leader [mm]."""
_FURTHER = 60
"""Places of a centre distance that are tried, further and further left [-]."""
_TRIES = 12
"""Places of a name that are tried, a line further down or out [-]."""


@dataclass(frozen=True)
class _Shown:
    """What the sheet shows."""

    sizing: Sizing
    plane: Positions
    casing: CasingSection | None
    """The housing, where the section cuts it."""
    outside: Outside
    """The housing from the second end of the first shaft, where the sheet has that view."""
    apart: TrueSection | None = None
    """A section by one plane with the housing, where the unfolded one cannot have it."""
    closed: tuple[str, ...] = ()
    """Machines towards which the housing has no opening."""


def arrangement_content(sizing: Sizing, solids: Scene) -> Content:
    """Return what the general arrangement shows.

    Args:
        sizing: What was sized.
        solids: A scene of it.
    """
    shown = _shown(sizing, solids)
    items = _items(shown)
    rows = tuple(
        (f"{k}", f"{item.count}", item.part, item.remark, "" if item.mass is None else _kilograms(item.mass))
        for k, item in enumerate(items, start=1)
    )
    heads = ("Item", "Qty", "Part", "Remark", "Mass [kg]")
    title = Title(
        sizing.design.name, "General arrangement", NAME, "Assembly drawing", mass=f"{made_of(sizing).total:.1f}"
    )
    return Content(
        NAME, title, lambda scale: _views(shown, scale),
        (SheetTable("Parts; mass of one", rows, heads), _axes(sizing)),
        (*shown.plane.notes, *_notes(shown)), largest_scale=1.0, kind=NAME, is_whole=True,
    )  # fmt: skip


def _shown(sizing: Sizing, solids: Scene) -> _Shown:
    plane = positions(sizing)
    casing = casing_section(sizing, solids, plane)
    if not sizing.design.housing.own:
        return _Shown(sizing, plane, casing, Outside())
    has_end = _has_end_view(sizing, plane)
    outside = Outside()
    if has_end:
        lines, covers = seen_from_second_end(solids)
        outside = Outside(lines, covers, cutting_way(sizing, plane, covers) if casing is not None else ())
    apart = true_section(sizing, solids, plane) if has_end and casing is None else None
    return _Shown(sizing, plane, casing, outside, apart, closed_towards(sizing, solids))


def _items(shown: _Shown) -> list[Item]:
    """Return the list of parts."""
    apart = true_items(shown.sizing, shown.apart, 1.0) if shown.apart is not None else []
    return [*_parts(shown, 1.0)[1], *apart]


def _kilograms(mass: float) -> str:
    """Return a mass with three digits, or to the kilogram [kg]."""
    return f"{mass:.0f}" if mass >= 100.0 else f"{mass:.3g}"


def _notes(shown: _Shown) -> Iterator[str]:
    sizing, plane = shown.sizing, shown.plane
    if _has_end_view(sizing, plane):
        around = ", housing from outside" if shown.outside.lines else ""
        yield f"View {ARROW_NAME}: along the first shaft from its second end, axes in place, pitch circles{around}."
    if sizing.bearings:
        yield (
            "Bearings simplified: boundary dimensions ISO 15 or ISO 355, rings with shoulders as drawn, rolling "
            "elements as their ratings assume."
        )
    else:
        yield "No bearings, shoulders and joints are sized: shafts are the cylinders of the first sizing."
    yield from set_notes(sizing, cut=shown.casing is not None)
    # Bodies that stand into each other.
    for check in sizing.checks:
        if check.clause == CLAUSE and check.status is Status.FAILS:
            verb = "stands" if check.part == GEARBOX else "stand"  # a keep-out names one body
            yield f"{check.place} {verb} {check.why}: put one of them elsewhere."
    if shown.apart is not None:
        yield "B-B: by the plane through the first axis with most axes, the housing in section; other axes unfolded."
    yield from casing_notes(sizing, shown.casing if shown.apart is None else shown.apart.casing.section)
    yield from exit_notes(shown.closed)
    listed = sum(item.count * (item.mass or 0.0) for item in _items(shown))
    yield f"Mass: the complete mass; {made_of(sizing).total - listed:.3g} kg of it are in no part of the list."
    yield "Gears in section by ISO 2203. Lubrication is not drawn."
    yield from _seals(sizing)


def _seals(sizing: Sizing) -> Iterator[str]:
    """Yield what is told of radial seals, and of places where none is."""
    sealed, others = sealed_exits(sizing), unsealed_exits(sizing)
    if sealed:
        low, high = (1e6 * limit for limit in ROUGHNESS)
        yield (
            f"Radial seals of type A, lips to the oil; bores {BORE}, shafts under them {SHAFT}, Ra {low:g} to "
            f"{high:g}, ground without lead."
        )
    if others:
        names = ", ".join(leaves.machine for leaves in others)
        yield f"No seal is drawn towards {names}: gearwright review says why."


def _axes(sizing: Sizing) -> SheetTable:
    """Return where the axes of all shafts stand in space: their first ends, and which way they go."""
    rows = []
    for name, frame in sizing.arrangement.frames.items():
        place = (trimmed(MM * at, 3) for at in frame.origin)
        rows.append((name, *place, ", ".join(trimmed(way, 4) for way in frame.along)))
    return SheetTable("Axes: first ends [mm]", tuple(rows), ("Shaft", "x", "y", "z", "direction"))


def _views(shown: _Shown, scale: float) -> Rows:
    sizing, plane = shown.sizing, shown.plane
    entities, items = _parts(shown, scale)
    parts = extent([mark for mark in entities if isinstance(mark, Path | Arc) and mark.layer is Layer.OUTLINE])
    entities += _distances(sizing, plane, scale, list(segments(entities)))
    dots = [(item.anchor - arm, item.anchor + arm) for item in items for arm in (DOT, 1j * DOT)]
    entities += _machines(sizing, plane, scale, [*segments(entities), *dots], parts)
    entities += balloons([item.anchor for item in items], extent(entities), texts(entities))
    entities += _overall(parts, entities, scale, tall=plane.exact and not plane.notes)
    if not _has_end_view(sizing, plane):
        return [[entities]]
    level = plane.shafts[sizing.design.shafts[0]].at(0.0).imag * scale
    entities += _looked(complex(extent(entities)[2] + BEYOND, level))
    turned = is_turned(sizing, plane.shafts)
    seen = end_view(sizing, scale, shown.outside, turned=turned)
    if shown.apart is not None:
        seen += cutting_line(shown.apart, shown.outside.lines, scale, turned=turned)
    if shown.outside.way:
        seen += way_marks([(-scale if turned else scale) * point for point in shown.outside.way])
        around = extent(entities)
        name_at = complex((around[0] + around[2]) / 2.0, around[3] + BEYOND)
        entities.append(Words(name_at, f"{SECTION}-{SECTION}", LETTER, "middle"))
    box = extent(seen)
    seen.append(Words(complex((box[0] + box[2]) / 2.0, box[3] + BEYOND / 2.0), ARROW_NAME, LETTER, "middle"))
    if shown.apart is None:
        return [[seen, entities]]
    return [[seen, entities, true_entities(sizing, shown.apart, scale, len(items) + 1)]]


def _looked(tip: complex) -> Iterator[Entity]:
    """Yield the arrow of a view that need not stand where projection has it (ISO 128-3:2022), with its letter."""
    yield Path((tip, tip + LENGTH), Layer.OUTLINE)
    yield arrow(tip, -1.0 + 0j, Layer.OUTLINE)
    yield Words(tip + complex(LENGTH / 2.0, 2.0), ARROW_NAME, LETTER, "middle")


def _has_end_view(sizing: Sizing, plane: Positions) -> bool:
    """Tell whether the sheet has a view along the first shaft: where axes are unfolded or planets stand around them."""
    return is_square(sizing) and (not plane.exact or bool(plane.notes) or bool(sizing.design.sets))


def _parts(shown: _Shown, scale: float) -> tuple[list[Entity], list[Item]]:
    sizing, plane = shown.sizing, shown.plane
    entities: list[Entity] = []
    items: list[Item] = []
    for name in plane.shafts:
        drawn, listed = shaft_parts(sizing, plane, name, scale)
        entities, items = entities + drawn, items + listed
    for stage in sizing.design.planetaries:
        drawn, listed = planetary_parts(sizing, stage, plane, scale, lean=3.0 * math.pi / 4.0)
        entities, items = entities + drawn, items + listed
    for ring in (gear for gear in sizing.gears if gear.rim and gear.stage in sizing.design.sets):
        if GROUND in ring.shafts:
            drawn, listed = standing_ring(sizing, ring, plane, scale, lean=math.pi / 4.0)
            entities, items = entities + drawn, items + listed
    if shown.casing is not None:
        entities += casing_entities(shown.casing, scale)
        items += casing_items(sizing, shown.casing, scale)
    return entities, items


def _machines(sizing: Sizing, plane: Positions, scale: float, lines: Sequence[Segment], parts: Box) -> Iterator[Entity]:
    """Yield the name of every machine, clutch and damper where it joins its shaft, clear of lines and other names.

    Those within the parts stand above or below them, where that is not too far.
    """
    seats = dict(sizing.train.machines) | {link.name: link.driving for link in sizing.train.links}
    names: list[Words] = []
    for name, shaft in seats.items():
        lying, x = plane.shafts[shaft], plane.places[shaft][name]
        axis = axis_of(lying, scale)
        first, last = _ends(sizing, plane, shaft)
        if first < x < last:
            ways = [complex(aside, -way * (14.0 + 4.0 * k))
                    for aside in (4.0, 12.0, 20.0, 28.0) for k in range(3 * _TRIES) for way in (1.0, -1.0)]  # fmt: skip
            knees = sorted((axis.at(x) + way for way in ways), key=lambda knee: parts[1] < knee.imag < parts[3])
            wanted = [Words(knee + complex(1.0, -SMALL / 2.0), name, SMALL) for knee in knees]
            words = _clear(wanted, names, lines)
            yield Path((axis.at(x), knees[wanted.index(words)]), Layer.SYMBOL)
        else:
            outwards = -lying.along if x <= first else lying.along
            words = _clear(_beyond(name, axis.at(lying.start if x <= first else lying.end), outwards), names, lines)
        names.append(words)
        yield words


def _beyond(name: str, end: complex, outwards: complex) -> list[Words]:
    """Return places of a name beyond the end of a shaft, the nearest first."""
    flat = abs(outwards.real) > 0.5
    align = ("right" if outwards.real < 0.0 else "left") if flat else "middle"
    drop = 1.5 if flat else (0.0 if outwards.imag > 0.0 else -SMALL)
    places = [end + 6.0 * outwards + 1j * drop - 1j * (SMALL + 1.0) * k for k in range(_TRIES)]
    places += [end + (6.0 + 6.0 * k) * outwards + 1j * drop for k in range(1, _TRIES)]
    return [Words(place, name, SMALL, align) for place in places]


def _clear(wanted: Sequence[Words], names: Sequence[Words], lines: Sequence[Segment]) -> Words:
    """Return the first of several places of a name where it covers no other one, and no line where that can be."""
    boxes = [extent([other]) for other in names]
    apart = [words for words in wanted if not any(overlap(extent([words]), box) for box in boxes)]
    return next((words for words in apart if clear_of([words], lines)), apart[0] if apart else wanted[0])


def _ends(sizing: Sizing, plane: Positions, shaft: str) -> tuple[float, float]:
    """Return the middles of the first and the last gear, carrier or bearing on a shaft [mm]."""
    carried = [gear.name for gear in sizing.gears if shaft in gear.shafts]
    carried += [
        str(carrier_part(name)) for name, planetary in sizing.design.planetaries.items() if planetary.carrier == shaft
    ]
    seats = [plane.places[shaft][name] for name in carried]
    seats += [MM * bearing.position for bearing in sizing.bearings if bearing.shaft == shaft]
    lying = plane.shafts[shaft]
    middle = (lying.start + lying.end) / 2.0
    return min(seats, default=middle), max(seats, default=middle)


def _distances(sizing: Sizing, plane: Positions, scale: float, marks: Sequence[Segment]) -> Iterator[Entity]:
    """Yield centre distances that the plane shows, left of both gears, where no line runs through their texts."""
    seen: set[tuple[float, float]] = set()
    for mesh in pair_meshes(sizing.train):
        lines = [plane.shafts[node] for node in mesh.nodes[:2]]
        if kind_of(sizing, mesh.stage) != "cylindrical":
            continue
        if mesh.name in plane.unfolded:
            continue
        ends = [axis_of(line, scale).at(line.start) for line in lines]
        key = (round(ends[0].imag, 3), round(ends[1].imag, 3))
        if key not in seen and abs(lines[0].along.imag) < 1e-9:
            seen.add(key)
            left = min(end.real for end in ends) - 30.0 - 9.0 * (len(seen) - 1)
            tried = [Distance(ends[0] - 4.0, ends[1] - 4.0, complex(left - 6.0 * k, 0.0), math.pi / 2.0, scale)
                     for k in range(_FURTHER)]  # fmt: skip
            yield next((each for each in tried if clear_of(texts(drawn([each])), marks)), tried[0])


def _overall(parts: Box, entities: Sequence[Entity], scale: float, *, tall: bool) -> Iterator[Entity]:
    """Yield the length over all parts, and their height where the plane shows it true, where no line meets a text."""
    around, words = extent(entities), texts(entities)
    corners = complex(parts[0], parts[1]), complex(parts[2], parts[1]), complex(parts[2], parts[3])
    wide = Distance(corners[0], corners[1], complex(corners[0].real, around[1] - BEYOND), 0.0, scale)
    high = Distance(corners[1], corners[2], complex(around[2] + BEYOND, corners[1].imag), math.pi / 2.0, scale)
    for size in (wide, high) if tall else (wide,):
        if clear_of(words, list(segments(drawn([size])))):
            yield size


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


def casing_content(sizing: Sizing, solids: Scene) -> Content | None:
    """Return what the sheet of the housing shows; None where the gearbox has none of its own, or no plane cuts it.

    Args:
        sizing: What was sized.
        solids: A scene of it.
    """
    casing = casing_of(sizing, solids)
    if casing is None:
        return None
    flanges = weighed_flanges(sizing)
    mass = sum(each for name, each in made_of(sizing).casing.items() if name != SCREWS)
    material = sizing.design.housing.material
    title = Title(sizing.design.name, "Housing", HOUSING_NAME, "Component drawing", material, f"{mass:.1f}")

    def views(scale: float) -> Rows:
        return [[_section(sizing, casing, scale), _end(sizing, casing, flanges, scale)]]

    grids = (_flange_grid(casing, flanges), _chambers(casing), _openings(casing), _webs(sizing, casing),
             mounts_grid(casing), _bore_axes(sizing))  # fmt: skip
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
    frame = GeometricTolerance("flatness", FLAT)
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


def _flange_grid(casing: Casing, flanges: Flanges) -> SheetTable:
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
    return SheetTable("Flanges [mm]", tuple(rows), ("No.", "Joint at", "Width", "Thickness", "Screws", "Pitch"))


def _top(casing: Casing, loop: Floats) -> float:
    return float(np.max(casing.seen(loop).imag))


def _chambers(casing: Casing) -> SheetTable:
    """Return every chamber: from where to where along the first shaft, wall, how high and wide it is."""
    rows = []
    for k, (node, solid) in enumerate(casing.chambers, start=1):
        seen, wall = casing.seen(solid.outer), _top(casing, solid.outer) - _top(casing, solid.inner)
        places = (trimmed(MM * (at - casing.start), 1) for at in span_of(node, solid))
        sizes = (trimmed(MM * float(np.ptp(part)), 1) for part in (seen.imag, seen.real))
        rows.append((f"{k}", *places, millimetres(MM * wall), *sizes))
    return SheetTable("Chambers, outside [mm]", tuple(rows), ("No.", "From", "To", "Wall", "Height", "Width"))


def _openings(casing: Casing) -> SheetTable:
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
    return SheetTable("Round openings [mm]", lines, ("Chamber", "Size", "x", "y", "z"))


def _circle(hole: Floats) -> tuple[list[float], float | None]:
    """Return middle and radius of the largest circle in a hole; no radius of what is not round [m]."""
    middle = hole.mean(axis=0)
    far = np.linalg.norm(hole - middle, axis=1)
    is_round = float(np.ptp(far)) < 1e-6 * float(far.mean())
    return middle.tolist(), float(far.mean()) * math.cos(math.pi / len(hole)) if is_round else None


def _webs(sizing: Sizing, casing: Casing) -> SheetTable:
    """Return the webs that carry bosses, seen from the first end: 0° points up, clockwise."""
    rows = []
    for web in (web for carried in carried_in_walls(sizing) for web in carried.webs):
        seen = complex(casing.seen(casing.foot + web.way[None, 1:])[0])
        turned = round(math.degrees(math.atan2(seen.real, seen.imag))) % 360
        where = f"{turned}°" if abs(web.way[0]) < SQUARE else "along the first shaft"
        sizes = (millimetres(MM * web.thickness), millimetres(MM * web.width), trimmed(MM * web.length, 1))
        rows.append((web.bearing, where, *sizes))
    return SheetTable("Webs of bosses [mm]", tuple(rows), ("Boss", "Way", "Thickness", "Width", "Length"))


def _bore_axes(sizing: Sizing) -> SheetTable:
    """Return where axes along the first shaft stand."""
    rows = tuple((name, *(trimmed(MM * at, 3) for at in frame.origin[1:]))
                 for name, frame in sizing.arrangement.frames.items() if abs(frame.along.x) > 1.0 - SQUARE)  # fmt: skip
    return SheetTable("Axes along the first shaft [mm]", rows, ("Shaft", "y", "z"))


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


def true_to(sizing: Sizing, shaft: str) -> GeometricTolerance | None:
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
            return GeometricTolerance("perpendicularity", MM * square, others[0])
        if kind_of(sizing, mesh.stage) == "cylindrical":
            fit = sizing.design.rules(mesh.stage).centre_allowance or CENTRE_FIT_OF_BORES
            allowance = centre_allowance(mesh.centre_distance, fit)
            return GeometricTolerance("position", MM * 2.0 * allowance, others[0])
    return None


def _is_square(sizing: Sizing, stage: str) -> bool:
    angle = sizing.design.pairs[stage].axis_angle
    return angle is None or math.isclose(angle, math.pi / 2.0)


def _view(
    sizing: Sizing, own: Sequence[BearingSizing], held: Sequence[Held], letters: Mapping[str, str], scale: float
) -> list[Entity]:
    """Return the bores of one shaft in section, with what they must keep."""
    axis = SheetAxis(0j, 1 + 0j, scale)
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


def _bore(axis: SheetAxis, bearing: BearingSizing, held: Sequence[Held]) -> Iterator[Entity]:
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


def _marks(sizing: Sizing, own: Sequence[BearingSizing], letters: Mapping[str, str]) -> Iterator[Callout]:
    """Yield the diameter of every bore, and how true it is to the others of its axis, and its axis to others."""
    radial = [one for one in own if one.name in letters]
    for one in own:
        size, x = MM * one.outer_diameter, MM * one.position
        yield Callout(x, size / 2.0, f" {BORE_CLASS}" if one.name in letters else " + 1 (free)")
        if one in radial[1:]:
            true = GeometricTolerance(
                "coaxiality", MM * standard_tolerance(one.outer_diameter, BORE_GRADE), letters[radial[0].name]
            )
            yield Callout(x + 0.3 * MM * one.width, size / 2.0, "", tolerance=true)
    wanted = true_to(sizing, own[0].shaft)
    if wanted is not None and radial:
        mates = [one for one in sizing.bearings if one.shaft == wanted.datums and one.name in letters]
        named = wanted._replace(datums=_axis_of(sizing, sorted(mates, key=_place), letters))
        yield Callout(
            MM * (radial[0].position + 0.3 * radial[0].width), MM * radial[0].outer_diameter / 2.0, "", tolerance=named
        )
    faces = [(own[0], -1.0), (own[-1], 1.0)] if len(own) > 1 else [(own[0], 1.0)]
    for bearing, way in faces:
        x, radius = MM * (bearing.position + way * bearing.width / 2.0), MM * bearing.outer_diameter * (0.5 + WALL)
        lean = MM * standard_tolerance(bearing.outer_diameter, BORE_GRADE)
        yield Callout(
            x, radius, "", tolerance=GeometricTolerance("perpendicularity", lean, _axis_of(sizing, own, letters))
        )
        yield Callout(x + way * 0.01, radius, "", tolerance=GeometricTolerance("flatness", lean / 2.0))


def _bores(sizing: Sizing, shafts: Mapping[str, Sequence[BearingSizing]], letters: Mapping[str, str]) -> SheetTable:
    """Return every bore with its bearing, its datum, its size and limits."""
    rows = []
    for shaft, own in shafts.items():
        for one in own:
            limit = "" if one.name not in letters else f"+{1e6 * standard_tolerance(one.outer_diameter, 7):.0f} / 0"
            size, wide = f"Ø{millimetres(MM * one.outer_diameter)}", millimetres(MM * one.width)
            rows.append((shaft, one.name, one.designation, letters.get(one.name, ""), size, limit, wide))
    heads = ("Shaft", "Bearing", "Type", "Datum", "Bore", f"{BORE_CLASS}, µm", "Width")
    return SheetTable("Bores", tuple(rows), heads)


def _notes_on_bores() -> Iterator[str]:
    yield f"Bores {BORE_CLASS} for outer rings under a load that stands still (assumed; DIN 5425-1); Ra 1.6 (assumed)."
    grade = f"IT{BORE_GRADE}"
    yield f"Coaxiality and perpendicularity {grade}, flatness of faces for covers {grade}/2 (usual; assumed)."
    vary = f"as far as centre distances may vary, {CENTRE_FIT_OF_BORES} (DIN 3964) where nothing is given"
    yield f"Position of axes: {vary}."
    yield f"Axes of a bevel pair are square to {grade} of the distance of its bearings (assumed)."
    yield "Free bores have 1 mm more than their bearings, which bear no radial load. Frames at bores mean their axes."
    yield f"Walls and shoulders as wide as drawn ({LIP:g} mm) are not sized; the housing has its own sheet."
