"""A figure as SVG: real text, colours that a page may change by CSS variables, whole numbers for coordinates."""

from __future__ import annotations

import base64
import re
import struct
import zlib
from collections.abc import Sequence
from html import escape
from itertools import groupby
from operator import itemgetter

import numpy as np

from gearwright.render.vector.figure import Figure
from gearwright.render.vector.ink import Disc, Frame, Image, Ink, Line, Path
from gearwright.render.vector.marks import Pen, circle
from gearwright.render.vector.painting import painted
from gearwright.render.vector.palette import DARK, MUTED, NAMES, PAPER, css_value, tinted
from gearwright.render.vector.thinning import straightened
from gearwright.render.vector.words import POINT, SMALL

ROUND = 13
"""Points of an ellipse of four cubic curves."""
UNITS = 20.0
"""Steps of the drawing's own grid in one mm."""
FONT = "DejaVu Sans,Verdana,sans-serif"
OPEN = 'fill="none"'
LOOK = "\0"
"""Where an element's look stands until it is known whether its neighbours share it."""
_DASHES = {"--": "5 2.5", ":": "1 1.8"}


def svg_text(figure: Figure, prefix: str = "", *, styled: bool = True) -> str:
    """Return a figure as an SVG element that stands alone or inside a page.

    Args:
        figure: As drawn.
        prefix: Goes before every id and names the figure's own ids, so that several figures can share a page.
        styled: With its own style; else the page has that of `style_of`.
    """
    writer = _Writer(figure, f"{prefix}-" if prefix else "", styled=styled)
    return writer.text(painted(figure))


def style_of(page: str) -> str:
    """Return the rules of all classes that figures without their own style use on a page, and its colours.

    Args:
        page: HTML.
    """
    light = "".join(f"--gw-{name}:{colour};" for colour, name in NAMES.items())
    dark = "".join(f"--gw-{name}:{colour};" for name, colour in DARK.items())
    used = sorted(set(re.findall(r"gw-[fs]-[a-z0-9-]+", page)))
    colours = {
        known[0]: re.sub(r",#\w+\)", ")", known[1]) for known in map(css_value, (*NAMES, *map(tinted, NAMES))) if known
    }
    kinds = {"f": "fill", "s": "stroke"}
    rules = "".join(f".{name}{{{kinds[name[3]]}:{colours[name[5:]]}}}" for name in used)
    return f":root{{{light}}}@media screen and (prefers-color-scheme:dark){{:root{{{dark}}}}}{rules}"


class _Writer:
    """Collects elements, and which colours and clips they need."""

    def __init__(self, figure: Figure, prefix: str, *, styled: bool) -> None:
        self.figure, self.prefix, self.styled = figure, prefix, styled
        self.rules: dict[str, str] = {}
        self.clips: dict[Frame, str] = {}
        self.hatched = False

    def text(self, ink: Sequence[Ink]) -> str:
        wide, high = self._length(self.figure.width), self._length(self.figure.height)
        body = [self._rectangle(0, 0, wide, high, self._look("fill", PAPER)), *self._body(ink)]
        titles = [axes.title for axes in self.figure.axes if axes.title]
        title = self.figure.title or "; ".join(dict.fromkeys(titles)) or "Figure"
        told = ". ".join(dict.fromkeys(self.figure.texts()))
        lines = [
            f'<svg class="gw-figure" xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {wide} {high}" role="img"'
            f' width="{self.figure.width:.5g}mm" height="{self.figure.height:.5g}mm" font-family="{FONT}"'
            f' aria-labelledby="{self.prefix}title {self.prefix}desc">',
            f'<title id="{self.prefix}title">{escape(title.replace(chr(10), " "))}</title>',
            f'<desc id="{self.prefix}desc">{escape(told.replace(chr(10), " ")[:1500])}</desc>',
            *([f"<style>{self._style()}</style>"] if self.styled else []),
            *self._definitions(),
            *body,
            "</svg>",
        ]
        return "\n".join(lines) + "\n"

    def _style(self) -> str:
        rules = "".join(f".{name}{{{rule}}}" for name, rule in sorted(self.rules.items()))
        dark = "".join(f"--gw-{name}:{colour};" for name, colour in DARK.items())
        # A page sets the variables itself; only a file that stands alone follows the reader's own choice.
        return f"{rules}@media screen and (prefers-color-scheme:dark){{svg.gw-figure:root{{{dark}}}}}"

    def _definitions(self) -> list[str]:
        parts = []
        if self.hatched:
            look = self._look("stroke", MUTED)
            size = 'width="22" height="22" patternUnits="userSpaceOnUse"'
            parts.append(f'<pattern id="{self.prefix}hatch" {size}>'
                         f'<path d="M-5 5l10-10M0 22l22-22M17 27l10-10" stroke-width="4" {look}/>'
                         "</pattern>")  # fmt: skip
        for frame, name in self.clips.items():
            left, low, right, high = frame
            box = (self._x(left), self._y(high), self._x(right) - self._x(left), self._y(low) - self._y(high))
            parts.append(f'<clipPath id="{name}">{self._rectangle(*box, "")}</clipPath>')
        return ["<defs>", *parts, "</defs>"] if parts else []

    def _body(self, ink: Sequence[Ink]) -> list[str]:
        """Return elements, those that share a clip in one group."""
        lines: list[str] = []
        for clip, drops in groupby(ink, key=lambda drop: getattr(drop, "clip", None)):
            lines += [f'<g clip-path="url(#{self._clip(clip)})">'] if clip is not None else []
            for look, elements in groupby(map(self._element, drops), key=itemgetter(1)):
                lines += _together([element for element, _ in elements], look)
            lines += ["</g>"] if clip is not None else []
        return lines

    def _clip(self, frame: Frame) -> str:
        return self.clips.setdefault(frame, f"{self.prefix}clip-{len(self.clips)}")

    def _element(self, drop: Ink) -> tuple[str, str]:
        """Return an element with a place for its look, and the look."""
        if isinstance(drop, Path):
            return self._path(drop)
        if isinstance(drop, Disc):
            look = self._look("fill", drop.fill) + _opacity(drop.alpha)
            if drop.edge:
                look += " " + self._stroke(Pen(drop.edge, drop.edge_width or 1.0))
            place = f'cx="{self._x(drop.x)}" cy="{self._y(drop.y)}" r="{drop.radius * UNITS:.3g}"'
            return f"<circle {place}{LOOK}/>", _one_class(look)
        if isinstance(drop, Image):
            return self._image(drop), ""
        return self._line(drop)

    def _path(self, path: Path) -> tuple[str, str]:
        shape = (
            self._round(path) or f'path d="{"".join(self._piece(piece, path) for piece in path.pieces if len(piece))}"'
        )
        look = self._look("fill", path.fill) + _opacity(path.alpha) if path.fill else OPEN
        if path.hatched:
            self.hatched = True
            look = f'fill="url(#{self.prefix}hatch)"'
        pen = " " + self._stroke(path.pen) if path.pen is not None else ""
        return f"<{shape}{LOOK}/>", _one_class(look + pen)

    def _round(self, path: Path) -> str:
        """Return the element of an ellipse; nothing for other paths."""
        points = path.pieces[0] if path.cubic and len(path.pieces) == 1 else np.zeros((0, 2))
        if len(points) != ROUND:
            return ""
        centre, size = (
            (points[0] + points[6]) / 2.0,
            np.array([points[0, 0] - points[6, 0], points[3, 1] - points[9, 1]]),
        )
        if not np.allclose(points, circle((centre[0], centre[1]), size[0], size[1])):
            return ""
        radii = np.round(np.abs(size) / 2.0 * UNITS).astype(int)
        return f'ellipse cx="{self._x(centre[0])}" cy="{self._y(centre[1])}" rx="{radii[0]}" ry="{radii[1]}"'

    def _piece(self, points: np.ndarray, path: Path) -> str:
        grid = np.stack([np.round(points[:, 0] * UNITS), np.round((self.figure.height - points[:, 1]) * UNITS)], axis=1)
        grid = grid if path.cubic else straightened(grid)
        steps = np.diff(grid.astype(int), axis=0)
        first = f"M{int(grid[0, 0])} {int(grid[0, 1])}"
        if path.cubic:
            words = " ".join(f"{x} {y}" for x, y in grid[1:].astype(int).tolist())
            return f"{first}C{words}z"
        words = " ".join(f"{x} {y}" for x, y in steps.tolist()).replace(" -", "-")
        return f"{first}l{words or '0 0'}" + ("z" if path.closed else "")

    def _line(self, line: Line) -> tuple[str, str]:
        x, y = self._x(line.x), self._y(line.y)
        size = line.size * POINT * UNITS
        look = f'font-size="{size:.3g}" {self._look("fill", line.colour)}'
        look += f' text-anchor="{line.anchor}"' if line.anchor != "start" else ""
        look += ' font-weight="bold"' if line.bold else ""
        turned = f' transform="rotate({-line.turned:.4g} {x} {y})"' if line.turned else ""
        words = "".join(self._spans(line, size))
        return f'<text x="{x}" y="{y}"{turned}{LOOK}>{words}</text>', look

    def _spans(self, line: Line, size: float) -> list[str]:
        words, level = [], 0.0
        for span in line.spans:
            to = -span.shift * (0.36 if span.shift > 0 else 0.2) * size
            moved = f' dy="{to - level:.3g}"' if to != level else ""
            level = to
            small = f' font-size="{SMALL * size:.3g}"' if span.shift else ""
            slanted = ' font-style="italic"' if span.italic else ""
            text = escape(span.text, quote=False)
            words.append(f"<tspan{moved}{small}{slanted}>{text}</tspan>" if moved or small or slanted else text)
        return words

    def _image(self, image: Image) -> str:
        left, low, right, high = image.frame
        box = (self._x(left), self._y(high), self._x(right) - self._x(left), self._y(low) - self._y(high))
        data = base64.b64encode(png_bytes(image.pixels[::-1])).decode("ascii")
        return (f'<image x="{box[0]}" y="{box[1]}" width="{box[2]}" height="{box[3]}" preserveAspectRatio="none"'
                f' href="data:image/png;base64,{data}"/>')  # fmt: skip

    def _rectangle(self, x: int, y: int, width: int, height: int, look: str) -> str:
        return f'<rect x="{x}" y="{y}" width="{width}" height="{height}" {look}/>'.replace(" />", "/>")

    def _look(self, what: str, colour: str) -> str:
        """Return the attribute of a colour, and the class by which a page may change it."""
        known = css_value(colour)
        if known is None:
            return f'{what}="{colour}"'
        name = f"gw-{what[0]}-{known[0]}"
        self.rules[name] = f"{what}:{known[1]}"
        return f'class="{name}" {what}="{colour}"' if self.styled else f'class="{name}"'

    def _stroke(self, pen: Pen) -> str:
        width = pen.width * POINT * UNITS
        look = f'{self._look("stroke", pen.colour)} stroke-width="{width:.3g}"'
        if pen.dash in _DASHES:
            steps = " ".join(f"{float(part) * width:.3g}" for part in _DASHES[pen.dash].split())
            look += f' stroke-dasharray="{steps}"'
        return look + (f' stroke-opacity="{pen.alpha:.3g}"' if pen.alpha < 1.0 else "")

    def _length(self, size: float) -> int:
        return round(size * UNITS)

    def _x(self, x: float) -> int:
        return round(x * UNITS)

    def _y(self, y: float) -> int:
        return round((self.figure.height - y) * UNITS)


def _together(elements: Sequence[str], look: str) -> list[str]:
    """Return elements of one look, which several of them have from their group."""
    if look.startswith(OPEN) and "opacity" not in look:
        elements = ["".join(elements).replace(f'"{LOOK}/><path d="', "")]
    if len(elements) == 1 or not look:
        return [element.replace(LOOK, f" {look}" if look else "") for element in elements]
    return [f"<g {look}>", *(element.replace(LOOK, "") for element in elements), "</g>"]


def _opacity(alpha: float) -> str:
    return f' fill-opacity="{alpha:.3g}"' if alpha < 1.0 else ""


def _one_class(look: str) -> str:
    """Return attributes with their classes in one."""
    parts = look.split('class="')
    if len(parts) < 3:
        return look
    names = [part.split('"', 1)[0] for part in parts[1:]]
    rest = parts[0] + "".join(part.split('"', 1)[1] for part in parts[1:])
    return f'class="{" ".join(names)}" {" ".join(rest.split())}'


def png_bytes(pixels: np.ndarray) -> bytes:
    """Return cells of colours as a PNG image.

    Args:
        pixels: Shape (rows, columns, 3), bytes, the first row on top.

    Source: ISO/IEC 15948 (PNG), chunks IHDR, IDAT and IEND; every row with filter 0.
    """
    rows, columns = pixels.shape[:2]
    raw = b"".join(b"\0" + row.tobytes() for row in np.ascontiguousarray(pixels, dtype=np.uint8))
    head = struct.pack(">IIBBBBB", columns, rows, 8, 2, 0, 0, 0)
    parts = [(b"IHDR", head), (b"IDAT", zlib.compress(raw, 9)), (b"IEND", b"")]
    chunks = [
        struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data)) for kind, data in parts
    ]
    return b"\x89PNG\r\n\x1a\n" + b"".join(chunks)
