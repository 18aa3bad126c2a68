"""Threads of lock nuts in built shafts: from where to where they are cut, how they end, what they leave of the shaft.

Full turns begin where the nut does, beyond its washer, and go on outwards as far as the shaft is as thick, since the
nut comes from there. Inwards a thread ends beneath washer and inner ring: in an undercut DIN 76 - A where the design
asks for undercuts at its shoulders, else in turns that run out over 2.5 P.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from gearwright.catalogue import LockNut, ThreadUndercut, thread_run_out, thread_undercut
from gearwright.sizing.result import Sizing
from gearwright.sizing.shafts.holding.held import holders_of
from gearwright.sizing.shafts.holding.retention import ends


class Thread(NamedTuple):
    """A thread on a shaft."""

    shaft: str
    beside: str
    """Part that its nut holds."""
    way: int
    """Towards which end the nut is screwed off."""
    nut: LockNut
    foot: float
    """Where undercut or run-out begin, from the shaft's first end [m]."""
    first: float
    """Where its full turns begin [m]."""
    last: float
    """Where it starts, with a chamfer [m]."""
    undercut: ThreadUndercut | None
    """None where its turns run out."""

    @property
    def turns(self) -> tuple[float, float]:
        """Lower and upper end of its full turns [m]."""
        return min(self.first, self.last), max(self.first, self.last)

    @property
    def fading(self) -> tuple[float, float]:
        """Lower and upper end of its undercut, or of the turns that run out [m]."""
        return min(self.foot, self.first), max(self.foot, self.first)

    @property
    def bottom(self) -> float:
        """Diameter of its undercut, where it has one, else of its core [m]."""
        return self.nut.core if self.undercut is None else self.nut.thread - self.undercut.below


def threads(sizing: Sizing) -> Iterator[Thread]:
    """Yield the threads of every built shaft.

    Args:
        sizing: As sized.
    """
    kinds = {(holder.shaft, holder.beside) for holder in holders_of(sizing) if holder.kind == "lock nut"}
    for end in ends(sizing) if kinds else ():
        nut = end.nut
        if (end.shaft, end.outermost) not in kinds or nut is None:
            continue
        first = end.place + end.way * nut.washer
        cut = thread_undercut(nut.pitch) if sizing.design.shafting.shoulders == "undercut" else None
        foot = first - end.way * (thread_run_out(nut.pitch) if cut is None else cut.width)
        yield Thread(end.shaft, end.outermost, end.way, nut, foot, first, end.level, cut)
