"""A design at another level, and what a design takes by default that states none."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from gearwright.errors import DesignError, Problem, near
from gearwright.spec.design import BUILT, CONCEPT, FATIGUE, PRELIMINARY, RATINGS, STATIC, Design, GearRules
from gearwright.spec.edit import Value, edited
from gearwright.verbs import verb

LEVELS = (CONCEPT, PRELIMINARY)
"""That a design without bearings of shafts can be sized at."""


@verb
def at_level(design: Design, level: str) -> Design:
    """Return a design at a level: preliminary rates by ISO 6336 what knows no fatigue, and gives planets bearings.

    What the design gives stays, but for the rules of the method that is left; with a life, or rules of ISO 6336, a
    concept is rated by it, too.

    Args:
        design: As read.
        level: ``concept`` or ``preliminary``.

    Raises:
        DesignError: If the level is none of these, or the design has bearings on its shafts.
    """
    if level not in LEVELS:
        raise DesignError([Problem("level", f"{level!r} is not known; {near(level, LEVELS)}")])
    return edited(design, as_concept(design)) if level == CONCEPT else against_fatigue(design, {"level": level})


def as_concept(design: Design) -> dict[str, Value]:
    """Return the changes with which a design is a first sizing: path -> value.

    Args:
        design: As read.
    """
    rules = (design.gears, *_own_rules(design).values())
    fatigue = set(RATINGS[FATIGUE].reads) - set(RATINGS[STATIC].reads)
    implied_rating = design.level == PRELIMINARY and "rating" not in design.gears.model_fields_set
    asks = "service" in design.model_fields_set or any(fatigue & one.model_fields_set for one in rules)
    return {"level": CONCEPT, **({"gears.rating": FATIGUE} if implied_rating and asks else {})}


def implied(design: Design) -> dict[str, str]:
    """Return what a design leaves open and its level gives: path -> value, as its file would have them.

    Args:
        design: As read; nothing is said of one whose bearings build its shafts.
    """
    if design.level == BUILT:
        return {}
    entries: dict[str, str] = {} if "level" in design.model_fields_set else {"level": design.level}
    if design.level == PRELIMINARY:
        if "rating" not in design.gears.model_fields_set:
            entries["gears.rating"] = design.gears.rating
        for name, stage in design.planetaries.items():
            if stage.planet_bearing is not None and "planet_bearing" not in stage.model_fields_set:
                entries[f"planetaries.{name}.planet_bearing.kind"] = stage.planet_bearing.kind
    return entries


def against_fatigue(design: Design, changes: Mapping[str, Value] | None = None) -> Design:
    """Return a design whose stages are rated against fatigue, by ISO 6336 where their own method knows none.

    Args:
        design: As read; the rules that only the method reads which is left go with it.
        changes: What else is changed: path -> value.

    Raises:
        DesignError: Values that the keys of the design do not allow.
    """
    return edited(_freed(design), {**dict(_rated(design)), **(changes or {})})


def _rated(design: Design) -> Iterator[tuple[str, Value]]:
    """Yield the changes of rules with which every stage is rated against fatigue."""
    tables = {"gears": design.gears} | {f"{design.table(name)}.gears": own for name, own in _own_rules(design).items()}
    for path, rules in tables.items():
        if (path == "gears" or "rating" in rules.model_fields_set) and not RATINGS[rules.rating].fatigue:
            yield f"{path}.rating", FATIGUE


def _own_rules(design: Design) -> dict[str, GearRules]:
    """Return stage -> its own rules, of those that have some."""
    return {name: stage.gears for name, stage in design.stages.items() if stage.gears is not None}


def _freed(design: Design) -> Design:
    """Return a design without the rules that only the method reads which the closure does not rate by."""
    if not RATINGS[design.gears.rating].fatigue:
        design = design.model_copy(update={"gears": _without(design.gears)})
    for name, rules in _own_rules(design).items():
        if not RATINGS[design.rules(name).rating].fatigue:
            kind = design.kind(name)
            stage = design.stages[name].model_copy(update={"gears": _without(rules)})
            design = design.model_copy(update={kind: {**getattr(design, kind), name: stage}})
    return design


def _without(rules: GearRules) -> GearRules:
    """Return rules without those that the former method alone reads."""
    former = set(RATINGS[STATIC].reads) - set(RATINGS[FATIGUE].reads)
    return GearRules.model_validate({key: getattr(rules, key) for key in rules.model_fields_set - former})
