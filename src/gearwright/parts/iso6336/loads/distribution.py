"""How the load spreads over the face and over the pairs in contact: K_Hβ, K_Fβ by method C, K_Hα, K_Fα by method B."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, NamedTuple

import numpy as np

from gearwright.parts.iso6336.geometry import MeshGeometry, Value, as_value
from gearwright.parts.iso6336.steels import GearSteel
from gearwright.parts.material import STEEL_MODULUS
from gearwright.units import Origin, Quantity

_PART1 = "ISO 6336-1:2019"
_MICRON = 1e-6
_MPA = 1e6
_SHAFT_CONSTANT = 0.023e-3 * 1e-6  # 0.023 mm µm/N in m²/N
_LEAST_MISALIGNMENT = 0.005e-3 * 1e-6  # 0.005 mm µm/N in m²/N


@dataclass(frozen=True)
class HelixModification:
    """Weights of deflection and of manufacturing error in the misalignment, B_1 and B_2 [-]."""

    deflection: float
    """B_1, on f_sh [-]."""
    manufacture: float
    """B_2, on f_ma [-]."""


class Misalignment(NamedTuple):
    """By how much the flanks are out of line before running in."""

    deflection: Value
    """By elastic deflection f_sh [m]."""
    manufacture: Value
    """By helix deviations f_ma [m]."""


UNMODIFIED = HelixModification(1.0, 1.0)
"""No helix modification (ISO 6336-1:2006, table 8, row 1)."""
CROWNED = HelixModification(0.5, 0.5)
"""Central crowning C_β = 0.5 (f_ma + f_sh), row 3."""
CORRECTED_AND_CROWNED = HelixModification(0.1, 0.5)
"""Helix correction and central crowning, row 5."""


@dataclass(frozen=True)
class PinionShaft:
    """Where the pinion sits on its shaft."""

    offset: float = 0.0
    """Distance of the pinion's middle from the middle of the bearing span s [m]."""
    span: float = 0.0
    """Bearing span l [m]."""
    diameter: float = 1.0
    """Outer diameter of the shaft d_sh [m]."""
    constant: float = 0.48
    """Constant K′ of the arrangement [-]: ±0.48, ±0.48, 1.33, ±0.36, ±0.6 (ISO 6336-1:2006, figure 13)."""


CENTRED = PinionShaft()
"""A pinion in the middle between its bearings."""


@dataclass(frozen=True)
class FaceLoadFactor:
    """K_Hβ and K_Fβ with the misalignment that makes them."""

    deflection: Annotated[Value, Quantity("length"), Origin("f_sh by shaft and pinion", f"{_PART1}, 7.5")]
    """Misalignment by elastic deflection f_sh [m]."""
    manufacture: Annotated[Value, Quantity("length"), Origin("f_ma by helix deviations", f"{_PART1}, 7.5")]
    """Misalignment by manufacture f_ma [m]."""
    misalignment: Annotated[Value, Quantity("length"), Origin("F_βy = F_βx − y_β", f"{_PART1}, 7.5")]
    """Effective misalignment after running in F_βy [m]."""
    contact: Annotated[Value, Quantity("ratio"), Origin("K_Hβ = 1 + F_βy c_γβ b/(2 F_m)", f"{_PART1}, 7.5")]
    """Face load factor for contact K_Hβ [-]."""
    bending: Annotated[Value, Quantity("ratio"), Origin("K_Fβ = K_Hβ^N_F", f"{_PART1}, 7.4")]
    """Face load factor for the root K_Fβ [-]."""


@dataclass(frozen=True)
class TransverseLoadFactor:
    """K_Hα and K_Fα."""

    contact: Annotated[Value, Quantity("ratio"), Origin("K_Hα by c_γα (f_pb − y_α) b/F_tH", f"{_PART1}, 8.3")]
    """Transverse load factor for contact K_Hα [-]."""
    bending: Annotated[Value, Quantity("ratio"), Origin("K_Fα by c_γα (f_pb − y_α) b/F_tH", f"{_PART1}, 8.3")]
    """Transverse load factor for the root K_Fα [-]."""


def deflection_misalignment(
    mesh: MeshGeometry,
    specific_load: Value,
    shaft: PinionShaft,
    *,
    paths: float = 1,
    elastic_modulus: float = STEEL_MODULUS,
) -> Value:
    """Return the misalignment that the pinion and its shaft bend and twist into.

    Args:
        mesh: The pair, spur or single helical.
        specific_load: F_m/b = F_t K_A K_γ K_V / b [N/m].
        shaft: Where the pinion sits.
        paths: Meshes of the pinion, such as planets on a sun [-].
        elastic_modulus: E of the pinion and its shaft [Pa]; the formula is that of steel.

    Returns:
        f_sh [m].

    Source: ISO 6336-1:2006, clause 7.5.2.4.1, 0.023 (|B* + K′ l s/d_1² (d_1/d_sh)⁴ − 0.3| + 0.3)(b/d_1)² F_m/b with
        B* = 1 for one mesh and 1 + 2 (k − 1) for k of them.
    Valid for: solid or nearly solid pinions, bearings that do not tilt.
    """
    first = mesh.pitch_diameters[0]
    lever = shaft.constant * shaft.span * shaft.offset / first**2 * (first / shaft.diameter) ** 4
    shape = np.abs(1.0 + 2.0 * (paths - 1) + lever - 0.3) + 0.3
    return specific_load * _SHAFT_CONSTANT * (STEEL_MODULUS / elastic_modulus) * shape * (mesh.face_width / first) ** 2


def lead_allowance(misalignment: Value, steel: GearSteel, speed: Value) -> Value:
    """Return by how much running in lessens the misalignment.

    Args:
        misalignment: F_βx before running in [m].
        steel: Of the gear.
        speed: Pitch-line velocity v [m/s].

    Returns:
        y_β [m].

    Source: ISO 6336-1:2006, clause 7.5.2.5: 0.15 F_βx ≤ 6 µm for surface-hardened, 0.55 F_βx ≤ 45 or 22 µm from 5 and
        10 m/s for grey and ferritic nodular iron, 320/σ_Hlim F_βx for others.
    """
    if steel.treatment.is_brittle_iron:
        most = np.where(np.asarray(speed) <= 5.0, np.inf, np.where(np.asarray(speed) <= 10.0, 45.0, 22.0))
        return as_value(np.minimum(0.55 * misalignment, most * _MICRON))
    if steel.treatment.is_surface_hardened:
        return np.minimum(0.15 * misalignment, 6.0 * _MICRON)
    strength = steel.tabulated_strength / _MPA
    limit = np.where(np.asarray(speed) <= 5.0, np.inf, np.where(np.asarray(speed) <= 10.0, 25600.0, 12800.0))
    return as_value(np.minimum(np.minimum(320.0 / strength, 1.0) * misalignment, limit / strength * _MICRON))


def face_load_factor(
    mesh: MeshGeometry,
    misalignment: Misalignment,
    steels: tuple[GearSteel, GearSteel],
    *,
    stiffness: Value,
    specific_load: Value,
    speed: Value,
    modification: HelixModification = UNMODIFIED,
) -> FaceLoadFactor:
    """Return K_Hβ and K_Fβ by method C.

    Args:
        mesh: The pair.
        misalignment: f_sh and f_ma.
        steels: Of the two gears.
        stiffness: c_γβ [N/m²].
        specific_load: F_m/b = F_t K_A K_γ K_V / b [N/m].
        speed: v [m/s].
        modification: Helix modification.

    Source: ISO 6336-1:2006, clauses 7.5 and 7.6; F_βx = 1.33 B_1 f_sh + B_2 f_ma, at least 0.005 mm µm/N F_m/b;
        K_Hβ = √(2 F_βy c_γβ b/F_m) where the load no longer covers the face.

    >>> pair = MeshGeometry((20, 60), 2e-3, 0.02, 0.08, (0.022, 0.062))
    >>> from gearwright.parts.iso6336 import Treatment
    >>> steel = GearSteel("x", Treatment.CASE_HARDENED, "MQ", 700.0, 1500e6, 500e6)
    >>> made = Misalignment(0.0, 1e-5)
    >>> result = face_load_factor(pair, made, (steel, steel), stiffness=17e9, specific_load=2e5, speed=5.0)
    >>> round(float(result.contact), 4)
    1.3613
    """
    deflection, manufacture = misalignment
    weighted = 1.33 * modification.deflection * deflection + modification.manufacture * manufacture
    initial = np.maximum(weighted, _LEAST_MISALIGNMENT * specific_load)
    allowance = 0.5 * (lead_allowance(initial, steels[0], speed) + lead_allowance(initial, steels[1], speed))
    effective = initial - allowance
    tilt = effective * stiffness / (2.0 * specific_load)
    contact = as_value(np.where(tilt >= 1.0, 2.0 * np.sqrt(tilt), 1.0 + tilt))
    return FaceLoadFactor(deflection, manufacture, effective, contact, contact ** _face_exponent(mesh))


def _face_exponent(mesh: MeshGeometry) -> Value:
    """N_F of the more slender tooth, b/h ≥ 3 (ISO 6336-1:2006, clause 7.6)."""
    slender = np.maximum(3.0, mesh.face_width / np.maximum(*mesh.tooth_heights))
    return as_value(slender**2 / (1.0 + slender + slender**2))


def transverse_load_factor(
    mesh: MeshGeometry, pitch_deviation: Value, *, stiffness: Value, specific_load: Value, contact_ratio_factor: Value
) -> TransverseLoadFactor:
    """Return K_Hα and K_Fα by method B.

    Args:
        mesh: The pair.
        pitch_deviation: f_pb − y_α after running in [m].
        stiffness: c_γα [N/m²].
        specific_load: F_tH/b = F_t K_A K_γ K_V K_Hβ / b [N/m].
        contact_ratio_factor: Z_ε [-].

    Source: ISO 6336-1:2019, clause 8.3; limits ε_γ/(ε_α Z_ε²) and ε_γ/(0.25 ε_α + 0.75), and at least 1.
    """
    total, alpha = mesh.total_contact_ratio, mesh.transverse_contact_ratio
    error = stiffness * pitch_deviation / specific_load
    wide = np.sqrt(2.0 * (np.maximum(total, 2.0) - 1.0) / np.maximum(total, 2.0))
    factor = np.where(np.asarray(total) <= 2.0, 0.5 * total * (0.9 + 0.4 * error), 0.9 + 0.4 * wide * error)
    contact = np.clip(factor, 1.0, np.maximum(1.0, total / (alpha * contact_ratio_factor**2)))
    bending = np.clip(factor, 1.0, np.maximum(1.0, total / (0.25 * alpha + 0.75)))
    return TransverseLoadFactor(as_value(contact), as_value(bending))
