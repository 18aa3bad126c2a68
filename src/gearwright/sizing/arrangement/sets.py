"""How long a planetary set is, and where in it the planes of its gears lie."""

from __future__ import annotations

from collections.abc import Mapping

from gearwright.identity import Role
from gearwright.parts.planetary import planes
from gearwright.sizing.rating import Context
from gearwright.sizing.result import GearSizing

PLATE_GAP = 0.005
"""Between planets and the plate of their carrier, an assumption [m]."""


def set_length(context: Context, gears: Mapping[str, GearSizing], stage: str) -> float:
    """Return how long the gears of a set are, plane by plane [m].

    Args:
        context: What sizing reads.
        gears: By name.
        stage: Name of the set.
    """
    return sum(_widths(context, gears, stage).values())


def slots(context: Context, gears: Mapping[str, GearSizing], stage: str, *, turned: bool) -> dict[str, float]:
    """Return gear -> where the middle of its width lies, from the set's middle on [m].

    Args:
        context: What sizing reads.
        gears: By name.
        stage: Name of the set.
        turned: True where its planes lie the other way round.
    """
    lies = _planes(context, stage)
    if stage in context.design.planetaries:  # one plane, in the middle
        return dict.fromkeys(lies, 0.0)
    widths = _widths(context, gears, stage)
    sense = -1.0 if turned else 1.0
    reached, middles = -sum(widths.values()) / 2.0, {}
    for key, width in widths.items():
        middles[key] = (reached, reached + width)
        reached += width
    found = {}
    for name, keys in lies.items():
        ends = [end for key in keys for end in middles[key]]
        found[name] = sense * (min(ends) + max(ends)) / 2.0
    return found


def _planes(context: Context, stage: str) -> dict[str, tuple[tuple[str, int], ...]]:
    """Return gear -> the planes that it lies in, in order."""
    gears = [gear for gear in context.train.gears if gear.stage == stage]
    if stage in context.design.planetaries:
        return {gear.name: (("", 0),) for gear in gears}
    lies = planes(context.design.epicyclics[stage].compound)
    return {gear.name: tuple(sorted(lies[gear.own])) for gear in gears}


def _widths(context: Context, gears: Mapping[str, GearSizing], stage: str) -> dict[tuple[str, int], float]:
    """Return plane -> its width, that of the widest gear which lies in it alone, in order along the axis [m]."""
    widths: dict[tuple[str, int], float] = {}
    for name, keys in sorted(_planes(context, stage).items(), key=lambda item: len(item[1])):
        for key in keys:
            share = gears[name].face_width / len(keys)
            widths[key] = max(widths.get(key, 0.0), share if gears[name].role is Role.PLANET or len(keys) == 1 else 0.0)
    return {key: widths[key] for key in sorted(widths)}
