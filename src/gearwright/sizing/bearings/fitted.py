"""Which bearing sits in a seat, as the design names it or sizing took it."""

from __future__ import annotations

from typing import NamedTuple

from gearwright.catalogue import Bearing
from gearwright.sizing.bearings.seat import Seat
from gearwright.sizing.result import Sizing


class Fitted(NamedTuple):
    """A bearing in a seat."""

    bearing: Bearing
    side_by_side: int


def fitted_in(sizing: Sizing, seat: Seat) -> Fitted | None:
    """Return the bearing that sizing took for a seat of the design, or for a planet; None for a film, or nothing.

    Args:
        sizing: As sized.
        seat: One of its seats.
    """
    if seat.given is not None:
        return Fitted(next(sized.bearing for sized in sizing.bearings if sized.name == seat.name), 1)
    rolls = None if seat.runs_on is None else seat.runs_on.bearing
    return None if rolls is None else Fitted(rolls, seat.side_by_side)
