"""Published rating and vibration of the second and third stage of a 5 MW wind turbine gearbox."""

from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from typing import NamedTuple

import numpy as np

from gearwright.base import RPM
from gearwright.parts.iso6336 import (
    BendingRating,
    DynamicFactor,
    Edition,
    GearSteel,
    MeshDeviations,
    MeshDuty,
    MeshGeometry,
    MeshQuality,
    PairRating,
    PittingRating,
    RootBody,
    ShaperCutter,
    ToothLoadFactors,
    ToothProportions,
    Treatment,
    bending_rating,
    dynamic_factor,
    mesh_springs,
    pitting_rating,
    rate_mesh,
)
from gearwright.parts.material import BRINELL_PER_VICKERS
from gearwright.parts.micropitting import FilmMesh, Micropitting, OilGrade, film_of_test, micropitting
from gearwright.sizing import size
from gearwright.sizing.rating.iso6336 import Iso6336Rating
from gearwright.spec import parse
from gearwright.validate.case import Case
from gearwright.validate.gears.ratings import PLANET_RING as WIDE_RING

# ----------------------------------------------------------------------------------------------------------------------
# More printed reports of the 5 MW wind turbine: roots and flanks of its second and third stage, micropitting of all.
#
# The third stage is helical. K factors are the printed ones, with their two or three decimals.
# ----------------------------------------------------------------------------------------------------------------------


_SECOND = "KISSsoft 03/2017, NREL 5 MW gearbox, stage 2 (report in the repository gfsReboucas/Drivetrain)"
_THIRD = _SECOND.replace("stage 2", "stage 3")
_FIRST = _SECOND.replace("stage 2", "stage 1")
_MM, _MPA = 1e-3, 1e6
_LIFE = 175_200.0 * 3600.0
_RACK, _RING_RACK = ToothProportions(1.25, 0.38), ToothProportions(1.25, 0.30)
_CASE = GearSteel("18CrNiMo7-6", Treatment.CASE_HARDENED, "MQ", 720.0, 1500 * _MPA, 430 * _MPA)
_TEMPERED = GearSteel(
    "34CrNiMo6", Treatment.THROUGH_HARDENED, "MQ", 240.0 / BRINELL_PER_VICKERS, 700 * _MPA, 290 * _MPA,
    yield_strength=1000 * _MPA,
)  # fmt: skip
_QUALITY = MeshQuality(flank_roughness=4.8e-6, root_roughness=20e-6, viscosity=220e-6)
_PLANET = replace(_RACK, profile_shift=0.5039)
SUN_PLANET = MeshGeometry(
    (18.0, 36.0), 21 * _MM, 550 * _MM, 584 * _MM, (216.419 * _MM, 407.8315 * _MM),
    proportions=(replace(_RACK, profile_shift=0.3890), _PLANET),
)  # fmt: skip
PLANET_RING = MeshGeometry(
    (36.0, -93.0), 21 * _MM, 550 * _MM, 584 * _MM, (407.8315 * _MM, 953.0405 * _MM),
    proportions=(_PLANET, replace(_RING_RACK, cutter=ShaperCutter(30.0), profile_shift=0.1171)),
)  # fmt: skip
HELICAL = MeshGeometry(
    (24.0, 95.0), 14 * _MM, 360 * _MM, 861 * _MM, (0.5 * 380.747 * _MM, 0.5 * 1395.376 * _MM),
    helix_angle=np.radians(10.0),
    proportions=(replace(_RACK, profile_shift=0.48), replace(_RACK, profile_shift=0.6691)),
)  # fmt: skip
_WIDE = MeshGeometry(
    (19.0, 17.0), 45 * _MM, 491 * _MM, 863 * _MM, (489.404 * _MM, 452.735 * _MM),
    proportions=(replace(_RACK, profile_shift=0.617), replace(_RACK, profile_shift=0.8021)),
)  # fmt: skip
"""Sun and planet of the first stage."""
_SPEED, _FAST = (294.5 - 47.8) * RPM, 1165.9 * RPM
"""Of the second sun against its carrier, and of the pinion [rad/s]."""
_TORQUE = 162_105.5 / 3.0
_LOADS = (
    ToothLoadFactors(1.25, 1.1, 1.06, face_contact=2.06, face_bending=1.94),
    ToothLoadFactors(1.25, 1.1, 1.06, face_contact=1.15, face_bending=1.14),
    ToothLoadFactors(1.25, 1.0, 1.092, 1.150, 1.069, 1.136, 1.069),
)
"""As printed, of sun-planet, planet-ring and the helical pair."""
_STEELS = ((_CASE, _CASE), (_CASE, _TEMPERED), (_CASE, _CASE))
_OIL, _THERMAL = OilGrade(220e-6, 19e-6, 890.0), 13.78e3
"""Klüberoil GEM 1-220 N, and the printed B_M of the steel."""


@cache
def _rated() -> tuple[PairRating, PairRating, PairRating]:
    """Return the three meshes, rated by the edition of 2006."""
    sun = MeshDuty(_TORQUE, _SPEED, _LIFE, 1.25, 1.1, (3.0, 1.0))
    planet = MeshDuty(2.0 * _TORQUE, 0.5 * _SPEED, _LIFE, 1.25, 1.1, (1.0, 3.0))
    inner = replace(_QUALITY, mean_stresses=(0.7, 1.0), flank_roughness=(4.8e-6, 8e-6))
    outer = replace(_QUALITY, mean_stresses=(1.0, 0.7))
    edition = Edition.ISO2006
    return (
        rate_mesh(SUN_PLANET, _STEELS[0], sun, quality=outer, edition=edition),
        rate_mesh(PLANET_RING, _STEELS[1], planet, quality=inner, edition=edition),
        rate_mesh(HELICAL, _STEELS[2], MeshDuty(40_953.0, _FAST, _LIFE, 1.25), quality=_QUALITY, edition=edition),
    )


def _roots() -> list[BendingRating]:
    """Return the roots with the printed load factors: sun, planet, planet, ring, pinion, wheel."""
    return [
        bending_rating(
            mesh, gear, steels[gear], specific_load=rated.tangential_force / mesh.face_width, loads=loads,
            strength=rated.root_strength[gear], body=RootBody(edition=Edition.ISO2006),
        )
        for mesh, steels, rated, loads in zip(_MESHES, _STEELS, _rated(), _LOADS, strict=True)
        for gear in (0, 1)
    ]  # fmt: skip


def _flanks() -> list[PittingRating]:
    return [
        pitting_rating(mesh, steels, rated.tangential_force, loads=loads, strengths=rated.contact_strength)
        for mesh, steels, rated, loads in zip(_MESHES, _STEELS, _rated(), _LOADS, strict=True)
    ]


_MESHES = (SUN_PLANET, PLANET_RING, HELICAL)


def _sections() -> list[float]:
    parts = [root.section for root in _roots()]
    return [
        *(float(part.lever) for part in parts), *(float(part.chord) for part in parts),
        *(float(part.fillet_radius) for part in parts), *(float(np.degrees(part.load_angle)) for part in parts),
    ]  # fmt: skip


def _form() -> list[float]:
    parts = [root.section for root in _roots()]
    return [*(float(part.form) for part in parts), *(float(part.stress_correction) for part in parts)]


def _root_stresses() -> list[float]:
    roots = _roots()
    found = [value for root in roots for value in (root.nominal_stress, root.stress, root.permissible)]
    return [float(value) / _MPA for value in found if value is not roots[4].permissible]


def _root_factors() -> list[float]:
    helical = _rated()[2]
    pinion, wheel = helical.root_strength
    strengths = (_rated()[0].root_strength[0], _rated()[1].root_strength[1], pinion, wheel)
    return [
        float(helical.bending[0].helix),
        *(float(own.life) for own in strengths if own is not pinion),
        *(float(value) for own in strengths for value in (own.notch_sensitivity, own.surface, own.size)),
    ]


def _contact() -> list[float]:
    sun, ring, pair = _flanks()
    found = [
        *(value for flank in (sun, ring) for value in (flank.nominal_stress, *flank.stresses, *flank.permissible)),
        pair.nominal_stress, *pair.stresses, pair.permissible[1],
    ]  # fmt: skip
    return [float(value) / _MPA for value in found]


def _contact_factors() -> list[float]:
    helical, (sun, ring, pair) = _flanks()[2].geometry, _rated()
    pinion, wheel = pair.contact_strength
    strengths = (*sun.contact_strength, ring.contact_strength[1], pinion, wheel)
    return [
        float(helical.zone), float(helical.contact_ratio), float(helical.helix),
        *(float(own.life) for own in strengths if own is not pinion),
        *(float(value) for own in strengths for value in (own.lubricant, own.speed, own.roughness)),
        float(ring.contact_strength[1].work_hardening),
    ]  # fmt: skip


def _long_life() -> list[float]:
    """Return Y_NT, σ_FG, Z_NT and σ_HG of the helical pinion, which takes 1.23e10 cycles."""
    pair = _rated()[2]
    root, flank = _roots()[4].permissible, _flanks()[2].permissible[0]
    lives = float(pair.root_strength[0].life), float(pair.contact_strength[0].life)
    return [lives[0], float(root) / _MPA, lives[1], float(flank) / _MPA]


def _films() -> tuple[Micropitting, Micropitting, Micropitting]:
    """Return micropitting of sun and planet of both sets and of the helical pair; suns turn against their carrier."""
    wide = FilmMesh(_WIDE, 779_454.877, 1.25 * 1.1 * 1.05 * 1.15, (47.8 - 12.1) * RPM, 0.6e-6, thermal=_THERMAL)
    sun = FilmMesh(SUN_PLANET, 285_900.438, float(_LOADS[0].contact), _SPEED, 0.6e-6, thermal=_THERMAL)
    pair = FilmMesh(HELICAL, 240_064.4, float(_LOADS[2].contact), _FAST, 0.6e-6, thermal=_THERMAL)
    first, second = (micropitting(mesh, _OIL, 75.0, stage=10.0) for mesh in (wide, sun))
    return first, second, micropitting(pair, _OIL, 80.0, stage=10.0)


def _helical_film() -> Sequence[float]:
    film = _films()[2]
    return film.friction, film.bulk, film.pressure / _MPA, film.thinnest, film.safety


def _set_films() -> Sequence[float]:
    first, second, _ = _films()
    return first.thinnest, first.safety, second.thinnest, second.pressure / _MPA, second.safety


def _ring_film() -> Sequence[float]:
    """Return where the first ring's tip touches the planet, and the friction there; against its carrier."""
    turning = (47.8 - 12.1) * RPM * 19.0 / 17.0
    mesh = FilmMesh(WIDE_RING, 779_454.877, 1.25 * 1.1 * 1.05 * 1.15, turning, 0.825e-6, thermal=_THERMAL)
    film = micropitting(mesh, _OIL, 75.0, stage=10.0)
    touch = float(WIDE_RING.tangent_distance) + 0.5 * float(WIDE_RING.base_diameters[1] * WIDE_RING.tip_tangents[1])
    return 2.0 * float(np.hypot(touch, 0.5 * WIDE_RING.base_diameters[0])) / _MM, film.friction, film.bulk


def _test_film() -> Sequence[float]:
    film = film_of_test(_OIL, 10.0)
    return film, 1.4 * film, float(_OIL.pressure_coefficient(38.0)) * 1e6, float(_OIL.dynamic(85.0)) * 1e3


REPORT_CASES = (
    Case("h_Fe*, s_Fn*, ρ_F*, α_Fen of 6 contacts, stages 2 and 3", f"{_SECOND}; stage 3", "–, °",
         (1.159, 1.225, 0.880, 1.444, 1.004, 1.151, 2.132, 2.271, 2.271, 2.703, 2.227, 2.340,
          0.453, 0.414, 0.414, 0.418, 0.425, 0.385, 25.74, 24.68, 22.21, 18.63, 23.89, 22.20),
         _sections, 2e-3, "half a printed digit of ρ_F*"),
    Case("Y_F and Y_S of 6 contacts, stages 2 and 3", f"{_SECOND}; stage 3", "",
         (1.47, 1.38, 1.01, 1.20, 1.18, 1.24, 2.04, 2.18, 2.48, 2.34, 2.28, 2.35), _form, 7e-3,
         "less than a printed digit", is_relative=False),
    Case("σ_F0, σ_F, σ_FG of 6 contacts, stages 2 and 3, but for σ_FG of the helical pinion",
         f"{_SECOND}; stage 3", "N/mm²",
         (73.95, 209.38, 589.60, 74.21, 210.14, 429.38, 61.98, 102.77, 429.38, 69.12, 114.61, 444.89,
          117.92, 195.64, 127.69, 211.85, 654.72), _root_stresses, 5e-3,
         "K factors of stage 2 have two decimals"),
    Case("Y_β of the helical pair; Y_NT of sun, ring, wheel; Y_δrelT, Y_RrelT, Y_X of sun, ring, pinion, wheel",
         f"{_SECOND}; stage 3", "",
         (0.917, 0.854, 0.883, 0.870, 0.999, 0.957, 0.840, 1.005, 0.957, 0.904, 1.001, 0.957, 0.910,
          1.005, 0.957, 0.910), _root_factors, 6e-4, "half a printed digit", is_relative=False),
    Case("σ_H0, σ_H and σ_HG of both gears, 3 meshes, stages 2 and 3, but for σ_HG of the helical pinion",
         f"{_SECOND}; stage 3", "N/mm²",
         (573.40, 1071.17, 994.13, 1295.42, 1368.61, 312.44, 404.76, 404.76, 1388.39, 732.21,
          570.79, 739.61, 739.61, 1387.31), _contact, 4e-3, "K factors of stage 2 have two decimals"),
    Case("Z_H, Z_ε, Z_β of the helical pair; Z_NT of 4 gears; Z_L, Z_v, Z_R of 5 gears; Z_W of the ring",
         f"{_SECOND}; stage 3", "",
         (2.307, 0.827, 1.008, 0.857, 0.905, 0.901, 0.881, 1.020, 0.982, 1.007, 1.020, 0.982, 1.007,
          1.038, 0.961, 1.026, 1.020, 1.022, 1.007, 1.020, 1.022, 1.007, 1.135), _contact_factors, 6e-4,
         "half a printed digit", is_relative=False),
    Case("Y_NT, σ_FG, Z_NT, σ_HG of the helical pinion at 1.23e10 cycles", _THIRD, "–, N/mm², –, N/mm²",
         (0.850, 637.15, 0.850, 1338.30), _long_life, 6.5e-3,
         "the report stops at 0.85 beyond 1e10 cycles, where the tables of ISO 6336 end; here the line goes on,"
         " 0.4 % and 0.6 % lower at 1.23e10"),
    Case("λ_GFT, λ_GFP, α_38 [1/GPa·1e-3], η at 85 °C: the oil and its test at load stage 10", _THIRD, "–, –, –, mPa s",
         (0.102, 0.143, 0.02162, 25.2), _test_film, 5e-3,
         "half a printed digit; two constants of the rig are of this report"),
    Case("micropitting of the helical pair: μ_m, θ_M, p_dyn, λ_GF,min, S_λ", _THIRD, "–, °C, N/mm², –, –",
         (0.030, 85.0, 1014.701, 1.053, 7.360), _helical_film, 1.5e-3, "μ_m has two digits; K factors three decimals"),
    Case("micropitting of sun and planet: λ_GF,min, S_λ of stage 1; λ_GF,min, p_dyn, S_λ of stage 2",
         f"{_FIRST}; stage 2", "–, –, –, N/mm², –", (0.378, 2.641, 0.536, 784.475, 3.746), _set_films, 1.3e-2,
         "the report takes the power of the sun's absolute speed for θ_M"),
    Case("oil between planet and ring of stage 1: d_y of the planet at the ring's tip, μ_m, θ_M", _FIRST, "mm, –, °C",
         (749.170, 0.040, 78.0), _ring_film, 1e-2, "as of sun and planet, and H_v is the integral for Ohlendorf's"),
)  # fmt: skip
"""Printed roots, flanks and films."""


# ----------------------------------------------------------------------------------------------------------------------
# Printed vibration of the 5 MW wind turbine's second and third stage: masses, stiffness, resonance and K_V.
#
# Both stages are designs with their printed teeth, shifts, bores, relief and load factors, sized as any other.
# ----------------------------------------------------------------------------------------------------------------------


_SECOND_STAGE = "KISSsoft 03/2017, NREL 5 MW gearbox, stage 2 (report in the repository gfsReboucas/Drivetrain)"
_THIRD_STAGE = _SECOND_STAGE.replace("stage 2", "stage 3")
_HEAD = """schema = 1
name = "{name}"
level = "concept"
shafts = ["slow", "fast"]
[motors.motor]
shaft = "slow"
power_kw = 5000
speed_rpm = {speed!r}
[loads.load]
shaft = "fast"
[cases.rated]
motor.power_kw = 5000
[service]
life_h = 175200
application_factor = 1.25
[gears]
material = "18CrNiMo7-6"
rating = "iso6336"
helix_angle_deg = {helix}
mesh_load_factor = {sharing}
[gears.iso6336]
tolerance_class = 6
tip_relief_um = 2
blank_factor = {blank}
"""
SET = (
    _HEAD.format(name="second stage", speed=47.8, helix=0, sharing=1.1, blank=0.862)
    + """[planetaries.set]
sun = "fast"
ring = "ground"
carrier = "slow"
planets = 3
sun_teeth = 18
planet_teeth = 36
ring_teeth = 93
module_mm = 21
face_width_mm = 550
centre_distance_mm = 584
sun_shift = 0.3890
planet_shift = 0.5039
ring_shift = 0.1171
sun_bore_mm = 194.32
planet_bore_mm = 576.96
"""
)
"""The second stage as a design, with a held ring."""
PAIR = (
    _HEAD.format(name="third stage", speed=1165.9 * 24 / 95, helix=10, sharing=1.0, blank=0.898)
    + """[pairs.pair]
pinion = "fast"
wheel = "slow"
pinion_teeth = 24
wheel_teeth = 95
module_mm = 14
face_width_mm = 360
centre_distance_mm = 861
pinion_shift = 0.48
wheel_shift = 0.6691
pinion_bore_mm = 179.10
wheel_bore_mm = 1193.32
"""
)
"""The third stage as a design."""
_DEVIATIONS = MeshDeviations(14.7e-6, 20.4e-6)
"""Printed f_pb and f_fα of the helical wheel by ISO 1328:1995, 15.9 and 22 µm, less what running in takes, 1.2 and 1.6
[m]."""


class Vibrating(NamedTuple):
    """One mesh of the report, as gearwright rates it."""

    mesh: MeshGeometry
    rated: PairRating
    dynamic: DynamicFactor

    @property
    def resonance(self) -> float:
        """Speed of its first gear against the carrier at the main resonance n_E1, ω/N [rad/s]."""
        speed = 2.0 * float(self.rated.speed / self.mesh.pitch_diameters[0])
        return speed / float(self.dynamic.resonance_ratio)

    @property
    def stiffness(self) -> float:
        """c_γα = m_red (ω_E1 z_1)² [N/m²]."""
        return float(self.dynamic.reduced_mass * (self.resonance * self.mesh.teeth[0]) ** 2)


@cache
def sized_meshes() -> tuple[Vibrating, ...]:
    """Return sun and planet, planet and ring, and the helical pair."""
    ratings = [mesh.rating for text in (SET, PAIR) for mesh in size(parse(text)).meshes]
    rated = [rating.factors for rating in ratings if isinstance(rating, Iso6336Rating)]
    return tuple(
        Vibrating(mesh, one, one.dynamic)
        for mesh, one in zip((SUN_PLANET, PLANET_RING, HELICAL), rated, strict=True)
        if isinstance(one.dynamic, DynamicFactor)
    )


def _masses() -> list[float]:
    return [float(mesh.dynamic.reduced_mass) / 1e3 for mesh in sized_meshes()]


def _stiffness() -> list[float]:
    """Return c′ and c_γα of each mesh [N/(mm µm)]."""
    single = [float(mesh.rated.relief.stiffness) / 1e9 for mesh in sized_meshes()]
    return [*single, *(mesh.stiffness / 1e9 for mesh in sized_meshes())]


def _resonances() -> list[float]:
    return [mesh.resonance / RPM for mesh in sized_meshes()]


def _ratios() -> list[float]:
    return [float(mesh.dynamic.resonance_ratio) for mesh in sized_meshes()]


def _factors() -> list[float]:
    """Return K_V of both meshes of the second stage, and the larger that counts for the planet."""
    sun, ring = (float(mesh.dynamic.factor) for mesh in sized_meshes()[:2])
    return [sun, ring, max(sun, ring)]


def _of_pair() -> list[float]:
    return [float(sized_meshes()[2].dynamic.factor)]


def _of_printed_deviations() -> list[float]:
    pair = sized_meshes()[2]
    load = float(pair.rated.tangential_force / pair.mesh.face_width) * 1.25
    found = dynamic_factor(
        pair.mesh, mesh_springs(pair.mesh, load, blank=0.898), _DEVIATIONS, specific_load=load,
        pinion_speed=1165.9 * RPM, masses=(pair.dynamic.reduced_mass,),
    )  # fmt: skip
    return [float(found.factor)]


DYNAMICS_CASES = (
    Case("m_red of sun and 3 planets, planet and held ring, bored helical pair", f"{_SECOND_STAGE}; stage 3", "kg/mm",
         (0.1534, 1.4684, 0.36503), _masses, 2e-4, "half a printed digit"),
    Case("c′, then c_γα, of sun and planet, planet and ring, helical pair; C_R as printed", f"{_SECOND_STAGE}; stage 3",
         "N/(mm µm)", (12.240, 14.053, 13.832, 15.640, 20.563, 18.632), _stiffness, 6e-4, "C_R has three digits"),
    Case("n_E1 of sun and planet, planet and held ring, helical pair", f"{_SECOND_STAGE}; stage 3", "1/min",
         (5357.0, 993.0, 2843.0), _resonances, 8e-4, "three digits of C_R and of 993"),
    Case("N of sun and planet, planet and held ring, helical pair", f"{_SECOND_STAGE}; stage 3", "–",
         (0.046, 0.124, 0.410), _ratios, 5e-4, "half a printed digit", is_relative=False),
    Case("K_V of sun and planet, of planet and held ring, of the set", _SECOND_STAGE, "–", (1.02, 1.06, 1.06),
    _factors, 5e-3,
         "half a printed digit", is_relative=False),
    Case("K_V of the bored helical pair, class 6", _THIRD_STAGE, "–", (1.092,), _of_pair, 6e-3,
         "f_fα of class 6 is 18 µm by ISO 1328-1:2013, 22 µm by the edition of 1995"),
    Case("K_V of the bored helical pair with its printed deviations", _THIRD_STAGE, "–", (1.092,),
    _of_printed_deviations,
         1e-3, "deviations are printed to 0.1 µm", is_relative=False),
)  # fmt: skip
"""Printed vibration of teeth."""
