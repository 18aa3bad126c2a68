"""What a design implies that states no level: one by what stands in it, and what this level asks for.

What is implied is no entry of the design: texts leave it out, and it follows anew from every change.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, TypeVar

from gearwright.spec.design.rules import RATINGS, GearRules
from gearwright.spec.design.stages import Planetary, PlanetBearing
from gearwright.spec.record import Record

CONCEPT, PRELIMINARY, BUILT = "concept", "preliminary", "built"
STATIC, FATIGUE = "lewis-hertz", "iso6336"
"""Methods that rate where the design names none: by static strength, and at level preliminary against fatigue."""
_OF_STATIC = frozenset(RATINGS[STATIC].reads) - frozenset(RATINGS[FATIGUE].reads)
"""Rules that only the static method reads, so that it is meant where they stand."""
R = TypeVar("R", bound=Record)


def implied_level(rules: Iterable[GearRules], *, bearings: bool) -> str:
    """Return the level of a design that states none: built with bearings, concept where static strength is asked for.

    Args:
        rules: Of [gears], and of every stage that has its own.
        bearings: Whether its shafts have bearings.
    """
    if bearings:
        return BUILT
    return CONCEPT if any(map(_asks_for_static, rules)) else PRELIMINARY


def implied_rules(rules: GearRules, level: str) -> GearRules:
    """Return [gears] with the method of a level, where they name none.

    Args:
        rules: Of the design.
        level: That it has.
    """
    return _implying(rules, "rating", FATIGUE if level == PRELIMINARY else STATIC)


def implied_bearings(planetaries: Mapping[str, Planetary], level: str) -> dict[str, Planetary]:
    """Return planetary sets whose planets turn on bearings of the catalogue at level preliminary, where they name none.

    Args:
        planetaries: Of the design, by name.
        level: That it has.
    """
    bearing = PlanetBearing() if level == PRELIMINARY else None
    return {name: _implying(stage, "planet_bearing", bearing) for name, stage in planetaries.items()}


def _asks_for_static(rules: GearRules) -> bool:
    """Tell whether rules name a method that knows no fatigue, or give what only it reads."""
    stated = rules.model_fields_set
    return ("rating" in stated and not RATINGS[rules.rating].fatigue) or bool(_OF_STATIC & stated)


def _implying(record: R, key: str, value: Any) -> R:
    """Return a record with a value that its user leaves open, which does not count as given."""
    if key in record.model_fields_set or getattr(record, key) == value:
        return record
    copy = record.model_copy()
    copy.__dict__[key] = value
    return copy
