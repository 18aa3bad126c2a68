"""Pitting and tooth bending of cylindrical gears by ISO 6336-2 and -3, method B: stress, permissible stress, safety."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Annotated

import numpy as np

from gearwright.base import DesignError, Origin, Problem, Quantity
from gearwright.parts.iso6336.geometry import (
    Edition,
    MeshGeometry,
    RatingMethod,
    RootSection,
    Value,
    as_value,
    loaded_tooth,
    of_contact,
    of_form,
    root_section,
)
from gearwright.parts.iso6336.steels import STRESS_CORRECTION_TEST_GEAR, GearSteel, Treatment

# ----------------------------------------------------------------------------------------------------------------------
# Pitting of cylindrical gears by ISO 6336-2, method B: contact stress, permissible stress, safety, by factor.
# ----------------------------------------------------------------------------------------------------------------------


_PART2 = "ISO 6336-2:2019"
PairOf = tuple[Value, Value]


@dataclass(frozen=True)
class ToothLoadFactors:
    """The five load factors of ISO 6336-1, and the share of parallel paths."""

    application: Annotated[Value, Quantity("ratio"), Origin("K_A", "ISO 6336-1:2019, clause 5")] = 1.0
    """Application factor K_A [-]."""
    mesh_load: Annotated[Value, Quantity("ratio"), Origin("K_γ", "ISO 6336-1:2019, clause 5")] = 1.0
    """Mesh load factor K_γ of parallel paths [-]."""
    dynamic: Annotated[Value, Quantity("ratio"), Origin("K_V", "ISO 6336-1:2019, clause 6")] = 1.0
    """Dynamic factor K_V [-]."""
    face_contact: Annotated[Value, Quantity("ratio"), Origin("K_Hβ", "ISO 6336-1:2019, clause 7")] = 1.0
    """Face load factor for contact K_Hβ [-]."""
    transverse_contact: Annotated[Value, Quantity("ratio"), Origin("K_Hα", "ISO 6336-1:2019, clause 8")] = 1.0
    """Transverse load factor for contact K_Hα [-]."""
    face_bending: Annotated[Value, Quantity("ratio"), Origin("K_Fβ", "ISO 6336-1:2019, clause 7")] = 1.0
    """Face load factor for the root K_Fβ [-]."""
    transverse_bending: Annotated[Value, Quantity("ratio"), Origin("K_Fα", "ISO 6336-1:2019, clause 8")] = 1.0
    """Transverse load factor for the root K_Fα [-]."""

    @property
    def contact(self) -> Value:
        """K_A K_γ K_V K_Hβ K_Hα [-]."""
        return self.application * self.mesh_load * self.dynamic * self.face_contact * self.transverse_contact

    @property
    def bending(self) -> Value:
        """K_A K_γ K_V K_Fβ K_Fα [-]."""
        return self.application * self.mesh_load * self.dynamic * self.face_bending * self.transverse_bending


@dataclass(frozen=True)
class ContactStrengthFactors:
    """What turns σ_Hlim of one gear into its permissible stress."""

    life: Annotated[Value, Quantity("ratio"), Origin("Z_NT", f"{_PART2}, clause 11")] = 1.0
    """Life factor Z_NT [-]."""
    lubricant: Annotated[Value, Quantity("ratio"), Origin("Z_L", f"{_PART2}, clause 12")] = 1.0
    """Lubricant factor Z_L [-]."""
    speed: Annotated[Value, Quantity("ratio"), Origin("Z_v", f"{_PART2}, clause 12")] = 1.0
    """Velocity factor Z_v [-]."""
    roughness: Annotated[Value, Quantity("ratio"), Origin("Z_R", f"{_PART2}, clause 12")] = 1.0
    """Roughness factor Z_R [-]."""
    work_hardening: Annotated[Value, Quantity("ratio"), Origin("Z_W", f"{_PART2}, clause 13")] = 1.0
    """Work hardening factor Z_W [-]."""
    size: Annotated[Value, Quantity("ratio"), Origin("Z_X", f"{_PART2}, clause 14")] = 1.0
    """Size factor Z_X [-]: 1, as the standard leaves it to experience (DIN 3990-2 lowers it from m_n = 10 mm)."""

    @property
    def product(self) -> Value:
        """Z_NT Z_L Z_v Z_R Z_W Z_X [-]."""
        return self.life * self.lubricant * self.speed * self.roughness * self.work_hardening * self.size


@dataclass(frozen=True)
class ContactGeometryFactors:
    """What turns the tangential force into the stress at the pitch point and at the inner points of single contact."""

    zone: Annotated[Value, Quantity("ratio"), Origin("Z_H", f"{_PART2}, clause 6")]
    """Zone factor Z_H [-]."""
    single_contact: Annotated[tuple[Value, Value], Quantity("ratio"), Origin("Z_B, Z_D", f"{_PART2}, clause 6")]
    """Single pair contact factors Z_B of the pinion and Z_D of the wheel [-]."""
    elasticity: Annotated[Value, Quantity("elasticity_factor"), Origin("Z_E", f"{_PART2}, clause 7")]
    """Elasticity factor Z_E [√Pa]; 189.8 √(N/mm²) is 189.8e3 √Pa."""
    contact_ratio: Annotated[Value, Quantity("ratio"), Origin("Z_ε", f"{_PART2}, clause 8")]
    """Contact ratio factor Z_ε [-]."""
    helix: Annotated[Value, Quantity("ratio"), Origin("Z_β = 1/√cos β", f"{_PART2}, clause 9")]
    """Helix angle factor Z_β [-]."""


@dataclass(frozen=True)
class PittingRating:
    """Contact stress and safety of both gears of a mesh."""

    geometry: ContactGeometryFactors
    """Z_H, Z_B, Z_D, Z_E, Z_ε, Z_β."""
    nominal_stress: Annotated[
        Value, Quantity("stress"), Origin("σ_H0 = Z_H Z_E Z_ε Z_β √(F_t/(d_1 b) (u+1)/u)", f"{_PART2}, clause 5")
    ]
    """Nominal contact stress at the pitch point σ_H0 [Pa]."""
    stresses: Annotated[
        tuple[Value, Value],
        Quantity("stress"),
        Origin("σ_H = Z_B,D σ_H0 √(K_A K_γ K_V K_Hβ K_Hα)", f"{_PART2}, clause 5"),
    ]
    """Contact stress of pinion and wheel σ_H [Pa]."""
    permissible: Annotated[
        tuple[Value, Value], Quantity("stress"), Origin("σ_HG = σ_Hlim Z_NT Z_L Z_v Z_R Z_W Z_X", f"{_PART2}, clause 5")
    ]
    """Pitting stress limit of pinion and wheel σ_HG [Pa]."""
    safeties: Annotated[tuple[Value, Value], Quantity("ratio"), Origin("S_H = σ_HG/σ_H", f"{_PART2}, clause 5")]
    """Safety against pitting of pinion and wheel S_H [-]."""


@of_form
def zone_factor(mesh: MeshGeometry) -> Value:
    """Return the zone factor Z_H, which takes the force at the reference circle to the flank at the pitch point.

    Args:
        mesh: The pair.

    Source: ISO 6336-2:2019, clause 6.2, √(2 cos β_b cos α_wt / (cos² α_t sin α_wt)).
    """
    numerator = 2.0 * np.cos(mesh.base_helix_angle) * np.cos(mesh.working_angle)
    return as_value(np.sqrt(numerator / (np.cos(mesh.transverse_angle) ** 2 * np.sin(mesh.working_angle))))


@lru_cache(maxsize=256)
def elasticity_factor(steels: tuple[GearSteel, GearSteel]) -> float:
    """Return the elasticity factor Z_E [√Pa].

    Args:
        steels: Of the two gears.

    Source: ISO 6336-2:2019, clause 7, √(1/(π ((1−ν_1²)/E_1 + (1−ν_2²)/E_2))).
    """
    compliance = sum((1.0 - steel.poisson_ratio**2) / steel.elastic_modulus for steel in steels)
    return float(1.0 / np.sqrt(np.pi * compliance))


def contact_ratio_factor(mesh: MeshGeometry) -> Value:
    """Return the contact ratio factor Z_ε.

    Args:
        mesh: The pair.

    Source: ISO 6336-2:2019, clause 8: √((4 − ε_α)/3) for spur, √(1/ε_α) for ε_β ≥ 1, between them by ε_β.
    """
    alpha = mesh.transverse_contact_ratio
    beta = np.minimum(mesh.overlap_ratio, 1.0)
    return np.sqrt((4.0 - alpha) / 3.0 * (1.0 - beta) + beta / alpha)


@of_contact
def mesh_contact_ratio_factor(mesh: MeshGeometry) -> Value:
    """Return the contact ratio factor Z_ε of a mesh that keeps it, as load factors and flanks ask for it.

    Args:
        mesh: The pair.

    Source: as `contact_ratio_factor`.
    """
    return contact_ratio_factor(mesh)


def single_contact_factors(mesh: MeshGeometry, *, profile_factor: Value = 1.0) -> PairOf:
    """Return Z_B and Z_D, which take the stress from the pitch point to the inner points of single pair contact.

    Args:
        mesh: The pair.
        profile_factor: f_ZCa of the 2019 edition for helical teeth [-]: 1 with well-made profile modifications (and
            always in the 2006 edition), 1.07 with modifications by experience, 1.2 without any.

    Source: ISO 6336-2:2019, clause 6.3; Z_D = 1 for an internal wheel.
    """
    beta = np.minimum(mesh.overlap_ratio, 1.0)
    helical = np.sqrt(profile_factor)
    pinion, wheel = (
        np.where(factor > 1.0, factor + beta * (helical - factor), 1.0 + beta * (helical - 1.0))
        for factor in _inner_single_contact(mesh)
    )
    return as_value(pinion), as_value(np.where(np.asarray(mesh.side) > 0, wheel, 1.0))


@of_form
def _inner_single_contact(mesh: MeshGeometry) -> PairOf:
    """M_1 and M_2 of spur gears."""
    turns = [2.0 * np.pi / mesh.teeth[0], 2.0 * np.pi / np.abs(mesh.teeth[1])]
    beyond = mesh.transverse_contact_ratio - 1.0
    pinion_tip, wheel_tip = mesh.tip_tangents
    tangent = np.tan(mesh.working_angle)
    first = tangent / np.sqrt((pinion_tip - turns[0]) * (wheel_tip - mesh.side * beyond * turns[1]))
    second = tangent / np.sqrt(np.abs((wheel_tip - mesh.side * turns[1]) * (pinion_tip - beyond * turns[0])))
    return first, second


def contact_geometry_factors(
    mesh: MeshGeometry,
    steels: tuple[GearSteel, GearSteel],
    *,
    profile_factor: Value = 1.0,
    edition: Edition = Edition.ISO2019,
) -> ContactGeometryFactors:
    """Return Z_H, Z_B, Z_D, Z_E, Z_ε and Z_β of a mesh.

    Args:
        mesh: The pair.
        steels: Of the two gears.
        profile_factor: f_ZCa [-], see `single_contact_factors`.
        edition: DIN 3990 has Z_β = √cos β, ISO 6336 since its correction of 2008 the inverse.

    Source: ISO 6336-2:2019, clauses 6 to 9; DIN 3990-2:1987.
    """
    known = type(profile_factor) is float
    return ContactGeometryFactors(
        zone=zone_factor(mesh),
        single_contact=(_single_contact if known else single_contact_factors)(mesh, profile_factor=profile_factor),
        elasticity=elasticity_factor(steels),
        contact_ratio=mesh_contact_ratio_factor(mesh),
        helix=_slant(mesh) if edition is Edition.DIN1987 else 1.0 / _slant(mesh),
    )


@of_form
def _slant(mesh: MeshGeometry) -> Value:
    return np.sqrt(np.cos(mesh.helix_angle))


@of_contact
def _single_contact(mesh: MeshGeometry, *, profile_factor: Value) -> PairOf:
    return single_contact_factors(mesh, profile_factor=profile_factor)


def pitting_rating(
    mesh: MeshGeometry,
    steels: tuple[GearSteel, GearSteel],
    tangential_force: Value,
    *,
    loads: ToothLoadFactors,
    strengths: tuple[ContactStrengthFactors, ContactStrengthFactors],
    profile_factor: Value = 1.0,
    edition: Edition = Edition.ISO2019,
) -> PittingRating:
    """Return the contact stress, its limit and the safety of both gears.

    Args:
        mesh: The pair.
        steels: Of the two gears.
        tangential_force: Nominal tangential force of one mesh at the reference circle F_t [N].
        loads: K factors.
        strengths: Z_NT, Z_L, Z_v, Z_R, Z_W, Z_X of the two gears.
        profile_factor: f_ZCa [-], see `single_contact_factors`.
        edition: That gives Z_β.

    Source: ISO 6336-2:2019, clause 5.
    Valid for: external and internal involute pairs, 1 < ε_α < 2.5.
    """
    factors = contact_geometry_factors(mesh, steels, profile_factor=profile_factor, edition=edition)
    load = tangential_force / (mesh.pitch_diameters[0] * mesh.face_width) * (mesh.ratio + 1.0) / mesh.ratio
    nominal = factors.zone * factors.elasticity * factors.contact_ratio * factors.helix * np.sqrt(load)
    root = np.sqrt(loads.contact)
    stresses = tuple(factor * nominal * root for factor in factors.single_contact)
    limits = tuple(steel.contact_strength * strength.product for steel, strength in zip(steels, strengths, strict=True))
    return PittingRating(
        geometry=factors,
        nominal_stress=nominal,
        stresses=(stresses[0], stresses[1]),
        permissible=(limits[0], limits[1]),
        safeties=(limits[0] / stresses[0], limits[1] / stresses[1]),
    )


# ----------------------------------------------------------------------------------------------------------------------
# Lubricant film factors Z_L, Z_v, Z_R and work hardening Z_W of ISO 6336-2.
# ----------------------------------------------------------------------------------------------------------------------


_MPA = 1e6
_MM2_S = 1e-6
_MICRON = 1e-6
SMOOTH = 3.0 * _MICRON
"""R_zH at which a hard flank works its mate best; Z_W has its full value [m]."""
RZ_OVER_RA = 6.0
"""R_z over R_a of ground flanks [-] (ISO 6336-2:2019, clause 12)."""


def _film_constant(contact_strength: Value, at_850: float, at_1200: float) -> Value:
    """Constant that runs linearly between σ_Hlim of 850 and 1200 N/mm²."""
    if isinstance(contact_strength, float):
        return _constant_of_one(contact_strength, at_850, at_1200)
    return _constant(contact_strength, at_850, at_1200)


@lru_cache(maxsize=256)
def _constant_of_one(contact_strength: float, at_850: float, at_1200: float) -> Value:
    """The same of one steel, which many pairs have."""
    return _constant(contact_strength, at_850, at_1200)


def _constant(contact_strength: Value, at_850: float, at_1200: float) -> Value:
    strength = np.asarray(contact_strength) / _MPA
    part = (np.minimum(np.maximum(strength, 850.0), 1200.0) - 850.0) / 350.0
    return as_value(at_850 + (at_1200 - at_850) * part)


def lubricant_factor(viscosity: Value, contact_strength: Value) -> Value:
    """Return the lubricant factor Z_L of mineral oils.

    Args:
        viscosity: Kinematic viscosity at 40 °C ν_40 [m²/s].
        contact_strength: σ_Hlim of the softer gear [Pa].

    Source: ISO 6336-2:2006, clause 12.3.1.

    >>> round(float(lubricant_factor(320e-6, 1500e6)), 5)
    1.04739
    """
    constant = _film_constant(contact_strength, 0.83, 0.91)
    return constant + 4.0 * (1.0 - constant) / (1.2 + 134.0 * _MM2_S / viscosity) ** 2


def speed_factor(speed: Value, contact_strength: Value) -> Value:
    """Return the velocity factor Z_v.

    Args:
        speed: Pitch-line velocity v [m/s].
        contact_strength: σ_Hlim of the softer gear [Pa].

    Source: ISO 6336-2:2006, clause 12.3.2, C_Zv = C_ZL + 0.02.

    >>> round(float(speed_factor(2.6642, 1500e6)), 5)
    0.96911
    """
    constant = _film_constant(contact_strength, 0.85, 0.93)
    return constant + 2.0 * (1.0 - constant) / np.sqrt(0.8 + 32.0 / speed)


def roughness_factor(roughness: Value, curvature: Value, contact_strength: Value) -> Value:
    """Return the roughness factor Z_R.

    Args:
        roughness: Mean R_z of the two flanks [m]; R_z ≈ 6 R_a where only R_a is known.
        curvature: ρ_red at the pitch point [m].
        contact_strength: σ_Hlim of the softer gear [Pa].

    Source: ISO 6336-2:2006, clause 12.3.3, (3 µm/R_z10)^C_ZR with R_z10 = R_z (10 mm/ρ_red)^(1/3).
    """
    exponent = _film_constant(contact_strength, 0.15, 0.08)
    relative = roughness / _MICRON * (10e-3 / curvature) ** (1.0 / 3.0)
    return (3.0 / relative) ** exponent


def equivalent_roughness(flanks: tuple[Value, Value], curvature: Value, *, viscosity: Value, speed: Value) -> Value:
    """Return the equivalent roughness R_zH of a hard flank, by which it works the soft flank of its mate [m].

    Args:
        flanks: R_z of the hard gear and of the soft one, before running in [m].
        curvature: ρ_red at the pitch point [m].
        viscosity: ν_40 [m²/s].
        speed: Pitch-line velocity v [m/s].

    Returns:
        R_zH [m], held between 3 and 16 µm.

    Source: ISO 6336-2:2006, clause 13.3.2: R_z1 (10 mm/ρ_red)^0.33 (R_z1/R_z2)^0.66 / (ν_40 v/1500)^0.33.

    >>> hard = equivalent_roughness((4.8e-6, 8e-6), 173e-3, viscosity=220e-6, speed=1.0)
    >>> round(float(hard) / 1e-6, 2)  # a smooth flank of a wind turbine's planet
    3.0
    """
    hard, soft = flanks
    running_in = (10e-3 / curvature) ** 0.33 * (hard / soft) ** 0.66
    film = (viscosity / _MM2_S * speed / 1500.0) ** 0.33
    return as_value(np.minimum(np.maximum(hard * running_in / film, SMOOTH), 16.0 * _MICRON))


def contact_size_factor(module: Value, treatment: Treatment) -> Value:
    """Return the size factor Z_X of DIN 3990; ISO 6336-2 leaves it at 1.

    Args:
        module: m_n [m].
        treatment: Material group.

    Source: DIN 3990-2:1987, table 4: 1.05 − 0.005 m_n from 10 mm for case- and induction-hardened, 1.08 − 0.011 m_n
        from 7.5 mm for nitrided gears, to 30 mm; 1 for others.

    >>> round(float(contact_size_factor(16e-3, Treatment.CASE_HARDENED)), 3)
    0.97
    """
    if not treatment.is_surface_hardened:
        return 1.0
    size = np.minimum(module / 1e-3, 30.0)
    return as_value(np.minimum(1.0, 1.08 - 0.011 * size if treatment.is_nitrided else 1.05 - 0.005 * size))


def work_hardening_factor(
    hardness: float,
    treatments: tuple[Treatment, Treatment],
    *,
    mate_hardness: float,
    mate_roughness: Value,
    ratio: Value,
) -> Value:
    """Return the work hardening factor Z_W of a gear.

    Args:
        hardness: Brinell hardness of this gear HB [-].
        treatments: Of this gear and of its mate.
        mate_hardness: Brinell hardness of the mate [-].
        mate_roughness: `equivalent_roughness` R_zH of the mate [m].
        ratio: |u| [-].

    Returns:
        Z_W [-]; 1 unless this gear is of soft steel and its steel mate is hard or clearly harder.

    Source: ISO 6336-2:2006, clause 13: 1.2 − (HB − 130)/1700 times (3 µm/R_zH)^0.15 against a hard mate;
        1 + (0.00898 HB_1/HB_2 − 0.00829)(u − 1) between through-hardened gears.
    """
    treatment, mate_treatment = treatments
    if treatment.is_surface_hardened or treatment.is_cast_iron or mate_treatment.is_cast_iron:
        return 1.0
    if mate_treatment.is_surface_hardened:
        base = 1.2 - (min(max(hardness, 130.0), 470.0) - 130.0) / 1700.0
        return as_value(np.maximum(1.0, base * (SMOOTH / np.asarray(mate_roughness)) ** 0.15))
    harder = mate_hardness / hardness
    if harder < 1.2:
        return 1.0
    slope = 0.00698 if harder > 1.7 else 0.00898 * harder - 0.00829
    return 1.0 + slope * (np.minimum(ratio, 20.0) - 1.0)


# ----------------------------------------------------------------------------------------------------------------------
# Tooth bending of cylindrical gears by ISO 6336-3, method B: root stress, permissible stress, safety, by factor.
# ----------------------------------------------------------------------------------------------------------------------


_PART3 = "ISO 6336-3:2019"
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
    ratio = mesh.transverse_contact_ratio / np.cos(mesh.base_helix_angle) ** 2
    deep = np.where(ratio <= 2.05, 1.0, np.where(ratio <= 2.5, 2.366 - 0.666 * ratio, 0.7))
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
    if isinstance(roughness, float):
        return _surface_of_one(roughness, treatment)
    return _surface(roughness, treatment)


@lru_cache(maxsize=256)
def _surface_of_one(roughness: float, treatment: Treatment) -> Value:
    """The same of one gear, as many have it."""
    return _surface(roughness, treatment)


def _surface(roughness: Value, treatment: Treatment) -> Value:
    rough = np.asarray(roughness) / _MICRON
    height = np.minimum(np.maximum(rough, 1.0), 40.0) + 1.0
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


@of_contact
def _shared_and_slanted(
    mesh: MeshGeometry, method: RatingMethod, edition: Edition
) -> tuple[Value, Value, Value | None]:
    """f_ε and Y_β, which both gears have in common, and Y_ε of a load at the tip."""
    tip = contact_ratio_factor_root(mesh) if method is RatingMethod.C else None
    sharing = load_sharing_factor(mesh) if edition is Edition.ISO2019 and tip is None else 1.0
    return sharing, helix_factor(mesh, edition), tip


def bending_rating(
    mesh: MeshGeometry,
    gear: int,
    steel: GearSteel,
    *,
    specific_load: Value,
    loads: ToothLoadFactors,
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
    sharing, helix, tip = _shared_and_slanted(mesh, body.method, body.edition)
    nominal = specific_load / mesh.module * section.form * sharing * section.stress_correction * helix
    nominal = nominal * body.rim * body.deep_tooth * (1.0 if tip is None else tip)
    stress = nominal * loads.bending
    limit = steel.bending_strength * STRESS_CORRECTION_TEST_GEAR * strength.product
    safety = limit / stress
    return BendingRating(section, sharing, helix, body.rim, body.deep_tooth, nominal, stress, limit, safety, tip)
