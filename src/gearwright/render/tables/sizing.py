"""What a reader wants to see of a Sizing, as tables: load cases, margins worst first, gears, shafts, masses."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

from gearwright.render.tables.given import given_by_user, overrides_table
from gearwright.render.tables.mounted import mounted_tables
from gearwright.render.tables.tables import Mark, Table, table, written
from gearwright.sizing import CarrierSizing, Check, MeshSizing, ShaftSizing, Sizing
from gearwright.sizing.arrangement import envelope
from gearwright.train import Branch, branches
from gearwright.units import Length, Mass, Origin, Quantity, Ratio, Speed, shown, unit

NOT_IN_THE_MASS = "Not in the mass: housing, bearings, oil system, accessories, motors."
_BEARINGS = "Positions from the shaft's first end; shafts that only torque acts on need none for it."
_THICKEST = "d of a shaft with steps is its thickest; the stress is of a section, listed with its own d under strength."
_ENVELOPE = "Box around tip circles and shafts, without housing."
_JUST_ENOUGH = (
    "Margin: limit over value, or value over limit where more is better; 1 is just enough. Limits of stresses include"
    " the asked factor. Bending (Lewis), contact (Hertz), Tresca's stress: equations of Pulvirenti 2023."
)
KEPT = 1e-9
"""Deviation of a speed below which it counts as kept [-]; rounding is far below."""
ROUNDING = 1e-9
"""What counts as rounding, of a margin or beside the largest force [-]."""


@dataclass(frozen=True)
class Margin:
    """One check of one part."""

    part: str
    check: str
    """What is checked."""
    case: str
    """Load case that governs; empty where no single one does."""
    value: float
    """As computed, in the unit."""
    limit: float
    """With the asked factor in it, in the unit."""
    unit: str
    """Empty for a ratio."""
    margin: Ratio
    """1 is just enough [-]."""
    source: str
    """Equation or clause."""
    group: str
    """gears, shafts, bearings, joints or carriers."""

    @property
    def holds(self) -> bool:
        """True if the value is allowed."""
        return self.margin >= 1.0 - ROUNDING

    @property
    def sentence(self) -> str:
        """Part, check, value, limit, source, case and margin."""
        value, limit = (f"{written(each)} {self.unit}".rstrip() for each in (self.value, self.limit))
        case = f", case {self.case}" if self.case else ""
        return (
            f"{self.part}: {self.check} {value}, limit {limit} ({self.source}){case}: margin {written(self.margin, 3)}"
        )


@dataclass(frozen=True)
class MassPart:
    """One line of the mass breakdown."""

    part: str
    group: str
    """gears, shafts or carriers."""
    count: int
    each: Mass
    """Of one [kg]."""
    total: Mass
    """Of all [kg]."""
    share: Annotated[float, Quantity("percent")]
    """Of the mass of gears, shafts and carriers [-]."""


@dataclass(frozen=True)
class AskedSpeed:
    """A speed that the teeth give only nearly."""

    case: str
    machine: str
    asked: Speed
    """[rad/s]"""
    actual: Speed
    """[rad/s]"""
    deviation: Annotated[float, Quantity("percent"), Origin("actual / asked − 1", "kinematics of the teeth")]
    """[-]"""


@dataclass(frozen=True)
class Bearing:
    """What one bearing carries in the case that governs its shaft."""

    shaft: str
    case: str
    position: Length
    """From the shaft's first end [m]."""
    radial_force: Annotated[float, Quantity("force"), Origin("√(F_y² + F_z²)", "equilibrium in both planes")]
    """[N]"""


def margins(sizing: Sizing) -> tuple[Margin, ...]:
    """Return every check of a sizing, worst first.

    Args:
        sizing: As sized.
    """
    found = [each for mesh in sizing.meshes if mesh.rating is None for each in _mesh_margins(mesh)]
    found += [_shaft_margin(shaft) for shaft in sizing.shafts]
    found += [each for carrier in sizing.carriers for each in _carrier_margins(carrier)]
    found += [_checked(check, _group(sizing, check)) for check in sizing.checks]
    return tuple(sorted(found, key=lambda each: (round(each.margin, 9), each.part)))


def _checked(check: Check, group: str) -> Margin:
    value, limit = (shown(each, check.dimension) for each in (check.value, check.limit))
    return Margin(
        check.part, check.check, check.case, value, limit, unit(check.dimension), check.margin, check.clause, group
    )


def _group(sizing: Sizing, check: Check) -> str:
    """Return the kind of part that a check is about."""
    first = check.part.partition(" ")[0]
    if check.part in {shaft.name for shaft in sizing.built_shafts}:
        return "shafts"
    if first in sizing.design.bearings:
        return "bearings"
    return "joints" if " on " in check.part else "gears"


def _mesh_margins(mesh: MeshSizing) -> list[Margin]:
    return [
        _stressed(mesh.name, "bending", mesh.case, mesh.bending_stress, mesh.bending_margin, "eq. 2.1", "gears"),
        _stressed(mesh.name, "contact", mesh.case, mesh.contact_stress, mesh.contact_margin, "eq. 2.2", "gears"),
    ]  # fmt: skip


def _shaft_margin(shaft: ShaftSizing) -> Margin:
    return _stressed(shaft.name, "Tresca", shaft.case, shaft.stress, shaft.margin, "eq. 2.47", "shafts")


def _carrier_margins(carrier: CarrierSizing) -> list[Margin]:
    part, case = f"{carrier.stage}.carrier", carrier.case
    pins = _stressed(part, "pin bending", case, carrier.pin_stress, carrier.pin_margin, "cantilever", "carriers")
    if carrier.plate_margin is None:
        return [pins]
    plate = _stressed(part, "plate shear", case, carrier.plate_stress, carrier.plate_margin, "Tresca", "carriers")
    return [pins, plate]


def _stressed(part: str, check: str, case: str, stress: float, margin: float, source: str, group: str) -> Margin:
    value = shown(stress, "stress")
    limit = value * margin if math.isfinite(margin) else math.inf
    return Margin(part, check, case, value, limit, unit("stress"), margin, source, group)


def mass_parts(sizing: Sizing) -> tuple[MassPart, ...]:
    """Return the mass breakdown of gears, shafts and carriers, heaviest first.

    Args:
        sizing: As sized.
    """
    parts = [(gear.name, "gears", gear.bodies, gear.mass) for gear in sizing.gears]
    parts += [(shaft.name, "shafts", 1, shaft.mass) for shaft in sizing.shafts]
    parts += [(f"{carrier.stage}.carrier", "carriers", 1, carrier.mass) for carrier in sizing.carriers]
    rows = [
        MassPart(part, group, count, each, count * each, count * each / sizing.parts_mass)
        for part, group, count, each in parts
    ]
    return tuple(sorted(rows, key=lambda row: -row.total))


def asked_speeds(sizing: Sizing) -> tuple[AskedSpeed, ...]:
    """Return every asked speed that the teeth do not give exactly.

    Args:
        sizing: As sized.
    """
    return tuple(
        AskedSpeed(case, each.machine, each.asked, each.actual, each.deviation)
        for case, flow in sizing.flows.items()
        for each in flow.yielded
        if abs(each.deviation) > KEPT
    )


def flow_tables(sizing: Sizing) -> tuple[Table, ...]:
    """Return one table per load case: speed, torque and power of every part on every shaft.

    Args:
        sizing: As sized.
    """
    note = "Torque on the shaft; power into the shaft is positive."
    fields = ("shaft", "part", "speed", "torque", "power")
    return tuple(table(f"Case {case}", _shaft_by_shaft(sizing, case), fields, note=note) for case in sizing.flows)


def _shaft_by_shaft(sizing: Sizing, case: str) -> list[Branch]:
    found = branches(sizing.train, sizing.flows[case])
    return [each for shaft in sizing.design.shafts for each in found if each.shaft == shaft]


def tables_of(sizing: Sizing) -> dict[str, Table]:
    """Return every table of a sizing, by a short name.

    Args:
        sizing: As sized.
    """

    def mark(record: object, field: str) -> Mark:
        return given_by_user(sizing, record, field)

    return {
        **mounted_tables(sizing),
        "margins": table("Margins, worst first", margins(sizing),
                         ("part", "check", "case", "value", "limit", "unit", "margin", "source"),
                         note=_JUST_ENOUGH),
        "speeds": table("Speeds that yield", asked_speeds(sizing),
                        ("case", "machine", "asked", "actual", "deviation")),
        "gears": table("Gears", sizing.gears, _gear_fields(sizing), mark=mark),
        "meshes": table("Mesh forces", sizing.meshes,
                        ("name", "count", "case", "load_factor", "tangential_force", "radial_force", "axial_force",
                         "pitch_line_velocity"), note="Forces of one mesh."),
        "rating": table("Mesh rating", sizing.meshes,
                        ("name", "module_bending", "module_contact", "bending_stress", "bending_margin",
                         "contact_stress", "contact_margin")),
        "shafts": table("Shafts: loads and stresses", sizing.shafts,
                        ("name", "case", "torque", "bending_moment", "axial_force", "diameter", "stress", "margin"),
                        mark=mark, note=_THICKEST if sizing.built_shafts else ""),
        "shaft_sizes": table("Shafts: sizes", sizing.shafts,
                             ("name", "length", "diameter", "bore", "stiffness", "mass", "inertia"), mark=mark),
        "bearings": table("Bearing loads", bearings(sizing), ("shaft", "case", "position", "radial_force"),
                          note=_BEARINGS),
        "envelope": table("Envelope", [envelope(sizing)], ("width", "height", "length", "volume"),
                          note=_ENVELOPE),
        "overrides": overrides_table(sizing),
        "carriers": table("Carriers", sizing.carriers,
                          ("stage", "torque", "tangential_force", "centrifugal_force", "radius", "pin_diameter",
                           "plate_thickness", "mass", "inertia"), mark=mark),
        "machines": table("Machines", sizing.machines, ("name", "kind", "shaft", "torque", "mass", "inertia"),
                          mark=mark),
        "mass": table("Mass", mass_parts(sizing), ("part", "group", "count", "each", "total", "share"),
                      note=NOT_IN_THE_MASS),
    }  # fmt: skip


def bearings(sizing: Sizing) -> tuple[Bearing, ...]:
    """Return the load of every bearing on shafts of one diameter, shaft by shaft.

    Args:
        sizing: As sized.
    """
    built = {shaft.name for shaft in sizing.built_shafts}
    largest = max((each.radial_force for shaft in sizing.shafts for each in shaft.bearings), default=0.0)
    return tuple(
        Bearing(shaft.name, shaft.case, each.position, _above_rounding(each.radial_force, largest))
        for shaft in sizing.shafts
        for each in shaft.bearings
        if shaft.name not in built
    )


def _above_rounding(value: float, largest: float) -> float:
    return value if value > ROUNDING * largest else 0.0


def _gear_fields(sizing: Sizing) -> tuple[str, ...]:
    helical = ("helix_angle",) if any(gear.helix_angle for gear in sizing.gears) else ()
    return ("name", "bodies", "teeth", "module", *helical, "face_width", "pitch_diameter", "mass", "inertia")
