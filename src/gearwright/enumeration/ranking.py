"""Ranking of architectures by mass and unmet requirements, from first sizing to design closure."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import partial
from hashlib import sha256
from pathlib import Path
from typing import TypeVar

import numpy as np

from gearwright.base import (
    Check,
    DesignError,
    GearwrightError,
    Problem,
    Role,
    Shown,
    gear_part,
    refuse,
    smallest,
    smallest_first,
    verb,
)
from gearwright.closure import Wishes
from gearwright.enumeration.trains import (
    Architecture,
    Built,
    Requirement,
    borne,
    built,
    freedoms,
    requirement_of,
    trains,
)
from gearwright.processes import computed
from gearwright.sizing import Sizing, size, size_unturned
from gearwright.sizing.mass import complete_mass
from gearwright.sizing.rating import MESHES
from gearwright.spec import Design, at_level, edited
from gearwright.store import load, save
from gearwright.study import EqualLife, equal_life
from gearwright.study.architectures import Difference, difference, in_bearings, with_public_motors
from gearwright.version import __version__

# ----------------------------------------------------------------------------------------------------------------------
# Every architecture with its best numbers: as a first sizing, against fatigue, then by what it weighs and lacks.
# ----------------------------------------------------------------------------------------------------------------------


_STEPS = (0.25, 0.12)
"""Of every number within its range, up and down [-]."""
PRELIMINARY = "preliminary"
_ROOM = 0.7
"""Margin of room between bodies below which less counts as no worse, as closing makes room by turning axes [-]."""


@dataclass(frozen=True)
class Candidate:
    """An architecture with its best numbers."""

    architecture: Architecture
    ratios: tuple[float, ...] = ()
    """Of its stages [-]."""
    motor_speed: float | None = None
    """[rad/s]"""
    places: tuple[float, ...] = ()
    """Of its numbers within their ranges, from 0 to 1 [-]."""
    first_mass: float | None = None
    """Of gears, shafts and carriers as a first sizing, with its motor [kg]."""
    first_complete: float | None = None
    """Of the whole gearbox of that first sizing, with its motor; inverter and cooling are the same for all [kg]."""
    design: Design | None = None
    """At level preliminary; None where it is refused, or far from the lightest as a first sizing."""
    complete_mass: float | None = None
    """Of the whole gearbox against fatigue; with bearings of its shafts where `bare` is empty [kg]."""
    motor_mass: float | None = None
    """Of the motor by itself [kg]."""
    inverter_mass: float | None = None
    """[kg]"""
    cooling_mass: float | None = None
    """Of motor and inverter [kg]."""
    lacks: tuple[tuple[str, float], ...] = ()
    """Checks that fail, with their margins, the worst first."""
    rated_mass: float | None = None
    """Complete, with its motor, before its numbers were chosen anew [kg]."""
    rated_promise: float | None = None
    """What it promised then [kg]."""
    proportioned: bool = False
    """Whether its numbers were chosen anew, by what it weighs and lacks against fatigue."""
    bare: str | None = None
    """Shafts that need bearings and find none, and why; empty where all stand in bearings; None: not looked for."""
    refused: str = ""
    """Why it cannot be sized."""

    @property
    def with_machines(self) -> float | None:
        """Complete mass and motor with inverter and cooling [kg]; None where it is refused."""
        if self.complete_mass is None:
            return None
        return self.complete_mass + sum(
            part or 0.0 for part in (self.motor_mass, self.inverter_mass, self.cooling_mass)
        )

    @property
    def worst(self) -> float:
        """Margin of the check that fails worst, 1 where none does [-]."""
        return min((margin for _, margin in self.lacks), default=1.0)

    @property
    def unborne(self) -> bool:
        """Whether it has planets in which no bearing lives as long as asked."""
        if self.design is None:
            return False
        planets = [gear_part(name, Role.PLANET) for name in self.design.planetaries]
        stepped = self.design.epicyclics.items()
        planets += [gear_part(name, Role.PLANET, own=own) for name, stage in stepped for own in stage.planets]
        return not {f"{planet} life" for planet in planets}.isdisjoint(name for name, _ in self.lacks)

    @property
    def promise(self) -> float:
        """What it may weigh once everything is met [kg]: a mass grows as the square root of what it lacks, or so.

        Room that is missing beside bodies weighs little. It only orders what is looked at next; masses that are told
        are computed.
        """
        mass = self.with_machines
        lacks = (max(margin, _ROOM) if " room beside " in name else margin for name, margin in self.lacks)
        return float("inf") if mass is None else mass / max(min(lacks, default=1.0), 0.01) ** 0.5

    @property
    def order(self) -> tuple[int, float, float, str]:
        """By what it promises, those with all their bearings weighed first; those that are known as first sizings alone
        follow, by their mass, then refused ones."""
        weighed = 2 if self.bare is None else int(bool(self.bare))
        return weighed, self.promise, self.first_complete or float("inf"), self.architecture.slug


def sketched(requirement: Requirement, architecture: Architecture, *, most: float = math.inf) -> Candidate:
    """Return an architecture with the numbers that weigh least as a first sizing.

    Args:
        requirement: Machines, cases and rules.
        architecture: That is to serve it.
        most: Complete mass with its motor in the middle of its ranges, above which no other numbers are looked at [kg].
    """
    if slowed := _slowed(requirement, architecture):
        return Candidate(architecture, refused=slowed)
    middle = _middle(requirement, architecture) if most < math.inf else None
    if middle is not None and (middle.first_complete or 0.0) > most:
        return middle
    try:
        first, best, places = _lightest(requirement, architecture)
        sizing = size_unturned(best.design)
        whole = complete_mass(sizing).total + sizing.motor_mass
    except GearwrightError as error:
        return Candidate(architecture, refused=_words(error))
    return Candidate(architecture, best.ratios, best.motor_speed, places, first, whole)


def _slowed(requirement: Requirement, architecture: Architecture) -> str:
    """Say where a differential turns the propeller more slowly than may be; empty where it does not."""
    case, speed = requirement.slowed
    tolerance = requirement.design.teeth.speed_tolerance
    if speed >= 1.0 - tolerance or not any(kind.balanced for kind in architecture.members):
        return ""
    why = "its torques stand in a fixed ratio, and the motor gives less there"
    return f"turns the propeller at {speed:.2f} of its speed in {case}: {why}; {1.0 - tolerance:.2f} is asked"


def _middle(requirement: Requirement, architecture: Architecture) -> Candidate | None:
    """Return an architecture with the middle of its ranges as a first sizing; None where that cannot be sized."""
    places = (0.5,) * freedoms(architecture)
    try:
        made = built(requirement, architecture, places)
        sizing = size_unturned(made.design)
        whole = complete_mass(sizing).total + sizing.motor_mass
    except GearwrightError:
        return None
    return Candidate(architecture, made.ratios, made.motor_speed, places, _first_mass(sizing), whole)


@MESHES.sharing()
def rated(requirement: Requirement, row: Candidate, *, life: float) -> Candidate:
    """Return a sketched architecture sized against fatigue, with everything in its mass.

    Args:
        requirement: Machines, cases and rules.
        row: As sketched.
        life: Of gears and bearings alike [s].
    """
    try:
        found = _rated(requirement, row, row.places, life)
        return replace(found, rated_mass=found.with_machines, rated_promise=found.promise)
    except GearwrightError as error:
        return replace(row, refused=_words(error))


@MESHES.sharing()
def proportioned(requirement: Requirement, row: Candidate, *, life: float) -> Candidate:
    """Return an architecture whose numbers promise most against fatigue, of a star of points about those it has.

    A first sizing knows no bearing: numbers that are lightest without may leave planets no bearing that lives.

    Args:
        requirement: Machines, cases and rules.
        row: As rated.
        life: Of gears and bearings alike [s].
    """
    best = replace(row, proportioned=True)
    for step in _STEPS:
        for around in list(_star(best.places, step))[1:]:
            try:
                tried = _rated(requirement, best, around, life)
            except GearwrightError:
                continue
            best = smallest([best, tried], lambda one: one.promise)
    return best


@MESHES.sharing()
def weighed(row: Candidate) -> Candidate:
    """Return an architecture with bearings on every shaft that needs them in its mass and among what it lacks.

    Args:
        row: As rated.
    """
    if row.design is None:
        return row
    _, sizing, bare = in_bearings(size(row.design))
    return replace(row, complete_mass=complete_mass(sizing).total, lacks=tuple(_lacks(sizing.checks)), bare=bare)


def _rated(requirement: Requirement, row: Candidate, places: Sequence[float], life: float) -> Candidate:
    """Return an architecture at a place in the range of its numbers, sized against fatigue."""
    made = built(requirement, row.architecture, places)
    design = borne(for_life(at_level(made.design, PRELIMINARY), life))
    sizing = size(design)
    return replace(
        row, ratios=made.ratios, motor_speed=made.motor_speed, places=tuple(places), design=design,
        complete_mass=complete_mass(sizing).total, motor_mass=sizing.motor_mass, inverter_mass=sizing.inverter_mass,
        cooling_mass=sizing.cooling_mass, lacks=tuple(_lacks(sizing.checks)),
    )  # fmt: skip


def for_life(design: Design, life: float) -> Design:
    """Return a design that is asked for one life of gears and bearings.

    Args:
        design: Of any kind.
        life: [s].
    """
    return edited(design, {"service.life_s": life, "service.bearing_life_s": life})


def _lightest(requirement: Requirement, architecture: Architecture) -> tuple[float, Built, tuple[float, ...]]:
    """Return the lightest, and its place, of a star of points, and of a smaller star about it; its place."""
    places = [0.5] * freedoms(architecture)
    tried: dict[tuple[float, ...], tuple[float, Built]] = {}
    problems: list[Problem] = []
    for step in _STEPS:
        for around in _star(places, step):
            if around not in tried:
                try:
                    made = built(requirement, architecture, around)
                    tried[around] = (_first_mass(size_unturned(made.design)), made)
                except GearwrightError as error:
                    problems = problems or [Problem(architecture.name, _words(error))]
        if not tried:
            raise DesignError(problems)
        best = smallest(tried, lambda point: tried[point][0])
        places = list(best)
    return (*tried[best], best)


def _star(places: Sequence[float], step: float) -> Iterator[tuple[float, ...]]:
    """Yield a point and those a step away from it along every number, within the range."""
    yield tuple(places)
    for number, place in enumerate(places):
        for moved in (place - step, place + step):
            if 0.0 <= moved <= 1.0:
                yield (*places[:number], moved, *places[number + 1 :])


def _first_mass(sizing: Sizing) -> float:
    return sizing.mass + sizing.machines_mass


def _lacks(checks: Sequence[Check]) -> Iterator[tuple[str, float]]:
    """Yield what fails, with its margin."""
    for check in checks:
        if check.fails and check.margin is not None:
            yield check.name, check.margin


def _words(error: GearwrightError) -> str:
    problems = error.problems if isinstance(error, DesignError) else ()
    return "; ".join(f"{problem.path}: {problem.message}" for problem in problems) or str(error)


# ----------------------------------------------------------------------------------------------------------------------
# The verb: every architecture that can serve a requirement, ranked, the most promising closed for one life.
# ----------------------------------------------------------------------------------------------------------------------


T = TypeVar("T")
STAGES = (2, 3)
"""How many stages a train may have, where nothing else is asked."""
CLOSED = 12
"""Architectures that are closed, where nothing else is asked [-]."""


@dataclass(frozen=True)
class Effort:
    """How much is looked at."""

    closed: int = CLOSED
    """Architectures that are closed, the most promising first [-]."""
    restarts: int = 4
    """How many times at most those that could be the lightest are closed from other numbers, so that what the search
    left is known: one for each of them, until the lead is four times that [-]."""


_SURE = 4.0
"""Lead over the error of the search from which no further start is made [-]."""
_DRAWS = 8
"""Places that are drawn for a start until one can be sized [-]."""
_KEEP = 25
"""Finished architectures after which what is known is written."""
_FAR = 1.75
"""First sizing, complete and with its motor, over the lightest one, up to which it is sized against fatigue [-]."""
_HOPELESS = 2.5
"""The same of the middle of its ranges, over the lightest of the fewest stages, above which it is left at that [-]."""
_ANEW = 3
"""Times as many as are closed get numbers anew, by what they weigh and lack against fatigue [-]."""
_BEHIND = 2.0
"""What one promises over the best promise, above which it gets none: other numbers do not mend so much [-]."""


@dataclass(frozen=True, repr=False)
class Ranking(Shown):
    """Every architecture that can serve a requirement, and what the best weigh once they meet everything."""

    requirement: str
    """Name of the design that asks."""
    life: float
    """Of gears and bearings alike [s]."""
    candidates: tuple[Candidate, ...]
    """Every architecture with its best numbers, the most promising first; those that are refused come last."""
    closed: tuple[EqualLife, ...]
    """The most promising and what they are compared with, closed: those that pass first, the lightest of them first."""
    restarts: int = 0
    """Closings from other numbers of those that could be the lightest [-]."""
    stopped: str = ""
    """Why no more were made; empty where none was asked for."""

    @property
    def refused(self) -> int:
        """How many architectures cannot be sized at all [-]."""
        return sum(bool(row.refused) for row in self.candidates)

    @property
    def passing(self) -> tuple[EqualLife, ...]:
        """Those that pass the review of their written design with all their bearings weighed, the lightest first."""
        return tuple(row for row in self.closed if row.is_compared)

    @property
    def beside(self) -> tuple[EqualLife, ...]:
        """Those that pass of what the architectures are compared with, the lightest first."""
        own = {row.architecture.slug for row in self.candidates}
        return tuple(row for row in self.passing if row.design not in own)

    def called(self, row: EqualLife) -> str:
        """Return a closed design in words: its architecture, or the name of one that is compared with them.

        Args:
            row: Of those that were closed.
        """
        names = {one.architecture.slug: one.architecture.name for one in self.candidates}
        variant = " (variant)" if row.variant else ""
        return f"{names[row.design]}{variant}" if row.design in names else row.title

    @property
    def unborne(self) -> int:
        """How many of those sized against fatigue have planets in which no bearing lives as long as asked [-]."""
        return sum(row.unborne for row in self.candidates)

    @property
    def lead(self) -> Difference | None:
        """By how much the lightest is lighter than the next; None where fewer than two pass and are comparable."""
        return None if len(self.passing) < 2 else difference(*self.passing[:2])


@dataclass(frozen=True)
class Kept:
    """What a journal holds."""

    asked: str
    """Digest of everything that moves a result."""
    candidates: Mapping[str, Candidate]
    closed: Mapping[str, tuple[EqualLife, ...]]


@verb
def architectures(
    design: Design,
    *,
    life: float,
    stages: Sequence[int] = STAGES,
    effort: Effort | None = None,
    beside: Mapping[str, Design] | None = None,
    fastest: float | None = None,
    workers: int = 0,
    journal: Path | None = None,
    tell: Callable[[str], None] | None = None,
) -> Ranking:
    """Return every train of a few stages that can take the place of a design's own, ranked at equal life.

    Each architecture gets the ratios and the motor's speed with which it weighs least as a first sizing. Those that are
    not far from the lightest are sized against fatigue, with everything but bearings of shafts in their mass, by which
    the lightest of them get other numbers, and then those bearings. The most promising are closed: every free size is
    chosen, and every shaft put into bearings, so that an independent review of the written design passes.
    The answer does not depend on how many workers there are.

    Args:
        design: Whose turbine, motor, propeller, cases and rules count; its stages do not.
        life: Of gears and bearings alike [s].
        stages: How many stages a train may have.
        effort: How many architectures are closed, and how often anew; left out: `Effort()`.
        beside: Name -> design, closed for the same life to compare with.
        fastest: Speed that the motor may have [rad/s]; left out: that of the faster of motor and turbine.
        workers: Processes that compute; 0: this one.
        journal: File that keeps what is finished; one that is there is gone on with.
        tell: Called with what is being done.

    Raises:
        DesignError: If the design asks for other machines, or a number cannot be; if the journal is of something else.
    """
    much = effort or Effort()
    refuse(_problems(life, stages, much, workers))
    asked = requirement_of(with_public_motors(design), fastest=fastest)
    rivals = {name: with_public_motors(one) for name, one in (beside or {}).items()}
    counts, motor = tuple(sorted(set(stages))), asked.motor is not None
    every = list(trains(asked.ratio, stages=counts, motor=motor, added=asked.added))
    if not every:
        message = (
            f"no train of {' or '.join(map(str, stages))} stages gives a ratio of {asked.ratio:.4g}; ask for others"
        )
        refuse([Problem("stages", message)], design.name)
    kept = _begun(journal, _digest(asked, life, rivals))
    say = tell or _quiet
    with _keeping(journal, kept) as book:
        say(f"{len(every)} architectures for a ratio of {asked.ratio:.4g}")
        anew = max(much.closed, CLOSED) * _ANEW if much.closed else 0  # the same order, however few are closed
        task = _Task(asked, life, workers, say, book)
        rows = _ranked(task, every, anew)
        best = [row for row in rows if row.design is not None][: much.closed]
        wanted = {row.architecture.slug: row.design for row in best if row.design is not None} | rivals
        open_ones = [named for named in wanted.items() if named[0] not in book.closed]
        open_ones.sort(key=lambda named: -len(named[1].stages))  # the longest first: no process waits
        for name, lives in computed(partial(_closed, life=life), open_ones, workers):
            book.lived(name[0], 0, lives)
            say(f"{name[0]}: {_said(lives)}")
        starts, stopped = _restarted(task, best, wanted, much.restarts)
    return Ranking(design.name, life, tuple(rows), tuple(_ended(book, starts)), sum(starts.values()), stopped)


def _problems(life: float, stages: Sequence[int], effort: Effort, workers: int) -> Iterator[Problem]:
    """Yield what cannot be asked for."""
    if not 0.0 < life < math.inf:
        yield Problem("life", f"{life / 3600.0:g} h is asked; it must be above 0 and finite")
    if not stages or any(count not in range(1, 5) for count in stages):
        yield Problem("stages", f"{list(stages)} are asked; 1 to 4 are enumerated, such as 2 and 3")
    if effort.closed < 0:
        yield Problem("closed", f"{effort.closed} are asked; give 0 or more")
    if effort.restarts < 0:
        yield Problem("restarts", f"{effort.restarts} are asked; give 0 or more")
    if workers < 0:
        yield Problem("workers", f"{workers} are asked; 0 computes in this process")


def _quiet(_: str) -> None:
    """Say nothing."""


@dataclass(frozen=True)
class _Task:
    """What architectures are sized for, and by what."""

    asked: Requirement
    life: float
    workers: int
    say: Callable[[str], None]
    book: _Book

    def run(self, function: Callable[[T], Candidate], things: Sequence[T], how: str) -> None:
        """Take in what a function makes of architectures, as they come."""
        for number, (_, row) in enumerate(computed(function, things, self.workers), start=1):
            self.book.sized(row)
            if number % _KEEP == 0 or number == len(things):
                self.say(f"{number} of {len(things)} sized {how}")


def _ranked(task: _Task, every: Sequence[Architecture], anew: int) -> list[Candidate]:
    """Return all architectures, the most promising first: sketched, those near the lightest rated, the best anew."""
    known = task.book.candidates
    fewest = min(one.stages for one in every)
    simple = [one for one in every if one.stages == fewest]
    how = "as first sizings"
    task.run(partial(sketched, task.asked), [one for one in simple if one.slug not in known], how)
    most = _HOPELESS * min((known[one.slug].first_complete or math.inf for one in simple), default=math.inf)
    longer = [one for one in every if one.stages > fewest and one.slug not in known]
    task.run(partial(sketched, task.asked, most=most), longer, how)
    near = [row for row in _near([known[one.slug] for one in every]) if row.design is None]
    task.run(partial(rated, task.asked, life=task.life), near, "against fatigue")
    light = [row for row in _light([known[one.slug] for one in every], anew) if not row.proportioned]
    task.run(partial(proportioned, task.asked, life=task.life), light, "anew by what they weigh and lack there")
    bare = [row for row in _light([known[one.slug] for one in every], anew) if row.bare is None]
    task.run(weighed, bare, "with bearings on their shafts")
    return sorted((known[one.slug] for one in every), key=lambda row: row.order)


def _near(rows: Sequence[Candidate]) -> list[Candidate]:
    """Return the architectures whose first sizing is not far heavier than the lightest."""
    masses = {row.architecture.slug: row.first_complete for row in rows if row.first_complete and not row.refused}
    most = _FAR * min(masses.values(), default=0.0)
    return [row for row in rows if masses.get(row.architecture.slug, math.inf) <= most]


def _light(rows: Sequence[Candidate], count: int) -> list[Candidate]:
    """Return the lightest of the architectures that were sized against fatigue, but for those that lack too much."""
    known = [row for row in rows if row.rated_mass is not None]
    by_name = sorted(known, key=lambda row: row.architecture.slug)
    lightest = smallest_first(by_name, lambda row: row.rated_mass or 0.0)[:count]
    most = _BEHIND * min((row.rated_promise or math.inf for row in known), default=0.0)
    return [row for row in lightest if (row.rated_promise or math.inf) <= most]


def _closed(named: tuple[str, Design], *, life: float) -> tuple[EqualLife, ...]:
    """Return a design closed for a life, and its nearest variant where it does not close itself."""
    return equal_life(dict([named]), wishes=Wishes(life))


def _start(name: str, number: int) -> str:
    """Return under which name a journal keeps a start of a design: its own alone for the first."""
    return f"{name} from start {number}" if number else name


def _ended(book: _Book, starts: Mapping[str, int]) -> list[EqualLife]:
    """Return closed designs in their order, of those with several starts the best with what all of them came to."""
    return sorted((row for name in starts for row in _of_starts(book, name, starts[name])), key=lambda row: row.order)


def _of_starts(book: _Book, name: str, count: int) -> tuple[EqualLife, ...]:
    """Return the rows of a design: of all starts the best itself, and the variant of the first."""
    (own, *variants), found = book.closed[name], list[EqualLife]()
    for number in range(1, count + 1):
        found += [row for row in book.closed[_start(name, number)] if not row.variant]
    if not found:
        return own, *variants
    masses = tuple(row.with_machines for row in (own, *found) if row.is_compared and row.with_machines is not None)
    return replace(min(own, *found, key=lambda row: row.order), starts=masses), *variants


def _restarted(task: _Task, rows: Sequence[Candidate], names: Iterable[str], most: int) -> tuple[dict[str, int], str]:
    """Close those that could be the lightest from other numbers, a round at a time.

    Rounds are the same with any number of workers, and with what a journal holds already.

    Returns:
        How many further starts each has, and why there are no more.
    """
    free = {row.architecture.slug: row for row in rows if freedoms(row.architecture)}
    starts, left = dict.fromkeys(names, 0), most
    again = partial(_closed_anew, requirement=task.asked, life=task.life)
    while most:
        passing = [row for row in _ended(task.book, starts) if row.is_compared]
        rivals = _rivals(passing, free)
        if not rivals:
            return starts, "none that passes has other numbers to start from"
        lead = difference(*passing[:2]) if len(passing) > 1 else None
        if lead is not None and lead.search is not None and lead.mass >= _SURE * lead.search:
            return starts, f"the lead is {_SURE:.0f} times what the search may have left"
        if not left:
            return starts, "no more were asked for"
        fewest = min(starts[name] for name in rivals)
        chosen = [name for name in rivals if starts[name] == fewest][:left]
        open_ones = [(free[name], fewest + 1) for name in chosen if _start(name, fewest + 1) not in task.book.closed]
        for (row, number), lives in computed(again, open_ones, task.workers):
            task.book.lived(row.architecture.slug, number, lives)
            task.say(f"{row.architecture.slug}, from other numbers: {_said(lives) if lives else 'not sized'}")
        starts, left = starts | dict.fromkeys(chosen, fewest + 1), left - len(chosen)
    return starts, ""


def _rivals(passing: Sequence[EqualLife], free: Mapping[str, Candidate]) -> list[str]:
    """Return which architectures could be the lightest: the lead, the next, and all that are not separable from it."""
    found = []
    for place, row in enumerate(passing):
        apart = difference(passing[0], row)
        if row.design in free and not row.variant and (place < 2 or (apart is not None and not apart.separable)):
            found.append(row.design)
    return found


@MESHES.sharing()
def _closed_anew(start: tuple[Candidate, int], *, requirement: Requirement, life: float) -> tuple[EqualLife, ...]:
    """Return an architecture closed from other numbers, drawn over their ranges; none where none can be sized."""
    row, number = start
    seed = int(sha256(f"{row.architecture.slug} {number}".encode()).hexdigest()[:16], 16)
    for places in np.random.default_rng(seed).random((_DRAWS, freedoms(row.architecture))).tolist():
        try:
            found = _rated(requirement, row, places, life)
        except GearwrightError:
            continue
        best = proportioned(requirement, found, life=life)
        assert best.design is not None
        return _closed((row.architecture.slug, best.design), life=life)
    return ()


def _said(rows: Sequence[EqualLife]) -> str:
    best = rows[0]
    mass = "no gearbox" if best.with_machines is None else f"{best.with_machines:.0f} kg with machines"
    return f"{mass}, {best.verdict}{f' ({best.variant})' if best.variant else ''}"


def _digest(asked: Requirement, life: float, beside: Mapping[str, Design]) -> str:
    """Return the digest of everything that moves a result, but for how many are looked at."""
    stated = [one.model_dump_json(by_alias=True, exclude_unset=True) for one in (asked.design, *beside.values())]
    return sha256(json.dumps([__version__, life, asked.fastest, list(beside), stated]).encode()).hexdigest()


def _begun(journal: Path | None, asked: str) -> Kept:
    """Return what a journal holds already, or refuse one of something else."""
    if journal is None or not journal.exists():
        return Kept(asked, {}, {})
    kept = load(journal)
    if not isinstance(kept, Kept) or kept.asked != asked:
        fix = "name another file, or take this one away"
        refuse([Problem("journal", f"{journal} was begun with another design, life, version or comparison; {fix}")])
    assert isinstance(kept, Kept)
    return kept


class _Book:
    """What is finished, and where it is kept."""

    def __init__(self, journal: Path | None, kept: Kept) -> None:
        self.journal, self.asked = journal, kept.asked
        self.candidates, self.closed = dict(kept.candidates), dict(kept.closed)
        self.unwritten = 0

    def sized(self, row: Candidate) -> None:
        """Take in an architecture."""
        self.candidates[row.architecture.slug] = row
        self.unwritten += 1
        if self.unwritten >= _KEEP:
            self.write()

    def lived(self, name: str, start: int, rows: tuple[EqualLife, ...]) -> None:
        """Take in a closed design, from its own numbers (0) or from others."""
        self.closed[_start(name, start)] = tuple(replace(row, design=name) for row in rows)
        self.unwritten += 1
        self.write()

    def write(self) -> None:
        """Write what is not written yet."""
        if self.journal is not None and self.unwritten:
            save(Kept(self.asked, self.candidates, self.closed), self.journal)
            self.unwritten = 0


@contextmanager
def _keeping(journal: Path | None, kept: Kept) -> Iterator[_Book]:
    """Keep what is finished when all is done, and when it is broken off."""
    book = _Book(journal, kept)
    try:
        yield book
    finally:
        book.write()
