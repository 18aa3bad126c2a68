"""Whether a spanner reaches the screw of an end plate, or the nut that an end needs: a free cylinder outwards.

Their outsides and the spanner's are estimates over the diameters of screw and seat.
"""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.checks import Check
from gearwright.identity import Kind, PartId
from gearwright.sizing import Sizing
from gearwright.sizing.arranged import Body, Point, Station
from gearwright.sizing.making.order import ENDS
from gearwright.sizing.places import room_between
from gearwright.sizing.shafts import Retention, retentions

HEAD = 1.5
"""Outside of a nut that is not sized, or of a screw's head, over its thread, an estimate [-]."""
SPANNER = 5e-3
"""Wall of a socket spanner around a nut, an estimate [m]."""
_HELP = "another order of parts, or a nut at the other end, would help"


def spanner_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield whether a socket spanner comes to every end of a built shaft that no retaining ring holds.

    Args:
        sizing: As sized.
    """
    for held in retentions(sizing):
        if held.has_ring:
            continue
        what, head = _turned(held)
        others = [body for body in sizing.arrangement.bodies if body.shaft != held.shaft]
        axis, needed = _axis(sizing, held), head / 2.0 + SPANNER
        free = [(room_between(axis, body, enough=2.0 * needed).gap, body.name) for body in others]
        if free:
            gap, name = min(free, key=lambda pair: round(pair[0], 9))
            yield Check(
                PartId(Kind.SHAFT, held.shaft), f"access to a {what} at its {ENDS[held.way]} end", "socket spanner",
                max(gap, 0.0), needed, "length", exponent=None, place=f"at {held.outermost}, past {name}",
                why="" if gap >= needed else _HELP,
            )  # fmt: skip


def _turned(held: Retention) -> tuple[str, float]:
    """Return what is turned at an end, and its outer diameter [m]."""
    if held.has_plate and held.hole is not None:
        return "screw", HEAD * held.hole.thread
    if held.has_nut and held.nut is not None:
        return "nut", held.nut.outer
    return "nut", HEAD * held.diameter


def _axis(sizing: Sizing, held: Retention) -> Body:
    """Return the axis along which a spanner comes, from the held part out beyond all bodies."""
    frame, bodies = sizing.arrangement.frames[held.shaft], sizing.arrangement.bodies
    far = 10.0 * max(max(map(abs, body.origin)) + body.length + body.radius for body in bodies)
    start = held.place if held.way > 0 else held.place - far
    origin = Point(*(at + start * along for at, along in zip(frame.origin, frame.along, strict=True)))
    ends = (Station(0.0, 0.0), Station(far, 0.0))
    return Body(PartId(Kind.SHAFT, held.shaft), held.shaft, "", origin, frame.along, ends)
