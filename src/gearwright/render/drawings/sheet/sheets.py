"""A sheet of paper with what is on it, the sizes of ISO 5457 and the scales of ISO 5455."""

from __future__ import annotations

from dataclasses import dataclass

from gearwright.render.drawings.sheet.entities import Entity
from gearwright.showing import Shown

FILING = 20.0
"""Margin on the left [mm] (ISO 5457:1999)."""
MARGIN = 10.0
"""Margin on the other sides [mm] (ISO 5457:1999)."""
SCALES = (50.0, 20.0, 10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01)
"""Scales of ISO 5455:1979 [-]: mm of paper per mm."""


@dataclass(frozen=True)
class Size:
    """A trimmed sheet, lying."""

    name: str
    width: float
    """[mm]"""
    height: float
    """[mm]"""
    fields: tuple[int, int]
    """Number of reference fields along the width and the height."""


SIZES = (
    Size("A3", 420.0, 297.0, (8, 6)),
    Size("A2", 594.0, 420.0, (12, 8)),
    Size("A1", 841.0, 594.0, (16, 12)),
    Size("A0", 1189.0, 841.0, (24, 16)),
)
"""Lying sheets of ISO 5457:1999, the smallest first."""


@dataclass(frozen=True, repr=False)
class Sheet(Shown):
    """A drawing sheet."""

    name: str
    """Of its file."""
    title: str
    size: Size
    scale: float
    """[-]: mm of paper per mm."""
    entities: tuple[Entity, ...]
    """In mm of paper, from the lower left corner."""


def scale_text(scale: float) -> str:
    """Return a scale as ISO 5455 writes it.

    Args:
        scale: mm of paper per mm [-].

    >>> scale_text(0.5), scale_text(2.0)
    ('1:2', '2:1')
    """
    return f"{scale:g}:1" if scale >= 1.0 else f"1:{1.0 / scale:g}"
