"""Mesh stiffness per unit face width by ISO 6336-1: the default, fitted to measured gears.

Stiffnesses are in N/m per metre of face width; 1 N/(mm µm) = 1e9 N/m².
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import cast

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem, refuse
from gearwright.parts.gears import BasicRack, GearPair, virtual_teeth
from gearwright.parts.material import STEEL_MODULUS
from gearwright.parts.stiffness.curve import StiffnessCurve
from gearwright.parts.stiffness.passing_pairs import rectangular_curve

_C = (0.04723, 0.15551, 0.25791, -0.00635, -0.11654, -0.00193, -0.24188, 0.00529, 0.00182)
"""Coefficients C_1 to C_9 of the least flexibility q′ in mm µm/N (ISO 6336-1:2006, clause 9, method B)."""
_UNIT = 1e9  # N/(mm µm) in N/m²
THEORY_TO_MEASUREMENT = 0.8
"""Correction factor C_M [-] (ISO 6336-1:2006, clause 9)."""
LINEAR_LOAD = 100e3
"""Specific load F_t K_A / b from which load no longer matters [N/m] (ISO 6336-1:2006, clause 9)."""


@dataclass(frozen=True)
class GearBlank:
    """The body that carries the teeth."""

    web_ratio: float = 1.0
    """Web thickness over face width b_s/b [-]; 1: solid disc."""
    rim_ratio: float = 5.0
    """Rim thickness over normal module s_R/m_n [-]; without effect on a solid disc."""


SOLID = GearBlank()
"""A solid disc, C_R = 1."""


@dataclass(frozen=True)
class MeshStiffness:
    """Stiffnesses of a mesh per unit face width, in the transverse plane along the line of action."""

    theoretical: float
    """Theoretical single stiffness c′_th [N/m²]."""
    single: float
    """Single stiffness of one tooth pair c′ [N/m²]."""
    mesh: float
    """Mean mesh stiffness c_γα [N/m²], for dynamic and transverse load factors."""
    face: float
    """Mean mesh stiffness c_γβ = 0.85 c_γα [N/m²], for the face load factor."""


def theoretical_stiffness(teeth: tuple[float, float], profile_shifts: tuple[float, float] = (0.0, 0.0)) -> float:
    """Return the theoretical single stiffness c′_th of a pair of solid steel spur gears.

    The regression for q′ has one set of coefficients for the pinion and one for the wheel: the gear with fewer teeth
    counts as the pinion, whichever drives; of equal ones that with the larger shift.

    Args:
        teeth: Virtual numbers of teeth z_n of both gears [-], or arrays of them; infinite for an internal gear.
        profile_shifts: x of both [-].

    Returns:
        c′_th [N/m²], from the least flexibility q′.

    Source: ISO 6336-1:2006, clause 9, 1/q′; index 1 is the pinion, 2 the wheel.
    Valid for: x_1 ≥ x_2 and −0.5 ≤ x_1 + x_2 ≤ 2.

    >>> round(theoretical_stiffness((18.905, 114.543), (0.145, 0.0)) / 1e9, 4)
    17.8558
    """
    (z_1, z_2), (x_1, x_2), c = *_pinion_first(teeth, profile_shifts), _C
    flexibility = c[0] + c[1] / z_1 + c[2] / z_2 + c[3] * x_1 + c[4] * x_1 / z_1
    flexibility += c[5] * x_2 + c[6] * x_2 / z_2 + c[7] * x_1**2 + c[8] * x_2**2
    stiffness = _UNIT / flexibility
    return cast(float, stiffness if np.ndim(stiffness) else float(stiffness))  # arrays pass through


def _pinion_first(
    teeth: tuple[float, float], shifts: tuple[float, float]
) -> tuple[tuple[Floats, Floats], tuple[Floats, Floats]]:
    z_1, z_2, x_1, x_2 = (np.asarray(value, dtype=np.float64) for value in (*teeth, *shifts))
    turned = (z_1 > z_2) | ((z_1 == z_2) & (x_1 < x_2))
    ordered = [(np.where(turned, b, a), np.where(turned, a, b)) for a, b in ((z_1, z_2), (x_1, x_2))]
    return ordered[0], ordered[1]


def blank_factor(blank: GearBlank) -> float:
    """Return the gear blank factor C_R.

    Args:
        blank: The gear's body.

    Returns:
        C_R [-]; 1 for a solid disc.

    Source: ISO 6336-1:2006, clause 9, C_R = 1 + ln(b_s/b) / (5 e^(s_R/(5 m_n))).
    Valid for: 0.2 ≤ b_s/b ≤ 1.2 and s_R/m_n ≥ 1; beyond them the standard takes the limits.
    """
    web = min(max(blank.web_ratio, 0.2), 1.2)
    return 1.0 + math.log(web) / (5.0 * math.exp(max(blank.rim_ratio, 1.0) / 5.0))


def rack_factor(first: BasicRack, second: BasicRack) -> float:
    """Return the basic rack factor C_B of a pair, the mean of its two gears'.

    Args:
        first: Basic rack of one gear.
        second: Basic rack of the other.

    Returns:
        C_B [-].

    Source: ISO 6336-1:2006, clause 9, C_B = [1 + 0.5 (1.2 − h_fP/m_n)] [1 − 0.02 (20° − α_Pn)].

    >>> from gearwright.parts.gears import ISO53_A
    >>> round(rack_factor(ISO53_A, ISO53_A), 4)
    0.975
    """
    return 0.5 * sum(
        (1.0 + 0.5 * (1.2 - rack.dedendum)) * (1.0 - 0.02 * (20.0 - math.degrees(rack.pressure_angle)))
        for rack in (first, second)
    )


def load_factor(specific_load: float) -> float:
    """Return by how much a light load lowers the single stiffness.

    Args:
        specific_load: F_t K_A / b [N/m].

    Returns:
        1 from 100 N/mm upwards, below it (F_t K_A / b / 100 N/mm)^0.25 [-].

    Source: ISO 6336-1:2006, clause 9.
    """
    if not specific_load > 0.0:
        message = f"{specific_load:.6g} N/m given; must be above 0, or leave it out for 100 N/mm and more"
        raise DesignError([Problem("specific_load", message)])
    return float(min(1.0, (specific_load / LINEAR_LOAD) ** 0.25))


def modulus_factor(elastic_moduli: tuple[float, float], steel: float = STEEL_MODULUS) -> float:
    """Return E/E_St, by which c′ of other materials than steel differs [-].

    Args:
        elastic_moduli: Young's moduli of the two gears [Pa].
        steel: E_St [Pa].

    Source: ISO 6336-1:2006, clause 9, E = 2 E_1 E_2/(E_1 + E_2), E_St = 206 000 N/mm².

    >>> round(modulus_factor((206e9, 173e9)), 4)  # steel on nodular iron
    0.9129
    """
    first, second = elastic_moduli
    return 2.0 * first * second / (first + second) / steel


def mesh_stiffness_iso6336(
    pair: GearPair,
    *,
    blank: GearBlank = SOLID,
    specific_load: float = LINEAR_LOAD,
    elastic_moduli: tuple[float, float] = (STEEL_MODULUS, STEEL_MODULUS),
) -> MeshStiffness:
    """Return c′ and c_γ of a mesh by method B of ISO 6336-1.

    Args:
        pair: External or internal pair.
        blank: The less stiff of the two bodies.
        specific_load: F_t K_A / b [N/m]; matters below 100 N/mm.
        elastic_moduli: Young's moduli of the two gears [Pa].

    Returns:
        c_γα = c′ (0.75 ε_α + 0.25), c_γβ = 0.85 c_γα.

    Source: ISO 6336-1:2006, clause 9; an internal gear counts as z_n = ∞; other materials by E = 2 E_1 E_2/(E_1 + E_2).
    Valid for: β ≤ 45°, ε_α from 1.2 to 1.9 (higher is taken as it is), −0.5 ≤ x_1 + x_2 ≤ 2.

    Raises:
        DesignError: outside the ranges of β, x_1 + x_2 and below ε_α = 1.
    """
    refuse(_outside(pair))
    driver, driven = pair.driver, pair.driven
    z_1, z_2 = (virtual_teeth(gear.teeth, gear.rack.pressure_angle, gear.helix_angle) for gear in (driver, driven))
    x_1, x_2 = driver.profile_shift, driven.profile_shift
    if pair.side < 0:
        z_2 = math.inf
    theoretical = theoretical_stiffness((z_1, z_2), (x_1, x_2))
    factor = THEORY_TO_MEASUREMENT * blank_factor(blank) * rack_factor(driver.rack, driven.rack)
    single = theoretical * factor * math.cos(driver.helix_angle) * load_factor(specific_load)
    single *= modulus_factor(elastic_moduli)
    mesh = single * (0.75 * pair.transverse_contact_ratio + 0.25)
    return MeshStiffness(theoretical, single, mesh, 0.85 * mesh)


def mesh_curve_iso6336(pair: GearPair, stiffness: MeshStiffness, *, harmonics: int = 8) -> StiffnessCurve:
    """Return the two-level mesh stiffness that c′ and ε_α imply: c′ b in single, 1.75 c′ b in double contact.

    Args:
        pair: The pair.
        stiffness: Its stiffnesses from `mesh_stiffness_iso6336`.
        harmonics: Harmonics of the mesh phase to keep [-]; 0 gives the constant c_γα b.

    Source: see `rectangular_curve`; helical teeth in slices without coupling.
    """
    pitch = pair.driver.base_pitch
    ends = (-pair.approach / pitch, pair.recess / pitch)
    single = stiffness.single * pair.face_width
    return rectangular_curve(single, ends, overlap=pair.overlap_ratio, harmonics=harmonics)


def _outside(pair: GearPair) -> list[Problem]:
    """What lies outside the method's range."""
    total = pair.driver.profile_shift + pair.driven.profile_shift
    problems = []
    if pair.driver.helix_angle > math.radians(45.0):
        degrees = math.degrees(pair.driver.helix_angle)
        problems.append(Problem("helix_angle", f"{degrees:.4g}° given; ISO 6336-1 allows at most 45°"))
    if not -0.5 <= total <= 2.0:
        problems.append(Problem("profile_shift", f"x_1 + x_2 = {total:.4g}; ISO 6336-1 allows −0.5 to 2"))
    ratio = pair.transverse_contact_ratio
    if not ratio >= 1.0:
        problems.append(Problem("", f"contact ratio {ratio:.3f}; a mesh needs at least 1: longer teeth or less shift"))
    return problems
