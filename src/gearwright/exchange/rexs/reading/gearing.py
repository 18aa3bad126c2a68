"""Gears and stages of a document as tables of a design: pairs, bevel pairs, planetary sets."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any

from gearwright.exchange.rexs.files import Component, Document
from gearwright.exchange.rexs.reading.asking import Asking
from gearwright.spec import GROUND

Table = dict[str, Any]
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

    pairs: dict[str, Table] = field(default_factory=dict)
    planetaries: dict[str, Table] = field(default_factory=dict)
    compounds: dict[str, Table] = field(default_factory=dict)
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
    clutches: dict[str, Table] = field(default_factory=dict)
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


def stage_table(asking: Asking, stage: Component, gears: Sequence[Gear]) -> Table:
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
    table: Table = {"face_width_m": min(widths)}
    rules: Table = {}
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
