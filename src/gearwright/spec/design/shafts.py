"""Shafts and carriers: sizing rules, specified dimensions, bearing seats and shaft-hub joints."""

from __future__ import annotations

import math
from types import MappingProxyType
from typing import Literal

from pydantic import Field

from gearwright.base import Angle, Force, Inertia, Length, Mass, Ratio, Stiffness, Stress, Time, TorsionalStiffness
from gearwright.spec.record import Record

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
