"""The housing and the oil system, as far as the mass of the gearbox needs them."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from gearwright.spec.record import Record
from gearwright.units import Length, Mass, Ratio, Time

HousingMaterial = Literal["aluminium", "magnesium", "composite", "cast-iron"]
"""What housings are made of."""


class HousingRules(Record):
    """What the housing is made of, and which of it and of the oil system belongs to the gearbox."""

    material: HousingMaterial = Field("aluminium", description="Of the housing: castings, or a laminate")
    wall: Length | None = Field(
        None, gt=0, le=0.2, description="Wall; left out: as torque and bearings ask, at least what can be cast"
    )
    mass: Mass | None = Field(
        None, gt=0, description="Of the housing, as weighed; left out: shell, ribs, flanges, bosses"
    )
    own: bool = Field(True, description="False: what stands around it holds the gears, and is no part of the gearbox")
    oil_system: Literal["own", "splash", "shared"] = Field(
        "own", description="own: pump, filter and cooler; splash: oil alone; shared: the engine's, none in the gearbox"
    )
    accessory_drives: int = Field(
        0, ge=0, le=20, description="Pads with a gear for accessories that the design does not have"
    )
    oil_dwell: Time = Field(15.0, gt=0, le=3600, description="How long oil rests in the tank between two rounds")
    oil_temperature_rise: Ratio = Field(
        40.0, gt=0, le=200, description="Of the oil from inlet to outlet [K]; with the losses it gives the flow"
    )
