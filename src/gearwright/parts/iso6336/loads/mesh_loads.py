"""The loads of a cylindrical mesh by ISO 6336-1: what it carries, how it is made, and the K factors in their order."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from gearwright.errors import Problem, refuse
from gearwright.parts.iso6336.choices import USUAL_CHOICES, Choices, RatingMethod
from gearwright.parts.iso6336.geometry import MeshGeometry, ToothProportions, Value, as_value
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
    SOLID,
    DynamicFactor,
    MeshDeviations,
    MovingBody,
    dynamic_factor,
    idler_masses,
    lightness,
    mean_allowance,
    reduced_mass,
)
from gearwright.parts.iso6336.loads.dynamic_by_speed import DynamicFactorBySpeed, dynamic_factor_by_speed
from gearwright.parts.iso6336.loads.relief import (
    ReliefRule,
    TipRelief,
    in_ring,
    load_deflection,
    relief_for,
    relief_term,
    running_in_relief,
    usual_class,
)
from gearwright.parts.iso6336.loads.stiffness import MeshSprings
from gearwright.parts.iso6336.loads.tolerances import flank_tolerances
from gearwright.parts.iso6336.pitting import contact_ratio_factor
from gearwright.parts.iso6336.steels import GearSteel

Steels = tuple[GearSteel, GearSteel]


class Neighbour(NamedTuple):
    """The gear beyond an idler, as the vibration of a mesh with it takes it."""

    teeth: Value
    """z, negative of an internal gear [-]."""
    density: float
    """ρ [kg/m³]."""
    body: MovingBody = SOLID
    """Its bore, mates and hold."""


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
    """Load cycles per turn of pinion and wheel [-]; for a sun the number of planets. So many equal meshes move it."""
    relief_torque: Value | None = None
    """Torque on the pinion for which tips are relieved where no relief is stated [N m]; None: this one."""
    fastest: Value | None = None
    """Greatest speed of the pinion relative to the carrier, for a class that is not stated [rad/s]; None: this one."""

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

    grade: Value | None = 5
    """Flank tolerance class of ISO 1328-1 [-]; None: the usual one of the pitch-line velocity."""
    flank_roughness: float | tuple[float, float] = 4e-6
    """R_z of the flanks of both gears, or of each [m]."""
    root_roughness: float = 10e-6
    """R_z of the root fillets [m]."""
    tip_relief: Value | None = 0.0
    """C_a of well-made tip relief [m]; None: by `relief_rule`."""
    relief_rule: ReliefRule = ReliefRule.LOAD
    """What tips are relieved for where no amount is stated."""
    relief_tolerance: float | None = None
    """By how much C_a may miss [m]; None: not at all where an amount is stated, else as ground teeth do."""
    planet: int | None = None
    """Which gear is a planet, 0 or 1: its tips are relieved once, for its stiffer mesh in the ring. None: neither."""
    bodies: tuple[MovingBody, MovingBody] = (SOLID, SOLID)
    """Bores and rims of both gears, for K_V; how many meshes move them is in the duty."""
    blank: float = 1.0
    """Gear blank factor C_R of the stiffness [-]; 1 of solid and bored gears."""
    beyond: tuple[Neighbour | None, Neighbour | None] = (None, None)
    """What the first and the second gear mesh with besides, where they are idlers."""
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


def flank_class(mesh: MeshGeometry, duty: MeshDuty, quality: MeshQuality) -> Value:
    """Return the flank tolerance class of a mesh: as stated, or the usual one of its greatest speed [-].

    Args:
        mesh: The pair.
        duty: With its greatest speed.
        quality: With the class, if it is stated.

    Source: ISO 1328-1:2013; `usual_class`.
    """
    if quality.grade is not None:
        return quality.grade
    fastest = duty.pinion_speed if duty.fastest is None else duty.fastest
    return usual_class(0.5 * np.abs(fastest) * mesh.pitch_diameters[0])


def tip_relief(
    mesh: MeshGeometry, springs: MeshSprings, steels: Steels, *, duty: MeshDuty, quality: MeshQuality
) -> TipRelief:
    """Return the tip relief of a mesh: as stated, or for the load that does most damage, or what running in leaves.

    Args:
        mesh: The pair.
        springs: Its stiffness.
        steels: Of the two gears.
        duty: With the torque for which tips are relieved.
        quality: With the relief, if it is stated.

    Source: ISO 6336-1:2019, clause 6.5.5; ISO/TS 6336-20:2017, C_eff.
    """
    load, single = specific_load(mesh, duty), springs.single
    design = load if duty.relief_torque is None else load * np.asarray(duty.relief_torque) / duty.pinion_torque
    if quality.planet is not None:
        springs = in_ring(mesh, springs, quality.planet)
    deflection = load_deflection(mesh, springs, load, design)
    run_in = running_in_relief(steels)
    tolerance = quality.relief_tolerance
    if quality.tip_relief is not None:
        made = TipRelief(quality.tip_relief, deflection)
    elif quality.relief_rule is ReliefRule.RUN_IN:
        made = TipRelief(run_in, deflection)
    else:
        made = relief_for(deflection, mesh.module, run_in)
    made = replace(made, stiffness=single)
    return made if tolerance is None else replace(made, tolerance=tolerance, stated=True)


def moving_masses(mesh: MeshGeometry, steels: Steels, *, duty: MeshDuty, quality: MeshQuality) -> tuple[Value, ...]:
    """Return the masses per face width that a mesh moves: one, or two for each of its gears that is an idler [kg/m].

    Args:
        mesh: The pair.
        steels: Of the two gears.
        duty: With the meshes that move each gear.
        quality: With bores, rims, and the gears beyond idlers.

    Source: ISO 6336-1:2006, clause 6.5.9.
    """
    pairs = zip(quality.bodies, duty.meshes_per_turn, strict=True)
    first, second = (replace(body, meshes=max(body.meshes, meshes)) for body, meshes in pairs)
    own = tuple(lightness(mesh, gear, steels[gear].density, body) for gear, body in enumerate((first, second)))
    masses = list[Value]()
    for gear, neighbour in enumerate(quality.beyond):
        if neighbour is not None:
            row = _beyond(mesh, gear, neighbour.teeth)
            far = lightness(row, 1, neighbour.density, neighbour.body)
            masses += idler_masses(own[1 - gear], own[gear], far)
    return tuple(masses) or (reduced_mass(mesh, (steels[0].density, steels[1].density), (first, second)),)


def _beyond(mesh: MeshGeometry, gear: int, teeth: Value) -> MeshGeometry:
    """Return an idler and the gear beyond it, unshifted, of the mesh's module."""
    module = mesh.module / np.cos(mesh.helix_angle)
    idler, side = np.abs(mesh.teeth[gear]), np.sign(teeth)
    radii = 0.5 * idler * module, 0.5 * np.abs(teeth) * module
    return replace(
        mesh,
        teeth=(idler, teeth),
        centre_distance=radii[1] + side * radii[0],
        tip_radii=(radii[0] + mesh.module, radii[1] + side * mesh.module),
        proportions=(ToothProportions(), ToothProportions()),
    )


def load_distribution(
    mesh: MeshGeometry,
    springs: MeshSprings,
    steels: Steels,
    *,
    duty: MeshDuty,
    quality: MeshQuality,
    relief: TipRelief,
    grade: Value,
) -> tuple[DynamicFactor | DynamicFactorBySpeed, FaceLoadFactor, TransverseLoadFactor]:
    """Return K_V, the face and the transverse load factors, in the order in which they build on each other.

    Args:
        mesh: The pair.
        springs: Its stiffness.
        steels: Of the two gears.
        duty: Torque and speed.
        quality: Flanks and mounting.
        relief: From `tip_relief`.
        grade: From `flank_class` [-].

    Source: ISO 6336-1:2019, clauses 6 to 9.
    """
    specific = specific_load(mesh, duty)
    speed = 0.5 * np.abs(duty.pinion_speed) * mesh.pitch_diameters[0]
    pitch, profile, slope = _deviations(mesh, grade)
    pitch_left = pitch - mean_allowance(pitch, steels, speed)
    if quality.choices.dynamic is RatingMethod.C:
        dynamic: DynamicFactor | DynamicFactorBySpeed = dynamic_factor_by_speed(
            mesh, grade, specific_load=specific, speed=speed
        )
    else:
        left = relief_term(relief, specific, grade=grade)
        dynamic = dynamic_factor(
            mesh,
            springs,
            MeshDeviations(pitch_left, profile - mean_allowance(profile, steels, speed), left),
            specific_load=specific,
            pinion_speed=np.abs(duty.pinion_speed),
            masses=moving_masses(mesh, steels, duty=duty, quality=quality),
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


def _deviations(mesh: MeshGeometry, grade: Value) -> tuple[Value, Value, Value]:
    """Greater f_pb of the two gears, f_fα of their module, and f_ma = √(f_Hβ1² + f_Hβ2²) [m]."""
    pinion, wheel = (flank_tolerances(d, mesh.module, mesh.face_width, grade=grade) for d in mesh.pitch_diameters)
    return (
        np.maximum(pinion.single_pitch, wheel.single_pitch) * np.cos(mesh.transverse_angle),
        pinion.profile_form,
        np.hypot(pinion.helix_slope, wheel.helix_slope),
    )
