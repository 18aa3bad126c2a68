"""Gears that several pairs share, and which stages therefore have one module."""

from __future__ import annotations

from gearwright.identity import SIDES, Role
from gearwright.spec.design.design import Design
from gearwright.spec.design.latest import of_the_latest


def gear_owner(design: Design, pair: str, side: Role) -> str:
    """Return the pair that owns the gear on one side of a pair: itself, or the one that it names.

    Args:
        design: With its pairs.
        pair: Name of the pair.
        side: Pinion or wheel.
    """
    owner, _ = design.pairs[pair].shared(side) or (pair, side)
    return owner if owner in design.pairs else pair


@of_the_latest
def module_owners(design: Design) -> dict[str, str]:
    """Return stage -> the stage whose module it has: of all that gears join, the first that shares no gear of another.

    Args:
        design: As typed.
    """
    shares = {name: {gear_owner(design, name, side) for side in SIDES} - {name} for name in design.pairs}
    group = {name: {name} for name in design.simple_stages}
    for name, owners in shares.items():
        joined = set[str]().union(group[name], *(group[owner] for owner in owners))
        group |= dict.fromkeys(joined, joined)
    order = list(design.simple_stages)
    return {
        name: min(joined, key=lambda stage: (bool(shares.get(stage)), order.index(stage)))
        for name, joined in group.items()
    }
