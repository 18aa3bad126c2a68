"""The sheet of the housing's bores: what every bearing is seated in, and how true bores stand to each other.

The housing around them is on a sheet of its own.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from gearwright.catalogue import centre_allowance, standard_tolerance
from gearwright.render.drawings.sheet.compose import Content, Rows
from gearwright.render.drawings.sheet.dimensions import extent
from gearwright.render.drawings.sheet.entities import (
    TEXT,
    Distance,
    Entity,
    Hatch,
    Layer,
    Path,
    Words,
    millimetres,
)
from gearwright.render.drawings.sheet.frame import Title
from gearwright.render.drawings.sheet.symbols import section_letters
from gearwright.render.drawings.sheet.tables import Grid
from gearwright.render.drawings.sheet.tolerances import HIGH, TRIANGLE, Tolerance, datum
from gearwright.render.drawings.views.marks import ACROSS, Mark, marked
from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.render.drawings.views.shaft_view import OVERSHOOT, Axis
from gearwright.render.style.labels import spread
from gearwright.shape.teeth import kind_of
from gearwright.sizing import BearingSizing, Sizing
from gearwright.sizing.shafts import Held, held_rings

NAME = "housing-bores"
BORE_GRADE = 6
"""Of coaxiality, of what cover faces and shoulders may lean, and, by half, of flatness: usual for bearings of normal
accuracy, assumed."""
BORE_CLASS = "H7"
"""Of bores, for outer rings under a load that stands still; assumed (DIN 5425-1)."""
CENTRE_FIT = "js7"
"""Of centre distances where the design gives none; assumed (DIN 3964)."""
WALL = 0.12
"""Wall of a bore that is drawn over its diameter: that of bosses as they are weighed."""
LIP = 5.0
"""Thickness of shoulders as drawn [mm]."""
LEVEL = 8.0
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
    title = Title(sizing.design.name, "Bores of the housing", NAME, "Component drawing", sizing.design.housing.material)

    def views(scale: float) -> Rows:
        drawn = [_view(sizing, own, held, letters, scale) for own in shafts.values()]
        return [drawn[k : k + 2] for k in range(0, len(drawn), 2)]

    return Content(
        NAME, title, views, (_bores(sizing, shafts, letters),), tuple(_notes()), largest_scale=1.0, kind="housing"
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
            fit = sizing.design.rules(mesh.stage).centre_allowance or CENTRE_FIT
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
            level -= 1j * LEVEL
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


def _notes() -> Iterator[str]:
    yield f"Bores {BORE_CLASS} for outer rings under a load that stands still (assumed; DIN 5425-1); Ra 1.6 (assumed)."
    grade = f"IT{BORE_GRADE}"
    yield f"Coaxiality and perpendicularity {grade}, flatness of faces for covers {grade}/2 (usual; assumed)."
    yield f"Position of axes: as far as centre distances may vary, {CENTRE_FIT} (DIN 3964) where nothing is given."
    yield f"Axes of a bevel pair are square to {grade} of the distance of its bearings (assumed)."
    yield "Free bores have 1 mm more than their bearings, which bear no radial load. Frames at bores mean their axes."
    yield f"Walls and shoulders as wide as drawn ({LIP:g} mm) are not sized; the housing has its own sheet."
