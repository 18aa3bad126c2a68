"""Words of earlier versions, and what is written now: they are still read, each with a sentence that says so."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from types import MappingProxyType

FORMER: Mapping[str, str] = MappingProxyType({
    "least": "minimum", "most": "maximum", "least_charge": "minimum_charge",
    "fly.least_charge": "fly.minimum_charge", "mission.battery.least_charge": "mission.battery.minimum_charge",
})  # fmt: skip
"""Key, value or dotted path of an earlier version -> what is written now."""


class FormerWord(FutureWarning):
    """A file says something in a word of an earlier version."""


def today(word: str, place: str = "") -> str:
    """Return what is written now for a word, and say it where that is another one.

    Args:
        word: Key, value or dotted path.
        place: Where it stands, for the sentence.

    >>> today("minimum")
    'minimum'
    """
    now = FORMER.get(word, word)
    if now != word:
        at = f"{place}: " if place else ""
        warnings.warn(f"{at}{word!r} is a word of an earlier version; write {now!r}", FormerWord, stacklevel=2)
    return now
