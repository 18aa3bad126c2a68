"""A design as a component of OpenMDAO: dotted paths in, results by name out, each with its unit, and its partials.

What is computed are the results of a study's case; drivers, mission models and their optimum are OpenMDAO's.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import cache
from importlib.util import find_spec
from types import MappingProxyType
from typing import Any, Literal

from gearwright.base import DesignError, GearwrightError, Problem, install, refuse, si_unit, suffix_unit, verb
from gearwright.closure import teeth_of
from gearwright.sizing import TEXT, Named, pick, size
from gearwright.spec import MISSION_PATH, Design, Mission, Standing, Study, edited, path_problem, standing_at
from gearwright.study.cases import refuse_unknown_paths, results_of, split

# ----------------------------------------------------------------------------------------------------------------------
# Names and units of gearwright as OpenMDAO has them.
# ----------------------------------------------------------------------------------------------------------------------


_OTHER: Mapping[str, str] = MappingProxyType({
    "°": "deg", "°C": "degC", "K": "degK", "in": "inch", "kt": "knot", "l": "L", "nmi": "NM", "1": "", "√Pa": "",
    "nm_s_rad": "N*m*s/rad", "per_in": "1/inch",
})  # fmt: skip
"""Unit -> what OpenMDAO calls it, where that is more than other signs; empty of what has none there."""


@verb
def variable(name: str) -> str:
    """Return the name of a variable of OpenMDAO for a dotted path or result.

    Args:
        name: Such as ``motors.electric.speed_rpm``.

    >>> variable("gears.first stage.sun-gear.mass")
    'gears:first_stage:sun_gear:mass'
    """
    return re.sub(r"[^\w:]", "_", name.split(",")[0].strip().replace(".", ":"))


def unit_written(suffix: str) -> str | None:
    """Return the unit of a key as OpenMDAO writes it; None of what has none.

    Args:
        suffix: Of the key, such as ``lbf_ft``; empty for what has no unit.

    >>> unit_written("lbf_ft"), unit_written("mm2"), unit_written("in")
    ('lbf*ft', 'mm**2', 'inch')
    """
    return _in_its_signs(suffix_unit(suffix)) if suffix else None


def unit_of_result(dimension: str) -> str | None:
    """Return the SI unit of a result as OpenMDAO writes it; None of a ratio, a count, and what it has no words for.

    Args:
        dimension: Such as ``"torque"``.

    >>> unit_of_result("torque"), unit_of_result("ratio")
    ('N*m', None)
    """
    return _in_its_signs(si_unit(dimension))


def _in_its_signs(unit: str) -> str | None:
    plain = unit.replace("²", "**2").replace("³", "**3").replace("µ", "u").replace(" ", "*")
    return _OTHER.get(unit, plain) or None


# ----------------------------------------------------------------------------------------------------------------------
# What a component computes: the results of a case by its paths, and their differences with the teeth held.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# The class that OpenMDAO knows, made when it is asked for: OpenMDAO is an extra.
# ----------------------------------------------------------------------------------------------------------------------


@cache
def transmission() -> Any:
    """Return the class of a design over some of its entries."""
    import openmdao.api as om

    class Transmission(om.ExplicitComponent):  # type: ignore[misc]
        """A design over some of its entries."""

        def __init__(self, held: Held) -> None:
            super().__init__()
            self._held, self._last = held, dict(held.start)

        def designed(self) -> Design:
            """Return the design at the values that were computed last, with its teeth where they are frozen."""
            return self._held.changed(self._last)

        def setup(self) -> None:
            """Declare variables with units and values to start from."""
            for path, value in self._held.start.items():
                if isinstance(value, float):
                    self.add_input(variable(path), value, units=self._held.units[path], desc=path)
                else:
                    self.add_discrete_input(variable(path), value, desc=path)
            for name, result in self._held.begun.items():
                self.add_output(variable(name), result.value, units=unit_of_result(result.dimension), desc=name)

        def setup_partials(self) -> None:
            """Declare that every output may depend on every input that is no whole number."""
            if any(isinstance(value, float) for value in self._held.start.values()):
                self.declare_partials("*", "*")

        def compute(self, inputs: Any, outputs: Any, discrete_inputs: Any = None, discrete_outputs: Any = None) -> None:
            """Size, and fly where that is asked for.

            Raises:
                AnalysisError: If that is not possible, in the words of gearwright.
            """
            self._last = self._values(inputs, discrete_inputs)
            for name, result in self._asked(self._held.results, self._last).items():
                outputs[variable(name)] = result.value

        def compute_partials(self, inputs: Any, partials: Any, discrete_inputs: Any = None) -> None:
            """Compute central differences with the teeth held.

            Raises:
                AnalysisError: If there is no sizing beside the point.
            """
            slopes = self._asked(self._held.slopes, self._values(inputs, discrete_inputs))
            for (name, path), slope in slopes.items():
                partials[variable(name), variable(path)] = slope

        def _values(self, inputs: Any, discrete: Any) -> dict[str, float]:
            """Return path -> value."""
            start = self._held.start
            return {
                path: float(inputs[variable(path)][0]) if isinstance(value, float) else int(discrete[variable(path)])
                for path, value in start.items()
            }

        @staticmethod
        def _asked(compute: Any, values: Mapping[str, float]) -> Any:
            try:
                return compute(values)
            except GearwrightError as error:
                raise om.AnalysisError(str(error)) from None

    return Transmission


# ----------------------------------------------------------------------------------------------------------------------
# The component itself: what OpenMDAO asks of it, answered by a design.
# ----------------------------------------------------------------------------------------------------------------------


@verb
def component(
    design: Design, inputs: Sequence[str] | Mapping[str, float], outputs: Sequence[str], *,
    teeth: Literal["chosen", "frozen"] = "chosen", mission: Mission | None = None,
) -> Any:  # fmt: skip
    """Return a design as an ``ExplicitComponent`` of OpenMDAO: entries of its file in, results of its sizing out.

    Inputs are in the unit of their path, outputs in SI. A dotted name becomes one with colons (`variable`). A place
    that takes whole numbers alone, such as ``planets``, is a discrete input. Partials are central differences with
    the teeth held as they are chosen where they are asked for, whatever ``teeth`` says. What cannot be sized or flown
    is an ``AnalysisError`` in the words of gearwright. ``component.designed()`` is the design at the last values.

    Args:
        design: As read.
        inputs: Dotted paths of the design, or with ``mission.`` of the mission, which begin at what stands there; or
            path -> number to begin with. Several paths with commas between them have one value.
        outputs: Results as studies name them: ``mass``, ``meshes.first.sun-planet.contact_margin``, ``fly.fuel`` …
        teeth: ``chosen`` anew for all values, or ``frozen`` as they are chosen at the start.
        mission: What is flown, for results named ``fly.…`` and paths named ``mission.…``.

    Raises:
        DesignError: If OpenMDAO is not here, a path or result is unknown or no number, or the start cannot be sized.
    """
    if find_spec("openmdao") is None:
        refuse([Problem("", f"this needs OpenMDAO, which is not here; {install('openmdao')}")])

    asked = {"inputs": inputs, "outputs": outputs}
    refuse(Problem(name, "it is empty; give a list of at least one name") for name, names in asked.items() if not names)
    given: dict[str, float | None] = dict(inputs) if isinstance(inputs, Mapping) else dict.fromkeys(inputs)
    study = Study(name="component", designs=[design.name], results=list(outputs), mission=mission)
    return transmission()(Held(design, given, study, frozen=teeth == "frozen"))
