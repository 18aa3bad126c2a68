"""Scuffing of cylindrical pairs by the integral temperature method (ISO/TS 6336-21)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from gearwright.errors import DesignError, Problem
from gearwright.parts.gears import reduced_modulus
from gearwright.parts.scuffing.flash_temperature import Oil, ScuffingMesh
from gearwright.units import Origin, Quantity

_SOURCE = "ISO/TS 6336-21:2017"
_MM, _MICRON = 1e-3, 1e-6
_WEIGHT = 1.5
"""Weight C_2 of the mean flash temperature against the bulk temperature [-]."""


@dataclass(frozen=True)
class IntegralTemperature:
    """Mean surface temperature and the safety against scuffing."""

    friction: Annotated[float, Quantity("ratio"), Origin("μ_mC", f"{_SOURCE}, eq. 1")]
    """Mean coefficient of friction μ_mC [-]."""
    thermal_flash: Annotated[float, Quantity("number"), Origin("X_M", f"{_SOURCE}, eq. 11")]
    """Thermal flash factor X_M [K N^−¾ s^½ m^−½ mm]; 50 for steel."""
    geometry: Annotated[float, Quantity("ratio"), Origin("X_BE", f"{_SOURCE}, eq. 22")]
    """Geometry factor at the pinion's tip X_BE [-]."""
    approach: Annotated[float, Quantity("ratio"), Origin("X_Q", f"{_SOURCE}, eqs 25 to 29")]
    """Approach factor X_Q [-]."""
    tip_relief: Annotated[float, Quantity("ratio"), Origin("X_Ca", f"{_SOURCE}, eq. 32")]
    """Tip relief factor X_Ca [-]."""
    contact_ratio: Annotated[float, Quantity("ratio"), Origin("X_ε", f"{_SOURCE}, eqs 39 to 44")]
    """Contact ratio factor X_ε [-]."""
    flash_mean: Annotated[float, Quantity("temperature"), Origin("ϑ_flaint = ϑ_flaE X_ε", f"{_SOURCE}, eq. 18")]
    """Mean flash temperature ϑ_flaint [K]."""
    integral: Annotated[float, Quantity("temperature"), Origin("ϑ_int = ϑ_M + 1.5 ϑ_flaint", f"{_SOURCE}, eq. 17")]
    """Integral temperature ϑ_int [°C]."""
    scuffing: Annotated[float, Quantity("temperature"), Origin("ϑ_intS by the FZG test", f"{_SOURCE}, eqs 94 to 97")]
    """Scuffing integral temperature ϑ_intS [°C]."""
    safety: Annotated[float, Quantity("ratio"), Origin("S_intS = ϑ_intS/ϑ_int", f"{_SOURCE}, eq. 14")]
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
    load = (_helical_factor(float(pair.total_contact_ratio)) * mesh.specific_load * _MM) ** 0.75
    flash = friction * elastic * geometry * _angle_factor(mesh) * load * np.sqrt(mesh.speed)
    flash *= (pair.centre_distance / _MM) ** -0.25 / (approach * relief)
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
    curvature = pair.relative_curvature / np.cos(pair.base_helix_angle) / _MM
    load = max(mesh.specific_load * _MM, 150.0) * _helical_factor(float(pair.total_contact_ratio))
    rough = 2.2 * (mesh.roughness / _MICRON / curvature) ** 0.25
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
    chosen = mesh.reliefs[0] if first > 1.5 * second else mesh.reliefs[1]
    return min(chosen, needed) / needed


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
