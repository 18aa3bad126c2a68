"""What a transmission must live through, and how gears are rated for it where Lewis and Hertz are not enough."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from gearwright.spec.record import Record
from gearwright.units import Length, Ratio, Time

_HOUR = 3600.0


class Iso6336Rules(Record):
    """How gears are made, of what, and which safeties they owe: ISO 6336 for cylindrical, ISO 10300 for bevel gears."""

    steel: str | None = Field(None, description="Class in the table of ISO 6336-5; left out: that of the material")
    grade: Literal["ML", "MQ", "ME"] | None = Field(
        None, description="Material quality of ISO 6336-5; left out: that of the material, MQ for another class"
    )
    hardness_hv: float | None = Field(
        None, ge=100, le=1000, description="Surface hardness; left out: that of the material, 700 for another class"
    )
    pitting_safety: Ratio = Field(1.2, ge=1, le=5, description="Least safety against pitting S_Hmin")
    bending_safety: Ratio = Field(1.6, ge=1, le=5, description="Least safety against tooth root fracture S_Fmin")
    scuffing_safety: Ratio = Field(1.5, ge=1, le=5, description="Least safety against scuffing S_Smin (ISO/TS 6336-21)")
    tolerance_class: int = Field(5, ge=1, le=11, description="Flank tolerance class of ISO 1328-1 or ISO 17485")
    helix_modification: Literal["none", "crowning", "corrected"] = Field(
        "corrected", description="Lead of cylindrical gears: as cut, crowned, or corrected for the shafts' deflection"
    )
    flank_roughness: Length = Field(4e-6, ge=1e-8, le=1e-4, description="Mean R_z of the flanks")
    root_roughness: Length = Field(10e-6, ge=1e-8, le=1e-3, description="R_z of the root fillets")
    oil_viscosity: float = Field(25.0, ge=5, le=1000, description="ν_40 of the oil [mm²/s]")
    oil_temperature: float = Field(90.0, ge=-40, le=200, description="Temperature of the oil [°C], for scuffing")
    scuffing_stage: int = Field(10, ge=1, le=14, description="FZG load stage of the oil (A/8.3/90), for scuffing")
    mounting: Literal["straddle", "one-overhung", "both-overhung"] = Field(
        "one-overhung", description="How the gears of a bevel pair are held (ISO 10300-1, K_Hβ-be)"
    )
    widest_diameters: Ratio = Field(0.8, gt=0, le=3, description="Largest face width over the pinion's pitch diameter")
    widest_modules: Ratio = Field(20.0, gt=1, le=60, description="Largest face width over the normal module")
    standard_modules: bool = Field(True, description="Take modules from series I and II of ISO 54")


class Service(Record):
    """The life that is asked, and the loads in it."""

    life: Time = Field(3500 * _HOUR, gt=0, description="Life of gears")
    bearing_life: Time = Field(5000 * _HOUR, gt=0, description="Least basic rating life L_10h of each bearing")
    application_factor: Ratio = Field(1.25, ge=1, le=5, description="K_A: what the outside adds to the nominal load")
    shares: dict[str, Ratio] = Field(
        default_factory=dict,
        description="Share of the life that each case lasts, with sum 1; left out: all of it at rated power",
    )
    mean_load: Ratio = Field(
        1.0,
        gt=0,
        le=1,
        description="Cubic mean load over the rated one, for bearings; with shares it follows from them",
    )
    static_safety: Ratio = Field(1.5, ge=0.5, le=5, description="Least static safety s_0 of bearings (ISO 76)")
    shaft_fatigue_safety: Ratio = Field(1.5, ge=1, le=5, description="Least safety of shafts against fatigue")
    shaft_yield_safety: Ratio = Field(1.5, ge=1, le=5, description="Least safety of shafts against yield")
    torque_swing: Ratio = Field(0.15, ge=0, le=1, description="Alternating part of the torque over its mean")
