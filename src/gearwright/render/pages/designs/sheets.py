"""Technical drawings of a design as one self-contained HTML page: the sheets, to scale on paper."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from gearwright.render.pages.page import (
    UNSTAMPED,
    Figure,
    Number,
    Page,
    Section,
    Stamp,
    judged_by_sizing,
    quantity,
    set_page,
)
from gearwright.sizing import Sizing
from gearwright.sizing.arrangement import envelope
from gearwright.sizing.mass import complete_mass


class DrawnSheet(NamedTuple):
    """A sheet as it stands on the page."""

    name: str
    """Of its file."""
    title: str
    size: str
    """Such as ``A3``."""
    scale: str
    """Such as ``1:2``."""
    svg: str
    """With ids of its own."""


def sheets_page(sizing: Sizing, drawn: Sequence[DrawnSheet], *, stamp: Stamp = UNSTAMPED) -> str:
    """Return the page; it makes no request to anywhere, and the same input gives the same bytes.

    Args:
        sizing: As sized.
        drawn: Its sheets.
        stamp: Date of the page.
    """
    room = envelope(sizing)
    numbers = (
        Number("sheets", f"{len(drawn)}", "", float(len(drawn))),
        quantity("gears, shafts, carriers", complete_mass(sizing).train, "mass"),
        quantity("width", room.width, "length"),
        quantity("height", room.height, "length"),
        quantity("length", room.length, "length"),
    )
    sections = tuple(Section(sheet.title, figures=(_figure(sheet),)) for sheet in drawn)
    return set_page(
        Page("Drawings", sizing.design.name, sizing.design.description, judged_by_sizing(sizing), numbers, sections,
             design=sizing.design, stamp=stamp, footer="Sheets to ISO conventions, in mm; print each from its file.")
    )  # fmt: skip


def _figure(sheet: DrawnSheet) -> Figure:
    titled = sheet.svg.replace("<svg ", '<svg role="img" ', 1)
    return Figure(titled, f"{sheet.name}: {sheet.size}, {sheet.scale}.", sheet.name)
