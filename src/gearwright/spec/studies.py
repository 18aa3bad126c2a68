"""Study and mission mix files: designs, axes, searches, their checks and their reader.

What is computed of them is in `study` and `mission/lives`.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from statistics import NormalDist
from typing import Any, Literal, cast

from pydantic import Field, ValidationInfo, field_validator

from gearwright.base import DesignError, Problem, Ratio, Shown, Time, excerpt, refuse, verb
from gearwright.files import beside
from gearwright.shipped import find_mission, find_mix, find_study, shipped_missions, shipped_mixes
from gearwright.spec.edit import edited_mission
from gearwright.spec.missions import BearingLifeRules, Mission
from gearwright.spec.read import file_text, is_map_file, mission_problems, placed, read_mission, toml_tables
from gearwright.spec.record import Record, build, today

# ----------------------------------------------------------------------------------------------------------------------
# One axis of a study: a list of values, equal steps, a range, or a distribution.
# ----------------------------------------------------------------------------------------------------------------------


Value = float | int | str | bool
MOST_VALUES = 1_000_000
"""Values of one axis of equal steps [-]."""


class Axis(Record):
    """The values that one entry takes: a list, equal steps, a range, or a distribution."""

    values: list[Value] | None = Field(None, min_length=1, description="The values themselves")
    first: int | float | None = Field(None, alias="from", description="First value of equal steps, or of a range")
    last: int | float | None = Field(None, alias="to", description="Last value of equal steps, or of a range")
    step: int | float | None = Field(None, gt=0, description="Step between values; left out: a range for samples")
    distribution: Literal["uniform", "log-uniform", "triangular", "normal"] = Field(
        "uniform", description="How samples are spread: over the range, or normally about the mean"
    )
    likeliest: float | None = Field(None, description="Likeliest value of a triangular distribution")
    mean: float | None = Field(None, description="Mean of a normal distribution")
    deviation: float | None = Field(None, gt=0, description="Standard deviation of a normal distribution")


def axis_values(path: str, axis: Axis) -> list[Value]:
    """Return the values of an axis.

    Args:
        path: Of the entry, for messages.
        axis: As written.

    Raises:
        DesignError: If neither a list nor first, last and step are given, or they do not go together.
    """
    return [_value(axis, k) for k in range(axis_length(path, axis))]


def _value(axis: Axis, k: int) -> Value:
    """Return the k-th value of a list or of equal steps."""
    return axis.values[k] if axis.values is not None else (axis.first or 0) + (axis.step or 0) * k


def axis_length(path: str, axis: Axis) -> int:
    """Return the number of values of an axis.

    Args:
        path: Of the entry, for messages.
        axis: As written.

    Raises:
        DesignError: As `axis_values`.
    """
    if axis.values is not None:
        return len(axis.values)
    if axis.first is None or axis.last is None or axis.step is None:
        message = 'give a list of values, or all of from, to and step; a range needs [sampling] method = "sobol"'
        raise DesignError([Problem(f"axes.{path}", message)])
    steps = (axis.last - axis.first) / axis.step
    if steps == 0:
        message = f"from {axis.first:g} to {axis.last:g} there is no length; a single value belongs under [changes]"
        raise DesignError([Problem(f"axes.{path}", message)])
    if steps < 0 or not math.isfinite(steps):
        message = f"there is nothing from {axis.first:g} up to {axis.last:g}; exchange them"
        raise DesignError([Problem(f"axes.{path}", message)])
    if steps >= MOST_VALUES:
        message = f"{math.floor(steps) + 1:,} values; at most {MOST_VALUES:,} are taken: make the step larger"
        raise DesignError([Problem(f"axes.{path}.step", message)])
    return math.floor(steps + 1e-9) + 1


def axis_problems(path: str, axis: Axis, *, sampled: bool) -> list[Problem]:
    """Return what is wrong with an axis.

    Args:
        path: Of the entry, for messages.
        axis: As written.
        sampled: True if places of the unit interval are drawn, False if every value is taken.
    """
    if axis.values is not None and (axis.first, axis.last, axis.step, axis.mean) != (None, None, None, None):
        return [Problem(f"axes.{path}", "values and a range are given; keep one of them")]
    try:
        if sampled:
            value_at(path, axis, 0.5)
        else:
            axis_length(path, axis)
    except DesignError as error:
        return list(error.problems)
    return []


def value_at(path: str, axis: Axis, place: float) -> Value:
    """Return the value of an axis at a place of the unit interval, by its inverse distribution.

    Args:
        path: Of the entry, for messages.
        axis: As written; of a list or of equal steps every value is as likely.
        place: From 0 to 1 [-].

    Raises:
        DesignError: If what the distribution needs is not given.

    >>> value_at("a", Axis.model_validate({"from": 10, "to": 20}), 0.25)
    12.5
    """
    if axis.distribution == "normal":
        if axis.mean is None or axis.deviation is None:
            raise DesignError([Problem(f"axes.{path}", "a normal distribution needs mean and deviation")])
        inside = min(max(place, sys.float_info.min), 1.0 - 2.0**-53)
        return NormalDist(axis.mean, axis.deviation).inv_cdf(inside)
    if axis.values is not None or axis.step is not None:
        length = axis_length(path, axis)
        return _value(axis, min(int(place * length), length - 1))
    return _in_range(path, axis, place)


def _in_range(path: str, axis: Axis, place: float) -> float:
    if axis.first is None or axis.last is None:
        raise DesignError([Problem(f"axes.{path}", "give a list of values, from and to, or a normal distribution")])
    low, high = float(axis.first), float(axis.last)
    if low >= high:
        message = f"there is nothing between {low:g} and {high:g}; from must be below to (a single value: [changes])"
        raise DesignError([Problem(f"axes.{path}", message)])
    if axis.distribution == "log-uniform":
        if low <= 0.0:
            raise DesignError([Problem(f"axes.{path}.from", f"{low:g} has no logarithm; give a value above 0")])
        return low * math.exp(place * math.log(high / low))
    if axis.distribution == "triangular":
        peak = (low + high) / 2.0 if axis.likeliest is None else axis.likeliest
        if not low <= peak <= high:
            raise DesignError([Problem(f"axes.{path}.likeliest", f"{peak:g} is not between {low:g} and {high:g}")])
        left = (peak - low) / (high - low)
        if place < left:
            return low + math.sqrt(place * (high - low) * (peak - low))
        return high - math.sqrt((1.0 - place) * (high - low) * (high - peak))
    return low + (high - low) * place


# ----------------------------------------------------------------------------------------------------------------------
# The table ``[search]`` of a study: how the best designs along its axes are looked for.
# ----------------------------------------------------------------------------------------------------------------------


MOST = 10_000_000
"""Designs of one search at most [-]."""
GUIDED = 1000
"""Designs of a search with a surrogate at most [-]: its processes take the cube of their number."""


class Search(Record):
    """A search in layers: points that fill the axes, generations on the best of them, each found design polished."""

    screened: int = Field(
        16384, ge=0, le=1_000_000, description="Designs of the first layer, Sobol' points over all axes, of each design"
    )
    population: int = Field(256, ge=8, le=10_000, description="Designs of one generation")
    evaluations: int = Field(
        25_600, ge=1, le=1_000_000, description="Designs of generations and polish together, at most"
    )
    still: int = Field(8, ge=1, le=10_000, description="Generations without growth of the hypervolume that end them")
    growth: Ratio = Field(1e-3, ge=0, le=1, description="Growth of the hypervolume that counts, over itself")
    polished: int = Field(32, ge=0, le=200, description="Designs of the front whose teeth are kept and sizes polished")
    samples: int = Field(256, ge=8, le=65_536, description="Of what is uncertain, for the regret")
    surrogate: bool = Field(
        False, description="Gaussian processes choose the designs of generations: for results that take seconds"
    )
    seed: int = Field(1, ge=0, description="Start of the random numbers: the same seed, the same answer")


def search_problems(
    search: Search | None, axes: Mapping[str, Axis], objectives: Mapping[str, Any], uncertain: Mapping[str, Axis]
) -> list[Problem]:
    """Return what a search lacks, and what is given for one that is not there.

    Args:
        search: As written.
        axes: What it may change.
        objectives: What it wants.
        uncertain: What nobody knows.
    """
    if search is None:
        return [Problem("uncertain", "only a search reads it; write [search], too")] if uncertain else []
    problems = []
    if search.surrogate and search.evaluations > GUIDED:
        message = f"{search.evaluations} designs; a surrogate is for {GUIDED} at most: write less, such as 100"
        problems.append(Problem("search.evaluations", message))
    if not axes:
        problems.append(Problem("axes", "a search has nothing to vary; give a range or a list"))
    if not objectives:
        problems.append(Problem("objectives", 'a search needs at least one: [objectives] mass = "minimum"'))
    for path in uncertain.keys() & axes.keys():
        problems.append(Problem(f"uncertain.{path}", "is an axis, too: the search chooses it; keep one of them"))
    for path, axis in uncertain.items():
        problems += [
            Problem(f"uncertain.{path}", problem.message) for problem in axis_problems(path, axis, sampled=True)
        ]
    return problems


# ----------------------------------------------------------------------------------------------------------------------
# The study file: designs and a mission, axes over dotted paths of them, and the results that are asked for.
# ----------------------------------------------------------------------------------------------------------------------


MOST_REDUCED = 1_000_000_000
"""Cases of a study that keeps no rows."""
MISSION_PATH, FLY_RESULT = "mission.", "fly."
"""How paths into the mission and the results of its flight begin."""
Method = Literal["grid", "list", "random", "sobol", "latin-hypercube", "saltelli", "nsga2", "form", "subset"]
RELIABILITY = ("form", "subset")
"""Methods that find how likely it is that a constraint is broken."""


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

    case: str | None = Field(None, description="Load case; left out: the governing one, of least margin")
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


# ----------------------------------------------------------------------------------------------------------------------
# What does not fit together in a study, and how many cases it has.
# ----------------------------------------------------------------------------------------------------------------------


MOST_CASES = 10_000_000
"""More cases than this are refused: at 1 ms each they would take three hours of one core, at 10 ms more than a day."""
MOST_SAMPLES = 1_000_000
"""Largest number of samples that are drawn at once."""
MOST_STEPS = 20
"""Steps in which ``form`` looks for the likeliest failure of one limit [-]."""
TRIED_STEPS = 8
"""Lengths of a step that ``form`` tries at once [-]."""
SCATTERED = 64
"""Points among which ``form`` looks for a second start [-]."""
LEAST_SAMPLES = 100
"""Samples of a level of ``subset``: a tenth of them starts the next one [-]."""


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


# ----------------------------------------------------------------------------------------------------------------------
# Study files and the missions that they name, made a study that needs no file from then on.
# ----------------------------------------------------------------------------------------------------------------------


MAP_PATH = f"{MISSION_PATH}propeller_map"


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


# ----------------------------------------------------------------------------------------------------------------------
# The mix file: missions by name or path, how often each is flown, and how many flights a life has.
# ----------------------------------------------------------------------------------------------------------------------


MOST_FLIGHTS = 100_000_000
"""Flights of a life [-]: no gearbox makes a thousand a day for two hundred years."""
WHOLE = 1e-6
"""By how much the shares of a file may miss 1: what is left of thirds with six digits [-]."""


class MixedMission(Record):
    """One mission of a mix: how often it is flown, and what differs from its file."""

    mission: str = Field(description="Mission file, or name of a shipped mission")
    share: Ratio | None = Field(None, gt=0, le=1, description="Part of all flights; the sum of a mix is 1")
    count: int | None = Field(
        None, ge=1, le=MOST_FLIGHTS, description="Flights of the life, instead of a share; all missions alike"
    )
    changes: dict[str, Value] = Field(
        default_factory=dict, description="Dotted path of the mission, with unit -> value, such as a shorter cruise"
    )


class MixFile(Record):
    """Several missions that one gearbox flies in its life."""

    schema_version: Literal[1] = Field(1, alias="schema", description="Version of this file format")
    name: str = Field(description="Name of the mix")
    description: str = Field("", description="Whose life it is, and what of it is assumed")
    flights: int | None = Field(
        None, ge=1, le=MOST_FLIGHTS, description="Of the whole life; left out: the sum of all counts"
    )
    missions: dict[str, MixedMission] = Field(min_length=1, description="Missions by a name of one's own")
    bearings: BearingLifeRules | None = Field(
        None, description="Chosen from the catalogue where the design names none; left out: as each mission says"
    )


@dataclass(frozen=True, repr=False)
class Mix(Shown):
    """Missions that one gearbox flies in its life, read and ready to fly."""

    name: str
    description: str
    flights: int
    """Of the whole life [-]."""
    missions: Mapping[str, Mission]
    """By their names in the mix."""
    shares: Mapping[str, float]
    """Mission -> part of all flights, with sum 1 [-]."""

    def count(self, mission: str) -> float:
        """Return how often a mission is flown [-].

        Args:
            mission: By its name in the mix.
        """
        return self.shares[mission] * self.flights


@verb
def read_mix(path: str | Path) -> Mix:
    """Return the mix that a file describes, with the missions that it names.

    Args:
        path: A TOML file, or the name of a shipped mix; a file of that name comes first.

    Raises:
        DesignError: With every problem of the file: shares that do not add up to 1, missions that are not there.
    """
    file = find_mix(str(path))
    return parse_mix(file_text(file), source=str(path), folder=file.parent)


def parse_mix(text: str, *, source: str = "", folder: Path | None = None) -> Mix:
    """Return the mix that a TOML text describes, with the missions that it names.

    Args:
        text: The file's content.
        source: Name of the file, for messages.
        folder: Where mission files are looked for; left out: where the program runs.

    Raises:
        DesignError: With every problem of the text.
    """
    tables = toml_tables(text, source)
    if "phases" in tables and "missions" not in tables:
        message = f"this is a mission; gearwright fly DESIGN {source or 'FILE'} flies it, and a mix names it"
        raise DesignError([Problem("phases", message)], source)
    record, written = build(MixFile, tables)
    problems, missions = list(written.problems), dict[str, Mission]()
    if record is not None and not problems:
        file = cast(MixFile, record)
        problems += _problems(file)
        for name, entry in file.missions.items():
            try:
                missions[name] = _mission(file, entry, folder or Path())
            except DesignError as error:
                problems += _said(name, entry, error)
    if problems:
        raise DesignError(placed(problems, text), source)
    return _mix(cast(MixFile, record), missions)


def _mix(file: MixFile, missions: Mapping[str, Mission]) -> Mix:
    parts = {name: entry.share or float(entry.count or 0) for name, entry in file.missions.items()}
    whole = sum(parts.values())
    flights = file.flights or round(whole)
    shares = {name: part / whole for name, part in parts.items()}
    return Mix(file.name, file.description, flights, missions, shares)


def _problems(file: MixFile) -> Iterator[Problem]:
    """Yield what does not fit together in shares and counts."""
    entries = file.missions
    for name, entry in entries.items():
        if (entry.share is None) == (entry.count is None):
            given = "neither is" if entry.share is None else "both are"
            yield Problem(f"missions.{name}", f"{given} given; give share, a part of all flights, or count")
    shares = [entry.share for entry in entries.values() if entry.share is not None]
    counts = [entry.count for entry in entries.values() if entry.count is not None]
    if shares and counts:
        yield Problem("missions", "some have a share and some a count; give all of them the same")
    elif shares and abs(sum(shares) - 1.0) > WHOLE:
        yield Problem("missions", f"their shares add up to {sum(shares):g}; they have to add up to 1")
    elif shares and file.flights is None:
        yield Problem("flights", "is required beside shares; write how many flights the life has, such as 30000")
    elif counts and file.flights not in (None, sum(counts)):
        message = f"{file.flights} flights, and counts of {sum(counts)}; leave flights out, or change the counts"
        yield Problem("flights", message)


def _mission(file: MixFile, entry: MixedMission, folder: Path) -> Mission:
    """Return a mission as the mix flies it, whose map and deck are found from anywhere on this machine."""
    if entry.mission in shipped_mixes() and entry.mission not in shipped_missions():
        raise _mix_in_mix(entry.mission)
    path = find_mission(entry.mission, folder, key="")
    tables = toml_tables(file_text(path), str(path))
    if "missions" in tables and "phases" not in tables:
        raise _mix_in_mix(entry.mission)
    mission = edited_mission(read_mission(path), entry.changes) if entry.changes else read_mission(path)
    update: dict[str, object] = {} if file.bearings is None else {"bearings": file.bearings}
    if is_map_file(mission.propeller_map):
        update["propeller_map"] = str(beside(mission.propeller_map, path.parent, "propeller_map").resolve())
    if mission.engine.deck is not None:
        found = str(beside(mission.engine.deck, path.parent, "engine.deck").resolve())
        update["engine"] = mission.engine.model_copy(update={"deck": found})
    return mission.model_copy(update=update)


def _mix_in_mix(name: str) -> DesignError:
    message = f"{excerpt(name)!r} is a mix itself; a mix is made of missions: name those of it, with their shares"
    return DesignError([Problem("", message)])


def _said(name: str, entry: MixedMission, error: DesignError) -> Iterator[Problem]:
    """Yield what is wrong with a mission, at its place in the mix."""
    for problem in error.problems:
        changed = next((path for path in entry.changes if problem.path == path), None)
        at = f"missions.{name}.mission" if changed is None else f"missions.{name}.changes.{changed}"
        told = (error.source, problem.path if problem.path not in ("name", changed) else "", problem.message)
        yield Problem(at, ": ".join(filter(None, told)))
