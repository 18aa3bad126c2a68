"""Rating of a cylindrical gear pair by ISO 6336, its static strength, and balanced profile shifts."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from gearwright.base import DesignError, Origin, Problem, Quantity, SolveError
from gearwright.parts.gears import GearPair
from gearwright.parts.iso6336.dynamic import DynamicFactor, DynamicFactorBySpeed, MeshSprings, mesh_springs
from gearwright.parts.iso6336.geometry import (
    Edition,
    MeshGeometry,
    RootSection,
    Value,
    as_value,
    loaded_sections,
    mesh_geometry,
    outer_single_contact,
    root_section,
)
from gearwright.parts.iso6336.loads import (
    USUAL,
    FaceLoadFactor,
    MeshDuty,
    MeshQuality,
    Steels,
    TipRelief,
    TransverseLoadFactor,
    flank_class,
    load_cycles,
    load_distribution,
    specific_load,
    tip_relief,
)
from gearwright.parts.iso6336.steels import STRESS_CORRECTION_TEST_GEAR, GearSteel, Treatment, life_curves, life_factor
from gearwright.parts.iso6336.tooth_strength import (
    SMOOTH,
    BendingRating,
    ContactStrengthFactors,
    PittingRating,
    RootBody,
    RootStrengthFactors,
    ToothLoadFactors,
    bending_rating,
    bending_size_factor,
    contact_size_factor,
    deep_tooth_factor,
    equivalent_roughness,
    lubricant_factor,
    notch_sensitivity_factor,
    pitting_rating,
    roughness_factor,
    speed_factor,
    surface_factor,
    work_hardening_factor,
)
from gearwright.parts.material import BRINELL_PER_VICKERS
from gearwright.parts.stiffness import LINEAR_LOAD, mesh_stiffness_iso6336

# ----------------------------------------------------------------------------------------------------------------------
# Rating of one cylindrical pair by ISO 6336 parts 1, 2, 3 and 5 in one call, every factor shown.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class PairRating:
    """A rated pair: loads, factors, stresses, safeties."""

    tangential_force: Annotated[Value, Quantity("force"), Origin("F_t = 2 T_1/d_1", "ISO 6336-1:2019, clause 4")]
    """Nominal tangential force of one mesh F_t [N]."""
    speed: Annotated[Value, Quantity("velocity"), Origin("v = ω_1 d_1/2", "ISO 6336-1:2019, clause 4")]
    """Pitch-line velocity v [m/s]."""
    cycles: Annotated[tuple[Value, Value], Quantity("number"), Origin("N_L", "ISO 6336-2:2019, clause 11")]
    """Load cycles of pinion and wheel N_L [-]."""
    dynamic: DynamicFactor | DynamicFactorBySpeed
    """K_V and its terms."""
    face: FaceLoadFactor
    """K_Hβ, K_Fβ and their misalignment."""
    transverse: TransverseLoadFactor
    """K_Hα, K_Fα."""
    loads: ToothLoadFactors
    """All K factors."""
    contact_strength: tuple[ContactStrengthFactors, ContactStrengthFactors]
    """Z factors of the strength of pinion and wheel."""
    pitting: PittingRating
    """Pitting."""
    root_strength: tuple[RootStrengthFactors, RootStrengthFactors]
    """Y factors of the strength of pinion and wheel."""
    bending: tuple[BendingRating, BendingRating]
    """Bending of pinion and wheel."""
    relief: TipRelief
    """Tip relief that K_V reckons with."""
    grade: Annotated[Value, Quantity("number"), Origin("A", "ISO 1328-1:2013; not stated: by v")]
    """Flank tolerance class [-]."""


def rate_pair(
    pair: GearPair,
    steels: Steels,
    duty: MeshDuty,
    *,
    quality: MeshQuality = USUAL,
    edition: Edition = Edition.ISO2019,
) -> PairRating:
    """Return the rating of a pair by ISO 6336.

    Args:
        pair: The pair; its stiffness follows ISO 6336-1, clause 9.
        steels: Of pinion and wheel.
        duty: Torque, speed, life.
        quality: Flanks, mounting and oil.
        edition: Edition of part 3.

    Source: ISO 6336-1:2019, -2:2019, -3:2019, -5:2016; K_V method B, K_Hβ method C, K_Hα method B.

    Raises:
        DesignError: undercut or interfering teeth, and what the stiffness of clause 9 does not cover.
    """
    mesh = mesh_geometry(pair)
    stiff = mesh_stiffness_iso6336(
        pair,
        specific_load=min(LINEAR_LOAD, float(specific_load(mesh, duty))),
        elastic_moduli=(steels[0].elastic_modulus, steels[1].elastic_modulus),
    )
    springs = MeshSprings(stiff.single, stiff.mesh, stiff.face)
    widths = (pair.driver.face_width, pair.driven.face_width)
    return rate_mesh(mesh, steels, duty, quality=quality, edition=edition, springs=springs, widths=widths)


def rate_mesh(
    mesh: MeshGeometry,
    steels: Steels,
    duty: MeshDuty,
    *,
    quality: MeshQuality = USUAL,
    edition: Edition = Edition.ISO2019,
    springs: MeshSprings | None = None,
    widths: tuple[Value, Value] | None = None,
) -> PairRating:
    """Return the rating of one pair or of an array of them, whose teeth the caller has checked.

    Args:
        mesh: The pairs.
        steels: Of pinion and wheel.
        duty: Torque, speed, life.
        quality: Flanks, mounting and oil.
        edition: Edition of part 3, or DIN 3990.
        springs: Stiffness; None: that of solid gears.
        widths: Face widths of pinion and wheel [m], for the roots; None: the common one.

    Source: as `rate_pair`.
    """
    springs = springs or mesh_springs(mesh, specific_load(mesh, duty), steels=steels, blank=quality.blank)
    grade, relief = flank_class(mesh, duty, quality), tip_relief(mesh, springs, steels, duty=duty, quality=quality)
    dynamic, face, transverse = load_distribution(
        mesh, springs, steels, duty=duty, quality=quality, relief=relief, grade=grade
    )
    loads = ToothLoadFactors(
        duty.application_factor,
        duty.mesh_load_factor,
        dynamic.factor,
        face.contact,
        transverse.contact,
        face.bending,
        transverse.bending,
    )
    force = 2.0 * duty.pinion_torque / mesh.pitch_diameters[0]
    speed = 0.5 * np.abs(duty.pinion_speed) * mesh.pitch_diameters[0]
    cycles = load_cycles(mesh, duty)
    contact = _contact_strengths(mesh, steels, cycles, quality=quality, speed=speed, edition=edition)
    pitting = pitting_rating(
        mesh,
        steels,
        force,
        loads=loads,
        strengths=contact,
        profile_factor=quality.profile_factor,
        edition=edition,
    )
    sections = loaded_sections(mesh, quality.choices.root, edition)
    roots = _root_strengths(mesh, steels, cycles, sections=sections, quality=quality)
    deep = deep_tooth_factor(mesh, grade)
    first, second = (
        bending_rating(
            mesh,
            gear,
            steels[gear],
            specific_load=force / width,
            loads=loads,
            strength=roots[gear],
            body=RootBody(quality.rims[gear], deep, edition, quality.choices.root),
            section=sections[gear],
        )
        for gear, width in enumerate(widths or (mesh.face_width, mesh.face_width))
    )
    return PairRating(force, speed, cycles, dynamic, face, transverse, loads, contact, pitting, roots, (first, second),
                      relief, grade)  # fmt: skip


def _contact_strengths(
    mesh: MeshGeometry,
    steels: Steels,
    cycles: tuple[Value, Value],
    *,
    quality: MeshQuality,
    speed: Value,
    edition: Edition,
) -> tuple[ContactStrengthFactors, ContactStrengthFactors]:
    """Z factors of the strength of both gears; the film factors go by the softer one."""
    softer = min(steel.tabulated_strength for steel in steels)
    film = lubricant_factor(quality.viscosity, softer), speed_factor(speed, softer)
    rough = roughness_factor(0.5 * sum(quality.flanks), mesh.relative_curvature, softer)
    first, second = (
        ContactStrengthFactors(
            life=life_factor(life_curves(steel)[0], count),
            lubricant=film[0],
            speed=film[1],
            roughness=rough,
            work_hardening=_work_hardening(mesh, steels, gear, quality=quality, speed=speed, edition=edition),
            size=contact_size_factor(mesh.module, steel.treatment) if edition is Edition.DIN1987 else 1.0,
        )
        for gear, (steel, count) in enumerate(zip(steels, cycles, strict=True))
    )
    return first, second


def _work_hardening(
    mesh: MeshGeometry, steels: Steels, gear: int, *, quality: MeshQuality, speed: Value, edition: Edition
) -> Value:
    """Z_W of one gear by the Brinell hardness of both; DIN 3990 knows no roughness in it, and hard mates alone."""
    steel, mate = steels[gear], steels[1 - gear]
    hard = mate.treatment.is_surface_hardened
    if steel.treatment.is_surface_hardened or (edition is Edition.DIN1987 and not hard):
        return 1.0
    flanks = (quality.flanks[1 - gear], quality.flanks[gear])
    return work_hardening_factor(
        steel.hardness * BRINELL_PER_VICKERS,
        (steel.treatment, mate.treatment),
        mate_hardness=mate.hardness * BRINELL_PER_VICKERS,
        mate_roughness=equivalent_roughness(flanks, mesh.relative_curvature, viscosity=quality.viscosity, speed=speed)
        if hard and edition is not Edition.DIN1987
        else SMOOTH,
        ratio=np.abs(mesh.ratio),
    )


def _root_strengths(
    mesh: MeshGeometry,
    steels: Steels,
    cycles: tuple[Value, Value],
    *,
    sections: Sequence[RootSection],
    quality: MeshQuality,
) -> tuple[RootStrengthFactors, RootStrengthFactors]:
    """Y factors of the strength of both gears."""
    first, second = (
        RootStrengthFactors(
            life=life_factor(life_curves(steel)[1], count),
            notch_sensitivity=notch_sensitivity_factor(section.notch, steel),
            surface=surface_factor(quality.root_roughness, steel.treatment),
            size=bending_size_factor(mesh.module, steel.treatment),
            mean_stress=mean_stress,
        )
        for section, steel, count, mean_stress in zip(sections, steels, cycles, quality.mean_stresses, strict=True)
    )
    return first, second


# ----------------------------------------------------------------------------------------------------------------------
# Static strength of cylindrical gears: what flanks and roots bear once, without pitting, cracking or yielding.
# ----------------------------------------------------------------------------------------------------------------------


_PART2, _PART3 = "ISO 6336-2:2019", "ISO 6336-3:2019"
_MPA = 1e6
_SOFT = 130.0


@dataclass(frozen=True)
class StaticStrength:
    """What one gear bears under a load that comes once."""

    contact_life: Annotated[Value, Quantity("ratio"), Origin("Z_NT, static", f"{_PART2}, table 2")]
    """Z_NT of static stress [-]."""
    work_hardening: Annotated[Value, Quantity("ratio"), Origin("Z_W, static", f"{_PART2}, clause 13")]
    """Z_W of static stress [-]."""
    contact_stress: Annotated[
        Value, Quantity("stress"), Origin("σ_H = Z_B,D σ_H0 √(K_V K_Hβ K_Hα K_γ), K_A = 1", f"{_PART2}, clause 5")
    ]
    """σ_H [Pa]."""
    contact_limit: Annotated[
        Value,
        Quantity("stress"),
        Origin("σ_HG,stat = σ_Hlim Z_NT Z_W, Z_L = Z_v = Z_R = Z_X = 1", f"{_PART2}, clauses 5, 11 to 14"),
    ]
    """σ_HG of static stress [Pa]."""
    contact_safety: Annotated[Value, Quantity("ratio"), Origin("S_H,stat = σ_HG,stat/σ_H", f"{_PART2}, clause 5")]
    """S_H against one load [-]."""
    bending_life: Annotated[Value, Quantity("ratio"), Origin("Y_NT, static", f"{_PART3}, table 1")]
    """Y_NT of static stress [-]."""
    notch_sensitivity: Annotated[
        Value, Quantity("ratio"), Origin("Y_δrelT, static, by Y_S", "ISO 6336-3:2006, clause 12.3")
    ]
    """Y_δrelT of static stress [-]."""
    bending_stress: Annotated[
        Value, Quantity("stress"), Origin("σ_F = σ_F0 K_V K_Fβ K_Fα K_γ, K_A = 1", f"{_PART3}, clause 5")
    ]
    """σ_F [Pa]."""
    bending_limit: Annotated[
        Value,
        Quantity("stress"),
        Origin("σ_FG,stat = σ_Flim Y_ST Y_NT Y_δrelT, Y_RrelT = Y_X = 1", f"{_PART3}, clauses 5, 11 to 14"),
    ]
    """σ_FG of static stress [Pa]."""
    bending_safety: Annotated[Value, Quantity("ratio"), Origin("S_F,stat = σ_FG,stat/σ_F", f"{_PART3}, clause 5")]
    """S_F against one load [-]."""
    yielding_safety: Annotated[
        Value | None,
        Quantity("ratio"),
        Origin("S_y = R_p0.2 Y_S/σ_F", "beam of the critical section, without its notch"),
    ] = None
    """R_p0.2 of the core over the nominal stress of the critical section [-]; None where it is not known."""


def static_notch_sensitivity(correction: Value, steel: GearSteel) -> Value:
    """Return the relative notch sensitivity factor Y_δrelT of static stress.

    Args:
        correction: Y_S [-].
        steel: Of the gear.

    Source: ISO 6336-3:2006, clause 12.3: 0.44 Y_S + 0.12 for case- and induction-hardened roots, 0.20 Y_S + 0.60 for
        nitrided ones; by the yield strength (1 + k (Y_S − 1) s)/(1 + k s), with k = 0.93 and s = (200/σ_S)^¼ for
        structural, k = 0.82 and s = (300/σ_0.2)^¼ for through-hardened steel.
        Grey and ferritic nodular iron are taken at 1, an assumption.
    Valid for: stress up to the first crack, or up to yielding where the steel is soft.

    >>> from gearwright.parts.iso6336.steels import Treatment
    >>> steel = GearSteel("x", Treatment.CASE_HARDENED, "MQ", 700.0, 1500e6, 500e6)
    >>> round(float(static_notch_sensitivity(2.0, steel)), 12)  # of the test gears
    1.0
    """
    if steel.treatment.is_brittle_iron:
        return as_value(np.ones_like(np.asarray(correction)))
    if steel.treatment.is_nitrided:
        return 0.20 * correction + 0.60
    if steel.treatment.is_surface_hardened or steel.yield_strength is None:
        return 0.44 * correction + 0.12
    structural = steel.treatment is Treatment.STRUCTURAL
    weight, reference = (0.93, 200.0) if structural else (0.82, 300.0)
    part = weight * (reference * _MPA / steel.yield_strength) ** 0.25
    return as_value((1.0 + part * (correction - 1.0)) / (1.0 + part))


def static_work_hardening(steel: GearSteel, mate: GearSteel) -> float:
    """Return the work hardening factor Z_W of static stress.

    Args:
        steel: Of the gear.
        mate: Of its mate.

    Source: ISO 6336-2:2006, clause 13: 1.05 − (HB − 130)/680 of a soft gear against a hard mate, 1.05 below 130 HB,
        at least 1; 1 otherwise.
    """
    if steel.treatment.is_cast_iron or steel.treatment.is_surface_hardened or not mate.treatment.is_surface_hardened:
        return 1.0
    above = max(steel.hardness * BRINELL_PER_VICKERS - _SOFT, 0.0)
    return max(1.0, 1.05 - above / 680.0)


def static_strength(
    pitting: PittingRating, bending: tuple[BendingRating, BendingRating], steels: tuple[GearSteel, GearSteel], gear: int
) -> StaticStrength:
    """Return what one gear bears under a load that comes once.

    Args:
        pitting: The mesh under that load, K_A = 1.
        bending: Roots of both gears under it.
        steels: Of both gears.
        gear: 0 for the pinion, 1 for the wheel.

    Source: ISO 6336-2:2019, clauses 5 and 11 to 14; ISO 6336-3:2019, clauses 5 and 11 to 14: reference factors of film,
        roughness and size are 1 for static stress. Y_M is 1, since a load that comes once does not bend both ways.
    """
    steel, root = steels[gear], bending[gear]
    flank_curve, root_curve = life_curves(steel)
    hardening = static_work_hardening(steel, steels[1 - gear])
    sensitivity = static_notch_sensitivity(root.section.stress_correction, steel)
    flank = steel.contact_strength * flank_curve.factors[0] * hardening
    limit = steel.bending_strength * STRESS_CORRECTION_TEST_GEAR * root_curve.factors[0] * sensitivity
    nominal = np.asarray(root.stress) / root.section.stress_correction
    return StaticStrength(
        contact_life=flank_curve.factors[0],
        work_hardening=hardening,
        contact_stress=pitting.stresses[gear],
        contact_limit=flank,
        contact_safety=flank / pitting.stresses[gear],
        bending_life=root_curve.factors[0],
        notch_sensitivity=sensitivity,
        bending_stress=root.stress,
        bending_limit=limit,
        bending_safety=limit / root.stress,
        yielding_safety=None if steel.yield_strength is None else as_value(steel.yield_strength / nominal),
    )


# ----------------------------------------------------------------------------------------------------------------------
# How profile shift is divided between two gears: equal specific sliding, or equal strength of the roots.
# ----------------------------------------------------------------------------------------------------------------------


_HALVINGS = 50
_EDGE = 1e-6
"""Curvature of a flank over the module below which its sliding has no bound [-]."""
Balance = Callable[[MeshGeometry], float]


def specific_slidings(mesh: MeshGeometry) -> tuple[float, float]:
    """Return the largest specific sliding at the roots of both gears, as positive numbers [-].

    Args:
        mesh: The pair, external or internal.

    Returns:
        −ζ_f1 where the wheel's tip touches the pinion, −ζ_f2 where the pinion's tip touches the wheel; infinite where
        a tip reaches past the mate's involute.

    Source: ISO 21771:2007, ζ_f1 = 1 − ρ_A2/(u ρ_A1), ζ_f2 = 1 − u ρ_E1/ρ_E2.

    >>> geometry = MeshGeometry((20.0, 20.0), 1.0, 10.0, 20.0, (11.0, 11.0))
    >>> first, second = specific_slidings(geometry)
    >>> first == second
    True
    """
    side, ratio = float(mesh.side), abs(float(mesh.ratio))
    reach = float(mesh.centre_distance * np.sin(mesh.working_angle))
    tips = [0.5 * float(base * tangent) for base, tangent in zip(mesh.base_diameters, mesh.tip_tangents, strict=True)]
    root_first = side * (reach - tips[1])
    root_second = reach - tips[0] if side > 0.0 else reach + tips[0]
    edge = _EDGE * float(mesh.module)
    first = tips[1] / (ratio * root_first) - 1.0 if root_first > edge else math.inf
    second = ratio * tips[0] / root_second - 1.0 if root_second > edge else math.inf
    return first, second


def sliding_balance(mesh: MeshGeometry) -> float:
    """Return by how much the pinion's root slides more than the wheel's [-]; negative where it slides less.

    Args:
        mesh: The pair.

    Source: DIN 3992:1964 and Niemann & Winter, Maschinenelemente II: equal specific sliding at both ends.
    """
    first, second = specific_slidings(mesh)
    return 0.0 if first == second else first - second


def strength_balance(mesh: MeshGeometry) -> float:
    """Return by how much the nominal root stress of the pinion is above the wheel's, ln of their ratio [-].

    Args:
        mesh: The pair.

    Source: ISO 6336-3:2019, σ_F0 ~ Y_F Y_S, both at the outer point of single contact; gears of one steel.
    """
    first, second = (root_section(outer_single_contact(mesh, gear)) for gear in (0, 1))
    return math.log(float(first.form * first.stress_correction / (second.form * second.stress_correction)))


BALANCES: dict[str, Balance] = {"sliding": sliding_balance, "strength": strength_balance}
"""Name in a design file -> what is to be nothing."""


def balanced_shift(shape: Callable[[float], MeshGeometry], least: float, most: float, *, by: str) -> float:
    """Return the profile shift of the pinion at which both gears are balanced [-]; a limit where none balances them.

    Args:
        shape: x_1 [-] -> the pair, whose other shift follows.
        least: Smallest x_1 that is looked at [-].
        most: Largest x_1 [-].
        by: A name of `BALANCES`.

    Source: bisection; more shift of the pinion lowers its sliding and its root stress, and raises the wheel's.

    Raises:
        DesignError: If no shift between the limits makes teeth.
    """
    balance = BALANCES[by]
    for _ in range(_HALVINGS):
        middle = 0.5 * (least + most)
        try:
            above = balance(shape(middle)) > 0.0
        except SolveError as error:
            raise DesignError([Problem("profile_shift", f"x_1 = {middle:.3f} makes no teeth: {error}")]) from None
        least, most = (middle, most) if above else (least, middle)
    return round(0.5 * (least + most), 4)
