"""Cases of a study: sampling plans, NSGA-II, and evaluation of one case or of a batch.

Which answers they give together is in `answers`, how thousands are run in `running`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from functools import cache, partial
from itertools import product, takewhile
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from gearwright.base import Bools, DesignError, Floats, GearwrightError, Ints, Problem, refuse
from gearwright.memo import Memo
from gearwright.signals import heard_after
from gearwright.sizing import TEXT, Named, Sizing, asked_results, in_lanes, pick, size
from gearwright.spec import (
    MISSION_PATH,
    Design,
    Mission,
    Study,
    Value,
    axis_values,
    case_count,
    edited,
    edited_mission,
    path_problem,
    value_at,
)
from gearwright.study.tables import Blocks, Row, block_of_columns, blocks_of, crowding, ranks, violations, wanted

if TYPE_CHECKING:
    from gearwright.mission import Flight
    from gearwright.reviews import Review


# ----------------------------------------------------------------------------------------------------------------------
# Cases of a study: every combination, lists, and samples drawn from ranges and distributions.
#
# A case's number and inputs follow from the study alone, never from who computes it or when: the same seed gives the
# same cases, bit for bit, with any number of workers.
# ----------------------------------------------------------------------------------------------------------------------


DRAWN = 1 << 16
"""Independent draws that are held at once [-]."""


class Case(NamedTuple):
    """One variant of one design."""

    number: int
    """Place in the study, from 0."""
    design: str
    """Design that is varied."""
    inputs: dict[str, Value]
    """Dotted path with unit -> value."""


def cases(study: Study) -> Iterator[Case]:
    """Yield every case of a study: designs outermost, of a grid the last axis fastest.

    Args:
        study: With any method but ``nsga2``, whose cases follow from earlier results.

    Raises:
        DesignError: If axes and method do not go together, or there are too many cases.
    """
    case_count(study)
    paths, number = list(study.axes), 0
    for name in study.designs:
        for values in _values(study):
            yield Case(number, name, dict(zip(paths, values, strict=True)))
            number += 1


def _values(study: Study) -> Iterator[tuple[Value, ...]]:
    """Yield the values of all axes for every case of one design."""
    if study.sampling.method in ("grid", "list"):
        columns = [axis_values(path, axis) for path, axis in study.axes.items()]
        if study.sampling.method == "grid":
            yield from product(*columns)
        else:
            yield from zip(*columns, strict=True) if columns else iter([()])
        return
    axes = list(study.axes.items())
    for row in _rows(study):
        yield tuple(value_at(path, axis, float(place)) for (path, axis), place in zip(axes, row, strict=True))


def _rows(study: Study) -> Iterator[Floats]:
    """Yield the rows of the sample; independent draws a part at a time, of which there may be a thousand millions."""
    if study.sampling.method != "random":
        yield from unit_sample(study)
        return
    generator, left = np.random.default_rng(study.sampling.seed), study.sampling.count or 0
    while left:
        yield from generator.random((min(left, DRAWN), len(study.axes)))
        left -= min(left, DRAWN)


def unit_sample(study: Study) -> Floats:
    """Return the sample of a study in the unit cube, shape (cases of one design, axes).

    Args:
        study: With a method that draws samples.

    Source: Sobol' points with Owen's scrambling and Latin hypercubes of scipy.stats.qmc; for ``saltelli`` the blocks
        A, B and A with each column of B in turn (Saltelli et al. 2010, Comput. Phys. Commun. 181, 259-270).
    """
    method, count, axes = study.sampling.method, study.sampling.count or 0, len(study.axes)
    generator = np.random.default_rng(study.sampling.seed)
    if method == "random":
        return generator.random((count, axes))
    if method == "latin-hypercube":
        from scipy.stats import qmc  # half a second to load: only for those who draw by it

        return np.asarray(qmc.LatinHypercube(axes, rng=generator).random(count))
    if method == "sobol":
        return _sobol(count, axes, generator)
    both = _sobol(count, 2 * axes, generator)
    first, second = both[:, :axes], both[:, axes:]
    return np.concatenate([first, second, *(_exchanged(first, second, k) for k in range(axes))])


def _sobol(count: int, axes: int, generator: np.random.Generator) -> Floats:
    """Return the first points of a scrambled Sobol' sequence; drawn to a power of two, which keeps their balance."""
    from scipy.stats import qmc

    power = max(0, math.ceil(math.log2(count)))
    with heard_after():  # its first numbers are read in C, which swallows what is raised in it
        return np.asarray(qmc.Sobol(axes, rng=generator).random_base2(power)[:count])


def _exchanged(first: Floats, second: Floats, column: int) -> Floats:
    block = first.copy()
    block[:, column] = second[:, column]
    return block


# ----------------------------------------------------------------------------------------------------------------------
# NSGA-II: the Pareto front of the objectives, found over continuous and discrete choices.
#
# Source: Deb, Pratap, Agarwal, Meyarivan 2002, IEEE Trans. Evol. Comput. 6 (2), 182-197: non-dominated sorting,
# constraint-domination and crowding distance; simulated binary crossover and polynomial mutation of Deb and Agrawal
# 1995.
# ----------------------------------------------------------------------------------------------------------------------


CROSSOVER = 0.9
"""Probability that two parents are mixed [-] (Deb et al. 2002, section V)."""
SPREAD_OF_CHILDREN, SPREAD_OF_MUTATION = 15.0, 20.0
"""Distribution indices of crossover and mutation [-]; the paper takes 20 for both, 15 looks a little further."""


def generations(study: Study) -> Generator[list[Case], list[Row], None]:
    """Yield one generation of cases after the other; send the rows of each to get the next.

    The cases follow from the seed and the rows alone, so that a search that was interrupted finds its way again.

    Args:
        study: With objectives, a count of evaluations and a population.
    """
    count, generator = case_count(study), np.random.default_rng(study.sampling.seed)
    size = min(study.sampling.population, count)
    genes = generator.random((size, len(study.axes) + 1))
    parents, values, broken = genes[:0], np.zeros((0, len(study.objectives))), np.zeros(0)
    number = 0
    while number < count:
        genes = genes[: count - number]
        rows = yield [_case(study, number + k, gene) for k, gene in enumerate(genes)]
        number += len(genes)
        parents = np.vstack([parents, genes])
        values = np.vstack([values, wanted(study, rows)])
        broken = np.concatenate([broken, violations(study, rows)])
        rank = ranks(values, broken)
        crowd = crowding(values, rank)
        best = np.lexsort((-crowd, rank))[:size]
        parents, values, broken = parents[best], values[best], broken[best]
        genes = children(parents, rank[best], crowd[best], generator)


def _case(study: Study, number: int, gene: Floats) -> Case:
    """Return the case of a gene: its first entry chooses the design, the others their axes."""
    design = study.designs[min(int(gene[0] * len(study.designs)), len(study.designs) - 1)]
    inputs = {
        path: value_at(path, axis, float(place))
        for (path, axis), place in zip(study.axes.items(), gene[1:], strict=True)
    }
    return Case(number, design, inputs)


def children(parents: Floats, rank: Ints, crowd: Floats, generator: np.random.Generator) -> Floats:
    """Return as many children as parents: tournaments, crossover, mutation.

    Args:
        parents: Genes in the unit cube, shape (parents, genes).
        rank: Front that each belongs to, shape (parents,).
        crowd: Crowding distance of each, shape (parents,).
        generator: Of random numbers.
    """
    size = len(parents)
    pairs = generator.integers(size, size=(size + size % 2, 2))
    first_wins = (rank[pairs[:, 0]] < rank[pairs[:, 1]]) | (
        (rank[pairs[:, 0]] == rank[pairs[:, 1]]) & (crowd[pairs[:, 0]] >= crowd[pairs[:, 1]])
    )
    chosen = parents[np.where(first_wins, pairs[:, 0], pairs[:, 1])]
    for first in range(0, len(chosen), 2):
        if generator.random() < CROSSOVER:
            chosen[first : first + 2] = _crossed(chosen[first], chosen[first + 1], generator)
    return _mutated(chosen[:size], generator)


def _crossed(first: Floats, second: Floats, generator: np.random.Generator) -> Floats:
    """Return two children by simulated binary crossover, each gene mixed with probability one half."""
    draw = generator.random(len(first))
    power = 1.0 / (SPREAD_OF_CHILDREN + 1.0)
    beta = np.where(draw <= 0.5, (2.0 * draw) ** power, (0.5 / (1.0 - draw)) ** power)
    beta = np.where(generator.random(len(first)) < 0.5, beta, 1.0)
    middle, half = (first + second) / 2.0, (second - first) / 2.0
    half = np.where((beta != 1.0) & (generator.random(len(first)) < 0.5), -half, half)  # genes of both parents meet
    return np.clip(np.stack([middle - beta * half, middle + beta * half]), 0.0, 1.0)


def _mutated(genes: Floats, generator: np.random.Generator) -> Floats:
    """Return genes of which one in each child or more is moved by polynomial mutation: no child repeats a parent."""
    draw = generator.random(genes.shape)
    power = 1.0 / (SPREAD_OF_MUTATION + 1.0)
    move = np.where(draw < 0.5, (2.0 * draw) ** power - 1.0, 1.0 - (2.0 * (1.0 - draw)) ** power)
    hit = generator.random(genes.shape) < 1.0 / genes.shape[1]
    hit[np.arange(len(genes)), generator.integers(genes.shape[1], size=len(genes))] = True
    return np.clip(genes + np.where(hit, move, 0.0), 0.0, 1.0)


# ----------------------------------------------------------------------------------------------------------------------
# One case: design and mission are changed, the verbs that results need are run, and what fails becomes a reason.
# ----------------------------------------------------------------------------------------------------------------------


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
    from gearwright.study.results import flown  # what flies is loaded for those who ask for it

    design_changes, mission_changes = split({**study.changes, **inputs})
    if study.mission is None:
        raise DesignError([Problem("fly.mission", "this study has no mission; it names one under [fly]")])
    return flown(edited(design, design_changes), edited_mission(study.mission, mission_changes), study.fly)


def _flown(study: Study, design: Design, inputs: Mapping[str, Value]) -> tuple[Sizing, dict[str, Named]]:
    """Return the sizing of a case, and the results of its flight."""
    from gearwright.study.results import flight_results

    sizing, flight = _flight(study, design, inputs)
    results = flight_results(flight, study.asked)
    if _asks(study, "review"):
        from gearwright.study.results import review_results

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
        from gearwright.study.results import modal_results

        results |= modal_results(sizing)
    if _asks(study, "simulate"):
        from gearwright.study.results import simulated_results

        results |= simulated_results(sizing, study.simulate)
    if _asks(study, "review") and not study.flies:
        from gearwright.study.results import review_results

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


# ----------------------------------------------------------------------------------------------------------------------
# Cases of which only the mission differs: sized once, and flown together as arrays.
# ----------------------------------------------------------------------------------------------------------------------


_LONE_VERBS = ("review", "modes", "simulate")
"""Beginnings of results for which a case is computed alone."""
_SIZED = Memo[tuple[int, str], tuple[Design, Sizing]](1)
"""The last sizing with its design, by which object that is and by its changes."""


TOGETHER = 64
"""Flights of a chunk: many beside what an operation on arrays costs, few beside a cache and a journal."""


def flown_together(study: Study, designs: Mapping[str, Design], cases: Sequence[Case]) -> list[Row]:
    """Return the rows of cases, each with the bits that it has alone.

    Args:
        study: Changes, and the results that are asked for.
        designs: Name -> design.
        cases: Their inputs.
    """
    if not fly_together(study):
        return [evaluate(study, designs[case.design], case) for case in cases]
    rows, place = list[Row](), 0
    while place < len(cases):
        first, changes = cases[place], _design_part(study, cases[place])
        chunk = list(takewhile(partial(_alike, study, first.design, changes), cases[place : place + TOGETHER]))
        rows += _flown_rows(study, designs[first.design], changes, chunk)
        place += len(chunk)
    return rows


def fly_together(study: Study) -> bool:
    """Tell whether flights of a study can be found together.

    Args:
        study: With its results.
    """
    alone = any(name.partition(".")[0] in _LONE_VERBS for name in study.asked)
    return study.flies and study.mission is not None and study.fly.life is None and not alone


def _alike(study: Study, design: str, changes: Mapping[str, Value], case: Case) -> bool:
    return case.design == design and _design_part(study, case) == changes


def _design_part(study: Study, case: Case) -> Mapping[str, Value]:
    return split({**study.changes, **case.inputs})[0]


def _flown_rows(study: Study, design: Design, changes: Mapping[str, Value], cases: Sequence[Case]) -> list[Row]:
    from gearwright.mission import Flight, fly_each, gear_damages  # what flies is loaded for those who ask for it
    from gearwright.study.results import asks_lives

    mission = study.mission
    assert mission is not None  # `fly_together`
    try:
        sizing = _sized(design, changes)
    except GearwrightError:
        return [evaluate(study, design, case) for case in cases]
    missions = [_edited(mission, split({**study.changes, **case.inputs})[1]) for case in cases]
    good = [entry for entry in missions if isinstance(entry, Mission)]
    flights = iter(fly_each(sizing, good))
    found = [next(flights) if isinstance(entry, Mission) else entry for entry in missions]
    flew = [one for one in found if isinstance(one, Flight)]
    damages = iter(gear_damages(flew) if asks_lives(study.asked) else [None] * len(flew))
    lived = [next(damages) if isinstance(one, Flight) else None for one in found]
    once = cache(lambda: asked_results(sizing, study.asked))
    return [
        row_of(study, case, partial(_results, study, once, one, damage))
        for case, one, damage in zip(cases, found, lived, strict=True)
    ]


def _sized(design: Design, changes: Mapping[str, Value]) -> Sizing:
    """Return the sizing of a design with changes; the last one is kept."""
    return _SIZED.of((id(design), repr(sorted(changes.items()))), lambda: (design, size(edited(design, changes))))[1]


def _edited(mission: Mission, changes: Mapping[str, Value]) -> Mission | DesignError:
    try:
        return edited_mission(mission, changes)
    except DesignError as error:
        return error


def _results(study: Study, of_sizing: Callable[[], dict[str, Named]], flight: object, damage: Any) -> dict[str, Named]:
    """Return the results that are asked for; those of the sizing, the same for all, where a flight has not all."""
    from gearwright.mission import Flight
    from gearwright.study.results import flight_results

    for known in (flight, damage):
        if isinstance(known, DesignError):
            raise known
    assert isinstance(flight, Flight)
    results = flight_results(flight, study.asked, damage)
    if all(name in results for name in study.asked):
        return {name: results[name] for name in study.asked}
    return of_sizing() | results


# ----------------------------------------------------------------------------------------------------------------------
# Cases that only sizes are asked of, sized together: with the bits of each alone, whatever stands beside it.
# ----------------------------------------------------------------------------------------------------------------------


LEAST = 64
"""Cases of one design below which each is sooner sized alone [-]."""
_OTHERS = ("fly", "modes", "simulate", "review")
"""Verbs that compute one case at a time."""


def goes_together(study: Study) -> bool:
    """Tell whether nothing but sizes is asked of the cases of a study.

    Args:
        study: With its results and changes.
    """
    flies = study.flies or any(path.startswith(MISSION_PATH) for path in (*study.axes, *study.changes))
    return not flies and not any(name.partition(".")[0] in _OTHERS for name in study.asked)


def evaluated(study: Study, designs: Mapping[str, Design], cases: Sequence[Case]) -> Blocks:
    """Return the rows of cases, each as `evaluate` gives it of the case alone, bit for bit.

    Args:
        study: Changes, and the results that are asked for.
        designs: Name -> design.
        cases: Any of it.
    """
    done = np.zeros(len(cases), dtype=bool)
    found = Blocks(())
    if goes_together(study) and len(cases) >= LEAST:
        places: dict[tuple[str, ...], list[int]] = {}
        for place, case in enumerate(cases):
            places.setdefault((case.design, *case.inputs), []).append(place)
        for own in places.values():
            if len(own) >= LEAST:
                blocks, sized = _together(study, designs[cases[own[0]].design], [cases[place] for place in own])
                done[np.array(own)[sized]] = True
                found = Blocks((*found.blocks, *blocks.blocks))
    alone = [cases[place] for place in np.flatnonzero(~done).tolist()]
    rest = blocks_of(zip((case.number for case in alone), flown_together(study, designs, alone), strict=True))
    return Blocks((*found.blocks, *rest.blocks))


def _together(study: Study, design: Design, cases: Sequence[Case]) -> tuple[Blocks, Bools]:
    """Return the rows of those cases that could be sized together, and which they are."""
    none = Blocks(()), np.zeros(len(cases), dtype=bool)
    columns = {path: [case.inputs[path] for case in cases] for path in cases[0].inputs}
    try:
        base = edited(design, {path: value for path, value in study.changes.items() if path not in columns})
    except GearwrightError:
        return none
    found, _ = in_lanes(base, columns, study.asked, count=len(cases))
    if not all(name in found.values for name in study.asked):
        return none
    sized = found.done.copy()
    for name in study.asked:
        sized &= ~np.isnan(found.values[name])  # a part that others have: alone it says so
    place = np.flatnonzero(sized)
    inputs = {path: [values[k] for k in place.tolist()] for path, values in columns.items()}
    results = {name: (found.values[name][place], found.dimensions[name]) for name in study.asked}
    numbers = np.array([cases[k].number for k in place.tolist()], dtype=np.int64)
    return block_of_columns(cases[0].design, numbers, inputs, results), sized
