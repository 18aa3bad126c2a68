"""Ends of built shafts that leave the housing towards their machines: what lies beyond the outermost bearing."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from gearwright.sizing.mounted import BuiltShaft
from gearwright.sizing.result import Sizing

NEAR = 1e-6
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
    way: int
    """−1 at the shaft's first end, +1 at its second."""
    diameter: float
    """Beside the outermost bearing [m]."""

    @property
    def face(self) -> float:
        """Outer face of the outermost bearing, from the shaft's first end [m]."""
        return self.start if self.way > 0 else self.end


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
    sides = ((-1, first, span[0], min(places) < span[0]), (1, span[1], last, max(places) > span[1]))
    for way, start, end, is_left in sides:
        inside = [step for step in shaft.steps if step.start < end - NEAR and step.end > start + NEAR]
        if is_left and end > start + NEAR:
            radius = max(step.diameter for step in inside) / 2.0
            yield Leaving(shaft.name, start, end, radius, way, inside[0 if way > 0 else -1].diameter)
