"""What a closure is asked and may change, the closed design, and its course: what it looked at, and the best so far."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field
from enum import StrEnum
from functools import cache, cached_property
from operator import itemgetter
from types import MappingProxyType
from typing import TYPE_CHECKING, Annotated, NamedTuple

from gearwright.base import (
    Check,
    GearwrightError,
    Kind,
    Life,
    Mass,
    Origin,
    Problem,
    Quantity,
    Ratio,
    Shown,
    near,
    refuse,
    smallest_first,
    worst,
)
from gearwright.sizing import Sizing, size, size_unturned, trial_of
from gearwright.sizing.mass import CompleteMass, complete_mass
from gearwright.spec import Design, edited
from gearwright.spec.design import RATINGS
from gearwright.spec.edit import Value

if TYPE_CHECKING:
    from gearwright.closure.loop import Settled


# ----------------------------------------------------------------------------------------------------------------------
# What a closure has cost, and over what it searched.
# ----------------------------------------------------------------------------------------------------------------------


KEPT_EVERY = 2.0
"""Time between two writings of a journal [s]."""
Seen = tuple[float, ...]
"""What was found of a change, numbers alone; empty where it cannot be sized."""


@dataclass(frozen=True)
class Effort:
    """What a closure cost, and over what it searched."""

    sizings: int
    """Whole designs that were sized [-]."""
    looked_at: int
    """Changes of a design that were proportioned once [-]."""
    confirmed: int
    """Changes whose dynamic and load factors were settled [-]."""
    taken: int
    """Changes that were made [-]."""
    from_journal: int
    """Answers that a journal had already [-]."""
    starts: int
    """Designs from which the search began: it is local, and one start says nothing of the distance to the best [-]."""
    searched: tuple[str, ...]
    """Freedoms that were searched, in words."""
    not_searched: tuple[str, ...]
    """What could be changed, too, and was not looked at."""


@dataclass
class Course:
    """A closure on its way."""

    known: dict[str, Seen] = field(default_factory=dict)
    """Name of a change of a design -> what was found of it."""
    keep: Callable[[Mapping[str, Seen]], None] | None = None
    """Takes what is known, to be kept in a journal."""
    best: Settled | None = None
    """The best design so far."""
    sizings: int = 0
    looked_at: int = 0
    confirmed: int = 0
    taken: int = 0
    from_journal: int = 0
    starts: int = 0
    searched: dict[str, None] = field(default_factory=dict)
    """Freedoms that were searched, in words."""
    begun: frozenset[str] = frozenset()
    """Names of what a journal knew at the start."""
    kept_at: float = 0.0

    def __post_init__(self) -> None:
        self.begun = frozenset(self.known)

    def seen(self, name: str, found: Callable[[], Seen]) -> Seen:
        """Return what is known of a change, found once; empty where it cannot be sized.

        Args:
            name: Of the change and of the design that it changes.
            found: Finds it.
        """
        if name in self.known:
            self.from_journal += name in self.begun
            return self.known[name]
        try:
            self.known[name] = found()
        except GearwrightError:
            self.known[name] = ()
        if self.keep is not None and time.monotonic() - self.kept_at >= KEPT_EVERY:
            self.keep(self.known)
            self.kept_at = time.monotonic()
        return self.known[name]

    def effort(self, not_searched: tuple[str, ...]) -> Effort:
        """Return what it has cost.

        Args:
            not_searched: What could be changed, too.
        """
        return Effort(
            self.sizings, self.looked_at, self.confirmed, self.taken, self.from_journal, self.starts,
            tuple(self.searched), not_searched,
        )  # fmt: skip


_NOW: ContextVar[Course | None] = ContextVar("course", default=None)


@contextmanager
def under_way(course: Course) -> Iterator[Course]:
    """Let everything within count for a closure.

    Args:
        course: Of it.
    """
    token = _NOW.set(course)
    try:
        yield course
    finally:
        _NOW.reset(token)


def now() -> Course:
    """Return the closure that is on its way; a new one where none is."""
    return _NOW.get() or Course()


def sized(design: Design, *, still: bool = False, among: dict[str, Sizing] | None = None) -> Sizing:
    """Return a sized design, which counts for the closure that is on its way.

    Args:
        design: As `size` takes it.
        still: Whether open axes stay where they stand first, room or not.
        among: Those that were sized so before, by what they state, to which it is added; None: it is sized.

    Raises:
        DesignError: If it cannot be sized.
    """
    stated = "" if among is None else f"{still} {design.model_dump_json(by_alias=True, exclude_unset=True)}"
    if among is not None and stated in among:
        return among[stated]
    now().sizings += 1
    sizing = size_unturned(design) if still else size(design)
    if among is not None:
        among[stated] = sizing
    return sizing


# ----------------------------------------------------------------------------------------------------------------------
# What a closure may change beside modules, widths and bearings, where it is asked to look for something lighter.
# ----------------------------------------------------------------------------------------------------------------------


FREEDOMS: Mapping[str, str] = MappingProxyType({
    "teeth": "tooth numbers of pairs and sets",
    "shifts": "profile shift of pinions and suns",
    "planets": "number of planets, their load factor as the design states it",
    "helix": "helix angle of pairs",
    "material": "steel of the gears, and its grade",
    "rims": "rims of wheels, planets and rings",
    "webs": "webs of pairs",
})  # fmt: skip
"""Name -> what may then be changed, also where the design gives it."""


# ----------------------------------------------------------------------------------------------------------------------
# What a gearbox must meet: every mode that a review can fail, by the requirement that it belongs to.
# ----------------------------------------------------------------------------------------------------------------------


class Requirement(NamedTuple):
    """One requirement."""

    modes: tuple[str, ...]
    """How the modes of its checks begin."""
    kinds: tuple[Kind, ...]
    """Of the parts that it is about; empty: of any."""
    moved_by: str
    """What the closure changes to meet it."""
    helps: str
    """What helps where that does not do."""
    unasked: Mapping[str, Value] = MappingProxyType({})
    """Rules of a design by which nothing is asked, where the sizing itself meets it."""


_GEARS = (Kind.GEAR, Kind.MESH, Kind.STAGE)
REQUIREMENTS: Mapping[str, Requirement] = MappingProxyType({
    "flank": Requirement(
        ("pitting", "contact", "micropitting"), _GEARS, "module and face width of the stage",
        "a better steel or grade, more planets, another split of the ratio, a wider face (widest_diameters)",
    ),
    "root": Requirement(
        ("tooth root", "bending", "yielding root"), _GEARS, "module and face width of the stage",
        "a better steel or grade, more planets, profile shift, a thicker rim",
    ),
    "static strength": Requirement(("static",), _GEARS, "module and face width of the stage", "a smaller limit load"),
    "scuffing": Requirement(
        ("scuffing",), _GEARS, "module and face width of the stage",
        "smaller modules, profile shift that balances sliding, tip relief, an oil of a higher load stage, cooler oil",
    ),
    "teeth": Requirement(
        ("contact ratio", "undercut", "tip thickness", "involute interference", "tip interference", "radial assembly",
         "planets apart", "backlash", "face width", "cutter", "speed of K_V"), _GEARS,
        "tooth numbers, by the search of the sizing; the widest face that its rules allow",
        "other tooth numbers, profile shift, fewer planets, gears.iso6336.widest_diameters",
        MappingProxyType({"gears.iso6336.widest_modules": 60.0, "gears.iso6336.widest_diameters": 3.0}),
    ),
    "rims": Requirement(
        ("rim", "bending of the web", "resonance of the web", "standing wave of the web"), (), "nothing yet",
        "a thicker rim (rim_ratio, rim_thickness_ratio); a thicker or dished web (web_thickness_ratio, web_dish)",
    ),
    "sharing": Requirement(
        ("load sharing",), (), "K_γ of the stage, and with it module and face width",
        "smaller errors, a floating member ([supports]), gears clocked on their shafts, fewer planets",
    ),
    "peaks": Requirement(
        ("peak",), _GEARS, "least K_V of the stage, and with it module and face width",
        "other speeds or teeth, tip relief, more damping",
    ),
    "bearings": Requirement(
        ("", "life", "bearing life", "static safety", "bearing static safety", "room around the pin", "room in the rim",
         "room for its bearing", "room beside the plate", "shaft in its bore"),
        (Kind.BEARING,), "bearings of shafts, by the sizing; what planets turn on, where the design leaves it open",
        "more or lighter planets, plain bearings, a star stage in place of the planetary one, a slower carrier",
    ),
    "room of planets": Requirement(
        ("room for its bearing", "room beside the plate", "pin in its bore"), (Kind.GEAR,), "nothing yet",
        "larger planets, smaller or fewer bearings side by side",
    ),
    "shafts": Requirement(
        ("Tresca", "fatigue", "yield", "limit load", "slope", "first critical speed", "face load"),
        (Kind.SHAFT, Kind.MESH), "diameters, by the sizing", "a stronger shaft material, shorter spans",
        MappingProxyType({"shafting.safety": 1.0}),
    ),
    "carriers": Requirement(
        ("", "pin", "plate"), (Kind.CARRIER,), "pins and plates, by the sizing",
        "fewer or narrower planets, a stronger carrier material",
    ),
    "joints": Requirement((), (Kind.JOINT,), "sizes of keys, splines and fits, by the sizing", "another kind of joint"),
    "critical speeds": Requirement(
        ("resonance of", "resonances", "main resonance"), (), "tooth numbers and modules",
        "other speeds, another split of the ratio, stiffer or softer shafts; a waiver where the peak passes",
    ),
    "room": Requirement(
        ("room", "keep-out", "axes of", "installation envelope"), (), "places of axes, by the sizing",
        "other sides or distances of shafts ([layout])",
    ),
    "housing": Requirement(
        ("shell fatigue", "wall fatigue", "flat wall fatigue", "web fatigue", "collar fatigue", "mount fatigue",
         "arm fatigue"), (), "nothing",
        "a thicker wall ([housing] wall_mm), a stronger material, smaller forces on bearings",
    ),
    "making": Requirement(
        ("assembly", "axial retention", "access", "running clearance", "wheel that grinds", "order along",
         "bridges between planets", "webs of bosses", "ring seat", "plate through its ring", "seal"), (), "nothing",
        "other places of gears and bearings, thinner shafts, more room",
    ),
    "life in flight": Requirement(
        ("pitting life", "bending life"), _GEARS, "module and face width of the stage", "a lighter duty, a better steel"
    ),
    "machines": Requirement((), (Kind.MACHINE, Kind.BATTERY), "nothing", "other machines, speeds or cases"),
    "others": Requirement((), (), "nothing", "see the check"),
})  # fmt: skip
"""Name of a requirement -> what it is about; a check belongs to the first of the most exact mode that covers it."""
STRENGTH = ("flank", "root", "static strength", "scuffing", "life in flight")
"""Those that module and face width of a stage move."""


def requirement_of(check: Check) -> str:
    """Return the name of the requirement that a check belongs to.

    Args:
        check: Any.
    """
    return _requirement(check.mode, check.part.kind)


@cache
def _requirement(mode: str, kind: Kind) -> str:
    best, length = "others", -1
    for name, requirement in REQUIREMENTS.items():
        if requirement.kinds and kind not in requirement.kinds:
            continue
        fitting = [len(own) for own in requirement.modes if mode.startswith(own)]
        fitting += [0] if not requirement.modes and requirement.kinds else []
        if fitting and max(fitting) > length:
            best, length = name, max(fitting)
    return best


def wanted(checks: Iterable[Check], left_out: frozenset[str]) -> list[Check]:
    """Return the checks of the requirements that count.

    Args:
        checks: Any.
        left_out: Names of requirements that do not.
    """
    return [check for check in checks if not left_out or requirement_of(check) not in left_out]


def without(design: Design, left_out: Iterable[str]) -> Design:
    """Return a design whose rules ask nothing of what its sizing would meet by itself.

    Args:
        design: With its rules.
        left_out: Names of requirements that do not count.
    """
    changes = {path: value for name in left_out for path, value in REQUIREMENTS[name].unasked.items()}
    return edited(design, changes) if changes else design


# ----------------------------------------------------------------------------------------------------------------------
# What is asked of a closed gearbox beside what its design says: a life, how sizes are rounded, which way to go.
# ----------------------------------------------------------------------------------------------------------------------


HOUR = 3600.0
"""[s]"""


@dataclass(frozen=True)
class Wishes:
    """What a closure is asked for; what is left out is as the design says."""

    life: float | None = None
    """Life of gears and bearings alike [s]; None: service.life and service.bearing_life of the design."""
    rounded: bool = True
    """Modules of ISO 54 and face widths in whole millimetres, as the rules of the design ask; False: continuous."""
    separate: bool = True
    """Look for teeth and modules that keep critical speeds away from operating ones; False: crossings are listed."""
    lighten: bool = True
    """Look for other teeth, and for what else is free, with which everything is lighter; False: teeth as sized."""
    free: tuple[str, ...] = ()
    """Names of `FREEDOMS`: what is changed, too, while all becomes lighter, also where the design gives it."""
    left_out: frozenset[str] = field(default_factory=frozenset)
    """Requirements that the closure does not look at: to see which of them bind."""

    def __post_init__(self) -> None:
        refuse(self._problems())

    def _problems(self) -> Iterator[Problem]:
        """Yield what cannot be asked for."""
        if self.life is not None and not 0.0 < self.life < math.inf:
            yield Problem("life", f"{self.life / HOUR:g} h is asked; it must be above 0 and finite")
        for name in self.free:
            if name not in FREEDOMS:
                yield Problem("free", f"{name!r} is no freedom; {near(name, FREEDOMS)}")
        for name in sorted(self.left_out - REQUIREMENTS.keys()):
            yield Problem("left_out", f"{name!r} is no requirement; {near(name, REQUIREMENTS)}")


# ----------------------------------------------------------------------------------------------------------------------
# What a closure yields: the written design, its sizing and checks, the rounds to it, and what could not be met.
# ----------------------------------------------------------------------------------------------------------------------


class Outcome(StrEnum):
    """What a closure says."""

    CLOSED = "meets everything that is assessed"
    OPEN = "does not meet everything"


class Step(StrEnum):
    """What is done in a round."""

    PROPORTION = "proportioned"
    CONFIRM = "confirmed"
    BEAR = "bearings of planets"
    SEPARATE = "other teeth or modules"
    LIGHTEN = "made lighter"
    SIMULATE = "simulated"
    FLY = "flown"


@dataclass(frozen=True)
class Round:
    """One step of the loop."""

    step: Step
    mass: Mass
    """Of gears, shafts and carriers after it [kg]."""
    margin: Ratio
    """Of the worst check that it looked at [-]."""
    change: Ratio
    """Largest relative change of a dynamic factor since the round before [-]."""
    what: str
    """In words."""


@dataclass(frozen=True)
class Unmet:
    """A requirement that nothing meets over which the closure searched."""

    requirement: str
    """Its name."""
    check: Check
    """The best that was found."""
    kept: str
    """What the design gives and the closure therefore does not change; empty where nothing."""
    helps: str
    """What would help."""
    searched: str
    """Over what it was looked for."""


@dataclass(frozen=True)
class StageLife:
    """How long the gears of a stage live at the safeties that are asked."""

    stage: str
    life: Annotated[
        Life,
        Origin(
            "largest life at which the safeties against fatigue are met", "the rating of the stage, Miner, ISO 6336-6"
        ),
    ]
    """[s]"""
    governs: str
    """Check that ends it."""


@dataclass(frozen=True, repr=False)
class Closed(Shown):
    """A gearbox that meets everything, or says what it does not meet."""

    design: Design
    """With every freedom written: what `gearwright review` judges."""
    sizing: Sizing
    """Of it."""
    checks: tuple[Check, ...]
    """Everything that was looked at, worst first."""
    rounds: tuple[Round, ...]
    unmet: tuple[Unmet, ...]
    lives: tuple[StageLife, ...]
    """Of the stages whose method knows one, the shortest first."""
    kept: tuple[str, ...]
    """Paths of what the design gives and the closure does not change."""
    wishes: Wishes
    effort: Effort
    """What it cost, and over what it searched."""
    text: str
    """The closed design as TOML, from which it was read again before it was judged."""
    changes_nothing: bool = False
    """Whether the text is that of the file that was closed."""

    @property
    def outcome(self) -> Outcome:
        """One word for all of it."""
        return Outcome.OPEN if self.unmet else Outcome.CLOSED

    @property
    def life(self) -> Annotated[float | None, Quantity("life")]:
        """Life of the gears that fail first, at the asked safeties [s]; None where no method knows one."""
        return self.lives[0].life if self.lives else None

    @property
    def worst(self) -> Check | None:
        """The check that every page shows."""
        return worst(self.checks)

    @property
    def mass(self) -> Mass:
        """Of gears, shafts and carriers [kg]."""
        return self.sizing.mass

    @cached_property
    def whole(self) -> CompleteMass:
        """Everything in the gearbox, housing, bearings and oil included, with its band."""
        return complete_mass(self.sizing)


# ----------------------------------------------------------------------------------------------------------------------
# How long the gears of a closed design live at the safeties that are asked.
# ----------------------------------------------------------------------------------------------------------------------


LONGEST = 1e6 * HOUR
"""Above it a life is told as this one [s]."""
SHORTEST = 0.1 * HOUR
"""Below it a life is told as this one [s]."""
FATIGUE = ("pitting", "tooth root")
"""Modes that a life ends: cycles wear out flanks and roots, while scuffing, films and limit loads know no hours."""
CLOSE = 1e-3
"""Relative width of the bracket in which a life is found [-]."""


def stage_lives(sizing: Sizing, left_out: frozenset[str] = frozenset()) -> tuple[StageLife, ...]:
    """Return the largest life of every stage at which its safeties against fatigue are met, the shortest first.

    Args:
        sizing: As sized.
        left_out: Requirements that do not count.
    """
    stages = [name for name in sizing.design.simple_stages if RATINGS[sizing.design.rating(name)].fatigue]
    lives = [_life(sizing, stage, left_out) for stage in stages]
    return tuple(smallest_first(lives, lambda row: row.life))


def _life(sizing: Sizing, stage: str, left_out: frozenset[str]) -> StageLife:
    """Return the life of one stage: a bracket around it, then by halving its logarithm."""
    low = high = sizing.design.service.life
    margin, governs = _margin(sizing, stage, high, left_out)
    while margin >= 1.0 and high < LONGEST:
        low, high = high, 2.0 * high
        margin, governs = _margin(sizing, stage, high, left_out)
    while low == high and margin < 1.0 and low > SHORTEST:
        low = 0.5 * low
        margin, name = _margin(sizing, stage, low, left_out)
        low, high, governs = (low, 2.0 * low, governs) if margin >= 1.0 else (low, low, name)
    while high / low - 1.0 > CLOSE:
        middle = math.sqrt(low * high)
        margin, name = _margin(sizing, stage, middle, left_out)
        low, high, governs = (middle, high, governs) if margin >= 1.0 else (low, middle, name)
    return StageLife(stage, max(low, SHORTEST), governs)


def _margin(sizing: Sizing, stage: str, life: float, left_out: frozenset[str]) -> tuple[float, str]:
    """Return the least margin against fatigue of a stage that lives so long [-], and the name of its check."""
    design = edited(sizing.design, {"service.life_h": life / HOUR})
    mesh = next(mesh for mesh in sizing.meshes if mesh.stage == stage)
    gear = next(gear for gear in sizing.gears if gear.name == mesh.gears[0])
    checks = trial_of(design, sizing).checks(stage, gear.module, gear.face_width)
    fatigue = [check for check in checks if check.mode in FATIGUE and requirement_of(check) not in left_out]
    reserves = [(check.reserve, check.name) for check in fatigue if check.reserve is not None]
    return min(reserves, default=(math.inf, ""), key=itemgetter(0))
