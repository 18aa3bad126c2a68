"""Whether the splines of rings bear the torque that the housing holds."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.checks import Check
from gearwright.sizing import Sizing
from gearwright.sizing.casing import ring_seats

_CLAUSE = "p = 2 T/(d_m h l z k) on splines in the housing; 2 τ (Tresca)"
_HELP = "a wider ring leaves room for longer splines; a stronger material of the housing bears more"


def ring_seat_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield the pressure on the flanks of the splines of every ring that stands in a housing of the gearbox's own.

    Args:
        sizing: As sized.
    """
    for seat in ring_seats(sizing):
        yield Check(
            seat.ring.part, "ring seat pressure", _CLAUSE, seat.pressure, seat.permissible, "stress", at_most=True,
            symbol="p", place=f"W {seat.name}, T = {seat.torque:.4g} N m",
            why="" if seat.pressure <= seat.permissible else _HELP,
        )  # fmt: skip
