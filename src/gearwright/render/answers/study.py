"""Answers of studies: a row for every variant, and how far a study is."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from gearwright.render.answers.plain import named
from gearwright.spec import Study
from gearwright.spec.studies import RELIABILITY
from gearwright.study import Row, Table
from gearwright.study.journal.journal import Status
from gearwright.study.running import Reliability, reliability
from gearwright.units import Time


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
