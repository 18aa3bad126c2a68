"""Shafts that go through one another: the inner ones are sized first, the outer ones around them."""

from __future__ import annotations

from collections.abc import Sequence

from gearwright.sizing.arranged import Arrangement
from gearwright.sizing.carrying import ShaftSizing
from gearwright.sizing.rating import Context

THINNEST_WALL = 0.9
"""Bore over diameter of a shaft around another one that strength alone would make thinner, an assumption [-]."""


def inner_first(arrangement: Arrangement) -> Sequence[str]:
    """Return the shafts in the order of the design, but every one behind those that go through it.

    Args:
        arrangement: With what goes through what.
    """
    if not arrangement.within:
        return tuple(arrangement.plans)
    found = list[str]()
    while len(found) < len(arrangement.plans):
        waiting = {outer for inner, outer in arrangement.within if inner not in found}
        found += [name for name in arrangement.plans if name not in found and name not in waiting]
    return found


def least_bore(context: Context, arrangement: Arrangement, shafts: Sequence[ShaftSizing], outer: str) -> float:
    """Return the bore that a shaft needs around those that go through it; 0 where none does [m].

    Args:
        context: What sizing reads.
        arrangement: With what goes through what.
        shafts: Sized so far, the inner ones among them.
        outer: Name of the shaft.
    """
    inner = {first for first, second in arrangement.within if second == outer}
    if not inner:
        return 0.0
    thickest = max((shaft.diameter for shaft in shafts if shaft.name in inner), default=0.0)
    return thickest + 2.0 * context.design.shafting.radial_gap
