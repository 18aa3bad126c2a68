"""Rating of one cylindrical pair by ISO 6336 parts 1, 2, 3 and 5 in one call, every factor shown."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from gearwright.parts.gears import GearPair
from gearwright.parts.hardness import BRINELL_PER_VICKERS
from gearwright.parts.iso6336.bending import (
    BendingRating,
    RootBody,
    RootStrengthFactors,
    bending_rating,
    bending_size_factor,
    deep_tooth_factor,
    loaded_tooth,
    notch_sensitivity_factor,
    surface_factor,
)
from gearwright.parts.iso6336.film import (
    SMOOTH,
    contact_size_factor,
    equivalent_roughness,
    lubricant_factor,
    roughness_factor,
    speed_factor,
    work_hardening_factor,
)
from gearwright.parts.iso6336.geometry import MeshGeometry, Value, mesh_geometry
from gearwright.parts.iso6336.loads import (
    USUAL,
    DynamicFactor,
    DynamicFactorBySpeed,
    FaceLoadFactor,
    MeshDuty,
    MeshQuality,
    MeshSprings,
    Steels,
    TipRelief,
    TransverseLoadFactor,
    flank_class,
    load_cycles,
    load_distribution,
    mesh_springs,
    specific_load,
    tip_relief,
)
from gearwright.parts.iso6336.pitting import ContactStrengthFactors, LoadFactors, PittingRating, pitting_rating
from gearwright.parts.iso6336.root import Edition, RootSection, root_section
from gearwright.parts.iso6336.steels import life_curves, life_factor
from gearwright.parts.stiffness import LINEAR_LOAD, mesh_stiffness_iso6336
from gearwright.units import Origin, Quantity


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
    loads: LoadFactors
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
    loads = LoadFactors(
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
    sections = [root_section(loaded_tooth(mesh, gear, quality.choices.root), edition) for gear in (0, 1)]
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
    first, second = (
        ContactStrengthFactors(
            life=life_factor(life_curves(steel)[0], count),
            lubricant=lubricant_factor(quality.viscosity, softer),
            speed=speed_factor(speed, softer),
            roughness=roughness_factor(0.5 * sum(quality.flanks), mesh.relative_curvature, softer),
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
    if edition is Edition.DIN1987 and not mate.treatment.is_surface_hardened:
        return 1.0
    flanks = (quality.flanks[1 - gear], quality.flanks[gear])
    return work_hardening_factor(
        steel.hardness * BRINELL_PER_VICKERS,
        (steel.treatment, mate.treatment),
        mate_hardness=mate.hardness * BRINELL_PER_VICKERS,
        mate_roughness=SMOOTH
        if edition is Edition.DIN1987
        else equivalent_roughness(flanks, mesh.relative_curvature, viscosity=quality.viscosity, speed=speed),
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
