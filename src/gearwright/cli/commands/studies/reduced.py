"""What ``study`` and ``merge`` do with studies that keep no rows."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from gearwright.cli.answers import show_answer
from gearwright.cli.terminal.output import show

if TYPE_CHECKING:
    from gearwright.spec import Design, Study
    from gearwright.study.answers import Reduced
    from gearwright.study.running import Start


def study_reduced(
    study: Study, designs: Mapping[str, Design], *, state: Path | None, workers: int | None, start: Start,
    shard: str | None, json: bool, refused: Mapping[str, bool],
) -> None:  # fmt: skip
    """Run a study that keeps no rows, and show what is left of it.

    Args:
        study: With the table ``reduced``.
        designs: Name -> design.
        state: File that keeps it; one that is there is continued.
        workers: Processes; left out: all cores.
        start: What holds them.
        shard: Part of the study.
        json: Whether the answer is JSON.
        refused: Option that needs rows -> whether it was given.
    """
    from gearwright.cli.commands.studies.running import part_given, stopped_cleanly, watched, workers_for
    from gearwright.errors import DesignError, Problem
    from gearwright.spec import case_count
    from gearwright.study.running import reduce_study

    problems = [
        Problem(option, "needs rows, and a study with [reduced] keeps none; take [reduced] out, or the option away")
        for option, given in refused.items()
        if given
    ]
    if problems:
        raise DesignError(problems)
    part = part_given(shard, state)
    count = workers_for(workers, len(part.cases(case_count(study))))
    again = f"gearwright study … --journal {state}" if state is not None else ""
    with stopped_cleanly(state, again), watched(None) as watch:
        found = reduce_study(study, designs, workers=count, state=state, watch=watch, start=start, part=part)
    show_reduced(found, json=json)


def show_reduced(found: Reduced, *, json: bool) -> None:
    """Print what is left of a study, as tables or as JSON.

    Args:
        found: Of the study.
        json: Whether the answer is JSON.
    """
    if json:
        from gearwright.render.answers.reduced import reduced_answer

        show_answer("study reduced", reduced_answer(found))
        return
    from gearwright.render.tables.study.reduced import reduced_grids

    show(*reduced_grids(found))
