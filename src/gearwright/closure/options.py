"""One change of a settled design: proportioned once, what it then lacks of what is asked, and confirmed."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import cached_property
from hashlib import sha256
from typing import NamedTuple

from gearwright.base import Check, Status
from gearwright.closure.course import Seen, now, sized
from gearwright.closure.loop import Settled, changes_of, settled
from gearwright.closure.proportion import StageSize, proportioned, sizes_of, teeth_of
from gearwright.closure.requirements import requirement_of, wanted
from gearwright.dynamics.vibration import resonance_checks
from gearwright.sizing import Sizing
from gearwright.sizing.making import built_checks
from gearwright.sizing.mass import complete_mass
from gearwright.spec import edited
from gearwright.spec.edit import Value

# ----------------------------------------------------------------------------------------------------------------------
# One change of a settled design: proportioned once, and what it then lacks of what is asked.
# ----------------------------------------------------------------------------------------------------------------------


MOVED = ("critical speeds", "room", "teeth")
"""Requirements that other teeth and modules move."""


class Change(NamedTuple):
    """A change of one stage, or of several that share a gear."""

    tables: tuple[str, ...]
    """Of the stages in the design file, where teeth follow anew; empty: all teeth stay."""
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
    short, near = _standing(state)
    more, nearer = _shaking(state)
    return Candidate(state, short + more, near + nearer)


def _standing(state: Settled) -> tuple[float, float]:
    """Return what sizing and making lack [-], and the part of room and teeth in it."""
    return _lacking(state, [*state.sizing.checks, *built_checks(state.sizing)])


def _shaking(state: Settled) -> tuple[float, float]:
    """Return what resonances lack [-], which is the part of critical speeds."""
    return _lacking(state, resonance_checks(state.sizing))


def _lacking(state: Settled, checks: Iterable[Check]) -> tuple[float, float]:
    counted = wanted(checks, state.task.wishes.left_out)
    lacking = [check for check in counted if check.status is Status.FAILS and not check.waiver]
    near = (check for check in lacking if requirement_of(check) in MOVED)
    return _sum(lacking), _sum(near)


def _sum(checks: Iterable[Check]) -> float:
    return sum(1.0 - (check.margin or 0.0) for check in checks)


class Option:
    """A change of a settled design: proportioned once, judged, and confirmed, each only where somebody asks for it."""

    def __init__(self, state: Settled, change: Change, name: str, firsts: dict[str, Sizing]) -> None:
        self.state, self.change, self.firsts = state, change, firsts
        self.name = f"{name} {sha256(repr(change).encode()).hexdigest()[:16]}"

    @cached_property
    def settled(self) -> Settled:
        """Proportioned once, with the dynamic factors of what it is a change of."""
        return _screened(self.state, self.change, self.firsts)

    @cached_property
    def _still(self) -> Settled:
        """The same with open axes where they stand first."""
        now().looked_at += 1
        found = _screened(self.state, self.change, self.firsts, still=True)
        if not _lacks_room(found):
            self.__dict__["settled"] = found  # no axis has to be turned
        return found

    @cached_property
    def _first(self) -> Seen:
        """Mass [kg], what it lacks beside room [-], and whether it has room, before any axis is turned."""
        return now().seen(f"{self.name} still", lambda: (self._still.sizing.mass, *_without_room(self._still)))

    @cached_property
    def _exact(self) -> Seen:
        """Mass and lacks with axes turned where they must."""
        if not self._first or self.has_room:
            return self._first
        return now().seen(f"{self.name} turned", lambda: (self.settled.sizing.mass, *_standing(self.settled)))

    @cached_property
    def _shaken(self) -> Seen:
        if not self._exact:
            return ()
        return now().seen(f"{self.name} shakes", lambda: _shaking(self._still if self.has_room else self.settled))

    @property
    def can_be_sized(self) -> bool:
        """Whether it can."""
        return bool(self._first)

    @property
    def weighed(self) -> Seen:
        """Its mass and what it lacks, before axes are turned; empty where it cannot be sized."""
        return self._first

    @property
    def mass(self) -> float:
        """Of gears, shafts and carriers, before axes are turned [kg]."""
        return self._first[0]

    @cached_property
    def complete(self) -> float:
        """Complete mass, before axes are turned [kg]."""
        return now().seen(f"{self.name} weighs", lambda: (complete_of(self._still),))[0]

    @property
    def has_room(self) -> bool:
        """Whether no axis has to be turned."""
        return bool(self._first[2])

    @property
    def stands(self) -> float:
        """What its sizing and its making lack beside room, without what shakes: it lacks no less [-]."""
        return self._first[1]

    @property
    def short(self) -> float:
        """What all failing checks lack [-]; infinite where its axes or its modes cannot be had."""
        return self._exact[1] + self._shaken[0] if self._exact and self._shaken else math.inf

    @property
    def rank(self) -> tuple[float, float]:
        """What meets more comes first, then what is lighter."""
        return round(self.short, 6), self._exact[0] if self._exact else math.inf

    def confirmed(self) -> Confirmed:
        """Return it with dynamic factors of its own."""
        return Confirmed(self)


class Confirmed:
    """A change with the dynamic factors of its own."""

    def __init__(self, option: Option) -> None:
        self.option = option

    @cached_property
    def settled(self) -> Settled:
        """From the loop."""
        now().confirmed += 1
        return settled(self.option.settled.task)

    @cached_property
    def _found(self) -> Seen:
        return now().seen(
            f"{self.option.name} confirmed",
            lambda: (self.settled.sizing.mass, complete_of(self.settled), *judged(self.settled)[1:]),
        )

    @property
    def can_be_sized(self) -> bool:
        """Whether it can."""
        return bool(self._found)

    @property
    def complete(self) -> float:
        """Complete mass [kg]."""
        return self._found[1]

    @property
    def short(self) -> float:
        """What all failing checks lack [-]."""
        return self._found[2]

    @property
    def near(self) -> float:
        """The part of critical speeds and of room in it [-]."""
        return self._found[3]

    @property
    def rank(self) -> tuple[float, float]:
        """What meets more comes first, then what is lighter."""
        return round(self.short, 6), self._found[0]

    @property
    def candidate(self) -> Candidate:
        """With its sizing."""
        return Candidate(self.settled, self.short, self.near)


def options(state: Settled, changes: Iterable[Change]) -> list[Option]:
    """Return every change that can be sized, proportioned once; of those that come to the same the first.

    A module that is looked for comes to one of those that are tried beside it.

    Args:
        state: That is changed.
        changes: Each of the same state.
    """
    task, own = state.task, state.factors
    started = None if task.start is None else task.start.teeth
    stands = (task.chosen, task.factors, task.targets, task.planets, started, own, dict(state.proportioned.sizes))
    name = sha256(repr(stands).encode()).hexdigest()[:16]
    firsts, found = dict[str, Sizing](), dict[tuple[str, Seen], Option]()
    for change in changes:
        option = Option(state, change, name, firsts)
        if option.can_be_sized:
            found.setdefault((_but_modules(change), option.weighed), option)
    return list(found.values())


def _but_modules(change: Change) -> str:
    """Return what a change is beside the modules that it sets."""
    return repr({path: value for path, value in change.values.items() if ".module_" not in path})


def _lacks_room(state: Settled) -> bool:
    """Tell whether bodies stand into each other, so that open axes would be turned."""
    return any(check.fails and requirement_of(check) == "room" for check in state.sizing.checks)


def _without_room(state: Settled) -> tuple[float, float]:
    """Return what sizing and making lack, and 1 if that is all; without room, and 0, where axes are to be turned."""
    if not _lacks_room(state):
        return _standing(state)[0], 1.0
    checks = [*state.sizing.checks, *built_checks(state.sizing)]
    return _lacking(state, (check for check in checks if requirement_of(check) not in ("room", "making")))[0], 0.0


def _screened(state: Settled, change: Change, firsts: dict[str, Sizing], *, still: bool = False) -> Settled:
    """Return a change, proportioned once; the teeth of the other stages stay, and their sizes where they still do.

    What teeth follow from a change is found once, whatever module is tried with them.
    """
    design, sizing = state.task.design, state.sizing
    anew = tuple(f"{table}." for table in change.tables)
    stays = {path: value for path, value in teeth_of(design, sizing) if not path.startswith(anew)}
    own = {path: value for path, value in state.task.chosen.items() if path not in change.frees}
    task = replace(state.task, chosen={**own, **stays, **change.values})
    changes = changes_of(task.design, state.factors)
    stated = edited(task.design, {**task.chosen, **changes})
    first, sizes, kept = sizing, state.proportioned.sizes, dict[str, StageSize]()
    if change.tables:
        kept = {name: size for name, size in sizes.items() if design.table(name) not in change.tables}
        name = _but_modules(change)
        if name not in firsts:
            without = {path: None for path in change.values if ".module_" in path}
            alone = edited(task.design, {**task.chosen, **without, **changes})
            firsts[name] = sized(edited(alone, dict(sizes_of(alone, sizes))), still=True)
        first = firsts[name]
    found = proportioned(stated, task.wishes, before=first, targets=task.targets, kept=kept, still=still, among=firsts)
    return replace(state, task=replace(task, start=first), proportioned=found)


def complete_of(state: Settled) -> float:
    """Return the mass of everything in a gearbox [kg].

    Args:
        state: As settled or proportioned.
    """
    return complete_mass(state.sizing).total
