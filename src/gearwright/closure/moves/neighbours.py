"""One change of a settled design: proportioned once, and what it then lacks of what is asked."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from typing import NamedTuple

from gearwright.checks import Check, Status
from gearwright.closure.confirm import changes_of
from gearwright.closure.loop import Settled, settled
from gearwright.closure.proportion import proportioned, searched, sizes_of, teeth_of
from gearwright.closure.requirements import requirement_of, wanted
from gearwright.dynamics.vibration import resonance_checks
from gearwright.errors import GearwrightError
from gearwright.identity import Role
from gearwright.sizing import size
from gearwright.sizing.making import built_checks
from gearwright.sizing.rating import STANDARD_MODULES
from gearwright.spec import edited
from gearwright.spec.design import Planetary
from gearwright.spec.edit import Value

MOVED = ("critical speeds", "room", "teeth")
"""Requirements that other teeth and modules move."""
TEETH = (-6, -4, -3, -2, -1, 1, 2, 3, 4, 6)
"""By how many teeth the sun or the pinion of a stage is changed [-]."""
TEETH_OF_SETS = ("sun_teeth", "planet_teeth", "ring_teeth")
"""Keys of the teeth of a planetary set."""
TEETH_OF_PAIRS = ("pinion_teeth", "wheel_teeth")
"""Keys of the teeth of a pair."""
ROUNDING = 1e-9
"""Of modules [-]."""
_MM = 1e-3
DRIVING = (Role.SUN, Role.PINION)
"""Gears whose teeth are varied; a pair has none of its own where its pinion is a gear of another stage."""


class Change(NamedTuple):
    """A change of one stage."""

    table: str
    """Of the stage in the design file, where its teeth follow anew; empty: all teeth stay."""
    values: Mapping[str, Value]
    """Path -> value."""
    frees: tuple[str, ...] = ()
    """Paths that were chosen before and are free again: what else follows from the teeth."""


class Candidate(NamedTuple):
    """A settled design beside what it lacks."""

    settled: Settled
    short: float
    """Sum of what all failing checks lack of their limits [-]."""
    near: float
    """The part of critical speeds and of room in it [-]."""

    @property
    def rank(self) -> tuple[float, float]:
        """What meets more comes first, then what is lighter."""
        return round(self.short, 6), self.settled.sizing.mass


def judged(state: Settled) -> Candidate:
    """Return a settled design with what its sizing, its making and its resonances lack.

    Args:
        state: From the loop.
    """
    own = state.sizing
    checks = wanted([*own.checks, *built_checks(own), *resonance_checks(own)], state.task.wishes.left_out)
    lacking = [check for check in checks if check.status is Status.FAILS and not check.waiver]
    near = (check for check in lacking if requirement_of(check) in MOVED)
    return Candidate(state, _sum(lacking), _sum(near))


def _sum(checks: Iterable[Check]) -> float:
    return sum(1.0 - (check.margin or 0.0) for check in checks)


def screened(state: Settled, changes: Iterable[Change]) -> Iterator[Settled]:
    """Yield every change that can be sized, proportioned once, with the dynamic factors of what it is a change of.

    Args:
        state: That is changed.
        changes: One after another, each of the same state.
    """
    for change in changes:
        try:
            yield _screened(state, change)
        except GearwrightError:
            continue


def _screened(state: Settled, change: Change) -> Settled:
    """Return a change of one stage, proportioned once; the teeth of the other stages stay."""
    design, sizing = state.task.design, state.sizing
    stays = {path: value for path, value in teeth_of(design, sizing) if not path.startswith(f"{change.table}.")}
    own = {path: value for path, value in state.task.chosen.items() if path not in change.frees}
    task = replace(state.task, chosen={**own, **stays, **change.values})
    stated = edited(task.changed, changes_of(task.design, state.factors))
    first = size(edited(stated, dict(sizes_of(stated, state.proportioned.sizes))))
    found = proportioned(stated, task.wishes, before=first, targets=task.targets)
    return replace(state, task=replace(task, start=first), proportioned=found)


def confirmed_anew(state: Settled) -> Candidate:
    """Return a screened change with the dynamic factors of its own.

    Args:
        state: As screened.
    """
    return judged(settled(state.task))


def other_teeth(state: Settled, steps: Iterable[int] = TEETH) -> Iterator[Change]:
    """Yield other numbers of teeth of suns and pinions, stage by stage, where the design leaves them open or free.

    Args:
        state: With the teeth of now.
        steps: By how many teeth [-].
    """
    design, sizing, steps = state.task.design, state.sizing, tuple(steps)
    for name in searched(design):
        stage, table = design.simple_stages[name], design.table(name)
        keys = TEETH_OF_SETS if isinstance(stage, Planetary) else TEETH_OF_PAIRS
        gear = next((gear for gear in sizing.gears if gear.stage == name and gear.role in DRIVING), None)
        given = {f"{table}.{key}": None for key in keys if getattr(stage, key) is not None}
        if (not given or "teeth" in state.task.wishes.free) and gear is not None:
            frees = tuple(f"{table}.{key}" for key in keys)
            yield from (Change(table, {**given, frees[0]: gear.teeth + step}, frees) for step in steps)


def open_modules(state: Settled) -> dict[str, float]:
    """Return stage -> module of those that are searched and give none [m].

    Args:
        state: As settled.
    """
    design = state.task.design
    modules = {gear.stage: gear.module for gear in state.sizing.gears}
    return {name: modules[name] for name in searched(design) if design.simple_stages[name].module is None}


def standard_modules(own: float, steps: Iterable[int]) -> tuple[float, ...]:
    """Return modules of ISO 54 so many steps from the largest that is not above one's own [mm].

    Args:
        own: Module [m].
        steps: Upwards [-].
    """
    place = sum(value * _MM <= own * (1.0 + ROUNDING) for value in STANDARD_MODULES) - 1
    return tuple(STANDARD_MODULES[place + step] for step in steps if 0 <= place + step < len(STANDARD_MODULES))


def words_of(chosen: Mapping[str, Value]) -> str:
    """Return what was chosen, for a round.

    Args:
        chosen: Path -> value.
    """
    return "; ".join(f"{path} = {value}" for path, value in chosen.items())
