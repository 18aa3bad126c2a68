"""Scuffing of cylindrical pairs by flash and by integral temperature (ISO/TS 6336-20 and -21).

Pitting and bending are in `iso6336`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from typing import Annotated

import numpy as np

from gearwright.base import DesignError, Floats, Origin, Problem, Quantity, refuse
from gearwright.parts.gears import reduced_modulus
from gearwright.parts.iso6336 import MeshGeometry, Value
from gearwright.parts.material import STEEL_MODULUS, STEEL_POISSON

# ----------------------------------------------------------------------------------------------------------------------
# Scuffing of cylindrical pairs: flash temperature (ISO/TS 6336-20) with its load sharing and friction.
#
# Temperatures are in °C and their differences in K. The empirical formulas are in the standard's own units, converted
# inside. The integral temperature method is in `scuffing_integral`.
# ----------------------------------------------------------------------------------------------------------------------


_FLASH_SOURCE = "ISO/TS 6336-20:2017"
_POINTS = 401
_MM, _MICRON = 1e-3, 1e-6
THERMAL_COEFFICIENT = 435.0
"""Thermal contact coefficient B_M of martensitic steel [N/(mm^½ m^½ s^½ K)] (ISO/TS 6336-20, annex A.3)."""
SPRAY, DIP, SUBMERGED = 1.2, 1.0, 0.2
"""Lubrication factor X_S of the bulk temperature [-] (ISO/TS 6336-20, eq. 22)."""
AUSTENITIC, CASE_HARDENED_USUAL, PHOSPHATED, COPPER_PLATED, NITRIDED = 0.85, 1.00, 1.25, 1.50, 1.50
"""Structural factor X_W [-]: above average austenite; 10 to 20 % austenite; treated; nitrided (table 2)."""
MINERAL, POLYALPHAOLEFIN, NON_WATER_POLYGLYCOL, WATER_POLYGLYCOL, PHOSPHATE_ESTER = 1.0, 0.8, 0.7, 0.6, 1.3
"""Oil type in the lubricant factor X_L [-] (ISO/TS 6336-20, eq. 27)."""


class FlashEdition(Enum):
    """Whose flash temperature method, which says how roughness enters friction."""

    TR2000 = 0.5
    """ISO/TR 13989-1:2000: X_R = R_a^½."""
    TS2017 = 0.25
    """ISO/TS 6336-20:2017: X_R = R_a^¼."""


@dataclass(frozen=True)
class Oil:
    """The oil at work."""

    temperature: float
    """Oil temperature before the mesh ϑ_oil [°C]."""
    dynamic_viscosity: float
    """η_oil at that temperature [Pa s]."""
    load_stage: float
    """FZG A/8.3/90 load stage at which it scuffs [-]."""
    kind: float = MINERAL
    """Oil type factor [-]."""
    supply: float = DIP
    """X_S [-]."""
    viscosity_40: float = 100e-6
    """ν_40 [m²/s], for the integral method."""
    test_torque: float | None = None
    """On the test's pinion at that load stage [N m], for the integral method; None: 3.726 S_FZG², which is 730.3 at
    stage 14, where a commercial report has 714.2."""


@dataclass(frozen=True)
class ScuffingMesh:
    """A mesh as the scuffing methods see it."""

    geometry: MeshGeometry
    """The pair; of an internal one the second flank is hollow, ρ_2 < 0."""
    specific_load: float
    """w_Bt = K_A K_γ K_V K_Hβ K_Hα F_t/b [N/m]."""
    nominal_load: float
    """K_A K_γ F_t/b [N/m], for the tip relief that the deflection asks for."""
    speed: float
    """Pitch-line velocity v [m/s]."""
    roughness: float
    """Mean R_a of the two new flanks [m]."""
    stiffness: tuple[float, float] = (14e9, 20e9)
    """c′ and c_γ [N/m²]."""
    reliefs: tuple[float, float] = (0.0, 0.0)
    """Tip reliefs C_a1 and C_a2 [m]."""
    grade: int = 6
    """Flank tolerance class [-]."""
    elastic_modulus: float = STEEL_MODULUS
    """E of both gears [Pa]."""
    poisson_ratio: float = STEEL_POISSON
    """ν of both gears [-]."""
    mate: tuple[float, float] | None = None
    """E [Pa] and ν [-] of the second gear where it is of another material."""
    structure: float = CASE_HARDENED_USUAL
    """X_W [-]."""
    mates: float = 1.0
    """Meshes that heat the first gear, such as planets around a sun n_p [-]."""

    @property
    def mating(self) -> float:
        """Multiple mating factor X_mp = (1 + n_p)/2 of the bulk temperature [-] (ISO/TR 13989-1:2000)."""
        return 0.5 * (1.0 + self.mates)

    def __post_init__(self) -> None:
        problems = [
            Problem(name, f"{value:.4g} given; must be above 0")
            for name, value in (
                ("specific_load", self.specific_load),
                ("speed", self.speed),
                ("roughness", self.roughness),
            )
            if not value > 0.0
        ]
        refuse(problems)


@dataclass(frozen=True)
class FlashTemperature:
    """Contact temperature along the path of contact and the safety against scuffing."""

    friction: Annotated[float, Quantity("ratio"), Origin("μ_m", f"{_FLASH_SOURCE}, eq. 25")]
    """Mean coefficient of friction μ_m [-]."""
    thermo_elastic: Annotated[float, Quantity("number"), Origin("X_M", f"{_FLASH_SOURCE}, eq. A.13")]
    """Thermo-elastic factor X_M [K N^−¾ s^½ m^−½ mm]; 50 for steel."""
    place: Floats
    """Parameter Γ along the path of contact [-], shape (n,); 0 at the pitch point."""
    flash: Floats
    """Flash temperature there [K], shape (n,)."""
    bulk: Annotated[float, Quantity("number"), Origin("ϑ_M = ϑ_oil + 0.47 X_S X_mp ϑ_flm", f"{_FLASH_SOURCE}, eq. 22")]
    """Bulk temperature ϑ_M [°C]."""
    contact: Annotated[float, Quantity("number"), Origin("ϑ_B = ϑ_M + ϑ_flmax", f"{_FLASH_SOURCE}, eq. 2")]
    """Greatest contact temperature ϑ_B [°C]."""
    scuffing: Annotated[
        float, Quantity("number"), Origin("ϑ_S = 80 + (0.85 + 1.4 X_W) X_L S_FZG²", f"{_FLASH_SOURCE}, eq. 99")
    ]
    """Scuffing temperature ϑ_S [°C]."""
    safety: Annotated[
        float, Quantity("ratio"), Origin("S_B = (ϑ_S − ϑ_oil)/(ϑ_B − ϑ_oil)", f"{_FLASH_SOURCE}, eq. 100")
    ]
    """S_B [-]."""

    @property
    def margin(self) -> float:
        """ϑ_S − ϑ_B [K]; the standard advises to look at it too, 50 K is comfortable."""
        return self.scuffing - self.contact


def lubricant_factor_scuffing(oil: Oil) -> float:
    """Return the lubricant factor X_L of the flash temperature method [-].

    Args:
        oil: Kind and viscosity.

    Source: ISO/TS 6336-20:2017, eq. 27, kind × η_oil^−0.05 with η in mPa s.
    """
    return oil.kind * float(np.exp(-0.05 * np.log(oil.dynamic_viscosity / 1e-3)))


def thermo_elastic_factor(
    elastic_modulus: float, poisson_ratio: float, mate: tuple[float, float] | None = None
) -> float:
    """Return the thermo-elastic factor X_M [K N^−¾ s^½ m^−½ mm].

    Args:
        elastic_modulus: E of both gears [Pa].
        poisson_ratio: ν of both gears [-].
        mate: E [Pa] and ν [-] of the second gear where it is of another material.

    Source: ISO/TS 6336-20:2017, eqs A.10 and A.13, 1000 E_r^¼/B_M with E_r in N/mm² and B_M of steel.

    >>> round(thermo_elastic_factor(206e9, 0.3), 1)
    50.1
    """
    reduced = reduced_modulus((elastic_modulus, poisson_ratio), mate) / 1e6
    return float(1000.0 * np.sqrt(np.sqrt(reduced)) / THERMAL_COEFFICIENT)


def friction_coefficient(mesh: ScuffingMesh, oil: Oil, edition: FlashEdition = FlashEdition.TS2017) -> float:
    """Return the mean coefficient of friction of the flash temperature method [-].

    Args:
        mesh: The mesh.
        oil: The oil.
        edition: Of the method: X_R = R_a^¼, or R_a^½ before.

    Source: ISO/TS 6336-20:2017, eqs 25 to 28: 0.060 (w_Bt/(v_ΣC ρ_relC))^0.2 X_L X_R, X_R = R_a^¼ in µm, v ≤ 50 m/s;
        ISO/TR 13989-1:2000: X_R = R_a^½.
    """
    sine = np.sin(mesh.geometry.working_angle)
    rolling = 2.0 * min(mesh.speed, 50.0) * sine
    curvature = _relative_radius(mesh.geometry, 0.0) / _MM
    load = (mesh.specific_load * _MM) / (rolling * curvature)
    return float(0.060 * load**0.2 * lubricant_factor_scuffing(oil) * (mesh.roughness / _MICRON) ** edition.value)


def flash_temperature(
    mesh: ScuffingMesh,
    oil: Oil,
    edition: FlashEdition = FlashEdition.TS2017,
    *,
    sharing: Callable[[Floats], Floats] | None = None,
) -> FlashTemperature:
    """Return the contact temperature by the flash temperature method, the pinion driving.

    Args:
        mesh: The mesh.
        oil: The oil.
        edition: Of the method, which says how roughness enters friction.
        sharing: X_Γ of the places Γ, of crowned flanks that fade in and out (X_J = 1) [-]; None: of unmodified ones.

    Source: ISO/TS 6336-20:2017, eqs 1 to 5: ϑ_fl = 2.52 μ_m X_M/50 X_J (X_Γ w_Bt)^¾ √(n_1/60)
        |√ρ_1 − √(ρ_2/u)|/ρ_rel^¼, in N, mm, 1/min.
    Valid for: unmodified profiles or tip relief that enters by X_J, steady load. Internal pairs by signed lengths, with
        z_2, u, a and ρ_2 negative: what slides, rolls and presses is the same involute.

    Raises:
        DesignError: Tips that reach beyond the tangent points of the base circles, where nothing rolls.
    """
    pair = mesh.geometry
    if not pair.rolls:
        refuse([Problem("geometry", "tips that interfere with the mate's root; nothing rolls there")])
    ends = _path_ends(pair)
    place = np.linspace(ends[0], ends[3], _POINTS)
    ratio = pair.ratio
    first, second = (radius / _MM for radius in flank_radii(pair, place))
    relative = first * second / (first + second)
    friction = friction_coefficient(mesh, oil, edition)
    elastic = thermo_elastic_factor(mesh.elastic_modulus, mesh.poisson_ratio, mesh.mate)
    turns = mesh.speed / (np.pi * pair.pitch_diameters[0])
    share = load_sharing(mesh, place) if sharing is None else sharing(place)
    shock = approach_factor(mesh, place) if sharing is None else np.ones_like(place)
    load = (share * mesh.specific_load * _MM) ** 0.75
    geometry = np.abs(np.sqrt(first) - np.sqrt(second / ratio)) / relative**0.25
    flash = 2.52 * friction * elastic / 50.0 * shock * load * np.sqrt(turns) * geometry
    mean = float(np.trapezoid(flash, place) / (place[-1] - place[0]))
    bulk = oil.temperature + 0.47 * oil.supply * mesh.mating * mean
    contact = bulk + float(flash.max())
    limit = 80.0 + (0.85 + 1.4 * mesh.structure) * lubricant_factor_scuffing(oil) * oil.load_stage**2
    safety = (limit - oil.temperature) / (contact - oil.temperature)
    return FlashTemperature(friction, elastic, place, flash, bulk, contact, limit, safety)


def load_sharing(mesh: ScuffingMesh, place: Floats) -> Floats:
    """Return the load sharing factor X_Γ along the path of contact.

    Args:
        mesh: The mesh.
        place: Γ [-], shape (n,).

    Returns:
        X_Γ [-], shape (n,).

    Source: ISO/TS 6336-20:2017, clause 9: eqs 57 to 60 for spur and narrow helical, (Q − 2)/15 and a third more on the
        way to single contact (AGMA 925-A03 the same for Q = 7: 1/3 to 2/3), eq. 76 (1/ε_α) for ε_γ > 2, each with the
        buttressing factor X_but of helical teeth (eqs 49 to 56).
    """
    pair = mesh.geometry
    start, single_start, single_end, end = _path_ends(pair)
    base = (max(float(mesh.grade), 7.0) - 2.0) / 15.0
    # A third of the load comes on the way to B; there the second pair parts and the rest comes at once.
    rise = np.where(place < single_start, base + (place - start) / (single_start - start) / 3.0, np.inf)
    fall = np.where(place > single_end, base + (end - place) / (end - single_end) / 3.0, np.inf)
    spur = np.clip(np.minimum(rise, fall), 0.0, 1.0)
    if pair.helix_angle > 0.0 and pair.total_contact_ratio > 2.0:
        spur = np.full_like(place, 1.0 / pair.transverse_contact_ratio)
    return spur * _buttressing(pair, place, (start, end))


def approach_factor(mesh: ScuffingMesh, place: Floats) -> Floats:
    """Return the approach factor X_J of a driving pinion: shocks where the wheel's tip enters unrelieved.

    Args:
        mesh: The mesh.
        place: Γ [-], shape (n,).

    Source: ISO/TS 6336-20:2017, eqs 45 and 46: 1 + (C_eff − C_a2)/50 µm (−Γ/(Γ_E − Γ_A))³ before the pitch point.
    """
    needed = mesh.nominal_load / np.cos(mesh.geometry.transverse_angle) / mesh.stiffness[1]
    missing = max(float(needed - mesh.reliefs[1]), 0.0) / (50.0 * _MICRON)
    return np.asarray(1.0 + missing * np.maximum(-place / (place[-1] - place[0]), 0.0) ** 3)


def _path_ends(pair: MeshGeometry) -> tuple[float, float, float, float]:
    """Γ at A, B, D and E (eqs 30 to 35)."""
    tangent = np.tan(pair.working_angle)
    start = -pair.ratio * (pair.tip_tangents[1] / tangent - 1.0)
    end = pair.tip_tangents[0] / tangent - 1.0
    pitch = 2.0 * np.pi / (pair.teeth[0] * tangent)
    return float(start), float(end - pitch), float(start + pitch), float(end)


def flank_radii(pair: MeshGeometry, place: Value) -> tuple[Value, Value]:
    """Return the radii of curvature of both flanks in the transverse section [m]; that of a ring is negative.

    Args:
        pair: The pair.
        place: Γ along the path of contact [-], 0 at the pitch point.

    Source: ISO/TS 6336-20:2017, eqs 6 and 7: (1 + Γ)/(1 + u) a sin α_wt and (u − Γ)/(1 + u) a sin α_wt, signed.
    """
    step = pair.tangent_distance / (1.0 + pair.ratio)
    return (1.0 + place) * step, (pair.ratio - place) * step


def _relative_radius(pair: MeshGeometry, place: float) -> Value:
    """ρ_rel in the transverse section [m] (eq. 8)."""
    first, second = flank_radii(pair, place)
    return first * second / (first + second)


def _buttressing(pair: MeshGeometry, place: Floats, ends: tuple[float, float]) -> Floats:
    """X_but: the ends of helical teeth stiffen the entry and exit."""
    width = 0.2 * float(np.sin(pair.base_helix_angle))
    if width < 1e-9:
        return np.ones_like(place)
    peak = 0.3 * min(float(pair.overlap_ratio), 1.0)
    near = np.minimum(place - ends[0], ends[1] - place)
    return np.asarray(1.0 + peak * np.clip(1.0 - near / width, 0.0, 1.0))


# ----------------------------------------------------------------------------------------------------------------------
# Scuffing of cylindrical pairs by the integral temperature method (ISO/TS 6336-21).
# ----------------------------------------------------------------------------------------------------------------------


_INTEGRAL_SOURCE = "ISO/TS 6336-21:2017"
_INTEGRAL_MM, _INTEGRAL_MICRON = 1e-3, 1e-6
_WEIGHT = 1.5
"""Weight C_2 of the mean flash temperature against the bulk temperature [-]."""


@dataclass(frozen=True)
class IntegralTemperature:
    """Mean surface temperature and the safety against scuffing."""

    friction: Annotated[float, Quantity("ratio"), Origin("μ_mC", f"{_INTEGRAL_SOURCE}, eq. 1")]
    """Mean coefficient of friction μ_mC [-]."""
    thermal_flash: Annotated[float, Quantity("number"), Origin("X_M", f"{_INTEGRAL_SOURCE}, eq. 11")]
    """Thermal flash factor X_M [K N^−¾ s^½ m^−½ mm]; 50 for steel."""
    geometry: Annotated[float, Quantity("ratio"), Origin("X_BE", f"{_INTEGRAL_SOURCE}, eq. 22")]
    """Geometry factor at the pinion's tip X_BE [-]."""
    approach: Annotated[float, Quantity("ratio"), Origin("X_Q", f"{_INTEGRAL_SOURCE}, eqs 25 to 29")]
    """Approach factor X_Q [-]."""
    tip_relief: Annotated[float, Quantity("ratio"), Origin("X_Ca", f"{_INTEGRAL_SOURCE}, eq. 32")]
    """Tip relief factor X_Ca [-]."""
    contact_ratio: Annotated[float, Quantity("ratio"), Origin("X_ε", f"{_INTEGRAL_SOURCE}, eqs 39 to 44")]
    """Contact ratio factor X_ε [-]."""
    flash_mean: Annotated[
        float, Quantity("temperature"), Origin("ϑ_flaint = ϑ_flaE X_ε", f"{_INTEGRAL_SOURCE}, eq. 18")
    ]
    """Mean flash temperature ϑ_flaint [K]."""
    integral: Annotated[
        float, Quantity("temperature"), Origin("ϑ_int = ϑ_M + 1.5 ϑ_flaint", f"{_INTEGRAL_SOURCE}, eq. 17")
    ]
    """Integral temperature ϑ_int [°C]."""
    scuffing: Annotated[
        float, Quantity("temperature"), Origin("ϑ_intS by the FZG test", f"{_INTEGRAL_SOURCE}, eqs 94 to 97")
    ]
    """Scuffing integral temperature ϑ_intS [°C]."""
    safety: Annotated[float, Quantity("ratio"), Origin("S_intS = ϑ_intS/ϑ_int", f"{_INTEGRAL_SOURCE}, eq. 14")]
    """S_intS [-]; below 1 high, 1 to 2 some, above 2 low risk."""


def integral_temperature(mesh: ScuffingMesh, oil: Oil) -> IntegralTemperature:
    """Return the integral temperature, the pinion driving and the flanks run in.

    Args:
        mesh: The mesh.
        oil: The oil; its viscosity at 40 °C enters the test temperature.

    Source: ISO/TS 6336-21:2017, clauses 5 and 6.1 (ISO/TR 13989-2:2000).
    Valid for: ε_α below 3, contact on both sides of the pitch point, v from 1 m/s on. Internal pairs by signed lengths.

    Raises:
        DesignError: ε_α of 3 and more.
    """
    pair = mesh.geometry
    friction = friction_coefficient_integral(mesh, oil)
    reduced = reduced_modulus((mesh.elastic_modulus, mesh.poisson_ratio), mesh.mate)
    elastic = float(np.sqrt(1000.0) * (reduced / 1e6) ** 0.25)
    elastic /= np.sqrt(50.0 * 3.8)  # √(λ_M c_v) of case-hardened steel, clause 5.3
    geometry = _geometry_factor(mesh)
    first, second = (float(ratio) for ratio in pair.addendum_contact_ratios)
    approach = float(np.interp(second / first, [1.5, 3.0], [1.0, 0.6]))
    relief = tip_relief_factor(mesh)
    ratio_factor = contact_ratio_factor_integral(first, second)
    load = (_helical_factor(float(pair.total_contact_ratio)) * mesh.specific_load * _INTEGRAL_MM) ** 0.75
    flash = friction * elastic * geometry * _angle_factor(mesh) * load * np.sqrt(mesh.speed)
    flash *= (pair.centre_distance / _INTEGRAL_MM) ** -0.25 / (approach * relief)
    mean = float(flash * ratio_factor)
    integral = oil.temperature + 0.7 * mean * oil.supply * mesh.mating + _WEIGHT * mean
    limit = scuffing_integral_temperature(oil, mesh.structure)
    return IntegralTemperature(
        friction, float(elastic), geometry, approach, relief, ratio_factor, mean, integral, limit, limit / integral
    )


def friction_coefficient_integral(mesh: ScuffingMesh, oil: Oil) -> float:
    """Return the mean coefficient of friction of the integral method [-].

    Args:
        mesh: The mesh.
        oil: The oil.

    Source: ISO/TS 6336-21:2017, eqs 1 to 7: 0.045 (w_Bt K_Bγ/(v_ΣC ρ_redC))^0.2 η^−0.05 X_R X_L with
        X_R = 2.2 (R_a/ρ_redC)^¼; w_Bt at least 150 N/mm, v at most 50 m/s.
    """
    pair = mesh.geometry
    rolling = 2.0 * min(mesh.speed, 50.0) * np.tan(pair.working_angle) * np.cos(pair.transverse_angle)
    curvature = pair.relative_curvature / np.cos(pair.base_helix_angle) / _INTEGRAL_MM
    load = max(mesh.specific_load * _INTEGRAL_MM, 150.0) * _helical_factor(float(pair.total_contact_ratio))
    rough = 2.2 * (mesh.roughness / _INTEGRAL_MICRON / curvature) ** 0.25
    viscosity = (oil.dynamic_viscosity / 1e-3) ** -0.05
    return float(0.045 * (load / (rolling * curvature)) ** 0.2 * viscosity * rough * oil.kind)


def contact_ratio_factor_integral(first: float, second: float) -> float:
    """Return the contact ratio factor X_ε, which takes the flash temperature at the pinion's tip to its mean.

    Args:
        first: Addendum contact ratio of the pinion ε_1 [-].
        second: Addendum contact ratio of the wheel ε_2 [-].

    Source: ISO/TS 6336-21:2017, eqs 39 to 44.

    Raises:
        DesignError: ε_1 + ε_2 of 3 and more.
    """
    total = first + second
    if total >= 3.0:
        raise DesignError([Problem("contact_ratio", f"{total:.3f} given; ISO/TS 6336-21 holds below 3")])
    squares = (first**2, second**2)
    if total < 1.0:
        value = squares[0] + squares[1]
    elif first < 1.0 and second < 1.0:
        value = 0.70 * (squares[0] + squares[1]) - 0.22 * total + 0.52 - 0.60 * first * second
    elif total < 2.0:
        (a, b) = (first, second) if first >= second else (second, first)
        value = 0.18 * a**2 + 0.70 * b**2 + 0.82 * a - 0.52 * b - 0.30 * a * b
    else:
        (a, b) = (first, second) if first >= second else (second, first)
        value = 0.44 * a**2 + 0.59 * b**2 + 0.30 * a - 0.30 * b - 0.15 * a * b
    return value / (2.0 * total * first)


def tip_relief_factor(mesh: ScuffingMesh) -> float:
    """Return the tip relief factor X_Ca; 1 for tolerance classes coarser than 6.

    Args:
        mesh: The mesh.

    Source: ISO/TS 6336-21:2017, eqs 32 to 38: 1 + (0.06 + 0.18 r) ε_max + (0.02 + 0.69 r) ε_max², r = C_a/C_eff ≤ 1.
    """
    if mesh.grade > 6:
        return 1.0
    longest = max(float(ratio) for ratio in mesh.geometry.addendum_contact_ratios)
    part = relieved_part(mesh)
    return 1.0 + (0.06 + 0.18 * part) * longest + (0.02 + 0.69 * part) * longest**2


def relieved_part(mesh: ScuffingMesh) -> float:
    """Return the part of the deflection that tip relief makes up for, C_a/C_eff ≤ 1 [-].

    Args:
        mesh: The mesh.

    Source: ISO/TS 6336-21:2017, eqs 33 to 38: C_eff = F_t K_A K_γ/(b c′), of helical gears with c_γ; C_a of the pinion
        where ε_1 > 1.5 ε_2, else of the wheel.
    """
    first, second = (float(ratio) for ratio in mesh.geometry.addendum_contact_ratios)
    needed = mesh.nominal_load / mesh.stiffness[1 if mesh.geometry.helix_angle > 0.0 else 0]
    return min(mesh.reliefs[0] if first > 1.5 * second else mesh.reliefs[1], needed) / needed


def scuffing_integral_temperature(oil: Oil, structure: float) -> float:
    """Return the scuffing integral temperature of an oil ϑ_intS [°C].

    Args:
        oil: Load stage, kind, viscosity at 40 °C.
        structure: X_W of the gears [-]; the test gears have 1.

    Source: ISO/TS 6336-21:2017, eqs 94 to 97: 80 + 0.23 T X_L + X_WrelT 1.5 · 0.2 T (100/ν_40)^0.02 X_L,
        T = 3.726 S_FZG² N m unless the oil says the torque of its test.
    """
    torque = 3.726 * oil.load_stage**2 if oil.test_torque is None else oil.test_torque
    viscous = float(np.exp(0.02 * np.log(100e-6 / oil.viscosity_40)))
    return 80.0 + 0.23 * torque * oil.kind + structure * _WEIGHT * 0.2 * torque * viscous * oil.kind


def _helical_factor(total: float) -> float:
    """Helical load factor of friction K_Bγ (eq. 5)."""
    if total <= 2.0:
        return 1.0
    return 1.3 if total >= 3.5 else 1.0 + 0.2 * float(np.sqrt((total - 2.0) * (5.0 - total)))


def _angle_factor(mesh: ScuffingMesh) -> float:
    """Angle factor X_αβ, method A (eq. 13)."""
    pair = mesh.geometry
    angles = np.sin(pair.working_angle) * np.cos(pair.pressure_angle) * np.cos(pair.helix_angle)
    return float(1.22 * angles**0.25 / np.sqrt(np.cos(pair.working_angle) * np.cos(pair.transverse_angle)))


def _geometry_factor(mesh: ScuffingMesh) -> float:
    """Geometry factor at the pinion's tip X_BE (eqs 22 to 24); |u + 1| and |ρ_E2| of internal pairs."""
    pair = mesh.geometry
    first = 0.5 * pair.base_diameters[0] * pair.tip_tangents[0]
    second = pair.tangent_distance - first
    difference = np.sqrt(first) - np.sqrt(second / pair.ratio)
    size = np.sqrt(pair.side * (pair.ratio + 1.0))
    return float(0.51 * size * difference / (pair.side * first * second) ** 0.25)
