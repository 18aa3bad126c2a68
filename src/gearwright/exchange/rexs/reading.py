"""REXS files as designs: shafts, gears, stages, bearings and loads.

Nothing is written or sized here; only a file of gearwright's own is held against the sizing of its design.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal, cast

from gearwright.arrays import ALIKE
from gearwright.errors import DesignError, Problem, refuse
from gearwright.exchange.rexs.arrangement import (
    Mounting,
    bodies_of,
    gears_of,
    lone_shafts,
    read_layout,
    read_materials,
    read_mounting,
    read_service,
    with_gears,
    with_places,
)
from gearwright.exchange.rexs.files import DESIGN, GEAR, MESH, Asking, Component, Document, opened, unsound
from gearwright.exchange.rexs.loads import read_clutches, read_loads, read_oil
from gearwright.exchange.rexs.stages import read_stages, refuse_nothing
from gearwright.identity import Role
from gearwright.showing import Shown
from gearwright.sizing import GearSizing, MeshSizing, Sizing, size
from gearwright.sizing.rating.iso6336 import Iso6336Rating
from gearwright.sizing.rating.iso10300 import Iso10300Rating
from gearwright.spec import Design, build, design_text, edited, parse
from gearwright.spec.design import FATIGUE
from gearwright.units import Ratio
from gearwright.verbs import verb

# ----------------------------------------------------------------------------------------------------------------------
# Files that gearwright wrote itself: their own design, with what another tool has changed since.
# ----------------------------------------------------------------------------------------------------------------------


SAME = 1e-9
"""Relative difference below which a number of the file is the one that was written [-]."""
Change = tuple[str, float]
"""Path in the design, and what stands there now."""


def own_design(asking: Asking, source: str) -> Design | None:
    """Return the design that travels in a file of gearwright's own, with what was changed since; None of other files.

    Args:
        asking: The document.
        source: Name of the file, for messages.

    Raises:
        DesignError: If the design in it is broken, or its gears are others than the file's.
    """
    units = [unit for unit in asking.document.of_kind("gear_unit") if DESIGN in unit.attributes]
    if not units:
        return None
    try:
        design = parse(units[0].attributes[DESIGN].text, source=source)
        sizing = size(design)
    except DesignError as error:
        said = f"does not give a design: {error.problems[0]}; remove the attribute to read what REXS itself says"
        line = units[0].attributes[DESIGN].line
        raise DesignError([Problem(f"{units[0].path}.{DESIGN}", said, line)], source) from None
    changes = dict(_changes(asking, sizing))
    refuse(asking.problems, source)
    _count_as_read(asking)
    asking.notes.append(f"the design is that of {DESIGN}; loads, shafts, bearings and materials are as it has them")
    asking.notes += [f"{path} is {value:.6g}, as the file has it now" for path, value in changes.items()]
    return edited(design, changes) if changes else design


def own_labels(asking: Asking) -> dict[int, str]:
    """Return gear -> what its design calls it, in a file of gearwright's own.

    Args:
        asking: The document.
    """
    components = asking.document.components
    return {number: label for number, component in components.items() if (label := asking.text(component, GEAR))}


def _count_as_read(asking: Asking) -> None:
    """Count as read what gearwright wrote from its own design."""
    for component in asking.document.components.values():
        asking.used.add(component.number)
        asking.asked.update(map(id, component.attributes.values()))
    for case in asking.document.cases:
        for said in case.values():
            asking.asked.update(map(id, said.attributes.values()))


def _changes(asking: Asking, sizing: Sizing) -> Iterator[Change]:
    """Yield what differs between the file and its own design as sized."""
    gears = {gear.name: gear for gear in sizing.gears}
    written = {name: [component for component in asking.document.components.values()
                      if asking.text(component, GEAR) == name] for name in gears}  # fmt: skip
    for name, gear in gears.items():
        for component in written[name]:
            yield from _of_gear(asking, sizing.design, gear, component)
    distances = {mesh.name: mesh for mesh in sizing.meshes}
    for stage in asking.document.of_kind("cylindrical_stage"):
        mesh, distance = distances.get(asking.text(stage, MESH)), asking.number(stage, "center_distance")
        if mesh is not None and distance is not None and not _same(distance, mesh.centre_distance):
            if mesh.stage in sizing.design.epicyclics:
                asking.refuse(stage, "has another center_distance than it was written with; change that in the design")
            else:
                yield f"{sizing.design.table(mesh.stage)}.centre_distance_m", distance


def _of_gear(asking: Asking, design: Design, gear: GearSizing, component: Component) -> Iterator[Change]:
    bevel = component.kind == "bevel_gear"
    table = design.table(gear.stage)
    own = f"{table}.{_table_of(gear)}.{gear.own}." if gear.stage in design.epicyclics else f"{table}."
    role = "" if gear.stage in design.epicyclics else f"{gear.role}_"
    module = asking.number(component, "mean_normal_module" if bevel else "normal_module")
    width, teeth = asking.number(component, "face_width"), asking.number(component, "number_of_teeth")
    if teeth is not None and round(abs(teeth)) != abs(gear.teeth):
        yield f"{own}{role}teeth", round(abs(teeth))
    if module is not None and not _same(module, gear.module):
        if bevel:
            asking.refuse(
                component,
                "has another mean_normal_module than it was written with; change outer_module_mm in the design",
            )
        else:
            yield f"{own}module_m", module
    if width is not None and not _same(width, gear.face_width):
        yield f"{own}face_width_m", width
    for flank in (flank for role_ in ("left", "right")
                  for flank in asking.document.related("flank", "gear", component.number, role_)):  # fmt: skip
        shift = asking.number(asking.document.components[flank], "addendum_modification_coefficient")
        if shift is not None and not _same(shift, gear.profile_shift):
            yield f"{own}{role}shift", shift


def _table_of(gear: GearSizing) -> str:
    return {Role.SUN: "suns", Role.RING: "rings"}.get(gear.role, "planets")


def _same(one: float, other: float) -> bool:
    return math.isclose(one, other, rel_tol=SAME, abs_tol=SAME * 1e-3)


# ----------------------------------------------------------------------------------------------------------------------
# Safeties of gears that a document states, to be held beside those of a sizing.
# ----------------------------------------------------------------------------------------------------------------------


Symbol = Literal["S_H", "S_F"]
SAFETIES: Mapping[str, tuple[Symbol, str]] = {
    "safety_factor_pitting_iso_6336_2019": ("S_H", "ISO 6336:2019"),
    "safety_factor_tooth_root_iso_6336_2019": ("S_F", "ISO 6336:2019"),
    "safety_factor_pitting_iso_6336_2006": ("S_H", "ISO 6336:2006"),
    "safety_factor_tooth_root_iso_6336_2006": ("S_F", "ISO 6336:2006"),
    "safety_factor_root_din_3990_1987": ("S_F", "DIN 3990:1987"),
    "safety_factor_pitting_iso_10300_2023": ("S_H", "ISO 10300:2023"),
    "safety_factor_tooth_root_iso_10300_2023": ("S_F", "ISO 10300:2023"),
    "safety_factor_pitting_iso_10300_2014": ("S_H", "ISO 10300:2014"),
    "safety_factor_tooth_root_iso_10300_2014": ("S_F", "ISO 10300:2014"),
}
"""Attribute -> what it is, and by which standard."""


@dataclass(frozen=True)
class Stated:
    """A safety of a gear in a mesh, as a file states it."""

    gear: str
    """As the design calls it, such as ``first.pinion``."""
    mate: str
    """The gear that it meshes with."""
    symbol: Symbol
    """Against pitting or against fracture of the root."""
    standard: str
    """By which it is."""
    value: Ratio
    """[-]"""
    line: int
    """Of the file [-]."""

    def ours(self, sizing: Sizing) -> float | None:
        """Return what a sizing of the design makes of it [-]; None where it rates by no ISO standard.

        Args:
            sizing: Of the design that was read.
        """
        for mesh in sizing.meshes:
            if {self.gear, self.mate} == set(mesh.gears):
                return _safety(mesh, mesh.gears.index(self.gear), self.symbol)
        return None


def _safety(mesh: MeshSizing, side: int, symbol: Symbol) -> float | None:
    rating = mesh.rating
    if not isinstance(rating, Iso6336Rating | Iso10300Rating):
        return None
    return float((rating.pitting if symbol == "S_H" else rating.bending)[side])


def read_stated(asking: Asking, labels: Mapping[int, str]) -> tuple[Stated, ...]:
    """Return every safety that a document states, once for equal planets and paths.

    Args:
        asking: The document.
        labels: Gear -> what the design calls it.
    """
    found: list[Stated] = []
    for stated in _all(asking, labels):
        if not any(_alike(stated, other) for other in found):
            found.append(stated)
    return tuple(found)


def _alike(first: Stated, second: Stated) -> bool:
    """Return whether two safeties are one and the same but for rounding."""
    same = replace(first, value=second.value, line=second.line) == second
    return same and math.isclose(first.value, second.value, rel_tol=ALIKE)


def _all(asking: Asking, labels: Mapping[int, str]) -> Iterator[Stated]:
    document = asking.document
    for relation in document.relations:
        roles = relation.roles
        data = document.components.get(roles.get("stage_gear_data", -1))
        if relation.kind != "stage_gear_data" or data is None or roles.get("gear") not in labels:
            continue
        asking.used.add(data.number)
        mate = _mate(document, roles.get("stage", -1), roles["gear"])
        for name, (symbol, standard) in SAFETIES.items():
            attribute = asking.attribute(data, name)
            value = None if attribute is None else asking.number(data, name)
            if attribute is not None and value is not None and mate in labels:
                yield Stated(labels[roles["gear"]], labels[mate], symbol, standard, value, attribute.line)


def _mate(document: Document, stage: int, gear: int) -> int:
    ends = (document.related("stage", "stage", stage, role) for role in ("gear_1", "gear_2"))
    return next((end for both in ends for end in both if end != gear), -1)


# ----------------------------------------------------------------------------------------------------------------------
# The verb: a REXS file as a design.
# ----------------------------------------------------------------------------------------------------------------------


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
