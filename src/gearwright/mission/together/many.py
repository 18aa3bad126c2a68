"""Many flights of one gearbox together: missions that differ by numbers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields
from typing import Any

from gearwright.arrays import Floats
from gearwright.errors import DesignError
from gearwright.mission.collect import Flown, Log, collect
from gearwright.mission.flight import Flight
from gearwright.mission.gearbox import Point
from gearwright.mission.history import History
from gearwright.mission.together.deck import Deck, deck_of, is_free
from gearwright.mission.together.flight import Together, flown_together
from gearwright.mission.together.gearbox import box_of
from gearwright.mission.together.log import Reached, history_of, reached


def flights_together(all_flown: Sequence[Flown]) -> list[Flight | Reached | None]:
    """Return the flight of each, or how far it comes; None where it has to be flown alone.

    Args:
        all_flown: With the same gearbox, machines and propeller; their missions differ in numbers.
    """
    gearbox, blades, _, supply, _ = all_flown[0]
    box = box_of(gearbox)
    free = [k for k, flown in enumerate(all_flown) if is_free(flown.mission)]
    found: list[Flight | Reached | None] = [None] * len(all_flown)
    if box is None or not free:
        return found
    try:
        deck = deck_of([all_flown[k] for k in free])
    except DesignError:  # one that has no course is told why alone, and does not slow the others down
        if len(all_flown) == 1:
            return found
        half = len(all_flown) // 2
        return flights_together(all_flown[:half]) + flights_together(all_flown[half:])
    whole = flown_together(box, blades, supply, deck)
    if whole is None:
        return found
    history = history_of(deck, whole)
    for place, k in enumerate(free):
        lanes = deck.flights[place]
        fails = bool(whole.fails[lanes].any())
        found[k] = reached(deck, whole, place) if fails else collect(all_flown[k], _log(deck, whole, place, history))
    return found


def _log(deck: Deck, whole: Together, place: int, history: History[Floats]) -> Log:
    """Return the log of one flight."""
    lanes = deck.flights[place]
    columns: dict[str, Any] = {
        field.name: None if (values := getattr(history, field.name)) is None else values[lanes]
        for field in fields(History)
    }
    return Log(
        phase=deck.course.phase[lanes],
        history=History(**columns),
        point=Point(*(column[lanes] for column in whole.point)),
        powers={name: power[lanes] for name, power in whole.powers.items()},
        end=whole.battery.ends[place],
        warm=(),
    )
