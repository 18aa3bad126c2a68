"""Ends of built shafts that leave the housing towards their machines: what lies beyond the outermost bearing."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from gearwright.identity import Kind
from gearwright.sizing.arranged import Body
from gearwright.sizing.mounted import BuiltShaft
from gearwright.sizing.result import Sizing

_NEAR = 1e-6
"""Places that are nearer to each other are one [m]."""


class Leaving(NamedTuple):
    """An end of a shaft outside of the housing."""

    shaft: str
    start: float
    """Along the shaft from its first end: the outermost bearing's outer face, or that end [m]."""
    end: float
    """[m]"""
    radius: float
    """Largest of it [m]."""


def leaving_of(sizing: Sizing) -> Iterator[Leaving]:
    """Yield the ends of built shafts on which machines sit beyond all bearings.

    Args:
        sizing: As sized.
    """
    for shaft in sizing.built_shafts:
        own = [bearing for bearing in sizing.bearings if bearing.shaft == shaft.name]
        places = [sizing.arrangement.plans[shaft.name].places[machine]
                  for machine, node in sizing.train.machines.items() if node == shaft.name]  # fmt: skip
        if own and places:
            span = (min(one.position - one.width / 2.0 for one in own),
                    max(one.position + one.width / 2.0 for one in own))  # fmt: skip
            yield from _ends(shaft, span, places)


def _ends(shaft: BuiltShaft, span: tuple[float, float], places: list[float]) -> Iterator[Leaving]:
    first, last = shaft.steps[0].start, shaft.steps[-1].end
    sides = ((first, span[0], min(places) < span[0]), (span[1], last, max(places) > span[1]))
    for start, end, is_left in sides:
        radii = [step.diameter / 2.0 for step in shaft.steps if step.start < end - _NEAR and step.end > start + _NEAR]
        if is_left and end > start + _NEAR:
            yield Leaving(shaft.name, start, end, max(radii))


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
    return end.start - _NEAR <= place and place + body.length <= end.end + _NEAR
