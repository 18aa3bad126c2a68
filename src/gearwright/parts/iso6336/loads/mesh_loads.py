"""The loads of a cylindrical mesh by ISO 6336-1: what it carries, how it is made, and the K factors in their order."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from gearwright.errors import Problem, refuse
from gearwright.parts.iso6336.choices import USUAL_CHOICES, Choices, RatingMethod
from gearwright.parts.iso6336.geometry import MeshGeometry, Value, as_value
from gearwright.parts.iso6336.loads.distribution import (
    CENTRED,
    UNMODIFIED,
    FaceLoadFactor,
    HelixModification,
    Misalignment,
    PinionShaft,
    TransverseLoadFactor,
    deflection_misalignment,
    face_load_factor,
    transverse_load_factor,
)
from gearwright.parts.iso6336.loads.dynamic import (
    DynamicFactor,
    MeshDeviations,
    dynamic_factor,
    mean_allowance,
    reduced_mass,
)
from gearwright.parts.iso6336.loads.dynamic_by_speed import DynamicFactorBySpeed, dynamic_factor_by_speed
from gearwright.parts.iso6336.loads.stiffness import MeshSprings
from gearwright.parts.iso6336.loads.tolerances import flank_tolerances
from gearwright.parts.iso6336.pitting import contact_ratio_factor
from gearwright.parts.iso6336.steels import GearSteel

Steels = tuple[GearSteel, GearSteel]


@dataclass(frozen=True)
class MeshDuty:
    """What the mesh carries, and for how long."""

    pinion_torque: Value
    """Nominal torque of one mesh on the pinion T_1 [N m]."""
    pinion_speed: Value
    """Speed of the pinion relative to the carrier ω_1 [rad/s]."""
    life: Value
    """Required life [s]."""
    application_factor: float = 1.0
    """K_A [-]."""
    mesh_load_factor: float = 1.0
    """K_γ of parallel paths [-]."""
    meshes_per_turn: tuple[float, float] = (1.0, 1.0)
    """Load cycles per turn of pinion and wheel [-]; for a sun the number of planets."""

    def __post_init__(self) -> None:
        refuse(
            Problem(name, f"{np.min(np.asarray(value)):.6g} given; must be above 0")
            for name, value in (
                ("pinion_torque", self.pinion_torque),
                ("pinion_speed", np.abs(self.pinion_speed)),
                ("life", self.life),
                ("application_factor", self.application_factor),
                ("mesh_load_factor", self.mesh_load_factor),
            )
            if not np.all(np.asarray(value) > 0.0)
        )


@dataclass(frozen=True)
class MeshQuality:
    """How the flanks are made and mounted."""

    grade: int = 5
    """Flank tolerance class of ISO 1328-1 [-]."""
    flank_roughness: float | tuple[float, float] = 4e-6
    """R_z of the flanks of both gears, or of each [m]."""
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
    choices: Choices = USUAL_CHOICES
    """Method of the factors that have a choice."""

    @property
    def flanks(self) -> tuple[float, float]:
        """R_z of the flanks of pinion and wheel [m]."""
        roughness = self.flank_roughness
        return roughness if isinstance(roughness, tuple) else (roughness, roughness)


USUAL = MeshQuality()
"""Class 5, ground and without helix modification."""


def load_cycles(mesh: MeshGeometry, duty: MeshDuty) -> tuple[Value, Value]:
    """Return the load cycles of pinion and wheel N_L [-].

    Args:
        mesh: The pair.
        duty: Speed, life and meshes per turn.

    Source: ISO 6336-2:2019, clause 11.
    """
    turns = np.abs(duty.pinion_speed) * duty.life / (2.0 * np.pi)
    return turns * duty.meshes_per_turn[0], turns * duty.meshes_per_turn[1] / np.abs(mesh.ratio)


def specific_load(mesh: MeshGeometry, duty: MeshDuty) -> Value:
    """Return the specific load before the dynamic factor F_t K_A K_γ / b [N/m].

    Args:
        mesh: The pair.
        duty: Torque and factors.

    Source: ISO 6336-1:2019, clause 4.
    """
    nominal = 2.0 * duty.pinion_torque / mesh.pitch_diameters[0] / mesh.face_width
    return nominal * duty.application_factor * duty.mesh_load_factor


def load_distribution(
    mesh: MeshGeometry, springs: MeshSprings, steels: Steels, *, duty: MeshDuty, quality: MeshQuality
) -> tuple[DynamicFactor | DynamicFactorBySpeed, FaceLoadFactor, TransverseLoadFactor]:
    """Return K_V, the face and the transverse load factors, in the order in which they build on each other.

    Args:
        mesh: The pair.
        springs: Its stiffness.
        steels: Of the two gears.
        duty: Torque and speed.
        quality: Flanks and mounting.

    Source: ISO 6336-1:2019, clauses 6 to 9.
    """
    specific = specific_load(mesh, duty)
    speed = 0.5 * np.abs(duty.pinion_speed) * mesh.pitch_diameters[0]
    pitch, profile, slope = _deviations(mesh, quality.grade)
    pitch_left = pitch - mean_allowance(pitch, steels, speed)
    if quality.choices.dynamic is RatingMethod.C:
        dynamic: DynamicFactor | DynamicFactorBySpeed = dynamic_factor_by_speed(
            mesh, quality.grade, specific_load=specific, speed=speed
        )
    else:
        dynamic = dynamic_factor(
            mesh,
            springs,
            MeshDeviations(pitch_left, profile - mean_allowance(profile, steels, speed), quality.tip_relief),
            specific_load=specific,
            pinion_speed=np.abs(duty.pinion_speed),
            mass=reduced_mass(mesh, (steels[0].density, steels[1].density)),
        )
    dynamic = replace(dynamic, factor=as_value(np.maximum(dynamic.factor, quality.choices.least_dynamic)))
    with_dynamic = specific * dynamic.factor
    deflection = deflection_misalignment(
        mesh,
        with_dynamic,
        quality.shaft,
        paths=duty.meshes_per_turn[0],
        elastic_modulus=steels[0].elastic_modulus,
    )
    face = face_load_factor(
        mesh,
        Misalignment(deflection, slope),
        steels,
        stiffness=springs.face,
        specific_load=with_dynamic,
        speed=speed,
        modification=quality.helix,
    )
    transverse = transverse_load_factor(
        mesh,
        pitch_left,
        stiffness=springs.mesh,
        specific_load=with_dynamic * face.contact,
        contact_ratio_factor=contact_ratio_factor(mesh),
    )
    return dynamic, face, transverse


def _deviations(mesh: MeshGeometry, grade: int) -> tuple[Value, Value, Value]:
    """Greater f_pb of the two gears, f_fα of their module, and f_ma = √(f_Hβ1² + f_Hβ2²) [m]."""
    pinion, wheel = (flank_tolerances(d, mesh.module, mesh.face_width, grade=grade) for d in mesh.pitch_diameters)
    return (
        np.maximum(pinion.single_pitch, wheel.single_pitch) * np.cos(mesh.transverse_angle),
        pinion.profile_form,
        np.hypot(pinion.helix_slope, wheel.helix_slope),
    )
