"""Dynamic factor K_v of ISO 6336-1 by methods B and C, and the mesh stiffness it depends on."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache, reduce
from typing import Annotated, cast

import numpy as np

from gearwright.base import Origin, Quantity
from gearwright.parts.iso6336.geometry import MeshGeometry, Value, as_value, of_form
from gearwright.parts.iso6336.steels import GearSteel
from gearwright.parts.stiffness import LINEAR_LOAD, THEORY_TO_MEASUREMENT, modulus_factor, theoretical_stiffness

# ----------------------------------------------------------------------------------------------------------------------
# Mesh stiffness of ISO 6336-1, method B, over arrays of pairs: what the load factors need of it.
#
# For one pair with its web and rim see `mesh_stiffness_iso6336`; a test holds the two together.
# ----------------------------------------------------------------------------------------------------------------------


_CLAUSE = "ISO 6336-1:2019, clause 9"


@dataclass(frozen=True)
class MeshSprings:
    """Stiffness of the mesh per face width, in the transverse plane along the line of action."""

    single: Annotated[Value, Quantity("number"), Origin("c′ = c′_th C_M C_R C_B cos β", _CLAUSE)]
    """Of one tooth pair c′ [N/m²]."""
    mesh: Annotated[Value, Quantity("number"), Origin("c_γα = c′ (0.75 ε_α + 0.25)", _CLAUSE)]
    """Mean of the mesh c_γα [N/m²]."""
    face: Annotated[Value, Quantity("number"), Origin("c_γβ = 0.85 c_γα", _CLAUSE)]
    """For the face load factor c_γβ [N/m²]."""


def mesh_springs(
    mesh: MeshGeometry,
    specific_load: Value = LINEAR_LOAD,
    *,
    steels: tuple[GearSteel, GearSteel] | None = None,
    blank: float = 1.0,
) -> MeshSprings:
    """Return c′, c_γα and c_γβ of a mesh.

    Args:
        mesh: The pair.
        specific_load: F_t K_A K_γ / b [N/m]; softens the mesh below 100 N/mm.
        steels: Of both gears, for E/E_St; None: of E_St.
        blank: Gear blank factor C_R [-]; 1 of solid and bored gears.

    Source: ISO 6336-1:2006, clause 9; z_n2 = ∞ for an internal wheel; E = 2 E_1 E_2/(E_1 + E_2).
    Valid for: β ≤ 45°, 1.2 < ε_α < 1.9 (higher is taken as it is), −0.5 ≤ x_1 + x_2 ≤ 2; not checked for arrays.
    """
    light = np.minimum(1.0, (specific_load / LINEAR_LOAD) ** 0.25)
    single = _single_stiffness(mesh) * light * blank
    if steels is not None:
        single = single * modulus_factor((steels[0].elastic_modulus, steels[1].elastic_modulus))
    mean = single * (0.75 * mesh.transverse_contact_ratio + 0.25)
    return MeshSprings(single, mean, 0.85 * mean)


@of_form
def _single_stiffness(mesh: MeshGeometry) -> Value:
    """c′ of solid gears of steel under a load from 100 N/mm on."""
    rack = 1.0 + 0.5 * (1.2 - 0.5 * (mesh.proportions[0].dedendum + mesh.proportions[1].dedendum))
    rack = rack * (1.0 - 0.02 * (20.0 - np.degrees(mesh.pressure_angle)))
    return theory_of_mesh(mesh) * THEORY_TO_MEASUREMENT * rack * np.cos(mesh.helix_angle)


@of_form
def theory_of_mesh(mesh: MeshGeometry) -> Value:
    """Return the theoretical single stiffness c′_th of a mesh [N/m²].

    Args:
        mesh: The pair.

    Source: ISO 6336-1:2006, clause 9; z_n2 = ∞ for an internal wheel.
    """
    first, second = mesh.virtual_teeth
    teeth = (first, np.where(np.asarray(mesh.side) > 0, second, np.inf))
    return theory_of(teeth, (mesh.proportions[0].profile_shift, mesh.proportions[1].profile_shift))


def theory_of(teeth: tuple[Value, Value], shifts: tuple[Value, Value]) -> Value:
    """Return the theoretical single stiffness c′_th of pairs of virtual spur gears [N/m²].

    Args:
        teeth: z_n of both [-].
        shifts: x of both [-].

    Source: as `theoretical_stiffness`, whose formula is plain arithmetic, so that arrays pass through it.
    """
    return theoretical_stiffness(cast(tuple[float, float], teeth), cast(tuple[float, float], shifts))


# ----------------------------------------------------------------------------------------------------------------------
# Dynamic factor K_V of ISO 6336-1 by method B: a single-mass model of the mesh, in four regions of speed.
# ----------------------------------------------------------------------------------------------------------------------


_PART1 = "ISO 6336-1:2019"
_UNIT_LOAD = 100e3  # N/m, the specific load below which the resonance region widens
_MICRON = 1e-6
_MPA = 1e6
_THINNEST = 0.99
"""Bore over the mean diameter of a tooth, at most [-]: what is bored further is refused where it is written."""
RESONANCE_ENDS = 1.15
"""Reference speed N at which the main resonance range of a mesh ends [-] (ISO 6336-1:2019, clause 6.5.3)."""


@dataclass(frozen=True)
class MeshDeviations:
    """What the teeth deviate by once run in, and their relief."""

    base_pitch: Annotated[Value, Quantity("length"), Origin("f_pb,eff = f_pb − y_p", f"{_PART1}, 6.5")]
    """Effective base pitch deviation [m]."""
    profile: Annotated[Value, Quantity("length"), Origin("f_fα,eff = f_fα − y_f", f"{_PART1}, 6.5")]
    """Effective profile form deviation [m]."""
    relief_term: Annotated[Value, Quantity("ratio"), Origin("B_k", f"{_PART1}, 6.5.5")] = 1.0
    """What tip relief leaves of the vibration B_k [-], from `relief_term`; 1 without relief."""


@dataclass(frozen=True)
class DynamicFactor:
    """K_V with what it is made of."""

    reduced_mass: Annotated[
        Value, Quantity("mass_per_length"), Origin("1/m_red = p_1/m*_1 + p_2/m*_2", f"{_PART1}, 6.5.3 and 6.5.9")
    ]
    """Reduced mass of the mesh per face width m_red [kg/m], p meshes moving a gear together."""
    resonance_ratio: Annotated[Value, Quantity("ratio"), Origin("N = n_1/n_E1", f"{_PART1}, 6.5.3")]
    """Reference speed N [-]; 1 is the main resonance."""
    pitch_term: Annotated[Value, Quantity("ratio"), Origin("B_p = c′ f_pb,eff b/(F_t K_A)", f"{_PART1}, 6.5.4")]
    """Effect of pitch deviation B_p [-]."""
    profile_term: Annotated[Value, Quantity("ratio"), Origin("B_f = c′ f_fα,eff b/(F_t K_A)", f"{_PART1}, 6.5.4")]
    """Effect of profile deviation B_f [-]."""
    relief_term: Annotated[
        Value, Quantity("ratio"), Origin("B_k = |1 − c′ C_a b/(F_t K_A K_γ)|, worse end", f"{_PART1}, 6.5.5")
    ]
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


@dataclass(frozen=True)
class MovingBody:
    """How one gear of a mesh moves with the teeth."""

    inside: Value | None = None
    """Inner diameter of the body, or of the rim of a webbed one d_i; of a ring its outer diameter [m]. None: a solid
    gear, a ring that stands still."""
    meshes: float = 1.0
    """Equal meshes that move it together: the number of planets on a sun or a ring, of wheels on a split pinion [-]."""
    held: bool = False
    """It stands still, bolted or splined into the housing."""


SOLID = MovingBody()
"""A solid gear with one mate."""


def moving_mass(mesh: MeshGeometry, gear: int, density: float, body: MovingBody = SOLID) -> Value:
    """Return the mass of one gear that moves along the line of action, per face width m* [kg/m].

    Args:
        mesh: The pair.
        gear: 0 the first, 1 the second.
        density: ρ [kg/m³].
        body: Its bore or rim.

    Source: ISO 6336-1:2006, clause 6.5.9: J*/r_b² = π/8 ρ d_m⁴/d_b² (1 − q⁴), d_m = (d_a + d_f)/2, q = d_i/d_m; web and
        hub are left out. A ring has its wall outside: (q⁴ − 1).
    """
    sign = 1.0 if gear == 0 else mesh.side
    mean = 2.0 * mesh.tip_radii[gear] - sign * mesh.tooth_heights[gear]
    wall = mean**4
    if (inside := body.inside) is not None:
        hollow = np.minimum(inside, _THINNEST * mean) if gear == 0 or _external(mesh) else inside
        wall = np.abs(wall - hollow**4)
    return as_value(np.pi / 8.0 * density * wall / mesh.base_diameters[gear] ** 2)


@of_form
def _external(mesh: MeshGeometry) -> bool:
    return bool(np.all(np.asarray(mesh.side) > 0.0))


def reduced_mass(
    mesh: MeshGeometry, densities: tuple[float, float], bodies: tuple[MovingBody, MovingBody] = (SOLID, SOLID)
) -> Value:
    """Return the mass of a mesh that moves along its line of action, per face width.

    A central gear with p equal mates moves like a gear of m*/p: sun and planets, turning rings, split pinions, bull
    gears. A gear that is held moves not at all: planets in a standing ring have m_red = m*.

    Args:
        mesh: The pair.
        densities: ρ_1 and ρ_2 [kg/m³].
        bodies: Bores, mates and hold of both gears.

    Returns:
        m_red [kg/m].

    Source: ISO 6336-1:2006, clause 6.5.9: m*_1 m*_2/(m*_1 + m*_2); sun and p planets m*_s m*_p/(m*_s + p m*_p); the
        other cases are the same rule. Held against a printed report of sun, planets and a bored helical pair.
    """
    first, second = (lightness(mesh, gear, densities[gear], bodies[gear], meshes=1.0) for gear in (0, 1))
    return as_value(1.0 / (first + second))


def lightness(mesh: MeshGeometry, gear: int, density: float, body: MovingBody, *, meshes: float) -> Value:
    """Return what one gear adds to 1/m_red: p/m*, 0 of a gear that is held [m/kg].

    Args:
        mesh: The pair.
        gear: 0 the first, 1 the second.
        density: ρ [kg/m³].
        body: Its bore, mates and hold.
        meshes: Equal meshes that move it, where the body says fewer [-].

    Source: ISO 6336-1:2006, clause 6.5.9.
    """
    if body.held or (body.inside is None and gear == 1 and not _external(mesh)):
        return 0.0
    return as_value(max(body.meshes, meshes) / moving_mass(mesh, gear, density, body))


def idler_masses(first: Value, idler: Value, last: Value) -> tuple[Value, Value]:
    """Return the masses c_γ/ω² of the two vibrations of an idler between two gears, per face width [kg/m].

    Args:
        first: 1/m*_1 of the gear before it [m/kg].
        idler: 1/m*_2 of the idler [m/kg].
        last: 1/m*_3 of the gear behind it [m/kg].

    Source: ISO 6336-1:2006, clause 6.5.9: ω² = (A ± √(A² − 4 B))/2 with A = c/m_1 + 2 c/m_2 + c/m_3 and
        B = c² (m_1 + m_2 + m_3)/(m_1 m_2 m_3), c the mean of both meshes.

    >>> slow, fast = idler_masses(1.0, 1.0, 0.0)  # two equal masses, the second against a wall
    >>> round(float(1.0 / slow), 4), round(float(1.0 / fast), 4)
    (0.382, 2.618)
    """
    total = first + 2.0 * idler + last
    product = first * idler + first * last + idler * last
    root = np.sqrt(np.maximum(total**2 - 4.0 * product, 0.0))
    return as_value((total + root) / (2.0 * product)), as_value(2.0 / (total + root))


def resonance_begins(specific_load: Value) -> Value:
    """Return the reference speed N_S at which the main resonance range of a mesh begins [-]; it ends at 1.15.

    Args:
        specific_load: F_t K_A K_γ / b [N/m].

    Source: ISO 6336-1:2019, clause 6.5.3: 0.85 from 100 N/mm on, 0.5 + 0.35 √(F_t K_A/(100 b)) below.
    """
    light = np.minimum(np.asarray(specific_load) / _UNIT_LOAD, 1.0)
    return as_value(0.5 + 0.35 * np.sqrt(light))


def dynamic_factor(
    mesh: MeshGeometry,
    springs: MeshSprings,
    deviations: MeshDeviations,
    *,
    specific_load: Value,
    pinion_speed: Value,
    masses: tuple[Value, ...],
) -> DynamicFactor:
    """Return K_V of a mesh by method B.

    Args:
        mesh: The pair.
        springs: c′ and c_γα of the mesh.
        deviations: Effective deviations and relief.
        specific_load: F_t K_A K_γ / b [N/m].
        pinion_speed: ω_1 relative to the carrier [rad/s].
        masses: m_red [kg/m]; of a mesh with an idler both, of which that counts which gives the larger K_V.

    Source: ISO 6336-1:2019, clause 6.5 (2006: 6.5), tables of C_v1 to C_v7.
    Valid for: v z_1/100 √(u²/(1 + u²)) ≥ 3 m/s; below, K_V by method B is small and safe to use.

    >>> mesh = MeshGeometry((20, 60), 2e-3, 0.02, 0.08, (0.022, 0.062))
    >>> light = MeshDeviations(0.0, 0.0)
    >>> springs = MeshSprings(14e9, 20e9, 17e9)
    >>> k = dynamic_factor(mesh, springs, light, specific_load=2e5, pinion_speed=100.0, masses=(0.2,))
    >>> round(float(k.factor), 4)
    1.0015
    """
    pitch = springs.single * deviations.base_pitch / specific_load
    profile = springs.single * deviations.profile / specific_load
    relief = deviations.relief_term
    every, constants = list[DynamicFactor](), _coefficients(mesh.total_contact_ratio)
    for mass in masses:
        ratio = pinion_speed * mesh.teeth[0] / np.sqrt(springs.mesh / mass)
        factor = _by_region(ratio, constants, specific_load, pitch=pitch, profile=profile, relief=relief)
        every.append(DynamicFactor(mass, as_value(ratio), pitch, profile, relief, factor))
    return reduce(_larger, every)


def _larger(first: DynamicFactor, second: DynamicFactor) -> DynamicFactor:
    """Return the vibration of a mesh that gives the larger K_V, of every pair of an array."""
    larger = np.asarray(second.factor) > np.asarray(first.factor)

    def chosen(own: Value, other: Value) -> Value:
        return as_value(np.where(larger, other, own))

    return replace(
        first,
        reduced_mass=chosen(first.reduced_mass, second.reduced_mass),
        resonance_ratio=chosen(first.resonance_ratio, second.resonance_ratio),
        factor=chosen(first.factor, second.factor),
    )


def _by_region(
    ratio: Value, constants: tuple[Value, ...], specific_load: Value, *, pitch: Value, profile: Value, relief: Value
) -> Value:
    """K_V below, in, above and between the main resonance."""
    c_2, c_3, c_4, c_6, c_7 = constants
    lower = resonance_begins(specific_load)
    resonant = 0.32 * pitch + c_2 * profile + c_4 * relief + 1.0
    above = 0.47 * pitch + c_6 * profile + c_7
    below = ratio * (0.32 * pitch + c_2 * profile + c_3 * relief) + 1.0
    between = above + (resonant - above) * (1.5 - ratio) / 0.35
    beyond = np.where(ratio < 1.5, between, above)
    return as_value(np.where(ratio <= lower, below, np.where(ratio <= RESONANCE_ENDS, resonant, beyond)))


def _coefficients(overlap: Value) -> tuple[Value, ...]:
    """C_v2, C_v3, C_v4, C_v6, C_v7 over ε_γ."""
    return _coefficients_of_one(overlap) if isinstance(overlap, float) else _coefficients_over(overlap)


@lru_cache(maxsize=1024)
def _coefficients_of_one(overlap: float) -> tuple[Value, ...]:
    """The same of one mesh, whose sizes have them in common."""
    return _coefficients_over(overlap)


def _coefficients_over(overlap: Value) -> tuple[Value, ...]:
    high = np.maximum(overlap, 2.0)
    spur = overlap <= 2.0
    middle = 0.125 * np.sin(np.pi * overlap) + 0.875  # ε_γ − 2 in the standard: a whole turn less
    return (
        np.where(spur, 0.34, 0.57 / (high - 0.3)),
        np.where(spur, 0.23, 0.096 / (high - 1.56)),
        np.where(spur, 0.90, (0.57 - 0.05 * high) / (high - 1.44)),
        np.where(spur, 0.47, 0.12 / (high - 1.74)),
        np.where(overlap <= 1.5, 0.75, np.where(overlap <= 2.5, middle, 1.0)),
    )


def mean_allowance(deviation: Value, steels: tuple[GearSteel, GearSteel], speed: Value) -> Value:
    """Return the running-in allowance of a pair, the mean of its two gears'.

    Args:
        deviation: f_pb or f_fα, the greater of the two gears [m].
        steels: Of the two gears.
        speed: v [m/s].

    Source: ISO 6336-1:2019, clause 8.3.6.
    """
    first, second = steels
    allowance = running_in_allowance(deviation, first, speed)
    if second is first:
        return allowance
    return 0.5 * (allowance + running_in_allowance(deviation, second, speed))


# ----------------------------------------------------------------------------------------------------------------------
# Dynamic factor K_V of ISO 6336-1 by method C: below resonance, by v z_1 and the tolerance class alone.
# ----------------------------------------------------------------------------------------------------------------------


_SOURCE = "ISO 6336-1:2006, clause 6, method C"
_CLASSES = tuple(float(grade) for grade in range(3, 13))
_SPUR = (2.1, 3.9, 7.5, 14.9, 26.8, 39.1, 52.8, 76.6, 102.6, 146.3)
_HELICAL = (1.9, 3.5, 6.7, 13.3, 23.9, 34.8, 47.0, 68.2, 91.4, 130.3)
_LEAST_LOAD = 100.0  # N/mm
FASTEST = 3.0
"""v z_1/100 √(u²/(1 + u²)) up to which method C is meant [m/s]: beyond, resonance asks for method B."""


@dataclass(frozen=True)
class DynamicFactorBySpeed:
    """K_V by method C with what it is made of."""

    characteristic: Annotated[Value, Quantity("velocity"), Origin("v z_1/100 √(u²/(1 + u²))", _SOURCE)]
    """Speed that stands for the distance from resonance [m/s]."""
    slope: Annotated[Value, Quantity("ratio"), Origin("K_3 = 2.071 − 0.357 v z_1/100 √(u²/(1 + u²)), 1 to 2", _SOURCE)]
    """K_3 [-]."""
    factor: Annotated[
        Value,
        Quantity("ratio"),
        Origin("K_V = 1 + (K_1/(K_A F_t/b) + K_2) v z_1/100 K_3 √(u²/(1 + u²))", _SOURCE),
    ]
    """Dynamic factor K_V [-]."""


def dynamic_factor_by_speed(
    mesh: MeshGeometry, grade: Value, *, specific_load: Value, speed: Value
) -> DynamicFactorBySpeed:
    """Return K_V of a mesh by method C.

    Args:
        mesh: The pair.
        grade: Flank tolerance class, 3 to 12; finer ones count as 3 [-].
        specific_load: F_t K_A K_γ / b, at least 100 N/mm [N/m].
        speed: Pitch-line velocity v [m/s].

    Source: ISO 6336-1:2006, clause 6, method C: K_1 by class, K_2 = 0.0193 (spur) or 0.0087 (ε_β ≥ 1), straight between
        them in ε_β; K_3 is 2 up to 0.2 m/s and falls to 1 at 3 m/s, where DIN 3990-1:1987 has none.
    Valid for: steel, v z_1/100 √(u²/(1 + u²)) < 3 m/s.

    >>> spur = MeshGeometry((20, 60), 2e-3, 0.02, 0.08, (0.022, 0.062))
    >>> k = dynamic_factor_by_speed(spur, 6, specific_load=2e5, speed=5.0)
    >>> round(float(k.factor), 4)  # x = 0.9487 m/s, K_3 = 1.7323: 1 + (14.9/200 + 0.0193) 1.6434
    1.1542
    """
    lever = np.abs(mesh.ratio) / np.sqrt(1.0 + mesh.ratio**2)
    place = speed * mesh.teeth[0] / 100.0 * lever
    slope = np.minimum(np.maximum(2.071 - 0.357 * place, 1.0), 2.0)
    load = np.maximum(specific_load / 1e3, _LEAST_LOAD)
    rises = (
        np.interp(grade, _CLASSES, constants) / load + size for constants, size in ((_SPUR, 0.0193), (_HELICAL, 0.0087))
    )
    spur, helical = (1.0 + rise * place * slope for rise in rises)
    overlap = np.minimum(mesh.overlap_ratio, 1.0)
    return DynamicFactorBySpeed(as_value(place), as_value(slope), as_value(spur - overlap * (spur - helical)))
