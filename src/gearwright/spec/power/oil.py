"""What warms up in the gearbox: oil, gears, bearings and housing, and how long it runs without oil."""

from __future__ import annotations

from pydantic import Field

from gearwright.spec.record import Record
from gearwright.units import Mass, Ratio


class OilNetworkRules(Record):
    """Temperatures of oil, gears, bearings and housing through a flight, in place of a stated oil temperature."""

    oil_mass: Mass = Field(gt=0, le=1e4, description="Of the oil in sump, gearbox and cooler")
    housing_mass: Mass = Field(gt=0, le=1e5, description="Of the housing")
    bearing_mass: Mass = Field(gt=0, le=1e4, description="Of all bearings")
    oil_heat_j_kg_k: float = Field(2000.0, ge=500, le=5000, description="Heat capacity of the oil")
    housing_heat_j_kg_k: float = Field(900.0, ge=100, le=5000, description="Of the housing; 900 for aluminium")
    steel_heat_j_kg_k: float = Field(470.0, ge=100, le=5000, description="Of gears, shafts and bearings")
    gears_to_oil_w_k: float = Field(gt=0, le=1e6, description="From gears to the oil that cools them")
    bearings_to_oil_w_k: float = Field(gt=0, le=1e6, description="From bearings to the oil")
    bearings_to_housing_w_k: float = Field(20.0, ge=0, le=1e6, description="From bearings to the housing")
    gears_to_housing_w_k: float = Field(2.0, ge=0, le=1e6, description="From gears, by air and radiation")
    oil_to_housing_w_k: float = Field(50.0, ge=0, le=1e6, description="From the oil to the housing")
    housing_to_air_w_k: float = Field(15.0, ge=0, le=1e6, description="From the housing to the air")
    cooler_w_k: float = Field(ge=0, le=1e6, description="From the oil to the air, with the cooler's valve open")
    cooler_opens_k: float = Field(343.15, ge=200, le=450, description="Of the oil, where the cooler's valve opens")
    cooler_range_k: float = Field(10.0, gt=0, le=200, description="Above that, until it is open")
    oil_share: Ratio = Field(
        0.5, ge=0, le=1, description="Part of the heat of meshes and bearings that oil takes at once"
    )
    start_temperature_k: float | None = Field(
        None, ge=190, le=450, description="Of everything at the start; left out: oil.inlet_temperature_k"
    )
    highest_oil_k: float = Field(413.15, ge=250, le=700, description="Of the oil, where a flight ends")
    highest_gears_k: float = Field(
        523.15, ge=250, le=1500, description="Of the gears, where a flight or dry running ends"
    )
    highest_bearings_k: float = Field(
        473.15, ge=250, le=1500, description="Of the bearings, where a flight or dry running ends"
    )
    dry_friction: float = Field(
        3.0, ge=1, le=100, description="Losses of meshes and bearings without oil over those with"
    )
    dry_from: str | None = Field(None, description="Phase at whose end the oil is lost, to see how long it then runs")
