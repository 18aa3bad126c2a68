"""One computed number of the Colibri report, and how a part of the chain reads those before it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple, TypeAlias

from gearwright.replays.colibri.report.printed import printed_numbers


class Step(NamedTuple):
    """A number as the report's own steps give it."""

    value: float
    """In SI."""
    how: str
    """Formula or origin, in the report's symbols."""
    assumptions: tuple[str, ...] = ()
    """What the report does not say and the step needs: H1 to H9."""

    def again(self, where: str) -> Step:
        """Return the same number where the report prints it once more.

        Args:
            where: It was before.
        """
        return self._replace(how=f"as {where}")


Steps: TypeAlias = Mapping[str, Step]
"""Key of a number -> the number."""


class Known:
    """The numbers of one part that are known so far, by the second half of their keys."""

    def __init__(self, steps: Steps, part: str) -> None:
        self._steps, self._part = steps, part

    def __getitem__(self, name: str) -> float:
        return self.step(name).value

    def step(self, name: str) -> Step:
        """Return a number with its origin.

        Args:
            name: Second half of the key.
        """
        return self._steps[f"{self._part}.{name}"]


def stated_steps() -> dict[str, Step]:
    """Return the numbers that the report states."""
    return {number.key: Step(number.value, "stated") for number in printed_numbers() if number.is_stated}


def of_part(part: str, steps: Steps) -> dict[str, Step]:
    """Return the numbers of a part under their whole keys.

    Args:
        part: First half of the keys.
        steps: By the second half.
    """
    return {f"{part}.{name}": step for name, step in steps.items()}


def typed(value: float, decimals: int, unit: float = 1.0) -> float:
    """Return a number as it is after it was printed with some decimals and typed in again, in SI.

    Args:
        value: In SI.
        decimals: After the point.
        unit: In which it was printed, in SI.
    """
    return round(value / unit, decimals) * unit
