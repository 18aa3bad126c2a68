"""Rating of one cylindrical pair by ISO 6336 parts 1, 2, 3 and 5 in one call, every factor shown."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from gearwright.parts.gear_pair import GearPair
from gearwright.parts.iso6336_bending import (
    BendingRating,
    Edition,
    RootStrengthFactors,
    bending_rating,
    bending_size_factor,
    deep_tooth_factor,
    notch_sensitivity_factor,
    surface_factor,
)
from gearwright.parts.iso6336_distribution import (
    CENTRED,
    UNMODIFIED,
    FaceLoadFactor,
    HelixModification,
    PinionShaft,
    TransverseLoadFactor,
    deflection_misalignment,
    face_load_factor,
    transverse_load_factor,
)
from gearwright.parts.iso6336_dynamic import DynamicFactor, MeshDeviations, dynamic_factor, mean_allowance, reduced_mass
from gearwright.parts.iso6336_film import (
    contact_size_factor,
    lubricant_factor,
    roughness_factor,
    speed_factor,
    work_hardening_factor,
)
from gearwright.parts.iso6336_geometry import MeshGeometry, Value, mesh_geometry
from gearwright.parts.iso6336_life import bending_life_curve, contact_life_curve, life_factor
from gearwright.parts.iso6336_pitting import (
    ContactStrengthFactors,
    LoadFactors,
    PittingRating,
    contact_ratio_factor,
    pitting_rating,
)
from gearwright.parts.iso6336_root import outer_single_contact, root_section
from gearwright.parts.iso6336_strength import GearSteel
from gearwright.parts.iso6336_tolerances import flank_tolerances
from gearwright.parts.mesh_stiffness_iso6336 import LINEAR_LOAD, mesh_stiffness_iso6336
from gearwright.units import Origin, Quantity

Steels = tuple[GearSteel, GearSteel]
_BRINELL_PER_VICKERS = 0.95  # ISO 18265:2013, table A.1, steels up to 400 HV


@dataclass(frozen=True)
class MeshDuty:
    """What the mesh carries, and for how long."""

    pinion_torque: float
    """Nominal torque of one mesh on the pinion T_1 [N m]."""
    pinion_speed: float
    """Speed of the pinion relative to the carrier ω_1 [rad/s]."""
    life: float
    """Required life [s]."""
    application_factor: float = 1.0
    """K_A [-]."""
    mesh_load_factor: float = 1.0
    """K_γ of parallel paths [-]."""
    meshes_per_turn: tuple[float, float] = (1.0, 1.0)
    """Load cycles per turn of pinion and wheel [-]; for a sun the number of planets."""


@dataclass(frozen=True)
class MeshQuality:
    """How the flanks are made and mounted."""

    grade: int = 5
    """Flank tolerance class of ISO 1328-1 [-]."""
    flank_roughness: float = 4e-6
    """Mean R_z of the two flanks [m]."""
    root_roughness: float = 10e-6
    """R_z of the root fillets [m]."""
    tip_relief: float = 0.0
    """C_a of well-made tip relief [m]."""
    helix: HelixModification = UNMODIFIED
    """Helix modification."""
    shaft: PinionShaft = CENTRED
    """Where the pinion sits."""
    viscosity: float = 100e-6
    """Kinematic viscosity of the oil at 40 °C ν_40 [m²/s]."""
    rims: tuple[float, float] = (1.0, 1.0)
    """Rim factors Y_B of pinion and wheel [-], from `rim_factor`."""
    mean_stresses: tuple[float, float] = (1.0, 1.0)
    """Y_M of pinion and wheel [-]; 0.7 for gears loaded on both flanks."""
    profile_factor: float = 1.0
    """f_ZCa of helical gears [-], see `single_contact_factors`."""


USUAL = MeshQuality()
"""Class 5, ground and without helix modification."""


@dataclass(frozen=True)
class PairRating:
    """A rated pair: loads, factors, stresses, safeties."""

    tangential_force: Annotated[Value, Quantity("force"), Origin("F_t = 2 T_1/d_1", "ISO 6336-1:2019, clause 4")]
    """Nominal tangential force of one mesh F_t [N]."""
    speed: Annotated[Value, Quantity("velocity"), Origin("v = ω_1 d_1/2", "ISO 6336-1:2019, clause 4")]
    """Pitch-line velocity v [m/s]."""
    cycles: tuple[float, float]
    """Load cycles of pinion and wheel N_L [-]."""
    dynamic: DynamicFactor
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
    force = 2.0 * duty.pinion_torque / mesh.pitch_diameters[0]
    speed = 0.5 * duty.pinion_speed * mesh.pitch_diameters[0]
    dynamic, face, transverse = load_distribution(pair, mesh, steels, duty=duty, quality=quality)
    loads = LoadFactors(
        duty.application_factor,
        duty.mesh_load_factor,
        dynamic.factor,
        face.contact,
        transverse.contact,
        face.bending,
        transverse.bending,
    )
    cycles = load_cycles(mesh, duty)
    contact = _contact_strengths(mesh, steels, cycles, quality=quality, speed=speed)
    pitting = pitting_rating(mesh, steels, force, loads=loads, strengths=contact, profile_factor=quality.profile_factor)
    roots = _root_strengths(mesh, steels, cycles, quality=quality)
    deep = deep_tooth_factor(mesh, quality.grade)
    bending = [
        bending_rating(
            mesh,
            gear,
            steels[gear],
            specific_load=force / width,
            loads=loads,
            strength=roots[gear],
            body=(quality.rims[gear], deep, edition),
        )
        for gear, width in enumerate((pair.driver.face_width, pair.driven.face_width))
    ]
    return PairRating(
        force, speed, cycles, dynamic, face, transverse, loads, contact, pitting, roots, (bending[0], bending[1])
    )


def load_cycles(mesh: MeshGeometry, duty: MeshDuty) -> tuple[float, float]:
    """Return the load cycles of pinion and wheel N_L [-].

    Args:
        mesh: The pair.
        duty: Speed, life and meshes per turn.

    Source: ISO 6336-2:2019, clause 11.
    """
    turns = abs(duty.pinion_speed) * duty.life / (2.0 * np.pi)
    return turns * duty.meshes_per_turn[0], float(turns * duty.meshes_per_turn[1] / np.abs(mesh.ratio))


def load_distribution(
    pair: GearPair, mesh: MeshGeometry, steels: Steels, *, duty: MeshDuty, quality: MeshQuality
) -> tuple[DynamicFactor, FaceLoadFactor, TransverseLoadFactor]:
    """Return K_V, the face and the transverse load factors, in the order in which they build on each other.

    Args:
        pair: The pair.
        mesh: Its geometry.
        steels: Of the two gears.
        duty: Torque and speed.
        quality: Flanks and mounting.

    Source: ISO 6336-1:2019, clauses 6 to 9.
    """
    nominal = 2.0 * duty.pinion_torque / mesh.pitch_diameters[0] / mesh.face_width
    specific = nominal * duty.application_factor * duty.mesh_load_factor
    speed = 0.5 * abs(duty.pinion_speed) * mesh.pitch_diameters[0]
    stiff = mesh_stiffness_iso6336(pair, specific_load=min(LINEAR_LOAD, float(specific)))
    pitch, profile, slope = _deviations(mesh, quality.grade)
    pitch_left = pitch - mean_allowance(pitch, steels, speed)
    deviations = MeshDeviations(pitch_left, profile - mean_allowance(profile, steels, speed), quality.tip_relief)
    dynamic = dynamic_factor(
        mesh,
        (stiff.single, stiff.mesh),
        deviations,
        specific_load=specific,
        pinion_speed=abs(duty.pinion_speed),
        mass=reduced_mass(mesh, (steels[0].density, steels[1].density)),
    )
    with_dynamic = specific * dynamic.factor
    deflection = deflection_misalignment(mesh, with_dynamic, quality.shaft, paths=duty.meshes_per_turn[0])
    face = face_load_factor(
        mesh,
        (deflection, slope),
        steels,
        stiffness=stiff.face,
        specific_load=with_dynamic,
        speed=speed,
        modification=quality.helix,
    )
    transverse = transverse_load_factor(
        mesh,
        pitch_left,
        stiffness=stiff.mesh,
        specific_load=with_dynamic * face.contact,
        contact_ratio_factor=contact_ratio_factor(mesh),
    )
    return dynamic, face, transverse


def _deviations(mesh: MeshGeometry, grade: int) -> tuple[Value, Value, Value]:
    """Greater f_pb and f_fα of the two gears, and f_ma = √(f_Hβ1² + f_Hβ2²) [m]."""
    one, two = (flank_tolerances(d, mesh.module, mesh.face_width, grade=grade) for d in mesh.pitch_diameters)
    return (
        np.maximum(one.single_pitch, two.single_pitch) * np.cos(mesh.transverse_angle),
        np.maximum(one.profile_form, two.profile_form),
        np.hypot(one.helix_slope, two.helix_slope),
    )


def _contact_strengths(
    mesh: MeshGeometry, steels: Steels, cycles: tuple[float, float], *, quality: MeshQuality, speed: Value
) -> tuple[ContactStrengthFactors, ContactStrengthFactors]:
    """Z factors of the strength of both gears; the film factors go by the softer one."""
    softer = min(steel.contact_strength for steel in steels)
    first, second = (
        ContactStrengthFactors(
            life=life_factor(contact_life_curve(steel.treatment), count),
            lubricant=lubricant_factor(quality.viscosity, softer),
            speed=speed_factor(speed, softer),
            roughness=roughness_factor(quality.flank_roughness, mesh.relative_curvature, softer),
            work_hardening=_work_hardening(mesh, steels, gear, quality=quality),
            size=contact_size_factor(mesh.module, steel.treatment),
        )
        for gear, (steel, count) in enumerate(zip(steels, cycles, strict=True))
    )
    return first, second


def _work_hardening(mesh: MeshGeometry, steels: Steels, gear: int, *, quality: MeshQuality) -> float:
    """Z_W of one gear by the Brinell hardness of both."""
    own, mate = steels[gear], steels[1 - gear]
    return work_hardening_factor(
        own.hardness * _BRINELL_PER_VICKERS,
        (own.treatment, mate.treatment),
        mate_hardness=mate.hardness * _BRINELL_PER_VICKERS,
        mate_roughness=quality.flank_roughness,
        ratio=float(np.abs(mesh.ratio)),
    )


def _root_strengths(
    mesh: MeshGeometry, steels: Steels, cycles: tuple[float, float], *, quality: MeshQuality
) -> tuple[RootStrengthFactors, RootStrengthFactors]:
    """Y factors of the strength of both gears."""
    first, second = (
        RootStrengthFactors(
            life=life_factor(bending_life_curve(steel.treatment), count),
            notch_sensitivity=notch_sensitivity_factor(root_section(outer_single_contact(mesh, gear)).notch, steel),
            surface=surface_factor(quality.root_roughness, steel.treatment),
            size=bending_size_factor(mesh.module, steel.treatment),
            mean_stress=quality.mean_stresses[gear],
        )
        for gear, (steel, count) in enumerate(zip(steels, cycles, strict=True))
    )
    return first, second
