"""The verbs that are fed, and how each answers a fuzzed file: with a result, a refusal, or a finding."""

import random
import re
import signal
import traceback
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from types import MappingProxyType
from typing import NamedTuple

from fuzz_files import MODELS, Case, case, corpus
from fuzz_oracles import mute, unsound

from gearwright.dynamics import modes, simulate
from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.motion import default_step
from gearwright.errors import DesignError, SolveError
from gearwright.mission import durability, fly
from gearwright.particulars import particulars
from gearwright.render.answers.design import size_answer
from gearwright.render.answers.flights import fly_answer
from gearwright.render.answers.motion import modes_answer, simulate_answer
from gearwright.render.answers.schema import plain
from gearwright.reviews import review_of
from gearwright.sizing import Sizing, size
from gearwright.spec import parse, parse_mission, parse_study

LONGEST = 20.0
"""Processor time after which a file counts as one that hangs [s]; that of the clock depends on who else is at work."""
SIMULATED, MOST_STEPS = 0.002, 20_000
"""Time that is simulated [s], and most steps: a stiff train is simulated for less."""
FLOWN = MappingProxyType({
    "ec120b-sortie": ("ec120b", "face-gear-split-torque", "off-set", "star"),
    "ec120b-trim": ("ec120b",),
    "equal-power": ("in-line", "mixed-h1", "off-set-h2", "single-planetary", "twin-engine-sprag"),
    "hybrid-reserves": ("in-line-h2",),
    "regional-250nm": ("in-line", "mixed", "star"),
    "regional-aircraft": ("in-line",),
    "rotor-schedule": ("face-gear-split-torque",),
    "strategies": ("in-line-h2",),
    "thesis": ("in-line-h1", "in-line-h2", "mixed-h2", "off-set-h3"),
    "thesis-chapter-4": ("in-line-h2", "mixed-h1", "off-set-h1"),
    "ways-down": ("in-line-h2",),
})  # fmt: skip
"""Shipped mission -> shipped designs that can fly it."""
_ANYWHERE = Path("/nonexistent")
"""Folder of a fuzzed file: what it names beside itself is not there."""


class Hang(BaseException):
    """A file took longer than `LONGEST`; no `except Exception` on the way may keep it."""


class Finding(NamedTuple):
    """What a verb did that no verb may do."""

    signature: str
    """Verb, kind of fault and place: files with the same one share a cause, as a rule."""
    area: str
    """Layer of the package in which it came about."""
    told: str
    """Traceback, or what is wrong with the result."""


def _read(fuzzed: Case) -> object:
    if fuzzed.kind == "design":
        return parse(fuzzed.text, folder=_ANYWHERE)
    if fuzzed.kind == "mission":
        return parse_mission(fuzzed.text)
    return parse_study(fuzzed.text, folder=_ANYWHERE)


def _check(fuzzed: Case) -> object:
    return _sized(fuzzed).checks


def _sized(fuzzed: Case) -> Sizing:
    return size(parse(fuzzed.text, folder=_ANYWHERE))


def _size(fuzzed: Case) -> object:
    sizing = _sized(fuzzed)
    return sizing, plain(size_answer(particulars(sizing)))


def _modes(fuzzed: Case) -> object:
    found = modes(assemble(_sized(fuzzed)))
    return found, plain(modes_answer(found, "rated"))


def _simulate(fuzzed: Case) -> object:
    system = assemble(_sized(fuzzed))
    trace = simulate(system, min(SIMULATED, MOST_STEPS * default_step(system.arrays)))
    return trace, plain(simulate_answer({"rated": trace}))


def _fly(fuzzed: Case) -> object:
    if fuzzed.kind == "mission":
        partner = random.Random(fuzzed.text).choice(FLOWN[fuzzed.base])
        sizing, mission = _shipped_sizing(partner), parse_mission(fuzzed.text)
    else:
        missions = [name for name, designs in FLOWN.items() if fuzzed.base in designs]
        name = random.Random(fuzzed.text).choice(missions or ["ec120b-sortie"])
        sizing, mission = _sized(fuzzed), parse_mission(coarse(corpus("mission")[name]))
    flight = fly(sizing, mission, folder=_ANYWHERE)
    lives = durability(flight)
    return flight, lives, plain(fly_answer(flight, lives, review_of(flight.sizing, flight, lives)))


@cache
def _shipped_sizing(name: str) -> Sizing:
    return size(parse(corpus("design")[name], folder=_ANYWHERE))


def coarse(text: str) -> str:
    """Return a shipped mission with steps of a minute: what it flies through stays."""
    return re.sub(r"^step_s = \d+", "step_s = 60", text, flags=re.MULTILINE)


class Stage(NamedTuple):
    """One verb."""

    verb: Callable[[Case], object]
    kinds: tuple[str, ...] = ("design",)
    """Kinds of files that it takes."""
    damaged: float = 0.1
    """Part of the files whose text is damaged: few of them come further than the reader."""
    wild: float = 0.3
    """Part of the changes of trees that most files do not survive."""


STAGES = MappingProxyType({
    "read": Stage(_read, tuple(MODELS), damaged=0.35, wild=0.6),
    "check": Stage(_check),
    "size": Stage(_size),
    "modes": Stage(_modes, damaged=0.05, wild=0.2),
    "simulate": Stage(_simulate, damaged=0.05, wild=0.2),
    "fly": Stage(_fly, ("mission", "mission", "design"), damaged=0.05, wild=0.2),
})  # fmt: skip


def made(stage: str, seed: int, number: int) -> Case:
    """Return the file that a stage is fed."""
    _, kinds, damaged, wild = STAGES[stage]
    fuzzed = case(seed, number, kinds, damaged=damaged, wild=wild)
    return fuzzed._replace(text=coarse(fuzzed.text)) if stage == "fly" else fuzzed


def fed(stage: str, fuzzed: Case) -> str | Finding:
    """Return "answered", "refused", or the finding.

    Args:
        stage: One of `STAGES`.
        fuzzed: What is fed.
    """
    try:
        with _limited(), warnings.catch_warnings():
            warnings.simplefilter("error")
            result = STAGES[stage].verb(fuzzed)
        faults = sorted(set(unsound(result)))
        if not faults:
            return "answered"
        places = ", ".join(faults)
        return Finding(f"{stage}-unsound-{faults[0]}", "results", places)
    except (DesignError, SolveError) as error:
        fault = mute(error)
        if fault is None:
            return "refused"
        signature = f"{stage}-mute-{re.sub('[0-9]+', 'N', fault)}-{_raised(error)}"
        return Finding(signature, "messages", f"{error!s:.5000}\n{fault}")
    except (Exception, Hang) as error:
        place = _raised(error)
        told = "".join(traceback.format_exception(error, limit=-30))
        return Finding(f"{stage}-{type(error).__name__}-{place}", place.partition("/")[0], told[-20_000:])


def _raised(error: BaseException) -> str:
    """Return the last place of the package on the way to an error."""
    frames = [each for each in traceback.extract_tb(error.__traceback__) if "/gearwright/" in each.filename]
    if not frames:
        return "outside"
    name = frames[-1].filename.rpartition("/gearwright/")[2]
    return f"{name}:{frames[-1].name}"


@contextmanager
def _limited() -> Iterator[None]:
    """Raise `Hang` when the time is over."""
    signal.signal(signal.SIGPROF, _over)
    signal.setitimer(signal.ITIMER_PROF, LONGEST, 1.0)  # again, where a callback swallowed it
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)


def _over(*_: object) -> None:
    raise Hang(f"not done after {LONGEST:g} s")
