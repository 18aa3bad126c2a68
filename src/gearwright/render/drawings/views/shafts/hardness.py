"""Where a shaft is case-hardened: lines beside its outline with numbers (ISO 15787), and the table of what is asked."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from gearwright.render.drawings.sheet.entities import SMALL, Arc, Entity, Layer, Path, Words, trimmed
from gearwright.render.drawings.sheet.tables import Grid
from gearwright.render.drawings.views.shaft_parts import Piece, ShaftBody
from gearwright.render.drawings.views.shaft_view import Axis
from gearwright.render.drawings.views.tooth_data import CASE
from gearwright.shape.teeth import gear_of
from gearwright.sizing import Sizing
from gearwright.sizing.shafts import case_hardened

HARDEST = 800.0
"""Hardness of case-hardened flanks up to which ISO 6336-5 rates them [HV]."""
OUTSIDE = 2.0
"""Between the outline and the line of a hardened surface [mm of paper]."""
RING = 2.3
"""Radius of the circle around a number [mm of paper]."""
UNDER_LIP = (0.3, 0.6)
"""Depth of the case under the lip of a seal, at least (makers' sheets) and at most (assumed) [mm]."""
_MM = 1e3


class Zone(NamedTuple):
    """A surface of a shaft that is hardened."""

    piece: Piece
    what: str
    """Such as ``teeth of helical.pinion``."""
    hardness: float
    """At least [HV]."""
    depth: tuple[float, float]
    """At least and at most [mm]."""

    @property
    def words(self) -> str:
        """Hardness and depth of the case as drawings write them."""
        return case_words(self.hardness, self.depth)


def case_words(hardness: float, depth: tuple[float, float]) -> str:
    """Return hardness and depth of a case as drawings write them.

    Args:
        hardness: At least [HV].
        depth: At least and at most [mm].

    >>> case_words(700.0, (0.3, 0.4))
    '700 +100 HV, CHD 0.3 +0.1'
    """
    more, (low, high) = HARDEST - hardness, depth
    hard = f"{hardness:.0f} {more:+.0f} HV" if more > 0.0 else f"{hardness:.0f} HV"
    return f"{hard}, CHD {trimmed(low, 2)} +{trimmed(high - low, 2)}"


def zones(sizing: Sizing, body: ShaftBody) -> tuple[Zone, ...]:
    """Return the teeth of one piece with a shaft that are case-hardened, and with them what runs under lips of seals.

    Args:
        sizing: What was sized.
        body: The shaft.
    """
    found, steels = [], case_hardened(sizing, body.name)
    for piece in body.pieces:
        if piece.toothed and piece.seat in steels:
            gear = gear_of(sizing, piece.seat)
            low, high = (_MM * share * gear.module for share in CASE)
            found.append(Zone(piece, f"teeth of {gear.name}", steels[gear.name].hardness, (low, high)))
    if found:
        hardness = min(zone.hardness for zone in found)
        found += [Zone(piece, f"under the seal towards {piece.sealed}", hardness, UNDER_LIP)
                  for piece in body.pieces if piece.sealed]  # fmt: skip
    return tuple(found)


def zone_lines(axis: Axis, hard: tuple[Zone, ...]) -> Iterator[Entity]:
    """Yield the lines below the outline along which a shaft is hardened, with their numbers.

    Args:
        axis: Of the shaft.
        hard: From `zones`.
    """
    for number, zone in enumerate(hard, start=1):
        piece = zone.piece
        ends = [
            axis.at(x, -diameter / 2.0) for x, diameter in zip((piece.start, piece.end), piece.diameters, strict=True)
        ]
        along = (ends[1] - ends[0]) / abs(ends[1] - ends[0])
        yield from hard_line((ends[0], ends[1]), -1j * along, number)


def hard_line(ends: tuple[complex, complex], away: complex, number: int) -> Iterator[Entity]:
    """Yield the line beside a surface that is hardened, and its number in a circle (ISO 15787).

    Args:
        ends: Of the surface's outline [mm of paper].
        away: Unit vector out of the part [-].
        number: In the table of hardened surfaces.
    """
    yield Path((ends[0] + OUTSIDE * away, ends[1] + OUTSIDE * away), Layer.HARDENED)
    middle = (ends[0] + ends[1]) / 2.0 + (OUTSIDE + RING + 0.7) * away
    yield Arc(middle, RING, Layer.SYMBOL)
    yield Words(middle - 1j * SMALL / 2.0, f"{number}", SMALL, "middle", layer=Layer.SYMBOL)


def zone_grid(hard: tuple[Zone, ...]) -> Iterator[Grid]:
    """Yield the table of hardened surfaces; none where none is.

    Args:
        hard: From `zones`.
    """
    if hard:
        rows = [(f"{number}", zone.what, zone.words) for number, zone in enumerate(hard, start=1)]
        rows.append(("", "all else", "soft: kept from carburizing (assumed)"))
        yield Grid("Case-hardened and tempered (ISO 15787)", tuple(rows))
