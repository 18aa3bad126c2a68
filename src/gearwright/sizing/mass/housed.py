"""What a housing stands around: all but the ends of built shafts that leave it."""

from __future__ import annotations

import numpy as np

from gearwright.identity import Kind
from gearwright.sizing.arranged import Body
from gearwright.sizing.result import Sizing
from gearwright.sizing.sealing import NEAR, Leaving, leaving_of


def housed(sizing: Sizing) -> tuple[Body, ...]:
    """Return the bodies around which a housing stands: all but the ends of built shafts that leave it.

    Args:
        sizing: As sized.
    """
    ends = tuple(leaving_of(sizing))
    return tuple(body for body in sizing.arrangement.bodies if not any(_is_in(sizing, body, end) for end in ends))


def _is_in(sizing: Sizing, body: Body, end: Leaving) -> bool:
    """Tell whether a body is a stretch of such an end."""
    if body.part.kind is not Kind.SHAFT or body.shaft != end.shaft:
        return False
    frame = sizing.arrangement.frames[end.shaft]
    place = float((np.asarray(body.origin) - np.asarray(frame.origin)) @ np.asarray(frame.along))
    return end.start - NEAR <= place and place + body.length <= end.end + NEAR
