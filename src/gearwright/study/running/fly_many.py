"""The verb: many scattered flights of one design, and how fuel, charge and lives are spread."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from gearwright.errors import Problem, refuse
from gearwright.spec import Axis, Design, Mission, Study
from gearwright.spec.studies import study_problems
from gearwright.study.answers import Table
from gearwright.study.running.runner import Progress, run_study
from gearwright.verbs import verb

USUAL_RESULTS = ("fly.fuel", "fly.battery_energy", "fly.minimum_charge", "fly.duration", "fly.life")
"""What is kept of a flight where nothing is asked."""


@verb
def fly_many(
    design: Design,
    mission: Mission,
    scatter: Mapping[str, Axis | Mapping[str, float | str]],
    count: int,
    *,
    seed: int = 1,
    results: Sequence[str] = USUAL_RESULTS,
    workers: int = 0,
    journal: Path | None = None,
    watch: Callable[[Progress], None] | None = None,
) -> Table:
    """Return the table of scattered flights of a design, a row for each; the same bits with any number of workers.

    Args:
        design: As read; it is sized once, unless the scatter changes it.
        mission: What is flown.
        scatter: Dotted path with unit -> distribution, as the axes of a study; a path of the mission begins with
            ``mission.``, and several paths with commas between them have the same value in every flight.
        count: Flights [-].
        seed: Of the random numbers.
        results: What is kept of each flight, by the names of studies.
        workers: Processes that compute; 0 computes in this one.
        journal: File that keeps every finished flight at once, for `gearwright resume`; left out: nothing is kept.
        watch: Called with the progress each time that flights are finished.

    Raises:
        DesignError: A path that does not exist, a distribution that is none, or every flight fails. One that fails is
            a row with its reason.
    """
    name = design.name
    problems = [Problem("count", f"{count}; fly one at least")] if count < 1 else []
    refuse(problems, "fly_many")
    axes = {path: Axis.model_validate(axis) if isinstance(axis, Mapping) else axis for path, axis in scatter.items()}
    study = Study.model_validate(
        {
            "name": f"{count} flights of {name}",
            "designs": [name],
            "axes": {path: axis.model_dump(by_alias=True, exclude_unset=True) for path, axis in axes.items()},
            "results": list(results),
            "sampling": {"method": "random", "count": count, "seed": seed},
        }
    ).model_copy(update={"mission": mission})
    refuse(study_problems(study), "fly_many")
    return run_study(study, {name: design}, workers=workers, journal=journal, watch=watch)
