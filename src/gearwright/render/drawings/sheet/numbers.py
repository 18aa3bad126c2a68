"""Item numbers around a view: each on the nearest side from which its leader crosses no text."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from collections.abc import Set as AbstractSet

from gearwright.render.drawings.sheet.crossing import clear_of
from gearwright.render.drawings.sheet.entities import Box, Entity, Words
from gearwright.render.drawings.sheet.symbols import balloon
from gearwright.render.style.labels import spread

AROUND = 9.0
"""From the parts to their item numbers [mm]."""
APART = 10.0
"""Between item numbers [mm]."""
SIDES = ("left", "right", "top", "bottom")
"""On which item numbers stand."""


def balloons(anchors: Sequence[complex], box: Box, words: Sequence[Words], first: int = 1) -> Iterator[Entity]:
    """Yield item numbers around the parts, each on the nearest side from which its leader crosses no text.

    Args:
        anchors: Where the numbers point, in their order [mm].
        box: Of the parts [mm].
        words: That leaders must not cross.
        first: Number of the first one.
    """
    barred = [set[str]() for _ in anchors]
    for _ in range(len(SIDES)):
        middles = _around(anchors, box, barred)
        through = [not clear_of(words, [(middle, anchor)])
                   for (_, middle), anchor in zip(middles, anchors, strict=True)]  # fmt: skip
        retried = False
        for (side, _), shut, crosses in zip(middles, barred, through, strict=True):
            if crosses and len(shut) < len(SIDES) - 1:
                shut.add(side)
                retried = True
        if not retried:
            break
    for k, ((_, middle), anchor) in enumerate(zip(middles, anchors, strict=True), start=first):
        yield from balloon(anchor, middle, f"{k}")


def _around(anchors: Sequence[complex], box: Box, barred: Sequence[AbstractSet[str]]) -> list[tuple[str, complex]]:
    """Return side and place of every item number, on the nearest side that is not barred for it [mm]."""
    sides: dict[str, list[tuple[float, int]]] = {side: [] for side in SIDES}
    for k, anchor in enumerate(anchors):
        x, y = anchor.real, anchor.imag
        far = {"left": x - box[0], "right": box[2] - x, "bottom": y - box[1], "top": box[3] - y}
        side = min((side for side in far if side not in barred[k]), key=far.__getitem__)
        sides[side].append((y if side in ("left", "right") else x, k))
    found: dict[int, tuple[str, complex]] = {}
    for side, listed in sides.items():
        ordered = sorted(listed)
        for place, (_, k) in zip(spread([along for along, _ in ordered], APART), ordered, strict=True):
            middle = {
                "left": complex(box[0] - AROUND, place), "right": complex(box[2] + AROUND, place),
                "bottom": complex(place, box[1] - AROUND), "top": complex(place, box[3] + AROUND),
            }[side]  # fmt: skip
            found[k] = (side, middle)
    return [found[k] for k in range(len(anchors))]
