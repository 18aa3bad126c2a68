"""One case: design and mission are changed, the verbs that results need are run, and what fails becomes a reason."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING

from gearwright.errors import DesignError, GearwrightError, Problem, refuse
from gearwright.sizing import TEXT, Named, Sizing, asked_results, pick, size
from gearwright.spec import MISSION_PATH, Design, Mission, Study, edited, edited_mission, path_problem, value_at
from gearwright.spec.studies import Value
from gearwright.study.answers import Row
from gearwright.study.cases.sampling import Case

if TYPE_CHECKING:
    from gearwright.mission import Flight
    from gearwright.reviews import Review


def evaluate(
    study: Study, design: Design, case: Case, *, fitted: Callable[[Design], Design] = lambda design: design
) -> Row:
    """Return the row of a case; a case that fails is a row with its reason.

    Args:
        study: Changes, and the results that are asked for.
        design: Where the case starts.
        case: Its inputs.
        fitted: What becomes of the design before it is changed; left out: it stays as it is.
    """
    return row_of(study, case, lambda: results_of(study, fitted(design), case.inputs))


def row_of(study: Study, case: Case, computed: Callable[[], dict[str, Named]]) -> Row:
    """Return the row of a case whose results are computed here; what fails becomes its reason.

    Args:
        study: With the results that are asked for.
        case: Its inputs.
        computed: Returns its results by name.
    """
    try:
        results = computed()
        return Row(case.design, case.inputs, {name: pick(results, name) for name in study.asked})
    except DesignError as error:
        reason = "; ".join(str(problem) for problem in error.problems)
    except GearwrightError as error:
        reason = str(error)
    except (ArithmeticError, LookupError, TypeError, ValueError) as error:  # ours to mend; a night's other cases go on
        reason = f"a fault of gearwright itself, {type(error).__name__}: {error}"
    return Row(case.design, case.inputs, {}, reason)


def split(changes: Mapping[str, Value]) -> tuple[dict[str, Value], dict[str, Value]]:
    """Return the changes of the design and those of the mission, each by its own paths.

    Args:
        changes: Dotted path -> value; those of the mission begin with ``mission.``. Several paths with commas between
            them have the same value.
    """
    changes = {path.strip(): value for paths, value in changes.items() for path in paths.split(",")}
    flight = {path for path in changes if path.startswith(MISSION_PATH)}
    design = {path: value for path, value in changes.items() if path not in flight}
    return design, {path.removeprefix(MISSION_PATH): changes[path] for path in changes if path in flight}


def fixed(study: Study, designs: Mapping[str, Design]) -> Mapping[str, Design]:
    """Return the designs of a study as its cases start from them: with their sizes written, where it is frozen.

    Args:
        study: That says so.
        designs: Name -> design.

    Raises:
        DesignError: If sizes cannot be written.
    """
    if not study.frozen:
        return designs
    from gearwright.closure import as_sized  # what closes is loaded for those who ask for it

    return {name: as_sized(design) for name, design in designs.items()}


def sized(study: Study, design: Design, inputs: Mapping[str, Value]) -> Sizing:
    """Return the sizing of a case, strengthened if the study asks for a life.

    Args:
        study: With its changes.
        design: Where the case starts.
        inputs: Of the case.

    Raises:
        DesignError: If it cannot be had.
        SolveError: If the life is out of reach.
    """
    if study.fly.life is not None:
        return _flight(study, design, inputs)[0]
    return size(edited(design, split({**study.changes, **inputs})[0]))


def reviewed(study: Study, design: Design, inputs: Mapping[str, Value]) -> tuple[Sizing, Review]:
    """Return the sizing of a case and every check of it, with those of its flight where the study flies.

    Args:
        study: With its changes.
        design: Where the case starts.
        inputs: Of the case.

    Raises:
        DesignError: If it cannot be had.
        SolveError: If the life is out of reach.
    """
    from gearwright.reviews import review_of

    (design,) = fixed(study, {"": design}).values()
    if study.flies:
        sizing, flight = _flight(study, design, inputs)
        return sizing, review_of(sizing, flight, life=study.fly.life)
    sizing = sized(study, design, inputs)
    return sizing, review_of(sizing)


def _flight(study: Study, design: Design, inputs: Mapping[str, Value]) -> tuple[Sizing, Flight]:
    """Return the sizing of a case and its flight."""
    from gearwright.study.cases.flight import flown  # what flies is loaded for those who ask for it

    design_changes, mission_changes = split({**study.changes, **inputs})
    if study.mission is None:
        raise DesignError([Problem("fly.mission", "this study has no mission; it names one under [fly]")])
    return flown(edited(design, design_changes), edited_mission(study.mission, mission_changes), study.fly)


def _flown(study: Study, design: Design, inputs: Mapping[str, Value]) -> tuple[Sizing, dict[str, Named]]:
    """Return the sizing of a case, and the results of its flight."""
    from gearwright.study.cases.flight import flight_results

    sizing, flight = _flight(study, design, inputs)
    results = flight_results(flight, study.asked)
    if _asks(study, "review"):
        from gearwright.study.cases.verdicts import review_results

        results |= review_results(sizing, flight, life=study.fly.life)
    return sizing, results


def _asks(study: Study, verb: str) -> bool:
    """Return whether a study asks for a result of a verb."""
    return any(name.partition(".")[0] == verb for name in study.asked)


def results_of(study: Study, design: Design, inputs: Mapping[str, Value]) -> dict[str, Named]:
    """Return the results of every verb that a name asks for.

    Args:
        study: With its changes and what it asks for.
        design: Where the case starts.
        inputs: Of the case.

    Raises:
        DesignError: If the case cannot be sized or flown.
        SolveError: If a computation does not succeed.
    """
    asked = study.asked
    sizing, flights = _flown(study, design, inputs) if study.flies else (sized(study, design, inputs), {})
    results = asked_results(sizing, asked)
    # The compiled kernel takes a second to load: only for those who ask for it.
    if _asks(study, "modes"):
        from gearwright.study.cases.motion import modal_results

        results |= modal_results(sizing)
    if _asks(study, "simulate"):
        from gearwright.study.cases.motion import simulated_results

        results |= simulated_results(sizing, study.simulate)
    if _asks(study, "review") and not study.flies:
        from gearwright.study.cases.verdicts import review_results

        results |= review_results(sizing)
    return results | flights


def refuse_unknown_paths(study: Study, designs: Mapping[str, Design]) -> None:
    """Raise for every path of a study that neither its mission nor any of its designs has.

    Args:
        study: With axes and changes.
        designs: Name -> design.

    Raises:
        DesignError: With the nearest path.
    """
    design_paths, mission_paths = split({**dict.fromkeys(study.axes, 0.0), **study.changes})
    problems_by_path = [[path_problem(design, path) for design in designs.values()] for path in design_paths]
    problems = [unknown[0] for unknown in problems_by_path if all(unknown) and unknown[0] is not None]
    problems += [problem for path in mission_paths if (problem := _mission_problem(study.mission, path)) is not None]
    problems = problems or _result_problems(study, designs)
    refuse(problems, study.name)


def _result_problems(study: Study, designs: Mapping[str, Design]) -> list[Problem]:
    """Return which results the case in the middle of the axes does not have, before a night of cases lacks them."""
    inputs = {path: value_at(path, axis, 0.5) for path, axis in study.axes.items()}
    for design in designs.values():
        try:
            results = results_of(study, design, inputs)
        except GearwrightError:
            continue  # this one cannot be had; another may tell
        return [problem for name in study.asked for problem in _result_problem(study, results, name)]
    return []


def _result_problem(study: Study, results: dict[str, Named], name: str) -> Iterator[Problem]:
    try:
        picked = pick(results, name)
    except DesignError as error:
        yield from error.problems
        return
    if picked.dimension == TEXT and (name in study.objectives or name in study.constraints):
        yield Problem(name, f"{picked.value!r} is a name and no number; ask for it under results")


def _mission_problem(mission: Mission | None, path: str) -> Problem | None:
    """Return why a path has no place in the mission of a study, or None if it has."""
    if mission is None:
        return Problem(f"{MISSION_PATH}{path}", "this study has no mission; it names one under [fly]")
    problem = path_problem(mission, path)
    return problem and Problem(f"{MISSION_PATH}{problem.path}", problem.message)
