"""What a component computes: the results of a case by its paths, and their differences with the teeth held."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gearwright.closure import teeth_of
from gearwright.errors import DesignError, Problem, refuse
from gearwright.exchange.openmdao.names import unit_written, variable
from gearwright.sizing import TEXT, Named, pick, size
from gearwright.spec import MISSION_PATH, Design, Mission, Study, edited, path_problem, standing_at
from gearwright.spec.edit import Standing
from gearwright.study.cases import refuse_unknown_paths, results_of, split

Numbers = Mapping[str, float]
"""Path -> number, in the unit of the path."""
STEP = 1e-4
"""Step of central differences over the value [-]: what is left out is of its square, what rounds of its inverse."""


class Held:
    """Results of a design, and of its flight, over some of their paths."""

    def __init__(self, design: Design, inputs: Mapping[str, float | None], study: Study, *, frozen: bool) -> None:
        self.design, self.study, self.frozen = design, study, frozen
        places = {path: self._standing(path) for path in inputs}
        begins = {path: places[path].value if value is None else value for path, value in inputs.items()}
        refuse(self._problem(path) for path, value in begins.items() if not _is_number(value))
        own = study.model_copy(update={"changes": begins})
        refuse_unknown_paths(own, {design.name: design})
        refuse(_alike([*begins, *study.asked]))
        self.start = {path: value if places[path].whole else float(value) for path, value in begins.items()}
        self.units = {path: unit_written(place.suffix) for path, place in places.items()}
        if frozen:
            self._freeze()
        self.begun = self.results(self.start)
        words = [name for name, result in self.begun.items() if result.dimension == TEXT]
        refuse(Problem(name, "it is a name and no number; leave it out") for name in words)

    def _standing(self, path: str) -> Standing:
        """Return what stands at an input; of several paths with commas between them, at the first."""
        return standing_at(*self._place(path))

    def _place(self, path: str) -> tuple[Design | Mission, str]:
        """Return where a path leads, and its part that is of the design or the mission."""
        own, flown = split({path: 1.0})
        return self.study.mission or self.design if flown else self.design, next(iter(flown or own))

    def _problem(self, path: str) -> Problem:
        """Return what is wrong with an input at which no number stands."""
        if path.startswith(MISSION_PATH) and self.study.mission is None:
            return Problem(path, "there is no mission; give mission = gw.read_mission(path or shipped name)")
        unknown = path_problem(*self._place(path))
        fix = "name an entry that is a number, or give one to start with: inputs = {path: number}"
        return Problem(path, unknown.message if unknown else f"no number stands there; {fix}")

    def _freeze(self) -> None:
        """Write the teeth of the start into the design; what only asked for teeth is no input any more."""
        changes = split(self.start)[0]
        begun = edited(self.design, changes)
        teeth = dict(teeth_of(begun, size(begun)))
        lost = [path for path in changes if path in teeth]
        fix = "leave it out, or have the teeth chosen: teeth = 'chosen'"
        refuse(Problem(path, f"with frozen teeth it changes nothing; {fix}") for path in lost)
        self.design = edited(self.design, teeth)

    def changed(self, values: Numbers) -> Design:
        """Return the design with the values of its inputs.

        Args:
            values: Path -> number, in the unit of the path.

        Raises:
            DesignError: If one of them is not allowed.
        """
        return edited(self.design, split(values)[0])

    def results(self, values: Numbers, design: Design | None = None) -> dict[str, Named]:
        """Return every output.

        Args:
            values: Path -> number, in the unit of the path.
            design: Where to start; left out: the design itself.

        Raises:
            DesignError: If it cannot be sized or flown.
            SolveError: If a computation does not succeed.
        """
        found = results_of(self.study, design or self.design, values)
        return {name: pick(found, name) for name in self.study.asked}

    def slopes(self, values: Numbers) -> dict[tuple[str, str], float]:
        """Return the partials of outputs over inputs, teeth held as they are chosen here; whole numbers have none.

        Args:
            values: Path -> number, in the unit of the path.

        Returns:
            Output and input -> SI over the unit of the path.

        Raises:
            DesignError: If it cannot be sized on either side.
        """
        changes, _ = split(values)
        here = edited(self.design, changes)
        teeth = dict(teeth_of(here, size(here)))
        held = edited(self.design, {**changes, **teeth})
        left = {path: value for path, value in values.items() if path not in teeth and path not in changes}
        slopes: dict[tuple[str, str], float] = {}
        for path in (path for path, value in values.items() if isinstance(value, float)):
            own = {} if path in teeth else self._slopes(held, left, path, values[path])
            slopes |= {(name, path): own.get(name, 0.0) for name in self.study.asked}
        return slopes

    def _slopes(self, held: Design, left: Numbers, path: str, value: float) -> dict[str, float]:
        """Return the partials over one input: central, or to the side that is allowed."""
        step = STEP * (abs(value) or 1.0)
        sides, last = list[tuple[float, dict[str, Named]]](), list[DesignError]()
        for there in (value + step, value - step, value):
            if len(sides) < 2:
                try:
                    sides.append((there, self.results({**left, path: there}, held)))
                except DesignError as error:
                    last.append(error)
        if len(sides) < 2:
            raise last[0]
        (a, first), (b, second) = sides
        return {name: (float(first[name].value) - float(second[name].value)) / (a - b) for name in first}


def _alike(names: Sequence[str]) -> list[Problem]:
    """Return which names OpenMDAO cannot tell apart."""
    seen: dict[str, str] = {}
    problems = []
    for name in names:
        if seen.setdefault(variable(name), name) != name:
            told = f"OpenMDAO's name for it, {variable(name)}, is that of {seen[variable(name)]}, too; leave one out"
            problems.append(Problem(name, told))
    return problems


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)
