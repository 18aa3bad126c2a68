"""The verb: a REXS file as a design."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

from gearwright.errors import DesignError, Problem, refuse
from gearwright.exchange.rexs.files import opened, unsound
from gearwright.exchange.rexs.reading.arrangement import lone_shafts, read_layout, read_materials, read_service
from gearwright.exchange.rexs.reading.asking import Asking
from gearwright.exchange.rexs.reading.bodies import bodies_of, with_gears
from gearwright.exchange.rexs.reading.gearing import gears_of
from gearwright.exchange.rexs.reading.loads import read_clutches, read_loads, read_oil
from gearwright.exchange.rexs.reading.mounting import Mounting, read_mounting, with_places
from gearwright.exchange.rexs.reading.own import own_design, own_labels
from gearwright.exchange.rexs.reading.stages import read_stages, refuse_nothing
from gearwright.exchange.rexs.reading.stated import Stated, read_stated
from gearwright.showing import Shown
from gearwright.sizing import size
from gearwright.spec import Design, build, design_text, parse
from gearwright.spec.design import FATIGUE
from gearwright.verbs import verb


@dataclass(frozen=True, repr=False)
class ImportedRexs(Shown):
    """A design that was read from a REXS file, and what became of the rest of the file."""

    design: Design
    version: str
    """Of REXS."""
    application: str
    """What wrote the file."""
    assumed: tuple[str, ...]
    """What the file does not say, and what was taken instead."""
    not_read: tuple[str, ...]
    """Every kind of component and attribute that was not read: the line and path of the first, and how many more."""
    stated: tuple[Stated, ...] = ()
    """Safeties of gears that the file states; `Stated.ours` finds those of a sizing."""


@verb
def from_rexs(path: str | Path) -> ImportedRexs:
    """Return the design that a REXS file describes: parallel and bevel pairs, planetary sets, loads and load cases.

    A file that `to_rexs` wrote gives its own design again, with the teeth, modules, widths, shifts and centre distances
    that another tool has changed since.

    Args:
        path: Of a file of REXS 1.0 to 1.7: XML (.rexs), JSON (.rexsj), or one of them in an archive (.rexsz).

    Raises:
        DesignError: With every problem of the file: its line, path, what was given, what is allowed and the fix.

    Source: REXS 1.0 to 1.7, FVA GmbH, rexs.info.
    """
    source = str(path)
    document = with_gears(opened(path))
    refuse(unsound(document), source)
    asking = Asking(document)
    own = own_design(asking, source)
    design, labels = _design(asking, source) if own is None else (own, own_labels(asking))
    stated = read_stated(asking, labels)
    _refuse(asking, source)
    notes = tuple(dict.fromkeys(asking.notes))
    return ImportedRexs(design, document.version, document.application, notes, asking.unread(), stated)


def _design(asking: Asking, source: str) -> tuple[Design, Mapping[int, str]]:
    """Return a design of what REXS itself says, and what it calls the gears."""
    document = asking.document
    bodies, gears = bodies_of(asking), gears_of(asking)
    gearing = read_stages(asking, bodies, gears)
    refuse_nothing(asking, gearing)
    _refuse(asking, source)
    read_clutches(asking, bodies, gearing)
    loads = read_loads(asking, bodies, gearing)
    _refuse(asking, source)
    units = document.of_kind("gear_unit")
    asking.used |= {unit.number for unit in units}
    name = next((asking.text(unit, "model_name") or unit.name for unit in units), "") or "gearbox"
    rules = read_materials(asking, gearing, gears)
    layout = read_layout(asking, bodies, gearing, gears)
    mounting = read_mounting(asking, bodies, gearing, lone_shafts(asking, bodies, gearing, layout))
    table: dict[str, Any] = {
        "schema": 1, "name": name, "description": f"Read from {Path(source).name}: REXS {document.version}"
        f" of {document.application or 'an unnamed tool'}",
        "shafts": gearing.shafts, "pairs": gearing.pairs, "planetaries": gearing.planetaries,
        "epicyclics": gearing.compounds,
        "clutches": gearing.clutches,
        "gears": rules, "layout": layout,
        "oil": read_oil(asking), "service": read_service(asking) if rules["rating"] == FATIGUE else {},
    }  # fmt: skip
    _refuse(asking, source)
    whole = {key: value for key, value in (table | loads).items() if value}
    return _mounted(asking, whole, mounting, source), gearing.labels


def _mounted(asking: Asking, table: Mapping[str, Any], mounting: Mounting, source: str) -> Design:
    """Return a design with what sits where on its shafts, shaft by shaft as far as it can then be sized."""
    best, table = _made(table, source), dict(table)
    wishes = [("places on the shafts", with_places(table, mounting), frozenset[int]())]
    wishes += [(f"bearings of {name}", {"bearings": seats}, read) for name, seats, read in mounting.shafts]
    for what, wish, read in wishes:
        wanted = table | wish | {"bearings": {**table.get("bearings", {}), **wish.get("bearings", {})}}
        try:
            design = _made({key: value for key, value in wanted.items() if value}, source)
            size(design)
        except DesignError as error:
            asking.notes.append(f"{what} are not taken, for {error.problems[0]}")
            continue
        best, table = design, wanted
        asking.used |= read
    return best


def _refuse(asking: Asking, source: str) -> None:
    """Raise for every problem so far, in the order of the file."""
    refuse(sorted(dict.fromkeys(asking.problems), key=lambda problem: (problem.line or 0, problem.path)), source)


def _made(table: Mapping[str, Any], source: str) -> Design:
    record, written = build(Design, table)
    if record is None or written.problems:
        raise DesignError([_of_design(problem) for problem in written.problems], source)
    try:
        return parse(design_text(cast(Design, record)), source=source)
    except DesignError as error:
        raise DesignError([_of_design(problem) for problem in error.problems], source) from None


def _of_design(problem: Problem) -> Problem:
    """Return a problem of the design that was read; lines of its text are no lines of the file."""
    return Problem(problem.path, f"{problem.message} (in the design that was read)")
