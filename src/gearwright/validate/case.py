"""One published result: where it is printed, what is printed, how near gearwright must come and why so near."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from gearwright.base import Shown, SolveError


@dataclass(frozen=True)
class Case:
    """Numbers that one publication prints of one thing."""

    name: str
    """What it is, such as ``planetary set, N = 4, rotational modes``."""
    source: str
    """Author, year, place in the publication."""
    unit: str
    """Of the numbers, such as ``Hz``."""
    expected: tuple[float, ...]
    """As printed."""
    compute: Callable[[], Sequence[float]]
    """What gearwright finds, in the same order and unit."""
    tolerance: float
    """Allowed deviation, in the unit of the numbers or as a share of them."""
    reason: str
    """Why so much."""
    is_relative: bool = True
    """Whether the tolerance is a share of the number."""


@dataclass(frozen=True, repr=False)
class Checked(Shown):
    """One number of a case beside gearwright's."""

    case: str
    source: str
    unit: str
    expected: float
    got: float
    error: float
    """Deviation over the number; of a zero, the deviation itself [-]."""
    holds: bool
    reason: str
    """Why the tolerance is what it is."""


def check(case: Case) -> tuple[Checked, ...]:
    """Return every number of a case beside what gearwright finds.

    Args:
        case: Published result.

    Raises:
        SolveError: If gearwright finds another count of numbers than are printed.
    """
    numbers = [float(value) for value in case.compute()]
    if len(numbers) != len(case.expected):
        raise SolveError(f"{case.name}: {len(case.expected)} numbers are printed, {len(numbers)} found")
    several = len(numbers) > 1
    return tuple(
        _checked(case, f"{case.name}, {place}" if several else case.name, expected, got)
        for place, (expected, got) in enumerate(zip(case.expected, numbers, strict=True), start=1)
    )


def _checked(case: Case, name: str, expected: float, got: float) -> Checked:
    allowed = case.tolerance * abs(expected) if case.is_relative else case.tolerance
    deviation = got - expected
    error = deviation / abs(expected) if expected else deviation
    return Checked(name, case.source, case.unit, expected, got, error, abs(deviation) <= allowed, case.reason)
