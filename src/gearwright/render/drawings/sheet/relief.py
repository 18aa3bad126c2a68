"""Texts of lengths that lines would run through, put elsewhere along their dimension lines."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Sequence
from dataclasses import replace

from gearwright.render.drawings.sheet.crossing import clear_of, segments, texts
from gearwright.render.drawings.sheet.dimensions import drawn, ends
from gearwright.render.drawings.sheet.entities import ARROW, GAP, TEXT, Distance, Entity, words_length

STEP, TRIES = 3.0, 12
"""Between places that are tried beyond either end [mm], and how many [-]."""


def relieved(view: Sequence[Entity]) -> list[Entity]:
    """Return a view whose lengths have their texts where no line runs through them, as far as there is such a place.

    Args:
        view: Its entities.
    """
    lines = list(segments(view))
    if all(clear_of(texts(drawn([mark])), lines) for mark in view if isinstance(mark, Distance)):
        return list(view)
    found: list[Entity] = []
    for k, mark in enumerate(view):
        crossed = isinstance(mark, Distance) and mark.text_at is None and not clear_of(texts(drawn([mark])), lines)
        found.append(_moved(mark, [*found, *view[k + 1 :]]) if crossed and isinstance(mark, Distance) else mark)
    return found


def _moved(mark: Distance, rest: Sequence[Entity]) -> Distance:
    return next((tried for tried in _elsewhere(mark) if _is_clear(tried, rest)), mark)


def _is_clear(mark: Distance, rest: Sequence[Entity]) -> bool:
    """Tell whether no line runs through the text of a length, and its line through no other text."""
    own = list(segments([mark]))
    return clear_of(texts(drawn([mark])), [*segments(rest), *own]) and clear_of(texts(drawn(rest)), own)


def _elsewhere(mark: Distance) -> Iterator[Distance]:
    """Yield a length with its text beyond either end, the nearest first."""
    along, half = cmath.rect(1.0, mark.angle), words_length(mark.text, TEXT) / 2.0 + ARROW + 2.0
    low, high = sorted(ends(mark), key=lambda end: ((end - mark.line) * along.conjugate()).real)
    for k in range(TRIES):
        for end, way in ((high, 1.0), (low, -1.0)):
            yield replace(mark, text_at=end + way * along * (half + STEP * k) + along * 1j * GAP)
