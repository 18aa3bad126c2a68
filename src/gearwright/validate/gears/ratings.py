"""Published gear ratings: ISO/TR 6336-30, AGMA 908, mesh stiffness and reports of commercial programs."""

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cache, partial

import numpy as np

from gearwright.base import RPM
from gearwright.catalogue import gear_steel
from gearwright.parts import Material
from gearwright.parts.agma908 import HobbedPair, bending_geometry, pitting_geometry_factor
from gearwright.parts.gears import ISO53_D, CylindricalGear, GearPair, ball_measurement, span_measurement
from gearwright.parts.iso6336 import (
    BendingRating,
    Edition,
    GearSteel,
    MeshDuty,
    MeshGeometry,
    MeshQuality,
    PairRating,
    PittingRating,
    RootBody,
    RootSection,
    RootStrengthFactors,
    ShaperCutter,
    ToothLoadFactors,
    ToothProportions,
    Treatment,
    Value,
    bending_rating,
    notch_sensitivity_factor,
    outer_single_contact,
    pitting_rating,
    rate_mesh,
    rate_pair,
    root_section,
    single_contact_factors,
    surface_factor,
    zone_factor,
)
from gearwright.parts.losses import (
    OIL_DENSITY,
    Friction,
    LossDuty as LossDuty,
    MeshLaw,
    OilState,
    ToothContact,
    mesh_friction,
    mesh_loss_part,
    ohlendorf_loss_factor,
    oil_viscosity,
    tooth_contact,
)
from gearwright.parts.material import BRINELL_PER_VICKERS
from gearwright.parts.scuffing import (
    FlashEdition,
    Oil,
    ScuffingMesh,
    flash_temperature,
    integral_temperature,
    lubricant_factor_scuffing,
)
from gearwright.parts.stiffness import MeshStiffness, mesh_stiffness_iso6336, pair_stiffness
from gearwright.validate.case import Case

# ----------------------------------------------------------------------------------------------------------------------
# Published gear ratings: example 1 of ISO/TR 6336-30, and the geometry factors of AGMA 908.
# ----------------------------------------------------------------------------------------------------------------------


AGMA_FACTORS = (
    (21, 21, 0.33, 0.33, 0.078), (21, 26, 0.33, 0.35, 0.084), (26, 26, 0.35, 0.35, 0.079), (21, 35, 0.34, 0.37, 0.091),
    (26, 35, 0.36, 0.38, 0.088), (35, 35, 0.39, 0.39, 0.080), (21, 55, 0.34, 0.40, 0.102), (26, 55, 0.37, 0.41, 0.101),
    (35, 55, 0.40, 0.42, 0.095), (55, 55, 0.43, 0.43, 0.080), (21, 135, 0.35, 0.43, 0.118),
    (26, 135, 0.38, 0.44, 0.121), (35, 135, 0.41, 0.45, 0.120), (55, 135, 0.45, 0.47, 0.112),
    (135, 135, 0.49, 0.49, 0.080),
)  # fmt: skip
"""Teeth of pinion and gear, J of both, I: 20°, equal addenda, whole depth 2.25, highest single contact."""


@cache
def iso_rating() -> PairRating:
    """Return the rating of example 1: 17 and 103 teeth, 8 mm, 9000 N m at 360 rpm, 50 000 h, grade 5."""
    helix = math.radians(15.8)
    pair = GearPair(
        CylindricalGear(17, 8e-3, 0.1, helix_angle=helix, profile_shift=0.145, rack=ISO53_D),
        CylindricalGear(103, 8e-3, 0.1, helix_angle=helix, rack=ISO53_D),
        0.5,
    )
    steel = gear_steel("case-hardened", "MQ", 700.0)
    quality = MeshQuality(grade=5, flank_roughness=6e-6, tip_relief=70e-6, viscosity=320e-6)
    return rate_pair(pair, (steel, steel), MeshDuty(9000.0, 360.0 * RPM, 50_000 * 3600.0), quality=quality)


def _geometry() -> Sequence[float]:
    rated = iso_rating().pitting.geometry
    return [float(value) for value in (rated.zone, rated.elasticity / 1e3, rated.helix)]


def _example_film() -> Sequence[float]:
    strength = iso_rating().contact_strength[0]
    return [float(value) for value in (strength.lubricant, strength.speed, strength.roughness)]


def _example_stresses() -> Sequence[float]:
    rated = iso_rating().pitting
    return [float(value) / 1e6 for value in (rated.nominal_stress, *rated.permissible)]


def _loads() -> Sequence[float]:
    rated = iso_rating()
    return [float(value) for value in (rated.tangential_force, rated.speed, rated.dynamic.factor)]


def _example_bending() -> Sequence[float]:
    pairs = [HobbedPair((row[0], row[1])) for row in AGMA_FACTORS]
    return [float(bending_geometry(pair, gear).factor) for pair in pairs for gear in (0, 1)]


def _pitting() -> Sequence[float]:
    return [float(pitting_geometry_factor(HobbedPair((row[0], row[1])))) for row in AGMA_FACTORS]


_ISO = "ISO/TR 6336-30:2017, example 1"
RATING_CASES = (
    Case("Z_H, Z_E, Z_β", _ISO, "√N/mm for Z_E", (2.39533, 189.8117, 1.01944), _geometry, 1e-5, "six digits printed"),
    Case("Z_L, Z_v, Z_R", _ISO, "", (1.04739, 0.96911, 0.96599), _example_film, 1e-5, "five digits printed"),
    Case("F_t, v, K_v", _ISO, "N, m/s, –", (127352.0, 2.664, 1.003), _loads, 5e-4, "K_v and v have four digits"),
    Case("σ_H0, σ_HP1, σ_HP2", _ISO, "MPa", (1206.58207, 1338.48050, 1414.52551), _example_stresses, 1e-4,
         "the contact ratio there is rounded to three decimals"),
    Case("bending geometry factor J", "AGMA 908-B89", "", tuple(value for row in AGMA_FACTORS for value in row[2:4]),
         _example_bending, 0.0065, "two decimals, by charts", is_relative=False),
    Case("pitting geometry factor I", "AGMA 908-B89", "", tuple(row[4] for row in AGMA_FACTORS), _pitting, 5e-4,
         "three decimals", is_relative=False),
)  # fmt: skip
"""Published ratings."""


# ----------------------------------------------------------------------------------------------------------------------
# Published mesh stiffness: the worked example of ISO/TR 6336-30, other programs' by ISO 6336 and by energy.
# ----------------------------------------------------------------------------------------------------------------------


def iso_example() -> MeshStiffness:
    """Return the stiffness of the pair of example 1: 17 and 103 teeth, 8 mm, 15.8°, centre distance 0.5 m."""
    helix = math.radians(15.8)
    pair = GearPair(
        CylindricalGear(17, 8e-3, 0.1, helix_angle=helix, profile_shift=0.145, rack=ISO53_D),
        CylindricalGear(103, 8e-3, 0.1, helix_angle=helix, rack=ISO53_D),
        0.5,
    )
    return mesh_stiffness_iso6336(pair)


def _single() -> Sequence[float]:
    stiffness = iso_example()
    return [stiffness.theoretical / 1e9, stiffness.single / 1e9]


def _mesh() -> Sequence[float]:
    stiffness = iso_example()
    return [stiffness.mesh / 1e9, stiffness.face / 1e9]


def wind_turbine_pair(stage: int) -> GearPair:
    """Return sun and planet, or pinion and wheel, of a stage of the 5 MW reference gearbox of Nejad et al. 2016.

    The first stage's stiffness is left out: that program takes the sun for the pinion although its 19 teeth are more
    than the planet's 17, which turns c′_th = 18.379 into the 18.829 N/(mm µm) that it finds.

    Args:
        stage: 1 to 3.
    """
    teeth, shifts, module, width, distance, shortened, helix = {
        1: ((19, 17), (0.617, 0.802), 45e-3, 0.491, 0.863, 10.861e-3, 0.0),
        2: ((18, 36), (0.389, 0.504), 21e-3, 0.550, 0.584, 1.75e-3, 0.0),
        3: ((24, 95), (0.480, 0.669), 14e-3, 0.360, 0.861, 0.938e-3, math.radians(10.0)),
    }[stage]
    first, second = (
        CylindricalGear(z, module, width, helix, profile_shift=x, tip_alteration=-shortened / module)
        for z, x in zip(teeth, shifts, strict=True)
    )
    return GearPair(first, second, distance)


def _contact_ratios() -> Sequence[float]:
    return [wind_turbine_pair(stage).transverse_contact_ratio for stage in (1, 2, 3)]


def _wind_turbine(stage: int) -> Sequence[float]:
    found = mesh_stiffness_iso6336(wind_turbine_pair(stage))
    return [value / 1e9 for value in (found.theoretical, found.single, found.mesh, found.face)]


def _bored_pair() -> tuple[GearPair, Material]:
    """Return the pair of ROSS's tests: 62 teeth each, 2 mm, 20 mm wide, on bores of 35 mm."""
    gear = CylindricalGear(62, 2e-3, 20e-3)
    return GearPair(gear, gear), Material("gear steel", 206e9, 0.3, 7810.0)


def _two_pairs_begin() -> Sequence[float]:
    """Return the mesh stiffness where the second pair of teeth comes into contact [MN/m]."""
    pair, steel = _bored_pair()
    pitch = math.pi * pair.driver.module * math.cos(pair.driver.rack.pressure_angle)
    places = np.array([-pair.approach, pitch - pair.approach])
    found = pair_stiffness(pair, places, materials=(steel, steel), bore_radii=(17.5e-3, 17.5e-3))
    return [float(np.sum(found.stiffness)) * pair.face_width / 1e6]


def _mesh_contact() -> Sequence[float]:
    pair, steel = _bored_pair()
    contact = pair_stiffness(pair, np.zeros(1), materials=(steel, steel)).contact
    return [pair.transverse_contact_ratio, pair.face_width / contact / 1e6]


_NREL = "Nejad et al. 2016, 5 MW reference gearbox, by Rebouças' Drivetrain (tests)"
_ROSS = "ROSS 2.3, test of gears of varying mesh stiffness (method of Ma et al. 2014)"

STIFFNESS_CASES = (
    Case(
        "contact ratios of three shifted stages",
        _NREL,
        "-",
        (1.114698962948295, 1.3703997308907856, 1.462659404435414),
        _contact_ratios,
        1e-12,
        "rounding",
    ),
    Case(
        "stiffness c′_th, c′, c_γα, c_γβ of a sun and planet",
        _NREL,
        "N/(mm µm)",
        (18.198806127990704, 14.19506877983275, 18.138456021852434, 15.417687618574568),
        partial(_wind_turbine, 2),
        1e-12,
        "rounding",
    ),
    Case(
        "stiffness c′_th, c′, c_γα, c_γβ of a shifted helical pair",
        _NREL,
        "N/(mm µm)",
        (20.051822093657176, 15.402808090686957, 20.74749860408961, 17.635373813476168),
        partial(_wind_turbine, 3),
        1e-12,
        "rounding",
    ),
    Case(
        "contact ratio and Hertzian stiffness",
        _ROSS,
        "-, MN/m",
        (1.7897798668330458, 3555.8686079093266),
        _mesh_contact,
        1e-12,
        "rounding",
    ),
    Case(
        "mesh stiffness where a second pair of teeth comes in",
        _ROSS,
        "MN/m",
        (396.6229213581085,),
        _two_pairs_begin,
        0.05,
        "another root: straight from the base circle down there, the rack's trochoid here",
    ),
    Case(
        "single stiffness c′_th, c′",
        "ISO/TR 6336-30:2017, example 1",
        "N/(mm µm)",
        (17.85584, 12.37047),
        _single,
        6e-6,
        "five decimals are printed",
        is_relative=False,
    ),
    Case(
        "mesh stiffness c_γα, c_γβ",
        "ISO/TR 6336-30:2017, example 1",
        "N/(mm µm)",
        (17.46485, 14.84512),
        _mesh,
        6e-4,
        "the contact ratio there is rounded to three decimals",
    ),
)
"""Published mesh stiffness."""


# ----------------------------------------------------------------------------------------------------------------------
# Printed reports of commercial programs: a planetary stage of a 5 MW wind turbine, and a pair of a test rig.
#
# The reports carry their K factors with two decimals, so stresses are held with the printed factors, and what the
# standards' parts 2 and 3 make of them to the last digit.
# ----------------------------------------------------------------------------------------------------------------------


WIND = "KISSsoft 03/2017, NREL 5 MW gearbox, stage 1 (report in the repository gfsReboucas/Drivetrain)"
_RIG = "FVA STplus, DIN 3990:1987, pair 51/52 (listing in the repository tkuhn39/semesterthesis)"
_MM, _MPA = 1e-3, 1e6

# --- 19/17/-56, m 45, three planets; 5000 kW at 12.1 rpm of the carrier -------------------------------------------
_RACK, _RING_RACK = ToothProportions(1.25, 0.38), ToothProportions(1.25, 0.30)
_SUN, _PLANET = replace(_RACK, profile_shift=0.617), replace(_RACK, profile_shift=0.8021)
_RING = replace(_RING_RACK, cutter=ShaperCutter(36.0), profile_shift=-0.5013)
SUN_PLANET = MeshGeometry(
    (19.0, 17.0), 45 * _MM, 491 * _MM, 863 * _MM, (489.404 * _MM, 452.735 * _MM), proportions=(_SUN, _PLANET)
)
PLANET_RING = MeshGeometry(
    (17.0, -56.0), 45 * _MM, 491 * _MM, 863 * _MM, (452.735 * _MM, 1237.559 * _MM), proportions=(_PLANET, _RING)
)
_CASE = GearSteel("18CrNiMo7-6", Treatment.CASE_HARDENED, "MQ", 720.0, 1500 * _MPA, 430 * _MPA)
_TEMPERED = GearSteel(
    "34CrNiMo6", Treatment.THROUGH_HARDENED, "MQ", 240.0 / BRINELL_PER_VICKERS, 700 * _MPA, 290 * _MPA,
    yield_strength=1000 * _MPA,
)  # fmt: skip
_LOADS = tuple(ToothLoadFactors(1.25, 1.1, dynamic, face_contact=1.15, face_bending=1.12) for dynamic in (1.01, 1.05))
"""As printed, of sun-planet and planet-ring."""
_ROUGH = MeshQuality(flank_roughness=4.8e-6, root_roughness=20e-6, viscosity=220e-6)
_SPEED = 12.1 * RPM * 56.0 / 19.0
"""Of the sun against the carrier [rad/s]."""
_SUN_TORQUE = 999_650.9 / 3.0


@cache
def _rated() -> tuple[PairRating, PairRating]:
    """Return both meshes, rated by the edition of 2006."""
    life = 175_200.0 * 3600.0
    sun = MeshDuty(_SUN_TORQUE, _SPEED, life, 1.25, 1.1, (3.0, 1.0))
    planet = MeshDuty(_SUN_TORQUE * 17.0 / 19.0, _SPEED * 19.0 / 17.0, life, 1.25, 1.1, (1.0, 3.0))
    flanks = replace(_ROUGH, mean_stresses=(1.0, 0.7))
    ring_flanks = replace(_ROUGH, mean_stresses=(0.7, 1.0), flank_roughness=(4.8e-6, 8e-6))
    return (
        rate_mesh(SUN_PLANET, (_CASE, _CASE), sun, quality=flanks, edition=Edition.ISO2006),
        rate_mesh(PLANET_RING, (_CASE, _TEMPERED), planet, quality=ring_flanks, edition=Edition.ISO2006),
    )


def _roots() -> list[RootSection]:
    """Return the sections of sun, planet at the sun, planet at the ring, ring."""
    return [
        root_section(outer_single_contact(mesh, gear), Edition.ISO2006)
        for mesh in (SUN_PLANET, PLANET_RING)
        for gear in (0, 1)
    ]


def _bending() -> list[BendingRating]:
    """Return the roots with the printed load factors, in the same order."""
    return [
        bending_rating(
            mesh, gear, steels[gear], specific_load=rated.tangential_force / mesh.face_width, loads=loads,
            strength=rated.root_strength[gear], body=RootBody(edition=Edition.ISO2006),
        )
        for mesh, steels, rated, loads in zip(
            (SUN_PLANET, PLANET_RING), ((_CASE, _CASE), (_CASE, _TEMPERED)), _rated(), _LOADS, strict=True
        )
        for gear in (0, 1)
    ]  # fmt: skip


def _flanks() -> list[PittingRating]:
    return [
        pitting_rating(mesh, steels, rated.tangential_force, loads=loads, strengths=rated.contact_strength)
        for mesh, steels, rated, loads in zip(
            (SUN_PLANET, PLANET_RING), ((_CASE, _CASE), (_CASE, _TEMPERED)), _rated(), _LOADS, strict=True
        )
    ]


# --- 51/52, m 1, a pair of a test rig by DIN 3990, teeth as cut (x_E) and to the tip form diameters ----------------
RIG = MeshGeometry(
    (51.0, 52.0), 1 * _MM, 15 * _MM, 52 * _MM, (26.447 * _MM, 26.894 * _MM),
    proportions=(ToothProportions(1.1, 0.2, -0.2030), ToothProportions(1.25, 0.2, 0.0117)),
)  # fmt: skip
_RIG_LOADS = ToothLoadFactors(dynamic=1.56, face_bending=1.16)


_RIG_STEEL = GearSteel("16MnCr5", Treatment.CASE_HARDENED, "MQ", 700.0, 1500 * _MPA, 430 * _MPA)


def _rig() -> list[BendingRating]:
    return [
        bending_rating(
            RIG, gear, _RIG_STEEL, specific_load=384.6 / (width * _MM), loads=_RIG_LOADS,
            strength=_rig_strength(gear), body=RootBody(edition=Edition.ISO2006),
        )
        for gear, width in enumerate((17.0, 15.0))
    ]  # fmt: skip


def _rig_strength(gear: int) -> RootStrengthFactors:
    notch = root_section(outer_single_contact(RIG, gear)).notch
    sensitivity = notch_sensitivity_factor(notch, _RIG_STEEL)
    return RootStrengthFactors(1.0, sensitivity, surface_factor(20e-6, _RIG_STEEL.treatment))


def _teeth(sections: Sequence[RootSection]) -> list[float]:
    return [
        float(value)
        for section in sections
        for value in (section.chord, section.fillet_radius, section.lever, section.form, section.stress_correction)
    ]


def _load_angles(sections: Sequence[RootSection]) -> list[float]:
    return [float(np.degrees(section.load_angle)) for section in sections]


def _root_factors() -> list[float]:
    factors = [strength for rated in _rated() for strength in rated.root_strength]
    return [float(value) for root in factors for value in (root.notch_sensitivity, root.surface, root.size, root.life)]


def _stresses(roots: Sequence[BendingRating]) -> list[float]:
    return [float(root.nominal_stress) / _MPA for root in roots]


def _contact() -> list[float]:
    return [
        float(value)
        for flank in _flanks()
        for value in (flank.geometry.zone, flank.geometry.contact_ratio, *flank.geometry.single_contact)
    ]


def _contact_factors() -> list[float]:
    """Z_L, Z_v, Z_R of both meshes, Z_NT of sun, planet and ring, Z_W of the ring."""
    sun, ring = _rated()
    film = [value for rated in (sun, ring) for value in _film(rated)]
    lives = [sun.contact_strength[0].life, sun.contact_strength[1].life, ring.contact_strength[1].life]
    return [float(value) for value in (*film, *lives, ring.contact_strength[1].work_hardening)]


def _film(rated: PairRating) -> tuple[Value, Value, Value]:
    strength = rated.contact_strength[0]
    return strength.lubricant, strength.speed, strength.roughness


def _limits() -> list[float]:
    return [float(limit) / _MPA for flank in _flanks() for limit in flank.permissible]


_CUT = tuple(
    CylindricalGear(teeth, 45 * _MM, 491 * _MM, profile_shift=shift)
    for teeth, shift in ((19, 0.617), (17, 0.8021), (-56, -0.5013))
)
"""Sun, planet and ring as an inspector measures them."""


def _measures() -> list[float]:
    spans = [span_measurement(gear, 3) for gear in _CUT[:2]]
    balls = [ball_measurement(gear, ball * _MM) for gear, ball in zip(_CUT, (95.0, 110.0, 80.0), strict=True)]
    return [length / _MM for length in (*spans, *balls)]


_PRINT = "half a printed digit"
PROGRAM_CASES = (
    Case("s_Fn, ρ_F, h_F, Y_F, Y_S of sun, planet twice, ring", WIND, "m_n", (
        2.248, 0.403, 1.441, 1.56, 2.06, 2.314, 0.382, 1.450, 1.44, 2.14,
        2.314, 0.382, 1.101, 1.14, 2.38, 2.875, 0.494, 1.742, 1.27, 2.13,
    ), lambda: _teeth(_roots()), 0.0051, "Y_F and Y_S have two decimals", is_relative=False),
    Case("load angle α_Fen of sun, planet twice, ring", WIND, "°", (30.75, 33.33, 29.87, 19.59),
         lambda: _load_angles(_roots()), 0.006, _PRINT, is_relative=False),
    Case("σ_F0 of sun, planet twice, ring", WIND, "MPa", (113.46, 108.94, 95.70, 95.32),
         lambda: _stresses(_bending()), 2e-4, _PRINT),
    Case("Y_δrelT, Y_RrelT, Y_X, Y_NT of sun, planet twice, ring", WIND, "", (
        1.003, 0.957, 0.80, 0.888, 1.005, 0.957, 0.80, 0.906, 1.005, 0.957, 0.80, 0.906, 1.003, 0.957, 0.85, 0.907,
    ), _root_factors, 6e-4, _PRINT, is_relative=False),
    Case("σ_FG of sun, planet twice, ring", WIND, "MPa", (586.11, 419.35, 419.35, 429.14),
         lambda: [float(root.permissible) / _MPA for root in _bending()], 3e-5, _PRINT),
    Case("S_F of sun, planet twice, ring", WIND, "", (3.33, 2.48, 2.71, 2.79),
         lambda: [float(root.safety) for root in _bending()], 4e-3, "K_V and K_Fβ are printed with two decimals"),
    Case("Z_H, Z_ε, Z_B, Z_D of both meshes", WIND, "", (2.06, 0.981, 1.04, 1.05, 2.71, 0.952, 1.0, 1.0),
         _contact, 0.0051, "two decimals", is_relative=False),
    Case("σ_H0 of both meshes", WIND, "MPa", (759.92, 588.62),
         lambda: [float(flank.nominal_stress) / _MPA for flank in _flanks()], 2e-5, _PRINT),
    Case("Z_L, Z_v, Z_R of both meshes, Z_NT of sun, planet, ring, Z_W of the ring", WIND, "", (
        1.020, 0.961, 1.024, 1.038, 0.916, 1.025, 0.909, 0.937, 0.940, 1.135,
    ), _contact_factors, 6e-4, _PRINT, is_relative=False),
    Case("σ_HG of sun, planet twice, ring", WIND, "MPa", (1368.61, 1410.69, 1368.95, 727.36), _limits, 3e-5, _PRINT),
    Case("S_H of sun, planet, planet, ring", WIND, "", (1.37, 1.41, 1.80, 0.96),
         lambda: [float(safety) for flank in _flanks() for safety in flank.safeties], 5e-3,
         "K_V and K_Hβ are printed with two decimals"),
    Case("W_3 of sun and planet, M_dK of sun, planet, ring", WIND, "mm",
         (363.082, 367.520, 1050.690, 1008.755, 2445.378), _measures, 2e-3, "x has four decimals, up to 3 µm of M_dK",
         is_relative=False),
    Case("s_Fn, ρ_F, h_F, Y_F, Y_S of both gears", _RIG, "m_n", (
        2.068, 0.404, 1.762, 2.417, 1.819, 2.197, 0.381, 1.614, 1.970, 1.984,
    ), lambda: _teeth([root.section for root in _rig()]), 1e-3, "x_E of the span allowance has four decimals"),
    Case("load angle α_Fen of both gears", _RIG, "°", (23.222, 22.702),
         lambda: _load_angles([root.section for root in _rig()]), 1e-3, _PRINT, is_relative=False),
    Case("σ_F0 of both gears", _RIG, "MPa", (99.5, 100.2), lambda: _stresses(_rig()), 6e-4, _PRINT),
    Case("σ_F of both gears", _RIG, "MPa", (180.1, 181.4), lambda: [float(root.stress) / _MPA for root in _rig()],
         1e-3, "K_V and K_Fβ are printed with two decimals"),
    Case("σ_FP and S_F of the pinion", _RIG, "MPa, –", (823.2, 4.571),
         lambda: [float(_rig()[0].permissible) / _MPA, float(_rig()[0].safety)], 1e-3, _PRINT),
    Case("ε_α, Z_B, Z_D, Z_H", _RIG, "", (1.154, 1.009, 1.008, 2.400), lambda: [
        float(value) for value in (RIG.transverse_contact_ratio, *single_contact_factors(RIG), zone_factor(RIG))
    ], 6e-4, _PRINT, is_relative=False),
)  # fmt: skip
"""Printed ratings."""


# ----------------------------------------------------------------------------------------------------------------------
# Printed losses of teeth: the planetary stage of `gear_reports`.
# ----------------------------------------------------------------------------------------------------------------------


_OIL = oil_viscosity(348.15, (220e-6, 19e-6)) * 890.0 * (1.0 - 7e-4 * 60.0)
"""η at 75 °C of an oil of 890 kg/m³ at 15 °C [Pa s]."""
_ROUGHNESS = (0.6e-6, 0.5 * (0.6e-6 + 1.05e-6))
_FORCE = 1.25 * 1.1 * 999_650.9 / 3.0
"""K_A K_γ times the sun's torque of a planet [N m]."""
_SLIDING = 12.1 * RPM * 56.0 / 19.0 * 0.5 * 0.855
"""At the sun's reference circle, against the carrier [m/s]; the same at all reference circles."""
_PLANET_POWER, _POWER = 5000.0 * 56.0 / 75.0 / 3.0, 5000.0
"""Of the teeth of one planet, and of the stage [kW]."""


def _loss_factor(mesh: MeshGeometry) -> float:
    recess, approach = (float(ratio) for ratio in mesh.addendum_contact_ratios)
    return ohlendorf_loss_factor(_tooth_numbers(mesh), 0.0, approach=approach, recess=recess)


def _tooth_numbers(mesh: MeshGeometry) -> tuple[float, float]:
    return float(mesh.teeth[0]), float(mesh.teeth[1])


def _friction(mesh: MeshGeometry, roughness: float) -> float:
    small = min(float(diameter) for diameter in mesh.pitch_diameters)
    contact = ToothContact(
        _loss_factor(mesh), float(mesh.relative_curvature), float(mesh.working_angle), 0.0, pinion_diameter=small
    )
    load = _FORCE / (0.5 * float(SUN_PLANET.base_diameters[0])) / float(mesh.face_width)
    friction = mesh_friction(contact, load, _SLIDING, viscosity=_OIL, roughness=roughness, law=Friction.NIEMANN_WINTER)
    return float(friction)


def _frictions() -> list[float]:
    return [_friction(mesh, rough) for mesh, rough in zip((SUN_PLANET, PLANET_RING), _ROUGHNESS, strict=True)]


def _losses() -> list[float]:
    meshes = zip((SUN_PLANET, PLANET_RING), _frictions(), strict=True)
    return [_PLANET_POWER * friction * _loss_factor(mesh) for mesh, friction in meshes]


LOSS_CASES = (
    Case("H_V of sun-planet and planet-ring by Ohlendorf's formula", WIND, "", (0.181, 0.161),
         lambda: [_loss_factor(mesh) for mesh in (SUN_PLANET, PLANET_RING)], 5e-4, "half a printed digit",
         is_relative=False),
    Case("μ_m of both meshes by Niemann and Winter", WIND, "", (0.041, 0.045), _frictions, 5e-4,
         "half a printed digit", is_relative=False),
    Case("losses of both meshes of a planet, and of the stage", WIND, "kW", (9.272, 8.986, 54.775),
         lambda: [*_losses(), 3.0 * sum(_losses())], 5e-4, "the report does not print the oil's density at 75 °C"),
    Case("efficiency of the stage's teeth", WIND, "", (0.989,), lambda: [1.0 - 3.0 * sum(_losses()) / _POWER], 5e-4,
         "half a printed digit", is_relative=False),
)  # fmt: skip
"""Printed losses."""


# ----------------------------------------------------------------------------------------------------------------------
# Measured efficiency of a helicopter's main transmission, held against the losses of its teeth.
#
# The planetary set is that of Lin and Parker's model of it: pitch circles of 77.42, 100.35 and 275.03 mm, 24.6°
# between sun and planets, a common base circle of the planets with the ring, and 27, 35 and 99 teeth, of which the
# pitch circles have two modules. The bevel pair has 19 and 71 teeth; its module, its spiral and all face widths are
# assumed.
# ----------------------------------------------------------------------------------------------------------------------


_OH58 = (
    "Coy, Mitchell and Hamrock, 11 lubricants in the OH-58A main transmission (abstract, doi 10.1002/jsl.3000040105)"
)
_INPUT_POWER, _INPUT = 224e3, 6060.0 * RPM
_TEMPERATURES = (355.0, 372.0)
"""Of the oil into the transmission [K]."""
_SUN_MODULE, _RING_MODULE = 77.42e-3 / 27.0, 275.03e-3 / 99.0
_SUN_ANGLE = math.radians(24.6)
_RING_ANGLE = math.acos(_SUN_MODULE * math.cos(_SUN_ANGLE) / _RING_MODULE)
"""Of one base circle of the planets [rad]: 20.2°."""
_WIDTH, _BEVEL_WIDTH = 30e-3, 35e-3
_BEVEL_MODULE, _SPIRAL = 3.9e-3, math.radians(30.0)
_FLANK_ROUGHNESS = 0.4e-6
_STAGE = (
    "Experimental and analytical evaluation of efficiency of helicopter planetary stage, NASA Lewis, November 1990"
    " (abstract, DTIC ADA231724)"
)
_EXTREMES = (
    "124 conditions from 98.64 to 99.83 %; which stage is not told, that of the OH-58A is assumed, at 224 kW; planet"
    " bearings, windage and trapped oil are not in it"
)
_RANGE = "the eleven lubricants lie 0.25 % to both sides; widths and bevel module are assumed; bearings are not in it"


def _part(contact: ToothContact, torque: float, turning: float, *, width: float, oil: OilState, law: MeshLaw) -> float:
    """Return the part of its power that a mesh loses, from torque and speed of its first gear."""
    radius = contact.radii[0]
    load = torque / radius / math.cos(contact.pressure_angle) / width
    return float(mesh_loss_part(contact, LossDuty(load, width, turning * radius), oil, law=law))


def _efficiency(law: MeshLaw, temperature: float) -> float:
    """Return the efficiency of the teeth of both stages."""
    oil = OilState(oil_viscosity(temperature) * OIL_DENSITY, OIL_DENSITY, _FLANK_ROUGHNESS)
    bevel = tooth_contact((19, 71), _BEVEL_MODULE, pressure_angle=math.radians(20.0), helix_angle=_SPIRAL)
    first = _part(bevel, _INPUT_POWER / _INPUT, _INPUT, width=_BEVEL_WIDTH, oil=oil, law=law)
    return 1.0 - first - _planetary_loss(law, oil)


def _planetary_loss(law: MeshLaw, oil: OilState) -> float:
    """Return the part of its power that the planetary set loses in its teeth."""
    sun = tooth_contact((27, 35), _SUN_MODULE, pressure_angle=_SUN_ANGLE)
    ring = tooth_contact((35, -99), _RING_MODULE, pressure_angle=_RING_ANGLE)
    turning = _INPUT * 19.0 / 71.0
    rolling, torque = turning * 99.0 / 126.0, _INPUT_POWER / turning / 3.0
    second = _part(sun, torque, rolling, width=_WIDTH, oil=oil, law=law)
    third = _part(ring, torque * 35.0 / 27.0, rolling * 27.0 / 35.0, width=_WIDTH, oil=oil, law=law)
    return (second + third) * rolling / turning


def _stage(law: MeshLaw) -> Callable[[], list[float]]:
    return lambda: [
        1.0 - _planetary_loss(law, OilState(oil_viscosity(temperature) * OIL_DENSITY, OIL_DENSITY, _FLANK_ROUGHNESS))
        for temperature in _TEMPERATURES
    ]


def _both(law: MeshLaw) -> Callable[[], list[float]]:
    return lambda: [_efficiency(law, temperature) for temperature in _TEMPERATURES]


MEASURED_CASES = tuple(
    Case(f"OH-58A, 224 kW, oil of 355 and 372 K: efficiency by {name}", _OH58, "", (0.9855, 0.9855), _both(law), 2.5e-3,
         _RANGE, is_relative=False)
    for name, law in (("Schlenk", MeshLaw.SCHLENK), ("Niemann and Winter", MeshLaw.NIEMANN_WINTER),
                      ("Anderson and Loewenthal", MeshLaw.ANDERSON_LOEWENTHAL))
) + tuple(
    Case(f"helicopter planetary stage, oil of 355 and 372 K: efficiency of the teeth by {name}", _STAGE, "",
         (0.99235, 0.99235), _stage(law), 5.95e-3, _EXTREMES, is_relative=False)
    for name, law in (("Schlenk", MeshLaw.SCHLENK), ("Niemann and Winter", MeshLaw.NIEMANN_WINTER),
                      ("Anderson and Loewenthal", MeshLaw.ANDERSON_LOEWENTHAL))
)  # fmt: skip
"""Measured losses."""


# ----------------------------------------------------------------------------------------------------------------------
# Printed scuffing: the helical pair of the 5 MW gearbox of `gear_reports`, by flash and by integral temperature.
# ----------------------------------------------------------------------------------------------------------------------


_SOURCE = "KISSsoft 03/2017, NREL 5 MW gearbox, stage 3 (report in the repository gfsReboucas/Drivetrain)"
_WIND_RACK = ToothProportions(1.25, 0.38)
_PAIR = MeshGeometry(
    (24.0, 95.0), 14e-3, 360e-3, 861e-3, (0.5 * 380.7473e-3, 0.5 * 1395.3754e-3), helix_angle=np.radians(10.0),
    proportions=(replace(_WIND_RACK, profile_shift=0.48), replace(_WIND_RACK, profile_shift=0.6691)),
)  # fmt: skip
_SCUFFING_OIL = Oil(80.0, 30.09e-3, 14.0, viscosity_40=220e-6)
_LOAD = 40953.0 / (0.5 * float(_PAIR.pitch_diameters[0])) / 0.360
"""F_t/b [N/m]."""
_MESH = ScuffingMesh(
    _PAIR, specific_load=1119.632e3, nominal_load=1.25 * _LOAD,
    speed=1165.9 * RPM * 0.5 * float(_PAIR.pitch_diameters[0]), roughness=0.6e-6,
    stiffness=(13.832e9, 18.632e9), reliefs=(2e-6, 2e-6),
)  # fmt: skip
"""w_Bt with the printed factors."""


def _flash() -> list[float]:
    found = flash_temperature(_MESH, _SCUFFING_OIL, FlashEdition.TR2000)
    return [found.contact, found.scuffing, found.safety]


def _scuffing_friction() -> list[float]:
    friction = flash_temperature(_MESH, _SCUFFING_OIL, FlashEdition.TR2000).friction
    return [friction, lubricant_factor_scuffing(_SCUFFING_OIL)]


def _integral() -> list[float]:
    found = integral_temperature(_MESH, _SCUFFING_OIL)
    return [found.friction, found.geometry, found.approach, found.tip_relief, found.contact_ratio]


def _temperatures() -> list[float]:
    found = integral_temperature(_MESH, replace(_SCUFFING_OIL, test_torque=714.2))
    return [found.flash_mean, found.integral, found.scuffing, found.safety]


SCUFFING_CASES = (
    Case("μ_m and X_L of the flash temperature, ISO/TR 13989-1:2000", _SOURCE, "", (0.041, 0.843),
    _scuffing_friction, 5.1e-4,
         "half a printed digit", is_relative=False),
    Case("ϑ_B, ϑ_S and S_B of the flash temperature, ISO/TR 13989-1:2000", _SOURCE, "°C, –", (169.5, 451.98, 4.156),
         _flash, 7e-3, "the report has X_J = 1 and buttresses otherwise"),
    Case("μ_m, X_BE, X_Q, X_Ca, X_ε of the integral temperature", _SOURCE, "", (0.030, 0.230, 1.0, 1.095, 0.263),
         _integral, 5.1e-4, "half a printed digit", is_relative=False),
    Case("ϑ_flaint, ϑ_int, ϑ_intS, S_intS", _SOURCE, "K, °C, –", (16.25, 115.75, 455.17, 3.932), _temperatures, 5e-4,
         "stage 14 of the oil's test by the report's torque of 714.2 N m"),
)  # fmt: skip
"""Printed scuffing."""
