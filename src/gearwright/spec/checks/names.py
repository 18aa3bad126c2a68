"""What can be wrong with names: some that no path of a result can hold, and two parts that would be called alike."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from gearwright.errors import Problem
from gearwright.spec.bounds import NAME_RULE, is_name
from gearwright.spec.design import GROUND, MACHINES, WEIGHED, Case, Design
from gearwright.spec.keys import keys_of


def name_problems(design: Design) -> Iterator[Problem]:
    """Yield every name of a design that cannot be one, and every part that is called like another.

    Args:
        design: As typed.
    """
    yield from _shafts(design)
    yield from _whole(design)
    tables = _tables(design)
    for table, names in tables.items():
        for name in names:
            if not is_name(name):
                yield Problem(f"{table}.{name}", f"{name!r} {NAME_RULE}")
    for table in MACHINES:
        for name in tables[table]:
            if name in keys_of(Case):
                yield Problem(f"{table}.{name}", f"{name!r} is a key of load cases; give the machine another name")
    yield from _alike(design, tables)


def _tables(design: Design) -> dict[str, Mapping[str, object]]:
    return {
        **{table: getattr(design, table) for table in MACHINES},
        "pairs": design.pairs, "planetaries": design.planetaries, "epicyclics": design.epicyclics,
        "clutches": design.clutches, "dampers": design.dampers, "cases": design.cases,
    }  # fmt: skip


def _shafts(design: Design) -> Iterator[Problem]:
    seen: set[str] = set()
    for name in design.shafts:
        if name in seen:
            yield Problem("shafts", f"{name!r} stands twice; every shaft has one name")
        if name == GROUND:
            yield Problem("shafts", f"{GROUND!r} is the frame and stands still; give the shaft another name")
        seen.add(name)


def _whole(design: Design) -> Iterator[Problem]:
    """Find parts whose mass would be given by the path of the whole gearbox's."""
    named = [("shafts", name) for name in design.shafts]
    named += [(f"{table}.{name}", name) for table in WEIGHED for name in getattr(design, table)]
    for path, name in named:
        if name == "gearbox":
            yield Problem(path, f"{name!r} is the whole, whose mass {name}.mass is; give the part another name")


def _alike(design: Design, tables: Mapping[str, Mapping[str, object]]) -> Iterator[Problem]:
    """Find parts whose results, overrides, places or lines of the dynamic model would have one name."""
    owners = dict.fromkeys(design.shafts, "shafts")
    for table in MACHINES:
        for name in tables[table]:
            if name in owners:
                what = "a shaft" if owners[name] == "shafts" else "a machine"
                rest = "results and overrides need different names; give it another"
                message = f"{owners[name]} has {what} of this name already; {rest}"
                yield Problem(f"{table}.{name}", message)
            owners.setdefault(name, table)
    lines = {f"{name} shaft": f"the shaft of {name!r}" for name in owners}
    lines |= {f"{name} hub": f"the hub of {name!r}" for name in design.shafts}
    lines |= {f"{name} clutch": f"the clutch {name!r}" for name in design.clutches}
    lines |= {f"{name} damper": f"the damper {name!r}" for name in design.dampers}
    for name in design.dampers:
        if name in design.clutches:
            yield Problem(f"dampers.{name}", "clutches has one of this name already; give the damper another")
    stages: dict[str, str] = {}
    for table in ("pairs", "planetaries", "epicyclics"):
        for name in tables[table]:
            if name in stages:
                yield Problem(f"{table}.{name}", f"{stages[name]} has a stage of this name too; give it another")
            stages[name] = table
    for name, table in (*owners.items(), *stages.items()):
        if name in lines and table != "shafts":
            yield Problem(f"{table}.{name}", f"the dynamic model calls {lines[name]} so; give it another name")
