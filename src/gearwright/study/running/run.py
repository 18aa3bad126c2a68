"""Run a small study here and now."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

from gearwright.errors import DesignError, Problem
from gearwright.shipped import find_design
from gearwright.spec import Design, Study, case_count, read
from gearwright.spec.studies import RELIABILITY
from gearwright.study.answers import Row, Table
from gearwright.study.cases import Case, cases, fixed
from gearwright.study.running.reliable import failures
from gearwright.study.running.search import generations
from gearwright.study.running.workers import local
from gearwright.verbs import verb


@verb
def run(
    study: Study,
    designs: Mapping[str, Design] | None = None,
    *,
    workers: int = 0,
    folder: Path | None = None,
    progress: Callable[[float], None] | None = None,
) -> Table:
    """Return the table of a study; the same bits with any number of workers.

    Args:
        study: Axes, changes and results.
        designs: Name -> design, for every name in the study; left out: read by their names.
        workers: Processes that compute; 0 computes in this one.
        folder: Of the study, where files that it names are; left out: where the program runs.
        progress: Called with the fraction done, from 0 to 1.

    Raises:
        DesignError: If there are too many cases, or all of them fail. A variant that fails is a row with its reason.
        SolveError: If no worker starts.
    """
    refuse_search(study)
    count, rows = case_count(study), dict[int, Row]()
    if designs is None:
        designs = {name: read(find_design(name, folder)) for name in study.designs}

    with local(study, fixed(study, designs), workers) as compute:
        for batch, answer in batches(study):
            first = len(rows)
            for finished in compute(batch, count):
                rows.update(finished)
                if progress is not None:
                    progress(len(rows) / count)
            answer([rows[number] for number in range(first, len(rows))])
    return table_of(study, [rows[number] for number in range(len(rows))])


def refuse_search(study: Study) -> None:
    """Raise where a study has no cases to run, because it looks for the best.

    Args:
        study: As read.

    Raises:
        DesignError: If it has a table ``search``.
    """
    if study.search is not None:
        message = "this study looks for the best: `gearwright optimise` runs it; take [search] away to run its cases"
        raise DesignError([Problem("search", message)])


def batches(study: Study) -> Iterator[tuple[Iterator[Case], Callable[[list[Row]], None]]]:
    """Yield batches of cases, each with the function that takes its rows: one batch, or a search's generations.

    Args:
        study: Axes and method.
    """
    if not study.searches:
        yield cases(study), lambda rows: None
        return
    search = failures(study) if study.sampling.method in RELIABILITY else generations(study)
    batch = next(search, None)
    while batch is not None:
        answers: list[Row] = []
        yield iter(batch), answers.extend
        try:
            batch = search.send(answers)
        except StopIteration:
            batch = None


def table_of(study: Study, rows: list[Row]) -> Table:
    """Return the table of rows.

    Args:
        study: That they belong to.
        rows: In the order of the cases.

    Raises:
        DesignError: If all of them failed.
    """
    if rows and all(row.problem for row in rows):
        first = {row.design: row.problem for row in reversed(rows)}
        named = len(first) > 1
        raise DesignError(
            [
                Problem(design if named else "", f"every case failed, the first with {reason}")
                for design, reason in reversed(first.items())
            ],
            study.name,
        )
    return Table(study.name, study.description, study.asked, tuple(rows), tied=study.sampling.method == "list")
