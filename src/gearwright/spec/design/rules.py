"""Rules of rating, proportioning and modelling: gears, bearings, materials, tolerances, losses and housing.

What is rated stands in the design itself; what a method covers in `methods`.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import Annotated, Literal

from pydantic import Field

from gearwright.base import Angle, Density, Frequency, Length, Mass, Ratio, Stiffness, Stress, Time
from gearwright.catalogue import CENTRE_FITS, THICKNESS_FITS
from gearwright.parts.bearings import Lubrication
from gearwright.parts.losses import TURBINE_OIL
from gearwright.spec.record import OneOf, Record

# ----------------------------------------------------------------------------------------------------------------------
# Methods by which gears are rated, as design files name them: what each covers, and which rules it alone reads.
#
# Who computes by them is `sizing.rating.context`, which has a method for each of these names.
# ----------------------------------------------------------------------------------------------------------------------


CYLINDRICAL, INTERNAL, FACE, BEVEL = "cylindrical", "internal", "face", "bevel"
"""Kinds of meshes: external cylindrical gears, a pinion in a ring, a pinion on a face gear, bevel gears."""


@dataclass(frozen=True)
class RatingMethod:
    """What a file may expect of a method."""

    title: str
    """As people call it."""
    covers: frozenset[str]
    """Kinds of meshes that it rates."""
    reads: tuple[str, ...]
    """Rules of [gears] that not every method reads."""
    needs: tuple[str, ...] = ()
    """Properties that the material of its gears must have."""
    table: str = ""
    """Table of rules under [gears] in which its safeties stand; empty where they stand in [gears] itself."""
    instead: Mapping[str, str] = field(default_factory=dict)
    """Kind of mesh -> sister standard that rates it."""
    fatigue: bool = True
    """Whether its safeties are against fatigue, over the load cycles of the life."""


_ISO6336 = RatingMethod(
    "ISO 6336",
    frozenset({CYLINDRICAL, INTERNAL, FACE}),
    ("iso6336", "rim_ratio"),
    table="iso6336",
    instead={BEVEL: "iso10300"},
)
RATINGS: dict[str, RatingMethod] = {
    "lewis-hertz": RatingMethod(
        "Lewis and Hertz",
        frozenset({CYLINDRICAL, INTERNAL, FACE}),
        ("bending_safety", "contact_safety", "idler_factor", "contact_angles"),
        needs=("yield_strength", "surface_hardness"),
        fatigue=False,
    ),
    "iso6336": _ISO6336,
    "iso6336-2006": replace(_ISO6336, title="ISO 6336:2006"),
    "din3990": replace(_ISO6336, title="DIN 3990", covers=frozenset({CYLINDRICAL})),
    "iso10300": RatingMethod("ISO 10300", frozenset({BEVEL}), ("iso6336",), table="iso6336"),
    "agma2001": RatingMethod(
        "AGMA 2001",
        frozenset({CYLINDRICAL}),
        ("agma2001", "agma2003", "rim_ratio"),
        table="agma2001",
        instead={BEVEL: "agma2003"},
    ),
    "agma2003": RatingMethod("AGMA 2003", frozenset({BEVEL}), ("agma2003",), table="agma2003"),
}
"""Name in files -> method. The one place where the names stand."""


RatingName = Annotated[str, OneOf(RATINGS)]
"""Type of a field that names a method."""


def method_of(name: str, kinds: Iterable[str]) -> str:
    """Return the name of the method that rates a stage: the asked one, or its sister for these meshes.

    Args:
        name: As the rules of the stage ask.
        kinds: Of its meshes.
    """
    return next((RATINGS[name].instead[kind] for kind in kinds if kind in RATINGS[name].instead), name)


def uncovered(name: str, kinds: Iterable[str]) -> tuple[str, ...]:
    """Return the kinds of meshes of a stage that neither a method nor its sister rates.

    Args:
        name: As the rules of the stage ask.
        kinds: Of its meshes.
    """
    asked = tuple(kinds)
    return tuple(kind for kind in asked if kind not in RATINGS[method_of(name, asked)].covers)


# ----------------------------------------------------------------------------------------------------------------------
# How rolling bearings are judged: by which life, and by which limits of load and speed.
# ----------------------------------------------------------------------------------------------------------------------


Dirt = Literal[
    "extreme", "high", "normal", "slight", "typical", "severe", "beta-6-200", "beta-12-200", "beta-25-75", "beta-40-75"
]
"""How clean the oil is, by a word of ISO 281:2007, table 13, or by the filter of circulating oil, annex A.4."""


class BearingRules(Record):
    """How rolling bearings are judged, of shafts and planets."""

    life: Literal["basic", "modified"] = Field(
        "basic",
        description="Life that is asked: L_10h, or L_nmh = a_1 a_ISO L_10h by [oil] (ISO 281:2007); both are shown",
    )
    reliability: Ratio = Field(0.9, ge=0.9, le=0.999, description="Part of the bearings that reach the modified life")
    limits: bool = Field(
        False, description="Check least load against skidding and thermal reference speed (ISO 15312) too"
    )
    lubrication: Lubrication = Field(
        "jet",
        description="How oil comes to bearings: limits their n d_m; under-race: through inner rings, to taper ribs",
    )
    speed_factor: float | None = Field(
        None, ge=1e4, le=4e6, description="Largest n d_m from the maker; left out: by kind and lubrication [mm/min]"
    )


GRADE_KEYS = MappingProxyType({"oil_viscosity": "viscosity_40", "oil_viscosity_100": "viscosity_100"})
"""Rule of ISO 6336 -> what [oil] says of the same."""
WARMTH_KEYS = MappingProxyType({"oil_temperature": "temperature"})
"""Likewise of its temperature."""


VISCOSITY_40, VISCOSITY_100 = (1e6 * viscosity for viscosity in TURBINE_OIL)
"""Of the oil where a design says none, at bearings and teeth [mm²/s]."""
OIL_TEMPERATURE = 90.0
"""Likewise its temperature, an assumption [°C]."""


class OilOfDesign(Record):
    """The oil at bearings and teeth, for lives, losses and, where [gears.iso6336] says no other, films and scuffing."""

    viscosity_40: float = Field(VISCOSITY_40, ge=2, le=2000, description="Kinematic viscosity at 40 °C [mm²/s]")
    viscosity_100: float = Field(VISCOSITY_100, ge=1, le=200, description="Kinematic viscosity at 100 °C [mm²/s]")
    density: Density = Field(950.0, ge=500, le=1500, description="At its temperature")
    temperature: float = Field(OIL_TEMPERATURE, ge=-40, le=200, description="At bearings and teeth [°C]")
    cleanliness: Dirt = Field(
        "normal", description="Contamination factor e_C: a word of ISO 281:2007, table 13, or the filter of its annex A"
    )


# ----------------------------------------------------------------------------------------------------------------------
# How gears are rated by standards where Lewis and Hertz are not enough: how made, of what, which safeties they owe.
# ----------------------------------------------------------------------------------------------------------------------


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
    narrowest_modules: Ratio = Field(
        6.0,
        ge=1,
        le=30,
        description="Least face width over the normal module that is chosen where it is left out",
    )
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
    narrowest_modules: Ratio = Field(
        6.0,
        ge=1,
        le=30,
        description="Least face width over the normal module that is chosen where it is left out",
    )
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
    narrowest_modules: Ratio = Field(
        6.0, ge=1, le=30, description="Least face width over the mean normal module where it is left out"
    )
    standard_modules: bool = Field(True, description="Take modules from series I and II of ISO 54")


# ----------------------------------------------------------------------------------------------------------------------
# Bands of frequencies at which teeth shall not pass: a wish of the search, and a check of every design.
# ----------------------------------------------------------------------------------------------------------------------


class ForbiddenBand(Record):
    """Frequencies at which no teeth, or no planets, may pass in some load cases."""

    lowest: Frequency = Field(0.0, ge=0, description="Lower end of the band; at its ends a frequency is allowed")
    highest: Frequency = Field(gt=0, description="Upper end of the band")
    of: Literal["mesh", "planet-pass"] = Field(
        "mesh",
        description="mesh: how often teeth mesh, z |ω − ω_c|/2π of every pair and set; planet-pass: how often planets"
        " pass a tooth of their ring, N |ω_c − ω_r|/2π",
    )
    harmonics: int = Field(1, ge=1, le=20, description="Multiples of it that stay out, itself included")
    cases: list[str] | None = Field(
        None, description="Load cases in which it holds; left out: all that are not static, or rated without any"
    )
    reason: str = Field("", description="What would be shaken")


# ----------------------------------------------------------------------------------------------------------------------
# How gears are rated and proportioned, and what tooth numbers are searched.
# ----------------------------------------------------------------------------------------------------------------------


_DEGREE = math.pi / 180.0
ThicknessFit = Annotated[
    str, OneOf(THICKNESS_FITS, 'a series (a, ab, b, bc, c, cd, d, e, f, g, h) and a tolerance (21 to 30): "cd25"')
]
"""How much thinner than without backlash teeth are made, by DIN 3967."""
CentreFit = Annotated[str, OneOf(CENTRE_FITS)]
"""How far the axes of a mesh may miss their distance, by DIN 3964."""


class GearRules(Record):
    """How gears are rated and proportioned; a stage may state its own under ``gears``."""

    material: str = Field("nitriding-steel-785", description="Name in the catalogue or under [materials]")
    rating: RatingName = Field(
        "iso6336",
        description="First sizing by Lewis and Hertz; ISO 6336 or AGMA 2001, bevel gears by ISO 10300 or AGMA 2003;"
        " left out: as the level asks, iso6336 at preliminary, else lewis-hertz",
    )
    iso6336: Iso6336Rules = Field(
        default_factory=Iso6336Rules, description='Rules with rating = "iso6336" or "iso10300"'
    )
    agma2001: Agma2001Rules = Field(default_factory=Agma2001Rules, description='Rules with rating = "agma2001"')
    agma2003: Agma2003Rules = Field(default_factory=Agma2003Rules, description='Rules with rating = "agma2003"')
    pressure_angle: Angle = Field(
        20 * _DEGREE, ge=14 * _DEGREE, le=30 * _DEGREE, description="Normal pressure angle α_n"
    )
    helix_angle: Angle = Field(0.0, ge=0, le=45 * _DEGREE, description="Helix angle β of pairs; 0 is spur")
    face_width_ratio: Ratio | None = Field(
        None, gt=1, le=60, description="λ = b/m_n; left out: 10 for spur, the overlap ratio's for helical"
    )
    overlap_ratio: Ratio = Field(1.15, ge=1, le=5, description="Overlap ratio ε_β that sets the width of helical gears")
    bending_safety: Ratio = Field(2.5, ge=1, description="Factor on R_p0.2 in Lewis's bending")
    contact_safety: Ratio = Field(1.5, ge=1, description="Factor on 2.5 HB in Hertz's contact")
    mesh_load_factor: Ratio | None = Field(
        None,
        ge=1,
        le=3,
        description="K_γ, largest over mean load of parallel meshes; left out: by the load_sharing of the stage, 1 with"
        " Lewis and Hertz",
    )
    planet_load_factors: dict[str, Ratio] = Field(
        default_factory=dict,
        description="K_γ of sets by number of planets, { 3 = 1.1, 4 = 1.25 }: only those are chosen; left out:"
        " mesh_load_factor, or the load_sharing of the set",
    )
    idler_factor: Ratio = Field(
        1.0,
        ge=0.1,
        le=1,
        description="Share of the bending allowable for gears loaded both ways (planets); ISO 6336-3 takes 0.7",
    )
    profile_shift: Ratio = Field(
        0.0,
        ge=-0.5,
        le=1,
        description="Profile shift x of pinions and suns; it lowers the tooth number that is free of undercut",
    )
    balanced_shifts: Literal["sliding", "strength"] | None = Field(
        None,
        description="Shifts that are not given balance specific sliding, or the strength of the roots, of two gears",
    )
    allowance: ThicknessFit | None = Field(
        None,
        description='Allowance and tolerance of tooth thicknesses by DIN 3967: "cd25"; left out: as thick as can be',
    )
    centre_allowance: CentreFit | None = Field(
        None, description='Tolerance of centre distances by DIN 3964: "js7"; left out: the axes stand as drawn'
    )
    contact_angles: Literal["normal", "transverse"] = Field(
        "normal", description="Angles of the helical contact formula: α and β as the thesis prints, or α_t and β_b"
    )
    cutter_radius: Length | None = Field(
        None,
        gt=0,
        le=2,
        description="Cutter radius r_c0 of spiral bevel teeth, for their taper, K_F0 and K_x; left out: large",
    )
    mesh_efficiency: Ratio = Field(
        1.0, gt=0.5, le=1, description="Efficiency of one mesh; the driven gear receives that part of the tooth power"
    )
    web_ratio: Ratio = Field(
        1.0, ge=0.01, le=1, description="Mass of a wheel body over that of the solid disc; 1 is solid"
    )
    web_thickness_ratio: Ratio = Field(
        0.3,
        ge=0.05,
        le=1,
        description="Web over face width of gears in the complete mass, where rim and hub leave room; 1 is solid",
    )
    web_holes: Literal[0, 3, 4, 5, 6, 8, 10, 12] = Field(
        0,
        description="Holes that lighten the webs of cylindrical wheels of pairs, as wide as 0.6 of the room between rim"
        " and hub, or between neighbours",
    )
    web_dish: Ratio = Field(
        0.0,
        ge=-1,
        le=1,
        description="Dish of the webs of wheels of pairs: by how much they stand aside at the hub over their height,"
        " towards the shaft's second end, of bevel wheels away from the apex; their thickness along the axis is kept",
    )
    rim_thickness_ratio: Ratio = Field(
        3.95,
        ge=1,
        description="Ring wall from its pitch circle over the module; profile shift moves it with the root circle",
    )
    rim_ratio: Ratio | None = Field(
        None,
        gt=0.5,
        le=20,
        description="Rim of wheels and planets below the roots over the tooth height s_R/h_t, for Y_B; left out: solid",
    )

    def load_factor_of(self, planets: int) -> float:
        """Return K_γ of a set with so many planets, or of the first number in the table where that is not there [-].

        Args:
            planets: Number of planets, or of sets of planets [-].
        """
        table = self.planet_load_factors
        return table.get(str(planets), next(iter(table.values()), self.mesh_load_factor or 1.0))


SUN_LIMITS = (59, 120, 240, 400)
"""Largest tooth number of suns where none is given: as a rule, and then where no fewer teeth do [-]."""


class TeethRules(Record):
    """What the search for tooth numbers may choose from; the table of Lewis form factors begins at 12 teeth."""

    sun_minimum: int = Field(18, ge=12, le=400, description="Smallest tooth number of suns")
    sun_maximum: int | None = Field(
        None, ge=12, le=400, description="Largest tooth number of suns; left out: 59, or 400 where no fewer teeth do"
    )
    pinion_minimum: int | None = Field(
        None, ge=12, le=400, description="Smallest tooth number of pinions; left out: no undercut"
    )
    pinion_maximum: int = Field(40, ge=12, le=400, description="Largest tooth number of pinions that are searched")
    planet_minimum: int = Field(12, ge=12, le=400, description="Smallest tooth number of planets")
    planets_maximum: int = Field(
        5, ge=2, le=12, description="Maximum number of planets that are looked at where a set leaves their number out"
    )
    stage_tolerance: Ratio = Field(
        0.025, gt=0, le=0.2, description="Allowed deviation of a stage's ratio from its target"
    )
    speed_tolerance: Ratio = Field(0.05, gt=0, le=0.2, description="Allowed deviation of a speed from the one asked")
    split: Literal["equal", "optimal"] = Field(
        "equal", description="equal: stages share an open ratio equally (times ψ); optimal: as is lightest"
    )
    ring_deviation: int = Field(
        0, ge=0, le=2, description="Teeth by which chosen rings may differ from z_s + 2 z_p, where shifts close the set"
    )
    hunting: bool = Field(False, description="Ask for tooth numbers without a common factor")
    forbidden: dict[str, ForbiddenBand] = Field(
        default_factory=dict, description="Frequencies at which no teeth shall pass, by name: [teeth.forbidden.NAME]"
    )
    sized: int = Field(
        1,
        ge=1,
        le=1000,
        description="How many combinations of the lightest gears are sized in full, to take the lightest that passes",
    )

    def largest_sun(self, otherwise: int = SUN_LIMITS[0]) -> int:
        """Return the largest tooth number of suns that is looked at [-].

        Args:
            otherwise: Where none is given [-].
        """
        return self.sun_maximum or otherwise


# ----------------------------------------------------------------------------------------------------------------------
# Materials that a design states itself, to be named wherever one of the catalogue can be.
# ----------------------------------------------------------------------------------------------------------------------


class LifeLineRules(Record):
    """An S-N line: straight in double logarithmic scale up to its knee, then to the factor at 1e10 cycles and on."""

    knee_cycles: float = Field(ge=1e4, le=5e9, description="Cycles at which the strength is what the material states")
    exponent: Ratio = Field(ge=2, le=100, description="p of N ~ σ^(−p) below the knee")
    static_factor: Ratio | None = Field(
        None, gt=1, le=5, description="Largest stress over the strength, for few cycles; left out: of the class"
    )
    factor_at_1e10: Ratio | None = Field(
        None,
        ge=0.5,
        le=1,
        description="Stress over the strength at 1e10 cycles; beyond, the line goes on; left out: 0.85",
    )


class MaterialRules(Record):
    """A material: what is not known is left out, and refused where a method needs it."""

    elastic_modulus: Stress = Field(ge=5e10, le=5e11, description="Young's modulus E")
    poisson_ratio: Ratio = Field(ge=0.1, le=0.49, description="Poisson's ratio ν")
    density: Density = Field(ge=1e3, le=2e4, description="Density ρ")
    yield_strength: Stress | None = Field(None, ge=5e7, le=4e9, description="0.2 % proof stress R_p0.2 of the core")
    ultimate_strength: Stress | None = Field(None, ge=5e7, le=5e9, description="Tensile strength R_m of the core")
    group: Literal["structural", "nitriding", "tempered", "nickel-case-hardened", "case-hardened"] | None = Field(
        None, description="How its strength falls with the size of a shaft (DIN 743-2)"
    )
    hardness_hv: float | None = Field(None, ge=80, le=1200, description="Hardness of the flanks, Vickers")
    hardness_hb: float | None = Field(None, ge=80, le=750, description="Hardness of the flanks, Brinell")
    hardness_hrc: float | None = Field(None, ge=20.3, le=68, description="Hardness of the flanks, Rockwell C")
    steel: str | None = Field(
        None, description="Class of ISO 6336-5, for strengths that are left out, life curves and factors of size"
    )
    grade: Literal["ML", "MQ", "ME"] | None = Field(None, description="Material quality of ISO 6336-5; left out: MQ")
    contact_strength: Stress | None = Field(
        None, ge=1e8, le=4e9, description="σ_Hlim; left out: of its class, grade and hardness"
    )
    bending_strength: Stress | None = Field(
        None, ge=5e7, le=2e9, description="σ_Flim; left out: of its class, grade and hardness"
    )
    contact_life: LifeLineRules | None = Field(None, description="S-N line of flanks; left out: of the class")
    bending_life: LifeLineRules | None = Field(None, description="S-N line of roots; left out: of the class")
    melting: Literal["air", "vacuum-degassed", "ESR", "VAR", "VIM-VAR"] | None = Field(
        None, description="How clean it is molten"
    )
    source: str = Field("", description="Where the values come from")
    sources: dict[str, str] = Field(default_factory=dict, description="Property -> its own source")
    estimated: dict[str, str] = Field(
        default_factory=dict, description="Property that no source gives -> rule by which it is estimated"
    )


# ----------------------------------------------------------------------------------------------------------------------
# What is not as drawn: how far a gear, a shaft or a planet stands from its place, and how far that may go.
#
# Lengths are displacements of the part itself, so that a displacement towards the mating tooth closes a mesh.
# ----------------------------------------------------------------------------------------------------------------------


_TURN = 2.0 * math.pi


class PartErrors(Record):
    """Errors of one gear, shaft or planet."""

    eccentricity: Length = Field(
        0.0, ge=0, le=0.1, description="Distance of its own axis from the axis that it turns about"
    )
    phase: Angle = Field(
        0.0, ge=-_TURN, le=_TURN, description="Where the eccentricity points at time 0, from the first axis across it"
    )
    radial: Length = Field(0.0, ge=0, le=0.1, description="Distance of its standing axis from the drawn place")
    radial_angle: Angle = Field(
        0.0, ge=-_TURN, le=_TURN, description="Where that distance points, from the first axis across it"
    )
    axial: Length = Field(0.0, description="Distance along its axis from the drawn place, positive along x")
    tooth_thickness: Length = Field(0.0, description="Tooth too thick, along the line of action; negative is too thin")
    clocking: Angle = Field(
        0.0, ge=-_TURN, le=_TURN, description="Turned on its shaft against the drawn angle, positive as it drives"
    )
    pin_radial: Length = Field(0.0, description="Of a planet: pin too far out")
    pin_tangential: Length = Field(0.0, description="Of a planet: pin too far ahead in the positive direction")


# ----------------------------------------------------------------------------------------------------------------------
# By whose formulas power is lost: teeth, bearings, windage, seals.
# ----------------------------------------------------------------------------------------------------------------------


FrictionName = Literal["schlenk", "niemann-winter", "iso-tr-14179-1", "anderson-loewenthal"]
"""Whose friction of teeth; Schlenk's is that of ISO/TR 14179-2."""
TorqueName = Literal["constant", "palmgren", "skf"]
"""Whose friction of bearings."""
WindageName = Literal["anderson-loewenthal", "dawson"]
"""Whose windage of gears."""
SealName = Literal["none", "iso-tr-14179-1", "iso-tr-14179-2", "simrit"]
"""Whose friction of seals."""


class LossRules(Record):
    """By whose formulas power is lost; a mission takes them where its [oil] says nothing else."""

    friction: FrictionName = Field(
        "schlenk",
        description="Friction of the teeth: Schlenk (ISO/TR 14179-2), Niemann and Winter, ISO/TR 14179-1, or Anderson"
        " and Loewenthal",
    )
    lubricant_factor: Ratio = Field(
        1.0,
        gt=0,
        le=2,
        description="X_L of Schlenk, Niemann and Winter; left out: that of the stage's oil_type, 1 for mineral oils",
    )
    roughness: Length = Field(
        0.4e-6,
        ge=1e-8,
        le=1e-4,
        description="R_a of the flanks; left out: by the flank_roughness of the stage's rating where that is given",
    )
    bearings: TorqueName = Field(
        "constant",
        description="Friction of bearings: μ = 0.0011, Palmgren's two parts, or SKF's model; without a bearing's size"
        " μ = 0.0011",
    )
    windage: WindageName = Field("anderson-loewenthal", description="Windage of gears: in oil mist, or in air (Dawson)")
    enclosure: Ratio = Field(1.0, gt=0, le=1, description="λ of Dawson: 1 in the open, 0.6 to 0.7 in a housing")
    seals: SealName = Field("none", description="One shaft seal at each machine, and whose formula")
    dip: dict[str, Ratio] = Field(
        default_factory=dict,
        description="Gear -> part of it that dips into an oil bath, 0 to 1: it churns; left out: a dry sump",
    )


# ----------------------------------------------------------------------------------------------------------------------
# What the dynamic model assumes: mesh stiffness, damping, how far planetary sets may move on their bearings.
# ----------------------------------------------------------------------------------------------------------------------


class MeshCurve(Record):
    """A user's own stiffness of one mesh over a mesh cycle, from a file or written here."""

    file: str | None = Field(
        None, description="CSV file beside the design file, with the columns phase_cycles and stiffness_n_m"
    )
    phase_cycles: list[float] = Field(
        default_factory=list, description="Mesh phases as parts of a cycle, rising; 0 is contact at the pitch point"
    )
    stiffness_n_m: list[float] = Field(
        default_factory=list, description="Stiffness along the line of action at these phases [N/m]"
    )


class PlanetaryBearings(Record):
    """How the members of a planetary set are held where they may move; numbers left out are Lin & Parker's (1999)."""

    sun: Stiffness = Field(100e6, ge=0, description="Radial stiffness of the sun's bearing; 0 lets the sun float")
    carrier: Stiffness = Field(100e6, ge=0, description="Radial stiffness of the carrier's bearing; 0: floats")
    ring: Stiffness = Field(100e6, ge=0, description="Radial stiffness of the ring's seat; 0: floats")
    ring_tangential: Stiffness = Field(
        1000e6, gt=0, description="Tangential stiffness at the ring's base circle, where the ring stands still"
    )
    pin: Stiffness | None = Field(
        None,
        gt=0,
        description="Stiffness of a planet's pin with its bearing, in each direction; left out: the sized pin's alone",
    )
    rigid: list[Literal["sun", "carrier", "ring", "pin"]] = Field(
        default_factory=list, description="Members whose bearings do not give way at all"
    )


class DynamicsRules(Record):
    """Assumptions of the dynamic model."""

    mesh_damping: Ratio = Field(
        0.1, ge=0, lt=1, description="Damping ratio ζ of mesh lines (Pulvirenti 2023, eq. 3.29: 0.1)"
    )
    shaft_damping: Ratio = Field(
        0.1, ge=0, lt=1, description="Damping ratio ζ of shaft lines (Pulvirenti 2023, eq. 3.13: 0.1)"
    )
    stiffness: Literal["constant", "varying"] = Field(
        "varying", description="Mesh stiffness: mean, or a function of mesh phase"
    )
    mesh_stiffness: Literal["iso6336", "energy", "kuang-yang", "square-wave"] = Field(
        "iso6336",
        description="Mesh stiffness model: ISO 6336-1; strain energy of the teeth; Kuang & Yang; ISO's mean with the "
        "square wave of Pulvirenti 2023, eq. 3.35",
    )
    harmonics: int = Field(
        5, ge=1, le=40, description="Harmonics of the mesh frequency kept (Pulvirenti 2023, eq. 3.35: 5)"
    )
    curves: dict[str, MeshCurve] = Field(
        default_factory=dict, description="Own mesh stiffness, by mesh: first.sun-planet, first.planet-ring, a pair"
    )
    fidelity: Literal["rotational", "translational"] = Field(
        "rotational",
        description="Planetary sets turn in rigid bearings, or their members also move across on their bearings",
    )
    machines: Literal["inertia", "torque"] = Field(
        "inertia", description="Machines turn along on shafts of their own, or act by their torque alone"
    )


# ----------------------------------------------------------------------------------------------------------------------
# The housing and the oil system, as far as the mass of the gearbox needs them.
# ----------------------------------------------------------------------------------------------------------------------


HousingMaterial = Literal["aluminium", "magnesium", "composite", "cast-iron"]
"""What housings are made of."""


class HousingRules(Record):
    """What the housing is made of, and which of it and of the oil system belongs to the gearbox."""

    material: HousingMaterial = Field("aluminium", description="Of the housing: castings, or a laminate")
    wall: Length | None = Field(
        None, gt=0, le=0.2, description="Wall; left out: as a casting of its size has it, or as its torque asks"
    )
    rings: Literal["splined", "bolted"] = Field(
        "splined", description="Rings that stand: in splines of the housing; bolted: between two housings, as its wall"
    )
    reaction: Literal["lugs", "torque-arms"] = Field(
        "lugs",
        description="What holds its torque: lugs on the wall; torque-arms: arms and a shrink disc, weighed apart",
    )
    fatigue_safety: Ratio = Field(
        1.35, ge=1, le=5, description="Minimum safety of the housing's shell, walls, webs and mounts against fatigue"
    )
    start_interval: Time | None = Field(
        None,
        gt=0,
        description="From start to start; left out: what all load cases last together, where they have durations, else"
        " an hour",
    )
    overhaul_interval: Time | None = Field(
        None, gt=0, description="Asked of all for which the housing is opened; left out: none, intervals are told alone"
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
