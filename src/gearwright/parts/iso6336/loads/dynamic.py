"""Dynamic factor K_V of ISO 6336-1 by method B: a single-mass model of the mesh, in four regions of speed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from gearwright.parts.iso6336.geometry import MeshGeometry, Value, as_value
from gearwright.parts.iso6336.loads.stiffness import MeshSprings
from gearwright.parts.iso6336.steels import GearSteel
from gearwright.units import Origin, Quantity

_PART1 = "ISO 6336-1:2019"
_UNIT_LOAD = 100e3  # N/m, the specific load below which the resonance region widens
_MICRON = 1e-6
_MPA = 1e6


@dataclass(frozen=True)
class MeshDeviations:
    """What the teeth deviate by once run in, and their relief."""

    base_pitch: Annotated[Value, Quantity("length"), Origin("f_pb,eff = f_pb − y_p", f"{_PART1}, 6.5")]
    """Effective base pitch deviation [m]."""
    profile: Annotated[Value, Quantity("length"), Origin("f_fα,eff = f_fα − y_f", f"{_PART1}, 6.5")]
    """Effective profile form deviation [m]."""
    tip_relief: Annotated[Value, Quantity("length"), Origin("C_a, or C_ay by running in", f"{_PART1}, 6.5")] = 0.0
    """Tip relief C_a [m]; zero makes B_k = 1."""


@dataclass(frozen=True)
class DynamicFactor:
    """K_V with what it is made of."""

    reduced_mass: Annotated[
        Value, Quantity("mass_per_length"), Origin("m_red = m*_1 m*_2/(m*_1 + m*_2)", f"{_PART1}, 6.5.3")
    ]
    """Reduced mass of the pair per face width m_red [kg/m]."""
    resonance_ratio: Annotated[Value, Quantity("ratio"), Origin("N = n_1/n_E1", f"{_PART1}, 6.5.3")]
    """Reference speed N [-]; 1 is the main resonance."""
    pitch_term: Annotated[Value, Quantity("ratio"), Origin("B_p = c′ f_pb,eff b/(F_t K_A)", f"{_PART1}, 6.5.4")]
    """Effect of pitch deviation B_p [-]."""
    profile_term: Annotated[Value, Quantity("ratio"), Origin("B_f = c′ f_fα,eff b/(F_t K_A)", f"{_PART1}, 6.5.4")]
    """Effect of profile deviation B_f [-]."""
    relief_term: Annotated[Value, Quantity("ratio"), Origin("B_k = |1 − c′ C_a b/(F_t K_A)|", f"{_PART1}, 6.5.4")]
    """Effect of tip relief B_k [-]."""
    factor: Annotated[Value, Quantity("ratio"), Origin("K_V by region of N", f"{_PART1}, 6.5.4 to 6.5.7")]
    """Dynamic factor K_V [-]."""


def running_in_allowance(deviation: Value, steel: GearSteel, speed: Value) -> Value:
    """Return by how much running in lessens a pitch or profile deviation.

    Args:
        deviation: f_pb or f_fα [m].
        steel: Of the gear; of two different ones, average the two results.
        speed: Pitch-line velocity v [m/s].

    Returns:
        y_α (y_p, y_f) [m].

    Source: ISO 6336-1:2019, clause 8.3.6: 0.075 f ≤ 3 µm for surface-hardened, 0.275 f ≤ 22 or 11 µm from 5 and 10 m/s
        for grey and ferritic nodular iron, 160/σ_Hlim f for others.
    """
    if steel.treatment.is_brittle_iron:
        most = np.where(np.asarray(speed) <= 5.0, np.inf, np.where(np.asarray(speed) <= 10.0, 22.0, 11.0))
        return np.minimum(0.275 * deviation, most * _MICRON)
    if steel.treatment.is_surface_hardened:
        return np.minimum(0.075 * deviation, 3.0 * _MICRON)
    strength = steel.tabulated_strength / _MPA
    limit = np.where(np.asarray(speed) <= 5.0, np.inf, np.where(np.asarray(speed) <= 10.0, 12800.0, 6400.0))
    return np.minimum(160.0 / strength * deviation, limit / strength * _MICRON)


def reduced_mass(
    mesh: MeshGeometry, densities: tuple[float, float], *, bore_ratios: tuple[Value, Value] = (0.0, 0.0)
) -> Value:
    """Return the mass of a pair that moves along its line of action, per face width.

    Args:
        mesh: The pair.
        densities: ρ_1 and ρ_2 [kg/m³].
        bore_ratios: Inner diameter of the rim over the mean diameter, q_1 and q_2 [-]; 0 for solid gears.

    Returns:
        m_red [kg/m].

    Source: ISO 6336-1:2006, clause 6.5.9: m* = π/8 ρ d_m² (d_m/d_b)² (1 − q⁴), d_m = (d_a + d_f)/2. A wheel that is
        held (ring) has m* = ∞: give q < 1 and a great density.
    """
    masses = []
    for gear, (density, bore) in enumerate(zip(densities, bore_ratios, strict=True)):
        sign = 1.0 if gear == 0 else mesh.side
        mean = 2.0 * mesh.tip_radii[gear] - sign * mesh.tooth_heights[gear]
        masses.append(np.pi / 8.0 * density * mean**4 / mesh.base_diameters[gear] ** 2 * (1.0 - bore**4))
    return masses[0] * masses[1] / (masses[0] + masses[1])


def dynamic_factor(
    mesh: MeshGeometry,
    springs: MeshSprings,
    deviations: MeshDeviations,
    *,
    specific_load: Value,
    pinion_speed: Value,
    mass: Value,
) -> DynamicFactor:
    """Return K_V of a mesh by method B.

    Args:
        mesh: The pair.
        springs: c′ and c_γα of the mesh.
        deviations: Effective deviations and relief.
        specific_load: F_t K_A K_γ / b [N/m].
        pinion_speed: ω_1 relative to the carrier [rad/s].
        mass: m_red [kg/m].

    Source: ISO 6336-1:2019, clause 6.5 (2006: 6.5), tables of C_v1 to C_v7.
    Valid for: v z_1/100 √(u²/(1 + u²)) ≥ 3 m/s; below, K_V by method B is small and safe to use.

    >>> mesh = MeshGeometry((20, 60), 2e-3, 0.02, 0.08, (0.022, 0.062))
    >>> light = MeshDeviations(0.0, 0.0, 0.0)
    >>> springs = MeshSprings(14e9, 20e9, 17e9)
    >>> k = dynamic_factor(mesh, springs, light, specific_load=2e5, pinion_speed=100.0, mass=0.2)
    >>> round(float(k.factor), 4)
    1.0015
    """
    ratio = pinion_speed * mesh.teeth[0] / np.sqrt(springs.mesh / mass)
    pitch = springs.single * deviations.base_pitch / specific_load
    profile = springs.single * deviations.profile / specific_load
    relief = np.abs(1.0 - springs.single * deviations.tip_relief / specific_load)
    factor = _by_region(ratio, mesh.total_contact_ratio, specific_load, pitch=pitch, profile=profile, relief=relief)
    return DynamicFactor(mass, ratio, pitch, profile, relief, factor)


def _by_region(
    ratio: Value, overlap: Value, specific_load: Value, *, pitch: Value, profile: Value, relief: Value
) -> Value:
    """K_V below, in, above and between the main resonance."""
    c_2, c_3, c_4, c_6, c_7 = _coefficients(np.asarray(overlap, dtype=float))
    lower = np.where(
        np.asarray(specific_load) < _UNIT_LOAD, 0.5 + 0.35 * np.sqrt(np.asarray(specific_load) / _UNIT_LOAD), 0.85
    )
    resonant = 0.32 * pitch + c_2 * profile + c_4 * relief + 1.0
    above = 0.47 * pitch + c_6 * profile + c_7
    below = ratio * (0.32 * pitch + c_2 * profile + c_3 * relief) + 1.0
    between = above + (resonant - above) * (1.5 - ratio) / 0.35
    regions = [np.asarray(ratio) <= lower, np.asarray(ratio) <= 1.15, np.asarray(ratio) < 1.5]
    return as_value(np.select(regions, [below, resonant, between], above))


def _coefficients(overlap: np.ndarray[tuple[int, ...], np.dtype[np.float64]]) -> tuple[Value, ...]:
    """C_v2, C_v3, C_v4, C_v6, C_v7 over ε_γ."""
    high = np.maximum(overlap, 2.0)
    spur = overlap <= 2.0
    middle = 0.125 * np.sin(np.pi * overlap) + 0.875  # ε_γ − 2 in the standard: a whole turn less
    return (
        np.where(spur, 0.34, 0.57 / (high - 0.3)),
        np.where(spur, 0.23, 0.096 / (high - 1.56)),
        np.where(spur, 0.90, (0.57 - 0.05 * high) / (high - 1.44)),
        np.where(spur, 0.47, 0.12 / (high - 1.74)),
        np.select([overlap <= 1.5, overlap <= 2.5], [0.75, middle], 1.0),
    )


def mean_allowance(deviation: Value, steels: tuple[GearSteel, GearSteel], speed: Value) -> Value:
    """Return the running-in allowance of a pair, the mean of its two gears'.

    Args:
        deviation: f_pb or f_fα, the greater of the two gears [m].
        steels: Of the two gears.
        speed: v [m/s].

    Source: ISO 6336-1:2019, clause 8.3.6.
    """
    return 0.5 * (running_in_allowance(deviation, steels[0], speed) + running_in_allowance(deviation, steels[1], speed))
