"""Answers of studies, of searches for the best designs and of enumerations of architectures."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from gearwright.base import Life, Ratio, Time
from gearwright.enumeration import Ranking
from gearwright.optimum import Binding, Counts, Fit, Optimum
from gearwright.render.answers.schema import named
from gearwright.render.tables.study import ArchitectureRow, rows_of
from gearwright.sizing import Named
from gearwright.spec import Study
from gearwright.spec.studies import RELIABILITY
from gearwright.study import EqualLife, Row, Table
from gearwright.study.answers import ACCURACY, Reduced
from gearwright.study.architectures import Difference
from gearwright.study.journal import Status
from gearwright.study.reliability import Reliability, reliability

# ----------------------------------------------------------------------------------------------------------------------
# Answers of studies: a row for every variant, and how far a study is.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class StudyRow:
    """One variant; a line of `--jsonl`."""

    design: str
    inputs: Mapping[str, float | int | str | bool]
    """Dotted path, which ends in its unit -> value."""
    results: Mapping[str, float | str]
    """Result with its unit -> value, all digits; empty if the variant is infeasible."""
    problem: str
    """Why the variant is infeasible; empty if it is feasible."""


@dataclass(frozen=True)
class StudyAnswer:
    """A study: designs along axes or over samples."""

    name: str
    description: str
    failed: int | None
    """Infeasible variants; null in the first line of `--jsonl`, which stands before them."""
    reliability: tuple[Reliability, ...]
    """Of every design, where the study asks how likely a constraint is broken."""
    rows: tuple[StudyRow, ...]
    """In the order of the study."""


def study_answer(table: Table, study: Study | None = None) -> StudyAnswer:
    """Return what `gearwright study --json`, `compare --json` and `resume --json` answer.

    Args:
        table: Of the study.
        study: As run; left out: nobody asks how likely constraints are broken.
    """
    asked = study is not None and study.sampling.method in RELIABILITY
    found = reliability(study, table) if study is not None and asked else ()
    return StudyAnswer(table.name, table.description, len(table.failed), found, tuple(study_rows(table)))


def study_rows(table: Table) -> Iterator[StudyRow]:
    """Return a study variant by variant.

    Args:
        table: Of the study.
    """
    return map(study_row, table.rows)


def study_row(row: Row) -> StudyRow:
    """Return one variant of a study.

    Args:
        row: As it was computed.
    """
    return StudyRow(row.design, row.inputs, dict(named(row.results)), row.problem)


@dataclass(frozen=True)
class StatusAnswer:
    """How far a study is."""

    name: str
    done: int
    """Finished cases."""
    total: int
    failed: int
    """Finished cases that are infeasible."""
    running: bool
    rate: float
    """Cases a second."""
    remaining: Time
    """Estimated; null where nothing runs."""


def status_answer(state: Status) -> StatusAnswer:
    """Return what `gearwright status --json` answers.

    Args:
        state: From the journal.
    """
    known = state.recorded
    return StatusAnswer(
        known.study.name, state.done, known.total, state.failed, state.running, state.rate, state.remaining
    )  # fmt: skip


# ----------------------------------------------------------------------------------------------------------------------
# Answer of a study that kept no rows.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class SpreadOf:
    """How one result of one design is spread."""

    design: str
    result: str
    unit: str
    quantiles: Mapping[str, float]
    """Part of the cases, such as 0.05 -> value below which it lies, to the relative accuracy."""


@dataclass(frozen=True)
class ReducedAnswer:
    """A study that kept no rows."""

    name: str
    cases: int
    """Seen."""
    failed: int
    """Of them without a result."""
    accuracy: float
    """Relative, of every quantile."""
    spread: tuple[SpreadOf, ...]
    best: Mapping[str, StudyRow]
    """Number -> case of the Pareto front and of the best of every objective."""
    reasons: Mapping[str, int]
    """Why cases failed -> how many."""


def reduced_answer(reduced: Reduced) -> ReducedAnswer:
    """Return what `gearwright study --json` answers of a study with the table ``reduced``.

    Args:
        reduced: Of the study.
    """
    parts = (0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99)
    spread = tuple(
        SpreadOf(design, result, reduced.unit(result), {
            str(part): reduced.shown(result, value)
            for part, value in zip(parts, reduced.quantiles(design, result, parts), strict=True)
        })
        for design, result, axis in sorted(reduced.counts)
        if not axis
    )  # fmt: skip
    best = {str(number): study_row(row) for number, row in sorted(reduced.best.items())}
    return ReducedAnswer(
        reduced.study.name, reduced.cases, reduced.failed, ACCURACY, spread, best, dict(reduced.reasons.most_common(20))
    )  # fmt: skip


# ----------------------------------------------------------------------------------------------------------------------
# The answer of a search for the best designs.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class FrontRow:
    """A design of the front."""

    design: str
    inputs: Mapping[str, float | int | str | bool]
    """Dotted path, which ends in its unit -> value; of polished ones with their teeth."""
    results: Mapping[str, float | str]
    """Result with its unit -> value."""
    teeth: Mapping[str, tuple[int, ...]]
    """Stage -> teeth of its gears."""
    binds: tuple[Binding, ...]
    """What keeps it from being better, the nearest first."""
    polished: bool
    chosen: bool


@dataclass(frozen=True)
class PriceRow:
    """What a limit costs the chosen design."""

    limit: str
    kind: str
    changes: Mapping[str, float | str]
    """Objective with its unit -> its change for each per cent by which the limit is relaxed."""


@dataclass(frozen=True)
class RegretRow:
    """How a design of the front does where nobody knows what comes."""

    place: int
    """Of the design in the front, from 0."""
    best: Ratio
    """Part of the samples in which it is the best of the front."""
    mean: Ratio
    """Of how much it is worse than the best, over the span of the front."""
    late: Ratio
    """The same, which 95 % of the samples keep."""
    keeps: Ratio
    """Part of the samples in which it keeps every constraint as it was built."""
    low: Mapping[str, float | str]
    """Objective with its unit -> value that 5 % of the samples stay below."""
    high: Mapping[str, float | str]
    """Objective with its unit -> value that 95 % of the samples stay below."""


@dataclass(frozen=True)
class InfluenceRow:
    """What an assumption does to the chosen design."""

    path: str
    low: float
    """16 % quantile, in the unit of the path."""
    high: float
    """84 % quantile."""
    changes: Mapping[str, float | str]
    """Objective with its unit -> its change from low to high."""
    chosen: tuple[int, ...]
    """Designs of the front that would be chosen at either, from 0."""


@dataclass(frozen=True)
class GapRow:
    """How far the best of an objective may lie beyond what independent starts found."""

    best: Mapping[str, float | str]
    """Objective with its unit -> the best of all starts."""
    beyond: Mapping[str, float | str]
    """The same -> by how much better the best there is may be expected to be."""


@dataclass(frozen=True)
class OptimiseAnswer:
    """The best designs of a search."""

    name: str
    counts: Counts
    """What was looked at."""
    growth: tuple[float, ...]
    """Hypervolume of the front after every generation."""
    still: bool
    """Whether the hypervolume stood still; false where the evaluations ran out."""
    front: tuple[FrontRow, ...]
    """The best of the first objective first."""
    prices: tuple[PriceRow, ...]
    regrets: tuple[RegretRow, ...]
    """The chosen one first; empty where nothing is uncertain."""
    influences: tuple[InfluenceRow, ...]
    fits: tuple[Fit, ...]
    """How well surrogates foretell each result that they are not told; empty where none chose the designs."""
    starts: int = 1
    """Independent searches."""
    gaps: tuple[GapRow, ...] = ()
    """Of every objective; empty with one start, which tells nothing of it."""


def optimise_answer(optimum: Optimum) -> OptimiseAnswer:
    """Return what `gearwright optimise --json` answers.

    Args:
        optimum: From `optimise`.
    """
    front = tuple(
        FrontRow(best.row.design, best.inputs, dict(named(best.row.results)), best.teeth, best.binds, best.polished,
                 place == optimum.chosen)
        for place, best in enumerate(optimum.front)
    )  # fmt: skip
    prices = tuple(PriceRow(own.limit, own.kind, _with_units(optimum, own.changes)) for own in optimum.prices)
    regrets = tuple(
        RegretRow(
            own.place, own.best, own.mean, own.late, own.keeps,
            *(_with_units(optimum, {name: ends[k] for name, ends in own.spread.items()}) for k in (0, 1)),
        )
        for own in optimum.regrets
    )  # fmt: skip
    influences = tuple(
        InfluenceRow(own.path, own.low, own.high, _with_units(optimum, own.changes), own.chosen)
        for own in optimum.influences
    )
    return OptimiseAnswer(
        optimum.study.name,
        optimum.counts,
        optimum.growth,
        optimum.still,
        front,
        prices,
        regrets,
        influences,
        optimum.fits,
        optimum.starts,
        tuple(
            GapRow(*(_with_units(optimum, {gap.objective: value}) for value in (gap.best, gap.beyond)))
            for gap in optimum.gaps
        ),
    )


def _with_units(optimum: Optimum, values: Mapping[str, float]) -> dict[str, float | str]:
    """Return objectives with their units in their names."""
    results = optimum.best.row.results
    return dict(named({name: Named(value, results[name].dimension) for name, value in values.items()}))


# ----------------------------------------------------------------------------------------------------------------------
# The answer of an enumeration of architectures.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class ArchitecturesAnswer:
    """Every architecture that can serve a requirement, and the best closed for one life."""

    requirement: str
    life: Life
    """Of gears and bearings alike [s]."""
    count: int
    """Architectures that can give the ratio [-]."""
    refused: int
    """Of them cannot be sized [-]."""
    lead: Difference | None
    """By how much the lightest that passes is lighter than the next; None where fewer than two are comparable."""
    closed: tuple[EqualLife, ...]
    """Closed designs: those that pass first, the lightest first."""
    rows: tuple[ArchitectureRow, ...]
    """Every architecture, the most promising first."""


def architectures_answer(ranking: Ranking) -> ArchitecturesAnswer:
    """Return what `gearwright architectures --json` answers.

    Args:
        ranking: From `architectures`.
    """
    return ArchitecturesAnswer(
        ranking.requirement, ranking.life, len(ranking.candidates), ranking.refused, ranking.lead, ranking.closed,
        tuple(rows_of(ranking.candidates)),
    )  # fmt: skip
