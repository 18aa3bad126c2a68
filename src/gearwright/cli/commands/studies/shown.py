"""What a study ends with: its table, what follows from it, the verdict of its designs, and the files asked for."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from gearwright.cli.answers import show_answer, show_rows
from gearwright.cli.terminal.output import show, tell
from gearwright.writing import write_text

if TYPE_CHECKING:
    from gearwright.spec import Design, Study
    from gearwright.study import Table

LISTED = 60
"""Cases that are printed one by one; of more the spread is shown."""


def show_table(
    command: str, table: Table, study: Study | None = None, *, csv: Path | None, json: bool, jsonl: bool
) -> None:
    """Print the table of a study (its spread if it is long, then what follows from it) or JSON; write it as CSV."""
    from gearwright.render.answers.study import study_answer, study_rows
    from gearwright.render.tables.study.variants import study_csv, study_grid, summary_grid

    if jsonl and study is None:
        show_rows(command, study_answer(table), study_rows(table))
    elif jsonl:
        pass  # the rows of a study were printed as they were finished
    elif json:
        show_answer(command, study_answer(table, study))
    else:
        show(study_grid(table) if len(table.rows) <= LISTED else summary_grid(table))
        if study is not None and (study.objectives or study.sampling.method != "grid"):
            _show_answer(study, table)
    if csv is not None:
        write_text(csv, study_csv(table))


def _show_answer(study: Study, table: Table) -> None:
    """Print the front of several objectives, and in sentences what wins, by how much, and how sure that is."""
    from gearwright.render.tables.study.variants import study_grid
    from gearwright.render.words.study import answer
    from gearwright.study.answers import front_table, verdict

    if len(study.objectives) > 1 and verdict(study, table) is None:
        show(study_grid(front_table(study, table)))
    show(*answer(study, table))


def show_reviews(study: Study, table: Table, designs: Mapping[str, Design]) -> None:
    """Print the verdict of the designs with which a study ends.

    Args:
        study: As run.
        table: Its rows.
        designs: Name -> design.
    """
    from gearwright.render.words.headline import headline
    from gearwright.render.words.study import chosen
    from gearwright.study.answers import verdict
    from gearwright.study.cases import reviewed

    for caption, row in chosen(study, table, verdict(study, table)):
        show(f"{caption}: {headline(reviewed(study, designs[row.design], row.inputs)[1])}.")


def refuse_files(csv: Path | None, export: Path | None, *others: Path | None) -> None:
    """Raise before the first case for every file that could not be written after the last one."""
    from gearwright.errors import DesignError, Problem

    folders = {path.parent for path in (csv, *others) if path is not None and not path.parent.is_dir()}
    if folders:
        raise DesignError(
            Problem("", f"there is no folder {folder}; make it, or name another one") for folder in sorted(folders)
        )
    if export is not None:
        from gearwright.study.answers import refuse_export

        refuse_export(export)


def write_files(
    study: Study, table: Table, designs: Mapping[str, Design], *, export: Path | None, report: Path | None
) -> None:
    """Write the table for other programs and the page of a study, where they are asked for."""
    if export is not None:
        from gearwright.study.answers import write_table

        write_table(export, table)
        tell(f"wrote {export}")
    if report is not None:
        from gearwright.render.pages.studies.study import study_page

        write_text(report, study_page(study, table, designs))
        tell(f"wrote {report}")
