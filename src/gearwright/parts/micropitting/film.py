"""The oil film at seven points of the path of contact, by ISO/TS 6336-22, method B (ISO/TR 15144-1:2014)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import Problem, refuse
from gearwright.parts.iso6336 import MeshGeometry
from gearwright.parts.losses import tooth_loss_factor
from gearwright.parts.material import STEEL_MODULUS, STEEL_POISSON
from gearwright.parts.micropitting.lubricant import OilGrade

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
