"""A diagram of a design file's keys: what each length and angle is measured from."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

from gearwright.render.drawings.sheet.dimensions import drawn, extent
from gearwright.render.drawings.sheet.entities import Entity, Words, moved
from gearwright.render.drawings.sheet.sheets import Sheet, Size
from gearwright.render.drawings.sheet.svg import sheet_svg

MARGIN = 5.0
"""Around what is drawn [mm]."""
_KEY = re.compile(r"\b[a-z]+(?:_[a-z]+)*_(?:mm|deg)\b")


@dataclass(frozen=True)
class Diagram:
    """A sketch whose dimensions say keys."""

    name: str
    title: str
    tables: tuple[str, ...]
    """Tables of the file whose keys it shows, such as ``pairs.NAME``; it stands at the first."""
    draw: Callable[[], list[Entity]]

    @cached_property
    def keys(self) -> frozenset[str]:
        """The keys that it names, with the unit that is shown first."""
        words = (mark.text for mark in drawn(self.draw()) if isinstance(mark, Words))
        return frozenset(key for text in words for key in _KEY.findall(text))

    def svg(self) -> str:
        """Return it as an SVG image."""
        entities = self.draw()
        left, low, right, high = extent(entities)
        size = Size("", right - left + 2.0 * MARGIN, high - low + 2.0 * MARGIN, (0, 0))
        corner = complex(MARGIN - left, MARGIN - low)
        return sheet_svg(Sheet(self.name, self.title, size, 1.0, tuple(moved(entities, corner))))
