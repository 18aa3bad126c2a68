"""Tables of a Sizing: cases, margins, gears with every factor, mounted shafts, materials, what the user gave.

Tables of how it moves and lives stand beside this folder, drawings of its numbers in `figures`.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from functools import partial
from typing import TYPE_CHECKING, Annotated

from gearwright.base import Length, Mass, Number, Origin, Power, Quantity, Slope, Speed, shown, text, unit
from gearwright.particulars import Particulars, UsedMaterial
from gearwright.parts import Material
from gearwright.parts.iso6336 import GearSteel, LifeCurve
from gearwright.render.grid import Mark, Table, table
from gearwright.render.tables.checks import COLUMNS, JUST_ENOUGH, judged
from gearwright.sizing import Body, BuiltShaft, MachineSizing, Passing, ShaftSizing, Sizing
from gearwright.sizing.losses import ORIGINS, Loss, LossBalance
from gearwright.sizing.mass import CompleteMass, Statistics
from gearwright.sizing.result import TeethSearch
from gearwright.spec import Design
from gearwright.spec.design import NOTHING_GIVEN, RATINGS, module_owners
from gearwright.train import Branch

if TYPE_CHECKING:
    from gearwright.dynamics.sharing import PathShare

# ----------------------------------------------------------------------------------------------------------------------
# What the user gave in place of computed values, and how it is marked.
# ----------------------------------------------------------------------------------------------------------------------


_LAYOUT = {"stiffness": "torsional_stiffness"}
"""Field of a sized shaft -> its name in the layout, where they differ."""
_OF_MACHINES = {"mass": "mass", "inverter": "inverter_mass", "cooling": "cooling_mass", "inertia": "inertia"}
"""Field of a sized machine -> its name in the design."""


def given_by_user(sizing: Sizing, record: object, field: str) -> Mark:
    """Return whether a value was computed, given by the user, or estimated.

    Args:
        sizing: With what is given of it.
        record: One of its records.
        field: Name of the field.
    """
    name, stage = getattr(record, "name", "") or str(getattr(record, "part", "")), getattr(record, "stage", "")
    owner = module_owners(sizing.design).get(stage, stage)
    paths = {f"{name}.{field}", f"{stage}.{field}"}
    if field == "module":
        paths.add(f"{owner}.module")
    if paths & set(sizing.given) or _in_design(sizing, record, field):
        return "given"
    if isinstance(record, MachineSizing) and field == "inertia" and not record.inertia_is_given:
        return "estimated"
    return ""


def _in_design(sizing: Sizing, record: object, field: str) -> bool:
    """Tell whether the design file itself states a value that would else be computed."""
    if isinstance(record, ShaftSizing):
        layout = sizing.design.layout.get(record.name, NOTHING_GIVEN)
        return getattr(layout, _LAYOUT.get(field, field), None) is not None
    if isinstance(record, MachineSizing) and field in _OF_MACHINES:
        return getattr(sizing.design.machines[record.name], _OF_MACHINES[field], None) is not None
    return False


def overrides_table(sizing: Sizing) -> Table:
    """Return the values that the user gave in place of computed ones, with where they are from.

    Args:
        sizing: As sized.
    """
    return table("Given in place of computed values", list(sizing.given.values()), ("entry", "amount", "origin"))


# ----------------------------------------------------------------------------------------------------------------------
# Where the power of every case goes, as tables: by origin, and part by part for the first case.
# ----------------------------------------------------------------------------------------------------------------------


_NAMED = 3
"""Parts that a note names; more are counted [-]."""
_LOSS_NOTE = (
    "; the torques of the case do not know them, but gears.mesh_efficiency. Bearings of unknown size rub by a constant"
    " coefficient."
)


def _note(design: Design) -> str:
    """Say by what the losses are: whose oil, and that it is assumed where the design says none."""
    oil = design.oil
    kind = "the oil of [oil]" if "oil" in design.model_fields_set else "an assumed turbine oil, as [oil] is left out"
    degrees = oil.temperature
    return f"By the formulas of [losses], with {kind}: {oil.viscosity_40:g} mm²/s at 40 °C, {degrees:g} °C{_LOSS_NOTE}"


@dataclass(frozen=True)
class LossesOfCase:
    """What one case loses, by origin."""

    case: str
    power: Power
    """Into the gearbox [W]."""
    meshes: Power
    """[W]"""
    bearings: Power
    """[W]"""
    windage: Power
    """[W]"""
    churning: Power
    """[W]"""
    seals: Power
    """[W]"""
    lost: Power
    """In all [W]."""
    efficiency: Annotated[float, Quantity("ratio"), Origin("η = 1 − Σ P_V/P_in", "[losses] of the design")]
    """[-]"""


def losses_of_cases(balances: Iterable[LossBalance]) -> tuple[LossesOfCase, ...]:
    """Return what every case loses, by origin.

    Args:
        balances: Of the cases.
    """
    return tuple(map(_row, balances))


def _limits(losses: Iterable[Loss]) -> str:
    """Say of which losses the formula is at a limit, and at which: every limit once, with the parts that have it."""
    held: dict[str, list[str]] = {}
    for loss in losses:
        if loss.limit:
            held.setdefault(loss.limit, []).append(loss.part)
    return "".join(f" {_parts(parts)}: {limit}." for limit, parts in held.items())


def _parts(names: list[str]) -> str:
    return ", ".join(names) if len(names) <= _NAMED else f"{names[0]} and {len(names) - 1} more"


def _row(balance: LossBalance) -> LossesOfCase:
    parts = dict.fromkeys(ORIGINS, 0.0) | balance.by_origin()
    return LossesOfCase(balance.case, balance.power, **parts, lost=balance.lost, efficiency=balance.efficiency)


def loss_tables(facts: Particulars) -> dict[str, Table]:
    """Return the tables of losses by a short name.

    Args:
        facts: Of a sizing.
    """
    sizing = facts.sizing
    fields = ("case", "power", *ORIGINS, "lost", "efficiency")
    losses = facts.losses[sizing.reference.case].losses
    limits = ("limit",) if any(loss.limit for loss in losses) else ()
    columns = ("origin", "part", "count", "power", "share", "method", *limits)
    of_cases, note = losses_of_cases(facts.losses.values()), _note(sizing.design) + _limits(losses)
    return {
        "losses": table("Losses by origin", of_cases, fields, note=note),
        "loss_parts": table("Losses part by part", losses, columns, note=f"Case {sizing.reference.case}."),
    }


# ----------------------------------------------------------------------------------------------------------------------
# How the teeth of a sizing were chosen, in a sentence.
# ----------------------------------------------------------------------------------------------------------------------


def chosen_teeth(sizing: Sizing) -> str:
    """Return among how many combinations the teeth were chosen and what the next costs; nothing where all are given.

    Args:
        sizing: As sized.
    """
    search = sizing.search
    if search is None:
        return ""
    proof = "proven" if search.proven else "not proven: too many to hold"
    if sizing.design.compares_sizes:
        return _looked_at(sizing, search, proof)
    if search.sized + search.refused == 1:
        following = _next(search.gear_mass, search.next_mass)
        return f"the lightest gears of {search.combinations:,.0f} combinations ({proof}){following}"
    refused = f", {search.refused} refused" if search.refused else ""
    none, some = search.sized == search.failing, 0 < search.failing < search.sized
    failing = ", none of which passes its checks" if none else f", {search.failing} fail checks" if some else ""
    following = ""
    if math.isfinite(search.next_sized_mass):
        following = f"; the next complete gearbox weighs {search.next_sized_mass:.4g} kg"
    sized = f"{search.sized} sized in full{failing}{refused}{following}"
    lightest = f"those with the lightest gears of {search.combinations:,.0f} combinations ({proof})"
    return f"the lightest {'that passes its checks ' if some else ''}of {lightest}: {sized}"


def _looked_at(sizing: Sizing, search: TeethSearch, proof: str) -> str:
    """Return how a sizing that compares several sizes came to its teeth, and what it did not look for."""
    fall = f", {search.failing} of them fall short" if search.failing else ""
    refused = f", {search.refused} refused" if search.refused else ""
    fails = any(check.fails for check in sizing.checks)
    taken = "the fewest failing checks" if fails else "the lightest that passes"
    lightest = f"the lightest gears of {search.combinations:,.0f} combinations ({proof})"
    design = sizing.design
    closed = [name for name in design.stages if not RATINGS[design.rating(name)].table]
    left = f"; module and width of {', '.join(closed)} by their method, not searched" if closed else ""
    return f"{taken} among those with {lightest}: gears of {search.sized} sized{fall}{refused}{left}"


def _next(mass: float, heavier: float) -> str:
    """Say how much heavier the next one is; nothing where there is none."""
    more = heavier / mass - 1.0
    return f"; the next is {more:.2%} heavier" if math.isfinite(more) else ""


# ----------------------------------------------------------------------------------------------------------------------
# Every number of a material with its unit, its source, and whether it is estimated.
# ----------------------------------------------------------------------------------------------------------------------


NUMBERS = {
    "elastic_modulus": ("Young's modulus E", "stress"),
    "poisson_ratio": ("Poisson's ratio ν", "ratio"),
    "density": ("density ρ", "density"),
    "yield_strength": ("proof stress R_p0.2", "stress"),
    "ultimate_strength": ("tensile strength R_m", "stress"),
    "surface_hardness": ("hardness of flanks HB", "number"),
    "hardness": ("hardness of flanks HV", "number"),
}
"""Number of a material -> words with its symbol, and its kind."""
STRENGTHS = {"contact_strength": "strength of flanks σ_Hlim", "bending_strength": "strength of roots σ_Flim"}
"""Number of a gear steel -> words with its symbol [stress]."""
ESTIMATED = "estimated: "
"""How the source of a number begins that no source gives."""
_HARDNESS = "hardness"
_STANDARDS = ("ISO 6336-2:2019, table 2", "ISO 6336-3:2019, table 1")
"""Of the S-N lines of flanks and roots."""


@dataclass(frozen=True)
class Property:
    """One property of one material."""

    material: str
    quantity: str
    """In words, with its symbol."""
    value: float | str
    """In its unit."""
    unit: str
    source: str
    """Where it comes from, or that it is estimated and by which rule."""

    @property
    def estimated(self) -> bool:
        """Whether no source gives it."""
        return self.source.startswith(ESTIMATED)


def properties(used: UsedMaterial) -> Iterator[Property]:
    """Yield every property of a material that is known.

    Args:
        used: The material, with the steel as which its gears are rated.
    """
    material, steel = used.material, used.steel
    for key, (words, kind) in NUMBERS.items():
        value: float | None = getattr(material, key)
        if value is not None and (steel is not None or key != _HARDNESS):
            own = _HARDNESS if key == "surface_hardness" and key not in material.sources else key
            yield Property(material.name, words, shown(value, kind), unit(kind), _source(material, own))
    for key, words in (("group", "group of DIN 743"), ("melting", "melting")):
        if getattr(material, key) is not None:
            yield Property(material.name, words, getattr(material, key), "", _source(material, key))
    if steel is not None and used.lives is not None:
        yield from _rated(material, steel, used.lives, as_stated=used.as_stated)


def _rated(
    material: Material, steel: GearSteel, lives: tuple[LifeCurve, LifeCurve], *, as_stated: bool
) -> Iterator[Property]:
    """Yield strengths and S-N lines."""
    yield Property(material.name, "class and grade", f"{steel.name} {steel.grade}", "", steel.source)
    for key, words in STRENGTHS.items():
        stated = as_stated and (key in material.estimated or getattr(material, key) is not None)
        source = _source(material, key) if stated else steel.source
        yield Property(material.name, words, shown(getattr(steel, key), "stress"), unit("stress"), source)
    lines = (("contact_life", "flanks", steel.contact_life), ("bending_life", "roots", steel.bending_life))
    for (key, part, line), curve, standard in zip(lines, lives, _STANDARDS, strict=True):
        source = standard if line is None else _source(material, key)
        yield Property(material.name, f"S-N line of {part}, N and factor", _line(curve), "", source)


def _source(material: Material, key: str) -> str:
    """Return the source of a property, or that it is estimated and how."""
    return f"{ESTIMATED if key in material.estimated else ''}{material.source_of(key)}"


def _line(curve: LifeCurve) -> str:
    """Return the corners of an S-N curve."""
    return ", ".join(f"{n:.3g} × {factor:.3g}" for n, factor in zip(curve.cycles, curve.factors, strict=True))


def materials_table(materials: Iterable[UsedMaterial]) -> Table:
    """Return every property of the materials that a design uses.

    Args:
        materials: Of the design.
    """
    fields = ("material", "quantity", "value", "unit", "source")
    return table("Materials", material_properties(materials), fields, mark=_mark)


def material_properties(materials: Iterable[UsedMaterial]) -> tuple[Property, ...]:
    """Return every property of the materials that a design uses.

    Args:
        materials: Of the design.
    """
    return tuple(line for used in materials for line in properties(used))


def estimated_only(materials: Table) -> Table:
    """Return the rows of a table of materials that no source gives.

    Args:
        materials: As `materials_table` makes it.
    """
    rows = tuple(row for row in materials.rows if any(cell.mark == "estimated" for cell in row))
    return replace(materials, title="Materials: what is estimated", rows=rows)


def _mark(record: object, field: str) -> Mark:
    return "estimated" if field == "value" and getattr(record, "estimated", False) else ""


# ----------------------------------------------------------------------------------------------------------------------
# Where every body stands in space, as tables: envelopes with place and direction, and axes that were turned.
# ----------------------------------------------------------------------------------------------------------------------


_PLACES = (
    "Envelopes: cylinders and cones about an axis, from the middle of their first end on. x runs along the first shaft"
    " from its first end, y and z across it. Planets as the ring that they sweep; no housing and no machines."
)
_TURNS = "Open in the design, and turned by the least angle that makes room; an angle in [layout] keeps an axis."
_SQUARE = 1e-9
"""One less the cosine of the angle to x, y or z below which an axis lies along it [-]."""


@dataclass(frozen=True)
class Stands:
    """Where one body stands."""

    body: str
    """Part, and what of it."""
    shaft: str
    """Shaft that it turns with or stands on, or ``ground``."""
    x: Length
    """Of the middle of its first end [m]."""
    y: Length
    """[m]"""
    z: Length
    """[m]"""
    along_x: Number
    """Direction of its axis [-]."""
    along_y: Number
    """[-]"""
    along_z: Number
    """[-]"""
    length: Length
    """[m]"""
    first_radius: Length
    """At its first end [m]."""
    last_radius: Length
    """At its other end [m]."""
    bore_radius: Length | None
    """Within which there is nothing of it; None where it is solid [m]."""

    @property
    def axis(self) -> str:
        """Direction of its axis in words: ``+x``, or its three parts."""
        parts = {"x": self.along_x, "y": self.along_y, "z": self.along_z}
        whole = [f"{'+' if part > 0.0 else '-'}{name}" for name, part in parts.items() if abs(part) > 1.0 - _SQUARE]
        return whole[0] if whole else ", ".join(f"{part + 0.0:.3f}" for part in parts.values())


def stands(bodies: tuple[Body, ...]) -> tuple[Stands, ...]:
    """Return where every body stands.

    Args:
        bodies: Of an arrangement.
    """
    return tuple(_stands(body) for body in bodies)


def _stands(body: Body) -> Stands:
    first, last = body.stations[0].radius, body.stations[-1].radius
    return Stands(body.name, body.shaft, *body.origin, *body.direction, body.length, first, last, body.bore or None)


def place_tables(sizing: Sizing) -> dict[str, Table]:
    """Return the tables of places by a short name; without rows where there are none.

    Args:
        sizing: As sized.
    """
    fields = ("body", "shaft", "x", "y", "z", "axis", "length", "first_radius", "last_radius", "bore_radius")
    turns = sizing.arrangement.turns
    return {
        "turns": table("Axes turned to make room", turns, ("shaft", "before", "after", "why"), note=_TURNS),
        "places": table("Places in space", stands(sizing.arrangement.bodies), fields, note=_PLACES),
    }


# ----------------------------------------------------------------------------------------------------------------------
# What a reader wants to see of built shafts, as tables: steps, strength, stiffness, bearings, joints.
# ----------------------------------------------------------------------------------------------------------------------


_STEPS = "From the shaft's first end; of a gear of one piece, the part of its body that stiffens the shaft."
_STRENGTH = (
    "The case that tires each section most. K_f and K_fs are felt at the notch; n_f against fatigue at the asked"
    " reliability, and n_y against yield with the application factor, decide; S_D is what DIN 743 says of the section."
)
_STIFFNESS = "Largest of all cases. Critical speed with the gears as discs, in rigid bearings, without rotors."
_BEARING_RATINGS = (
    "Forces of the case with the largest static load; P is the mean over the service. Basic rating life, without a_ISO."
    " Ratings of the assumed inside of a standard size, unless the design gives the maker's."
)
_OILED = (
    "With the oil of [oil]: κ = ν/ν_1 and e_C are the least of all cases. P of the lightest case against what keeps"
    " rolling elements from skidding, speeds against n_θr by ISO 15312: checked where bearing_rules.limits asks for it."
)
_AIRSCREWS = (
    "What acts on a shaft in bearings; on one without, that nobody laid out, assumed loads act on nothing. Cases of"
    " life count for lives and fatigue, those of fatigue for shafts alone, limit loads for yield, static safety and 1.5"
    " times as ultimate loads."
)
_AIRSCREW_FIELDS = (
    "airscrew", "name", "case", "use", "share", "torque_factor", "thrust", "force", "moment", "origin",
)  # fmt: skip
_JOINTS = "Torque of the heaviest case with the application factor."
_STRENGTH_FIELDS = (
    "shaft", "place", "case", "position", "diameter", "bending_moment", "torque", "bending_notch", "torsion_notch",
    "fatigue_safety", "yield_safety", "din743_safety",
)  # fmt: skip
_BEARING_FIELDS = (
    "name", "shaft", "designation", "inner_diameter", "outer_diameter", "width", "case", "radial", "axial",
    "equivalent_load", "dynamic_rating", "life", "static_safety", "mass",
)  # fmt: skip
_OILED_FIELDS = (
    "name", "designation", "viscosity_ratio", "contamination", "life_factor", "modified_life", "lightest_load",
    "least_load", "highest_speed", "reference_speed", "speed_factor",
)  # fmt: skip
_JOINT_FIELDS = (
    "part", "shaft", "kind", "designation", "torque", "diameter", "length", "pressure", "allowed_pressure",
)  # fmt: skip


@dataclass(frozen=True)
class Step:
    """One cylinder of one shaft."""

    shaft: str
    seat: str
    """What sits on it."""
    start: Length
    """[m]"""
    end: Length
    """[m]"""
    diameter: Length
    """[m]"""
    bore: Length
    """[m]"""


@dataclass(frozen=True)
class Bend:
    """How far a shaft bends at one place."""

    shaft: str
    place: str
    """Gear or bearing."""
    slope: Slope
    """[rad]"""
    deflection: Length | None
    """None at bearings [m]."""
    critical_speed: Speed | None
    """First one of the shaft in bending [rad/s]."""


def mounted_tables(facts: Particulars) -> dict[str, Table]:
    """Return the tables of built shafts, bearings and joints by a short name; without rows where there are none.

    Args:
        facts: Of a sizing.
    """
    sizing = facts.sizing
    shafts, strength = sizing.built_shafts, [section for shaft in sizing.built_shafts for section in shaft.sections]
    steps = [step for shaft in shafts for step in _steps(shaft)]
    bends = [bend for shaft in shafts for bend in _bends(shaft)]
    joined = [joint for joint in sizing.joints if joint.kind != "integral"]
    fitted = ("running_pressure", "needed_pressure") if any(joint.running_pressure for joint in joined) else ()
    return {
        "steps": table("Shafts: steps", steps, ("shaft", "seat", "start", "end", "diameter", "bore"), note=_STEPS),
        "strength": table("Shafts: strength of sections", strength, _STRENGTH_FIELDS, note=_STRENGTH),
        "stiffness": table("Shafts: how they bend", bends,
                           ("shaft", "place", "slope", "deflection", "critical_speed"), note=_STIFFNESS),
        "airscrew_loads": table("Loads of propellers and rotors", facts.airscrew_loads, _AIRSCREW_FIELDS,
                                note=_AIRSCREWS),
        "bearing_sizes": table(
            "Bearings", sizing.bearings, _BEARING_FIELDS, note=f"{_BEARING_RATINGS}{_system(facts)}"
        ),
        "bearing_oil": table("Bearings: oil, least load, speeds", sizing.bearings, _OILED_FIELDS, note=_OILED),
        "joints": table("Shaft-hub joints", joined, (*_JOINT_FIELDS, *fitted), note=_JOINTS),
    }  # fmt: skip


def _steps(shaft: BuiltShaft) -> Iterator[Step]:
    for step in shaft.steps:
        yield Step(shaft.name, step.seat, step.start, step.end, step.diameter, shaft.bore)


def _bends(shaft: BuiltShaft) -> Iterator[Bend]:
    deflections = dict(shaft.deflections)
    for place, slope in shaft.slopes:
        yield Bend(shaft.name, place, slope, deflections.get(place), shaft.critical_speed)


def _system(facts: Particulars) -> str:
    """Return what all bearings together live and weigh."""
    if facts.system_life is None:
        return ""
    life, mass = text(facts.system_life, "life"), text(facts.sizing.bearing_mass, "mass")
    return f" All of them reach {life} with 90 % reliability (Weibull's product) and weigh {mass}."


# ----------------------------------------------------------------------------------------------------------------------
# What a reader wants to see of the bearings of planets, as a table.
# ----------------------------------------------------------------------------------------------------------------------


_PLANET_NOTE = (
    "The smallest that serves, where kind or size are left open; a planet is a ring around its bearing, and what turns"
    " of the bearing swings with it. Lives and films stand with the margins."
)


@dataclass(frozen=True)
class PlanetRow:
    """What one kind of planet turns on."""

    planet: str
    designation: str
    pin_diameter: Length
    """[m]"""
    bore: Length
    """Of the planet [m]."""
    width: Length
    """[m]"""
    ring: Mass
    """Of the planet itself [kg]."""
    turning: Mass
    """Of its bearing that turns with it [kg]."""


def planet_table(sizing: Sizing) -> Table:
    """Return what planets turn on; empty where the design does not say.

    Args:
        sizing: As sized.
    """
    fields = ("planet", "designation", "pin_diameter", "bore", "width", "ring", "turning")
    return table("Planet bearings", list(_rows(sizing)), fields, note=_PLANET_NOTE)


def _rows(sizing: Sizing) -> Iterator[PlanetRow]:
    for gear in sizing.gears:
        if (runs_on := gear.runs_on) is not None:
            sizes = (runs_on.pin_diameter, runs_on.outer_diameter, runs_on.width)
            yield PlanetRow(gear.name, runs_on.designation, *sizes, gear.mass, runs_on.turning_mass)


# ----------------------------------------------------------------------------------------------------------------------
# The complete mass of a sizing as tables: its groups with the sum and its band, and every part with its origin.
# ----------------------------------------------------------------------------------------------------------------------


def mass_tables(mass: CompleteMass, statistics: Statistics) -> dict[str, Table]:
    """Return the tables of the complete mass, by a short name.

    Args:
        mass: Complete mass.
        statistics: Of real gearboxes of the same power and speeds.
    """
    return {
        "complete_mass": table(
            "Complete mass", mass.groups, ("group", "total", "share", "deviation"), note=mass_sentence(mass, statistics)
        ),
        "mass_parts": table(
            "Complete mass, part by part", mass.parts,
            ("part", "group", "count", "each", "total", "uncertainty", "formula", "source"),
        ),
    }  # fmt: skip


def mass_sentence(mass: CompleteMass, statistics: Statistics) -> str:
    """Return the sum of all parts with its band, and how it stands to the statistics.

    Args:
        mass: Complete mass.
        statistics: Of real gearboxes of the same power and speeds.
    """
    return f"Sum {with_band(mass)}; machines are not in it. {statistics.sentence}"


def with_band(mass: CompleteMass) -> str:
    """Return a complete mass in words, with its band and what the train is of it.

    Args:
        mass: Complete mass.
    """
    low, high = (text(limit, "mass", 3) for limit in mass.band)
    train = f", of it gears, shafts and carriers {text(mass.train, 'mass', 3)}" if mass.train else ""
    return f"{text(mass.total, 'mass', 3)}, 68 % from {low} to {high}{train}"


# ----------------------------------------------------------------------------------------------------------------------
# What a reader wants to see of a Sizing, as tables: load cases, margins worst first, gears, shafts, masses.
# ----------------------------------------------------------------------------------------------------------------------


_FACTORS = (
    "name", "load_factor", "shared", "case", "resonance_ratio", "dynamic_factor", "relief_term", "tip_relief",
    "tolerance_class",
)  # fmt: skip
_OF_FACTORS = "N in the case nearest to the main resonance; K_V and B_k in the heaviest case."
_KEPT = (
    "Whole teeth give them. A speed is kept, met exactly, of the first machine that [speeds] keep names: left out, a"
    " turbine's, else a motor's."
)
_PASSING = "Backwards: with every torque turned; what gives nothing then is self-locking. Clutches stay as they are."
_BEARINGS = "Positions from the shaft's first end; shafts that only torque acts on need none for it."
_THICKEST = "d of a shaft with steps is its thickest; the stress is of a section, listed with its own d under strength."
_ENVELOPE = "Box around tip circles and shafts, without housing."


def not_in_the_mass(groups: Collection[str]) -> str:
    """Return what the mass of the train leaves out.

    Args:
        groups: Of parts that are in it.
    """
    bearings = "bearings of shafts" if "planet bearings" in groups else "bearings"
    return f"Not in the mass: housing, {bearings}, oil system, accessories, motors."


def flow_tables(branches: Mapping[str, Sequence[Branch]]) -> tuple[Table, ...]:
    """Return one table per load case: speed, torque and power of every part on every shaft.

    Args:
        branches: Load case -> every part on every shaft, shaft by shaft.
    """
    note = "Torque on the shaft; power into the shaft is positive."
    fields = ("shaft", "part", "speed", "torque", "power")
    return tuple(table(f"Case {case}", of_case, fields, note=note) for case, of_case in branches.items())


def passing_table(ways: Sequence[Passing]) -> Table:
    """Return how the gearbox and its epicyclic sets pass power, forwards and backwards, in every case.

    Args:
        ways: From `passing`.
    """
    fields = ("case", "part", "driving", "driven", "forwards", "backwards", "locking")
    return table("Efficiency of the teeth", ways, fields, note=_PASSING)


def gear_table(sizing: Sizing) -> Table:
    """Return the gears of a sizing.

    Args:
        sizing: As sized.
    """
    return table("Gears", sizing.gears, _gear_fields(sizing), mark=partial(given_by_user, sizing),
                 note=_searched(sizing))  # fmt: skip


def tables_of(facts: Particulars) -> dict[str, Table]:
    """Return every table of a sizing, by a short name.

    Args:
        facts: Of the sizing.
    """
    sizing = facts.sizing

    def mark(record: object, field: str) -> Mark:
        return given_by_user(sizing, record, field)

    return {
        **mounted_tables(facts),
        **loss_tables(facts),
        **place_tables(sizing),
        **mass_tables(facts.complete, facts.statistics),
        "margins": table("Margins, worst first", judged(sizing.checks), COLUMNS, note=JUST_ENOUGH),
        "speeds": table("Speeds that deviate from those asked", facts.asked_speeds,
                        ("case", "machine", "asked", "actual", "deviation"), note=_KEPT),
        "passing": passing_table(facts.passing),
        "gears": gear_table(sizing),
        "meshes": table("Mesh forces", sizing.meshes, _mesh_fields(sizing), note="Forces of one mesh."),
        "load_factors": table("Load factors", facts.load_factors, _FACTORS, note=_OF_FACTORS),
        "rating": table("Mesh rating", sizing.meshes,
                        ("name", "module_bending", "module_contact", "bending_stress", "bending_margin",
                         "contact_stress", "contact_margin")),
        "shafts": table("Shafts: loads and stresses", sizing.shafts,
                        ("name", "case", "torque", "bending_moment", "axial_force", "diameter", "stress", "margin"),
                        mark=mark, note=_THICKEST if sizing.built_shafts else ""),
        "shaft_sizes": table("Shafts: sizes", sizing.shafts,
                             ("name", "length", "diameter", "bore", "stiffness", "mass", "inertia"), mark=mark),
        "bearings": table("Bearing loads", facts.bearing_forces, ("shaft", "case", "position", "radial_force"),
                          note=_BEARINGS),
        "envelope": table("Envelope", [facts.envelope], ("width", "height", "length", "volume"),
                          note=_ENVELOPE),
        "overrides": overrides_table(sizing),
        "materials": materials_table(facts.materials),
        "carriers": table("Carriers", sizing.carriers,
                          ("stage", "torque", "tangential_force", "centrifugal_force", "radius", "pin_diameter",
                           "plate_thickness", "mass", "inertia"), mark=mark, note=_unequal(facts)),
        "planet_bearings": planet_table(sizing),
        "machines": table("Machines", sizing.machines, _machine_columns(sizing), mark=mark),
        "mass": table("Train as sized", facts.mass_parts, ("part", "group", "count", "each", "total", "share"),
                      note=not_in_the_mass(facts.mass_groups)),
    }  # fmt: skip


def motor_rows(sizing: Sizing) -> tuple[tuple[str, float], ...]:
    """Return what motors, their inverters and their cooling weigh, by name [kg].

    Args:
        sizing: As sized.
    """
    return (
        ("motors", sizing.motor_mass), ("inverters", sizing.inverter_mass), ("cooling of motors", sizing.cooling_mass),
    )  # fmt: skip


def _machine_columns(sizing: Sizing) -> tuple[str, ...]:
    """Return the columns of machines; inverters and cooling where they are counted."""
    beside = ("inverter", "cooling") if sizing.machines_mass > sizing.motor_mass else ()
    return "name", "kind", "shaft", "torque", "mass", *beside, "inertia"


def _searched(sizing: Sizing) -> str:
    """Say of how many combinations the teeth are the lightest."""
    chosen = chosen_teeth(sizing)
    return f"Teeth: {chosen}." if chosen else ""


def _unequal(facts: Particulars) -> str:
    """Say at which angles the pins of carriers stand that are not evenly divided."""
    words = []
    for stage, planetary in facts.sizing.design.planetaries.items():
        if planetary.unequal_places:
            angles = ", ".join(f"{math.degrees(angle):.7g}°" for angle in facts.pins[stage])
            words.append(f"Pins of {stage} stand at {angles}.")
    return " ".join(words)


def _gear_fields(sizing: Sizing) -> tuple[str, ...]:
    helical = ("helix_angle",) if any(gear.helix_angle for gear in sizing.gears) else ()
    shift = ("profile_shift", "tip_alteration") if _shifted(sizing) else ()
    return ("name", "bodies", "teeth", "module", *helical, *shift, "face_width", "pitch_diameter", "mass", "inertia")


def _mesh_fields(sizing: Sizing) -> tuple[str, ...]:
    working = ("centre_distance", "working_pressure_angle") if _shifted(sizing) else ()
    forces = ("tangential_force", "radial_force", "axial_force")
    return ("name", "count", "case", *working, "load_factor", *forces, "pitch_line_velocity")


def _shifted(sizing: Sizing) -> bool:
    return any(gear.profile_shift or gear.tip_alteration for gear in sizing.gears)


# ----------------------------------------------------------------------------------------------------------------------
# Parallel paths: how the train shares their load, and how the elastic gearbox does.
# ----------------------------------------------------------------------------------------------------------------------


TITLE = "Parallel paths"
NOTE = (
    "Sizing uses the train's shares. The elastic ones follow from shaft and mesh stiffness alone, without errors and"
    " clocking; K_γ is the largest elastic share over the train's."
)


def path_table(paths: Sequence[PathShare]) -> Table:
    """Return the shares of all parallel meshes in the governing case; no rows where there are none.

    Args:
        paths: From `path_shares`.
    """
    return table(TITLE, paths, [field.name for field in fields(paths[0])] if paths else (), note=NOTE)
