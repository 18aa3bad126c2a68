"""Pitting and load factors of bevel gears by ISO 10300-1 and -2:2023, method B1, without hypoid offset."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from gearwright.errors import Problem, refuse
from gearwright.parts.bevel.geometry import BevelPair
from gearwright.parts.bevel.virtual import VirtualPair
from gearwright.parts.iso6336 import (
    GearSteel,
    LoadFactors,
    elasticity_factor,
    lubricant_factor,
    roughness_factor,
    speed_factor,
)
from gearwright.parts.stiffness import modulus_factor
from gearwright.units import Origin, Quantity

_PART1, _PART2 = "ISO 10300-1:2023", "ISO 10300-2:2023"
BEVEL_FACTOR = 1.2
"""Bevel gear factor Z_KP [-] (ISO 10300-2:2023, eq. 11)."""
STRADDLE, ONE_OVERHUNG, BOTH_OVERHUNG = 1.05, 1.10, 1.25
"""Mounting factor K_Hβ-be with the contact pattern checked under light load [-] (ISO 10300-1, table 4)."""
_STIFFNESS = 20e9  # N/m², mean mesh stiffness c_γ0 (ISO 10300-1, 7.7)
_SINGLE_STIFFNESS = 14e9  # N/m², c′_0
_STEEL = 210e9  # Pa, E of the steel for which both are printed (ISO/TR 10300-30, sample 1)
_FULL_LOAD = 100e3  # N/m
_MICRON = 1e-6


@dataclass(frozen=True)
class BevelDuty:
    """What the mesh carries and how it is made."""

    pinion_torque: float
    """T_1 [N m]."""
    pinion_speed: float
    """ω_1 [rad/s]."""
    pitch_deviation: float
    """Single pitch deviation of the wheel f_pt [m]."""
    application_factor: float = 1.0
    """K_A [-]."""
    mounting: float = ONE_OVERHUNG
    """K_Hβ-be [-]."""
    cutter_radius: float = math.inf
    """Cutter radius r_c0 [m]; matters below the mean cone distance."""

    def __post_init__(self) -> None:
        refuse(
            Problem(name, f"{value:.6g} given; must be above 0")
            for name, value in (
                ("pinion_torque", self.pinion_torque),
                ("pinion_speed", abs(self.pinion_speed)),
                ("pitch_deviation", self.pitch_deviation),
                ("application_factor", self.application_factor),
                ("mounting", self.mounting),
                ("cutter_radius", self.cutter_radius),
            )
            if not value > 0.0
        )


@dataclass(frozen=True)
class BevelDynamics:
    """K_V of a bevel pair and what it is made of."""

    reduced_mass: Annotated[float, Quantity("mass_per_length"), Origin("m_red", f"{_PART1}, eq. 10")]
    """Reduced mass per face width m_red [kg/m]."""
    resonance_ratio: Annotated[float, Quantity("ratio"), Origin("N = n_1/n_E1", f"{_PART1}, eq. 8")]
    """Reference speed N [-]."""
    pitch_deviation: Annotated[float, Quantity("length"), Origin("f_p,eff = f_pt − y_α", f"{_PART1}, eq. 17")]
    """Effective pitch deviation [m]."""
    factor: Annotated[float, Quantity("ratio"), Origin("K_V-B", f"{_PART1}, eqs 15 to 21")]
    """Dynamic factor K_V [-]."""


@dataclass(frozen=True)
class BevelPitting:
    """Contact stress and its limit for both gears."""

    mid_zone: Annotated[float, Quantity("ratio"), Origin("Z_M-B", f"{_PART2}, eq. 6")]
    """Mid-zone factor Z_M-B [-]."""
    load_sharing: Annotated[float, Quantity("ratio"), Origin("Z_LS", f"{_PART2}, eq. 10")]
    """Load sharing factor Z_LS [-]."""
    elasticity: Annotated[float, Quantity("elasticity_factor"), Origin("Z_E", f"{_PART2}, eq. 51")]
    """Elasticity factor Z_E [√Pa]."""
    film: Annotated[tuple[float, float, float], Quantity("ratio"), Origin("Z_L, Z_v, Z_R", f"{_PART2}, eqs 54 to 60")]
    """Z_L, Z_v, Z_R [-]."""
    nominal_stress: Annotated[
        float, Quantity("stress"), Origin("σ_H0 = √(F_n/(l_bm ρ_rel)) Z_M-B Z_LS Z_E", f"{_PART2}, eq. 2")
    ]
    """Nominal contact stress σ_H0 [Pa]."""
    stress: Annotated[float, Quantity("stress"), Origin("σ_H = σ_H0 √(K_A K_V K_Hβ K_Hα)", f"{_PART2}, eq. 1")]
    """Contact stress σ_H [Pa]."""
    permissible: Annotated[
        tuple[float, float],
        Quantity("stress"),
        Origin("σ_HP = σ_Hlim Z_NT Z_X Z_L Z_v Z_R Z_W Z_KP; Z_X = Z_W = 1, Z_KP = 1.2", f"{_PART2}, eq. 4"),
    ]
    """Permissible contact stress of pinion and wheel σ_HP [Pa]."""
    safeties: Annotated[tuple[float, float], Quantity("ratio"), Origin("S_H = σ_HP/σ_H", f"{_PART2}, eq. 5")]
    """S_H of pinion and wheel [-]."""


def virtual_force(pair: BevelPair, duty: BevelDuty) -> float:
    """Return the tangential force at the mean cone F_mt = F_vmt [N].

    Args:
        pair: The pair.
        duty: Torque.

    Source: ISO 10300-1:2023, eqs 1 and 2; the two are equal without offset.
    """
    return 2.0 * duty.pinion_torque / pair.mean_diameters[0]


def bevel_dynamics(virtual: VirtualPair, duty: BevelDuty, steels: tuple[GearSteel, GearSteel]) -> BevelDynamics:
    """Return K_V by method B.

    Args:
        virtual: The virtual pair.
        duty: Load, speed, deviation.
        steels: Of pinion and wheel, for their mass and stiffness.

    Source: ISO 10300-1:2023, clause 7.7.3, stiffness 14 and 20 N/(mm µm) E/E_St, y_α = 0.075 f_pt ≤ 3 µm of
        hard flanks.
    """
    pair = virtual.bevel
    specific = virtual_force(pair, duty) * duty.application_factor / virtual.effective_width
    soft = _softness(specific, steels)
    masses = [
        math.pi / 8.0 * steel.density * (d / math.cos(pair.pressure_angle)) ** 2
        for d, steel in zip(pair.mean_diameters, steels, strict=True)
    ]
    reduced = masses[0] * masses[1] / (masses[0] + masses[1])
    ratio = abs(duty.pinion_speed) * pair.teeth[0] / math.sqrt(_STIFFNESS * soft / reduced)
    deviation = duty.pitch_deviation - min(0.075 * duty.pitch_deviation, 3.0 * _MICRON)
    error = _SINGLE_STIFFNESS * soft * deviation / specific
    return BevelDynamics(reduced, ratio, deviation, _by_region(ratio, error, virtual.total_ratio))


def _softness(specific_load: float, steels: tuple[GearSteel, GearSteel]) -> float:
    """Stiffness over that of fully loaded teeth of steel [-]."""
    moduli = (steels[0].elastic_modulus, steels[1].elastic_modulus)
    return min(1.0, specific_load / _FULL_LOAD) * modulus_factor(moduli, _STEEL)


def _by_region(ratio: float, error: float, overlap: float) -> float:
    """K_V below, in, between and above the main resonance (eqs 15 to 21)."""
    if overlap <= 2.0:
        c_12, c_3, c_4, c_56 = 0.66, 0.23, 0.90, 0.94
    else:
        c_12, c_3 = 0.32 + 0.57 / (overlap - 0.3), 0.096 / (overlap - 1.56)
        c_4, c_56 = (0.57 - 0.05 * overlap) / (overlap - 1.44), 0.47 + 0.12 / (overlap - 1.74)
    middle = 0.125 * math.sin(math.pi * overlap) + 0.875  # ε_vγ − 2 in the standard: a whole turn less
    c_7 = 0.75 if overlap <= 1.5 else middle if overlap <= 2.5 else 1.0
    resonant, above = c_12 * error + c_4 + 1.0, c_56 * error + c_7
    if ratio <= 0.75:
        return ratio * (c_12 * error + c_3) + 1.0
    if ratio <= 1.25:
        return resonant
    return above if ratio >= 1.5 else above + (resonant - above) * (1.5 - ratio) / 0.25


def bevel_load_factors(
    virtual: VirtualPair, duty: BevelDuty, steels: tuple[GearSteel, GearSteel]
) -> tuple[LoadFactors, BevelDynamics]:
    """Return the K factors of a bevel pair.

    Args:
        virtual: The virtual pair.
        duty: Load, speed, deviation, mounting, cutter.
        steels: Of pinion and wheel.

    Source: ISO 10300-1:2023, clauses 7 (K_V method B), 8 (K_Hβ = 1.5 K_Hβ-be, K_Fβ = K_Hβ/K_F0) and 9 (K_Hα method B).
    """
    pair = virtual.bevel
    dynamic = bevel_dynamics(virtual, duty, steels)
    face = 1.5 * duty.mounting
    force = virtual_force(pair, duty) * duty.application_factor
    stiffness = _STIFFNESS * _softness(force / virtual.effective_width, steels)
    error = stiffness * dynamic.pitch_deviation * pair.face_width / (force * dynamic.factor * face)
    total = virtual.total_ratio
    if total <= 2.0:
        share = 0.5 * total * (0.9 + 0.4 * error)
    else:
        share = 0.9 + 0.4 * math.sqrt(2.0 * (total - 1.0) / total) * error
    alpha = max(1.0, share)
    factors = LoadFactors(
        duty.application_factor, 1.0, dynamic.factor, face, alpha, face / _lengthwise_curvature(pair, duty), alpha
    )
    return factors, dynamic


def _lengthwise_curvature(pair: BevelPair, duty: BevelDuty) -> float:
    """K_F0 (eqs 33 to 35): 1 for straight teeth and large cutters, else 1 to 1.15."""
    ratio = duty.cutter_radius / pair.mean_cone_distance
    if pair.spiral_angle == 0.0 or ratio > 1.0:
        return 1.0
    exponent = 0.279 / math.log10(math.sin(pair.spiral_angle))
    return min(max(0.211 * math.exp(exponent * math.log(ratio)) + 0.789, 1.0), 1.15)


def mid_zone_factor(virtual: VirtualPair) -> float:
    """Return the mid-zone factor Z_M-B.

    Args:
        virtual: The virtual pair.

    Source: ISO 10300-2:2023, eq. 6 and table 4.
    """
    alpha, beta = virtual.profile_ratio, min(virtual.face_ratio, 1.0)
    first = 2.0 + (alpha - 2.0) * beta
    second = 2.0 * alpha - 2.0 + (2.0 - alpha) * beta
    product = 1.0
    for tip, base, teeth, turns in zip(
        virtual.tip_diameters, virtual.base_diameters, virtual.teeth, (first, second), strict=True
    ):
        product *= math.sqrt((tip / base) ** 2 - 1.0) - turns * math.pi / teeth
    return math.tan(virtual.transverse_angle) / math.sqrt(product)


def bevel_pitting(
    virtual: VirtualPair,
    steels: tuple[GearSteel, GearSteel],
    duty: BevelDuty,
    *,
    loads: LoadFactors,
    lives: tuple[float, float],
    viscosity: float = 100e-6,
    roughness: float = 8e-6,
) -> BevelPitting:
    """Return contact stress, limit and safety of both gears.

    Args:
        virtual: The virtual pair.
        steels: Of pinion and wheel.
        duty: Torque and speed.
        loads: K factors.
        lives: Z_NT of pinion and wheel [-].
        viscosity: ν_40 of the oil [m²/s].
        roughness: Mean R_z of the flanks [m].

    Source: ISO 10300-2:2023, clause 6, with Z_W = Z_X = Z_Hyp = 1 and Z_KP = 1.2.
    Valid for: ε_vα < 2, no hypoid offset, hardened flanks of about equal hardness.
    """
    pair = virtual.bevel
    force = virtual_force(pair, duty) / (math.cos(pair.pressure_angle) * math.cos(pair.spiral_angle))
    speed = 0.5 * abs(duty.pinion_speed) * pair.mean_diameters[0]
    softer = min(steel.tabulated_strength for steel in steels)
    film = (
        float(lubricant_factor(viscosity, softer)),
        float(speed_factor(speed, softer)),
        float(roughness_factor(roughness, virtual.curvature, softer)),
    )
    mid, sharing, elastic = mid_zone_factor(virtual), virtual.load_sharing, elasticity_factor(steels)
    nominal = math.sqrt(force / (virtual.lines[1].length * virtual.curvature)) * mid * sharing * elastic
    stress = nominal * float(np.sqrt(loads.contact))
    pinion, wheel = (
        steel.contact_strength * life * math.prod(film) * BEVEL_FACTOR
        for steel, life in zip(steels, lives, strict=True)
    )
    return BevelPitting(
        mid, sharing, elastic, film, nominal, stress, (pinion, wheel), (pinion / stress, wheel / stress)
    )
