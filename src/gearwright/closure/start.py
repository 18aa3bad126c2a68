"""What a closure starts from: the design with a rating that knows fatigue, the life that is asked, nothing chosen."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from gearwright.closure.wishes import HOUR, Wishes
from gearwright.spec import Design, edited
from gearwright.spec.design import RATINGS, GearRules
from gearwright.spec.edit import Value

FATIGUE = "iso6336"
"""Method that rates stages whose own one knows no fatigue; bevel pairs go to its sister by themselves."""
STATIC = "lewis-hertz"
"""The method that knows static strength alone."""


def start_of(design: Design, wishes: Wishes) -> Design:
    """Return the design as a closure begins with it.

    Stages that Lewis and Hertz rate are rated by ISO 6336, as no life can be asked of static strength; the rules that
    only those two read are left out with them.

    Args:
        design: As read.
        wishes: What is asked.

    Raises:
        DesignError: Values that the keys of the design do not allow.
    """
    return edited(_freed(design), {**dict(_rated(design)), **_lives(design, wishes)})


def _lives(design: Design, wishes: Wishes) -> Mapping[str, Value]:
    if wishes.life is None:
        return {}
    hours = wishes.life / HOUR
    return {"service.life_h": hours, "service.bearing_life_h": hours}


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
