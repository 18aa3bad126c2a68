"""The general arrangement: every shaft with its gears and bearings in one plane, and a list of parts."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from gearwright.catalogue.standard_parts import BORE, ROUGHNESS, SHAFT
from gearwright.checks import Status
from gearwright.identity import GEARBOX, carrier_part
from gearwright.render.drawings.arrangement_view import (
    Item,
    Outside,
    axis_of,
    end_view,
    is_square,
    is_turned,
    planetary_parts,
    shaft_parts,
    standing_ring,
)
from gearwright.render.drawings.casing_section import (
    CasingSection,
    casing_entities,
    casing_items,
    casing_notes,
    casing_section,
)
from gearwright.render.drawings.entities import (
    SMALL,
    Arc,
    Box,
    Distance,
    Entity,
    Layer,
    Path,
    Words,
    arrow,
    drawn,
    extent,
    trimmed,
)
from gearwright.render.drawings.paper import Content, Grid, Rows, Segment, Title, balloons, clear_of, segments, texts
from gearwright.render.drawings.plane_section import (
    TrueSection,
    closed_towards,
    cutting_line,
    exit_notes,
    seen_from_second_end,
    true_entities,
    true_items,
    true_section,
)
from gearwright.render.drawings.positions import LETTER as SECTION
from gearwright.render.drawings.positions import Positions, cutting_way, positions, way_marks
from gearwright.render.drawings.shaft_view import MM, made_of
from gearwright.render.skeleton import pair_meshes
from gearwright.render.style import overlap
from gearwright.shape import scene as scene_of
from gearwright.shape.stands import kind_of
from gearwright.sizing import Sizing
from gearwright.sizing.casing import ring_seats
from gearwright.sizing.places import CLAUSE, bells
from gearwright.sizing.shafts import sealed_exits, unsealed_exits
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


def arrangement_content(sizing: Sizing) -> Content:
    """Return what the general arrangement shows.

    Args:
        sizing: What was sized.
    """
    shown = _shown(sizing)
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
        (Grid("Parts; mass of one", rows, heads), _axes(sizing)),
        (*shown.plane.notes, *_notes(shown)), largest_scale=1.0, kind=NAME, is_whole=True,
    )  # fmt: skip


def _shown(sizing: Sizing) -> _Shown:
    plane = positions(sizing)
    casing = casing_section(sizing, plane)
    if not sizing.design.housing.own:
        return _Shown(sizing, plane, casing, Outside())
    scene = scene_of(sizing, detail="coarse")
    has_end = _has_end_view(sizing, plane)
    outside = Outside()
    if has_end:
        lines, covers = seen_from_second_end(scene)
        outside = Outside(lines, covers, cutting_way(sizing, plane, covers) if casing is not None else ())
    apart = true_section(sizing, scene, plane) if has_end and casing is None else None
    return _Shown(sizing, plane, casing, outside, apart, closed_towards(sizing, scene))


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
    yield from _crowded(sizing)
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


def _crowded(sizing: Sizing) -> Iterator[str]:
    """Yield bodies that stand into each other."""
    for check in sizing.checks:
        if check.clause == CLAUSE and check.status is Status.FAILS:
            verb = "stands" if check.part == GEARBOX else "stand"  # a keep-out names one body
            yield f"{check.place} {verb} {check.why}: put one of them elsewhere."


def _axes(sizing: Sizing) -> Grid:
    """Return where the axes of all shafts stand in space: their first ends, and which way they go."""
    rows = []
    for name, frame in sizing.arrangement.frames.items():
        place = (trimmed(MM * at, 3) for at in frame.origin)
        rows.append((name, *place, ", ".join(trimmed(way, 4) for way in frame.along)))
    return Grid("Axes: first ends [mm]", tuple(rows), ("Shaft", "x", "y", "z", "direction"))


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
