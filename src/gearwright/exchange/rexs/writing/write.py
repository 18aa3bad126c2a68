"""The verb: a sizing as a REXS file."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from gearwright.errors import Problem, near, refuse
from gearwright.exchange.rexs.words import DESIGN, VERSIONS, Version
from gearwright.exchange.rexs.writing.forms import FORMS, Form, formed
from gearwright.exchange.rexs.writing.gears import write_gears
from gearwright.exchange.rexs.writing.loads import write_cases, write_clutches, write_machines
from gearwright.exchange.rexs.writing.shafts import write_shafts
from gearwright.exchange.rexs.writing.sheet import Sheet
from gearwright.exchange.rexs.writing.stages import write_sets, write_stages
from gearwright.exchange.rexs.writing.task import Task
from gearwright.shape import contacts_of, stands_of
from gearwright.showing import Shown
from gearwright.sizing import Sizing
from gearwright.spec import design_text
from gearwright.verbs import verb


@dataclass(frozen=True, repr=False)
class RexsFile(Shown):
    """A sized gearbox as a file of REXS."""

    content: bytes
    """The file: XML or JSON in UTF-8, or an archive."""
    version: Version
    components: int
    """How many it holds [-]."""
    left_out: tuple[str, ...]
    """What the gearbox has and REXS has no words for."""


@verb
def to_rexs(sizing: Sizing, *, version: Version = "1.7", form: Form = "rexs") -> RexsFile:
    """Return a sized gearbox as a REXS file: shafts, gears, stages, bearings, materials, loads and load cases.

    What REXS has no words for is listed; the design itself travels along as an attribute of gearwright's own, so that
    `from_rexs` makes the same design of the file.

    Args:
        sizing: As sized.
        version: Of REXS.
        form: ``rexs`` is XML, ``rexsj`` JSON, ``rexsz`` XML in an archive.

    Source: REXS 1.7 database and schema, FVA GmbH, rexs.info.

    >>> import gearwright as gw
    >>> file = gw.to_rexs(gw.size(gw.read("star")))
    >>> file.content[3:22], file.version
    (b'<?xml version="1.0"', '1.7')
    """
    if version not in VERSIONS:
        refuse([Problem("version", f"REXS {version} is not written; {near(str(version), VERSIONS)}")])
    if form not in FORMS:
        refuse([Problem("form", f"{form!r} is no form of a REXS file; {near(str(form), FORMS)}")])
    stands = stands_of(sizing)
    task = Task(sizing, Sheet(version), stands, contacts_of(sizing, stands))
    _whole(task)
    write_shafts(task)
    sets = write_sets(task)
    write_gears(task)
    write_stages(task, sets)
    write_machines(task)
    write_clutches(task)
    write_cases(task)
    sheet = task.sheet
    newer = [f"attributes that REXS {version} does not have: {', '.join(sorted(sheet.newer))}"] if sheet.newer else []
    content = formed(sheet.text(), form)
    return RexsFile(content, version, len(sheet.components), (*_left_out(sizing), *newer))


def _whole(task: Task) -> None:
    """Write the gear unit, its housing and its oil."""
    sizing, sheet = task.sizing, task.sheet
    oil = sizing.design.oil
    task.unit = sheet.add("gear_unit", sizing.design.name, {
        "model_name": sizing.design.name, "operating_time": sizing.design.service.life, DESIGN: _toml(sizing),
    })  # fmt: skip
    task.casing = sheet.add("gear_casing", "housing", {"temperature_lubricant": oil.temperature})
    sheet.relate("assembly", {"assembly": task.unit, "part": task.casing})
    lubricant = sheet.add("lubricant", "oil", {
        "kind": "oil", "viscosity_at_40_degree_celsius": oil.viscosity_40,
        "viscosity_at_100_degree_celsius": oil.viscosity_100,
    })  # fmt: skip
    sheet.relate("reference", {"origin": task.casing, "referenced": lubricant})


def _toml(sizing: Sizing) -> str:
    """Return the design as TOML in characters that every XML file can hold."""
    text = design_text(sizing.design)
    return "".join(mark if mark == "\n" or " " <= mark <= "\ud7ff" else f"\\U{ord(mark):08x}" for mark in text)


def _left_out(sizing: Sizing) -> Iterator[str]:
    """Yield what REXS has no words for."""
    design = sizing.design
    for name, pair in design.pairs.items():
        if pair.kind == "face":
            yield f"pairs.{name}: REXS has no face gears; its pinion is written without a stage, its wheel is not"
        if pair.halves > 1:
            yield f"pairs.{name}: the halves of its double-helical gears stand as gears side by side, without a gap"
    for name in design.epicyclics:
        yield f"epicyclics.{name}: its planets stand as one planetary stage, which others may read as a simple set"
    for name, clutch in design.clutches.items():
        if clutch.kind == "overrunning":
            yield f"clutches.{name}: couplings of REXS do not overrun; each load case says whether it holds"
    for name in design.dampers:
        yield f"dampers.{name}: REXS has no dampers between shafts"
    for joint in sizing.joints:
        if joint.kind != "integral":
            yield f"joints.{joint.part}: the {joint.kind} is not written; the gear stands on its shaft"
    for name, screw in design.airscrews.items():
        if screw.thrust:
            yield f"{name}: its thrust and other forces are not written, its torque is"
    if design.errors:
        yield "errors: deviations of parts from the drawing"
    yield "rules of rating, sizing and dynamics, and what machines are: only in the attribute custom_gearwright_design"
