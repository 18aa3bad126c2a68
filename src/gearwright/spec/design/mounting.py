"""What holds a shaft in its housing and what holds its gears on it: bearing seats, and joints of shaft and hub."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from gearwright.spec.record import Record
from gearwright.units import Force, Length, Ratio, Stress, Time

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
