"""Requirements that no design variable meets, the conflicts behind them, and design alternatives."""

import math
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import NamedTuple

from gearwright.base import RPM, GearwrightError, Mass, Shown, margin_text, verb
from gearwright.closure.close import close
from gearwright.closure.moves import BODIES, OF_PLANETS, Thickness, thicknesses
from gearwright.closure.requirements import STRENGTH, Closed, Outcome, Wishes, requirement_of, wanted
from gearwright.sizing import size
from gearwright.spec import GROUND, Design, edited
from gearwright.spec.design import given_values
from gearwright.spec.edit import Value

# ----------------------------------------------------------------------------------------------------------------------
# What stands against a requirement that is not met, or against thinner rims and webs where they are free.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Variants of a design that cannot meet everything: what it gives is changed, the least first, until one closes.
# ----------------------------------------------------------------------------------------------------------------------


SHAKEN = frozenset({"peaks", "critical speeds"})
"""Requirements that a variant need not meet at first, since they take the time."""
_DEGREE_STEPS = (5.0, -5.0)
"""By which helix angles are changed [°]."""
SPEEDS = (1.05, 0.95, 1.1, 0.9)
"""Factors on the speed of a motor against resonance [-]."""
SLOWER = (0.9, 0.75, 0.6)
"""Factors on the speed of a motor beside planets that do not live, whose carrier it may turn with [-]."""
BEST_GRADE = "ME"
"""Of ISO 6336-5."""
_GIVEN_TEETH = ("pinion_teeth", "wheel_teeth", "sun_teeth", "planet_teeth", "ring_teeth")


class Change(NamedTuple):
    """What a variant gives otherwise than its design."""

    what: str
    """In words."""
    values: Mapping[str, Value]
    """Path -> value."""


@dataclass(frozen=True)
class Variant:
    """A design of which something given was changed, closed."""

    what: str
    """What was changed, in words."""
    changes: Mapping[str, Value]
    """Path -> value; None: left out."""
    design: Design
    """With it, before it is closed."""
    closed: Closed


@dataclass(frozen=True)
class Tried:
    """A change that did not lead to a gearbox that meets everything."""

    what: str
    why: str
    """What it does not meet, with its margin, or why it cannot be sized."""


@dataclass(frozen=True, repr=False)
class Variants(Shown):
    """The nearest variant of a design that meets everything, and what was tried before."""

    nearest: Variant | None
    """None where none of them does, or where the design itself does."""
    tried: tuple[Tried, ...]


@verb
def nearest_variant(design: Design, closed: Closed, *, tell: Callable[[str], None] | None = None) -> Variants:
    """Return the first of the changed designs that meets everything, from the smallest change to the largest.

    Given teeth are left to the search, the helix angle, motor speeds and numbers of planets change by a step, the steel
    is of the best grade, and at last a set whose planets do not live becomes a star: its carrier stands still.

    Args:
        design: As it was closed.
        closed: What came of it.
        tell: Called with what is being done.

    Raises:
        DesignError: If the design is none.
    """
    tried = list[Tried]()
    for change in _changes(design, closed) if closed.outcome is Outcome.OPEN else ():
        if tell is not None:
            tell(f"trying {change.what}")
        try:
            own = edited(design, change.values)
            found = _closed(own, closed, change, tell)
        except GearwrightError as error:
            tried.append(Tried(change.what, " ".join(str(error).split())))
            continue
        if found.outcome is Outcome.CLOSED:
            return Variants(Variant(change.what, dict(change.values), own, found), tuple(tried))
        tried.append(
            Tried(
                change.what,
                "; ".join(f"{row.check.name} {margin_text(row.check.margin or 0.0, 4)}" for row in found.unmet),
            )
        )
    return Variants(None, tuple(tried))


def _closed(own: Design, before: Closed, change: Change, tell: Callable[[str], None] | None) -> Closed:
    """Return a variant closed; where strengths and bearings alone are not met already, without what shakes them."""
    asked = before.wishes
    first = close(own, wishes=replace(asked, separate=False, lighten=False, left_out=asked.left_out | SHAKEN))
    if first.unmet:
        return first
    return close(own, wishes=asked, tell=None if tell is None else lambda words: tell(f"{change.what}: {words}"))


def _changes(design: Design, closed: Closed) -> Iterator[Change]:
    """Yield what may help with what is not met, each as small as can be, the smallest first."""
    unmet = {row.requirement for row in closed.unmet}
    stages = sorted({row.check.part.name for row in closed.unmet} & design.simple_stages.keys())
    if "critical speeds" in unmet and not unmet & {*OF_PLANETS, *STRENGTH}:
        yield from _freed(design, _shaken(design, closed))
        yield from _angles(design)
        yield from _speeds(design, SPEEDS)
    if unmet & set(STRENGTH):
        yield from _graded(design)
        yield from _freed(design, stages)
    if unmet & {*OF_PLANETS, *STRENGTH}:
        yield from _counted(design, [stage for stage in stages if stage in design.planetaries])
    if unmet & set(OF_PLANETS):
        sets = _bearing_sets(design, closed)
        yield from _speeds(design, SLOWER, on={design.planetaries[name].carrier for name in sets})
        yield from _stars(design, sets)


def _shaken(design: Design, closed: Closed) -> list[str]:
    """Return the stages whose meshes shake too near an operating speed, then all others."""
    words = " ".join(row.check.mode for row in closed.unmet if row.requirement == "critical speeds")
    return sorted(design.simple_stages, key=lambda name: name not in words)


def _freed(design: Design, stages: Iterable[str]) -> Iterator[Change]:
    """Yield stages whose given teeth are left to the search."""
    for name in stages:
        stage = design.simple_stages[name]
        given = [key for key in _GIVEN_TEETH if getattr(stage, key, None) is not None]
        if given:
            yield Change(f"teeth of {name} free", {f"{design.table(name)}.{key}": None for key in given})


def _angles(design: Design) -> Iterator[Change]:
    """Yield another helix angle, where gears are helical."""
    angle = math.degrees(design.gears.helix_angle)
    for step in _DEGREE_STEPS if angle > 0.0 else ():
        yield Change(f"helix angle {angle + step:g} °", {"gears.helix_angle_deg": round(angle + step, 9)})


def _speeds(design: Design, factors: Iterable[float], *, on: Collection[str] | None = None) -> Iterator[Change]:
    """Yield motors at other speeds, all or those on some shafts."""
    for name, motor in design.motors.items():
        for factor in factors if motor.speed and (on is None or motor.shaft in on) else ():
            rpm = float(f"{factor * motor.speed / RPM:.6g}")
            yield Change(f"{name} at {rpm:g} rpm", {f"motors.{name}.speed_rpm": rpm})


def _graded(design: Design) -> Iterator[Change]:
    """Yield the best grade of the same class of steel."""
    if design.gears.iso6336.grade != BEST_GRADE:
        yield Change(f"steel of grade {BEST_GRADE}", {"gears.iso6336.grade": BEST_GRADE})


def _counted(design: Design, stages: Iterable[str]) -> Iterator[Change]:
    """Yield sets with a planet more or fewer."""
    for name in stages:
        count = design.planetaries[name].planets_given
        for other in (count + 1, count - 1) if count else ():
            yield Change(f"{other} planets in {name}", {f"planetaries.{name}.planets": other})


def _bearing_sets(design: Design, closed: Closed) -> list[str]:
    """Return the sets whose planets have no bearing that lives."""
    lacking = {row.check.part.name for row in closed.unmet if row.requirement in OF_PLANETS}
    return [name for name in design.planetaries if name in lacking]


def _stars(design: Design, stages: list[str]) -> Iterator[Change]:
    """Yield a star in place of the planetary set, one set after another and then all of them."""
    rows = {name: _star(design, name) for name in stages}
    able = {name: row for name, row in rows.items() if row}
    for name, row in able.items():
        yield Change(f"{name} as a star", row)
    if len(able) > 1:
        values = {key: value for row in able.values() for key, value in row.items()}
        yield Change(f"{' and '.join(able)} as stars", values)


def _star(design: Design, name: str) -> dict[str, Value]:
    """Return what makes a set a star: what its carrier turned its ring turns; empty where its ring does not stand."""
    stage = design.planetaries[name]
    if stage.ring != GROUND or stage.carrier == GROUND:
        return {}
    swapped = {"ring": stage.carrier, "carrier": GROUND}
    return {f"planetaries.{name}.{member}": shaft for member, shaft in swapped.items()}
