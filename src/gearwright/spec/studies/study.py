"""The study file: designs and a mission, axes over dotted paths of them, and the results that are asked for."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, Literal, cast

from pydantic import Field, ValidationInfo, field_validator

from gearwright.errors import DesignError, Problem, refuse
from gearwright.reading import beside
from gearwright.shipped import find_mission, find_study
from gearwright.showing import Shown
from gearwright.spec.flying import is_map_file, mission_problems, read_mission
from gearwright.spec.former import today
from gearwright.spec.missions import Mission
from gearwright.spec.read import file_text, placed, toml_tables
from gearwright.spec.record import Record, build
from gearwright.spec.studies.axis import Axis, Value, axis_length, axis_problems
from gearwright.spec.studies.search import Search, search_problems
from gearwright.units import Time
from gearwright.verbs import verb

MOST_CASES = 10_000_000
"""More cases than this are refused: at 1 ms each they would take three hours of one core, at 10 ms more than a day."""
MOST_REDUCED = 1_000_000_000
"""Cases of a study that keeps no rows."""
MOST_SAMPLES = 1_000_000
"""Largest number of samples that are drawn at once."""
MISSION_PATH, FLY_RESULT = "mission.", "fly."
"""How paths into the mission and the results of its flight begin."""
MAP_PATH = f"{MISSION_PATH}propeller_map"
Method = Literal["grid", "list", "random", "sobol", "latin-hypercube", "saltelli", "nsga2", "form", "subset"]
RELIABILITY = ("form", "subset")
"""Methods that find how likely it is that a constraint is broken."""
MOST_STEPS = 20
"""Steps in which ``form`` looks for the likeliest failure of one limit [-]."""
TRIED_STEPS = 8
"""Lengths of a step that ``form`` tries at once [-]."""
SCATTERED = 64
"""Points among which ``form`` looks for a second start [-]."""
LEAST_SAMPLES = 100
"""Samples of a level of ``subset``: a tenth of them starts the next one [-]."""


class Sampling(Record):
    """How cases are taken from the axes."""

    method: Method = Field("grid", description="grid: every combination; list: the k-th values of all axes together")
    count: int | None = Field(
        None, ge=1, le=MOST_REDUCED, description="Samples of each design; evaluations of nsga2, form and subset"
    )
    seed: int = Field(1, ge=0, description="Start of the random numbers: the same seed, the same cases")
    population: int = Field(
        40, ge=4, le=10_000, description="Designs of one generation of nsga2, samples of one level of subset"
    )


class Bound(Record):
    """What a result must keep, in the unit in which tables show it."""

    minimum: float | None = Field(None, description="Smallest value allowed")
    maximum: float | None = Field(None, description="Largest value allowed")


class Simulated(Record):
    """How the results named ``simulate.…`` are had."""

    case: str | None = Field(None, description="Load case; left out: the design's first one, or 'rated'")
    duration: Time = Field(0.05, gt=0, le=1000, description="Simulated time; its last three quarters are looked at")


class Flown(Record):
    """How the results named ``fly.…`` are had."""

    mission: str | None = Field(None, description="Mission file, or name of a shipped mission")
    life: Time | None = Field(
        None, gt=0, le=3.6e9, description="Gears are strengthened until all live so long; left out: as sized"
    )


class Reduction(Record):
    """What a study keeps instead of its rows."""

    best: int = Field(20, ge=1, le=1000, description="Rows of the best cases that are kept, of every objective")


class Study(Shown, Record):
    """Designs varied along axes, with results by name."""

    schema_version: Literal[1] = Field(1, alias="schema", description="Version of this file format")
    name: str = Field(description="Name of the study")
    description: str = Field("", description="What it answers")
    designs: list[str] = Field(min_length=1, description="Design files, or names of shipped designs")
    axes: dict[str, Axis] = Field(
        default_factory=dict, description="Dotted path with unit, of the design or into its mission.… -> values"
    )
    changes: dict[str, Value] = Field(default_factory=dict, description="Dotted path with unit -> value, for all cases")
    frozen: bool = Field(
        False, description="Sizes stay those of each design as it is: axes and changes meet the finished gearbox"
    )
    results: list[str] = Field(default_factory=lambda: ["mass"], min_length=1, description="Results by name")
    sampling: Sampling = Field(default_factory=Sampling, description="How cases are taken from the axes")
    objectives: dict[str, Literal["minimum", "maximum"]] = Field(
        default_factory=dict, description="Result -> whether its minimum or its maximum is wanted"
    )
    constraints: dict[str, Bound] = Field(default_factory=dict, description="Result -> what it must keep")
    simulate: Simulated = Field(default_factory=Simulated, description="How results named simulate.… are had")
    fly: Flown = Field(default_factory=Flown, description="How results named fly.… are had")
    reduced: Reduction | None = Field(
        None, description="Given: no rows are kept, only how results are spread, along which axis, and the best cases"
    )
    search: Search | None = Field(None, description="How `gearwright optimise` looks for the best along the axes")
    uncertain: dict[str, Axis] = Field(
        default_factory=dict, description="Dotted path -> distribution of what nobody knows, for [search]'s regret"
    )
    mission: Mission | None = Field(None, description="What is flown, if it is written here and is no file of its own")

    @field_validator("axes", "uncertain", "changes", "results", "objectives", "constraints", mode="before")
    @classmethod
    def _in_words_of_today(cls, entries: Any, info: ValidationInfo) -> Any:
        """Read paths and results by their former names, too."""
        place = info.field_name or ""
        if isinstance(entries, list):
            return [today(entry, place) if isinstance(entry, str) else entry for entry in entries]
        if not isinstance(entries, Mapping):
            return entries
        renamed = {today(path, place): entry for path, entry in entries.items()}
        if place != "objectives":
            return renamed
        return {path: today(entry, f"{place}.{path}") if isinstance(entry, str) else entry
                for path, entry in renamed.items()}  # fmt: skip

    @property
    def asked(self) -> tuple[str, ...]:
        """Every result that a case computes: those asked for, then those of objectives and constraints."""
        return tuple(dict.fromkeys([*self.results, *self.objectives, *self.constraints]))

    @property
    def searches(self) -> bool:
        """True if its cases follow from the results of earlier ones."""
        return self.search is not None or self.sampling.method in ("nsga2", *RELIABILITY)

    @property
    def flies(self) -> bool:
        """True if a case needs the flight: a result of it is asked for, or a life of the gears."""
        return self.fly.life is not None or any(name.startswith(FLY_RESULT) for name in self.asked)


def study_problems(study: Study) -> list[Problem]:
    """Return what does not fit together in a study.

    Args:
        study: Typed, but not yet checked.
    """
    sampled = study.sampling.method not in ("grid", "list")
    sampled = sampled or study.search is not None
    problems = [problem for path, axis in study.axes.items() for problem in axis_problems(path, axis, sampled=sampled)]
    problems += search_problems(study.search, study.axes, study.objectives, study.uncertain)
    if study.fly.mission is not None and study.mission is not None:
        problems.append(Problem("fly.mission", "there is a [mission] as well; keep one of them"))
    if study.mission is not None:
        problems += [
            Problem(f"{MISSION_PATH}{problem.path}", problem.message) for problem in mission_problems(study.mission)
        ]
    try:
        if not problems:
            case_count(study)
    except DesignError as error:
        return list(error.problems)
    return problems


def case_count(study: Study) -> int:
    """Return the number of cases of a study.

    Args:
        study: As read.

    Raises:
        DesignError: If there are more than can be run, or what the method needs is not given.
    """
    if study.search is not None:
        return len(study.designs) * study.search.screened + study.search.evaluations
    count = _sampled(study) if study.sampling.method == "nsga2" else len(study.designs) * _each(study)
    most = MOST_CASES if study.reduced is None else MOST_REDUCED
    if count > most:
        message = (
            f"{count:,} cases; at most {most:,} are run: take larger steps or fewer axes, or draw samples of"
            ' them: [sampling] method = "sobol", count = 4096'
        )
        raise DesignError([Problem("axes", message)])
    return count


def _each(study: Study) -> int:
    """Return the number of cases of each design."""
    match study.sampling.method:
        case "grid":
            return math.prod(axis_length(path, axis) for path, axis in study.axes.items())
        case "list":
            lengths = {path: axis_length(path, axis) for path, axis in study.axes.items()}
            if len(set(lengths.values())) > 1:
                written = ", ".join(f"{path}: {length}" for path, length in lengths.items())
                raise DesignError([Problem("axes", f"a list needs axes of equal length; these have {written}")])
            return max(lengths.values(), default=1)
        case "saltelli":
            return _sampled(study) * (len(study.axes) + 2)
        case _:
            return _sampled(study)


def _sampled(study: Study) -> int:
    sampling = study.sampling
    if sampling.count is None:
        message = f"{sampling.method!r} draws samples: say how many, such as count = 1024"
        raise DesignError([Problem("sampling.count", message)])
    streamed = study.reduced is not None and sampling.method == "random"
    if sampling.count > MOST_SAMPLES and not streamed:
        message = (
            f"{sampling.count:,} are drawn at once; at most {MOST_SAMPLES:,} are, beside [reduced] more by 'random'"
        )
        raise DesignError([Problem("sampling.count", message)])
    if study.reduced is not None and study.searches:
        message = (
            f"{sampling.method!r} goes on from its rows, and none are kept; take another method, or [reduced] away"
        )
        raise DesignError([Problem("reduced", message)])
    if sampling.method == "saltelli" and len(study.axes) < 2:
        raise DesignError([Problem("axes", "'saltelli' compares the influences of axes; give two or more")])
    if sampling.method == "saltelli" and sampling.count & (sampling.count - 1):
        message = (
            f"{sampling.count} is no power of two, which Sobol' points need; take {1 << sampling.count.bit_length()}"
        )
        raise DesignError([Problem("sampling.count", message)])
    if sampling.method == "nsga2" and not study.objectives:
        message = 'a search needs at least one: [objectives] mass = "minimum"'
        raise DesignError([Problem("objectives", message)])
    if sampling.method in RELIABILITY:
        refuse(list(_reliability_problems(study, sampling.count)))
    if not study.axes and not (sampling.method == "nsga2" and len(study.designs) > 1):
        raise DesignError([Problem("axes", f"{sampling.method!r} has nothing to vary; give an axis")])
    return sampling.count


def _reliability_problems(study: Study, count: int) -> Iterator[Problem]:
    """Yield what a study lacks to find how likely it is that a constraint is broken."""
    method, size, axes = study.sampling.method, study.sampling.population, len(study.axes)
    limits = sum(bound is not None for limit in study.constraints.values() for bound in (limit.minimum, limit.maximum))
    if not limits:
        yield Problem("constraints", f"{method!r} needs what must not be broken: worst_margin = {{minimum = 1.0}}")
        return
    if method == "subset" and (not LEAST_SAMPLES <= size <= count // limits or size % 10):
        message = f"{size} samples of a level; give a multiple of 10 from {LEAST_SAMPLES} to {count // limits}"
        message += ", or a larger count: each limit has an equal share of it"
        yield Problem("sampling.population", message)
    if method != "form":
        return
    search = 2 * axes + MOST_STEPS * (2 * axes + TRIED_STEPS)
    least = 2 * axes + 3 + SCATTERED + 2 * limits * search
    if count < least:
        message = f"{count} is too few: {axes} axes and {limits} limits may take {least:,} before anything is drawn"
        yield Problem("sampling.count", f"{message}; give so many or more")
    for path, axis in study.axes.items():
        if axis.values is not None or axis.step is not None:
            message = "'form' follows gradients, and a list or equal steps have none"
            yield Problem(f"axes.{path}", f'{message}; give a range or a distribution, or take method = "subset"')


@verb
def read_study(path: str | Path) -> Study:
    """Return the study that a file describes, with the mission that it names.

    Args:
        path: A TOML file, or the name of a shipped study; a file of that name comes first.

    Raises:
        DesignError: With every problem of the file.
    """
    file = find_study(str(path))
    return parse_study(file_text(file), source=str(path), folder=file.parent)


def parse_study(text: str, *, source: str = "", folder: Path | None = None) -> Study:
    """Return the study that a TOML text describes, with the mission that it names.

    Args:
        text: The file's content.
        source: Name of the file, for messages.
        folder: Where a mission file is looked for; left out: where the program runs.

    Raises:
        DesignError: With every problem of the text.
    """
    record, written = build(Study, toml_tables(text, source))
    problems = list(written.problems) or study_problems(cast(Study, record))
    if problems:
        raise DesignError(placed(problems, text), source)
    return with_mission(cast(Study, record), folder or Path())


def with_mission(study: Study, folder: Path) -> Study:
    """Return a study that holds the mission that it names, so that it needs no file from then on.

    Args:
        study: As written.
        folder: Where a mission file is looked for.

    Raises:
        DesignError: If a mission is needed and none is given, or the one that is named cannot be read.
    """
    if study.fly.mission is not None:
        study = study.model_copy(update={"mission": _mission_of(study.fly.mission, folder)})
    elif study.mission is not None:
        study = study.model_copy(update={"mission": _with_map(study.mission, folder)})
    paths = [f"axes.{path}" for path in study.axes if path.startswith(MISSION_PATH)]
    paths += [f"changes.{path}" for path in study.changes if path.startswith(MISSION_PATH)]
    if study.mission is None and (study.flies or paths):
        message = 'nothing says what is flown; write [fly] mission = "thesis", or another mission file'
        raise DesignError([Problem(paths[0] if paths else "fly.mission", message)])
    return _with_maps(study, folder)


def mission_changed(study: Study, folder: Path) -> bool:
    """Tell whether the mission file that a study names, if it is still there, says something else now.

    Args:
        study: With the mission as it was.
        folder: Where the file is looked for.
    """
    if study.fly.mission is None or not find_mission(study.fly.mission, folder).is_file():
        return False
    return _mission_of(study.fly.mission, folder) != study.mission


def _mission_of(name: str, folder: Path) -> Mission:
    path = find_mission(name, folder)
    return _with_map(read_mission(path), path.parent)


def _with_map(mission: Mission, folder: Path) -> Mission:
    """Return a mission whose propeller map and engine deck, where files, are found from anywhere on this machine."""
    update: dict[str, object] = {"propeller_map": _map_from(mission.propeller_map, folder, "mission.propeller_map")}
    if mission.engine.deck is not None:
        deck = str(beside(mission.engine.deck, folder, "mission.engine.deck").resolve())
        update["engine"] = mission.engine.model_copy(update={"deck": deck})
    return mission.model_copy(update=update)


def _with_maps(study: Study, folder: Path) -> Study:
    """Return a study whose other propeller maps, too, which it varies, are found from anywhere on this machine."""
    changes, axes = dict(study.changes), dict(study.axes)
    if MAP_PATH in changes:
        changes[MAP_PATH] = _map_from(changes[MAP_PATH], folder, f"changes.{MAP_PATH}")
    if MAP_PATH in axes and axes[MAP_PATH].values is not None:
        values = [_map_from(value, folder, f"axes.{MAP_PATH}") for value in axes[MAP_PATH].values or []]
        axes[MAP_PATH] = axes[MAP_PATH].model_copy(update={"values": values})
    return study.model_copy(update={"changes": changes, "axes": axes})


def _map_from(name: Value, folder: Path, key: str) -> Value:
    if not isinstance(name, str) or not is_map_file(name):
        return name
    return str(beside(name, folder, key).resolve())
