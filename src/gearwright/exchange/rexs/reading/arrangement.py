"""Where shafts of a document stand and what sits where on them, and of what gears are made, as tables of a design."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from gearwright.arrays import Floats
from gearwright.catalogue import materials
from gearwright.exchange.rexs.files import Component
from gearwright.exchange.rexs.reading.asking import Asking
from gearwright.exchange.rexs.reading.bodies import Bodies
from gearwright.exchange.rexs.reading.gearing import Gear, Gearing
from gearwright.spec.design import FATIGUE, STATIC

Table = dict[str, Any]
CASE_HARDENED = "18CrNiMo7-6"
"""Steel of bevel gears whose own is not known."""


@dataclass(frozen=True)
class Sections:
    """Cylinders and cones of a shaft, as a file has them."""

    length: float
    """From the shaft's first end to the end of the last [m]."""
    outer: tuple[float, ...]
    """Diameters at both ends of each [m]."""
    inner: tuple[float, ...]


def read_sections(asking: Asking) -> dict[int, Sections]:
    """Return shaft -> its sections; count all of them as read, as `told` says which are there.

    Args:
        asking: The document.
    """
    found: dict[int, Sections] = {}
    for shaft in asking.document.of_kind("shaft"):
        asking.used.add(shaft.number)
        asking.number(shaft, "mass_of_component")
        parts = asking.document.related("assembly", "assembly", shaft.number, "part")
        sections = [section for part in parts if (section := asking.document.components[part]).kind == "shaft_section"]
        asking.used |= {section.number for section in sections}
        ends = [
            (asking.number(section, "u_coordinate_on_shaft") or 0.0) + (asking.number(section, "length") or 0.0)
            for section in sections
        ]
        outer, inner = (
            tuple(
                asking.number(section, f"{side}_diameter_{end}") or 0.0
                for section in sections
                for end in ("begin", "end")
            )
            for side in ("outer", "inner")
        )
        found[shaft.number] = Sections(max(ends, default=0.0), outer, inner)
    return found


def told(sections: Mapping[str, Sequence[Sections]]) -> str:
    """Return what is said of the steps of shafts, which a design has no words for.

    Args:
        sections: Of the components that each shaft is.
    """
    said = []
    for name, parts in sections.items():
        outer = [diameter for part in parts for diameter in part.outer]
        inner = max((diameter for part in parts for diameter in part.inner), default=0.0)
        if outer:
            range_ = " to ".join(f"{1e3 * diameter:g}" for diameter in sorted({min(outer), max(outer)}))
            bore = f", bored {1e3 * inner:g} mm" if inner else ""
            said.append(f"{name} {len(outer) // 2} of {range_} mm{bore}")
    return (
        "sections of shafts are not read, as a design states one diameter and one bore of a shaft (diameter_mm, bore_mm"
        f" of layout.NAME), and its steps follow from strength, bearings and joints. The file has {'; '.join(said)}"
        if said
        else ""
    )


def read_layout(asking: Asking, bodies: Bodies, gearing: Gearing, gears: Mapping[int, Gear]) -> Table:
    """Return the table of shafts whose axes and lengths a design can hold: those of trains of parallel pairs.

    Args:
        asking: The document.
        bodies: What of it turns as one.
        gearing: Its gears and stages.
        gears: Gears by id.
    """
    sections = read_sections(asking)
    shafts = {name: [number for number in sections if bodies.name_of(number) == name] for name in gearing.shafts}
    steps = told({name: [sections[number] for number in numbers] for name, numbers in shafts.items()})
    asking.notes += [steps] if steps else []
    if gearing.planetaries or gearing.compounds or any(pair.get("kind") == "bevel" for pair in gearing.pairs.values()):
        asking.notes.append("lengths and places of shafts are not read in a train with planetary or bevel stages")
        return {}
    layout: Table = {}
    for name, numbers in shafts.items():
        if len(numbers) == 1 and sections[numbers[0]].length > 0.0:
            layout[name] = {"length_m": sections[numbers[0]].length}
    for shaft, angle in _angles(asking, gearing, shafts, gears).items():
        layout.setdefault(shaft, {})["angle_rad"] = angle
    return layout


def lone_shafts(asking: Asking, bodies: Bodies, gearing: Gearing, layout: Table) -> dict[str, Component]:
    """Return shaft of the layout -> its component, of those that are one component along +u.

    Args:
        asking: The document.
        bodies: What of it turns as one.
        gearing: Its gears and stages.
        layout: As read so far.
    """
    components = asking.document.of_kind("shaft")
    alone = {name: [part for part in components if bodies.name_of(part.number) == name] for name in gearing.shafts}
    return {
        name: parts[0] for name, parts in alone.items()
        if len(parts) == 1 and "length_m" in layout.get(name, {}) and _axis(asking, [parts[0].number]) is not None
    }  # fmt: skip


def _angles(
    asking: Asking, gearing: Gearing, shafts: Mapping[str, Sequence[int]], gears: Mapping[int, Gear]
) -> dict[str, float]:
    """Return shaft -> direction of its axis from the one that it meshes with, of those that stand along +u [rad]."""
    places = {name: _axis(asking, numbers) for name, numbers in shafts.items()}
    seen, angles = set(gearing.shafts[:1]), dict[str, float]()
    for pair in gearing.pairs.values():
        ends = [gearing.shaft(pair[role]) for role in ("pinion", "wheel")]
        ends.sort(key=lambda shaft: shaft not in seen)
        first, second = (places.get(end) for end in ends)
        if first is not None and second is not None and ends[1] not in seen:
            way = second - first
            if math.hypot(way[1], way[2]) > 0.0:
                angles[ends[1]] = math.atan2(way[2], way[1])
        seen |= set(ends)
    return angles


def _axis(asking: Asking, numbers: Sequence[int]) -> Floats | None:
    """Return a place on the axis of a shaft [m], shape (3,); None where it does not stand along +u."""
    for number in numbers:
        shaft = asking.document.components[number]
        origin, along = asking.vector(shaft, "support_vector"), asking.vector(shaft, "u_axis_vector")
        if origin and along and len(origin) == len(along) == 3 and along[0] > 0.999e-3 * math.hypot(*along) / 1e-3:
            return np.asarray(origin)
    return None


def read_service(asking: Asking) -> Table:
    """Return the table of the service: the life, and K_A where all stages have the same.

    Args:
        asking: The document.
    """
    units = asking.document.of_kind("gear_unit")
    lives = [value for unit in units if (value := asking.number(unit, "operating_time"))]
    stages = asking.document.of_kind("cylindrical_stage")
    factors = {value for stage in stages if (value := asking.number(stage, "application_factor_iso_6336_2019"))}
    if len(factors) > 1:
        asking.notes.append(
            f"of the application factors {', '.join(map('{:g}'.format, sorted(factors)))} the largest stands"
        )
    table: Table = {"life_s": lives[0]} if lives else {}
    return table | ({"application_factor": max(factors)} if factors else {})


def read_materials(asking: Asking, gearing: Gearing, gears: Mapping[int, Gear]) -> Table:
    """Return the rules of gears that follow from their materials.

    Args:
        asking: The document.
        gearing: Its stages.
        gears: Gears by id.
    """
    document = asking.document
    rings = {gear.number for gear in gears.values() if gear.component.kind == "ring_gear"}
    wheels = rings | gearing.wheels
    names: dict[str, set[str]] = {"first": set(), "wheel": set()}
    for gear in gears.values():
        for number in document.related("reference", "origin", gear.number, "referenced"):
            component = document.components[number]
            if component.kind == "material":
                asking.used.add(number)
                side = "wheel" if gear.number in wheels else "first"
                names[side].add(asking.text(component, "material_designation") or component.name)
    first, wheel = (sorted(names[key]) for key in ("first", "wheel"))
    if len(first) != 1 or len(wheel) > 1 or not {*first, *wheel} <= materials().keys():
        listed = ", ".join(sorted({*first, *wheel}))
        said = f"materials {listed} of the gears are not those" if listed else "gears have no material: they are not"
        bevel = any(gear.component.kind == "bevel_gear" for gear in gears.values())
        taken = (
            CASE_HARDENED if bevel else "nitriding-steel-785"
        )  # Lewis and Hertz, with which the other goes, has no bevels
        asking.notes.append(f"{said} of the catalogue that one design can hold; {taken} stands for them")
        return {"material": taken, "rating": FATIGUE} if bevel else {"rating": STATIC}
    asking.notes.append(f"materials {', '.join(sorted({*first, *wheel}))} are those of the catalogue, by their names")
    rules: Table = {"material": first[0]}
    steel = materials()[first[0]].steel
    if steel is None or (wheel and materials()[wheel[0]].steel is None):
        return {**rules, "rating": STATIC}
    rules["rating"] = FATIGUE
    if wheel and wheel != first:
        other = materials()[wheel[0]]
        rules["iso6336"] = {"wheel": {"steel": other.steel, "grade": other.grade or "MQ"}}
        if other.hardness is not None:
            rules["iso6336"]["wheel"]["hardness_hv"] = other.hardness
    return rules
