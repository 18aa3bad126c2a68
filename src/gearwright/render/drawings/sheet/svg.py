"""Sheets as SVG, in mm, one group a layer."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable
from html import escape

from gearwright.render.drawings.sheet.dimensions import drawn
from gearwright.render.drawings.sheet.entities import (
    CAPITALS,
    INDEX,
    Arc,
    Hatch,
    Layer,
    Mark,
    Path,
    Words,
    runs,
    trimmed,
)
from gearwright.render.drawings.sheet.sheets import Sheet

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
    return "M" + "L".join(_point(point, height) for point in points)


def _point(point: complex, height: float) -> str:
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
    return f'<path d="M{_point(start, height)}A{radius} {radius} 0 {large} 0 {_point(end, height)}"/>'


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
