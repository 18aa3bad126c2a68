"""The design record in SI, its level, overrides, load spectrum, parallel load paths and shared gears."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from typing import Any, Literal, NamedTuple, Self, TypeVar

from pydantic import Field, model_validator

from gearwright.base import SIDES, Mass, Problem, Role, Shown, near, suffix_unit
from gearwright.catalogue import material_of, materials
from gearwright.memo import of_latest
from gearwright.parts import Material
from gearwright.spec.design.duty import (
    MACHINES,
    Accessory,
    Airscrew,
    Case,
    Drive,
    ElectricMachine,
    Generator,
    Load,
    Machine,
    Motor,
    Propeller,
    Rotor,
    Service,
    Spectrum,
    SpeedRules,
    Turbine,
)
from gearwright.spec.design.rules import (
    GRADE_KEYS,
    RATINGS,
    WARMTH_KEYS,
    BearingRules,
    DynamicsRules,
    ForbiddenBand,
    GearRules,
    HousingRules,
    LossRules,
    MaterialRules,
    OilOfDesign,
    PartErrors,
    TeethRules,
    method_of,
)
from gearwright.spec.design.stages import (
    NOTHING_GIVEN,
    BearingSeat,
    CarrierRules,
    Clutch,
    Damper,
    Epicyclic,
    InstallationEnvelope,
    Joint,
    KeepOut,
    Pair,
    Planetary,
    PlanetBearing,
    ShaftLayout,
    ShaftRules,
    Support,
)
from gearwright.spec.record import Key as Written, Name, Record, keys_of, range_of

# ----------------------------------------------------------------------------------------------------------------------
# What a design implies that states no level: one by what stands in it, and what this level asks for.
#
# What is implied is no entry of the design: texts leave it out, and it follows anew from every change.
# ----------------------------------------------------------------------------------------------------------------------


CONCEPT, PRELIMINARY, BUILT = "concept", "preliminary", "built"
STATIC, FATIGUE = "lewis-hertz", "iso6336"
"""Methods that rate where the design names none: by static strength where it states that it is a concept, else against
fatigue."""
R = TypeVar("R", bound=Record)


def implied_level(rules: Iterable[GearRules], *, bearings: bool) -> str:
    """Return the level of a design that states none: built with bearings, concept where a static method is named.

    Args:
        rules: Of [gears], and of every stage that has its own.
        bearings: Whether its shafts have bearings.
    """
    if bearings:
        return BUILT
    return CONCEPT if any(map(_names_static, rules)) else PRELIMINARY


def implied_rules(rules: GearRules, *, concept: bool) -> GearRules:
    """Return [gears] with a method, where they name none: against fatigue, unless the design is stated as a concept.

    Args:
        rules: Of the design.
        concept: Whether the design states that it is one.
    """
    return _implying(rules, "rating", STATIC if concept else FATIGUE)


def implied_bearings(planetaries: Mapping[str, Planetary], level: str) -> dict[str, Planetary]:
    """Return planetary sets whose planets turn on bearings of the catalogue above level concept, where they name none.

    Args:
        planetaries: Of the design, by name.
        level: That it has.
    """
    bearing = None if level == CONCEPT else PlanetBearing()
    return {name: _implying(stage, "planet_bearing", bearing) for name, stage in planetaries.items()}


def _names_static(rules: GearRules) -> bool:
    """Tell whether rules name a method that knows no fatigue."""
    return "rating" in rules.model_fields_set and not RATINGS[rules.rating].fatigue


def _implying(record: R, key: str, value: Any) -> R:
    """Return a record with a value that its user leaves open, which does not count as given."""
    if key in record.model_fields_set or getattr(record, key) == value:
        return record
    copy = record.model_copy()
    copy.__dict__[key] = value
    return copy


# ----------------------------------------------------------------------------------------------------------------------
# The design: what a user writes of a transmission, typed and in SI.
#
# Every default lives with the types of this folder, once. A field that is None is a freedom: gearwright chooses it.
# ----------------------------------------------------------------------------------------------------------------------


GROUND = "ground"
"""The shaft that stands still."""


class Gearbox(Record):
    """What is known of the gearbox as a whole."""

    mass: Mass | None = Field(None, gt=0, description="Its mass, as weighed; left out: the sum of its parts")


class Design(Shown, Record):
    """A transmission as its user wrote it."""

    schema_version: Literal[1] = Field(1, alias="schema", description="Version of this file format")
    name: str = Field(description="Name of the design")
    description: str = Field("", description="What it is for")
    author: str = Field("", description="Who answers for it, for the head of its pages")
    revision: str = Field("", description="Which state of it this is, for the head of its pages")
    level: Literal["concept", "preliminary", "built"] = Field(
        "preliminary",
        description="How far it is worked out: a first sizing with shafts of one diameter (concept), the same against"
        " fatigue, with gears as they are made and bearings in planets (preliminary), or that with bearings, steps and"
        " joints of shafts as well (built); left out: built where [bearings] stand, concept where a rating without"
        " fatigue is named, else preliminary",
    )
    shafts: list[Name] = Field(min_length=1, description="Names of all shafts")
    turbines: dict[str, Turbine] = Field(default_factory=dict, description="Gas turbines by name")
    motors: dict[str, Motor] = Field(default_factory=dict, description="Electric motors by name")
    propellers: dict[str, Propeller] = Field(default_factory=dict, description="Propellers by name")
    rotors: dict[str, Rotor] = Field(default_factory=dict, description="Rotors of helicopters by name")
    generators: dict[str, Generator] = Field(default_factory=dict, description="Generators by name")
    accessories: dict[str, Accessory] = Field(
        default_factory=dict, description="Pumps, fans and other accessories by name"
    )
    loads: dict[str, Load] = Field(
        default_factory=dict, description="Anything else that takes power, such as wheels, by name"
    )
    pairs: dict[str, Pair] = Field(default_factory=dict, description="Gear pairs by name")
    planetaries: dict[str, Planetary] = Field(default_factory=dict, description="Planetary sets by name")
    epicyclics: dict[str, Epicyclic] = Field(
        default_factory=dict,
        description="Compound epicyclic sets by name: stepped and meshed planets, several suns and rings",
    )
    clutches: dict[str, Clutch] = Field(default_factory=dict, description="Clutches by name")
    dampers: dict[str, Damper] = Field(default_factory=dict, description="Viscous dampers between shafts by name")
    materials: dict[str, MaterialRules] = Field(
        default_factory=dict, description="Materials of one's own by name, beside those of the catalogue"
    )
    gears: GearRules = Field(default_factory=GearRules, description="Rules for all gears")
    teeth: TeethRules = Field(default_factory=TeethRules, description="Rules of the search for tooth numbers")
    housing: HousingRules = Field(default_factory=HousingRules, description="Housing and oil system, for the mass")
    gearbox: Gearbox = Field(default_factory=Gearbox, description="What is known of the gearbox as a whole")
    shafting: ShaftRules = Field(default_factory=ShaftRules, description="Rules for all shafts")
    carriers: CarrierRules = Field(default_factory=CarrierRules, description="Rules for all carriers")
    layout: dict[str, ShaftLayout] = Field(default_factory=dict, description="What is given of single shafts")
    keep_out: dict[str, KeepOut] = Field(
        default_factory=dict, description="Space that the gearbox may not take, by name"
    )
    installation_envelope: InstallationEnvelope = Field(
        default_factory=InstallationEnvelope, description="Circle, length and offset of axes that the gearbox may take"
    )
    supports: dict[str, Support] = Field(default_factory=dict, description="Shafts that move on their bearings")
    errors: dict[str, PartErrors] = Field(
        default_factory=dict, description="What is not as drawn, by gear, shaft or planet"
    )
    dynamics: DynamicsRules = Field(default_factory=DynamicsRules, description="Assumptions of the dynamic model")
    service: Service = Field(default_factory=Service, description="The life that is asked, and the loads in it")
    bearings: dict[str, BearingSeat] = Field(default_factory=dict, description="Bearings of shafts by name")
    bearing_rules: BearingRules = Field(default_factory=BearingRules, description="How rolling bearings are judged")
    joints: dict[str, Joint] = Field(default_factory=dict, description="Shaft-hub joints by gear or machine")
    oil: OilOfDesign = Field(default_factory=OilOfDesign, description="The oil at bearings and teeth")
    losses: LossRules = Field(default_factory=LossRules, description="By whose formulas power is lost")
    speeds: SpeedRules = Field(default_factory=SpeedRules, description="Which machines' speeds are kept, met exactly")
    cases: dict[str, Case] = Field(
        default_factory=dict,
        description="Load cases that size the gearbox; left out: one, called rated, with every machine at its rating",
    )
    spectra: dict[str, Spectrum] = Field(
        default_factory=dict, description="Load spectra by name, for the cases or the service that name them"
    )
    waivers: dict[str, str] = Field(
        default_factory=dict,
        description='Checks that may fail, by name, with the reason: "helical.pinion face width" = "drawing 4711"',
    )
    overrides: dict[str, float] = Field(
        default_factory=dict,
        description='Computed values that are given instead, by dotted path with unit: "first.module_mm" = 3;'
        " the tables of stages, shafts and motors have keys for them, too",
    )
    origins: dict[str, str] = Field(
        default_factory=dict,
        description='Where given values come from, by the path of overrides: "first.module_mm" = "drawing 4711"',
    )

    @model_validator(mode="after")
    def _implied(self) -> Self:
        """Fill in the level that what stands in the design implies, and what that level asks for."""
        if "level" not in self.model_fields_set:
            own = (stage.gears for stage in self.stages.values() if stage.gears is not None)
            self.__dict__["level"] = implied_level((self.gears, *own), bearings=bool(self.bearings))
        concept = self.level == CONCEPT and "level" in self.model_fields_set
        self.__dict__["gears"] = implied_rules(self.gears, concept=concept)
        self.__dict__["planetaries"] = implied_bearings(self.planetaries, self.level)
        return self

    def stating(self, *, level: str) -> Self:
        """Return the same design with its level stated, and what follows from that; nothing is checked.

        Args:
            level: One that there is.
        """
        given = {name: getattr(self, name) for name in self.model_fields_set} | {"level": level}
        aliases = {name: info.alias or name for name, info in type(self).model_fields.items()}
        return type(self).model_validate({aliases[name]: value for name, value in given.items()})

    @property
    def machines(self) -> Mapping[str, Machine]:
        """Every machine by name."""
        return _machines(self)

    @property
    def airscrews(self) -> dict[str, Airscrew]:
        """Propellers and rotors by name: what has thrust."""
        return {**self.propellers, **self.rotors}

    @property
    def links(self) -> dict[str, Clutch | Damper]:
        """Everything that joins two shafts of one axis, by name."""
        return {**self.clutches, **self.dampers}

    @property
    def simple_stages(self) -> dict[str, Pair | Planetary]:
        """Every pair and planetary set by name: stages of one ratio, whose teeth may be left out."""
        return {**self.pairs, **self.planetaries}

    @property
    def stages(self) -> dict[str, Pair | Planetary | Epicyclic]:
        """Every pair, planetary set and compound set by name."""
        return {**self.simple_stages, **self.epicyclics}

    def table(self, stage: str) -> str:
        """Return the table of the file in which a stage stands, such as ``planetaries.first``.

        Args:
            stage: Name of a pair, planetary set or compound set.
        """
        return f"{self.kind(stage)}.{stage}"

    def kind(self, stage: str) -> str:
        """Return the kind of a stage as the file has it: ``pairs``, ``planetaries`` or ``epicyclics``.

        Args:
            stage: Name of a pair, planetary set or compound set.
        """
        return "pairs" if stage in self.pairs else "planetaries" if stage in self.planetaries else "epicyclics"

    @property
    def sets(self) -> dict[str, Planetary | Epicyclic]:
        """Every stage with a carrier by name."""
        return {**self.planetaries, **self.epicyclics}

    @property
    def known_materials(self) -> Mapping[str, Material]:
        """Every material that the design may name: those of the catalogue and its own."""
        return {**materials(), **{name: self.material(name) for name in self.materials}}

    def material(self, name: str) -> Material:
        """Return a material of the design or of the catalogue.

        Args:
            name: Of one that exists.
        """
        own = self.materials.get(name)
        return materials()[name] if own is None else material_of(name, own.model_dump())

    def gear_material(self, stage: str) -> Material:
        """Return the material of the gears of a stage, which all that weighs, rates and shakes them reads.

        Args:
            stage: Name of a pair, planetary set or compound set.
        """
        return self.material(self.rules(stage).material)

    @property
    def shaft_material(self) -> Material:
        """The material of shafts and carriers."""
        return self.material(self.shafting.material or self.gears.material)

    def rules(self, stage: str) -> GearRules:
        """Return the gear rules of a stage: the design's own where the stage says nothing else, with the oil of [oil].

        Args:
            stage: Name of a pair, planetary set or compound set.
        """
        return _rules(self)[stage]

    def key_of(self, stage: str, key: str) -> str:
        """Return where a key of a stage is written: in the stage's table; rules of gears that it lacks in [gears].

        Args:
            stage: Name of a pair, planetary set or compound set.
            key: Below the stage, such as ``wheel_shift`` or ``gears.iso6336.ring_cutter.teeth``.
        """
        at: object = self.stages[stage]
        for name in key.split(".") if key.startswith("gears.") else ():
            if not isinstance(at, Record) or name not in at.model_fields_set:
                return key
            at = getattr(at, name)
        return f"{self.table(stage)}.{key}"

    @property
    def efficiencies(self) -> dict[str, float]:
        """Stage, or mesh of a compound set that has its own -> efficiency of one mesh [-]."""
        own = {
            f"{name}.{mesh}": value
            for name, epicyclic in self.epicyclics.items()
            for mesh, value in epicyclic.mesh_efficiencies.items()
        }
        return {stage: self.rules(stage).mesh_efficiency for stage in self.stages} | own

    def rating(self, stage: str) -> str:
        """Return the name of the method that rates a stage, such as ``iso10300`` for bevel gears by ISO standards.

        Args:
            stage: Name of a pair, planetary set or compound set.
        """
        return method_of(self.rules(stage).rating, self.stages[stage].meshes)

    @property
    def compares_sizes(self) -> bool:
        """Whether several sizes are completed and compared: gears are sized on a grid, or held against all checks."""
        return self.level != CONCEPT or any(RATINGS[self.rating(name)].table for name in self.stages)


@of_latest(2)
def _machines(design: Design) -> dict[str, Machine]:
    return {name: machine for table in MACHINES for name, machine in getattr(design, table).items()}


@of_latest(2)
def _rules(design: Design) -> dict[str, GearRules]:
    own = {name: stage.gears for name, stage in design.stages.items()}
    overlaid = {name: design.gears if rules is None else _overlaid(design.gears, rules) for name, rules in own.items()}
    return {name: with_oil(rules, design.oil) for name, rules in overlaid.items()}


def with_oil(rules: GearRules, oil: OilOfDesign) -> GearRules:
    """Return rules of gears whose oil is that of the design, as far as they say none of their own.

    Args:
        rules: Of a stage.
        oil: Of the design; what it leaves out stays as the rules of the gears have it.
    """
    own, stated = rules.iso6336.model_fields_set, oil.model_fields_set
    grade = {} if own & GRADE_KEYS.keys() else GRADE_KEYS
    told = {key: of_oil for key, of_oil in {**grade, **WARMTH_KEYS}.items() if of_oil in stated and key not in own}
    if not told:
        return rules
    update = {key: getattr(oil, of_oil) for key, of_oil in told.items()}
    return rules.model_copy(update={"iso6336": rules.iso6336.model_copy(update=update)})


def _overlaid(rules: GearRules, stage_rules: GearRules) -> GearRules:
    """Return rules with what a stage says of its own, in the tables of its standards too."""
    update: dict[str, object] = {name: getattr(stage_rules, name) for name in stage_rules.model_fields_set}
    for name, written in update.items():
        if isinstance(written, Record):
            own = {key: getattr(written, key) for key in written.model_fields_set}
            update[name] = getattr(rules, name).model_copy(update=own)
    return rules.model_copy(update=update)


# ----------------------------------------------------------------------------------------------------------------------
# Gears that several pairs share, and which stages therefore have one module.
# ----------------------------------------------------------------------------------------------------------------------


def gear_owner(design: Design, pair: str, side: Role) -> str:
    """Return the pair that owns the gear on one side of a pair: itself, or the one that it names.

    Args:
        design: With its pairs.
        pair: Name of the pair.
        side: Pinion or wheel.
    """
    owner, _ = design.pairs[pair].shared(side) or (pair, side)
    return owner if owner in design.pairs else pair


@of_latest(2)
def module_owners(design: Design) -> dict[str, str]:
    """Return stage -> the stage whose module it has: of all that gears join, the first that shares no gear of another.

    Args:
        design: As typed.
    """
    shares = {name: {gear_owner(design, name, side) for side in SIDES} - {name} for name in design.pairs}
    group = {name: {name} for name in design.simple_stages}
    for name, owners in shares.items():
        joined = set[str]().union(group[name], *(group[owner] for owner in owners))
        group |= dict.fromkeys(joined, joined)
    order = list(design.simple_stages)
    return {
        name: min(joined, key=lambda stage: (bool(shares.get(stage)), order.index(stage)))
        for name, joined in group.items()
    }


# ----------------------------------------------------------------------------------------------------------------------
# Values that the user gives in place of computed ones: by path in [overrides], or by a key in the table of their part.
#
# Both places say the same. What can be given is seen from the design; sizing reads one table of it, path -> value.
# ----------------------------------------------------------------------------------------------------------------------


NO_ORIGIN = "user's design file"
"""Origin of a value that the user gave without saying where it comes from."""
_OF_PAIRS = {
    "module": "module", "outer_module": "outer_module", "face_width": "face_width",
    "pinion_mass": "pinion.mass", "pinion_inertia": "pinion.inertia",
    "wheel_mass": "wheel.mass", "wheel_inertia": "wheel.inertia",
}  # fmt: skip
"""Key of a pair -> end of the path."""
_OF_SETS = {
    "module": "module", "face_width": "face_width",
    "sun_mass": "sun.mass", "sun_inertia": "sun.inertia", "planet_mass": "planet.mass",
    "planet_inertia": "planet.inertia", "ring_mass": "ring.mass", "ring_inertia": "ring.inertia",
    "pin_diameter": "pin_diameter", "plate_thickness": "plate_thickness", "eye_wall": "eye_wall",
    "carrier_mass": "carrier.mass", "carrier_inertia": "carrier.inertia",
}  # fmt: skip
"""Key of a planetary set -> end of the path."""
_OF_CARRIERS = ("pin_diameter", "plate_thickness", "eye_wall", "carrier_mass", "carrier_inertia")
"""Those of them that compound sets have, too."""
_OF_COMPOUND_GEARS = ("module", "face_width", "mass", "inertia")
"""Keys of a gear of a compound set."""
_OF_SHAFTS = ("length", "diameter", "mass")
"""Keys of a shaft's layout."""
WEIGHED = ("motors", "generators", "accessories")
"""Tables of machines that have a mass."""
_OF_ELECTRIC = ("mass", "inverter_mass", "cooling_mass")
"""Keys of a motor or generator."""


class ComputedKey(NamedTuple):
    """A computed value that can be given."""

    path: str
    """Its name in [overrides], without the unit: ``first.carrier.mass``."""
    table: str
    """Table of the design file that has a key for it: ``planetaries.first``."""
    field: str
    """Of that table: ``carrier_mass``."""
    record: Record
    """What stands in that table; an empty one where the file has no such table."""

    @property
    def written(self) -> float | None:
        """What stands in its own table [SI]."""
        value: float | None = getattr(self.record, self.field)
        return value

    @property
    def entries(self) -> Mapping[str, Written]:
        """Name in [overrides] -> how a value is written under it."""
        stem = self.path.removesuffix(self.field)
        keys = {key: meant for key, meant in keys_of(type(self.record)).items() if meant.field == self.field}
        named = {key: meant for key, meant in keys.items() if meant.inverse}
        suffixed = {f"{self.path}_{meant.suffix}": meant for meant in keys.values() if not meant.inverse}
        return suffixed | {f"{stem}{key}": meant for key, meant in named.items()}


class _Entry(NamedTuple):
    """A name that [overrides] may have."""

    key: ComputedKey
    meant: Written


class Given(NamedTuple):
    """A value that the user gives in place of a computed one."""

    value: float
    """In SI."""
    entry: str
    """Where it stands: a path of [overrides], or a key with its table, each with a unit."""
    amount: float
    """In the unit of that entry."""
    origin: str = NO_ORIGIN
    """Where the user has it from."""


class GivenValues(NamedTuple):
    """Everything that a design gives in place of computed values."""

    values: Mapping[str, Given]
    """By path, without the unit."""
    problems: tuple[Problem, ...]
    """What names nothing, is given twice, or is none that a part has."""


@of_latest(2)
def given_values(design: Design) -> GivenValues:
    """Return what a design gives in place of computed values, from both places.

    Args:
        design: As typed.
    """
    keys = list(givable(design))
    values = {key.path: _own(key, key.written) for key in keys if key.written is not None}
    problems = [*_without_effect(design)]
    if design.overrides or design.origins:
        entries = {name: _Entry(key, meant) for key in keys for name, meant in key.entries.items()}
        problems += _add_overrides(design, entries, values)
        problems += _add_origins(design, entries, values)
    return GivenValues(values, tuple(problems))


def _add_overrides(design: Design, entries: Mapping[str, _Entry], values: dict[str, Given]) -> Iterator[Problem]:
    """Put what [overrides] gives among the values, and yield what is wrong with it."""
    for entry, amount in design.overrides.items():
        fault = _fault(entry, amount, entries, values)
        if fault:
            yield Problem(f"overrides.{entry}", fault)
        else:
            key, meant = entries[entry]
            values[key.path] = Given(meant.si(amount), entry, amount)


def _add_origins(design: Design, entries: Mapping[str, _Entry], values: dict[str, Given]) -> Iterator[Problem]:
    """Put where values come from beside them, and yield what belongs to none."""
    for entry, origin in design.origins.items():
        path = entries[entry].key.path if entry in entries else ""
        if path in values:
            values[path] = values[path]._replace(origin=origin)
        elif entry not in design.overrides:
            known = [name for name, (key, _) in entries.items() if key.path in values]
            yield Problem(f"origins.{entry}", f"nothing of this name is given; {near(entry, known)}")


def _own(key: ComputedKey, value: float) -> Given:
    meant = next(iter(key.entries.values()))
    return Given(value, f"{key.table}.{key.field}_{meant.suffix}", meant.written(value))


def _fault(entry: str, amount: float, entries: Mapping[str, _Entry], values: Mapping[str, Given]) -> str | None:
    """Return what is wrong with an entry of [overrides], if anything is."""
    if entry not in entries:
        usual = {key.path: name for name, (key, _) in reversed(list(entries.items()))}
        return f"nothing of this name is computed; {near(entry, entries, usual.values())}"
    key, meant = entries[entry]
    allowed = range_of(type(key.record).model_fields[key.field])
    if not allowed.holds(meant.si(amount)):
        return f"{amount:g} {suffix_unit(meant.suffix)} is not allowed; give {meant.words(allowed)}"
    if key.path in values:
        first = values[key.path].entry
        place = f"overrides.{first}" if first in entries else first
        return f"{key.path} is given twice: here, and as {place}; keep one of the two"
    return None


def givable(design: Design) -> Iterator[ComputedKey]:
    """Yield everything that is computed of a design and can be given.

    Args:
        design: As typed.
    """
    owners = module_owners(design)
    yield ComputedKey("gearbox.mass", "gearbox", "mass", design.gearbox)
    for name, pair in design.pairs.items():
        idle = {field for field, _ in _idle(design, name, owners[name])}
        yield from (
            ComputedKey(f"{name}.{end}", f"pairs.{name}", f, pair) for f, end in _OF_PAIRS.items() if f not in idle
        )
    for name, planetary in design.planetaries.items():
        yield from (ComputedKey(f"{name}.{end}", f"planetaries.{name}", f, planetary) for f, end in _OF_SETS.items())
    yield from _of_compounds(design)
    for name in design.shafts:
        layout = design.layout.get(name, NOTHING_GIVEN)
        yield from (ComputedKey(f"{name}.{field}", f"layout.{name}", field, layout) for field in _OF_SHAFTS)
    for table in WEIGHED:
        for name, machine in getattr(design, table).items():
            fields = _OF_ELECTRIC if isinstance(machine, ElectricMachine) else ("mass",)
            yield from (ComputedKey(f"{name}.{field}", f"{table}.{name}", field, machine) for field in fields)


def _of_compounds(design: Design) -> Iterator[ComputedKey]:
    """Yield what can be given of compound sets: of every gear, of the carrier and of its pins."""
    for name, epicyclic in design.epicyclics.items():
        table = f"epicyclics.{name}"
        for kind, gears in (("suns", epicyclic.suns), ("rings", epicyclic.rings), ("planets", epicyclic.planets)):
            for gear_name, gear in gears.items():
                place = f"{table}.{kind}.{gear_name}"
                yield from (
                    ComputedKey(f"{name}.{gear_name}.{field}", place, field, gear) for field in _OF_COMPOUND_GEARS
                )
        yield from (
            ComputedKey(f"{name}.{end}", table, f, epicyclic) for f, end in _OF_SETS.items() if f in _OF_CARRIERS
        )


def _idle(design: Design, name: str, owner: str) -> Iterator[tuple[str, str]]:
    """Yield the keys of a pair that give nothing, and why: its module or its gear is another's."""
    is_bevel = design.pairs[name].kind == "bevel"
    if is_bevel or owner != name:
        why = "a bevel pair has an outer_module" if is_bevel else f"it has the module of pairs.{owner}; give it there"
        yield "module", why
    if not is_bevel or owner != name:
        why = f"it has that of pairs.{owner}; give it there" if is_bevel else "only a bevel pair has one"
        yield "outer_module", why
    for side in SIDES:
        gear = gear_owner(design, name, side)
        if gear != name:
            why = f"the gear is that of pairs.{gear}; give it there"
            yield from ((f"{side}_mass", why), (f"{side}_inertia", why))


def _without_effect(design: Design) -> Iterator[Problem]:
    """Yield every key of a pair that is written and gives nothing."""
    owners = module_owners(design)
    for name, pair in design.pairs.items():
        for field, why in _idle(design, name, owners[name]):
            if getattr(pair, field) is not None:
                yield Problem(f"pairs.{name}.{field}", f"has no effect: {why}")


# ----------------------------------------------------------------------------------------------------------------------
# Which load cases a design has, and what share of its life each lasts.
# ----------------------------------------------------------------------------------------------------------------------


RATED = "rated"
"""Name of the one case of a design without cases: each machine at its rated power."""
_ALONE = Case()


def cases_of(design: Design) -> tuple[str, ...]:
    """Return the names of the cases that size a design; the first speaks for it: ``rated``, or the first that lasts.

    Args:
        design: With its cases, or none.
    """
    return tuple(sorted(design.cases, key=lambda name: (name != RATED, design.cases[name].static))) or (RATED,)


def cases_forbidding(design: Design, band: ForbiddenBand) -> tuple[str, ...]:
    """Return the names of the cases in which a forbidden band of frequencies holds: those named, or all that last.

    Args:
        design: With its cases, or none.
        band: Of the rules for its teeth.
    """
    named = cases_of(design) if band.cases is None else band.cases
    return tuple(case for case in named if band.cases is not None or not case_named(design, case).static)


def case_named(design: Design, case: str) -> Case:
    """Return a case of a design.

    Args:
        design: With its cases, or none.
        case: Name of one of them, or ``rated``.
    """
    return design.cases.get(case, _ALONE)


def drives_of(design: Design, case: str) -> Mapping[str, Drive]:
    """Return what every machine does in a case.

    Args:
        design: With its machines.
        case: Name of one of its cases; any other is the one of a design without cases.
    """
    drives = _drives(design)
    return drives[case if case in drives else ""]


@of_latest(2)
def _drives(design: Design) -> dict[str, dict[str, Drive]]:
    """Return case -> what every machine does in it; under an empty name what it does in a design without cases."""
    machines = design.machines
    alone = {"": {name: machine.fully for name, machine in machines.items()}}
    return alone | {
        case: {
            name: _drive(machine.unsaid, said.machines[name], machine.rating)
            if name in said.machines
            else machine.unsaid
            for name, machine in machines.items()
        }
        for case, said in design.cases.items()
    }


def _drive(unsaid: Drive, said: Drive, rating: float | None) -> Drive:
    """Return what a machine does that a case names: what it says, or what is usual at the speed that it says."""
    if said.rating is not None:
        return Drive.model_construct(power=said.rating * (rating or 0.0), speed=said.speed)
    if said.stated or said.balances:
        return said
    if unsaid.idles:
        return Drive.model_construct(balances=True, speed=said.speed)
    return unsaid.model_copy(update={"speed": said.speed})


def levels_of(design: Design, case: str) -> tuple[tuple[float, float], ...]:
    """Return the levels of a case: part of its loads [-], share of its time [-]; of a static case its own alone.

    Args:
        design: With its cases and spectra.
        case: Name of one of its cases, or ``rated``.
    """
    said = case_named(design, case)
    name = None if said.static else said.spectrum or design.service.spectrum
    if name is None:
        return ((1.0, 1.0),)
    return tuple(zip(design.spectra[name].load, design.spectra[name].share, strict=True))


def shares_of(design: Design) -> Mapping[str, float]:
    """Return case -> share of the life [-]; empty where none is said: then one case lasts all of it.

    Args:
        design: With its service and its cases.
    """
    lasting = {name: case for name, case in design.cases.items() if not case.static}
    if design.service.shares or not lasting:
        return design.service.shares
    durations = [case.duration for case in lasting.values()]
    whole = sum(duration or 0.0 for duration in durations)
    if whole and None not in durations:
        return {name: (case.duration or 0.0) / whole for name, case in lasting.items()}
    if all(case.share is not None for case in lasting.values()):
        return {name: case.share or 0.0 for name, case in lasting.items()}
    return {}


# ----------------------------------------------------------------------------------------------------------------------
# Parallel paths of a train: which pairs lie on a loop that the power can pass two ways, and how often it has split.
# ----------------------------------------------------------------------------------------------------------------------


class _Link(NamedTuple):
    """Two shafts that turn at a fixed ratio, with the stage that joins them."""

    stage: str
    ends: tuple[str, str]


@of_latest(2)
def split_levels(design: Design) -> Mapping[str, float]:
    """Return pair -> how often the power has split in two where it passes, of pairs on parallel paths [-].

    Two paths are one level, four are two. Paths of machines of their own, as of two engines on one wheel, close no
    loop: their machines decide what each of them carries.

    Args:
        design: As typed.
    """
    links = list(_links(design))
    rows = {name: [link for link in links if link.stage == name] for name in design.pairs}
    looped = {name for name, own in rows.items() if any(_closes(link, links) for link in own)}
    branches = {name: _branches(design, name) if len(rows[name]) > 1 else set() for name in looped}

    def levels(name: str, above: frozenset[str]) -> float:
        trunk = {end for link in rows[name] for end in link.ends} - branches[name]
        parents = (other for other in looped - above - {name} if trunk & branches[other])
        return math.log2(len(rows[name])) + max((levels(other, above | {name}) for other in parents), default=0.0)

    return {name: levels(name, frozenset()) for name in looped}


def _branches(design: Design, name: str) -> set[str]:
    """Return the shafts of the side of a pair that has several."""
    sides = (_shafts(design, name, side) for side in SIDES)
    return set().union(*(side for side in sides if len(side) > 1))


def _shafts(design: Design, name: str, side: Role) -> list[str]:
    """Return the shafts on one side of a pair, of a shared gear those of its owner."""
    pair = design.pairs[name]
    shared = pair.shared(side)
    if shared is None:
        return pair.named(side)
    owner = design.pairs.get(shared[0])
    return [] if owner is None or owner.shared(shared[1]) is not None else owner.named(shared[1])


def _links(design: Design) -> Iterator[_Link]:
    """Yield what joins two shafts at a fixed ratio: pairs, sets of which a member stands still, clutches."""
    for name in design.pairs:
        first, second = (_shafts(design, name, side) for side in SIDES)
        for one in first:
            for other in second:
                yield _Link(name, (one, other))
    for name, planetary in design.planetaries.items():
        moving = [shaft for shaft in planetary.members if shaft != GROUND]
        if len(moving) == 2:
            yield _Link(name, (moving[0], moving[1]))
    for name, clutch in design.clutches.items():
        if clutch.kind != "open" and GROUND not in (clutch.driving, clutch.driven):
            yield _Link(name, (clutch.driving, clutch.driven))


def _closes(link: _Link, links: list[_Link]) -> bool:
    """Tell whether the ends of a link are joined without it."""
    near = defaultdict[str, set[str]](set)
    for other in links:
        if other is not link:
            first, second = other.ends
            near[first].add(second)
            near[second].add(first)
    reached, waiting = {link.ends[0]}, [link.ends[0]]
    while waiting:
        new = near[waiting.pop()] - reached
        reached |= new
        waiting += new
    return link.ends[1] in reached
