"""A design at another level: what a preliminary one asks is written where the design leaves it open."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from gearwright.errors import DesignError, Problem, near
from gearwright.spec.design import RATINGS, Design, GearRules
from gearwright.spec.edit import Value, edited
from gearwright.verbs import verb

FATIGUE = "iso6336"
"""Method that rates stages whose own one knows no fatigue; bevel pairs go to its sister by themselves."""
STATIC = "lewis-hertz"
"""The method that knows static strength alone."""
LEVELS = ("concept", "preliminary")
"""That a design without bearings of shafts can be sized at."""
PLAIN_BEARING = "cylindrical"
"""Kind of bearing in planets that name none."""


@verb
def at_level(design: Design, level: str) -> Design:
    """Return a design at a level: preliminary rates by ISO 6336 what knows no fatigue, and gives planets bearings.

    What the design gives stays, but for the rules of the method that is left.

    Args:
        design: As read.
        level: ``concept`` or ``preliminary``.

    Raises:
        DesignError: If the level is none of these, or the design has bearings on its shafts.
    """
    if level not in LEVELS:
        raise DesignError([Problem("level", f"{level!r} is not known; {near(level, LEVELS)}")])
    if level != "preliminary":
        return edited(design, {"level": level})
    turning = {
        f"planetaries.{name}.planet_bearing": {"kind": PLAIN_BEARING}
        for name, stage in design.planetaries.items()
        if stage.planet_bearing is None
    }
    return edited(against_fatigue(design), {"level": level, **turning})


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
