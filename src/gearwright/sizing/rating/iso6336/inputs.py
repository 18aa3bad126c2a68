"""What ISO 6336 is told of a stage: steel, quality of flanks and roots, and duty."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from gearwright.catalogue import is_cast_iron, rated_steel
from gearwright.identity import Role
from gearwright.parts import Material
from gearwright.parts.agma2001 import reliability_factor
from gearwright.parts.iso6336 import (
    CENTRED,
    CORRECTED_AND_CROWNED,
    CROWNED,
    LIFE_AT_1E10,
    UNMODIFIED,
    Choices,
    Edition,
    GearSteel,
    MeshDuty,
    MeshQuality,
    PinionShaft,
    RatingMethod,
    Steels,
    bending_life_curve,
    contact_life_curve,
)
from gearwright.sizing.rating.rules import Rating

IDLER_MEAN_STRESS = 0.7
"""Y_M of gears that are loaded on both flanks alike [-] (ISO 6336-3:2019, annex B)."""
SQUARE_MM = 1e-6
_PARTS = tuple((f"ISO 6336-{part}", f"DIN 3990-{part}:1987") for part in (1, 2, 3))
EDITIONS = {"iso6336": Edition.ISO2019, "iso6336-2006": Edition.ISO2006, "din3990": Edition.DIN1987}
"""Name of a method -> edition."""
WITH_OWN_STEEL = (Role.WHEEL, Role.RING)
"""Gears that may be of another steel than the rest of their stage."""
ASKED_RELIABILITY = 0.99
"""Part of the gears that survive σ_lim of ISO 6336-5 [-]."""
_HELIX = {"none": UNMODIFIED, "crowning": CROWNED, "corrected": CORRECTED_AND_CROWNED}


def steel_of(rating: Rating, role: Role = Role.PINION) -> GearSteel:
    """Return the steel of a gear as ISO 6336 rates it.

    Args:
        rating: Resolved rules.
        role: Of the gear; wheels and rings may be of a steel of their own.

    Raises:
        DesignError: Unknown class or grade, or a hardness outside the grade's range.
    """
    rules = rating.rules.iso6336
    if rules.wheel is None or role not in WITH_OWN_STEEL:
        steel = rated_steel(rating.material, rules.steel, rules.grade, hardness=rules.hardness_hv)
    else:
        own = rules.wheel
        steel = rated_steel(rating.material, own.steel, own.grade, hardness=own.hardness_hv, base=rules.steel)
        steel = replace(steel, yield_strength=own.yield_strength or _proof_of(rating.material, steel))
    return _surviving(_lasting(steel, rating), rules.reliability)


def _proof_of(material: Material, own: GearSteel) -> float | None:
    """Return R_p0.2 of a material for a gear of another class; that of a steel is none of an iron's [Pa]."""
    return None if own.treatment.is_cast_iron and not is_cast_iron(material.steel) else material.yield_strength


def steels_of(rating: Rating, roles: tuple[Role, Role]) -> Steels:
    """Return the steels of both gears of a mesh.

    Args:
        rating: Resolved rules.
        roles: What both gears are in their stage.

    Raises:
        DesignError: Unknown class or grade, or a hardness outside the grade's range.
    """
    return steel_of(rating, roles[0]), steel_of(rating, roles[1])


def _lasting(steel: GearSteel, rating: Rating) -> GearSteel:
    """Return a steel with the S-N curves asked for: DIN 3990 has no fall beyond the knee; its own curves stay."""
    rules = rating.rules.iso6336
    end = 1.0 if EDITIONS.get(rating.method) is Edition.DIN1987 else rules.life_factor_1e10
    if end == LIFE_AT_1E10 and not rules.some_pitting:
        return steel
    flank = contact_life_curve(steel.treatment, some_pitting=rules.some_pitting, at_1e10=end)
    root = bending_life_curve(steel.treatment, at_1e10=end)
    return replace(steel, contact_life=steel.contact_life or flank, bending_life=steel.bending_life or root)


def _surviving(steel: GearSteel, reliability: float) -> GearSteel:
    """Return a steel with the strengths that another part of the gears survives, by the table of AGMA 2001."""
    if reliability == ASKED_RELIABILITY:
        return steel
    factor = float(reliability_factor(reliability))
    return replace(
        steel,
        contact_strength=steel.contact_strength / factor,
        bending_strength=steel.bending_strength / factor,
        survival=factor,
        source=f"{steel.source or 'ISO 6336-5:2016, table 1'}; over K_R = {factor:.4g}, AGMA 2001-D04, table 11",
    )


def clause_of(source: str, edition: Edition) -> str:
    """Return the source of a quantity in the words of an edition; of DIN 3990 its part.

    Args:
        source: With the edition of 2019.
        edition: That rates.
    """
    if edition is Edition.ISO2006:
        return source.replace(":2019", ":2006")
    if edition is Edition.DIN1987:
        return next((own for part, own in _PARTS if part in source), source)
    return source


def mean_stress_factor(reverse: float) -> float:
    """Return Y_M of a gear that is loaded on both flanks [-].

    Args:
        reverse: Load of the less loaded flank over that of the other, 0 to 1 [-].

    Source: ISO 6336-3:2019, annex B, 1/Y_M = 1 - R (1 - M)/(1 + M) with R = -1.2 times that part (the root is bent back
        by more than its own flank's load), and the M that makes it 0.7 where both flanks are loaded alike, 0.47: what
        case-hardened steel has, 0.8 - 0.15 Y_S, at Y_S = 2.2; the equation from memory.

    >>> round(mean_stress_factor(0.5), 3)  # 7/(7 + 3/2)
    0.824
    """
    return IDLER_MEAN_STRESS / (IDLER_MEAN_STRESS + (1.0 - IDLER_MEAN_STRESS) * reverse)


def quality_of(
    rating: Rating,
    *,
    idlers: tuple[bool, bool],
    reverse: tuple[float, float] = (1.0, 1.0),
    shaft: PinionShaft = CENTRED,
    rims: tuple[float, float] = (1.0, 1.0),
) -> MeshQuality:
    """Return how the flanks of a stage are made and mounted.

    Args:
        rating: Resolved rules.
        idlers: Which of the two gears is loaded on both flanks.
        reverse: Load of the less loaded flank over that of the other, of gears that are [-].
        shaft: Where the pinion sits on its shaft.
        rims: Y_B of both gears [-].
    """
    rules = rating.rules.iso6336
    means = [mean_stress_factor(part) if idler else 1.0 for idler, part in zip(idlers, reverse, strict=True)]
    return MeshQuality(
        grade=rules.tolerance_class,
        flank_roughness=rules.flank_roughness,
        root_roughness=rules.root_roughness,
        tip_relief=rules.tip_relief,
        helix=_HELIX[rules.helix_modification],
        shaft=shaft,
        viscosity=rules.oil_viscosity * SQUARE_MM,
        rims=rims,
        mean_stresses=(means[0], means[1]),
        choices=Choices(
            RatingMethod(rules.dynamic_method),
            RatingMethod(rules.root_method),
            rules.least_dynamic_factor,
        ),
    )


def duty_of(
    rating: Rating, torque: ArrayLike, speed: ArrayLike, *, life: ArrayLike, passes: tuple[float, float]
) -> MeshDuty:
    """Return what a cylindrical mesh carries.

    Args:
        rating: Resolved rules.
        torque: On the first gear, of one mesh, load factor included [N m].
        speed: Of the first gear against the carrier [rad/s].
        life: Time under that load [s].
        passes: Mates that a tooth of each gear meets in a turn [-].
    """
    return MeshDuty(
        np.asarray(torque, dtype=float) / rating.load_factor,
        np.asarray(speed, dtype=float),
        np.asarray(life, dtype=float),
        application_factor=rating.service.application_factor,
        mesh_load_factor=rating.load_factor,
        meshes_per_turn=passes,
    )
