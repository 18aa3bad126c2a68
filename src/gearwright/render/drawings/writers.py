"""Sheets as DXF (AutoCAD 2010) with parts in true size, and as SVG in mm."""

from __future__ import annotations

import cmath
import io
import math
from collections.abc import Iterable
from html import escape
from types import ModuleType
from typing import TYPE_CHECKING, Any

from gearwright.base import DesignError, Problem
from gearwright.render.drawings.entities import (
    ARROW,
    BEYOND,
    CAPITALS,
    GAP,
    INDEX,
    TEXT,
    Arc,
    Corner,
    Distance,
    Entity,
    Hatch,
    Layer,
    Mark,
    Path,
    Words,
    arrows_outside,
    corner_leader,
    corner_words,
    drawn,
    ends,
    runs,
    text_place,
    trimmed,
)
from gearwright.render.drawings.paper import Sheet

if TYPE_CHECKING:
    from ezdxf.document import Drawing
    from ezdxf.layouts import Modelspace


# ----------------------------------------------------------------------------------------------------------------------
# Sheets as DXF (AutoCAD 2010): parts in true size, paper enlarged to fit them, dimensions as DIMENSION entities.
#
# What is 1 mm on a part is one unit, so that everything can be measured; a sheet in 1 : 2 has a frame of twice its size
# and is plotted at 1 : 2.
# ----------------------------------------------------------------------------------------------------------------------


STYLE = "GEARWRIGHT"
"""Name of the styles of text and dimensions."""
_MILLIMETRES = 4
_BLACK = 7


def sheet_dxf(sheet: Sheet) -> str:
    """Return a sheet as the text of a DXF file, the same each time.

    Args:
        sheet: The sheet.

    Raises:
        DesignError: If ezdxf is not installed.
    """
    options, stream = _ezdxf().options, io.StringIO()
    before = options.write_fixed_meta_data_for_testing
    # Else every file would carry the time at which it was made.
    options.write_fixed_meta_data_for_testing = True
    try:
        document = sheet_document(sheet)
        # ezdxf adds classes from a set, whose order differs from process to process.
        document.classes.add_required_classes(document.dxfversion)
        document.classes.classes = dict(sorted(document.classes.classes.items()))
        document.write(stream)
    finally:
        options.write_fixed_meta_data_for_testing = before
    return stream.getvalue()


def sheet_document(sheet: Sheet) -> Drawing:
    """Return a sheet as a DXF document.

    Args:
        sheet: The sheet.

    Raises:
        DesignError: If ezdxf is not installed.
    """
    document: Drawing = _ezdxf().new("R2010", setup=False, units=_MILLIMETRES)
    _prepare(document, 1.0 / sheet.scale)
    space = document.modelspace()
    for entity in sheet.entities:
        _add(space, entity, 1.0 / sheet.scale)
    return document


def _ezdxf() -> ModuleType:
    """Return the package, or say how to get it."""
    try:
        import ezdxf
    except ModuleNotFoundError:
        message = "DXF needs the package ezdxf, which is not here; pip install ezdxf, or --format svg"
        raise DesignError([Problem("--format dxf", message)]) from None
    return ezdxf


def _prepare(document: Drawing, enlarged: float) -> None:
    """Make line types, layers and styles; lengths of styles are those of the paper."""
    document.header["$LTSCALE"] = enlarged
    document.styles.add(STYLE, font="arial.ttf")
    for layer in Layer:
        if layer.dashes:
            pattern = [sum(layer.dashes), *(dash * (-1.0) ** k for k, dash in enumerate(layer.dashes))]
            document.linetypes.add(layer.name, pattern, description=layer.value[0])
        line = layer.name if layer.dashes else "Continuous"
        added = document.layers.add(layer.name, color=_BLACK, linetype=line, lineweight=round(100 * layer.width))
        added.description = layer.value[0]
    style: Any = document.dimstyles.new(STYLE)
    style.dxf.dimscale = enlarged
    for name, value in (
        *(("dimtxt", TEXT), ("dimasz", ARROW), ("dimgap", GAP), ("dimexo", GAP), ("dimexe", BEYOND)),
        *(("dimtad", 1), ("dimtih", 0), ("dimtoh", 0), ("dimdec", 2), ("dimzin", 8), ("dimadec", 2), ("dimazin", 2)),
        *(("dimtxsty", STYLE), ("dimdsep", ord(".")), ("dimlfac", 1.0), ("dimtmove", 2)),
    ):
        style.dxf.set(name, value)


def _add(space: Modelspace, entity: Entity, enlarged: float) -> None:
    attributes = {"layer": entity.layer.name}
    match entity:
        case Path() if entity.filled:
            corners = [_point(point, enlarged) for point in entity.points[:4]]
            space.add_solid(corners, dxfattribs=attributes)
        case Path():
            points = [_point(point, enlarged) for point in entity.points]
            space.add_lwpolyline(points, close=entity.closed, dxfattribs=attributes)
        case Arc():
            centre, radius = _point(entity.centre, enlarged), entity.radius * enlarged
            if entity.whole:
                space.add_circle(centre, radius, dxfattribs=attributes)
            else:
                angles = (math.degrees(entity.start), math.degrees(entity.end))
                space.add_arc(centre, radius, *angles, dxfattribs=attributes)
        case Hatch():
            _add_hatch(space, entity, enlarged)
        case Words():
            _add_words(space, entity, enlarged)
        case Distance():
            _add_distance(space, entity, enlarged)
        case Corner():
            _add_corner(space, entity, enlarged)


def _point(point: complex, enlarged: float) -> tuple[float, float]:
    return point.real * enlarged, point.imag * enlarged


def _add_hatch(space: Modelspace, hatch: Hatch, enlarged: float) -> None:
    added = space.add_hatch(color=_BLACK, dxfattribs={"layer": hatch.layer.name})
    across = cmath.rect(hatch.spacing, hatch.angle + math.pi / 2.0)
    line = [math.degrees(hatch.angle), (0.0, 0.0), (across.real, across.imag), []]
    added.set_pattern_fill("SECTION", scale=enlarged, definition=[line])
    added.paths.add_polyline_path([_point(point, enlarged) for point in hatch.points], is_closed=True)


def _add_words(space: Modelspace, words: Words, enlarged: float) -> None:
    """Add one line: TEXT, or MTEXT where it has indices."""
    from ezdxf.enums import MTextEntityAlignment, TextEntityAlignment

    place, height, turn = _point(words.at, enlarged), words.height * enlarged, math.degrees(words.turn)
    attributes = {"layer": words.layer.name, "style": STYLE}
    parts = runs(words.text)
    if not any(low for _, low in parts):
        align = {"left": TextEntityAlignment.LEFT, "middle": TextEntityAlignment.CENTER}
        text = space.add_text(words.text, height=height, rotation=turn, dxfattribs=attributes)
        text.set_placement(place, align=align.get(words.align, TextEntityAlignment.RIGHT))
        return
    aligned = {"left": MTextEntityAlignment.BOTTOM_LEFT, "middle": MTextEntityAlignment.BOTTOM_CENTER}
    marked = "".join(f"{{\\H0.7x;\\S^ {part};}}" if low else part for part, low in parts)
    mtext = space.add_mtext(marked, dxfattribs=attributes | {"char_height": height})
    mtext.set_location(place, turn, aligned.get(words.align, MTextEntityAlignment.BOTTOM_RIGHT))


def _add_distance(space: Modelspace, dimension: Distance, enlarged: float) -> None:
    factor = 1.0 / (enlarged * dimension.scale)  # of a detail in another scale than its sheet
    centre = text_place(dimension) + cmath.rect(TEXT / 2.0, dimension.angle) * 1j
    added = space.add_linear_dim(
        base=_point(ends(dimension)[1], enlarged),
        p1=_point(dimension.first, enlarged),
        p2=_point(dimension.second, enlarged),
        angle=math.degrees(dimension.angle),
        text=f"{dimension.prefix}<>{dimension.suffix}",
        dimstyle=STYLE,
        override={} if math.isclose(factor, 1.0) else {"dimlfac": factor},
        dxfattribs={"layer": dimension.layer.name},
    )
    added.set_location(_point(centre, enlarged))
    added.render()
    if not arrows_outside(dimension) or dimension.text_at is not None:
        first, second = ends(dimension)
        for part in drawn([dimension]):
            if isinstance(part, Path) and not part.filled and _is_beyond(part, first, second):
                _add(space, part, enlarged)


def _is_beyond(part: Path, first: complex, second: complex) -> bool:
    """Return True for the line from a dimension line's end to text outside of it."""
    along = (second - first) / abs(second - first)
    return part.points[0] in (first, second) and abs(((part.points[1] - first) * (along * 1j).conjugate()).real) < 1e-6


def _add_corner(space: Modelspace, corner: Corner, enlarged: float) -> None:
    words = corner_words(corner)
    centre = words.at + cmath.rect(TEXT / 2.0, words.turn) * 1j
    added = space.add_angular_dim_cra(
        center=_point(corner.centre, enlarged),
        radius=corner.radius * enlarged,
        start_angle=math.degrees(corner.start),
        end_angle=math.degrees(corner.end),
        distance=0.0,
        dimstyle=STYLE,
        dxfattribs={"layer": corner.layer.name},
    )
    added.set_location(_point(centre, enlarged))
    added.render()
    for part in corner_leader(corner):
        _add(space, part, enlarged)


# ----------------------------------------------------------------------------------------------------------------------
# Sheets as SVG, in mm, one group a layer.
# ----------------------------------------------------------------------------------------------------------------------


_ANCHOR = {"left": "start", "middle": "middle", "right": "end"}
_FONT = "Arial, 'Liberation Sans', Helvetica, sans-serif"


def sheet_svg(sheet: Sheet, prefix: str = "") -> str:
    """Return a sheet as an SVG image of its true size.

    Args:
        sheet: The sheet.
        prefix: Goes before every id, so that several sheets can share a page.
    """
    width, height = sheet.size.width, sheet.size.height
    hatches = sorted({(entity.angle, entity.spacing) for entity in sheet.entities if isinstance(entity, Hatch)})
    patterns = {_pattern_name(*hatch): _pattern(*hatch) for hatch in hatches}  # turned views differ by rounding
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:g}mm" height="{height:g}mm" '
        f'viewBox="0 0 {width:g} {height:g}" font-family="{_FONT}">',
        f"<title>{escape(sheet.title)}</title>",
        f'<rect width="{width:g}" height="{height:g}" fill="#fff"/>',
        *patterns.values(),
    ]
    for layer in Layer:
        elements = [_element(mark, height) for mark in drawn(sheet.entities) if mark.layer is layer]
        if elements:
            lines += [_group(layer), *elements, "</g>"]
    text = "\n".join([*lines, "</svg>"]) + "\n"
    return text.replace(' id="', f' id="{prefix}').replace("url(#", f"url(#{prefix}")


def _group(layer: Layer) -> str:
    dashes = f' stroke-dasharray="{" ".join(f"{dash:g}" for dash in layer.dashes)}"' if layer.dashes else ""
    return (
        f'<g id="{layer.name}" fill="none" stroke="#000" stroke-width="{layer.width:g}" stroke-linejoin="round" '
        f'stroke-linecap="butt"{dashes}>'
    )


def _pattern(angle: float, spacing: float) -> str:
    # The pattern's own lines lie across; SVG counts angles clockwise.
    turn = -math.degrees(angle)
    return (
        f'<defs><pattern id="{_pattern_name(angle, spacing)}" width="{spacing:g}" height="{spacing:g}" '
        f'patternUnits="userSpaceOnUse" patternTransform="rotate({turn:g})">'
        f'<path d="M0 {spacing / 2:g}H{spacing:g}" stroke="#000" stroke-width="{Layer.HATCH.width:g}"/>'
        "</pattern></defs>"
    )


def _pattern_name(angle: float, spacing: float) -> str:
    return f"hatch{round(math.degrees(angle))}-{round(10 * spacing)}"


def _element(mark: Mark, height: float) -> str:
    match mark:
        case Path():
            ending = "Z" if mark.closed else ""
            fill = ' fill="#000" stroke="none"' if mark.filled else ""
            return f'<path d="{_track(mark.points, height)}{ending}"{fill}/>'
        case Arc():
            return _arc(mark, height)
        case Hatch():
            fill = f"url(#{_pattern_name(mark.angle, mark.spacing)})"
            return f'<path d="{_track(mark.points, height)}Z" fill="{fill}" stroke="none"/>'
        case Words():
            return _words(mark, height)


def _track(points: Iterable[complex], height: float) -> str:
    return "M" + "L".join(_svg_point(point, height) for point in points)


def _svg_point(point: complex, height: float) -> str:
    return " ".join(_coordinates(point, height))


def _coordinates(point: complex, height: float) -> tuple[str, str]:
    return _short(point.real), _short(height - point.imag)


def _short(value: float) -> str:
    return trimmed(value, 3)


def _arc(arc: Arc, height: float) -> str:
    if arc.whole:
        x, y = _coordinates(arc.centre, height)
        return f'<circle cx="{x}" cy="{y}" r="{_short(arc.radius)}"/>'
    start, end = (arc.centre + cmath.rect(arc.radius, angle) for angle in (arc.start, arc.end))
    large = int(arc.end - arc.start > math.pi)
    radius = _short(arc.radius)
    return f'<path d="M{_svg_point(start, height)}A{radius} {radius} 0 {large} 0 {_svg_point(end, height)}"/>'


def _words(words: Words, height: float) -> str:
    x, y = _coordinates(words.at, height)
    turn = f' transform="rotate({_short(-math.degrees(words.turn))} {x} {y})"' if words.turn else ""
    anchor = f' text-anchor="{_ANCHOR[words.align]}"' if words.align != "left" else ""
    size = words.height / CAPITALS
    return (
        f'<text x="{x}" y="{y}" font-size="{_short(size)}" fill="#000" stroke="none"{anchor}{turn}>'
        f"{''.join(_run(part, low, size) for part, low in runs(words.text))}</text>"
    )


def _run(part: str, low: bool, size: float) -> str:  # noqa: FBT001
    if not low:
        return escape(part)
    drop = 0.25 * size
    return (
        f'<tspan font-size="{_short(INDEX * size)}" dy="{_short(drop)}">{escape(part)}</tspan>'
        f'<tspan dy="{_short(-drop)}">\u200b</tspan>'
    )
