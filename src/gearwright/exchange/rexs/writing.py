"""Sizings as REXS files: components with their numbers, relations and load cases.

Nothing is read or sized here.
"""

import codecs
import io
import json
import math
import zipfile
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime
from typing import Any, Literal
from xml.etree import ElementTree

import numpy as np

from gearwright.base import Floats, Problem, Shown, near, refuse, smallest, verb
from gearwright.exchange.rexs.files import (
    ABSORBS,
    BEARING_TYPES,
    DESIGN,
    GEAR,
    MESH,
    OWN,
    UNITS,
    VERSIONS,
    Version,
    words,
)
from gearwright.parts import Material
from gearwright.parts.bevel_geometry import Hand
from gearwright.shape import (
    Contact,
    Stand,
    bevel_pair,
    contacts_of,
    cylindrical_gear,
    halves_of,
    hand_of,
    is_internal,
    kind_of,
    sized_mesh,
    stands_of,
)
from gearwright.sizing import CarrierSizing, MeshSizing, ShaftSizing, Sizing, governing_case
from gearwright.sizing.rating.iso6336 import Iso6336Rating
from gearwright.sizing.rating.iso10300 import Iso10300Rating
from gearwright.spec import GROUND, design_text, levels_of, shares_of
from gearwright.version import __version__

# ----------------------------------------------------------------------------------------------------------------------
# A REXS file as it is put together: numbered components with attributes in REXS's units, relations, load cases.
# ----------------------------------------------------------------------------------------------------------------------


Value = float | int | str | bool | Sequence[float] | None
"""What an attribute may be, in SI; None is not written."""
BEGIN = codecs.BOM_UTF8 + b'<?xml version="1.0" encoding="UTF-8"?>\n'
"""How a file begins."""
DIGITS = 15
"""Digits with which numbers are written [-]."""


@dataclass
class Sheet:
    """A file in the making."""

    version: Version
    components: list[ElementTree.Element] = field(default_factory=list)
    relations: list[ElementTree.Element] = field(default_factory=list)
    cases: list[Mapping[int, Mapping[str, Value]]] = field(default_factory=list)
    kinds: dict[int, str] = field(default_factory=dict)
    left_out: list[str] = field(default_factory=list)
    """What REXS cannot hold, or this version of it."""
    newer: set[str] = field(default_factory=set)
    """Attributes that this version does not have."""

    def add(self, kind: str, name: str, attributes: Mapping[str, Value]) -> int:
        """Add a component and return its number.

        Args:
            kind: Type of the component.
            name: As people read it.
            attributes: In SI.
        """
        number = len(self.components) + 1
        element = ElementTree.Element("component", id=str(number), type=kind, name=_fit(name))
        self._fill(element, attributes)
        self.components.append(element)
        self.kinds[number] = kind
        return number

    def relate(self, kind: str, roles: Mapping[str, int]) -> None:
        """Add a relation.

        Args:
            kind: Type of the relation.
            roles: Component by role.
        """
        element = ElementTree.Element("relation", id=str(len(self.relations) + 1), type=kind)
        for role, number in roles.items():
            ElementTree.SubElement(element, "ref", id=str(number), role=role, hint=self.kinds[number])
        self.relations.append(element)

    def text(self) -> bytes:
        """Return the file, UTF-8 with the mark that REXS files begin with."""
        root = ElementTree.Element(
            "model", version=self.version, applicationId="gearwright", applicationVersion=__version__,
            date=datetime.now(UTC).isoformat(timespec="seconds"), applicationLanguage="en",
        )  # fmt: skip
        ElementTree.SubElement(root, "relations").extend(self.relations)
        ElementTree.SubElement(root, "components").extend(self.components)
        spectrum = ElementTree.SubElement(root, "load_spectrum", id="1")
        for place, case in enumerate(self.cases, start=1):
            element = ElementTree.SubElement(spectrum, "load_case", id=str(place))
            for number, attributes in case.items():
                child = ElementTree.SubElement(element, "component", id=str(number), type=self.kinds[number])
                self._fill(child, attributes)
        ElementTree.indent(root)
        return BEGIN + ElementTree.tostring(root, encoding="unicode").encode()

    def _fill(self, element: ElementTree.Element, attributes: Mapping[str, Value]) -> None:
        for name, value in attributes.items():
            if value is None or (isinstance(value, float) and not math.isfinite(value)):
                continue
            if name in OWN:
                ElementTree.SubElement(element, "attribute", id=name, unit="none").text = _fit(str(value))
                continue
            word = words()[name]
            if VERSIONS.index(word.since) < VERSIONS.index(self.version):
                self.newer.add(name)
                continue
            child = ElementTree.SubElement(element, "attribute", id=name, unit=word.unit)
            factor = UNITS[word.unit].factor
            if isinstance(value, str) or not isinstance(value, Iterable):
                child.text = _written(value, factor)
                continue
            array = ElementTree.SubElement(child, "array")
            for entry in value:
                ElementTree.SubElement(array, "c").text = _written(entry, factor)


def _written(value: object, factor: float) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return _fit(value)
    return f"{value / factor + 0.0:.{DIGITS}g}" if isinstance(value, float) else str(value)


def _fit(text: str) -> str:
    """Return a text without what XML cannot hold."""
    return "".join(mark if _fits(mark) else "\N{REPLACEMENT CHARACTER}" for mark in text)


def _fits(mark: str) -> bool:
    return mark in "\t\n\r" or " " <= mark <= "\ud7ff" or "\ue000" <= mark <= "\ufffd" or mark >= "\U00010000"


# ----------------------------------------------------------------------------------------------------------------------
# What the parts of the writer share: the sizing, the file in the making, and the numbers of its components.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass
class Task:
    """A sizing on its way into a file."""

    sizing: Sizing
    sheet: Sheet
    stands: tuple[Stand, ...]
    contacts: tuple[Contact, ...]
    unit: int = 0
    """Number of the gear unit."""
    casing: int = 0
    """Number of the housing."""
    shafts: dict[str, int] = field(default_factory=dict)
    """Shaft -> its number."""
    planets: dict[tuple[str, int], int] = field(default_factory=dict)
    """Body of planets and which of the equal ones -> number of its shaft."""
    gears: dict[str, tuple[int, ...]] = field(default_factory=dict)
    """Gear where it stands -> its number, or those of its halves."""
    loads: dict[str, int] = field(default_factory=dict)
    """Machine -> its number."""
    materials: dict[Material, int] = field(default_factory=dict)

    def material(self, name: str, of: int) -> None:
        """Say of what a component is made.

        Args:
            name: Of the material.
            of: Number of the component.
        """
        made = self.sizing.design.material(name)
        if made not in self.materials:
            self.materials[made] = self.sheet.add("material", made.name, _material(made))
        self.sheet.relate("reference", {"origin": of, "referenced": self.materials[made]})


def _material(made: Material) -> dict[str, Value]:
    return {
        "material_designation": made.name, "elastic_modulus": made.elastic_modulus,
        "poisson_ratio": made.poisson_ratio, "density": made.density, "yield_strength": made.yield_strength,
        "tensile_strength": made.ultimate_strength, "surface_hardness_vickers": made.hardness,
        "allowable_stress_number_contact_iso_6336_2016": made.contact_strength,
        "nominal_stress_number_tooth_root_iso_6336_2016": made.bending_strength,
    }  # fmt: skip


def placed(origin: Floats, along: Iterable[float], up: Iterable[float], unit: int) -> dict[str, Value]:
    """Return the attributes that say where a component stands.

    Args:
        origin: Of its own axes [m], shape (3,).
        along: Its u axis, shape (3,).
        up: Its w axis, shape (3,).
        unit: Number of the component in whose axes that is said.
    """
    return {
        "support_vector": tuple(map(float, origin)), "u_axis_vector": _direction(along),
        "w_axis_vector": _direction(up), "reference_component_for_position": unit,
    }  # fmt: skip


def _direction(way: Iterable[float]) -> tuple[float, ...]:
    """Return a direction that reads as one of length 1 in the database's unit, which is mm."""
    return tuple(float(part) * 1e-3 for part in np.asarray(tuple(way)))


# ----------------------------------------------------------------------------------------------------------------------
# Shafts, planets' shafts and pins, carriers and bearings as components of REXS.
# ----------------------------------------------------------------------------------------------------------------------


def write_shafts(task: Task) -> None:
    """Write every shaft with its sections and bearings.

    Args:
        task: Whose gear unit and housing are written.
    """
    for shaft in task.sizing.shafts:
        frame = task.sizing.arrangement.frames[shaft.name]
        attributes: dict[str, Value] = {"mass_of_component": shaft.mass}
        where = placed(np.asarray(frame.origin), frame.along, frame.up, task.unit)
        number = _shaft(task, shaft.name, attributes | where)
        task.shafts[shaft.name] = number
        for start, end, diameter, bore in _sections(task, shaft):
            section(task, number, (start, end), diameter, bore)
        task.material(task.sizing.design.shaft_material.name, number)
        if not any(bearing.shaft == shaft.name for bearing in task.sizing.bearings):
            for place, load in enumerate(shaft.bearings, start=1):
                _simple_bearing(task, f"{shaft.name} bearing {place}", load.position, number)
    _bearings(task)


def _sections(task: Task, shaft: ShaftSizing) -> list[tuple[float, float, float, float]]:
    built = next((built for built in task.sizing.built_shafts if built.name == shaft.name), None)
    if built is None:
        return [(0.0, shaft.length, shaft.diameter, shaft.bore)]
    return [(step.start, step.end, step.diameter, built.bore) for step in built.steps]


def _shaft(task: Task, name: str, attributes: dict[str, Value]) -> int:
    number = task.sheet.add("shaft", name, attributes)
    task.sheet.relate("assembly", {"assembly": task.unit, "part": number})
    return number


def section(task: Task, shaft: int, ends: tuple[float, float], diameter: float, bore: float) -> None:
    """Write a cylinder of a shaft.

    Args:
        task: The file in the making.
        shaft: Number of the shaft.
        ends: From the shaft's first end [m].
        diameter: Outer diameter [m].
        bore: Inner diameter [m].
    """
    number = task.sheet.add("shaft_section", "section", {
        "u_coordinate_on_shaft": ends[0], "length": ends[1] - ends[0], "outer_diameter_begin": diameter,
        "outer_diameter_end": diameter, "inner_diameter_begin": bore, "inner_diameter_end": bore,
    })  # fmt: skip
    task.sheet.relate("assembly", {"assembly": shaft, "part": number})


def _bearings(task: Task) -> None:
    for bearing in task.sizing.bearings:
        seat = task.sizing.design.bearings[bearing.name]
        number = task.sheet.add("rolling_bearing_with_catalog_geometry", bearing.name, {
            "catalogue_designation": bearing.designation, "bearing_type": BEARING_TYPES[seat.kind],
            "axial_force_absorption": ABSORBS[seat.locates], "radial_force_absorption": seat.radial,
            "inner_diameter": bearing.inner_diameter, "outer_diameter": bearing.outer_diameter, "width": bearing.width,
            "radial_dynamic_load_rating": bearing.dynamic_rating, "radial_static_load_rating": bearing.static_rating,
            "nominal_rating_life_time_iso_281_2007": bearing.life,
            "modified_rating_life_time_iso_281_2007": bearing.modified_life,
            "u_coordinate_on_shaft_inner_side": bearing.position,
        })  # fmt: skip
        task.sheet.relate(
            "side", {"assembly": number, "inner_part": task.shafts[bearing.shaft], "outer_part": task.casing}
        )


def _simple_bearing(task: Task, name: str, position: float, inner: int, outer: int | None = None) -> None:
    number = task.sheet.add("concept_bearing", name, {
        "u_coordinate_on_shaft_inner_side": position, "axial_force_absorption": "no_direction",
        "radial_force_absorption": True,
    })  # fmt: skip
    task.sheet.relate("side", {"assembly": number, "inner_part": inner, "outer_part": outer or task.casing})


def holder(task: Task, name: str) -> int:
    """Write a shaft that the housing holds, for what stands on the ground, and return its number.

    Args:
        task: The file in the making.
        name: Of the shaft.
    """
    number = _shaft(task, name, {})
    couple(task, f"{name} in housing", number, task.casing)
    return number


def couple(task: Task, name: str, inner: int, outer: int) -> None:
    """Join two components.

    Args:
        task: The file in the making.
        name: Of what joins them.
        inner: A shaft.
        outer: A shaft, a side plate or the housing.
    """
    task.sheet.relate(
        "side", {"assembly": task.sheet.add("coupling", name, {}), "inner_part": inner, "outer_part": outer}
    )


def write_planets(task: Task, stage: str, number: int) -> None:
    """Write the carrier of a set and the shaft and pin of every planet.

    Args:
        task: Whose shafts are written.
        stage: Name of the set.
        number: Of its planetary stage.
    """
    sheet = task.sheet
    carrier = next(carrier for carrier in task.sizing.carriers if carrier.stage == stage)
    body = sheet.add("planet_carrier", str(carrier.part), {"mass_of_component": carrier.mass})
    sheet.relate("assembly", {"assembly": number, "part": body})
    held = task.shafts[carrier.shaft] if carrier.shaft != GROUND else holder(task, f"{carrier.part} shaft")
    sheet.relate("planet_carrier_shaft", {"planetary_stage": number, "shaft": held})
    sheet.relate("assembly", {"assembly": body, "part": held})
    plate = _plate(task, carrier, body, held)
    for stand in task.stands:
        key = (stand.node, stand.place)
        if stand.gear.stage == stage and stand.carrier and key not in task.planets:
            task.planets[key] = _planet(task, stand, carrier, (number, body, plate))


def _plate(task: Task, carrier: CarrierSizing, body: int, shaft: int) -> int:
    widest = max(stand.gear.pitch_diameter for stand in task.stands if stand.gear.stage == carrier.stage
                 and stand.carrier)  # fmt: skip
    plate = task.sheet.add("side_plate", f"{carrier.part} plate", {
        "length": carrier.plate_thickness, "outer_diameter": 2.0 * carrier.radius + widest,
    })  # fmt: skip
    task.sheet.relate("assembly", {"assembly": body, "part": plate})
    couple(task, f"{carrier.part} plate on shaft", shaft, plate)
    return plate


def _planet(task: Task, stand: Stand, carrier: CarrierSizing, holds: tuple[int, int, int]) -> int:
    """Write shaft and pin of a planet; return the number of the shaft."""
    stage, body, plate = holds
    width, axes = stand.gear.face_width, stand.axes
    where = placed(axes.origin - width / 2.0 * axes.along, axes.along, axes.turned[:, 1], task.unit)
    shaft, pin = _shaft(task, f"{stand.name} shaft", where), _pin(task, stand, carrier, body, where)
    task.sheet.relate("planet_shaft", {"planetary_stage": stage, "shaft": shaft})
    task.sheet.relate("planet_pin", {"planetary_stage": stage, "shaft": pin})
    couple(task, f"{stand.name} pin in plate", pin, plate)
    _simple_bearing(task, f"{stand.name} bearing", width / 2.0, pin, shaft)
    return shaft


def _pin(task: Task, stand: Stand, carrier: CarrierSizing, body: int, where: dict[str, Value]) -> int:
    pin = task.sheet.add("shaft", f"{stand.name} pin", where)
    task.sheet.relate("assembly", {"assembly": body, "part": pin})
    section(task, pin, (0.0, stand.gear.face_width), carrier.pin_diameter, carrier.pin_bore or 0.0)
    return pin


# ----------------------------------------------------------------------------------------------------------------------
# Gears with their flanks as components of REXS.
# ----------------------------------------------------------------------------------------------------------------------


def write_gears(task: Task) -> None:
    """Write every gear of a file; wheels of face gears, which REXS does not know, are left out.

    Args:
        task: Whose shafts and planets are written.
    """
    for stand in task.stands:
        kind = kind_of(task.sizing, stand.gear.stage)
        if kind == "bevel":
            task.gears[stand.name] = (_bevel(task, stand),)
        elif kind == "cylindrical" or stand.gear.role == "pinion":
            task.gears[stand.name] = _cylindrical(task, stand)


def _shaft_of(task: Task, stand: Stand) -> int:
    if stand.carrier:
        return task.planets[stand.node, stand.place]
    if stand.node == GROUND:
        key = f"{stand.name} shaft"
        if key not in task.shafts:
            task.shafts[key] = holder(task, key)
        return task.shafts[key]
    return task.shafts[stand.node]


def _on_shaft(place: float) -> float | None:
    """Return a place along a shaft; None before its first end, for which REXS has the support vector alone."""
    return place if place >= 0.0 else None


def _place(task: Task, stand: Stand) -> float:
    """Return the middle of a gear from the first end of its shaft [m]."""
    if stand.carrier:
        first = next(one for one in task.stands if (one.node, one.place) == (stand.node, stand.place))
        origin = first.axes.origin - first.gear.face_width / 2.0 * first.axes.along
    elif stand.node == GROUND:
        return 0.0
    else:
        origin = np.asarray(task.sizing.arrangement.frames[stand.node].origin)
    return float((stand.axes.origin - origin) @ stand.axes.along)


def _cylindrical(task: Task, stand: Stand) -> tuple[int, ...]:
    sizing, gear, sheet = task.sizing, stand.gear, task.sheet
    halves = halves_of(gear) if stand.gear.stage in sizing.design.pairs else 1
    teeth, hand = cylindrical_gear(sizing, gear), _hand(task, stand)
    kind, middle, shaft = (
        "ring_gear" if is_internal(sizing, gear) else "cylindrical_gear",
        _place(task, stand),
        _shaft_of(task, stand),
    )
    numbers = []
    for half in range(halves):
        beside = (half - (halves - 1) / 2.0) * gear.face_width
        where = placed(
            stand.axes.origin + beside * stand.axes.along, stand.axes.along, stand.axes.turned[:, 1], task.unit
        )
        attributes: dict[str, Value] = {
            "u_coordinate_on_shaft": _on_shaft(middle + beside), "number_of_teeth": abs(gear.teeth),
            "normal_module": gear.module, "face_width": gear.face_width,
            "helix_angle_reference_diameter": (1 - 2 * half) * hand * gear.helix_angle,
            "reference_circle_diameter": gear.pitch_diameter, "tip_diameter": 2.0 * abs(teeth.tip_radius),
            "root_diameter": 2.0 * abs(teeth.root_radius), "base_circle_diameter": 2.0 * abs(teeth.base_radius),
            "mass_of_component": gear.mass, GEAR: gear.name,
        }  # fmt: skip
        name = stand.name if halves == 1 else f"{stand.name} half {half + 1}"
        number = sheet.add(kind, name, attributes | where)
        sheet.relate("assembly", {"assembly": shaft, "part": number})
        _flanks(task, number, name, {
            "addendum_modification_coefficient": gear.profile_shift,
            "normal_pressure_angle": sizing.design.rules(gear.stage).pressure_angle,
        })  # fmt: skip
        task.material(sizing.design.rules(gear.stage).material, number)
        numbers.append(number)
    return tuple(numbers)


def _flanks(task: Task, gear: int, name: str, attributes: dict[str, Value]) -> None:
    left, right = (
        task.sheet.add("cylindrical_gear_flank", f"{name} {side} flank", attributes) for side in ("left", "right")
    )
    task.sheet.relate("flank", {"gear": gear, "left": left, "right": right})


def _hand(task: Task, stand: Stand) -> int:
    """Return +1 for teeth of a right-hand helix and straight ones, −1 for left-hand ones."""
    if stand.gear.helix_angle == 0.0:
        return 1
    if stand.gear.stage in task.sizing.design.pairs:
        return -1 if hand_of(task.sizing, stand.gear, stand.node) is Hand.LEFT else 1
    return 1 if stand.gear.role == "sun" else -1


def _bevel(task: Task, stand: Stand) -> int:
    sizing, gear = task.sizing, stand.gear
    pair, side = bevel_pair(sizing, gear.stage), 0 if gear.role == "pinion" else 1
    hand = -1.0 if hand_of(sizing, gear, stand.node) is Hand.LEFT else 1.0
    number = task.sheet.add("bevel_gear", stand.name, {
        "u_coordinate_on_shaft": _on_shaft(_place(task, stand)), "number_of_teeth": gear.teeth,
        "face_width": gear.face_width,
        "mean_normal_module": gear.module, "mean_spiral_angle": hand * pair.spiral_angle,
        "outer_pitch_diameter": pair.outer_diameters[side], "pitch_angle": pair.pitch_angles[side],
        "mean_cone_distance": pair.mean_cone_distance,
        "mean_pitch_diameter": 2.0 * pair.mean_cone_distance * math.sin(pair.pitch_angles[side]),
        "profile_shift_coefficient": gear.profile_shift, "mass_of_component": gear.mass, GEAR: gear.name,
    })  # fmt: skip
    task.sheet.relate("assembly", {"assembly": _shaft_of(task, stand), "part": number})
    task.material(sizing.design.rules(gear.stage).material, number)
    return number


# ----------------------------------------------------------------------------------------------------------------------
# Meshes as stages of REXS, with what standards make of them.
# ----------------------------------------------------------------------------------------------------------------------


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
        (_bevel_stage if is_bevel else _cylindrical_stage)(task, mesh) | {MESH: mesh.name},
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


def _cylindrical_stage(task: Task, mesh: MeshSizing) -> dict[str, Value]:
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


def _bevel_stage(task: Task, mesh: MeshSizing) -> dict[str, Value]:
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


# ----------------------------------------------------------------------------------------------------------------------
# Machines, clutches and load cases as components and spectra of REXS.
# ----------------------------------------------------------------------------------------------------------------------


def write_machines(task: Task) -> None:
    """Write every machine as a load on its shaft.

    Args:
        task: Whose shafts are written.
    """
    sizing = task.sizing
    powers = sizing.reference.machine_powers
    follows = smallest(powers, powers.__getitem__)  # what takes most follows from all others
    for machine in sizing.machines:
        number = task.sheet.add("external_load", machine.name, {
            "u_coordinate_on_shaft": sizing.arrangement.plans[machine.shaft].places[machine.name],
            "transmits_torque": True, "defines_torque": machine.name != follows,
        })  # fmt: skip
        task.sheet.relate("assembly", {"assembly": task.shafts[machine.shaft], "part": number})
        task.loads[machine.name] = number


def write_clutches(task: Task) -> None:
    """Write every clutch and brake, engaged as it is in the case that speaks for the design.

    Args:
        task: Whose shafts are written.
    """
    for name, clutch in task.sizing.design.clutches.items():
        ends = [end for end in (clutch.driving, clutch.driven) if end != GROUND]
        outer = task.casing if len(ends) == 1 else task.shafts[ends[1]]
        number = task.sheet.add("switchable_coupling", name, {})
        task.sheet.relate("side", {"assembly": number, "inner_part": task.shafts[ends[0]], "outer_part": outer})
        task.loads[name] = number


def write_cases(task: Task) -> None:
    """Write every level of every load case: torques of machines, speeds of shafts, clutches that hold.

    Args:
        task: Whose machines and clutches are written.
    """
    sizing = task.sizing
    shares = shares_of(sizing.design) or {governing_case(sizing): 1.0}
    for name in sizing.flows:
        for load, share in levels_of(sizing.design, name):
            if share > 0.0:  # a case without a share of the life is a static one
                task.sheet.cases.append(_case(task, name, load, float(shares.get(name, 0.0) * share)))


def _case(task: Task, name: str, load: float, share: float) -> dict[int, dict[str, Value]]:
    """Return what the components say in a part of the loads of a case, which lasts a share of the life."""
    sizing, flow = task.sizing, task.sizing.flows[name]
    said: dict[int, dict[str, Value]] = {
        task.unit: {"operating_time_fraction": share},
        task.casing: {"temperature_lubricant": sizing.design.oil.temperature},
    }
    for machine in sizing.machines:
        torque, power = load * flow.machine_torques[machine.name], load * flow.machine_powers[machine.name]
        said[task.loads[machine.name]] = {"torque_around_u_axis": torque, "power": power}
    for shaft in sizing.shafts:
        said[task.shafts[shaft.name]] = {"rotational_speed": flow.speeds[shaft.name]}
    for clutch in sizing.design.clutches:
        said[task.loads[clutch]] = {"is_engaged": (clutch in flow.joints,)}
    return said


# ----------------------------------------------------------------------------------------------------------------------
# The forms of a REXS file beside XML: the same in JSON, and either in an archive.
# ----------------------------------------------------------------------------------------------------------------------


Form = Literal["rexs", "rexsj", "rexsz"]
FORMS: tuple[Form, ...] = ("rexs", "rexsj", "rexsz")
"""Ends of the names of REXS files: XML, JSON, and XML in an archive."""
_MOMENT = (1980, 1, 1, 0, 0, 0)
"""What an archive says of when its file was changed: nothing, so that equal files make equal archives."""
_PLAIN: Mapping[str, Callable[[str], object]] = {
    "floating_point": float, "floating_point_array": float, "integer": int, "reference_component": int,
    "boolean": "true".__eq__, "boolean_array": "true".__eq__,
}  # fmt: skip
"""Type of an attribute -> its value of a text, or those of its cells; of all others the text itself."""


def formed(content: bytes, form: Form) -> bytes:
    """Return a REXS file in another form.

    Args:
        content: As XML.
        form: That is wanted.
    """
    if form == "rexsj":
        model = _model(ElementTree.fromstring(content))
        return json.dumps({"model": model}, ensure_ascii=False, indent=1).encode()
    if form == "rexsz":
        packed = io.BytesIO()
        with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
            entry = zipfile.ZipInfo("model.rexs", _MOMENT)
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, content)
        return packed.getvalue()
    return content


def _model(root: ElementTree.Element) -> dict[str, Any]:
    spectrum = root.find("load_spectrum")
    cases = [] if spectrum is None else spectrum.findall("load_case")
    return {
        **root.attrib,
        "relations": [
            {"id": int(relation.attrib["id"]), "type": relation.attrib["type"],
             "refs": [{**ref.attrib, "id": int(ref.attrib["id"])} for ref in relation]}
            for relation in root.iterfind("relations/relation")
        ],
        "components": [_component(part) for part in root.iterfind("components/component")],
        "load_spectrum": {
            "id": 1,
            "load_cases": [{"id": int(case.attrib["id"]), "components": [_component(part) for part in case]}
                           for case in cases],
        },
    }  # fmt: skip


def _component(part: ElementTree.Element) -> dict[str, Any]:
    return {**part.attrib, "id": int(part.attrib["id"]), "attributes": [_attribute(said) for said in part]}


def _attribute(said: ElementTree.Element) -> dict[str, Any]:
    name = said.attrib["id"]
    kind = "string" if name in OWN else words()[name].kind
    read, array = _PLAIN.get(kind, str), said.find("array")
    value = read(said.text or "") if array is None else [read(cell.text or "") for cell in array]
    return {"id": name, "unit": said.attrib["unit"], kind: value}


# ----------------------------------------------------------------------------------------------------------------------
# The verb: a sizing as a REXS file.
# ----------------------------------------------------------------------------------------------------------------------


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
