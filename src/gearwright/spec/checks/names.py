"""What can be wrong with names: some that no path of a result can hold, and two parts that would be called alike."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from gearwright.errors import Problem
from gearwright.spec.bounds import NAME_RULE, is_name
from gearwright.spec.design import GROUND, MACHINES, WEIGHED, Case, Design
from gearwright.spec.keys import keys_of

STAGES = {"pairs": "the pair", "planetaries": "the set", "epicyclics": "the set"}
"""Table of stages -> what stands in it."""
ALONE = {
    **dict.fromkeys(MACHINES, "the machine"), **STAGES, "clutches": "the clutch", "dampers": "the damper",
    "bearings": "the bearing",
}  # fmt: skip
"""Table -> what stands in it, of parts that lie along shafts by their names, which therefore differ."""
_DIFFERENT = "results, places along shafts and overrides need different names: rename"


def name_problems(design: Design) -> Iterator[Problem]:
    """Yield every name of a design that cannot be one.

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
    yield from _in_the_model(design)


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


def alike_problems(design: Design) -> Iterator[Problem]:
    """Yield every part that is called like another, where results, places or overrides know them by their names.

    Args:
        design: As typed.
    """
    owners = dict[str, str]()
    for table, what in ALONE.items():
        for name in getattr(design, table):
            path = f"{table}.{name}"
            if table in MACHINES and name in design.shafts:
                yield Problem(path, f"shafts has a shaft of this name already; {_DIFFERENT} {what}")
            elif (first := owners.setdefault(name, path)) != path:
                yield Problem(path, f"{first} is called {name!r} already; {_DIFFERENT} {what}")


def _in_the_model(design: Design) -> Iterator[Problem]:
    """Find parts that are called like a line of the dynamic model."""
    lines = {f"{name} shaft": f"the shaft of {name!r}" for name in (*design.shafts, *design.machines)}
    lines |= {f"{name} hub": f"the hub of {name!r}" for name in design.shafts}
    lines |= {f"{name} clutch": f"the clutch {name!r}" for name in design.clutches}
    lines |= {f"{name} damper": f"the damper {name!r}" for name in design.dampers}
    for table in (*MACHINES, *STAGES):
        for name in getattr(design, table):
            if name in lines:
                yield Problem(f"{table}.{name}", f"the dynamic model calls {lines[name]} so; give it another name")
