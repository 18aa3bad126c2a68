"""Closure with shafts in bearings: what critical speeds, peaks and room ask for once bearings are in the gearbox.

A closure keeps critical speeds away from operating ones while shafts are as short as their gears. In bearings they are
longer, thicker and heavier, so that modes move. Here a gearbox is closed, put into bearings, closed again with its
shafts as heavy and as stiff as they then are, and put into bearings again, until its review passes.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

from gearwright.base import (
    SIDES,
    Check,
    DesignError,
    GearwrightError,
    Kind,
    Mass,
    PartId,
    Ratio,
    Shown,
    accepted,
    lacking_of,
    verb,
    worst,
)
from gearwright.closure.arrange import Arranged, arranged_where_needed
from gearwright.closure.close import close, looked_at
from gearwright.closure.loop import start_of
from gearwright.closure.moves import standard_modules, words_of
from gearwright.closure.proportion import searched
from gearwright.closure.requirements import Closed, Outcome, Wishes, requirement_of, wanted
from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.equations import modes
from gearwright.dynamics.vibration import critical_speeds, peak_checks, resonance_checks
from gearwright.sizing import Sizing, size
from gearwright.sizing.mass import complete_mass
from gearwright.sizing.rating import MESHES
from gearwright.spec import Design, at_level, design_text, edited
from gearwright.spec.design import CONCEPT, NOTHING_GIVEN, PRELIMINARY, Pair, module_owners
from gearwright.spec.edit import Value

# ----------------------------------------------------------------------------------------------------------------------
# What comes of it.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class BearingRound:
    """A gearbox that was put into bearings."""

    what: str
    """What was moved of the gearbox as it was closed first, in words; empty of that one."""
    before: Mass
    """Complete mass as it was closed for it, without bearings [kg]."""
    mass: Mass
    """Complete mass in bearings [kg]."""
    lacking: Ratio
    """What its failing checks lack of their limits together [-]."""
    worst: str
    """The one that lacks most, with its margin; empty where none fails."""


@dataclass(frozen=True, repr=False)
class ClosedArrangement(Shown):
    """A closed gearbox with bearings on every shaft that needs them."""

    closed: Closed
    """Before its shafts stand in bearings, with the sizes that it has with them."""
    arranged: Arranged | None
    """In bearings; None where no shaft needs any, or one finds none."""
    checks: tuple[Check, ...]
    """Everything that is looked at of the gearbox as it stands, worst first."""
    rounds: tuple[BearingRound, ...]
    """Gearboxes that were put into bearings, one after another."""
    searched: tuple[str, ...]
    """Freedoms that were moved with bearings in the gearbox, in words."""
    without_bearings: str = ""
    """Shafts that need bearings and find none, and why; empty where all have them."""
    what: str = ""
    """What was moved of the gearbox as it was closed first, in words; empty where nothing was."""
    unmet: frozenset[str] = frozenset()
    """Names of checks that the closure without bearings did not meet, so that nothing is moved for them here."""

    @property
    def sizing(self) -> Sizing:
        """As it stands."""
        return self.closed.sizing if self.arranged is None else self.arranged.sizing

    @property
    def design(self) -> Design:
        """As it stands."""
        return self.sizing.design

    @property
    def text(self) -> str:
        """The design as a file."""
        return design_text(self.design)

    @property
    def mass(self) -> Mass:
        """Complete mass [kg]."""
        return complete_mass(self.sizing).total

    @property
    def failing(self) -> tuple[Check, ...]:
        """Checks that fail."""
        return tuple(check for check in self.checks if check.fails)

    @cached_property
    def order(self) -> tuple[bool, float, float]:
        """What stands in bearings comes first, then what meets more, then what is lighter."""
        return bool(self.without_bearings), round(lacking_of(self.failing), 6), self.mass

    @property
    def left_open(self) -> tuple[Check, ...]:
        """Checks that fail in bearings alone: the closure without them met these."""
        return tuple(check for check in self.failing if check.name not in self.unmet)

    @property
    def passes(self) -> bool:
        """Whether all its shafts stand in bearings, and these leave nothing unmet."""
        return not (self.left_open or self.without_bearings)


# ----------------------------------------------------------------------------------------------------------------------
# The verb.
# ----------------------------------------------------------------------------------------------------------------------


MOST_ROUNDS = 3
"""How often a gearbox is put into bearings, at most [-]."""
MODULES = (-1, 1, 2, 3)
"""Steps of ISO 54 by which the module of a stage is changed where closing again leads to what was known before, or
where a shaft finds no bearings that go over its gear [-]."""
WHEELS = (-18, -10, -5, 5, 10, 18)
"""About how many teeth one wheel has more, the wheel of the next pair fewer by as much of the ratio [-]."""
LARGEST_RATIO = 10
"""Teeth of a wheel over those of its pinion, at most [-]."""
MOST_SIZES = 3
"""The lightest of these that are put into bearings [-]."""


@verb
@MESHES.sharing()
def close_arranged(
    design: Design,
    closed: Closed | None = None,
    *,
    wishes: Wishes | None = None,
    tell: Callable[[str], None] | None = None,
    keep: Callable[[ClosedArrangement], None] | None = None,
) -> ClosedArrangement:
    """Return the lightest gearbox in bearings that meets everything, of those to which what the design leaves open
    leads, or the one that lacks least.

    Closed and put into bearings, other diameters and bores of its shafts are looked at. Where checks fail then that did
    not before, it is closed again with its shafts as stiff and as heavy as they stand, by other teeth and modules, and
    put into bearings again, at most twice. Then single other modules and splits of the ratio are tried.

    Args:
        design: With the freedoms that are left; what it gives is kept. A concept is taken as preliminary.
        closed: Of it at that level, where that is known.
        wishes: What is asked of the closure; left out: as it was closed, or as the design says.
        tell: Called with what is being done.
        keep: Called with the best so far, wherever there is a better one.

    Raises:
        DesignError: If the design cannot be sized.
    """
    asked = wishes or (Wishes() if closed is None else closed.wishes)
    say = tell or _silent
    taken = as_compared(design)
    own = closed_as_compared(design, asked, say) if closed is None else closed
    course = _Course(taken, asked, say, keep, frozenset(row.check.name for row in own.unmet))
    found = course.put(own)
    if found.without_bearings:
        found = course.with_other_sizes(found)
    for _ in range(MOST_ROUNDS - 1):
        again = course.closed_with(found.arranged.sizing) if found.arranged and found.left_open else None
        if again is None:
            break
        found = course.put(*again)
    best = course.best or found
    if best.arranged and best.left_open:
        course.with_other_sizes(best)
    return replace(course.best or best, rounds=tuple(course.rounds), searched=tuple(course.searched))


def as_compared(design: Design) -> Design:
    """Return a design at the level at which architectures compete, where its gears have the bodies that they are made
    with: a concept as preliminary, any other as it is.

    Args:
        design: As read.
    """
    return at_level(design, PRELIMINARY) if design.level == CONCEPT else design


def closed_as_compared(design: Design, wishes: Wishes, tell: Callable[[str], None] | None = None) -> Closed:
    """Return a design closed as preliminary; a concept as it is, where that meets more, or as much and is lighter.

    A closure is a local search: what it cannot meet from one start it may meet from another.

    Args:
        design: As read.
        wishes: What is asked of the closure.
        tell: Called with what is being done.

    Raises:
        DesignError: If the design cannot be sized.
    """
    closed = close(as_compared(design), wishes=wishes, tell=tell)
    if closed.outcome is Outcome.OPEN and design.level == CONCEPT:
        return min(closed, close(design, wishes=wishes, tell=tell), key=_order)
    return closed


def _order(closed: Closed) -> tuple[float, float]:
    """Return what orders closures: what meets more comes first, then what is lighter."""
    return round(lacking_of([row.check for row in closed.unmet]), 2), closed.whole.total


def has_open_sizes(design: Design, wishes: Wishes | None = None) -> bool:
    """Tell whether a design leaves sizes of cylindrical stages open, so that a closure can move them.

    Args:
        design: As read.
        wishes: What is asked of the closure; left out: as the design says.
    """
    return bool(searched(start_of(design, wishes or Wishes())))


def _silent(_: str) -> None:
    """Say nothing."""


class _Course:
    """What is asked for, and what was found so far."""

    def __init__(
        self,
        design: Design,
        wishes: Wishes,
        say: Callable[[str], None],
        keep: Callable[[ClosedArrangement], None] | None,
        unmet: frozenset[str],
    ) -> None:
        self.design, self.wishes, self.say, self.keep, self.unmet = design, wishes, say, keep, unmet
        self.best: ClosedArrangement | None = None
        self.rounds = list[BearingRound]()
        self.searched = dict[str, None]()
        self.known = set[str]()
        """Texts of what was put into bearings."""

    def put(self, closed: Closed, what: str = "") -> ClosedArrangement:
        """Return a closed gearbox in bearings; one with other shafts where these let it pass."""
        self.say(f"putting shafts into bearings, round {len(self.rounds) + 1}")
        found = self._noted(replace(_put(closed, self.design), what=what, unmet=self.unmet))
        self.known.add(design_text(closed.design))
        if any(requirement_of(check) == RESONANT for check in found.left_open):
            self.say("looking for other diameters of shafts")
            other, words = self._with_other_shafts(found)
            if words:
                other = self._noted(replace(other, what="; ".join(filter(None, (what, words)))))
                return found if other.left_open else other
        return found

    def _noted(self, found: ClosedArrangement) -> ClosedArrangement:
        self.rounds.append(_round(found))
        if self.best is None or found.order < self.best.order:
            self.best = found
            if self.keep is not None:
                self.keep(found)
        return found

    def closed_with(self, stands: Sizing) -> tuple[Closed, str] | None:
        """Return the gearbox closed with its shafts as they stand; None where it is one that was known before."""
        felt = dict(shafts_as_they_stand(self.design, stands))
        self.say("closing again with the shafts as they stand")
        try:
            again = close(edited(self.design, felt), wishes=self.wishes, tell=self.say)
        except DesignError:
            return None
        again = _without(again, felt)
        self.searched |= dict.fromkeys(again.effort.searched)
        return None if design_text(again.design) in self.known else (again, _moves(again))

    def with_other_sizes(self, found: ClosedArrangement) -> ClosedArrangement:
        """Return the lightest gearbox of other modules or ratios that passes in bearings, or the one given.

        One that finds no bearings becomes the first that finds some, and what follows keeps what was changed for it.

        Args:
            found: That lacks bearings, or something with them.
        """
        felt = {} if found.arranged is None else dict(shafts_as_they_stand(self.design, found.arranged.sizing))
        rows = sorted(self._other_sizes(found, felt), key=lambda row: row[0].whole.total)
        for again, change in rows[: MOST_SIZES if felt else None]:
            other = self.put(again, words_of(change))
            if found.without_bearings and not other.without_bearings:
                self.design = edited(self.design, change)
                return other
            if other.passes:
                return other
        return found

    def _other_sizes(
        self, found: ClosedArrangement, felt: Mapping[str, Value]
    ) -> Iterator[tuple[Closed, Mapping[str, Value]]]:
        """Yield the gearbox closed with another module or ratio of one of its stages, and what was changed."""
        quick = replace(self.wishes, lighten=False, separate=False)  # what stands too near is left out below
        ratios = self._ratios(found.closed.sizing) if felt else ()  # without bearings it is a bore that is too small
        for change in (*self._modules(found.closed.sizing), *ratios):
            self.say(f"closing with {words_of(change)}")
            try:
                again = close(edited(self.design, {**felt, **change}), wishes=quick, tell=self.say)
            except GearwrightError:
                continue
            again = _without(again, felt)
            if self.unmet >= {row.check.name for row in again.unmet} and design_text(again.design) not in self.known:
                yield again, change

    def _modules(self, sizing: Sizing) -> Iterator[Mapping[str, Value]]:
        """Yield another module of one stage, where the design leaves it open: path -> value."""
        owners, modules = module_owners(self.design), {gear.stage: gear.module for gear in sizing.gears}
        for name in searched(self.design):
            if self.design.simple_stages[name].module is None and owners[name] == name:
                self.searched[f"module of {name}"] = None
                own = modules[name] / _MM
                values = (value for value in standard_modules(modules[name], MODULES) if abs(value / own - 1.0) > 1e-9)
                yield from ({f"{self.design.table(name)}.module_mm": value} for value in values)

    def _ratios(self, sizing: Sizing) -> Iterator[Mapping[str, Value]]:
        """Yield other teeth of two wheels whose pinions are given, so that both ratios together stay: path -> value."""
        design, teeth = self.design, sizing.teeth
        free = [name for name, pair in design.pairs.items() if pair.pinion_teeth is not None and _is_free(pair)]
        for first, second in pairwise(free):
            self.searched[f"ratios of {first} and {second}"] = None
            pinions, wheels = ([teeth[f"{name}.{side}"] for name in (first, second)] for side in SIDES)
            allowed = [_wheels(pinion, hunting=design.teeth.hunting) for pinion in pinions]
            for step in WHEELS:
                other = min(allowed[0], key=lambda count: abs(count - wheels[0] - step))
                beside = min(allowed[1], key=lambda count: abs(count - wheels[0] * wheels[1] / other))
                if other != wheels[0]:
                    yield {f"pairs.{first}.wheel_teeth": other, f"pairs.{second}.wheel_teeth": beside}

    def _with_other_shafts(self, found: ClosedArrangement) -> tuple[ClosedArrangement, str]:
        """Return a gearbox with the shafts that let it lack least, and what was changed; empty where nothing helps."""
        chosen = dict[str, Value]()
        for _ in range(MOST_SHAFTS):
            if not found.left_open:
                break
            tried = sorted(_other_shafts(self.design, found, self.searched), key=lambda one: one.order)
            better = next(_better(found, tried[:CONFIRMED]), None)
            if better is None:
                break
            found, change = better
            chosen |= change
        return found, words_of(chosen)


def _without(closed: Closed, felt: Mapping[str, Value]) -> Closed:
    """Return a closed gearbox without what it was told of its shafts."""
    design = edited(closed.design, dict.fromkeys(felt)) if felt else closed.design
    return replace(closed, design=design, sizing=size(design))


def _wheels(pinion: int, *, hunting: bool) -> list[int]:
    """Return the teeth that a wheel may have beside a pinion, without common factors where teeth are to hunt."""
    return [count for count in range(pinion, LARGEST_RATIO * pinion) if not hunting or math.gcd(pinion, count) == 1]


def _is_free(pair: Pair) -> bool:
    """Tell whether the wheel of a cylindrical pair follows from its ratio, and that from the speeds around it."""
    return pair.kind == "cylindrical" and pair.wheel_teeth is None and pair.ratio is None and pair.coaxial_with is None


def _put(closed: Closed, design: Design) -> ClosedArrangement:
    """Return a closed gearbox in bearings, judged as it stands."""
    arranged, bare = arranged_where_needed(closed.sizing, _without_diameters(closed.design, design))
    sizing = closed.sizing if arranged is None else arranged.sizing
    return ClosedArrangement(closed, arranged, judged_whole(sizing, closed.wishes), (), (), bare)


def judged_whole(sizing: Sizing, wishes: Wishes) -> tuple[Check, ...]:
    """Return every check of a gearbox as it stands, with peaks and resonances, worst first.

    Args:
        sizing: With bearings on its shafts.
        wishes: With the requirements that do not count.
    """
    checks = looked_at(sizing, peak_checks(sizing))
    return accepted(wanted(checks, wishes.left_out), sizing.design.waivers)


def _without_diameters(closed: Design, design: Design) -> Design:
    """Return a closed design without the diameters of shafts that the closure wrote: bearings ask for others."""
    given = {name for name, layout in design.layout.items() if layout.diameter is not None}
    wrote = [name for name, layout in closed.layout.items() if layout.diameter is not None and name not in given]
    return edited(closed, {f"layout.{name}.diameter_mm": None for name in wrote}) if wrote else closed


def _round(found: ClosedArrangement) -> BearingRound:
    first = worst(found.failing)
    words = "" if first is None else f"{first.name} {first.margin or 0.0:.4g}"
    return BearingRound(
        found.what, complete_mass(found.closed.sizing).total, found.mass, lacking_of(found.failing), words
    )


def _moves(closed: Closed) -> str:
    """Return teeth and modules of a closed gearbox in words."""
    stages = dict[str, list[str]]()
    for gear in closed.sizing.gears:
        stages.setdefault(f"{gear.stage} {gear.module / _MM:.4g} mm", []).append(str(gear.teeth))
    return "; ".join(f"{name}, {'/'.join(teeth)} teeth" for name, teeth in stages.items())


def shafts_as_they_stand(design: Design, stands: Sizing) -> Iterator[tuple[str, Value]]:
    """Yield mass, inertia and torsional stiffness of shafts in bearings, where the design gives none.

    The stiffness is that of what twists: between the outermost bodies on the shaft, not of the ends beyond them.

    Args:
        design: With its freedoms.
        stands: With its shafts in bearings.
    """
    system = assemble(stands, next(iter(stands.flows)))
    for shaft in stands.shafts:
        layout = design.layout.get(shaft.name, NOTHING_GIVEN)
        path, lines = f"layout.{shaft.name}", list(system.labels.places_of(PartId(Kind.SHAFT, shaft.name)))
        if layout.mass is None and shaft.mass > 0.0:
            yield f"{path}.mass_kg", shaft.mass
        if layout.inertia is None:
            yield f"{path}.inertia_kg_m2", shaft.inertia
        if layout.torsional_stiffness is None and lines:
            yield f"{path}.torsional_stiffness_nm_rad", 1.0 / float((1.0 / system.arrays.stiffness[lines]).sum())


# ----------------------------------------------------------------------------------------------------------------------
# Other diameters and bores of shafts in bearings: a shaft is the stiffness and the inertia that a mode feels.
# ----------------------------------------------------------------------------------------------------------------------


RESONANT = "critical speeds"
"""Requirement that other shafts move."""
TWISTS = 0.05
"""Part of a mode's elastic energy in a shaft from which another diameter moves it [-]."""
THICKER = (1.1, 1.2, 1.35, 1.6)
"""Factors on the thickest diameter of a shaft between its gears [-]."""
BORES = (0.0, 0.4, 0.7)
"""Bore over diameter [-]."""
MOST_SHAFTS = 2
"""Changes of shafts that are made one after another [-]."""
CONFIRMED = 2
"""The most promising ones that are judged in full [-]."""
STEP = 1e-3
"""To which diameters are made larger [m]."""
_MM = 1e-3


class _Tried(NamedTuple):
    """A gearbox with another shaft, judged without a run."""

    change: Mapping[str, Value]
    sizing: Sizing
    lacks: float

    @property
    def order(self) -> tuple[float, float]:
        """What meets more comes first, then what is lighter."""
        return round(self.lacks, 6), self.sizing.mass


def _other_shafts(design: Design, found: ClosedArrangement, searched: dict[str, None]) -> Iterator[_Tried]:
    """Yield the gearbox with another diameter or bore of one of its shafts, where the design leaves that open."""
    if found.arranged is None:
        return
    for change in _changes_of_shafts(design, found.arranged.sizing, searched):
        try:
            sizing = size(edited(found.arranged.design, change))
            checks = wanted([*sizing.checks, *resonance_checks(sizing)], found.closed.wishes.left_out)
        except GearwrightError:
            continue
        yield _Tried(change, sizing, lacking_of([check for check in checks if check.fails and not check.waiver]))


def _changes_of_shafts(design: Design, stands: Sizing, searched: dict[str, None]) -> Iterator[Mapping[str, Value]]:
    """Yield other diameters and bores of built shafts: path -> value."""
    twisting = _twisting(stands)
    for shaft in stands.shafts:
        layout = design.layout.get(shaft.name, NOTHING_GIVEN)
        given = (layout.diameter, layout.torsional_stiffness, layout.inertia)
        if shaft.name not in twisting or layout.as_given or any(value is not None for value in given):
            continue
        searched[f"diameter of {shaft.name}"] = None
        thick = {math.ceil(factor * shaft.diameter / STEP - 1e-6) * STEP for factor in THICKER}
        yield from ({f"layout.{shaft.name}.diameter_mm": round(value / _MM, 6)} for value in sorted(thick))
        if layout.bore is None and layout.bore_ratio is None and "bore_ratio" not in design.shafting.model_fields_set:
            yield from ({f"layout.{shaft.name}.bore_ratio": ratio} for ratio in BORES)


def _twisting(stands: Sizing) -> set[str]:
    """Return the built shafts whose twist holds some of the energy of a mode that lies too near to an order."""
    found, built = set[str](), [shaft.name for shaft in stands.built_shafts]
    for case in critical_speeds(stands):
        near = [critical.modes[0] - 1 for critical in case.nearest if critical.in_resonance]
        if not near:
            continue
        energy = modes(case.system).line_energy[:, near]
        for name in built:
            lines = list(case.system.labels.places_of(PartId(Kind.SHAFT, name)))
            if energy[lines].sum(axis=0).max() > TWISTS:
                found.add(name)
    return found


def _better(
    found: ClosedArrangement, tried: Iterable[_Tried]
) -> Iterator[tuple[ClosedArrangement, Mapping[str, Value]]]:
    """Yield gearboxes with another shaft that lack less, judged in full."""
    for one in tried:
        assert found.arranged is not None
        arranged = replace(found.arranged, design=one.sizing.design, sizing=one.sizing)
        other = replace(found, arranged=arranged, checks=judged_whole(one.sizing, found.closed.wishes))
        if other.order < found.order:
            yield other, one.change
