"""The design: what a user writes of a transmission, typed and in SI.

Every default lives with the types of this folder, once. A field that is None is a freedom: gearwright chooses it.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, Self

from pydantic import Field, model_validator

from gearwright.catalogue import material_of, materials
from gearwright.parts import Material
from gearwright.showing import Shown
from gearwright.spec.bounds import Name
from gearwright.spec.design.duty import (
    MACHINES,
    Accessory,
    Airscrew,
    Case,
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
from gearwright.spec.design.epicyclics import Epicyclic
from gearwright.spec.design.implied import implied_bearings, implied_level, implied_rules
from gearwright.spec.design.latest import of_the_latest
from gearwright.spec.design.mounting import BearingSeat, Joint
from gearwright.spec.design.rules import (
    GRADE_KEYS,
    WARMTH_KEYS,
    BearingRules,
    DynamicsRules,
    GearRules,
    HousingRules,
    LossRules,
    MaterialRules,
    OilOfDesign,
    PartErrors,
    TeethRules,
    method_of,
)
from gearwright.spec.design.shafts import CarrierRules, KeepOut, ShaftLayout, ShaftRules, Support
from gearwright.spec.design.stages import Clutch, Damper, Pair, Planetary
from gearwright.spec.record import Record
from gearwright.units import Mass

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
        " fatigue, with gears as they are made and bearings in planets (preliminary), or with bearings, steps and"
        " joints (built); left out: built where [bearings] stand, concept where a rating without fatigue or its rules"
        " stand, else preliminary",
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
        self.__dict__["gears"] = implied_rules(self.gears, self.level)
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


@of_the_latest
def _machines(design: Design) -> dict[str, Machine]:
    return {name: machine for table in MACHINES for name, machine in getattr(design, table).items()}


@of_the_latest
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
