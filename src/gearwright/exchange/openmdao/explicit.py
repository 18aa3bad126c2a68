"""The class that OpenMDAO knows, made when it is asked for: OpenMDAO is an extra."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

from gearwright.errors import GearwrightError
from gearwright.exchange.openmdao.held import Held
from gearwright.exchange.openmdao.names import unit_of_result, variable
from gearwright.spec import Design


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
