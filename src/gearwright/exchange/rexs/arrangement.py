"""Which components turn as one, their gears, where they stand and what sits on them, as tables of a design."""

import math
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from gearwright.base import Floats, Problem
from gearwright.catalogue import bearings, materials
from gearwright.exchange.rexs.files import ABSORBS, BEARING_TYPES, Asking, Attribute, Component, Document
from gearwright.spec import GROUND, LONGEST_NAME
from gearwright.spec.design import FATIGUE, STATIC

# ----------------------------------------------------------------------------------------------------------------------
# Which components of a document turn as one: shafts, carriers and plates that couplings join, and the housing.
# ----------------------------------------------------------------------------------------------------------------------


RIGID = (
    "coupling", "feather_key_connection", "cylindrical_interference_fit", "tapered_interference_fit",
    "involute_spline_connection",
)  # fmt: skip
"""Components that let their sides turn as one."""
MOST_GEARS = 24
"""Most gears of a transmission that become load cases [-]."""
LONGEST = 40
"""Longest name of a component that a design takes up; a longer one is a sentence [-]."""


@dataclass
class Bodies:
    """Components that turn as one, and what bodies are called."""

    asking: Asking
    joined: dict[int, int] = field(default_factory=dict)
    """Component -> another of its body, or itself."""
    names: dict[int, str] = field(default_factory=dict)
    """First component of a body -> its name in the design."""
    taken: set[str] = field(default_factory=lambda: {GROUND})
    """Names of the design so far."""

    def of(self, number: int) -> int:
        """Return the component that speaks for a body.

        Args:
            number: One of its components.
        """
        while (following := self.joined.get(number, number)) != number:
            number = following
        return number

    def join(self, first: int, second: int) -> None:
        """Make one body of two; the first speaks for it.

        Args:
            first: A component.
            second: Another one.
        """
        if self.of(first) != self.of(second):
            self.joined[self.of(second)] = self.of(first)

    def name(self, number: int) -> str:
        """Return what the design calls the body of a component.

        Args:
            number: Of the component.
        """
        body = self.of(number)
        if body not in self.asking.document.components:
            return GROUND  # of a gear without a shaft, which is refused
        if body not in self.names:
            self.names[body] = self.new_name(self.asking.document.components[number])
        return self.names[body]

    def name_of(self, number: int) -> str | None:
        """Return what the design calls the body of a component; None of one that nothing asked the name of.

        Args:
            number: Of the component.
        """
        return self.names.get(self.of(number))

    def new_name(self, component: Component) -> str:
        """Return a name for a component that nothing else has.

        Args:
            component: To be called so.
        """
        told = component.name if len(component.name) <= LONGEST else ""
        plain = "".join(mark if mark.isalnum() else " " for mark in told or component.kind)
        stem = "-".join(plain.split())[: LONGEST_NAME - 4].strip("-") or component.kind
        name = next(name for name in _numbered(stem) if name not in self.taken)
        self.taken.add(name)
        return name


def _numbered(stem: str) -> Iterator[str]:
    yield stem
    yield from (f"{stem}-{k}" for k in range(2, 10_000))


def bodies_of(asking: Asking) -> Bodies:
    """Return what of a document turns as one.

    Args:
        asking: The document.
    """
    document = asking.document
    bodies = Bodies(asking)
    for casing in document.of_kind("gear_casing"):
        bodies.join(document.of_kind("gear_casing")[0].number, casing.number)
    for carrier in document.of_kind("planet_carrier"):
        for part in document.related("assembly", "assembly", carrier.number, "part"):
            bodies.join(carrier.number, part)
    for coupling in document.of_kind(*RIGID, "switchable_coupling"):
        if coupling.kind in RIGID or all(holds(asking, coupling)):
            _couple(bodies, coupling)
    for casing in document.of_kind("gear_casing"):
        bodies.names[bodies.of(casing.number)] = GROUND
    return bodies


def holds(asking: Asking, coupling: Component) -> tuple[bool, ...]:
    """Return whether a switchable coupling is engaged, load case by load case.

    Args:
        asking: The document.
        coupling: Of it.
    """
    cases = asking.document.cases or ({},)
    return tuple(_held(asking, coupling, case) for case in cases)


def _held(asking: Asking, coupling: Component, case: Mapping[int, Component]) -> bool:
    """Tell whether a coupling is engaged in a case; of one that says so gear by gear, in the gear of the case."""
    spoken = [said for said in (case.get(coupling.number), coupling) if said is not None]
    for said in spoken:
        found = asking.attribute(said, "is_engaged")
        if found is not None and (found.text or found.cells):
            place = _gear_of(asking, case) - 1
            return (found.text or found.cells[place if place < len(found.cells) else 0]) == "true"
    return False


def _gear_of(asking: Asking, case: Mapping[int, Component]) -> int:
    """Return which of its gears a transmission is in, counted from 1 [-]."""
    units = asking.document.of_kind("gear_unit")
    for said in (*(case[unit.number] for unit in units if unit.number in case), *units):
        text = asking.text(said, "gear_shift_index")
        if text.isascii() and text.isdigit() and int(text) > 0:
            return int(text)
    return 1


def with_gears(document: Document) -> Document:
    """Return a document in which each gear of a transmission is a load case, where it has no load cases.

    Args:
        document: As read.
    """
    units = [unit for unit in document.of_kind("gear_unit") if "number_of_gears" in unit.attributes]
    couplings = document.of_kind("switchable_coupling")
    shifts = any("is_engaged" in one.attributes and len(one.attributes["is_engaged"].cells) > 1 for one in couplings)
    if document.cases or not units or not shifts:
        return document
    unit, count = units[0], units[0].attributes["number_of_gears"].text
    if not (count.isascii() and count.isdigit() and 1 < int(count) <= MOST_GEARS):
        return document
    said = [{"gear_shift_index": Attribute(str(gear), (), "none", unit.line)} for gear in range(1, int(count) + 1)]
    cases = tuple({unit.number: Component(unit.number, unit.kind, "", unit.line, index)} for index in said)
    return replace(document, cases=cases)


def _couple(bodies: Bodies, coupling: Component) -> None:
    """Join both sides of a coupling."""
    relations = [relation for relation in bodies.asking.document.relations
                 if relation.kind == "side" and relation.roles.get("assembly") == coupling.number]  # fmt: skip
    bodies.asking.used.add(coupling.number)
    for relation in relations:
        ends = [relation.roles.get(role) for role in ("inner_part", "outer_part")]
        if None in ends:
            said = f"joins {len(relation.roles) - 1} part; give an inner_part and an outer_part"
            bodies.asking.problems.append(Problem("relations.side", said, relation.line))
            continue
        inner, outer = (end for end in ends if end is not None)
        kind = bodies.asking.document.components[outer].kind
        bodies.join(*((outer, inner) if kind == "gear_casing" else (inner, outer)))


# ----------------------------------------------------------------------------------------------------------------------
# Gears and stages of a document as tables of a design: pairs, bevel pairs, planetary sets.
# ----------------------------------------------------------------------------------------------------------------------


GearTable = dict[str, Any]
GEARS = ("cylindrical_gear", "ring_gear", "bevel_gear")
_SQUARE = math.radians(20.0)
SAME = 1e-6
"""Relative difference below which numbers of gears in mesh are the same [-]."""
NEAR = 5e-4
"""Profile shifts that differ by no more are the same, as printed in files [-]."""


@dataclass(frozen=True)
class Gear:
    """A gear of a document."""

    component: Component
    shaft: int
    teeth: int
    """[-]"""
    module: float
    """Normal module; of a bevel gear the outer transverse one [m]."""
    width: float
    """[m]"""
    helix: float
    """Positive for right-hand teeth [rad]."""
    shift: float | None
    """[-]"""
    pressure_angle: float
    """[rad]"""

    @property
    def number(self) -> int:
        """Id of its component."""
        return self.component.number


@dataclass
class Gearing:
    """What was read of gears and stages."""

    pairs: dict[str, GearTable] = field(default_factory=dict)
    planetaries: dict[str, GearTable] = field(default_factory=dict)
    compounds: dict[str, GearTable] = field(default_factory=dict)
    shafts: list[str] = field(default_factory=list)
    """Shafts of the design, in order."""
    labels: dict[int, str] = field(default_factory=dict)
    """Gear -> what the design calls it."""
    owners: dict[int, str] = field(default_factory=dict)
    """Gear -> the pair that has it, and what it is there: ``first.wheel``."""
    wheels: set[int] = field(default_factory=set)
    """Gears that are wheels of pairs."""
    stages: dict[str, tuple[int, ...]] = field(default_factory=dict)
    """Stage of the design -> ids of its stages in the document."""
    clutches: dict[str, GearTable] = field(default_factory=dict)
    machines: dict[int, str] = field(default_factory=dict)
    """Load -> the machine of the design that it is."""
    engaged: dict[str, tuple[bool, ...]] = field(default_factory=dict)
    """Clutch -> whether it holds, load case by load case."""

    def add_shaft(self, name: str) -> str:
        """Note a shaft of the design, and return its name.

        Args:
            name: Of the shaft, or ground.
        """
        if name != GROUND and name not in self.shafts:
            self.shafts.append(name)
        return name

    def hold(self, shaft: str) -> None:
        """Put a shaft of sets on the ground.

        Args:
            shaft: That never turns.
        """
        if shaft in self.shafts and len(self.shafts) > 1:
            self.shafts.remove(shaft)
        for table in self.planetaries.values():
            table |= {role: GROUND for role in ("sun", "ring", "carrier") if table[role] == shaft}
        for table in self.compounds.values():
            members = [*table.get("suns", {}).values(), *table.get("rings", {}).values()]
            for holder, key in [(table, "carrier"), *((member, "shaft") for member in members)]:
                holder[key] = GROUND if holder[key] == shaft else holder[key]

    def shaft(self, named: str) -> str:
        """Return the shaft that a side of a pair names, directly or by a gear of another pair.

        Args:
            named: As in the design, such as ``fast`` or ``first.wheel``.
        """
        for name, pair in self.pairs.items():
            for role in ("pinion", "wheel"):
                if f"{name}.{role}" == named:
                    return self.shaft(pair[role])
        return named


def gears_of(asking: Asking) -> dict[int, Gear]:
    """Return every gear of a document by its id.

    Args:
        asking: The document.
    """
    return {component.number: _gear(asking, component) for component in asking.document.of_kind(*GEARS)}


def _gear(asking: Asking, component: Component) -> Gear:
    document, number = asking.document, component.number
    asking.used.add(number)
    shaft = _shaft_of(document, number)
    if shaft is None:
        asking.refuse(component, "stands on no shaft; give it an assembly relation with one, or one of its sides a fit")
    teeth = round(abs(asking.needed(component, "number_of_teeth")))
    flanks = [document.components[flank] for role in ("left", "right")
              for flank in document.related("flank", "gear", number, role)]  # fmt: skip
    asking.used.update(flank.number for flank in flanks)
    if component.kind == "bevel_gear":
        helix, shift = (
            asking.number(component, "mean_spiral_angle"),
            _of_any(asking, [component], "profile_shift_coefficient"),
        )
        module = _bevel_module(asking, component, max(teeth, 1), helix or 0.0)
    else:
        module, helix = (
            asking.needed(component, "normal_module"),
            asking.number(component, "helix_angle_reference_diameter"),
        )
        shift = _of_any(asking, [*flanks, component], "addendum_modification_coefficient")
    angle = _of_any(asking, flanks, "normal_pressure_angle")
    width = asking.needed(component, "face_width")
    asking.number(component, "mass_of_component")
    return Gear(component, -1 if shaft is None else shaft, teeth, module, width, helix or 0.0, shift, angle or _SQUARE)


def _shaft_of(document: Document, number: int) -> int | None:
    """Return the shaft of a gear: of which it is a part, or to which a fit, a key or a spline joins it."""
    for shaft in document.related("assembly", "part", number, "assembly"):
        if document.components[shaft].kind == "shaft":
            return shaft
    for role, other in (("outer_part", "inner_part"), ("inner_part", "outer_part")):
        for shaft in document.related("side", role, number, other):
            if document.components[shaft].kind in ("shaft", "gear_casing"):
                return shaft
    return None


def _bevel_module(asking: Asking, component: Component, teeth: int, spiral: float) -> float:
    """Return the transverse module at the outer end, or at the middle of the face where a file has only that [m]."""
    if asking.number(component, "outer_pitch_diameter") is None:
        mean = asking.number(component, "mean_normal_module")
        if mean is not None:
            return mean / math.cos(spiral)
    return asking.needed(component, "outer_pitch_diameter") / teeth


def _of_any(asking: Asking, components: Iterable[Component], name: str) -> float | None:
    """Return the first number of a name that some components have, and read all of them."""
    values = [value for component in components if (value := asking.number(component, name)) is not None]
    return values[0] if values else None


def _alike(asking: Asking, one: Gear, other: Gear) -> tuple[tuple[str, float, float], ...]:
    """Return what gears in mesh must have in common, of both."""
    ours, theirs = (asking.number(gear.component, "mean_normal_module") for gear in (one, other))
    modules = (ours, theirs) if ours is not None and theirs is not None else (one.module, other.module)
    return (
        ("module", *modules),
        ("helix angle", abs(one.helix), abs(other.helix)),
        ("pressure angle", one.pressure_angle, other.pressure_angle),
    )


def stage_table(asking: Asking, stage: Component, gears: Sequence[Gear]) -> GearTable:
    """Return what all gears of a stage share: module, width, centre distance, angles.

    Args:
        asking: The document.
        stage: One stage of them.
        gears: All of them.
    """
    first = gears[0]
    for gear in gears[1:]:
        for said, one, other in _alike(asking, first, gear):
            if not math.isclose(one, other, rel_tol=SAME, abs_tol=1e-9):
                message = f"meshes with {first.component.path}, which has another {said}; they must be equal"
                asking.refuse(gear.component, message)
    widths = {gear.width for gear in gears}
    if len(widths) > 1:
        listed = ", ".join(f"{1e3 * width:g}" for width in sorted(widths, reverse=True))
        asking.notes.append(f"line {stage.line}: {stage.path}: of face widths {listed} mm the smallest stands for all")
    table: GearTable = {"face_width_m": min(widths)}
    rules: GearTable = {}
    if not math.isclose(first.pressure_angle, _SQUARE, rel_tol=1e-9):
        rules["pressure_angle_rad"] = first.pressure_angle
    if first.component.kind == "bevel_gear":
        table |= {"outer_module_m": _outer(asking, stage, gears, min(widths)), "spiral_angle_rad": abs(first.helix)}
    else:
        table["module_m"] = first.module
        distance = asking.number(stage, "center_distance")
        if distance is not None:
            table["centre_distance_m"] = distance
        shared = asking.number(stage, "mesh_load_factor_iso_6336_2019")
        if shared is not None and shared > 1.0:
            rules["mesh_load_factor"] = shared
        if first.helix:
            rules["helix_angle_rad"] = abs(first.helix)
    asking.number(stage, "common_face_width")
    return table | ({"gears": rules} if rules else {})


def _outer(asking: Asking, stage: Component, gears: Sequence[Gear], width: float) -> float:
    """Return the outer transverse module of bevel gears of which the mean one may be known [m].

    Source: ISO 23509:2016, 6.4: tan δ_1 = sin Σ / (u + cos Σ), R_m = d_m1 / (2 sin δ_1), R_e = R_m + b/2.
    """
    first, second = gears[0], gears[-1]
    outer = next((gear for gear in gears if "outer_pitch_diameter" in gear.component.attributes), None)
    if outer is not None:
        return outer.module
    axes = asking.number(stage, "shaft_angle") or math.pi / 2.0
    cone = math.atan2(math.sin(axes), second.teeth / max(first.teeth, 1) + math.cos(axes))
    mean = first.teeth * first.module / (2.0 * math.sin(cone))
    said = "of bevel gears without outer_pitch_diameter the middle of the smaller face has the mean_normal_module"
    asking.notes.append(f"line {stage.line}: {stage.path}: {said}")
    return first.module * (mean + width / 2.0) / mean if mean else first.module


# ----------------------------------------------------------------------------------------------------------------------
# Where shafts of a document stand and what sits where on them, and of what gears are made, as tables of a design.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Where gears, machines and rolling bearings of a document sit on its shafts, as tables of a design.
# ----------------------------------------------------------------------------------------------------------------------


SeatTable = dict[str, Any]
_SIDES = ("u_coordinate_on_shaft_inner_side", "u_coordinate_on_shaft_outer_side")
CATALOGUED = "rolling_bearing_with_catalog_geometry"
RADIAL = 2
"""Bearings that carry a shaft across its axis [-]."""


@dataclass
class Mounting:
    """What sits where on the shafts that are known by one component along +u."""

    places: dict[str, dict[str, float]] = field(default_factory=dict)
    """Shaft -> what sits on it -> middle of its width from the shaft's first end [m]."""
    shafts: list[tuple[str, dict[str, SeatTable], frozenset[int]]] = field(default_factory=list)
    """Shafts that the housing alone carries, the seats of their bearings by name, and the ids of these."""


def read_mounting(asking: Asking, bodies: Bodies, gearing: Gearing, shafts: Mapping[str, Component]) -> Mounting:
    """Return places and bearings of shafts.

    Args:
        asking: The document.
        bodies: What of it turns as one.
        gearing: Its gears, stages and machines.
        shafts: Shaft of the design -> the component that it is, which stands along +u.
    """
    mounting = Mounting()
    named = {**gearing.labels, **gearing.machines}
    for name, shaft in shafts.items():
        found: dict[str, list[float]] = defaultdict(list)
        for number in asking.document.related("assembly", "assembly", shaft.number, "part"):
            place = _place(asking, shaft, asking.document.components[number])
            if number in named and place is not None:
                found[named[number]].append(place)
        mounting.places[name] = {label: sum(places) / len(places) for label, places in found.items()}
        seats = dict(_seats(asking, bodies, shaft, name))
        radial = sum(seat.get("radial", True) for seat in seats.values())
        if radial > RADIAL:
            asking.notes.append(f"the {radial} radial bearings of {name} are not read: statics knows two")
        if radial == RADIAL:
            called = {bodies.new_name(asking.document.components[number]): seat for number, seat in seats.items()}
            mounting.shafts.append((name, called, frozenset(seats)))
    return mounting


def with_places(table: Mapping[str, Any], mounting: Mounting) -> SeatTable:
    """Return the tables of a design with the places of what sits on its shafts, where all are between the ends.

    Args:
        table: Of the design, with its layout.
        mounting: As read.
    """
    layout = {name: dict(entry) for name, entry in table.get("layout", {}).items()}
    for name, places in mounting.places.items():
        if places and all(0.0 <= place <= layout[name]["length_m"] for place in places.values()):
            layout[name]["places"] = {label: {"position_m": place} for label, place in places.items()}
    return {**table, "layout": layout} if layout else dict(table)


def _place(asking: Asking, shaft: Component, part: Component) -> float | None:
    """Return where the middle of a part is on its shaft: by where both stand, else by what the part says [m]."""
    own, its = asking.vector(part, "support_vector"), asking.vector(shaft, "support_vector")
    asking.vector(part, "u_axis_vector")
    said = asking.number(part, "u_coordinate_on_shaft")
    return own[0] - its[0] if own and its and part.kind != "external_load" else said


def _seats(asking: Asking, bodies: Bodies, shaft: Component, name: str) -> Iterator[tuple[int, SeatTable]]:
    """Yield every bearing of a shaft; none where another shaft carries it."""
    document, seats = asking.document, dict[int, SeatTable]()
    for component in document.of_kind(CATALOGUED, "concept_bearing"):
        ends = {
            role: document.related("side", "assembly", component.number, role) for role in ("inner_part", "outer_part")
        }
        parts = [part for both in ends.values() for part in both]
        if shaft.number not in parts:
            continue
        others = [part for part in parts if part != shaft.number]
        if len(parts) != len(ends) or bodies.name_of(others[0]) != GROUND:
            return
        side = "inner_side" if shaft.number in ends["inner_part"] else "outer_side"
        position = asking.number(component, f"u_coordinate_on_shaft_{side}")
        if position is None:
            return
        seats[component.number] = {"shaft": name, "position_m": position} | _kind(asking, component)
    yield from seats.items()


def _kind(asking: Asking, component: Component) -> SeatTable:
    """Return kind, direction and size of a bearing, as far as a design has words for them."""
    kinds = {said: kind for kind, said in BEARING_TYPES.items()}
    locates = {said: kind for kind, said in ABSORBS.items()}.get(
        asking.text(component, "axial_force_absorption"), "none"
    )
    stated = asking.text(component, "bearing_type")
    kind = kinds.get(stated, "cylindrical" if locates == "none" else "deep-groove")
    if stated not in kinds:
        words = "a bearing of another kind" if stated else "a bearing of no kind"
        asking.notes.append(f"line {component.line}: {component.path} is {words}; {kind} stands for it")
    table: SeatTable = {"kind": kind, "locates": locates}
    if asking.text(component, "radial_force_absorption") == "false":
        table["radial"] = False
    designation = catalogued(asking.text(component, "catalogue_designation"))
    bore = asking.number(component, "inner_diameter")
    for name in ("outer_diameter", "width", "fatigue_limit_load"):
        asking.attribute(component, name)  # which follow from the bearing
    for name in ("support_vector", "u_axis_vector", "manufacturer", *_SIDES):
        asking.attribute(component, name)  # said by the shaft and the coordinate on it
    if designation:
        table["designation"] = designation
    elif bore:
        table["bore_m"] = bore
    for name, key in (
        ("radial_dynamic_load_rating", "dynamic_rating_n"),
        ("radial_static_load_rating", "static_rating_n"),
    ):
        value = asking.number(component, name)
        if value and designation:
            table[key] = value
    return table


def catalogued(designation: str) -> str:
    """Return the name of the catalogue for what a maker calls a bearing; empty where the catalogue has none.

    Args:
        designation: With seals, cages and the like behind it.

    >>> catalogued("6210-2Z"), catalogued("NU 2212 E"), catalogued("K 50x58x25")
    ('6210', 'NU 2212', '')
    """
    plain = designation.replace(" ", "").upper()
    names = {name.replace(" ", ""): name for name in bearings()}
    starts = (plain[:length] for length in range(len(plain), 2, -1) if not plain[length : length + 1].isdigit())
    return next((names[start] for start in starts if start in names), "")
