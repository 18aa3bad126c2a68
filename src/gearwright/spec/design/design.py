"""The design: what a user writes of a transmission, typed and in SI.

Every default lives here, once, beside the type. A field that is None is a freedom: gearwright chooses it.
"""

from __future__ import annotations

import math
from typing import Literal

from pydantic import Field

from gearwright.spec.bounds import Name
from gearwright.spec.design.dynamics import DynamicsRules, PlanetaryBearings
from gearwright.spec.design.mounting import BearingSeat, Joint
from gearwright.spec.design.planet_bearing import PlanetBearing
from gearwright.spec.design.service import Iso6336Rules, Service
from gearwright.spec.design.support import Support
from gearwright.spec.design.tolerance import PartErrors
from gearwright.spec.record import Record
from gearwright.units import (
    Angle,
    Force,
    Inertia,
    Length,
    Mass,
    Power,
    Ratio,
    Speed,
    Stiffness,
    Torque,
    TorsionalStiffness,
)

GROUND = "ground"
"""The shaft that stands still."""

_DEGREE = math.pi / 180.0


class Turbine(Record):
    """A gas turbine's output (power turbine) that drives a shaft."""

    shaft: str = Field(description="Shaft that it drives")
    power: Power = Field(gt=0, le=1e9, description="Rated power")
    speed: Speed = Field(ge=0.1, le=2e4, description="Speed at rated power")
    inertia: Inertia | None = Field(None, gt=0, description="Polar inertia of its rotor; estimated if left out")
    diameter: Length | None = Field(None, gt=0, le=100, description="Disc diameter, for the inertia estimate")


class Motor(Record):
    """An electric motor on a shaft; with negative power in a case it generates."""

    shaft: str = Field(description="Shaft that it drives")
    power: Power = Field(gt=0, le=1e9, description="Rated power")
    speed: Speed = Field(ge=0.1, le=2e4, description="Speed at rated power")
    flux: Literal["radial", "axial"] = Field("radial", description="Flux topology, for its proportions")
    mass_law: Literal["ndarc", "thesis"] = Field(
        "ndarc", description="Mass from torque: NDARC's law, or the thesis's k T^0.33"
    )
    mass: Mass | None = Field(None, gt=0, description="Known mass, instead of the law")
    reverse: bool = Field(False, description="Its shaft turns against the first machine's, as seen from one end")
    balances: bool = Field(
        False,
        description="Its torque follows from equilibrium, as on one member of a differential; power is its rating",
    )
    inertia: Inertia | None = Field(None, gt=0, description="Polar inertia of its rotor; estimated if left out")


class Propeller(Record):
    """A propeller or rotor; it takes the power that the machines give."""

    shaft: str = Field(description="Shaft that carries it")
    speed: Speed = Field(ge=0.1, le=2e4, description="Asked speed; the teeth may let it yield")
    diameter: Length = Field(gt=0, le=100, description="Diameter")
    blades: int = Field(4, ge=2, le=12, description="Number of blades")
    inertia: Inertia | None = Field(None, gt=0, description="Polar inertia; estimated if left out")
    thrust: Force = Field(0.0, description="Along its shaft, positive away from the gears")
    in_plane_force: Force = Field(0.0, ge=0, description="Across its shaft, turning with the flow, not with the shaft")
    hub_moment: Torque = Field(0.0, ge=0, description="Bending moment at its hub, in the plane of the force across")


class GearRules(Record):
    """How gears are rated and proportioned; a stage may state its own under ``gears``."""

    material: str = Field("nitriding-steel-785", description="Name in the catalogue of materials")
    rating: Literal["lewis-hertz", "iso6336"] = Field(
        "lewis-hertz",
        description="First sizing by Lewis and Hertz, or ISO 6336 and ISO 10300 with the rules of iso6336",
    )
    iso6336: Iso6336Rules = Field(default_factory=Iso6336Rules, description='Rules with rating = "iso6336"')
    pressure_angle: Angle = Field(
        20 * _DEGREE, ge=14 * _DEGREE, le=30 * _DEGREE, description="Normal pressure angle α_n"
    )
    helix_angle: Angle = Field(0.0, ge=0, le=45 * _DEGREE, description="Helix angle β of pairs; 0 is spur")
    face_width_ratio: Ratio | None = Field(
        None, gt=1, le=60, description="λ = b/m_n; left out: 10 for spur, the overlap ratio's for helical"
    )
    overlap_ratio: Ratio = Field(1.15, ge=1, le=5, description="Overlap ratio ε_β that sets the width of helical gears")
    bending_safety: Ratio = Field(2.5, ge=1, description="Factor on R_p0.2 in Lewis's bending")
    contact_safety: Ratio = Field(1.5, ge=1, description="Factor on 2.5 HB in Hertz's contact")
    mesh_load_factor: Ratio | None = Field(
        None, ge=1, le=3, description="K_γ, largest over mean load of parallel meshes; left out: 1 (equal sharing)"
    )
    idler_factor: Ratio = Field(
        1.0,
        ge=0.1,
        le=1,
        description="Share of the bending allowable for gears loaded both ways (planets); ISO 6336-3 takes 0.7",
    )
    profile_shift: Ratio = Field(
        0.0,
        ge=-0.5,
        le=1,
        description="Profile shift x of pinions; it lowers the tooth number that is free of undercut",
    )
    contact_angles: Literal["normal", "transverse"] = Field(
        "normal", description="Angles of the helical contact formula: α and β as the thesis prints, or α_t and β_b"
    )
    mesh_efficiency: Ratio = Field(
        1.0, gt=0.5, le=1, description="Efficiency of one mesh; the driven gear receives that part of the tooth power"
    )
    web_ratio: Ratio = Field(
        1.0, ge=0.01, le=1, description="Mass of a wheel body over that of the solid disc; 1 is solid"
    )
    rim_thickness_ratio: Ratio = Field(3.95, ge=1, description="Ring wall from its pitch circle over the module")


class TeethRules(Record):
    """What the search for tooth numbers may choose from; the table of Lewis form factors begins at 12 teeth."""

    sun_minimum: int = Field(18, ge=12, le=400, description="Smallest tooth number of suns")
    sun_maximum: int = Field(59, ge=12, le=400, description="Largest tooth number of suns")
    pinion_minimum: int | None = Field(
        None, ge=12, le=400, description="Smallest tooth number of pinions; left out: no undercut"
    )
    pinion_maximum: int = Field(40, ge=12, le=400, description="Largest tooth number of pinions that are searched")
    planet_minimum: int = Field(12, ge=12, le=400, description="Smallest tooth number of planets")
    stage_tolerance: Ratio = Field(
        0.025, gt=0, le=0.2, description="Allowed deviation of a stage's ratio from its target"
    )
    speed_tolerance: Ratio = Field(0.05, gt=0, le=0.2, description="Allowed deviation of a speed that yields")
    split: Literal["equal", "optimal"] = Field(
        "equal", description="equal: stages share an open ratio equally (times ψ); optimal: as is lightest"
    )
    hunting: bool = Field(False, description="Ask for tooth numbers without a common factor")


class Pair(Record):
    """A gear pair, or several equal ones side by side.

    ``pinion`` and ``wheel`` name shafts; one of them may be a list, and then the single gear meshes with all of them.
    A name such as ``second.pinion`` means that gear of another pair, which is then shared.
    """

    pinion: str | list[str] = Field(description="Shaft (or shafts, or shared gear) of the pinion")
    wheel: str | list[str] = Field(description="Shaft (or shafts, or shared gear) of the wheel")
    pinion_teeth: int | None = Field(None, ge=6, le=2000, description="z_1; left out: gearwright chooses")
    wheel_teeth: int | None = Field(None, ge=6, le=2000, description="z_2; left out: gearwright chooses")
    ratio: Ratio | None = Field(
        None, ge=0.001, description="Asked ratio z_2/z_1; left out: the shafts' speeds or the split give it"
    )
    ratio_split: Ratio = Field(1.0, gt=0.2, lt=5, description="ψ: this stage takes ψ times its equal part of the ratio")
    halves: Literal[1, 2] = Field(
        1, description="2 for a double-helical gear: two halves of opposite hand share the load"
    )
    internal: bool = Field(False, description="The wheel is an internal gear")
    kind: Literal["cylindrical", "face", "bevel"] = Field(
        "cylindrical",
        description="face: the wheel's teeth stand on its face and the pinion lies across; bevel: the axes meet",
    )
    axis_angle: Angle | None = Field(None, description="Angle between the axes of a face-gear or bevel pair: 90°")
    spiral_angle: Angle = Field(
        0.0, ge=0, le=45 * _DEGREE, description="Mean spiral angle β_m of bevel gears; 0 is straight"
    )
    pinion_apex: Literal["first", "second"] = Field(
        "second", description="End of the pinion's shaft towards which the apex of a bevel pair lies"
    )
    wheel_apex: Literal["first", "second"] = Field(
        "second", description="End of the wheel's shaft towards which the apex of a bevel pair lies"
    )
    mesh_stiffness: Stiffness | None = Field(
        None, gt=0, description="Known mean stiffness of one mesh along its line of action; left out: ISO 6336-1"
    )
    stiffness_swing: Ratio | None = Field(
        None, ge=0, lt=1, description="Known first harmonic of the mesh stiffness over its mean"
    )
    backlash: Length = Field(
        0.0, ge=0, le=0.01, description="Along the line of action; 0: teeth stay in contact both ways"
    )
    coaxial_with: str | None = Field(
        None, description="Pair whose centre distance this one must have, as their shafts lie on the same axes"
    )
    share: list[Ratio] | None = Field(None, description="Share of the load of each parallel mesh; left out: equal")
    gears: GearRules | None = Field(None, description="Rules of this pair where they differ from [gears]")


class Planetary(Record):
    """A planetary set: sun, ring, carrier and equal planets; any member may be ``ground``."""

    sun: str = Field(description="Shaft of the sun")
    ring: str = Field(description="Shaft of the ring")
    carrier: str = Field(description="Shaft of the carrier")
    planets: int = Field(3, ge=1, le=12, description="Number of planets")
    sun_teeth: int | None = Field(None, ge=6, le=2000, description="z_s; left out: gearwright chooses")
    planet_teeth: int | None = Field(None, ge=6, le=2000, description="z_p; left out: gearwright chooses")
    ring_teeth: int | None = Field(None, ge=6, le=2000, description="z_r; left out: z_s + 2 z_p")
    ratio: Ratio | None = Field(
        None, gt=1, description="Asked ratio 1 + z_r/z_s; left out: the speeds or the split give it"
    )
    ratio_split: Ratio = Field(1.0, gt=0.2, lt=5, description="ψ: this stage takes ψ times its equal part of the ratio")
    backlash: Length = Field(
        0.0, ge=0, le=0.01, description="Of each mesh, along the line of action; 0: contact both ways"
    )
    bearings: PlanetaryBearings = Field(
        default_factory=PlanetaryBearings, description="What holds its members, with dynamics.fidelity translational"
    )
    planet_bearing: PlanetBearing | None = Field(None, description="What each planet turns on; left out: not known")
    gears: GearRules | None = Field(None, description="Rules of this set where they differ from [gears]")


class Clutch(Record):
    """A clutch that joins two shafts when it is engaged."""

    driving: str = Field(description="Shaft that drives")
    driven: str = Field(description="Shaft that is driven")
    kind: Literal["overrunning", "engaged", "open"] = Field(
        "overrunning", description="overrunning transmits only from driving to driven and opens otherwise"
    )


class ShaftRules(Record):
    """How shafts are sized."""

    material: str | None = Field(None, description="Name in the catalogue; left out: that of the gears")
    safety: Ratio = Field(2.0, ge=1, description="Factor on R_p0.2 against Tresca's stress")
    end_length: Length = Field(0.100, gt=0, description="Length of a shaft that joins a machine to a planetary set")
    middle_length: Length = Field(0.060, gt=0, description="Length of a shaft between planetary sets")
    bearing_length: Length = Field(
        0.015, gt=0, description="Length per bearing and per gap between gears of a pair's shaft"
    )
    bore_ratio: Ratio = Field(
        0.0,
        ge=0,
        lt=0.95,
        description="Bore over outer diameter, on a shaft with bearings over its thinnest bearing seat; 0 is solid",
    )
    fatigue: Literal["asme", "goodman"] = Field(
        "asme", description="Criterion of fatigue for shafts with bearings: the ASME ellipse or Goodman's line"
    )
    reliability: Ratio = Field(
        0.999, ge=0.5, le=0.9999, description="Part of the shafts that reaches the endurance limit (Shigley, table 6-5)"
    )
    surface: Literal["ground", "machined"] = Field("machined", description="Surface of shafts with bearings")
    fillet_ratio: Ratio = Field(
        0.05, ge=0.01, le=0.3, description="Fillet radius over the thinner diameter where no bearing asks for less"
    )


class CarrierRules(Record):
    """How carriers are sized."""

    safety: Ratio = Field(2.0, ge=1, description="Factor on R_p0.2 against the stress of pins and plate")
    plate_ratio: Ratio = Field(0.25, ge=0.01, le=2, description="Plate thickness over the planets' face width")
    fill: Ratio = Field(0.6, ge=0.01, le=1, description="Share of the plate that is not cut out")


class Place(Record):
    """Where something sits along its shaft."""

    position: Length = Field(ge=0, description="Middle of its width, from the shaft's first end")


class ShaftLayout(Record):
    """What is given of one shaft."""

    length: Length | None = Field(None, gt=0, description="Length between its ends")
    diameter: Length | None = Field(
        None, gt=0, description="Outer diameter, on a shaft with bearings its thickest between gears; left out: sized"
    )
    as_given: bool = Field(
        False,
        description="True: the shaft is one cylinder of its diameter, its bearings and joints are as given; nothing"
        " grows, and what does not fit is a failed check",
    )
    bore_ratio: Ratio | None = Field(None, ge=0, lt=0.95, description="Bore over outer diameter")
    bore: Length | None = Field(None, gt=0, description="Bore diameter")
    inertia: Inertia | None = Field(None, ge=0, description="Polar inertia without gears; left out: of the cylinder")
    torsional_stiffness: TorsionalStiffness | None = Field(
        None, gt=0, description="Over its whole length; left out: of the cylinder"
    )
    first_bearing: Length | None = Field(
        None, ge=0, description="Middle of the first bearing, from the shaft's first end; left out: at that end"
    )
    second_bearing: Length | None = Field(
        None, ge=0, description="Middle of the second bearing, from the shaft's first end; left out: at the other end"
    )
    places: dict[str, Place] = Field(
        default_factory=dict, description="Where gears, carriers, machines and clutches sit; left out: in order"
    )
    angle: Angle | None = Field(
        None,
        ge=-2 * math.pi,
        le=2 * math.pi,
        description="Direction of this shaft's axis seen from the axis that it meshes with; left out: evenly spaced",
    )


NOTHING_GIVEN = ShaftLayout()
"""The layout of a shaft of which nothing is given."""


class Drive(Record):
    """What one machine does in a case."""

    power: Power | None = Field(
        None,
        ge=-1e9,
        le=1e9,
        description="Power into the train; negative takes power out; left out: it balances the rest",
    )
    speed: Speed | None = Field(None, ge=0.1, le=2e4, description="Speed, where it is not the rated one")


class SpeedRules(Record):
    """Which speed holds where the teeth make the asked ratio only nearly."""

    keep: list[str] | None = Field(
        None, description="Machines whose speed is kept, in order; left out: turbines, then motors, then propellers"
    )


class Design(Record):
    """A transmission as its user wrote it."""

    schema_version: Literal[1] = Field(1, alias="schema", description="Version of this file format")
    name: str = Field(description="Name of the design")
    description: str = Field("", description="What it is for")
    shafts: list[Name] = Field(min_length=1, description="Names of all shafts")
    turbines: dict[str, Turbine] = Field(default_factory=dict, description="Gas turbines by name")
    motors: dict[str, Motor] = Field(default_factory=dict, description="Electric motors by name")
    propellers: dict[str, Propeller] = Field(default_factory=dict, description="Propellers by name")
    pairs: dict[str, Pair] = Field(default_factory=dict, description="Gear pairs by name")
    planetaries: dict[str, Planetary] = Field(default_factory=dict, description="Planetary sets by name")
    clutches: dict[str, Clutch] = Field(default_factory=dict, description="Clutches by name")
    gears: GearRules = Field(default_factory=GearRules, description="Rules for all gears")
    teeth: TeethRules = Field(default_factory=TeethRules, description="Rules of the search for tooth numbers")
    shafting: ShaftRules = Field(default_factory=ShaftRules, description="Rules for all shafts")
    carriers: CarrierRules = Field(default_factory=CarrierRules, description="Rules for all carriers")
    layout: dict[str, ShaftLayout] = Field(default_factory=dict, description="What is given of single shafts")
    supports: dict[str, Support] = Field(default_factory=dict, description="Shafts that move on their bearings")
    errors: dict[str, PartErrors] = Field(
        default_factory=dict, description="What is not as drawn, by gear, shaft or planet"
    )
    dynamics: DynamicsRules = Field(default_factory=DynamicsRules, description="Assumptions of the dynamic model")
    service: Service = Field(default_factory=Service, description="The life that is asked, and the loads in it")
    bearings: dict[str, BearingSeat] = Field(default_factory=dict, description="Bearings of shafts by name")
    joints: dict[str, Joint] = Field(default_factory=dict, description="Shaft-hub joints by gear or machine")
    speeds: SpeedRules = Field(default_factory=SpeedRules, description="Which speeds are kept")
    cases: dict[str, dict[str, Drive]] = Field(
        default_factory=dict, description="Load cases: what each machine does; a machine left out idles"
    )
    overrides: dict[str, float] = Field(
        default_factory=dict,
        description='Computed values that are given instead, by dotted path with unit: "first.module_mm" = 3',
    )
    origins: dict[str, str] = Field(
        default_factory=dict,
        description='Where overrides come from, by the same path: "first.module_mm" = "drawing 4711"',
    )

    @property
    def machines(self) -> dict[str, Turbine | Motor | Propeller]:
        """Every machine by name."""
        return {**self.turbines, **self.motors, **self.propellers}

    @property
    def stages(self) -> dict[str, Pair | Planetary]:
        """Every pair and planetary set by name."""
        return {**self.pairs, **self.planetaries}

    def rules(self, stage: str) -> GearRules:
        """Return the gear rules of a stage: the design's own where the stage says nothing else.

        Args:
            stage: Name of a pair or planetary set.
        """
        stage_rules = self.stages[stage].gears
        return self.gears if stage_rules is None else _overlaid(self.gears, stage_rules)


def _overlaid(rules: GearRules, stage_rules: GearRules) -> GearRules:
    """Return rules with what a stage says of its own, in the table of ISO 6336 too."""
    update = {name: getattr(stage_rules, name) for name in stage_rules.model_fields_set - {"iso6336"}}
    deeper = {name: getattr(stage_rules.iso6336, name) for name in stage_rules.iso6336.model_fields_set}
    return rules.model_copy(update={**update, "iso6336": rules.iso6336.model_copy(update=deeper)})
