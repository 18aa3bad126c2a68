"""Intervals that are asked what the one before is asked: the first few of a run are computed and speak for the rest."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np

from gearwright.arrays import Bools, Ints
from gearwright.mission.together.deck import Deck


class Runs(NamedTuple):
    """Which intervals are computed."""

    kept: Ints
    """Their numbers, rising."""
    source: Ints
    """Of every interval, the place among the kept of the one that speaks for it."""


def runs_of(columns: Iterable[Any], starts: Bools, depth: int) -> Runs:
    """Return which intervals are computed: of a run of equal ones the first few.

    Args:
        columns: What intervals are asked; equal bits are equal.
        starts: Where a run starts in any case, shape (n,).
        depth: How many of a run: what one takes over from the one before has settled by then.
    """
    fresh = starts.copy()
    for column in columns:
        bits = column.view(f"u{column.itemsize}")
        fresh[1:] |= bits[1:] != bits[:-1]
    places = np.arange(len(fresh))
    kept = places - np.maximum.accumulate(np.where(fresh, places, 0)) < depth
    return Runs(np.flatnonzero(kept), np.cumsum(kept) - 1)


def shortened(deck: Deck, depth: int) -> tuple[Deck, Ints]:
    """Return a deck without what repeats, and which of its intervals speaks for each of the full one.

    Where intervals follow from those before them nothing repeats.

    Args:
        deck: What is asked.
        depth: As in `runs_of`.
    """
    course = deck.course
    if deck.follows:
        return deck, np.arange(len(deck.pitch))
    columns = (course.altitude, course.true_airspeed, course.power, course.propeller_speed, deck.pitch, deck.rating)
    spun = course.propeller_gain / course.duration
    runs = runs_of(
        (*columns, spun, *deck.parts.values(), *deck.driven.values()), course.starts_phase | deck.first, depth
    )
    return deck.at(runs.kept), runs.source


def spread(found: Any, source: Ints) -> Any:
    """Return what all intervals get from what those get that speak for them.

    Args:
        found: Arrays with a first axis of what is kept, in records and mappings; what is none stays.
        source: Of every interval, the place of the one that speaks for it.
    """
    if isinstance(found, np.ndarray):
        return found[source]
    if isinstance(found, dict):
        return {name: spread(value, source) for name, value in found.items()}
    if isinstance(found, tuple):
        values = [spread(value, source) for value in found]
        return type(found)(*values) if hasattr(found, "_fields") else tuple(values)
    return found
