"""What stands against a requirement that is not met, or against thinner rims and webs where they are free."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

from gearwright.closure.close import close
from gearwright.closure.closed import Closed, Outcome
from gearwright.closure.moves import BODIES, Thickness, thicknesses
from gearwright.closure.requirements import requirement_of, wanted
from gearwright.closure.wishes import Wishes
from gearwright.errors import GearwrightError
from gearwright.showing import Shown
from gearwright.sizing import size
from gearwright.spec import Design, edited
from gearwright.spec.design import given_values
from gearwright.units import Mass
from gearwright.verbs import verb

ROUNDING = 1e-9
"""Of a thickness [-]."""
MOVED = ("flank", "root", "scuffing", "static strength", "teeth", "sharing", "peaks", "critical speeds", "bearings")
"""Requirements that ask for other sizes, so that leaving one out leaves room for others."""


@dataclass(frozen=True, repr=False)
class Contradiction(Shown):
    """Things that are asked of a gearbox and that no freedom of the closure meets together."""

    against: str
    """A requirement, or what the design gives, as it is written there; without it the others are met. Of a closed
    design the next thinner rim or web."""
    unmet: tuple[str, ...]
    """Names of the checks that fail beside it, or the limit that a rim or web would leave."""
    requirements: tuple[str, ...]
    """That they belong to."""
    mass: Mass
    """Of gears, shafts and carriers without the other [kg]."""


@verb
def contradictions(
    design: Design, closed: Closed, *, tell: Callable[[str], None] | None = None
) -> tuple[Contradiction, ...]:
    """Return what stands against the requirements that a closure does not meet.

    Every other requirement is left out once, and every value that the design gives in the stages concerned, one at a
    time; what is then met contradicts what was left out. Of a closed design whose rims or webs were free every one is
    made thinner until something fails, all other sizes as they are.

    Args:
        design: As it was closed.
        closed: What came of it.
        tell: Called with what is being tried.

    Raises:
        DesignError: If the design is none.
    """
    if closed.outcome is Outcome.CLOSED:
        return tuple(_thinner(closed))
    found = list[Contradiction]()
    for name, own, wishes in _relaxed(design, closed):
        if tell is not None:
            tell(f"closing without {name}")
        try:
            again = close(own, wishes=replace(wishes, lighten=False))
        except GearwrightError:
            continue
        still = {row.check.name for row in again.unmet}
        met = [row for row in closed.unmet if row.check.name not in still and row.requirement != name]
        if met:
            names = tuple(dict.fromkeys(row.check.name for row in met))
            found.append(Contradiction(name, names, tuple(dict.fromkeys(row.requirement for row in met)), again.mass))
    return tuple(found)


def _thinner(closed: Closed) -> Iterator[Contradiction]:
    """Yield every rim and web that was free, thinner, with what speaks against it."""
    for freedom in (name for name in closed.wishes.free if name in BODIES):
        yield from (_against(closed, own) for own in thicknesses(closed.design, closed.sizing, freedom))


def _against(closed: Closed, own: Thickness) -> Contradiction:
    """Return the first thinner rim or web that fails a check, else the limit of what is known of it."""
    step = min(abs(step) for step in own.body.steps)
    value = own.now - step
    while value >= own.least - ROUNDING:
        sizing = size(edited(closed.design, own.at(value)))
        if failing := [check for check in wanted(sizing.checks, closed.wishes.left_out) if check.fails]:
            names = tuple(dict.fromkeys(check.name for check in failing))
            kinds = tuple(dict.fromkeys(map(requirement_of, failing)))
            return Contradiction(f"{own.path} = {value:.4g}", names, kinds, sizing.mass)
        value -= step
    return Contradiction(f"{own.path} < {own.least:.4g}", (own.body.limit,), (), closed.mass)


def _relaxed(design: Design, closed: Closed) -> Iterator[tuple[str, Design, Wishes]]:
    """Yield name, design and wishes of every closure with one thing less to meet."""
    asked, unmet = closed.wishes, {row.requirement for row in closed.unmet}
    alone = unmet.pop() if len(unmet) == 1 else ""
    parts = {row.check.part.name for row in closed.unmet}
    for path, given in given_values(design).values.items():
        if path.partition(".")[0] in parts and given.entry not in design.overrides:
            yield f"{given.entry} = {given.amount:g}", edited(design, {given.entry: None}), asked
    for name in MOVED:
        if name != alone and name not in asked.left_out:
            yield name, design, replace(asked, left_out=asked.left_out | {name})
