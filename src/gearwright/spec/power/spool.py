"""The gas generator of a turbine as a mission's user describes it."""

from __future__ import annotations

from pydantic import Field

from gearwright.spec.record import Record
from gearwright.units import Inertia, Ratio, Speed, Time


class SpoolRules(Record):
    """The gas generator of the turbines, which speeds up before power comes; power slams in windows follow it."""

    pressure_ratio: float = Field(ge=3, le=40, description="p_3/p_2 at thermal power at sea level")
    speed: Speed = Field(gt=100, le=1e4, description="N1 there")
    inertia: Inertia = Field(gt=0, le=100, description="Of the gas generator")
    compressor: Ratio = Field(0.81, gt=0.5, lt=1, description="Isentropic efficiency of the compressor; an assumption")
    turbine: Ratio = Field(0.86, gt=0.5, lt=1, description="Of the turbine that drives it; an assumption")
    acceleration: Ratio = Field(
        1.0,
        ge=0.6,
        le=2,
        description="Most fuel over p_3, over that at thermal power: keeps it from surge",
    )
    deceleration: Ratio = Field(0.3, ge=0.05, le=0.6, description="Least of it: keeps the fire")
    valve: Time = Field(0.05, gt=0, le=10, description="Time constant of the fuel's metering valve")
