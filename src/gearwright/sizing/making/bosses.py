"""Whether walls of the housing carry the bosses of all bearings, and whether bosses and covers stand clear."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from gearwright.checks import Check
from gearwright.identity import GEARBOX, Kind
from gearwright.sizing import Sizing
from gearwright.sizing.casing import ball_around, boss_bodies, cover_bodies
from gearwright.sizing.making.running import OFF, bending, moved
from gearwright.sizing.mass import carried_in_walls
from gearwright.sizing.places import room_between
from gearwright.sizing.shafts import holders_of

NEAR = 0.01
"""Room that is enough not to be looked at further [m]."""
_ROOM = "bending of shafts, and 0.5 mm"
_APART = "move bearings or gears along their shafts ([bearings], [layout.SHAFT.places])"
_CLAUSE = "webs built in at both ends; 2 τ (Tresca)"
_HELP = "move bearings nearer to a wall, or away from what turns around them ([bearings], [layout.SHAFT.places])"


def boss_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield the least room between bosses and covers and what turns, or other covers, about other axes.

    Args:
        sizing: As sized.
    """
    if not sizing.bearings or not sizing.design.housing.own:
        return
    least = min(_beside(sizing), key=lambda pair: (round(pair[0] - pair[1], 9), pair[2]), default=None)
    if least is not None:
        gap, needed, names = least
        why = "" if gap >= needed else f"{1e3 * gap:.3g} mm between {names}: {_APART}"
        yield Check(
            GEARBOX, "running clearance of bosses", _ROOM, max(gap, 0.0), needed, "length", exponent=None,
            place=names, why=why,
        )  # fmt: skip


def _beside(sizing: Sizing) -> Iterator[tuple[float, float, str]]:
    """Yield the room between a boss or cover and a body about another axis, what is needed [m], and both names."""
    holders, bent = holders_of(sizing), bending(sizing)
    bosses, covers = boss_bodies(sizing, holders), cover_bodies(sizing, holders)
    balls = np.array([ball_around(body) for body in sizing.arrangement.bodies])
    named = [(f"the boss of {name}", body) for name, body in bosses.items()]
    named += [(f"the cover of {name}", body) for name, body in covers]
    for name, body in named:
        ball = ball_around(body)
        near = np.linalg.norm(balls[:, :3] - ball[:3], axis=1) < balls[:, 3] + ball[3] + NEAR
        for other in (sizing.arrangement.bodies[k] for k in np.flatnonzero(near).tolist()):
            if other.shaft != body.shaft and other.part.kind is not Kind.BEARING:
                gap = room_between(body, other, enough=NEAR).gap
                yield gap, OFF + moved(other, bent), f"{name} and {other.part}"
        for beside, other in covers:
            if other.shaft != body.shaft:
                yield room_between(body, other, enough=NEAR).gap, OFF, f"{name} and the cover of {beside}"


def web_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield how many of the bosses of bearings walls, webs and collars of the housing carry.

    Args:
        sizing: As sized.
    """
    if not sizing.bearings or not sizing.design.housing.own:
        return
    bosses = carried_in_walls(sizing)
    bare = [name for carried in bosses if not carried.found for name in carried.bearings]
    count, why = len(sizing.bearings), f"no web or collar finds a way to {', '.join(bare)}: {_HELP}" if bare else ""
    yield Check(
        GEARBOX, "webs of bosses", _CLAUSE, float(count - len(bare)), float(count), "number", exponent=None, why=why
    )
