"""The loop of closure, proportion and confirmation by dynamics, and one change of a design that has settled."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from hashlib import sha256
from typing import NamedTuple

from gearwright.base import GEARBOX, Check, GearwrightError, Status, lacking_of, worst
from gearwright.closure.proportion import Proportioned, StageSize, proportioned, sizes_of, teeth_of
from gearwright.closure.requirements import HOUR, Round, Seen, Step, Wishes, now, requirement_of, sized, wanted
from gearwright.dynamics.sharing import load_factors
from gearwright.dynamics.vibration import forced_factors, resonance_checks
from gearwright.sizing import Sizing
from gearwright.sizing.making import built_checks
from gearwright.sizing.mass import complete_mass
from gearwright.spec import Design, against_fatigue, edited
from gearwright.spec.design import RATINGS, case_named
from gearwright.spec.edit import Value

# ----------------------------------------------------------------------------------------------------------------------
# What a closure starts from: the design with a rating that knows fatigue, the life that is asked, nothing chosen.
# ----------------------------------------------------------------------------------------------------------------------


def start_of(design: Design, wishes: Wishes) -> Design:
    """Return the design as a closure begins with it.

    Stages that Lewis and Hertz rate are rated by ISO 6336, as no life can be asked of static strength; the rules that
    only those two read are left out with them.

    Args:
        design: As read.
        wishes: What is asked.

    Raises:
        DesignError: Values that the keys of the design do not allow.
    """
    return against_fatigue(design, _lives(wishes))


def _lives(wishes: Wishes) -> Mapping[str, Value]:
    if wishes.life is None:
        return {}
    hours = wishes.life / HOUR
    return {"service.life_h": hours, "service.bearing_life_h": hours}


# ----------------------------------------------------------------------------------------------------------------------
# Confirm: dynamic factors by a forced response at the speeds of every case, load factors by the stated errors.
# ----------------------------------------------------------------------------------------------------------------------


STEP = 1e-3
"""To which a dynamic factor is written, upwards [-]."""
LARGEST = 5.0
"""That the key takes [-]."""
LARGEST_SHARE = 3.0
"""K_γ that the key takes [-]."""
ABOVE = 1.002
"""Factor on K_γ, as the next size shares its load a little otherwise [-]."""


class Factors(NamedTuple):
    """By how much teeth bear more than their torque says."""

    dynamic: Mapping[str, float]
    """Stage -> K_V [-]."""
    sharing: Mapping[str, float]
    """Stage -> K_γ [-]."""


def shared(sizing: Sizing) -> dict[str, float]:
    """Return stage -> K_γ by the errors of the design, of those that do not state one themselves [-].

    Args:
        sizing: As proportioned.
    """
    return {stage: ABOVE * factor for stage, factor in load_factors(sizing).items()}


def confirmed(sizing: Sizing) -> dict[str, float]:
    """Return stage -> largest dynamic factor of its meshes in all cases that last, by forced response [-].

    A case of which no equilibrium is found has none; its run says why, as a check that is not assessed.

    Args:
        sizing: As proportioned.
    """
    factors: dict[str, float] = {}
    stages = {mesh.name: mesh.stage for mesh in sizing.meshes}
    for case in sizing.flows:
        if case_named(sizing.design, case).static:
            continue
        try:
            forced = forced_factors(sizing, case)
        except GearwrightError:
            continue
        for mesh, factor in forced.items():
            factors[stages[mesh]] = max(factors.get(stages[mesh], 1.0), factor)
    return factors


def beyond_rating(sizing: Sizing) -> dict[str, float]:
    """Return stage -> dynamic factor by forced response, of those whose rating takes less [-].

    Args:
        sizing: As written.
    """
    application = sizing.design.service.application_factor
    used = dict[str, float]()
    for mesh in sizing.meshes:
        used[mesh.stage] = min(used.get(mesh.stage, math.inf), mesh.rating.peaks / application)
    return {stage: factor for stage, factor in confirmed(sizing).items() if factor > used[stage] * (1.0 + STILL)}


def takes_factor(design: Design, stage: str) -> bool:
    """Tell whether the method of a stage takes a dynamic factor.

    Args:
        design: With its rules.
        stage: Pair or set.
    """
    return RATINGS[design.rating(stage)].table == "iso6336" and design.rating(stage) != "iso10300"


def changes_of(design: Design, factors: Factors) -> dict[str, Value]:
    """Return the changes that give confirmed factors to the stages that take them.

    Args:
        design: Where they are written; what it asks for itself holds where it is more, and its own K_γ always.
        factors: As confirmed.
    """
    changes: dict[str, Value] = {}
    for stage, factor in factors.dynamic.items():
        if takes_factor(design, stage):
            own = design.rules(stage).iso6336.least_dynamic_factor
            upwards = min(_upwards(factor), LARGEST)
            if upwards > own:
                changes[f"{design.table(stage)}.gears.iso6336.least_dynamic_factor"] = upwards
    for stage, factor in factors.sharing.items():
        if takes_share(design, stage):
            changes[f"{design.table(stage)}.gears.mesh_load_factor"] = min(_upwards(factor), LARGEST_SHARE)
    return changes


def takes_share(design: Design, stage: str) -> bool:
    """Tell whether a design leaves the load factor of a stage open.

    Args:
        design: With its rules.
        stage: Pair or set.
    """
    rules = design.rules(stage)
    return rules.mesh_load_factor is None and not rules.planet_load_factors


def _upwards(factor: float) -> float:
    return round(-(-factor // STEP) * STEP, 3)


# ----------------------------------------------------------------------------------------------------------------------
# The loop: proportion, confirm, proportion again, until dynamic and load factors stand still.
# ----------------------------------------------------------------------------------------------------------------------


MOST_ROUNDS = 8
"""Rounds after which a loop counts as one that does not converge [-]."""
STILL = 0.005
"""Relative change of a dynamic factor that counts as none [-]."""
CONFIRMS = "peaks"
"""Requirement for which dynamic factors are confirmed."""
SHARES = "sharing"
"""Requirement for which load factors are."""
RATCHET = 4
"""Round from which dynamic factors no longer fall, so that a train that swings between two sizes comes to rest [-]."""


@dataclass(frozen=True)
class Task:
    """A design to close."""

    design: Design
    """As it starts."""
    wishes: Wishes
    chosen: Mapping[str, Value] = field(default_factory=dict)
    """Path -> value that the closure chose against resonance: teeth and modules."""
    factors: Mapping[str, float] = field(default_factory=dict)
    """Stage -> K_V to start with, from peaks of a run [-]."""
    targets: Mapping[str, float] = field(default_factory=dict)
    """Stage -> margin that a flight asks of its strengths [-]."""
    planets: Mapping[str, float] = field(default_factory=dict)
    """Set -> life in the cases that a flight asks of what its planets turn on [h]."""
    start: Sizing | None = None
    """Sizing with the teeth that are chosen, from whose modules the search begins; None: they are free."""

    @property
    def changed(self) -> Design:
        """The design with what the closure chose, its sizes still free."""
        return edited(self.design, self.chosen) if self.chosen else self.design


@dataclass(frozen=True)
class Settled:
    """What the loop ends with."""

    task: Task
    proportioned: Proportioned
    factors: Factors
    """K_V and K_γ of its stages."""
    rounds: tuple[Round, ...]
    converged: Check

    @property
    def sizing(self) -> Sizing:
        """Of the written design."""
        return self.proportioned.sizing


def settled(task: Task) -> Settled:
    """Return a design whose sizes, dynamic and load factors agree, or the last round with a check that fails.

    Args:
        task: With its freedoms.

    Raises:
        DesignError: If the design cannot be sized.
    """
    rounds, before = list[Round](), task.start
    factors = Factors(dict(task.factors), {})
    for number in range(1, MOST_ROUNDS + 1):
        stated = edited(task.design, {**task.chosen, **changes_of(task.design, factors)})
        own = proportioned(stated, task.wishes, before=before, targets=task.targets)
        before = own.sizing
        rounds.append(Round(Step.PROPORTION, before.mass, _margin(own, task), 0.0, _sizes(own)))
        following = _following(task, before, factors, number)
        change = max(_changes(before, factors, following), default=0.0)
        rounds.append(Round(Step.CONFIRM, before.mass, _margin(own, task), change, _factors(following, before)))
        if change <= STILL:
            break
        factors = following
    return Settled(task, own, factors, tuple(rounds), _convergence(change))


def _following(task: Task, sizing: Sizing, held: Factors, number: int) -> Factors:
    """Return the factors of a round; from the fourth on none is less than the one before."""
    left_out, late = task.wishes.left_out, number >= RATCHET
    found = confirmed(sizing) if CONFIRMS not in left_out else {}
    floor = held.dynamic if late else task.factors
    dynamic = {stage: max(value, floor.get(stage, 1.0)) for stage, value in {**task.factors, **found}.items()}
    sharing = shared(sizing) if SHARES not in left_out else {}
    least = held.sharing if late else {}
    return Factors(dynamic, {stage: max(value, least.get(stage, 1.0)) for stage, value in sharing.items()})


def _changes(sizing: Sizing, held: Factors, found: Factors) -> Iterator[float]:
    """Yield by how much every factor differs from the one that the stage was sized with [-]."""
    yield from (_change(sizing, stage, held.dynamic, found.dynamic) for stage in found.dynamic)
    for stage, factor in found.sharing.items():
        if takes_share(sizing.design, stage) or stage in held.sharing:
            sized = max(mesh.load_factor for mesh in sizing.meshes if mesh.stage == stage)
            yield abs(factor / held.sharing.get(stage, sized) - 1.0)


def _change(sizing: Sizing, stage: str, held: Mapping[str, float], found: Mapping[str, float]) -> float:
    """Return by how much a stage's factor differs from the one it was sized with; 0 where its method's own is more."""
    if not takes_factor(sizing.design, stage):
        return 0.0
    application = sizing.design.service.application_factor
    used = min(mesh.rating.peaks / application for mesh in sizing.meshes if mesh.stage == stage)
    before, after = held.get(stage, 1.0), found[stage]
    return 0.0 if max(before, after) <= used * (1.0 - STILL) else abs(after / before - 1.0)


def _margin(own: Proportioned, task: Task) -> float:
    first = worst(wanted(own.sizing.checks, task.wishes.left_out))
    return math.inf if first is None or first.margin is None else first.margin


def _sizes(own: Proportioned) -> str:
    sizes = own.sizes.items()
    return "; ".join(f"{name} m {1e3 * row.module:.4g} b {1e3 * row.face_width:.4g} mm" for name, row in sizes)


def _factors(factors: Factors, sizing: Sizing) -> str:
    """Return the factors of a round: of K_V the one that governs, by the rating or by the forced response."""
    application = sizing.design.service.application_factor
    dynamic = list[str]()
    for stage, factor in factors.dynamic.items():
        rated = max(mesh.rating.peaks / application for mesh in sizing.meshes if mesh.stage == stage)
        by = "by forced response" if factor >= rated else f"by its rating; forced response {factor:.3f}"
        dynamic.append(f"{stage} K_V {max(factor, rated):.3f} {by}")
    return "; ".join([*dynamic, *(f"{stage} K_γ {factor:.3f}" for stage, factor in factors.sharing.items())])


def _convergence(change: float) -> Check:
    """Return the check of the loop itself."""
    clause = f"{MOST_ROUNDS} rounds: K_V and K_γ stand within {STILL:.1%}"
    return Check(GEARBOX, "convergence of the closure", clause, change, STILL, at_most=True, exponent=None)


# ----------------------------------------------------------------------------------------------------------------------
# One change of a settled design: proportioned once, and what it then lacks of what is asked.
# ----------------------------------------------------------------------------------------------------------------------


MOVED = ("critical speeds", "room", "teeth")
"""Requirements that other teeth and modules move."""


class StageChange(NamedTuple):
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
    return lacking_of(lacking), lacking_of(near)


class Option:
    """A change of a settled design: proportioned once, judged, and confirmed, each only where somebody asks for it."""

    def __init__(self, state: Settled, change: StageChange, name: str, firsts: dict[str, Sizing]) -> None:
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


def options(state: Settled, changes: Iterable[StageChange]) -> list[Option]:
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


def _but_modules(change: StageChange) -> str:
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


def _screened(state: Settled, change: StageChange, firsts: dict[str, Sizing], *, still: bool = False) -> Settled:
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
