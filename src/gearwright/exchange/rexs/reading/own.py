"""Files that gearwright wrote itself: their own design, with what another tool has changed since."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gearwright.errors import DesignError, Problem, refuse
from gearwright.exchange.rexs.files import Component
from gearwright.exchange.rexs.reading.asking import Asking
from gearwright.exchange.rexs.words import DESIGN, GEAR, MESH
from gearwright.identity import Role
from gearwright.sizing import GearSizing, Sizing, size
from gearwright.spec import Design, edited, parse

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
