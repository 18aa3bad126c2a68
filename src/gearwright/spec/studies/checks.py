"""What does not fit together in a study, and how many cases it has."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gearwright.errors import DesignError, Problem, refuse
from gearwright.spec.flying import mission_problems
from gearwright.spec.studies.axis import axis_length, axis_problems
from gearwright.spec.studies.search import search_problems
from gearwright.spec.studies.study import MISSION_PATH, MOST_REDUCED, RELIABILITY, Study

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
