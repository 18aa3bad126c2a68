"""What a gearbox has: shafts and carriers, gear pairs, planetary and compound stages, clutches and dampers."""

from __future__ import annotations

import math
from types import MappingProxyType
from typing import Annotated, Literal

from pydantic import Field

from gearwright.base import (
    INCH,
    SIDES,
    Angle,
    Force,
    Inertia,
    Length,
    Mass,
    Ratio,
    Reciprocal,
    Role,
    Slope,
    Stiffness,
    Stress,
    Time,
    TorsionalDamping,
    TorsionalStiffness,
)
from gearwright.parts.planetary import CompoundSet
from gearwright.spec.design.rules import CYLINDRICAL, INTERNAL, GearRules, PlanetaryBearings, ThicknessFit
from gearwright.spec.record import Name, Record

# ----------------------------------------------------------------------------------------------------------------------
# How shafts and carriers are sized, what is given of single shafts, and how they are held.
# ----------------------------------------------------------------------------------------------------------------------


class ShaftRules(Record):
    """How shafts are sized."""

    material: str | None = Field(
        None, description="Name in the catalogue or under [materials]; left out: that of the gears"
    )
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
    radial_gap: Length = Field(
        0.002, gt=0, description="Least gap between a shaft and one that goes through it, all around; an assumption"
    )
    fatigue: Literal["asme", "goodman", "gerber", "soderberg"] = Field(
        "asme",
        description="Criterion of fatigue for shafts with bearings: ASME's ellipse, Goodman's or Soderberg's line,"
        " or Gerber's parabola",
    )
    reliability: Ratio = Field(
        0.999, ge=0.5, le=0.9999, description="Part of the shafts that reaches the endurance limit (Shigley, table 6-5)"
    )
    surface: Literal["ground", "machined"] = Field("machined", description="Surface of shafts with bearings")
    overload: Literal["constant-mean", "constant-ratio"] = Field(
        "constant-mean",
        description="How loads would grow until a section fails, for DIN 743: the amplitude alone (case 1), or mean and"
        " amplitude together (case 2)",
    )
    hard_surface: bool = Field(False, description="Shafts have a hard surface, for DIN 743: K_F = K_2F = γ_F = 1")
    fillet_ratio: Ratio = Field(
        0.05, ge=0.01, le=0.3, description="Fillet radius over the thinner diameter where no bearing asks for less"
    )
    shoulders: Literal["fillet", "undercut"] = Field(
        "fillet",
        description="At the shoulders of bearing seats: a fillet as the bearing allows, ground with the shoulder, or an"
        " undercut DIN 509-F for increased fatigue strength",
    )
    seal: Literal["auto", "nbr", "fkm", "none"] = Field(
        "auto",
        description="Lip of the radial seals where shafts with bearings leave the housing: nitrile or fluoro rubber;"
        " left out the first of them that bears speed and oil, none where neither does",
    )


class CarrierRules(Record):
    """How carriers are sized."""

    safety: Ratio = Field(2.0, ge=1, description="Factor on R_p0.2 against the stress of pins and plate")
    plate_ratio: Ratio = Field(0.25, ge=0.01, le=2, description="Plate thickness over the planets' face width")
    fill: Ratio = Field(0.6, ge=0.01, le=1, description="Share of the plate that is not cut out")
    plates: int | None = Field(
        None, ge=1, le=2, description="That hold pins, above level concept; left out: the lighter that keeps planets"
        " straight, of those that have room",
    )  # fmt: skip
    torque_at: Literal["plate", "middle"] = Field(
        "plate",
        description="Where a carrier of two plates hands on its torque: at one plate, behind which the other lags, or"
        " in the middle of its bridges, as a torque frame does",
    )
    largest_misalignment: Length | None = Field(
        None, ge=1e-8, le=1e-3, description="Of planets' teeth over their face by the carrier's twist and pins that"
        " bend, what helix correction takes left out, above level concept; left out: half of f_Hβ",
    )  # fmt: skip


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
    mass: Mass | None = Field(None, gt=0, description="Mass without gears; left out: of its cylinders")
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
    order: list[str] = Field(
        default_factory=list,
        description="Gears, carriers, machines and clutches on this shaft in the order in which they are to stand, from"
        " its first end on; what is left out stands where there is room",
    )
    angle: Angle | None = Field(
        None,
        ge=-2 * math.pi,
        le=2 * math.pi,
        description="Direction of this shaft's axis seen from the axis that it meshes with; left out: evenly spaced",
    )
    side: Literal["right", "left", "above", "below"] | None = Field(
        None,
        description="Where this shaft's axis stands about the axis that it meshes with, seen along x: y to the right,"
        " z upwards; its angle is then found within a quarter turn of that side; left out: any",
    )


NOTHING_GIVEN = ShaftLayout()
"""The layout of a shaft of which nothing is given."""


SIDE_ANGLES = MappingProxyType({"right": 0.0, "above": math.pi / 2.0, "left": math.pi, "below": -math.pi / 2.0})
"""Side -> direction of its middle [rad]."""


class Spot(Record):
    """A place in space: x runs along the first shaft from its first end, y and z across it."""

    x: Length = Field(0.0, description="Along the first shaft of the design, from its first end")
    y: Length = Field(0.0, description="Across, from the axis of the first shaft")
    z: Length = Field(0.0, description="Upwards, from the axis of the first shaft")


class KeepOut(Record):
    """Space that the gearbox may not take: a box, or with a radius a cylinder."""

    start: Spot = Field(description="A corner of the box, or one end of the cylinder's axis")
    end: Spot = Field(description="The opposite corner, or the other end of the axis")
    radius: Length | None = Field(None, gt=0, description="Of a cylinder; left out: a box")
    reason: str = Field(description="What is there")


class InstallationEnvelope(Record):
    """Room in which the gearbox is installed, with its housing and without its machines."""

    diameter: Length | None = Field(
        None, gt=0, description="Largest circle across the first shaft that may hold its housing; left out: any"
    )
    length: Length | None = Field(
        None, gt=0, description="Largest length along the first shaft, ends of shafts with it; left out: any"
    )
    offset: Length | None = Field(
        None, ge=0, description="Largest distance of the axis of what is driven from that of what drives; left out: any"
    )


class Support(Record):
    """Bearings of a shaft as springs to the housing; a shaft without this entry turns in rigid bearings."""

    radial: Stiffness = Field(gt=0, description="Stiffness in every direction across the shaft, all bearings together")
    axial: Stiffness | None = Field(None, gt=0, description="Stiffness along the shaft; left out: rigid")
    mass: Mass | None = Field(None, gt=0, description="What moves; left out: the shaft and its gears")
    damping: Ratio = Field(0.05, ge=0, lt=1, description="Damping ratio ζ of each direction")


# ----------------------------------------------------------------------------------------------------------------------
# What holds a shaft in its housing and what holds its gears on it: bearing seats, and joints of shaft and hub.
# ----------------------------------------------------------------------------------------------------------------------


LOCATES = {"none": (), "both": (-1, 1), "first": (-1,), "second": (1,)}
"""What a bearing locates -> signs of the axial forces that it takes: −1 towards the first end, +1 the second."""


class BearingSeat(Record):
    """One bearing of a shaft; its size is chosen from the catalogue unless it is given."""

    shaft: str = Field(description="Shaft that it carries")
    position: Length = Field(ge=0, description="Middle of its width, from the shaft's first end")
    kind: Literal["deep-groove", "cylindrical", "taper", "four-point"] = Field(
        "cylindrical", description="Deep-groove ball, cylindrical roller, taper roller or four-point contact ball"
    )
    locates: Literal["none", "both", "first", "second"] = Field(
        "none", description="Axial force that it takes: none, both ways, or only towards that end of the shaft"
    )
    radial: bool = Field(True, description="False: it has clearance in the housing and takes axial force only")
    designation: str | None = Field(None, description="Name in the catalogue, such as NU 2212; left out: chosen")
    bore: Length | None = Field(
        None, gt=0, description="Bore of the seat; left out: the smallest that the shaft allows"
    )
    dynamic_rating: Force | None = Field(None, gt=0, description="Maker's C, instead of the catalogue's")
    static_rating: Force | None = Field(None, gt=0, description="Maker's C_0, instead of the catalogue's")
    largest_outer_diameter: Length | None = Field(None, gt=0, description="Room in the housing; left out: any")
    life: Time | None = Field(None, gt=0, description="Minimum L_10h; left out: service.bearing_life")


class Joint(Record):
    """What carries the torque between a shaft and a gear or machine on it."""

    kind: Literal["integral", "key", "spline", "press-fit"] = Field(
        description="One piece; feather key DIN 6885; involute spline DIN 5480; press fit DIN 7190"
    )
    diameter: Length | None = Field(None, gt=0, description="Of the shaft in it; left out: as thick as strength asks")
    length: Length | None = Field(None, gt=0, description="Bearing length; left out: as long as the torque asks")
    hub_length: Length | None = Field(
        None, gt=0, description="Length of the hub; left out: the gear's face width; machines have none, and need it"
    )
    form: Literal["A", "B"] = Field(
        "A", description="Form of a key: A has round ends, which do not bear; B has square ones"
    )
    module: Length | None = Field(None, gt=0, description="Module of a spline; left out: chosen from DIN 5480's series")
    pressure: Stress | None = Field(
        None, gt=0, description="Allowed flank pressure; left out: 150 MPa for keys, 100 MPa for splines"
    )
    interference: Length | None = Field(
        None, ge=1e-7, le=1e-3, description="Of a press fit, as made; left out: as the torque asks at the highest speed"
    )
    friction: Ratio = Field(0.12, gt=0, lt=1, description="Friction coefficient of a press fit")
    safety: Ratio = Field(1.5, ge=1, le=5, description="Minimum safety against slip of a press fit")


# ----------------------------------------------------------------------------------------------------------------------
# What joins shafts: gear pairs, planetary sets, clutches and dampers.
# ----------------------------------------------------------------------------------------------------------------------


_DEGREE = math.pi / 180.0
NORMAL_PITCH = Reciprocal("normal_diametral_pitch", INCH, "per_in")
"""P_nd = 25.4 mm/m_n."""
PITCH = Reciprocal("diametral_pitch", INCH, "per_in")
"""P_d = 25.4 mm/m, of spur gears."""
OUTER_PITCH = Reciprocal("outer_diametral_pitch", INCH, "per_in")
"""P_d = 25.4 mm/m_et, of bevel gears."""
NOMINAL_PLANETS = 3
"""Planets of a set while their number is to be chosen [-]."""


def gear_named(reference: str) -> tuple[str, Role] | None:
    """Return the pair and the side of it that a text such as ``second.pinion`` means; None where it can mean none.

    Args:
        reference: As written.
    """
    stage, _, role = reference.partition(".")
    return (stage, Role(role)) if role in SIDES else None


SharingLevel = Literal["level-1", "level-2", "level-3", "level-4", "tolerances"]
"""How well planets share their load: a level of AGMA 6123, or by the tolerances of their pins."""
Sharing = Literal["clocked", "rigid", "quill", "floating"]
"""How well parallel paths share their load: clocked to each other, not clocked, over soft shafts, a floating gear."""
LEVELS = (
    "How planets share their load, for K_γ where no factor is given: level-1 to level-4 of AGMA 6123 (3: one member"
    " floats, 4: pins or ring give way, too), or tolerances, with pin_position; left out: level-3, 1.05 at least"
)
PINS = "Standard deviation of the tangential places of planets, for load_sharing tolerances"


class PlanetBearing(Record):
    """What a planet turns on: rolling bearings, of a catalogue or made into the planet, or a film of oil."""

    kind: Literal["cylindrical", "needle", "integral", "ceramic", "plain"] = Field(
        "cylindrical",
        description="cylindrical: of the catalogue; needle, integral: rollers between pin and planet; ceramic: integral"
        " with rollers of Si3N4; plain: a film of oil",
    )
    designation: str | None = Field(None, description="Name in the catalogue, such as NU 2212; left out: by kind")
    side_by_side: int = Field(1, ge=1, le=4, description="Equal bearings that share a pin")
    spacing: Length | None = Field(
        None, gt=0, description="From the middle of one of them to that of the next; left out: they touch"
    )
    dynamic_rating: Force | None = Field(None, gt=0, description="Maker's C, instead of the catalogue's")
    static_rating: Force | None = Field(None, gt=0, description="Maker's C_0, instead of the catalogue's")
    life: Time | None = Field(None, gt=0, description="Minimum L_10h; left out: service.bearing_life")
    diameter: Length | None = Field(
        None, gt=0, description="Of the pin under rollers or film; left out: the smallest that serves"
    )
    width: Length | None = Field(None, gt=0, description="Of rollers' room or film; left out: that of the planet")
    roller_diameter: Length | None = Field(
        None, gt=0, description="Of rollers between pin and planet; left out: needle 0.1, others 0.25 of the pin"
    )
    clearance: Ratio | None = Field(
        None, ge=2e-4, le=1e-2, description="ψ of a plain bearing, over its diameter; left out: 0.8e-3 u^(1/4)"
    )
    largest_pressure: Stress = Field(7e6, gt=0, le=1e8, description="p of a plain bearing, F/(B D), at most")
    least_film: Length | None = Field(
        None, ge=1e-7, le=1e-3, description="h_lim of a plain bearing; left out: by size and speed, ISO 7902-3"
    )
    oil_temperature: float | None = Field(
        None, ge=-40, le=200, description="At which oil enters a plain bearing [°C]; left out: oil.temperature"
    )
    largest_temperature: float = Field(
        125.0, ge=0, le=300, description="At which it leaves a plain bearing, at most [°C]"
    )

    @property
    def is_fitted(self) -> bool:
        """Whether it is a bearing of the catalogue."""
        return self.kind == "cylindrical"


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
    load_sharing: Sharing | None = Field(
        None,
        description="How its parallel paths share their load, for K_γ where no factor is given: clocked 1.06, rigid"
        " 1.20, quill and floating 1.03, to the power of the levels of the split; left out: clocked",
    )
    clocking: Slope | None = Field(
        None,
        gt=0,
        le=0.1,
        description="By how much the clocking of two paths may miss, for K_γ of clocked ones; left out: 1.06",
    )
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
    module: Annotated[Length | None, NORMAL_PITCH] = Field(
        None, gt=0, le=0.1, description="Normal module m_n, P_nd = 25.4 mm/m_n; left out: sized"
    )
    outer_module: Annotated[Length | None, OUTER_PITCH] = Field(
        None, gt=0, le=0.1, description="Outer transverse module m_et of a bevel pair; left out: sized"
    )
    face_width: Length | None = Field(None, gt=0, description="Face width b; left out: sized")
    centre_distance: Length | None = Field(
        None, gt=0, description="Working centre distance a_w; the shifts follow; left out: they give it"
    )
    pinion_shift: Ratio | None = Field(
        None, ge=-1, le=1.5, description="Profile shift x_1, of bevel gears x_hm1; left out: gears.profile_shift"
    )
    wheel_shift: Ratio | None = Field(
        None, ge=-1.5, le=1.5, description="Profile shift x_2; left out: it closes the pair"
    )
    pinion_tip_alteration: Ratio | None = Field(
        None, ge=-0.6, le=0.3, description="Tip alteration k_1; left out: keeps the tip clearance"
    )
    wheel_tip_alteration: Ratio | None = Field(
        None, ge=-0.6, le=0.3, description="Tip alteration k_2; left out: keeps the tip clearance"
    )
    pinion_allowance: ThicknessFit | None = Field(
        None, description="Tooth thickness of the pinion by DIN 3967; left out: gears.allowance"
    )
    wheel_allowance: ThicknessFit | None = Field(
        None, description="Tooth thickness of the wheel by DIN 3967; left out: gears.allowance"
    )
    pinion_bore: Length | None = Field(
        None, gt=0, description="Bore of the pinion, or inside of its rim, for K_V; left out: solid"
    )
    wheel_bore: Length | None = Field(
        None,
        gt=0,
        description="Bore of a solid wheel, or inside of its rim, for K_V; left out: a rim of gears.rim_ratio, or of"
        " 1.2 tooth heights",
    )
    pinion_mass: Mass | None = Field(None, gt=0, description="Of one pinion; left out: of the disc")
    pinion_inertia: Inertia | None = Field(None, gt=0, description="Of one pinion; left out: of the disc")
    wheel_mass: Mass | None = Field(None, gt=0, description="Of one wheel; left out: of the disc")
    wheel_inertia: Inertia | None = Field(None, gt=0, description="Of one wheel; left out: of the disc")
    coaxial_with: str | None = Field(
        None, description="Pair whose centre distance this one must have, as their shafts lie on the same axes"
    )
    share: list[Ratio] | None = Field(None, description="Share of the load of each parallel mesh; left out: equal")
    gears: GearRules | None = Field(None, description="Rules of this pair where they differ from [gears]")

    def named(self, side: Role) -> list[str]:
        """Return the shafts, or the one shared gear, that a side names.

        Args:
            side: Pinion or wheel.
        """
        names = self.pinion if side is Role.PINION else self.wheel
        return names if isinstance(names, list) else [names]

    def shared(self, side: Role) -> tuple[str, Role] | None:
        """Return the pair and the side of it whose gear a side shares, or None where it names shafts.

        Args:
            side: Pinion or wheel.
        """
        return gear_named(next(iter(self.named(side)), ""))

    @property
    def meshes(self) -> tuple[str, ...]:
        """Kinds of its meshes, as methods of rating cover them."""
        return (INTERNAL if self.internal and self.kind == CYLINDRICAL else self.kind,)


class Planetary(Record):
    """A planetary set: sun, ring, carrier and equal planets; any member may be ``ground``."""

    sun: str = Field(description="Shaft of the sun")
    ring: str = Field(description="Shaft of the ring")
    carrier: str = Field(description="Shaft of the carrier")
    planets_given: int | None = Field(
        None, alias="planets", ge=1, le=12, description="Number of planets; left out: gearwright chooses, the lightest"
    )
    sun_teeth: int | None = Field(None, ge=6, le=2000, description="z_s; left out: gearwright chooses")
    planet_teeth: int | None = Field(None, ge=6, le=2000, description="z_p; left out: gearwright chooses")
    ring_teeth: int | None = Field(
        None, ge=6, le=2000, description="z_r; left out: z_s + 2 z_p, which closes without shift"
    )
    ratio: Ratio | None = Field(
        None, gt=1, description="Asked ratio 1 + z_r/z_s; left out: the speeds or the split give it"
    )
    ratio_split: Ratio = Field(1.0, gt=0.2, lt=5, description="ψ: this stage takes ψ times its equal part of the ratio")
    backlash: Length = Field(
        0.0, ge=0, le=0.01, description="Of each mesh, along the line of action; 0: contact both ways"
    )
    module: Annotated[Length | None, PITCH, NORMAL_PITCH] = Field(
        None, gt=0, le=0.1, description="Module m_n; left out: sized"
    )
    face_width: Length | None = Field(None, gt=0, description="Face width b; left out: sized")
    centre_distance: Length | None = Field(
        None, gt=0, description="Working centre distance a_w of both meshes; shifts follow; left out: they give it"
    )
    sun_shift: Ratio | None = Field(None, ge=-1, le=1.5, description="Profile shift x of the sun; left out: chosen")
    planet_shift: Ratio | None = Field(
        None, ge=-1, le=1.5, description="Profile shift x of planets; left out: it closes"
    )
    ring_shift: Ratio | None = Field(
        None,
        ge=-1.5,
        le=1.5,
        description="Profile shift x of the ring (ISO 21771: + thickens its teeth); left out: closes",
    )
    sun_tip_alteration: Ratio | None = Field(
        None, ge=-0.6, le=0.3, description="Tip alteration k of the sun; left out: keeps the tip clearance"
    )
    planet_tip_alteration: Ratio | None = Field(
        None, ge=-0.6, le=0.3, description="Tip alteration k of planets; left out: keeps the clearance with the sun"
    )
    ring_tip_alteration: Ratio | None = Field(
        None, ge=-0.6, le=0.3, description="Tip alteration k of the ring; left out: 0"
    )
    sun_allowance: ThicknessFit | None = Field(
        None, description="Tooth thickness of the sun by DIN 3967; left out: gears.allowance"
    )
    planet_allowance: ThicknessFit | None = Field(
        None, description="Tooth thickness of planets by DIN 3967; left out: gears.allowance"
    )
    ring_allowance: ThicknessFit | None = Field(
        None, description="Tooth thickness of the ring by DIN 3967; left out: gears.allowance"
    )
    unequal_places: bool = Field(
        False, description="Planets stand at the places nearest to equal ones at which their teeth fit"
    )
    load_sharing: SharingLevel | None = Field(None, description=LEVELS)
    pin_position: Length | None = Field(None, ge=1e-7, le=1e-3, description=PINS)
    sun_bore: Length | None = Field(
        None, gt=0, description="Bore of the sun, or inside of its rim, for K_V; left out: solid, as on its own shaft"
    )
    planet_bore: Length | None = Field(
        None,
        gt=0,
        description="Bore of planets, or inside of their rim, for K_V; left out: 0.66 of the pitch diameter, but a rim"
        " of gears.rim_ratio, or of 1.2 tooth heights at the least",
    )
    sun_mass: Mass | None = Field(None, gt=0, description="Of the sun; left out: of the disc")
    sun_inertia: Inertia | None = Field(None, gt=0, description="Of the sun; left out: of the disc")
    planet_mass: Mass | None = Field(None, gt=0, description="Of one planet; left out: of the disc")
    planet_inertia: Inertia | None = Field(None, gt=0, description="Of one planet; left out: of the disc")
    ring_mass: Mass | None = Field(None, gt=0, description="Of the ring; left out: of its wall")
    ring_inertia: Inertia | None = Field(None, gt=0, description="Of the ring; left out: of its wall")
    pin_diameter: Length | None = Field(None, gt=0, description="Of the planets' pins; left out: sized")
    plate_thickness: Length | None = Field(None, gt=0, description="Of the carrier's plate; left out: sized")
    eye_wall: Length | None = Field(
        None, gt=0, description="Metal of the carrier's plates outside its pins; left out: sized"
    )
    carrier_mass: Mass | None = Field(None, gt=0, description="Of pins and plate; left out: computed")
    carrier_inertia: Inertia | None = Field(None, gt=0, description="Of pins and plate; left out: computed")
    bearings: PlanetaryBearings = Field(
        default_factory=PlanetaryBearings, description="What holds its members, with dynamics.fidelity translational"
    )
    planet_bearing: PlanetBearing | None = Field(
        None,
        description="What each planet turns on; left out: of the catalogue at level preliminary, else not known",
    )
    gears: GearRules | None = Field(None, description="Rules of this set where they differ from [gears]")

    @property
    def members(self) -> tuple[str, str, str]:
        """Shafts of sun, ring and carrier."""
        return self.sun, self.ring, self.carrier

    @property
    def planets(self) -> int:
        """Number of planets; until it is chosen, that with which speeds and torques are found."""
        return self.planets_given or NOMINAL_PLANETS

    @property
    def known_teeth(self) -> tuple[int, int, int] | None:
        """Teeth of sun, planet and ring where two of them are given, so that the third closes without shift."""
        sun, planet, ring = self.sun_teeth, self.planet_teeth, self.ring_teeth
        if planet is None and sun is not None and ring is not None and (ring - sun) % 2 == 0:
            planet = (ring - sun) // 2
        if sun is None and planet is not None and ring is not None:
            sun = ring - 2 * planet
        if sun is None or planet is None:
            return None
        return sun, planet, ring if ring is not None else sun + 2 * planet

    @property
    def meshes(self) -> tuple[str, ...]:
        """Kinds of its meshes, as methods of rating cover them: of sun and planet, and of planet and ring."""
        return CYLINDRICAL, INTERNAL


class Clutch(Record):
    """A clutch that joins two shafts when it is engaged."""

    driving: str = Field(description="Shaft that drives")
    driven: str = Field(description="Shaft that is driven")
    kind: Literal["overrunning", "engaged", "open"] = Field(
        "overrunning", description="overrunning transmits only from driving to driven and opens otherwise"
    )


class Damper(Record):
    """A viscous damper between two shafts: it gives the driven one a torque of c times the speed that it lags by."""

    driving: str = Field(description="Shaft at one end")
    driven: str = Field(description="Shaft at the other end")
    damping: TorsionalDamping = Field(gt=0.0, description="Torque over difference of speeds, c")


# ----------------------------------------------------------------------------------------------------------------------
# Compound epicyclic sets: one carrier, planets of several steps that may mesh with each other, any suns and rings.
# ----------------------------------------------------------------------------------------------------------------------


_TEETH = Field(ge=6, le=2000, description="Tooth number z")
_MODULE = Field(None, gt=0, le=0.1, description="Module m_n of this gear and of all that mesh with it; left out: sized")
_WIDTH = Field(None, gt=0, description="Face width b of the meshes of this gear and of its mates; left out: sized")
_SHIFT = Field(
    None, ge=-1.5, le=1.5, description="Profile shift x; left out: closes its meshes, balanced, or gears.profile_shift"
)
_TIP = Field(None, ge=-0.6, le=0.3, description="Tip alteration k; left out: keeps the tip clearance")
_ALLOWANCE = Field(None, description="Its tooth thickness by DIN 3967; left out: gears.allowance")
_BORE = Field(
    None,
    gt=0,
    description="Bore, or inside of the rim, for K_V; left out: suns solid, planets 0.66 of d",
)
_PLACE = Field(
    None, gt=0, le=10, description="Middle of its face along the axis, from the carrier's plate; left out: not known"
)
_MASS = Field(None, gt=0, description="Of one gear; left out: of the disc or of the ring's wall")
_INERTIA = Field(None, gt=0, description="Of one gear; left out: of the disc or of the ring's wall")


class CentralGear(Record):
    """A sun or a ring of a compound set."""

    shaft: Name = Field(description="Shaft that carries it, or ground")
    teeth: int = _TEETH
    module: Annotated[Length | None, PITCH, NORMAL_PITCH] = _MODULE
    face_width: Length | None = _WIDTH
    place: Length | None = _PLACE
    shift: Ratio | None = _SHIFT
    tip_alteration: Ratio | None = _TIP
    allowance: ThicknessFit | None = _ALLOWANCE
    bore: Length | None = _BORE
    mass: Mass | None = _MASS
    inertia: Inertia | None = _INERTIA


class PlanetGear(Record):
    """A planet of a compound set, or one step of a stepped planet."""

    teeth: int = _TEETH
    meshes: list[Name] = Field(
        default_factory=list, description="Suns, rings and other planets of the set that it meshes with"
    )
    in_one_piece_with: Name | None = Field(
        None, description="Planet of the set with which it turns as one piece: the steps of a stepped planet"
    )
    module: Annotated[Length | None, PITCH, NORMAL_PITCH] = _MODULE
    face_width: Length | None = _WIDTH
    place: Length | None = _PLACE
    centre_distance: Length | None = Field(
        None,
        gt=0,
        description="Working distance of its pin from the set's axis, of all its meshes with suns and rings; the shifts"
        " follow; left out: they give it",
    )
    shift: Ratio | None = _SHIFT
    tip_alteration: Ratio | None = _TIP
    allowance: ThicknessFit | None = _ALLOWANCE
    bore: Length | None = _BORE
    mass: Mass | None = _MASS
    inertia: Inertia | None = _INERTIA
    bearing: PlanetBearing | None = Field(
        None, description="What this planet, or this step, turns on; left out: not known"
    )


class Epicyclic(Record):
    """A compound epicyclic set: suns, rings and planets on one carrier; several members may have one shaft."""

    carrier: Name = Field(description="Shaft of the carrier, or ground")
    sets: int = Field(3, ge=1, le=12, description="Equal sets of planets, evenly spaced around the carrier")
    suns: dict[str, CentralGear] = Field(default_factory=dict, description="Suns by name")
    rings: dict[str, CentralGear] = Field(default_factory=dict, description="Rings by name")
    planets: dict[str, PlanetGear] = Field(
        default_factory=dict, description="Planets of one set, and the steps of stepped ones, by name"
    )
    backlash: Length = Field(
        0.0, ge=0, le=0.01, description="Of each mesh, along the line of action; 0: contact both ways"
    )
    mesh_efficiencies: dict[str, Ratio] = Field(
        default_factory=dict,
        description='Efficiency of single meshes, by name: "sun-planet" = 0.99; left out: gears.mesh_efficiency',
    )
    load_sharing: SharingLevel | None = Field(None, description=LEVELS)
    pin_position: Length | None = Field(None, ge=1e-7, le=1e-3, description=PINS)
    pin_diameter: Length | None = Field(None, gt=0, description="Of the planets' pins; left out: sized")
    plate_thickness: Length | None = Field(None, gt=0, description="Of the carrier's plate; left out: sized")
    eye_wall: Length | None = Field(
        None, gt=0, description="Metal of the carrier's plates outside its pins; left out: sized"
    )
    carrier_mass: Mass | None = Field(None, gt=0, description="Of pins and plate; left out: computed")
    carrier_inertia: Inertia | None = Field(None, gt=0, description="Of pins and plate; left out: computed")
    gears: GearRules | None = Field(None, description="Rules of this set where they differ from [gears]")

    @property
    def centrals(self) -> dict[str, CentralGear]:
        """Every sun and ring by name."""
        return {**self.suns, **self.rings}

    @property
    def toothed(self) -> dict[str, CentralGear | PlanetGear]:
        """Every gear by name."""
        return {**self.suns, **self.rings, **self.planets}

    @property
    def members(self) -> tuple[str, ...]:
        """Shafts of its suns, rings and carrier."""
        return (*(gear.shaft for gear in self.centrals.values()), self.carrier)

    @property
    def meshes(self) -> tuple[str, ...]:
        """Kinds of its meshes, as methods of rating cover them."""
        return (CYLINDRICAL, INTERNAL) if self.rings else (CYLINDRICAL,)

    @property
    def mesh_pairs(self) -> tuple[tuple[str, str], ...]:
        """Every mesh once, as the names of its gears: a sun, or a planet and a ring, or two planets."""
        pairs: dict[frozenset[str], tuple[str, str]] = {}
        for planet, gear in self.planets.items():
            for mate in gear.meshes:
                order = (mate, planet) if mate in self.suns else (planet, mate)
                pairs.setdefault(frozenset(order), order)
        return tuple(pairs.values())

    @property
    def compound(self) -> CompoundSet:
        """Its gears and meshes as geometry takes them: rings count with negative tooth numbers."""
        return CompoundSet(
            self.sets,
            {name: -gear.teeth if name in self.rings else gear.teeth for name, gear in self.centrals.items()},
            {name: gear.teeth for name, gear in self.planets.items()},
            {name: self.body(name) for name in self.planets},
            self.mesh_pairs,
            {name: self.group(name) for name in self.toothed},
            places={name: gear.place for name, gear in self.toothed.items() if gear.place is not None},
            widths={name: width for name in self.toothed if (width := self.width(name)) is not None},
        )

    def width(self, gear: str) -> float | None:
        """Return the face width that is given for a gear or for one that teeth join to it [m].

        Args:
            gear: One of its gears.
        """
        joined = _joined(gear, self.mesh_pairs) & self.toothed.keys()
        return next((width for name in joined if (width := self.toothed[name].face_width) is not None), None)

    def module(self, gear: str) -> float | None:
        """Return the module that is given for a gear or for one that teeth join to it [m].

        Args:
            gear: One of its gears.
        """
        joined = _joined(gear, self.mesh_pairs) & self.toothed.keys()
        return next((module for name in joined if (module := self.toothed[name].module) is not None), None)

    def group(self, gear: str) -> str:
        """Return the first of all gears that teeth join to one, or nothing where teeth join all.

        Args:
            gear: One of its gears.
        """
        joined = _joined(gear, self.mesh_pairs)
        return "" if len(joined) == len(self.toothed) else next(name for name in self.toothed if name in joined)

    def body(self, planet: str) -> str:
        """Return the first planet of the piece that one belongs to.

        Args:
            planet: One of its planets.
        """
        seen = [planet]
        while (following := self.planets[seen[-1]].in_one_piece_with) in self.planets and following not in seen:
            seen.append(following or "")
        return seen[-1]


def _joined(gear: str, pairs: tuple[tuple[str, str], ...]) -> set[str]:
    """Return a gear and all that mesh with it, directly or through others."""
    joined = {gear}
    while more := {name for pair in pairs if joined & set(pair) for name in pair} - joined:
        joined |= more
    return joined
