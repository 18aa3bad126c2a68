"""Micropitting of cylindrical gears by ISO/TS 6336-22, method B: oil film, lubricant and FZG test.

The oil by temperature is in `lubricant`, the film along the path of contact in `film`, the oil's test in `oil_test`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from gearwright.base import RPM, Floats, Origin, Problem, Quantity, refuse
from gearwright.parts.iso6336 import MeshGeometry, Treatment, Value, as_value
from gearwright.parts.losses import oil_viscosity, tooth_loss_factor
from gearwright.parts.material import STEEL_MODULUS, STEEL_POISSON

# ----------------------------------------------------------------------------------------------------------------------
# An oil between flanks: viscosity, density and pressure-viscosity coefficient over temperature (ISO/TS 6336-22).
# ----------------------------------------------------------------------------------------------------------------------


_MM2_S = 1e-6
_KELVIN = 273.0
_AT_38 = 38.0 + _KELVIN


@dataclass(frozen=True)
class OilBase:
    """What the base stock of an oil does to friction and film."""

    lubricant: float
    """X_L in the coefficient of friction [-]."""
    scale: float
    """α_38 of an oil of 1 Pa s [1/Pa]."""
    exponent: float
    """Power of η_38 in α_38 [-]."""


_MINERAL, _PAO, _PAG = (2.657e-8, 0.1348), (1.466e-8, 0.0507), (1.392e-8, 0.1572)
BASES = {
    "mineral": OilBase(1.0, *_MINERAL),
    "polyalphaolefin": OilBase(0.8, *_PAO),
    "polyglycol": OilBase(0.7, *_PAG),
    "water-soluble polyglycol": OilBase(0.6, *_PAG),
    "phosphate ester": OilBase(1.3, *_MINERAL),
    "traction": OilBase(1.5, *_MINERAL),
}
"""Base stock -> X_L (ISO/TS 6336-22, table 3) and α_38 (eqs 9 to 11: mineral, PAO, PAG; others as mineral)."""


@dataclass(frozen=True)
class OilGrade:
    """An oil by two viscosities."""

    viscosity_40: float
    """ν_40 [m²/s]."""
    viscosity_100: float | None = None
    """ν_100 [m²/s]; None: it thins as a turbine oil does."""
    density_15: float | None = None
    """ρ_15 [kg/m³]; None: by ν_40."""
    base: OilBase = BASES["mineral"]
    """Base stock."""

    def kinematic(self, temperature: Value) -> Value:
        """Return ν [m²/s].

        Args:
            temperature: Of the oil [°C].

        Source: ISO/TR 15144-1:2014, eqs 17 to 19: lg lg(ν + 0.7) falls straight over lg T.
        """
        hot = self.viscosity_100
        if hot is None:
            hot = self.viscosity_40 * oil_viscosity(373.15) / oil_viscosity(313.15)
        warm, end = (math.log10(math.log10(viscosity / _MM2_S + 0.7)) for viscosity in (self.viscosity_40, hot))
        places = math.log10(40.0 + _KELVIN), math.log10(100.0 + _KELVIN)
        slope = (warm - end) / (places[1] - places[0])
        at = warm - slope * (np.log10(np.asarray(temperature) + _KELVIN) - places[0])
        return as_value((10.0 ** (10.0**at) - 0.7) * _MM2_S)

    def density(self, temperature: Value) -> Value:
        """Return ρ [kg/m³].

        Args:
            temperature: Of the oil [°C].

        Source: ISO/TR 15144-1:2014, eqs 20 and 21: ρ_15 − 0.7 (T − 289 K), ρ_15 = 43.37 lg ν_40 + 805.5 where unknown.
        """
        known = self.density_15
        at_15 = 43.37 * math.log10(self.viscosity_40 / _MM2_S) + 805.5 if known is None else known
        return as_value(at_15 - 0.7 * (np.asarray(temperature) + _KELVIN - 289.0))

    def dynamic(self, temperature: Value) -> Value:
        """Return η [Pa s].

        Args:
            temperature: Of the oil [°C].

        Source: ISO/TR 15144-1:2014, eq. 16.
        """
        return as_value(self.kinematic(temperature) * self.density(temperature))

    def pressure_coefficient(self, temperature: Value) -> Value:
        """Return the pressure-viscosity coefficient α [1/Pa].

        Args:
            temperature: Of the oil [°C].

        Source: ISO/TR 15144-1:2014, eqs 8 to 11: α_38 (1 + 516 (1/T − 1/311 K)).
        """
        at_38 = self.base.scale * float(self.dynamic(38.0)) ** self.base.exponent
        return as_value(at_38 * (1.0 + 516.0 * (1.0 / (np.asarray(temperature) + _KELVIN) - 1.0 / _AT_38)))


# ----------------------------------------------------------------------------------------------------------------------
# The oil film at seven points of the path of contact, by ISO/TS 6336-22, method B (ISO/TR 15144-1:2014).
# ----------------------------------------------------------------------------------------------------------------------


POINTS = ("A", "AB", "B", "C", "D", "DE", "E")
"""Where the film is looked at: ends of contact, of single contact, pitch point, and midway in double contact."""
FINE_CLASS = 6
"""Coarsest flank class of which tip relief cools the mesh [-] (ISO/TR 15144-1:2014, eq. 101)."""
_MM, _MICRON = 1e-3, 1e-6
_CONDUCTIVITY, _DENSITY, _HEAT = 45.0, 7800.0, 440.0
THERMAL = float(np.sqrt(_CONDUCTIVITY * _DENSITY * _HEAT))
"""B_M of steel [N/(m s^½ K)] (ISO/TR 15144-1:2014, table 2)."""


@dataclass(frozen=True)
class FilmMesh:
    """A mesh as its oil film sees it."""

    geometry: MeshGeometry
    """The pair; of an internal one the second flank is hollow, ρ_2 < 0."""
    force: float
    """F_t [N]."""
    load_factor: float
    """K_A K_γ K_V K_Hα K_Hβ [-]."""
    speed: float
    """ω_1 [rad/s]."""
    roughness: float
    """Mean R_a of both flanks [m]."""
    grade: int = 6
    """Flank tolerance class [-]."""
    elastic_modulus: float = STEEL_MODULUS
    """E of both gears [Pa]."""
    poisson_ratio: float = STEEL_POISSON
    """ν of both gears [-]."""
    supply: float = 1.0
    """X_S [-]: 1.2 sprayed, 1 dipping, 0.2 submerged."""
    relief: float = 1.0
    """X_Ca of the bulk temperature [-], from `relief_factor`; 1 without relief."""
    thermal: float = THERMAL
    """Thermal contact coefficient B_M of both gears [N/(m s^½ K)]."""

    def __post_init__(self) -> None:
        values = {"force": self.force, "speed": self.speed, "roughness": self.roughness}
        problems = [
            Problem(name, f"{value:.4g} given; must be above 0") for name, value in values.items() if not value > 0.0
        ]
        if not self.geometry.rolls:
            problems.append(Problem("geometry", "tips that interfere with the mate's root; nothing rolls there"))
        refuse(problems)

    @property
    def modulus(self) -> float:
        """Reduced modulus E_r [Pa] (eq. 6)."""
        return self.elastic_modulus / (1.0 - self.poisson_ratio**2)


@dataclass(frozen=True)
class Film:
    """Temperatures, pressures and film at the seven points, shape (7,) each."""

    friction: float
    """μ_m [-]."""
    loss: float
    """H_v [-]."""
    bulk: float
    """θ_M [°C]."""
    curvature: Floats
    """ρ_n [m]."""
    sharing: Floats
    """X_Y [-]."""
    pressure: Floats
    """p_dyn [Pa]."""
    contact: Floats
    """θ_B [°C]."""
    thickness: Floats
    """h_Y [m]."""

    def relative(self, roughness: float) -> Floats:
        """Return λ_GF,Y = h_Y/R_a [-].

        Args:
            roughness: R_a [m].

        Source: ISO/TR 15144-1:2014, eq. 2.
        """
        return self.thickness / roughness


def film_thickness(mesh: FilmMesh, oil: OilGrade, temperature: float, *, sharing: Floats | None = None) -> Film:
    """Return the film at the seven points.

    Args:
        mesh: The mesh.
        oil: The oil.
        temperature: Of the oil before the mesh [°C].
        sharing: X_Y at the seven points [-]; None: of unmodified profiles.

    Source: ISO/TR 15144-1:2014, eqs 4 to 33 and 79 to 92 (ISO/TS 6336-22:2018 the same): h = 1600 ρ_n G^0.6 U^0.7
        W^−0.13 S^0.22, in N, mm, µm.
    Valid for: pairs of steel, ε_α ≤ 2. Internal ones by signed lengths: the document leaves them open as not yet
        investigated enough, and a ring gives off its heat elsewhere than over a b.
    """
    pair = mesh.geometry
    place = path_places(pair)
    curvature = _curvature(pair, place)
    friction = mean_friction(mesh, oil, temperature)
    loss = _loss(pair)
    bulk = temperature + _bulk_rise(mesh, friction, loss)
    rolling, sliding = _speeds(mesh, place)
    share = load_sharing(pair, mesh.grade, place) if sharing is None else sharing
    angle = np.cos(pair.transverse_angle)
    elastic = np.sqrt(mesh.modulus / (2.0 * np.pi))
    line = mesh.force * share * mesh.load_factor / (pair.face_width * angle)
    pressure = elastic * np.sqrt(line / curvature)
    first, second = _surface_speeds(mesh, place)
    drag = mesh.thermal * (np.sqrt(first) + np.sqrt(second))
    flash = (
        0.5 * np.sqrt(np.pi) * friction * pressure * sliding / drag * np.sqrt(8.0 * curvature * pressure / mesh.modulus)
    )
    contact = bulk + flash
    thickness = _thickness(mesh, oil, bulk, contact=contact, rolling=rolling, curvature=curvature, pressure=pressure)
    return Film(friction, loss, bulk, curvature, share, pressure, contact, thickness)


def _thickness(
    mesh: FilmMesh, oil: OilGrade, bulk: float, *, contact: Floats, rolling: Floats, curvature: Floats, pressure: Floats
) -> Floats:
    """h_Y [m] (eq. 4)."""
    viscous, pressing = oil.dynamic(bulk), oil.pressure_coefficient(bulk)
    material = pressing * mesh.modulus
    speed = viscous * rolling / (2.0 * mesh.modulus * curvature)
    load = 2.0 * np.pi * (pressure / mesh.modulus) ** 2
    # Beyond some 500 °C the coefficient has no meaning: there is no film left.
    sliding = np.maximum(oil.pressure_coefficient(contact) * oil.dynamic(contact) / (pressing * viscous), 0.0)
    # 1600 µm per mm of ρ_n
    return np.asarray(1.6 * curvature * material**0.6 * speed**0.7 * load**-0.13 * sliding**0.22)


def mean_friction(mesh: FilmMesh, oil: OilGrade, temperature: float) -> float:
    """Return the mean coefficient of friction μ_m [-].

    Args:
        mesh: The mesh.
        oil: The oil.
        temperature: Of the oil [°C].

    Source: ISO/TR 15144-1:2014, eqs 86 to 90: 0.045 (K F_bt K_Bγ/(b v_ΣC ρ_nC))^0.2 η^−0.05 X_R X_L, in N, mm, m/s
        and mPa s.
    """
    pair = mesh.geometry
    pitch = np.asarray([path_places(pair)[POINTS.index("C")]])
    curvature = float(_curvature(pair, pitch)[0]) / _MM
    rolling = float(_speeds(mesh, pitch)[0][0])
    line = mesh.load_factor * mesh.force / np.cos(pair.transverse_angle) / (pair.face_width / _MM)
    rough = 2.2 * (mesh.roughness / _MICRON / curvature) ** 0.25
    load = (line * helical_factor(float(pair.total_contact_ratio)) / (rolling * curvature)) ** 0.2
    return float(0.045 * load * (oil.dynamic(temperature) * 1e3) ** -0.05 * rough * oil.base.lubricant)


def relief_factor(pair: MeshGeometry, part: float, grade: int) -> float:
    """Return the tip relief factor X_Ca of the bulk temperature [-].

    Args:
        pair: The pair.
        part: Relief over the deflection that it makes up for C_a/C_eff, at most 1 [-].
        grade: Flank tolerance class [-].

    Source: ISO/TR 15144-1:2014, eqs 100 and 101, as a public program reads them: 1 + 0.24 ε_max + 0.71 ε_max² where the
        relief is adequate and the class 6 or finer, else 1. Between the two straight in C_a/C_eff, as ISO/TS 6336-21
        has it, whose factor is larger there by (1 − C_a/C_eff) (0.06 ε_max + 0.02 ε_max²).
    """
    if grade > FINE_CLASS:
        return 1.0
    longest = max(float(ratio) for ratio in pair.addendum_contact_ratios)
    return 1.0 + part * (0.24 * longest + 0.71 * longest**2)


def helical_factor(total: float) -> float:
    """Return the helical load factor of friction K_Bγ [-].

    Args:
        total: ε_γ [-].

    Source: ISO/TR 15144-1:2014, eqs 88 to 90.
    """
    if total <= 2.0:
        return 1.0
    return 1.3 if total >= 3.5 else 1.0 + 0.2 * float(np.sqrt((total - 2.0) * (5.0 - total)))


def path_places(pair: MeshGeometry) -> Floats:
    """Return the distances of the seven points from A along the path of contact g_Y [m].

    Args:
        pair: The pair.

    Source: ISO/TR 15144-1:2014, eqs 34 to 40.
    """
    start, length = _path(pair)
    pitch = float(pair.base_pitch)
    at_c = 0.5 * float(pair.base_diameters[0]) * float(np.tan(pair.working_angle)) - start
    double = length - pitch
    return np.asarray([0.0, 0.5 * double, double, at_c, pitch, pitch + 0.5 * double, length])


def load_sharing(pair: MeshGeometry, grade: int, place: Floats) -> Floats:
    """Return the load sharing factor X_Y of unmodified profiles [-].

    Args:
        pair: The pair.
        grade: Flank tolerance class [-].
        place: g_Y [m].

    Source: ISO/TR 15144-1:2014, clauses 11.1, 11.3, 11.4, 11.6 and 11.8: spur (Q − 2)/15 and a third more on the way
        to single contact; ε_β ≤ 0.8 the same with X_but, ε_β ≥ 1.2 X_but/ε_α, straight between them.
    """
    length = _path(pair)[1]
    pitch = float(pair.base_pitch)
    double = length - pitch
    base = (max(float(grade), 7.0) - 2.0) / 15.0
    near = np.minimum(place, length - place)
    spur = np.where(near < double * (1.0 - 1e-12), base + near / double / 3.0, 1.0)
    overlap = float(pair.overlap_ratio)
    part = min(max((overlap - 0.8) / 0.4, 0.0), 1.0)
    wide = 1.0 / float(pair.transverse_contact_ratio)
    return np.asarray(((1.0 - part) * spur + part * wide) * _buttressing(pair, near))


def _buttressing(pair: MeshGeometry, near: Floats) -> Floats:
    """X_but: the ends of helical teeth stiffen entry and exit, over 0.2 sin β_b of the distance to the pitch point."""
    reach = (
        0.2 * float(np.sin(pair.base_helix_angle)) * 0.5 * float(pair.base_diameters[0] * np.tan(pair.working_angle))
    )
    if reach < 1e-12:
        return np.ones_like(near)
    return np.asarray(1.0 + 0.3 * min(float(pair.overlap_ratio), 1.0) * np.maximum(1.0 - near / reach, 0.0))


def _path(pair: MeshGeometry) -> tuple[float, float]:
    """T_1A and g_α [m]."""
    ends = [0.5 * float(base * tangent) for base, tangent in zip(pair.base_diameters, pair.tip_tangents, strict=True)]
    start = float(pair.tangent_distance - pair.side * ends[1])
    return start, ends[0] - start


def _radii(pair: MeshGeometry, place: Floats) -> tuple[Floats, Floats]:
    """Radii of curvature of both flanks in the transverse section [m]."""
    first = _path(pair)[0] + place
    return first, float(pair.tangent_distance) - first


def _curvature(pair: MeshGeometry, place: Floats) -> Floats:
    """ρ_n,Y [m] (eqs 41 to 45)."""
    first, second = _radii(pair, place)
    return np.asarray(first * second / (first + second) / np.cos(pair.base_helix_angle))


def _surface_speeds(mesh: FilmMesh, place: Floats) -> tuple[Floats, Floats]:
    """v_r1 and v_r2 [m/s] (eqs 14 and 15)."""
    first, second = _radii(mesh.geometry, place)
    return mesh.speed * first, mesh.speed * second / float(mesh.geometry.ratio)


def _speeds(mesh: FilmMesh, place: Floats) -> tuple[Floats, Floats]:
    """Sum and difference of the surface speeds [m/s]."""
    first, second = _surface_speeds(mesh, place)
    return first + second, np.abs(first - second)


def _bulk_rise(mesh: FilmMesh, friction: float, loss: float) -> float:
    """θ_M − θ_oil [K] (eq. 84): 7400 (P μ_m H_v/(a b))^0.72 X_S/(1.2 X_Ca), in kW and mm."""
    pair = mesh.geometry
    power = mesh.force * mesh.speed * 0.5 * float(pair.pitch_diameters[0]) / 1e3
    area = float(pair.centre_distance * pair.face_width) / _MM**2
    return float(7400.0 * (power * friction * loss / area) ** 0.72 * mesh.supply / (1.2 * mesh.relief))


def _loss(pair: MeshGeometry) -> float:
    """H_v [-] (eqs 91 and 92)."""
    first, second = (float(ratio) for ratio in pair.addendum_contact_ratios)
    teeth = float(pair.teeth[0]), float(pair.teeth[1])
    return tooth_loss_factor(teeth, float(pair.base_helix_angle), approach=second, recess=first)


# ----------------------------------------------------------------------------------------------------------------------
# The film at which an oil lets flanks micropit: the FZG test C-GF/8.3/90 (FVA 54/7) at its failure load stage.
# ----------------------------------------------------------------------------------------------------------------------


STAGES = {5: 70.0, 6: 98.9, 7: 132.5, 8: 171.6, 9: 215.6, 10: 265.1}
"""Load stage -> torque on the pinion of the test [N m] (FVA 54/7)."""
_GEARS = MeshGeometry((16.0, 24.0), 4.5e-3, 14e-3, 91.5e-3, (41.23e-3, 59.18e-3))
"""Gears of type C-GF: m_n 4.5 mm, b 14 mm, d_a 82.46 and 118.36 mm."""
_SPEED, _TEMPERATURE, _ROUGHNESS = 2250.0 * RPM, 90.0, 0.5e-6
_LOAD_FACTOR, _PRESSURE = 1.163, 1.045
"""On the load of friction, and on the line load at A, which the test's gears add [-]: back-reckoned from the bulk and
the contact temperature, 127.7 and 251.7 °C, that a commercial report prints at load stage 10."""
_LINE_LOAD = _PRESSURE * 236.3e3 / 265.1
"""F_bb/b at A over the torque of the pinion [1/m²]: 236.3 N/mm at load stage 10, by the same report."""
MATERIAL = {
    Treatment.CASE_HARDENED: 1.0,
    Treatment.NITRIDED: 1.5,
    Treatment.NITRIDED_THROUGH_HARDENED: 1.5,
    Treatment.NITROCARBURISED: 1.5,
    Treatment.INDUCTION_HARDENED: 0.65,
    Treatment.THROUGH_HARDENED: 0.5,
    Treatment.STRUCTURAL: 0.5,
}
"""Material factor W_W [-] (ISO/TR 15144-1:2014, annex A; case-hardened with up to 25 % austenite)."""


def film_of_test(oil: OilGrade, stage: float) -> float:
    """Return the specific film thickness λ_GFT at which an oil fails the micropitting test [-].

    Args:
        oil: The oil.
        stage: Load stage of its failure, 5 to 10 [-].

    Source: ISO/TR 15144-1:2014, annex A: the film of the test gears at A by method B, R_a 0.5 µm, 90 °C, sprayed with
        X_S = 1.2; between stages straight over their torque.

    Raises:
        DesignError: a load stage that the test does not have.

    >>> round(film_of_test(OilGrade(220e-6, 19e-6, 890.0), 10), 2)
    0.1
    """
    low, high = min(STAGES), max(STAGES)
    refuse(
        [Problem("stage", f"{stage:g} given; FVA 54/7 has stages {low} to {high}")] if not low <= stage <= high else []
    )
    torque = float(np.interp(stage, list(STAGES), list(STAGES.values())))
    force = 2.0 * torque / float(_GEARS.pitch_diameters[0])
    nominal = force / float(np.cos(_GEARS.transverse_angle)) / float(_GEARS.face_width)
    share = np.full(len(path_places(_GEARS)), _LINE_LOAD * torque / nominal / _LOAD_FACTOR)
    mesh = FilmMesh(_GEARS, force, _LOAD_FACTOR, _SPEED, _ROUGHNESS, supply=1.2)
    return float(film_thickness(mesh, oil, _TEMPERATURE, sharing=share).relative(_ROUGHNESS)[0])


def permissible_film(oil: OilGrade, stage: float, treatment: Treatment = Treatment.CASE_HARDENED) -> float:
    """Return the permissible specific film thickness λ_GFP [-].

    Args:
        oil: The oil.
        stage: Load stage at which it fails the micropitting test [-].
        treatment: Of the weaker flank.

    Source: ISO/TR 15144-1:2014, annex A: λ_GFP = 1.4 W_W λ_GFT.
    """
    return 1.4 * MATERIAL[treatment] * film_of_test(oil, stage)


# ----------------------------------------------------------------------------------------------------------------------
# Safety against micropitting by ISO/TS 6336-22, method B.
# ----------------------------------------------------------------------------------------------------------------------


_SOURCE = "ISO/TS 6336-22:2018"


@dataclass(frozen=True)
class Micropitting:
    """The thinnest film of a mesh beside the one that its oil needs."""

    friction: Annotated[float, Quantity("ratio"), Origin("μ_m", f"{_SOURCE}, method B")]
    """Mean coefficient of friction μ_m [-]."""
    tip_relief: Annotated[
        float, Quantity("ratio"), Origin("X_Ca = 1 + C_a/C_eff (0.24 ε_max + 0.71 ε_max²), class ≤ 6", _SOURCE)
    ]
    """Tip relief factor X_Ca [-]."""
    bulk: Annotated[
        float, Quantity("temperature"), Origin("θ_M = θ_oil + 7400 (P μ_m H_v/(a b))^0.72 X_S/(1.2 X_Ca)", _SOURCE)
    ]
    """Bulk temperature θ_M [°C]."""
    films: Annotated[tuple[float, ...], Quantity("ratio"), Origin("λ_GF,Y at A, AB, B, C, D, DE, E", _SOURCE)]
    """Specific film thickness at the seven points [-]."""
    point: str
    """Where the film is thinnest."""
    pressure: Annotated[float, Quantity("stress"), Origin("p_dyn,Y there", _SOURCE)]
    """Contact pressure there [Pa]."""
    contact: Annotated[float, Quantity("temperature"), Origin("θ_B,Y there", _SOURCE)]
    """Contact temperature there [°C]."""
    thinnest: Annotated[float, Quantity("ratio"), Origin("λ_GF,min = h_Y/R_a", _SOURCE)]
    """Least specific film thickness λ_GF,min [-]."""
    permissible: Annotated[float, Quantity("ratio"), Origin("λ_GFP = 1.4 W_W λ_GFT", f"{_SOURCE}, by FZG C-GF/8.3/90")]
    """Permissible specific film thickness λ_GFP [-]."""
    safety: Annotated[float, Quantity("ratio"), Origin("S_λ = λ_GF,min/λ_GFP", _SOURCE)]
    """Safety against micropitting S_λ [-]."""


def micropitting(
    mesh: FilmMesh, oil: OilGrade, temperature: float, *, stage: float, treatment: Treatment = Treatment.CASE_HARDENED
) -> Micropitting:
    """Return the safety against micropitting.

    Args:
        mesh: The mesh.
        oil: The oil.
        temperature: Of the oil before the mesh [°C].
        stage: Load stage at which the oil fails FZG C-GF/8.3/90 [-].
        treatment: Of the weaker flank.

    Source: ISO/TS 6336-22:2018, method B (ISO/TR 15144-1:2014).
    Valid for: ε_α ≤ 2, teeth that share as unmodified ones do; internal pairs for information, see `film_thickness`.
    """
    film = film_thickness(mesh, oil, temperature)
    relative = film.relative(mesh.roughness)
    worst = int(relative.argmin())
    permissible = permissible_film(oil, stage, treatment)
    thinnest = float(relative[worst])
    return Micropitting(
        friction=film.friction,
        tip_relief=mesh.relief,
        bulk=film.bulk,
        films=tuple(float(thickness) for thickness in relative),
        point=POINTS[worst],
        pressure=float(film.pressure[worst]),
        contact=float(film.contact[worst]),
        thinnest=thinnest,
        permissible=permissible,
        safety=thinnest / permissible,
    )
