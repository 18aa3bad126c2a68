"""How gears are rated by standards where Lewis and Hertz are not enough: how made, of what, which safeties they owe."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from gearwright.spec.record import Record
from gearwright.units import Length, Ratio


class RingCutter(Record):
    """The pinion-shaped cutter that cuts the rings of a stage."""

    teeth: int = Field(ge=5, le=400, description="Teeth of the cutter z_0, fewer than the ring's")
    shift: float = Field(0.0, ge=-1, le=1, description="Profile shift of the cutter x_0; 0 where it is half worn")
    tip_radius: float = Field(0.25, ge=0, le=0.6, description="Radius of its tip over the module ρ_a0*")


class Iso6336Rules(Record):
    """How gears are made, of what, and which safeties they owe: ISO 6336 for cylindrical, ISO 10300 for bevel gears."""

    steel: str | None = Field(None, description="Class in the table of ISO 6336-5; left out: that of the material")
    grade: Literal["ML", "MQ", "ME"] | None = Field(
        None, description="Material quality of ISO 6336-5; left out: that of the material, MQ for another class"
    )
    hardness_hv: float | None = Field(
        None, ge=100, le=1000, description="Surface hardness; left out: that of the material, 700 for another class"
    )
    pitting_safety: Ratio = Field(1.2, ge=1, le=5, description="Minimum safety against pitting S_Hmin")
    bending_safety: Ratio = Field(1.6, ge=1, le=5, description="Minimum safety against tooth root fracture S_Fmin")
    scuffing_safety: Ratio = Field(
        1.5, ge=1, le=5, description="Minimum safety against scuffing S_Smin (ISO/TS 6336-21)"
    )
    tolerance_class: int = Field(5, ge=1, le=11, description="Flank tolerance class of ISO 1328-1 or ISO 17485")
    helix_modification: Literal["none", "crowning", "corrected"] = Field(
        "corrected", description="Lead of cylindrical gears: as cut, crowned, or corrected for the shafts' deflection"
    )
    flank_roughness: Length = Field(4e-6, ge=1e-8, le=1e-4, description="Mean R_z of the flanks")
    root_roughness: Length = Field(10e-6, ge=1e-8, le=1e-3, description="R_z of the root fillets")
    tip_relief: Length = Field(
        0.0, ge=0, le=5e-4, description="Tip relief C_a of both gears of cylindrical pairs, for K_V and scuffing"
    )
    ring_cutter: RingCutter | None = Field(
        None,
        description="Shaper cutter of the rings, for their fillets; left out: as by a rack of ISO 53, profile A",
    )
    oil_viscosity: float = Field(25.0, ge=5, le=1000, description="ν_40 of the oil [mm²/s]")
    oil_temperature: float = Field(90.0, ge=-40, le=200, description="Temperature of the oil [°C], for scuffing")
    scuffing_stage: int = Field(10, ge=1, le=14, description="FZG load stage of the oil (A/8.3/90), for scuffing")
    profile_crowning: Literal["high", "low"] = Field(
        "high", description="How much bevel flanks are crowned: e_LS = 1.5 or 3 (ISO 10300-2, table 5)"
    )
    mounting: Literal["straddle", "one-overhung", "both-overhung"] = Field(
        "one-overhung", description="How the gears of a bevel pair are held (ISO 10300-1, K_Hβ-be)"
    )
    widest_diameters: Ratio = Field(0.8, gt=0, le=3, description="Largest face width over the pinion's pitch diameter")
    widest_modules: Ratio = Field(20.0, gt=1, le=60, description="Largest face width over the normal module")
    standard_modules: bool = Field(True, description="Take modules from series I and II of ISO 54")


class Agma2001Rules(Record):
    """How gears are made, of what, and which safeties they owe: AGMA 2001-D04, K_o from service.application_factor."""

    steel: Literal["through-hardened", "carburised", "nitrided-4140"] = Field(
        "carburised", description="Steel with its row in tables 3 and 4"
    )
    grade: int = Field(2, ge=1, le=3, description="Metallurgical grade; through-hardened and nitrided steel: 1 or 2")
    hardness_hb: float = Field(
        300.0, ge=100, le=500, description="HB of through-hardened gears, of the core of nitrided ones: 180 to 400"
    )
    pitting_safety: Ratio = Field(1.2, ge=1, le=5, description="Minimum safety against pitting S_H, as with ISO 6336")
    bending_safety: Ratio = Field(1.6, ge=1, le=5, description="Minimum safety against bending S_F, as with ISO 6336")
    quality_number: int = Field(11, ge=5, le=11, description="Transmission accuracy Q_v, for the dynamic factor K_v")
    reliability: Ratio = Field(0.99, ge=0.5, le=0.9999, description="Part of the gears that survive, for K_R")
    temperature_factor: Ratio = Field(1.0, ge=1, le=2, description="K_T; 1 for blanks up to 120 °C")
    enclosure: Literal["open", "commercial", "precision", "extra-precision"] = Field(
        "precision", description="Housing, for the mesh alignment C_ma in K_m"
    )
    crowned: bool = Field(True, description="Leads are crowned or corrected: C_mc = 0.8 in K_m")
    adjusted: bool = Field(False, description="Aligned at assembly or lapped: C_e = 0.8 in K_m")
    widest_diameters: Ratio = Field(0.8, gt=0, le=3, description="Largest face width over the pinion's pitch diameter")
    widest_modules: Ratio = Field(20.0, gt=1, le=60, description="Largest face width over the normal module")
    standard_modules: bool = Field(True, description="Take modules from series I and II of ISO 54")


class Agma2003Rules(Record):
    """How bevel gears are made, of what, which safeties they owe: AGMA 2003, K_o from service.application_factor."""

    edition: Literal["D19", "B97"] = Field(
        "D19", description="Whose size factor C_s: constant from 79.8 mm (D19) or from 4.5 in (B97)"
    )
    steel: Literal["through-hardened", "carburised", "nitrided-4140", "nitralloy-135m"] = Field(
        "carburised", description="Steel with its row in tables 3 and 5"
    )
    grade: int = Field(
        2, ge=1, le=3, description="Metallurgical grade; through-hardened steel: 1 or 2, nitrided ones: 2"
    )
    hardness_hb: float = Field(300.0, ge=100, le=500, description="HB of a through-hardened pinion, 180 to 400")
    wheel_hardness_hb: float | None = Field(
        None, ge=100, le=500, description="HB of a softer through-hardened wheel, for C_H; left out: as the pinion's"
    )
    pitting_safety: Ratio = Field(1.2, ge=1, le=5, description="Minimum safety against pitting S_H, as with ISO 10300")
    bending_safety: Ratio = Field(1.6, ge=1, le=5, description="Minimum safety against bending S_F, as with ISO 10300")
    quality_number: int = Field(11, ge=5, le=11, description="Transmission accuracy Q_v, for the dynamic factor K_v")
    reliability: Ratio = Field(0.99, ge=0.5, le=0.9999, description="Part of the gears that survive, for K_R and C_R")
    blank_temperature: float = Field(
        80.0, ge=-40, le=200, description="Temperature of the gear blanks [°C]; K_T = 1 up to 250 °F"
    )
    critical_service: bool = Field(False, description="K_L beyond 3e6 cycles by the lower edge of its band")
    mounting: Literal["straddle", "one-overhung", "both-overhung"] = Field(
        "one-overhung", description="How the two gears are held: K_mb = 1, 1.1 or 1.25"
    )
    crowned: bool = Field(True, description="Properly crowned teeth: C_xc = 1.5, otherwise 2")
    widest_diameters: Ratio = Field(
        0.8, gt=0, le=3, description="Of cylindrical stages; bevel faces keep to R_e/3 and 10 m_et"
    )
    widest_modules: Ratio = Field(20.0, gt=1, le=60, description="Likewise")
    standard_modules: bool = Field(True, description="Take modules from series I and II of ISO 54")
