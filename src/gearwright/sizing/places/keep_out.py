"""Whether the gearbox stays out of the space that the design keeps free."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from gearwright.checks import Check
from gearwright.identity import GEARBOX
from gearwright.ranking import smallest
from gearwright.sizing.arranged import Body
from gearwright.sizing.places.coaxial import CLAUSE
from gearwright.sizing.places.solids import Room, Solid, box_of, solid_of, solid_room
from gearwright.spec import Design
from gearwright.spec.design import KeepOut


@dataclass(frozen=True)
class Entry:
    """The body that is nearest to a keep-out, or farthest inside it."""

    name: str
    """Of the keep-out."""
    reason: str
    body: Body
    room: Room


def entries(design: Design, bodies: Sequence[Body]) -> Iterator[Entry]:
    """Yield the nearest body of every keep-out.

    Args:
        design: With its keep-outs.
        bodies: At their places.
    """
    for name, keep in design.keep_out.items():
        space = _space(keep)
        rooms = [(body, solid_room(solid_of(body), space, enough=0.0)) for body in bodies]
        if rooms:
            body, room = smallest(rooms, lambda pair: pair[1].gap)
            yield Entry(name, keep.reason, body, room)


def keep_out_checks(design: Design, bodies: Sequence[Body]) -> Iterator[Check]:
    """Yield whether all bodies stay out of every keep-out.

    Args:
        design: With its keep-outs.
        bodies: At their places.
    """
    for entry in entries(design, bodies):
        gap = entry.room.gap
        into = f"{-1e3 * gap:.3g} mm into it, " if gap < 0.0 else ""
        yield Check(
            GEARBOX, f"keep-out {entry.name}", CLAUSE, max(entry.room.apart, 0.0), entry.room.needed,
            "length", exponent=None, place=entry.body.name, why=f"{into}{entry.reason}",
        )  # fmt: skip


def _space(keep: KeepOut) -> Solid:
    ends = [(spot.x, spot.y, spot.z) for spot in (keep.start, keep.end)]
    if keep.radius is None:
        return box_of(*ends)
    axis = np.array(ends[1]) - np.array(ends[0])
    return Solid(axis / np.linalg.norm(axis), np.array(ends), np.full(2, keep.radius), 0.0)
