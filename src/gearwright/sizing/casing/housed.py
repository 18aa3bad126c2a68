"""What a housing stands around: all but the ends of built shafts that leave it, with bosses and covers of bearings."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from gearwright.catalogue import housing_materials
from gearwright.identity import HOUSING, Kind
from gearwright.latest import of_latest
from gearwright.sizing.arranged import Body, Point, Station
from gearwright.sizing.casing.shell import Shell, shell_around
from gearwright.sizing.result import Sizing
from gearwright.sizing.sealing import NEAR, Leaving, leaving_of
from gearwright.sizing.shafts import Holder, holders_of

BOSS = 0.12
"""Wall of a bearing's boss over the bearing's outside diameter [-], an estimate."""


@of_latest
def housed(sizing: Sizing) -> tuple[Body, ...]:
    """Return the bodies around which a housing stands: all but the ends of built shafts that leave it.

    Bosses of bearings on built shafts are among them, and what holds bearings but where a shaft leaves: a cover there
    lies in the wall.

    Args:
        sizing: As sized.
    """
    ends = tuple(leaving_of(sizing))
    inside = [body for body in sizing.arrangement.bodies if not any(_is_in(sizing, body, end) for end in ends)]
    return (*inside, *_still(sizing, ends))


@of_latest
def shell_of(sizing: Sizing) -> Shell:
    """Return the shell of a housing around all that stands in it.

    Args:
        sizing: As sized.
    """
    return shell_around(housed(sizing))


def bosses_of(sizing: Sizing, holders: Sequence[Holder]) -> dict[str, float]:
    """Return bearing of a built shaft -> outside diameter of its boss [m].

    Args:
        sizing: As sized.
        holders: Of it.

    Source: a wall of 0.12 D, an estimate; as wide as its cover and the thinnest wall around it.
    """
    least = housing_materials()[sizing.design.housing.material].least_wall
    found = {bearing.name: (1.0 + 2.0 * BOSS) * bearing.outer_diameter for bearing in sizing.bearings}
    for holder in holders:
        if holder.kind == "cover":
            found[holder.beside] = max(found[holder.beside], holder.outer + 2.0 * least)
    return found


def cover_at(holders: Sequence[Holder], leaving: Leaving) -> Holder | None:
    """Return the cover through which the end of a shaft leaves; None where there is none.

    Args:
        holders: Of the sizing.
        leaving: The end.
    """
    covers = [holder for holder in holders if holder.kind == "cover" and holder.shaft == leaving.shaft]
    beyond = [cover for cover in covers if leaving.way * ((cover.start + cover.end) / 2.0 - leaving.face) > 0.0]
    return next(iter(beyond), None)


def _still(sizing: Sizing, ends: tuple[Leaving, ...]) -> Iterator[Body]:
    """Yield bosses, and what holds bearings within the housing, not where a shaft leaves."""
    holders = holders_of(sizing)
    yield from boss_bodies(sizing, holders).values()
    for holder in holders:
        beyond = (
            end.way * (holder.start + holder.end - 2.0 * end.face) > 0.0 for end in ends if end.shaft == holder.shaft
        )
        if not any(beyond):
            yield _round(sizing, holder.shaft, (holder.start, holder.end), holder.outer)


def boss_bodies(sizing: Sizing, holders: Sequence[Holder]) -> dict[str, Body]:
    """Return bearing of a built shaft -> its boss.

    Args:
        sizing: As sized.
        holders: Of it.
    """
    bosses, found = bosses_of(sizing, holders), dict[str, Body]()
    for bearing in sizing.bearings:
        span = (bearing.position - bearing.width / 2.0, bearing.position + bearing.width / 2.0)
        found[bearing.name] = _round(sizing, bearing.shaft, span, bosses[bearing.name])
    return found


def cover_bodies(sizing: Sizing, holders: Sequence[Holder]) -> list[tuple[str, Body]]:
    """Return the plates and necks of covers, each with the bearing that its cover is beside.

    Args:
        sizing: As sized.
        holders: Of it.
    """
    return [
        (holder.beside, _round(sizing, holder.shaft, (ring.start, ring.end), ring.outer))
        for holder in holders if holder.kind == "cover" for ring in holder.rings
    ]  # fmt: skip


def _round(sizing: Sizing, shaft: str, span: tuple[float, float], diameter: float) -> Body:
    frame = sizing.arrangement.frames[shaft]
    origin = Point(*(np.asarray(frame.origin) + span[0] * np.asarray(frame.along)).tolist())
    circles = (Station(0.0, diameter / 2.0), Station(span[1] - span[0], diameter / 2.0))
    return Body(HOUSING, shaft, "", origin, frame.along, circles)


def _is_in(sizing: Sizing, body: Body, end: Leaving) -> bool:
    """Tell whether a body is a stretch of such an end."""
    if body.part.kind is not Kind.SHAFT or body.shaft != end.shaft:
        return False
    frame = sizing.arrangement.frames[end.shaft]
    place = float((np.asarray(body.origin) - np.asarray(frame.origin)) @ np.asarray(frame.along))
    return end.start - NEAR <= place and place + body.length <= end.end + NEAR
