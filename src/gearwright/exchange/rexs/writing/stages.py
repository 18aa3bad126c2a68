"""Meshes as stages of REXS, with what standards make of them."""

from __future__ import annotations

from gearwright.exchange.rexs.words import MESH
from gearwright.exchange.rexs.writing.shafts import write_planets
from gearwright.exchange.rexs.writing.sheet import Value
from gearwright.exchange.rexs.writing.task import Task
from gearwright.shape import Contact, bevel_pair, kind_of, sized_mesh
from gearwright.sizing import MeshSizing
from gearwright.sizing.rating.iso6336 import Iso6336Rating
from gearwright.sizing.rating.iso10300 import Iso10300Rating
from gearwright.spec import GROUND


def write_sets(task: Task) -> dict[str, int]:
    """Write every planetary and compound set; return set -> its number.

    Args:
        task: Whose shafts are written.
    """
    numbers = {}
    for stage, members in task.sizing.design.sets.items():
        number = numbers[stage] = task.sheet.add("planetary_stage", stage, {})
        task.sheet.relate("assembly", {"assembly": task.unit, "part": number})
        write_planets(task, stage, number)
        for shaft in dict.fromkeys(members.members):
            if shaft not in (GROUND, members.carrier):
                task.sheet.relate("central_shaft", {"planetary_stage": number, "shaft": task.shafts[shaft]})
    return numbers


def write_stages(task: Task, sets: dict[str, int]) -> None:
    """Write every mesh of single gears as a stage.

    Args:
        task: Whose gears are written.
        sets: Set -> number of its planetary stage.
    """
    for stand in task.stands:
        held = task.shafts.get(f"{stand.name} shaft")
        if stand.node == GROUND and stand.gear.stage in sets and held:
            task.sheet.relate("central_shaft", {"planetary_stage": sets[stand.gear.stage], "shaft": held})
    for contact in task.contacts:
        gears = [task.gears.get(stand.name, ()) for stand in (contact.first, contact.second)]
        for first, second in zip(*gears, strict=False):
            _stage(task, contact, (first, second), sets.get(contact.mesh.stage, task.unit))


def _stage(task: Task, contact: Contact, gears: tuple[int, int], whole: int) -> None:
    sizing, mesh = task.sizing, sized_mesh(task.sizing, contact.mesh)
    is_bevel = kind_of(sizing, mesh.stage) == "bevel"
    number = task.sheet.add(
        "bevel_stage" if is_bevel else "cylindrical_stage",
        f"{contact.first.name} - {contact.second.name}",
        (_bevel if is_bevel else _cylindrical)(task, mesh) | {MESH: mesh.name},
    )
    task.sheet.relate("assembly", {"assembly": whole, "part": number})
    task.sheet.relate("stage", {"stage": number, "gear_1": gears[0], "gear_2": gears[1]})
    for side, gear in enumerate(gears):
        attributes = _safeties(mesh, side)
        if attributes:
            kind = "bevel_stage_gear_data" if is_bevel else "cylindrical_stage_gear_data"
            name = f"{(contact.first, contact.second)[side].name} in this stage"
            data = task.sheet.add(kind, name, attributes)
            task.sheet.relate("stage_gear_data", {"stage": number, "gear": gear, "stage_gear_data": data})


def _cylindrical(task: Task, mesh: MeshSizing) -> dict[str, Value]:
    widths = {gear.name: gear.face_width for gear in task.sizing.gears}
    attributes: dict[str, Value] = {
        "center_distance": mesh.centre_distance, "common_face_width": min(widths[gear] for gear in mesh.gears),
        "mesh_load_factor_iso_6336_2019": mesh.load_factor,
    }  # fmt: skip
    if isinstance(mesh.rating, Iso6336Rating):
        loads = mesh.rating.factors.loads
        attributes |= {
            "application_factor_iso_6336_2019": float(loads.application),
            "dynamic_factor_iso_6336_2019": float(loads.dynamic),
            "face_load_factor_contact_stress_iso_6336_2019": float(loads.face_contact),
            "transverse_load_factor_contact_stress_iso_6336_2019": float(loads.transverse_contact),
        }
    return attributes


def _bevel(task: Task, mesh: MeshSizing) -> dict[str, Value]:
    pair = bevel_pair(task.sizing, mesh.stage)
    return {"shaft_angle": pair.shaft_angle, "outer_transverse_module": pair.outer_module, "hypoid_offset": 0.0}


def _safeties(mesh: MeshSizing, side: int) -> dict[str, Value]:
    """Return S_H and S_F of one gear under all cases, and its stresses in the heaviest case."""
    rating = mesh.rating
    if isinstance(rating, Iso10300Rating):
        return {
            "safety_factor_pitting_iso_10300_2023": float(rating.pitting[side]),
            "safety_factor_tooth_root_iso_10300_2023": float(rating.bending[side]),
        }
    if not isinstance(rating, Iso6336Rating):
        return {}
    factors = rating.factors
    return {
        "number_of_load_cycles": float(factors.cycles[side]),
        "contact_stress_iso_6336_2019": float(factors.pitting.stresses[side]),
        "permissible_contact_stress_iso_6336_2019": float(factors.pitting.permissible[side]),
        "tooth_root_stress_iso_6336_2019": float(factors.bending[side].stress),
        "safety_factor_pitting_iso_6336_2019": float(rating.pitting[side]),
        "safety_factor_tooth_root_iso_6336_2019": float(rating.bending[side]),
    }
