"""The helicopter of a mission: a mass under a rotor that drags a fuselage, and a tail rotor that holds it straight."""

from __future__ import annotations

from pydantic import Field

from gearwright.spec.record import Record
from gearwright.units import Area, Length, Mass, Ratio, Speed


class TailRotor(Record):
    """The tail rotor, and what drives it."""

    machine: str = Field(description="Rotor or load of the design that it is, such as tail-drive")
    diameter: Length = Field(gt=0, le=50, description="Diameter")
    speed: Speed = Field(gt=0.1, le=2e4, description="With the main rotor at the speed of the first phase")
    arm: Length = Field(gt=0, le=100, description="From the mast to its shaft")
    solidity: Ratio = Field(gt=0, le=1, description="Area of the blades over that of the disc")
    profile_drag: Ratio = Field(0.012, gt=0, le=0.1, description="c_d0 of its blades; an assumption")
    induced_factor: float = Field(
        1.25, ge=0.5, le=3, description="κ; about 0.85 in a duct, whose disc moves twice the air; assumptions"
    )


class Rotorcraft(Record):
    """A helicopter, where phases leave their power to the trim of its rotors."""

    mass: Mass = Field(gt=0, le=1e6, description="At the start; fuel that burns is taken off")
    flat_plate_area: Area = Field(gt=0, le=100, description="f: drag of the fuselage over the dynamic pressure")
    solidity: Ratio = Field(gt=0, le=1, description="Of the main rotor: area of the blades over that of the disc")
    profile_drag: Ratio = Field(0.010, gt=0, le=0.1, description="c_d0 of its blades; an assumption")
    induced_factor: float = Field(1.15, ge=1, le=3, description="κ over the ideal induced power; an assumption")
    download: Ratio = Field(0.03, ge=0, le=0.5, description="Of the wake on the fuselage in hover, over the weight")
    highest_loading: Ratio = Field(0.12, gt=0, le=0.3, description="C_T/σ at which blades stall; an assumption")
    tail: TailRotor | None = Field(None, description="Left out: what the design's case says it takes")
