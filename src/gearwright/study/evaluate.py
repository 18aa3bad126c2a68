"""One case: the design is changed, the verbs that its results need are run, and what fails becomes a reason."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from gearwright.errors import DesignError, GearwrightError
from gearwright.sizing import size
from gearwright.sizing.named import Named, named_results, pick, total_results
from gearwright.spec import Design
from gearwright.spec.edit import edited, path_problem
from gearwright.spec.study import Study
from gearwright.study.sampling import Case
from gearwright.study.table import Row


def evaluate(study: Study, design: Design, case: Case) -> Row:
    """Return the row of a case; a case that fails is a row with its reason.

    Args:
        study: Changes, and the results that are asked for.
        design: Where the case starts.
        case: Its inputs.
    """
    try:
        results = _results(study, edited(design, {**study.changes, **case.inputs}))
        return Row(case.design, case.inputs, {name: pick(results, name) for name in study.asked})
    except DesignError as error:
        reason = "; ".join(str(problem) for problem in error.problems)
    except GearwrightError as error:
        reason = str(error)
    except (ArithmeticError, LookupError, TypeError, ValueError) as error:  # ours to mend; a night's other cases go on
        reason = f"a fault of gearwright itself, {type(error).__name__}: {error}"
    return Row(case.design, case.inputs, {}, reason)


def _results(study: Study, design: Design) -> dict[str, Named]:
    """Return the results of every verb that a name asks for."""
    verbs = {name.partition(".")[0] for name in study.asked}
    sizing = size(design)
    results = total_results(sizing)
    if not results.keys() >= set(study.asked):
        results = named_results(sizing)
    if verbs & {"modes", "simulate"}:  # the compiled kernel takes a second to load: only for those who ask for it
        from gearwright.study.motion import modal_results, simulated_results
    if "modes" in verbs:
        results |= modal_results(sizing)
    if "simulate" in verbs:
        results |= simulated_results(sizing, study.simulate)
    return results


def refuse_unknown_paths(study: Study, designs: Mapping[str, Design]) -> None:
    """Raise for every path of a study that none of its designs has.

    Args:
        study: With axes and changes.
        designs: Name -> design.

    Raises:
        DesignError: With the nearest path.
    """
    paths: Iterable[str] = [*study.axes, *study.changes]
    found = [[path_problem(design, path) for design in designs.values()] for path in paths]
    problems = [each[0] for each in found if all(each) and each[0] is not None]
    if problems:
        raise DesignError(problems, study.name)
