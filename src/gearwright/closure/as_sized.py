"""A design as it was sized: every size written, so that other loads meet the same gearbox."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.closure.proportion import Proportioned, teeth_of, written_out
from gearwright.errors import Problem, refuse
from gearwright.sizing import Sizing, size
from gearwright.spec import Design, edited
from gearwright.spec.design import Pair, module_owners
from gearwright.spec.edit import Value

_MM = 1e-3


def as_sized(design: Design) -> Design:
    """Return a design with teeth, modules, widths, shafts and pins written as they are sized.

    Planets on rolling bearings still choose them, and with them their bores, for the loads that they meet.

    Args:
        design: With freedoms, of a level below ``built``.

    Raises:
        DesignError: If it cannot be sized, or has parts that are chosen anew for other loads: built shafts, bevels and
            compound sets whose modules are left open.
    """
    sizing = size(design)
    refuse(list(_open(design, sizing)))
    own = edited(design, dict(teeth_of(design, sizing)))
    whole = edited(own, dict(_sizes(own, sizing)))
    return written_out(Proportioned(whole, size(whole), {})).design


def _open(design: Design, sizing: Sizing) -> Iterator[Problem]:
    """Yield what cannot be written as it is sized."""
    if sizing.level == "built":
        message = "a built gearbox chooses its shafts and bearings for its loads; give a level below it"
        yield Problem("level", message)
    for stage in dict.fromkeys(gear.stage for gear in sizing.gears):
        own = design.simple_stages.get(stage)
        if own is None or (isinstance(own, Pair) and own.kind == "bevel"):
            key = "module" if own is None else "outer_module"
            if f"{stage}.{key}" not in sizing.given:
                message = f"its module follows from the loads; give {key}_mm and face_width_mm to keep its size"
                yield Problem(f"{design.table(stage)}.{key}_mm", message)


def _sizes(design: Design, sizing: Sizing) -> Iterator[tuple[str, Value]]:
    """Yield modules and widths that the design leaves open."""
    owners = module_owners(design)
    gears = {gear.stage: gear for gear in sizing.gears}
    for name, stage in design.simple_stages.items():
        if isinstance(stage, Pair) and stage.kind == "bevel":
            continue
        if f"{name}.module" not in sizing.given and owners[name] == name:
            yield f"{design.table(name)}.module_mm", gears[name].module / _MM
        if f"{name}.face_width" not in sizing.given:
            yield f"{design.table(name)}.face_width_mm", gears[name].face_width / _MM
