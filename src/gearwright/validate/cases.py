"""Every published case that gearwright knows."""

from __future__ import annotations

from gearwright.errors import DesignError, Problem
from gearwright.validate import engines, gears, shafts
from gearwright.validate import engines as propellers
from gearwright.validate import gearboxes as gearbox_mass
from gearwright.validate import shafts as beams
from gearwright.validate import shafts as bearings
from gearwright.validate import trains as compound_shifts
from gearwright.validate import trains as compound_trains
from gearwright.validate import trains as planetary_sets
from gearwright.validate import vibration as geared
from gearwright.validate import vibration as rotors
from gearwright.validate import vibration as torsional
from gearwright.validate.case import Case, Checked, check
from gearwright.verbs import verb

ALL = (
    *planetary_sets.PLANETARY_CASES,
    *compound_trains.COMPOUND_CASES,
    *compound_shifts.SHIFT_CASES,
    *torsional.TORSIONAL_CASES,
    *geared.GEARED_CASES,
    *beams.BEAM_CASES,
    *rotors.ROTOR_CASES,
    *engines.ENGINE_CASES,
    *propellers.PROPELLER_CASES,
    *gears.CASES,
    *bearings.BEARING_CASES,
    *shafts.SHAFT_CASES,
    *gearbox_mass.CASES,
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
