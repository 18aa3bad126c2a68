"""Tooth bending of cylindrical gears by ISO 6336-3, method B: root stress, permissible stress, safety, by factor."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from gearwright.base import DesignError, Origin, Problem, Quantity
from gearwright.parts.iso6336.geometry import MeshGeometry, RatingMethod, Value, as_value
from gearwright.parts.iso6336.pitting import LoadFactors
from gearwright.parts.iso6336.steels import STRESS_CORRECTION_TEST_GEAR, GearSteel, Treatment
from gearwright.parts.iso6336.tooth_root import (
    Edition,
    LoadedTooth,
    RootSection,
    outer_single_contact,
    root_section,
    tip_loaded,
)

_PART3 = "ISO 6336-3:2019"
_MICRON = 1e-6
_MPA = 1e6
_ROUNDING = 1e-9
# Slip-layer thickness ρ′ [mm] over the yield strength [N/mm²] of steels without a hard case, ISO 6336-3:2006, table 3.
_YIELD = (300.0, 400.0, 500.0, 600.0, 800.0, 1000.0)
_SLIP = (0.0833, 0.0445, 0.0281, 0.0194, 0.0064, 0.0014)
_SLIP_YIELD_ONLY = (
    Treatment.STRUCTURAL, Treatment.THROUGH_HARDENED, Treatment.MALLEABLE_IRON, Treatment.NODULAR_IRON,
)  # fmt: skip
_SLIP_BRITTLE_IRON = 0.3095
_SLIP_NITRIDED = 0.1005
_SLIP_CASE = 0.0030


@dataclass(frozen=True)
class RootBody:
    """What the gear's body and the depth of its teeth do to the root, and by which edition it is rated."""

    rim: Value = 1.0
    """Rim thickness factor Y_B [-]."""
    deep_tooth: Value = 1.0
    """Deep tooth factor Y_DT [-]."""
    edition: Edition = Edition.ISO2019
    """Edition that gives f_ε, Y_β and the fillets of rings."""
    method: RatingMethod = RatingMethod.B
    """Whether the load is at the outer point of single contact, or at the tip with Y_ε."""


@dataclass(frozen=True)
class RootStrengthFactors:
    """What turns σ_Flim of one gear into its permissible stress."""

    life: Annotated[Value, Quantity("ratio"), Origin("Y_NT", f"{_PART3}, clause 11")] = 1.0
    """Life factor Y_NT [-]."""
    notch_sensitivity: Annotated[Value, Quantity("ratio"), Origin("Y_δrelT", f"{_PART3}, clause 12")] = 1.0
    """Relative notch sensitivity factor Y_δrelT [-]."""
    surface: Annotated[Value, Quantity("ratio"), Origin("Y_RrelT", f"{_PART3}, clause 13")] = 1.0
    """Relative surface factor Y_RrelT [-]."""
    size: Annotated[Value, Quantity("ratio"), Origin("Y_X", f"{_PART3}, clause 14")] = 1.0
    """Size factor Y_X [-]."""
    mean_stress: Annotated[Value, Quantity("ratio"), Origin("Y_M", f"{_PART3}, annex B")] = 1.0
    """Mean stress influence factor Y_M [-]; 0.7 for idlers and planets, loaded on both flanks."""

    @property
    def product(self) -> Value:
        """Y_NT Y_δrelT Y_RrelT Y_X Y_M [-]."""
        return self.life * self.notch_sensitivity * self.surface * self.size * self.mean_stress


@dataclass(frozen=True)
class BendingRating:
    """Root stress and safety of one gear."""

    section: RootSection
    """Critical section with Y_F (without f_ε) and Y_S."""
    load_sharing: Annotated[Value, Quantity("ratio"), Origin("f_ε", f"{_PART3}, clause 6.2")]
    """Load sharing factor f_ε, a part of Y_F in the 2019 edition [-]."""
    helix: Annotated[Value, Quantity("ratio"), Origin("Y_β", f"{_PART3}, clause 8")]
    """Helix angle factor Y_β [-]."""
    rim: Annotated[Value, Quantity("ratio"), Origin("Y_B", f"{_PART3}, clause 9")]
    """Rim thickness factor Y_B [-]."""
    deep_tooth: Annotated[Value, Quantity("ratio"), Origin("Y_DT", f"{_PART3}, clause 10")]
    """Deep tooth factor Y_DT [-]."""
    nominal_stress: Annotated[
        Value, Quantity("stress"), Origin("σ_F0 = F_t/(b m_n) Y_F f_ε Y_S Y_β Y_B Y_DT", f"{_PART3}, clause 5")
    ]
    """Nominal root stress σ_F0 [Pa]."""
    stress: Annotated[Value, Quantity("stress"), Origin("σ_F = σ_F0 K_A K_γ K_V K_Fβ K_Fα", f"{_PART3}, clause 5")]
    """Root stress σ_F [Pa]."""
    permissible: Annotated[
        Value,
        Quantity("stress"),
        Origin("σ_FG = σ_Flim Y_ST Y_NT Y_δrelT Y_RrelT Y_X Y_M, Y_ST = 2", f"{_PART3}, clause 5"),
    ]
    """Root stress limit σ_FG [Pa]."""
    safety: Annotated[Value, Quantity("ratio"), Origin("S_F = σ_FG/σ_F", f"{_PART3}, clause 5")]
    """Safety against tooth breakage S_F [-]."""
    contact_ratio: Annotated[
        Value | None, Quantity("ratio"), Origin("Y_ε = 0.25 + 0.75/ε_αn", "ISO 6336-3:1996, clause 7, method C")
    ] = None
    """Contact ratio factor Y_ε of a load at the tip [-]; None with the load where method B has it."""


def load_sharing_factor(mesh: MeshGeometry) -> Value:
    """Return the load sharing factor f_ε.

    Args:
        mesh: The pair.

    Source: ISO 6336-3:2019, clause 6.2: 1 (0.7 from ε_αn = 2) for spur, ε_αn^−½ for ε_β ≥ 1, between them
        √(1 − ε_β + ε_β/ε_αn), with (1 − ε_β)/2 from ε_αn = 2.
    """
    ratio = mesh.transverse_contact_ratio / np.cos(mesh.base_helix_angle) ** 2
    beta = np.minimum(mesh.overlap_ratio, 1.0)
    share = np.sqrt((1.0 - beta) * np.where(np.asarray(ratio) < 2.0, 1.0, 0.5) + beta / ratio)
    deep_spur = (np.asarray(beta) == 0.0) & (np.asarray(ratio) >= 2.0)
    return as_value(np.where(deep_spur, 0.7, share))


def contact_ratio_factor_root(mesh: MeshGeometry) -> Value:
    """Return the contact ratio factor Y_ε, which takes a load at the tip to the outer point of single contact.

    Args:
        mesh: The pair.

    Source: ISO 6336-3:1996, clause 7 (method C), 0.25 + 0.75/ε_αn; method B puts the load where it acts instead.
    Valid for: 1 ≤ ε_αn < 2.
    """
    ratio = mesh.transverse_contact_ratio / np.cos(mesh.base_helix_angle) ** 2
    return as_value(0.25 + 0.75 / ratio)


def helix_factor(mesh: MeshGeometry, edition: Edition) -> Value:
    """Return the helix angle factor Y_β of bending.

    Args:
        mesh: The pair.
        edition: Edition of ISO 6336-3.

    Source: ISO 6336-3:2006 and :2019, clause 8; ε_β at most 1 and β at most 30°.
    """
    angle = np.minimum(mesh.helix_angle, np.radians(30.0))
    factor = 1.0 - np.minimum(mesh.overlap_ratio, 1.0) * angle / np.radians(120.0)
    return as_value(factor / np.cos(angle) ** 3 if edition is Edition.ISO2019 else factor)


def rim_factor(rim: Value, height: Value, module: Value, *, internal: bool = False) -> Value:
    """Return the rim thickness factor Y_B.

    Args:
        rim: Rim thickness below the root s_R [m].
        height: Tooth height h_t [m].
        module: m_n [m].
        internal: Whether the gear is a ring.

    Source: ISO 6336-3:2006, clause 9: 1.6 ln(2.242 h_t/s_R) below s_R = 1.2 h_t, for rings 1.15 ln(8.324 m_n/s_R) below
        3.5 m_n.
    Valid for: s_R > 0.5 h_t, for rings s_R > 1.75 m_n.

    Raises:
        DesignError: thinner rims, which the standard asks to avoid.
    """
    thinnest = 1.75 * module if internal else 0.5 * height
    if np.any(np.asarray(rim) <= thinnest):
        allowed = f"ISO 6336-3 rates rims above {1e3 * float(np.max(thinnest)):.4g} mm"
        raise DesignError([Problem("rim", f"{1e3 * float(np.min(rim)):.4g} mm given; {allowed}")])
    thin = 1.15 * np.log(8.324 * module / rim) if internal else 1.6 * np.log(2.242 * height / rim)
    thick = np.asarray(rim) >= (3.5 * module if internal else 1.2 * height) * (1.0 - _ROUNDING)
    return as_value(np.where(thick, 1.0, np.maximum(1.0, thin)))


def deep_tooth_factor(mesh: MeshGeometry, grade: Value) -> Value:
    """Return the deep tooth factor Y_DT.

    Args:
        mesh: The pair.
        grade: Flank tolerance class [-].

    Source: ISO 6336-3:2006, clause 10: 2.366 − 0.666 ε_αn from 2.05 to 2.5 for class 4 and finer, else 1.
    """
    ratio = np.asarray(mesh.transverse_contact_ratio / np.cos(mesh.base_helix_angle) ** 2)
    deep = np.select([ratio <= 2.05, ratio <= 2.5], [1.0, 2.366 - 0.666 * ratio], 0.7)
    return as_value(np.where(np.asarray(grade) <= 4, deep, 1.0))


def slip_layer(steel: GearSteel) -> float:
    """Return the slip-layer thickness ρ′ of a steel [m].

    Args:
        steel: Of the gear.

    Source: ISO 6336-3:2006, table 3; linear in the yield strength between its rows.

    Raises:
        DesignError: a structural or through-hardened steel, malleable or perlitic iron without a yield strength.
    """
    if steel.treatment in _SLIP_YIELD_ONLY:
        if steel.yield_strength is None:
            message = "none given; the notch sensitivity of a steel without a hard case needs R_p0.2"
            raise DesignError([Problem("yield_strength", message)])
        return 1e-3 * float(np.interp(steel.yield_strength / _MPA, _YIELD, _SLIP))
    if steel.treatment.is_brittle_iron:
        return 1e-3 * _SLIP_BRITTLE_IRON
    return 1e-3 * (_SLIP_NITRIDED if steel.treatment.is_nitrided else _SLIP_CASE)


def notch_sensitivity_factor(notch: Value, steel: GearSteel) -> Value:
    """Return the relative notch sensitivity factor Y_δrelT for long life.

    Args:
        notch: q_s [-].
        steel: Of the gear.

    Source: ISO 6336-3:2006, clause 12.3, (1 + √(ρ′χ*))/(1 + √(ρ′χ*_T)), χ* = (1 + 2 q_s)/5 per mm, χ*_T = 1.2 per mm.
    """
    depth = slip_layer(steel) / 1e-3
    return as_value((1.0 + np.sqrt(depth * 0.2 * (1.0 + 2.0 * notch))) / (1.0 + np.sqrt(depth * 1.2)))


def surface_factor(roughness: Value, treatment: Treatment) -> Value:
    """Return the relative surface factor Y_RrelT for long life.

    Args:
        roughness: R_z of the root fillet [m].
        treatment: Material group.

    Source: ISO 6336-3:2006, clause 13.3; R_z counts from 1 to 40 µm, below it the value is constant.

    >>> round(float(surface_factor(10e-6, Treatment.CASE_HARDENED)), 3)
    1.002
    """
    rough = np.asarray(roughness) / _MICRON
    height = np.clip(rough, 1.0, 40.0) + 1.0
    if treatment is Treatment.STRUCTURAL:
        return as_value(np.where(rough < 1.0, 1.07, 5.306 - 4.203 * height**0.01))
    if treatment.is_nitrided or treatment.is_brittle_iron:
        return as_value(np.where(rough < 1.0, 1.025, 4.299 - 3.259 * height**0.0058))
    return as_value(np.where(rough < 1.0, 1.12, 1.674 - 0.529 * height**0.1))


def bending_size_factor(module: Value, treatment: Treatment) -> Value:
    """Return the size factor Y_X of bending.

    Args:
        module: m_n [m].
        treatment: Material group.

    Source: ISO 6336-3:2006, table 5: 1.05 − 0.01 m_n to 25 mm for hard cases, 1.075 − 0.015 m_n to 25 mm for grey and
        ferritic nodular iron, 1.03 − 0.006 m_n to 30 mm for others.
    """
    if treatment.is_brittle_iron:
        return np.minimum(np.maximum(1.075 - 0.015 * module / 1e-3, 0.7), 1.0)
    if treatment.is_surface_hardened:
        return np.minimum(np.maximum(1.05 - 0.01 * module / 1e-3, 0.8), 1.0)
    return np.minimum(np.maximum(1.03 - 0.006 * module / 1e-3, 0.85), 1.0)


def loaded_tooth(mesh: MeshGeometry, gear: int, method: RatingMethod) -> LoadedTooth:
    """Return a tooth with the load where a method puts it.

    Args:
        mesh: The pair.
        gear: 0 for the pinion, 1 for the wheel.
        method: B or C.

    Source: ISO 6336-3:2019, clause 6 (method B); ISO 6336-3:1996, clause 5 (method C).
    """
    return tip_loaded(mesh, gear) if method is RatingMethod.C else outer_single_contact(mesh, gear)


def bending_rating(
    mesh: MeshGeometry,
    gear: int,
    steel: GearSteel,
    *,
    specific_load: Value,
    loads: LoadFactors,
    strength: RootStrengthFactors,
    body: RootBody = RootBody(),
    section: RootSection | None = None,
) -> BendingRating:
    """Return the root stress, its limit and the safety of one gear.

    Args:
        mesh: The pair.
        gear: 0 for the pinion, 1 for the wheel.
        steel: Of the gear.
        specific_load: F_t/b with the gear's own face width [N/m].
        loads: K factors.
        strength: Y_NT, Y_δrelT, Y_RrelT, Y_X, Y_M of the gear.
        body: Y_B, Y_DT, the edition and the place of the load.
        section: The critical section where it is known; None: that of the tooth.

    Source: ISO 6336-3:2019, clause 5.
    """
    section = section or root_section(loaded_tooth(mesh, gear, body.method), body.edition)
    tip = contact_ratio_factor_root(mesh) if body.method is RatingMethod.C else None
    sharing = load_sharing_factor(mesh) if body.edition is Edition.ISO2019 and tip is None else 1.0
    helix = helix_factor(mesh, body.edition)
    nominal = specific_load / mesh.module * section.form * sharing * section.stress_correction * helix
    nominal = nominal * body.rim * body.deep_tooth * (1.0 if tip is None else tip)
    stress = nominal * loads.bending
    limit = steel.bending_strength * STRESS_CORRECTION_TEST_GEAR * strength.product
    safety = limit / stress
    return BendingRating(section, sharing, helix, body.rim, body.deep_tooth, nominal, stress, limit, safety, tip)
