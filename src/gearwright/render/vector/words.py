"""Text on paper: how wide it is, and what of it stands higher or lower."""

from __future__ import annotations

import functools
import json
import re
from importlib import resources
from typing import NamedTuple

POINT = 25.4 / 72.0
"""One typographic point [mm]."""
SPACING = 1.3
"""Line height over font size [-]."""
SMALL = 0.72
"""Size of what stands higher or lower, over the rest [-]."""
_EM = 2048.0
_USUAL = 1229
_PIECES = re.compile(r"([_^])(?:\{([^}]*)\}|(.))|([^_^]+)")
_LETTERS = re.compile(r"[A-Za-zα-ω]")


class Span(NamedTuple):
    """A piece of a line of text."""

    text: str
    shift: int
    """1 above, −1 below the line, 0 on it."""
    italic: bool


@functools.cache
def _widths(face: str) -> dict[int, int]:
    runs = json.loads(resources.files("gearwright.render.vector").joinpath("widths.json").read_text("utf-8"))[face]
    return {int(first) + k: width for first, run in runs.items() for k, width in enumerate(run)}


@functools.lru_cache(maxsize=4096)
def spans(text: str, *, math: bool) -> tuple[Span, ...]:
    """Return the pieces of a line.

    Args:
        text: The line.
        math: True: symbols stand between dollar signs, with ``_`` and ``^`` before what is lower and higher.

    >>> [span.text for span in spans("$z_2/z_1$ = 3", math=True)]
    ['z', '2', '/z', '1', ' = 3']
    """
    if not math or "$" not in text:
        return (Span(text, 0, italic=False),)
    found: list[Span] = []
    for k, part in enumerate(text.split("$")):
        if k % 2 == 0:
            found += [Span(part, 0, italic=False)] if part else []
            continue
        for sign, braced, single, plain in _PIECES.findall(part):
            words = braced or single or plain
            slanted = bool(_LETTERS.search(words)) and not sign
            found.append(Span(words, {"_": -1, "^": 1}.get(sign, 0), slanted))
    return tuple(found)


@functools.lru_cache(maxsize=8192)
def text_width(text: str, size: float, *, math: bool = False, bold: bool = True) -> float:
    """Return the width of one line [mm], in DejaVu Sans.

    Args:
        text: The line.
        size: Of the font [pt].
        math: True: symbols stand between dollar signs.
        bold: The wider face: what fits in bold fits in both.
    """
    table = _widths("bold" if bold else "regular")
    total = 0.0
    for span in spans(text, math=math):
        total += sum(table.get(ord(letter), _USUAL) for letter in span.text) * (SMALL if span.shift else 1.0)
    return total / _EM * size * POINT
