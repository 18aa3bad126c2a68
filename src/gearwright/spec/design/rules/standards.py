"""How gears are rated by standards where Lewis and Hertz are not enough: how made, of what, which safeties they owe."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from gearwright.spec.design.rules.bearings import OIL_TEMPERATURE, VISCOSITY_40
from gearwright.spec.record import Record
from gearwright.units import Length, Ratio, Stress


class RingCutter(Record):
    """The pinion-shaped cutter that cuts the rings of a stage."""

    teeth: int = Field(ge=5, le=400, description="Teeth of the cutter z_0, fewer than the ring's")
    shift: float = Field(0.0, ge=-1, le=1, description="Profile shift of the cutter x_0; 0 where it is half worn")
    tip_radius: float = Field(0.25, ge=0, le=0.6, description="Radius of its tip over the module ρ_a0*")


_HARDNESS = (
    "Surface hardness, in HBW of structural steel and cast irons; left out: that of the material, 700 for another class"
    " that is so hard"
)


class WheelSteel(Record):
    """The steel of wheels and rings where it is another than that of pinions, suns and planets."""

    steel: str = Field(description="Class in the table of ISO 6336-5")
    grade: Literal["ML", "MQ", "ME"] = Field("MQ", description="Material quality of ISO 6336-5")
    hardness_hv: float | None = Field(None, ge=100, le=1000, description=_HARDNESS)
    yield_strength: Stress | None = Field(
        None, ge=5e7, le=4e9, description="R_p0.2 of its core; left out: that of the material"
    )


class Iso6336Rules(Record):
    """How gears are made, of what, and which safeties they owe: ISO 6336 for cylindrical, ISO 10300 for bevel gears."""

    steel: str | None = Field(None, description="Class in the table of ISO 6336-5; left out: that of the material")
    grade: Literal["ML", "MQ", "ME"] | None = Field(
        None, description="Material quality of ISO 6336-5; left out: that of the material, MQ for another class"
    )
    hardness_hv: float | None = Field(None, ge=100, le=1000, description=_HARDNESS)
    pitting_safety: Ratio = Field(1.2, ge=1, le=5, description="Minimum safety against pitting S_Hmin")
    bending_safety: Ratio = Field(1.6, ge=1, le=5, description="Minimum safety against tooth root fracture S_Fmin")
    scuffing_safety: Ratio = Field(
        1.5, ge=1, le=5, description="Minimum safety against scuffing S_Smin (ISO/TS 6336-21)"
    )
    static_pitting_safety: Ratio = Field(
        1.0, ge=1, le=5, description="Minimum S_H of cylindrical gears against static cases, static strength"
    )
    static_bending_safety: Ratio = Field(
        1.4, ge=1, le=5, description="Minimum S_F of cylindrical gears against static cases, static strength"
    )
    yielding_safety: Ratio = Field(
        1.0, ge=1, le=5, description="Minimum R_p0.2 over the nominal root stress of static cases"
    )
    wheel: WheelSteel | None = Field(None, description="Steel of wheels and rings where it is another")
    dynamic_method: Literal["B", "C"] = Field(
        "B", description="K_V of cylindrical gears: B by resonance and deviations, C by v z_1 and class"
    )
    least_dynamic_factor: Ratio = Field(
        1.0,
        ge=1,
        le=5,
        description="Least K_V of cylindrical gears, by a forced response or a measurement",
    )
    root_method: Literal["B", "C"] = Field(
        "B", description="Y_F, Y_S of external gears: B loaded at the outer single contact, C at the tip, with Y_ε"
    )
    face_method: Literal["B", "C"] = Field(
        "C", description="K_Hβ of cylindrical gears: C alone, or B, held against the bending lines of built shafts, too"
    )
    reliability: Ratio = Field(
        0.99, ge=0.5, le=0.9999, description="Part of the gears that survive: σ_lim over K_R of AGMA 2001, table 11"
    )
    some_pitting: bool = Field(
        False, description="A little pitting may be left on flanks that are not nitrided: Z_NT by the upper curve"
    )
    life_factor_1e10: Ratio = Field(
        0.85,
        ge=0.85,
        le=1,
        description="Z_NT and Y_NT at 1e10 cycles; beyond, the line goes on; 1, a flat line that bears loads without"
        " end, asks for the best quality and experience",
    )
    tolerance_class: int | None = Field(
        None,
        ge=1,
        le=11,
        description="Flank tolerance class of ISO 1328-1 or ISO 17485; left out: by pitch-line velocity 4 above 60 m/s,"
        " 5 from 15 m/s on, 6 below; 5 for bevel gears",
    )
    helix_modification: Literal["none", "crowning", "corrected"] = Field(
        "corrected", description="Lead of cylindrical gears: as cut, crowned, or corrected for the shafts' deflection"
    )
    flank_roughness: Length = Field(4e-6, ge=1e-8, le=1e-4, description="Mean R_z of the flanks")
    root_roughness: Length = Field(10e-6, ge=1e-8, le=1e-3, description="R_z of the root fillets")
    tip_relief: Length | None = Field(
        None,
        ge=0,
        le=5e-4,
        description="Tip relief C_a of both gears of cylindrical meshes; left out: by tip_relief_for",
    )
    tip_relief_for: Literal["load", "run-in"] = Field(
        "load",
        description="What an open tip relief makes up for: load, the deflection in the case that does most damage, 0.02"
        " m_n at most; run-in, nothing but what running in leaves",
    )
    tip_relief_tolerance: Length | None = Field(
        None,
        ge=0,
        le=1e-4,
        description="By how much C_a may miss; left out: ±3 µm or ±15 % where C_a is open, 0 where it is given",
    )
    blank_factor: Ratio = Field(
        1.0, ge=0.5, le=1.1, description="Gear blank factor C_R of the mesh stiffness; 1 is a solid or bored gear"
    )
    ring_cutter: RingCutter | None = Field(
        None,
        description="Shaper cutter of the rings, for their fillets; left out: as by a rack of ISO 53, profile A",
    )
    oil_viscosity: float = Field(
        VISCOSITY_40, ge=5, le=1000, description="ν_40 of the oil [mm²/s]; left out: that of [oil]"
    )
    oil_viscosity_100: float | None = Field(
        None,
        ge=1,
        le=100,
        description="ν_100 of the oil [mm²/s]; left out: that of [oil], or it thins as a turbine oil does",
    )
    oil_temperature: float = Field(
        OIL_TEMPERATURE,
        ge=-40,
        le=200,
        description="Of the oil [°C], for scuffing; left out: that of [oil]",
    )
    oil_type: Literal[
        "mineral", "polyalphaolefin", "polyglycol", "water-soluble polyglycol", "phosphate ester", "traction"
    ] = Field("mineral", description="Base of the oil, for friction (X_L) and pressure viscosity")
    scuffing_method: Literal["integral", "flash", "both"] = Field(
        "integral", description="Temperature that the asked safety is against; both are always shown"
    )
    micropitting_stage: float | None = Field(
        None, ge=5, le=10, description="Load stage of the oil in FZG C-GF/8.3/90 (FVA 54/7); left out: not assessed"
    )
    micropitting_safety: Ratio = Field(1.0, ge=0.5, le=10, description="Minimum S_λ (ISO/TS 6336-22)")
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


class AgmaWheelSteel(Record):
    """The steel of gears where it is another than that of their pinions."""

    steel: Literal["through-hardened", "carburised", "nitrided-4140"] = Field(
        "through-hardened", description="Steel with its row in tables 3 and 4"
    )
    grade: int = Field(2, ge=1, le=3, description="Metallurgical grade; through-hardened and nitrided steel: 1 or 2")
    hardness_hb: float = Field(
        300.0, ge=100, le=500, description="HB of a through-hardened gear, of the core of a nitrided one: 180 to 400"
    )


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
    wheel: AgmaWheelSteel | None = Field(None, description="Steel of wheels where it is another: C_H by both")
    flank_roughness: Length = Field(0.5e-6, ge=1e-8, le=1e-5, description="R_a of pinions' flanks, for C_H")
    yielding_safety: Ratio = Field(1.0, ge=1, le=5, description="Minimum safety against yielding in static cases")
    yield_factor: Ratio = Field(0.75, ge=0.5, le=1, description="K_y: 0.75 for industrial, 0.5 for conservative use")
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
