"""Every published case that gearwright knows."""

from gearwright.base import DesignError, Problem, verb
from gearwright.validate import engines, gearboxes, gears, shafts, trains
from gearwright.validate.case import Case, Checked, check

ALL = (
    *trains.PLANETARY_CASES,
    *trains.COMPOUND_CASES,
    *trains.SHIFT_CASES,
    *shafts.TORSIONAL_CASES,
    *shafts.GEARED_CASES,
    *shafts.BEAM_CASES,
    *shafts.ROTOR_CASES,
    *engines.ENGINE_CASES,
    *engines.PROPELLER_CASES,
    *gears.CASES,
    *shafts.BEARING_CASES,
    *shafts.SHAFT_CASES,
    *gearboxes.CASES,
)
"""In the order of the table."""


def published(pattern: str = "") -> tuple[Case, ...]:
    """Return the cases whose name or source contains some words.

    Args:
        pattern: Words, in any case of letters; empty: all.

    Raises:
        DesignError: If no case does.
    """
    words = pattern.casefold()
    cases = tuple(case for case in ALL if words in f"{case.name} {case.source}".casefold())
    if not cases:
        names = ", ".join(dict.fromkeys(case.source.partition(",")[0] for case in ALL))
        raise DesignError([Problem("pattern", f"no case or source contains {pattern!r}; sources: {names}")])
    return cases


@verb
def validate(pattern: str = "") -> tuple[Checked, ...]:
    """Return every published number of some cases beside what gearwright finds; this computes them.

    Args:
        pattern: Words of a case or its source, in any case of letters; empty: all.

    Raises:
        DesignError: If no case or source contains them.

    >>> first = validate("planetary set, N = 3")[0]
    >>> first.expected, round(first.got, 1), first.unit, first.holds
    (1475.7, 1475.7, 'Hz', True)
    """
    return tuple(number for case in published(pattern) for number in check(case))
