"""Load factors of a cylindrical mesh by ISO 6336-1, with flank tolerances and tip relief."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum
from typing import Annotated, NamedTuple

import numpy as np

from gearwright.base import Origin, Problem, Quantity, refuse
from gearwright.parts.iso6336.dynamic import (
    SOLID,
    DynamicFactor,
    DynamicFactorBySpeed,
    MeshDeviations,
    MeshSprings,
    MovingBody,
    dynamic_factor,
    dynamic_factor_by_speed,
    idler_masses,
    lightness,
    mean_allowance,
    theory_of,
    theory_of_mesh,
)
from gearwright.parts.iso6336.geometry import (
    USUAL_CHOICES,
    Choices,
    MeshGeometry,
    RatingMethod,
    ToothProportions,
    Value,
    as_value,
    of_form,
)
from gearwright.parts.iso6336.steels import GearSteel
from gearwright.parts.iso6336.tooth_strength import mesh_contact_ratio_factor
from gearwright.parts.material import STEEL_MODULUS
from gearwright.parts.stiffness import LINEAR_LOAD

# ----------------------------------------------------------------------------------------------------------------------
# Flank tolerances of ISO 1328-1:2013, which the load factors of ISO 6336-1 start from.
# ----------------------------------------------------------------------------------------------------------------------


_STEP = np.sqrt(2.0)
_MM, _TOLERANCE_MICRON = 1e-3, 1e-6


@dataclass(frozen=True)
class FlankTolerances:
    """Tolerances of one gear, unrounded."""

    single_pitch: Annotated[
        Value, Quantity("length"), Origin("f_pT = (0.001 d + 0.4 m_n + 5) √2^(A−5)", "ISO 1328-1:2013")
    ]
    """Single pitch f_pT [m]."""
    profile_form: Annotated[Value, Quantity("length"), Origin("f_fα = (0.55 m_n + 5) √2^(A−5)", "ISO 1328-1:2013")]
    """Profile form f_fαT [m]."""
    profile_slope: Annotated[
        Value, Quantity("length"), Origin("f_Hα = (0.4 m_n + 0.001 d + 4) √2^(A−5)", "ISO 1328-1:2013")
    ]
    """Profile slope f_HαT [m]."""
    helix_slope: Annotated[
        Value, Quantity("length"), Origin("f_Hβ = (0.05 √d + 0.35 √b + 4) √2^(A−5)", "ISO 1328-1:2013")
    ]
    """Helix slope f_HβT [m]."""


def flank_tolerances(diameter: Value, module: Value, face_width: Value, *, grade: Value) -> FlankTolerances:
    """Return the flank tolerances of one gear by its tolerance class.

    Args:
        diameter: Reference diameter d [m].
        module: Normal module m_n [m].
        face_width: Face width b [m].
        grade: Flank tolerance class A, 1 to 11 [-].

    Returns:
        Tolerances before the rounding of the standard.

    Source: ISO 1328-1:2013, clause 5.
    Valid for: 5 ≤ z ≤ 1000, 0.5 mm ≤ m_n ≤ 70 mm, 5 mm ≤ d ≤ 15 m, 4 mm ≤ b ≤ 1.2 m, β ≤ 45°.
    """
    d, m, b = diameter / _MM, module / _MM, face_width / _MM
    scale = _TOLERANCE_MICRON * _STEP ** (grade - 5.0)
    return FlankTolerances(
        single_pitch=scale * _pitch(d, m),
        profile_form=scale * _profile(m),
        profile_slope=scale * (0.4 * m + 0.001 * d + 4.0),
        helix_slope=scale * _helix(d, np.sqrt(b)),
    )


def _pitch(diameter: Value, module: Value) -> Value:
    return 0.001 * diameter + 0.4 * module + 5.0


def _profile(module: Value) -> Value:
    return 0.55 * module + 5.0


def _helix(diameter: Value, root_width: Value) -> Value:
    return 0.05 * np.sqrt(diameter) + 0.35 * root_width + 4.0


# ----------------------------------------------------------------------------------------------------------------------
# Tip relief and flank class of a mesh where nobody states them, and what relief leaves of the dynamic factor.
# ----------------------------------------------------------------------------------------------------------------------


_RELIEF_SOURCE = "ISO 6336-1:2019"
_RELIEF_MICRON, _RELIEF_MPA = 1e-6, 1e6
LARGEST_RELIEF = 0.02
"""Tip relief over the module, at most, where none is stated [-]: shop practice, from memory."""
COARSE_CLASS = 6
"""Flank class from which on B_k = 1, whatever the relief (ISO 6336-1, clause 6.5.5)."""
_LEAST_TOLERANCE, _TOLERANCE = 3e-6, 0.15
"""Tolerance of a relief that is not stated: ±3 µm, or ±15 % where that is more; an estimate of grinding."""
_LEAST_TERM = 0.1
"""B_k at least where a tolerance is stated that is tighter [-]."""
_FAST, _SLOW = 60.0, 15.0
"""Pitch-line velocities above which class 4 and class 5 are taken [m/s]: AGMA 2015 A4 and A5 for aircraft; estimate."""


class ReliefRule(Enum):
    """What a tip relief is made for where its amount is not stated."""

    LOAD = "load"
    """The deflection under the load that does most damage."""
    RUN_IN = "run-in"
    """Nothing: what running in leaves."""


@dataclass(frozen=True)
class TipRelief:
    """Tip relief of both gears of a mesh."""

    amount: Annotated[
        Value, Quantity("length"), Origin("C_a ≤ C_eff, 0.02 m_n; at least C_ay", f"{_RELIEF_SOURCE}, 6.5.5")
    ]
    """C_a [m]."""
    deflection: Annotated[
        Value, Quantity("length"), Origin("C_eff = F_t K_A K_γ/(b c′), of ε_β ≥ 1 c_γα", "ISO/TS 6336-20:2017, C_eff")
    ]
    """Relief that the load for which it is made asks for C_eff [m]."""
    tolerance: Annotated[Value, Quantity("length"), Origin("max(3 µm, 0.15 C_a)", "estimate for ground teeth")] = 0.0
    """By how much C_a may miss [m]; 0 where an amount is stated without one."""
    stiffness: Annotated[Value, Quantity("number"), Origin("c′", f"{_RELIEF_SOURCE}, clause 9")] = 0.0
    """Of one pair of teeth in the mesh that is relieved c′ [N/m²]."""
    stated: bool = False
    """Whether the tolerance is stated; then B_k is at least 0.1."""


def running_in_relief(steels: tuple[GearSteel, GearSteel]) -> float:
    """Return the tip relief that running in gives C_ay, the mean of both gears [m].

    Args:
        steels: Of the two gears.

    Source: ISO 6336-1:2006, clause 6.5.5: (σ_Hlim/97 − 18.45)²/18 + 1.5 µm; 2.00 µm at 1500 MPa in a printed report.
    """
    strengths = (steel.tabulated_strength / _RELIEF_MPA for steel in steels)
    return 0.5 * sum((strength / 97.0 - 18.45) ** 2 / 18.0 + 1.5 for strength in strengths) * _RELIEF_MICRON


def load_deflection(mesh: MeshGeometry, springs: MeshSprings, load: Value, design_load: Value) -> Value:
    """Return the deflection of the teeth under a load, which a relief makes up for C_eff [m].

    Args:
        mesh: The pair.
        springs: Stiffness under the load at hand.
        load: F_t K_A K_γ/b at hand, to which the stiffness belongs [N/m].
        design_load: F_t K_A K_γ/b for which the relief is made [N/m].

    Source: ISO/TS 6336-20:2017, C_eff, with c′ of spur gears and c_γα from ε_β = 1 on; below 100 N/mm teeth are softer.

    >>> spur = MeshGeometry((20, 60), 2e-3, 0.02, 0.08, (0.022, 0.062))
    >>> deflection = load_deflection(spur, MeshSprings(14e9, 20e9, 17e9), 5e5, 5e5)
    >>> round(1e6 * float(deflection), 1)  # 500 N/mm over 14 N/(mm µm)
    35.7
    """
    stiffness = np.where(np.asarray(mesh.overlap_ratio) >= 1.0, springs.mesh, springs.single)
    soft = (_lightness(design_load) / _lightness(load)) ** 0.25
    return as_value(design_load / (stiffness * soft))


def in_ring(mesh: MeshGeometry, springs: MeshSprings, planet: int) -> MeshSprings:
    """Return the stiffness of a planet's mesh in an unshifted ring, from that of one of its meshes.

    Args:
        mesh: Sun and planet, or planet and ring.
        springs: Of that mesh.
        planet: Which of its gears is the planet.

    Source: ISO 6336-1:2006, clause 9: z_n2 = ∞ for an internal wheel.
    """
    stiffer = _stiffer_in_ring(mesh, planet)
    return MeshSprings(springs.single * stiffer, springs.mesh * stiffer, springs.face * stiffer)


@of_form
def _stiffer_in_ring(mesh: MeshGeometry, planet: int) -> Value:
    """c′_th of a planet in an unshifted ring over that of one of its meshes."""
    shifts = mesh.proportions[planet].profile_shift, 0.0
    return theory_of((mesh.virtual_teeth[planet], np.inf), shifts) / theory_of_mesh(mesh)


def _lightness(load: Value) -> Value:
    return np.minimum(1.0, np.maximum(load, 1.0) / LINEAR_LOAD)


def relief_for(deflection: Value, module: Value, run_in: float) -> TipRelief:
    """Return the relief that a deflection asks for: rounded down to whole micrometres, capped, not below running in.

    Args:
        deflection: C_eff [m].
        module: m_n [m].
        run_in: C_ay [m].

    Source: ISO 6336-1:2006, clause 6.5.5 (B_k = 0 at C_a = C_eff); the cap of 0.02 m_n by shop practice.

    >>> made = relief_for(35.7e-6, 3e-3, 2e-6)
    >>> round(1e6 * float(made.amount), 1), round(1e6 * float(made.tolerance), 2)
    (35.0, 5.25)
    """
    whole = np.floor(np.minimum(deflection, LARGEST_RELIEF * module) / _RELIEF_MICRON + 1e-6) * _RELIEF_MICRON
    amount = np.maximum(whole, run_in)
    return TipRelief(as_value(amount), deflection, as_value(np.maximum(_LEAST_TOLERANCE, _TOLERANCE * amount)))


def relief_term(relief: TipRelief, load: Value, *, grade: Value) -> Value:
    """Return what relief leaves of the vibration B_k [-], at the worse end of its tolerance.

    Args:
        relief: Of both gears.
        load: F_t K_A K_γ/b [N/m].
        grade: Flank class [-].

    Source: ISO 6336-1:2006, clause 6.5.5: |1 − c′ C_a b/(F_t K_A K_γ)|, 1 from class 6 on.
    """
    per = relief.stiffness / load
    term = np.abs(1.0 - per * relief.amount) + per * relief.tolerance
    if relief.stated:
        term = np.maximum(term, _LEAST_TERM)
    return as_value(np.where(np.asarray(grade) >= COARSE_CLASS, 1.0, term))


def usual_class(speed: Value) -> Value:
    """Return the flank class that gears of aircraft are made to at a pitch-line velocity [-].

    Args:
        speed: Greatest pitch-line velocity v [m/s].

    Source: classes A4 and A5 of AGMA 2015 in aircraft, an estimate: 4 above 60 m/s, 5 from 15 on, 6 below.
    """
    return as_value(np.where(np.asarray(speed) > _FAST, 4.0, np.where(np.asarray(speed) >= _SLOW, 5.0, 6.0)))


# ----------------------------------------------------------------------------------------------------------------------
# How the load spreads over the face and over the pairs in contact: K_Hβ, K_Fβ by method C, K_Hα, K_Fα by method B.
# ----------------------------------------------------------------------------------------------------------------------


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
    allowance = lead_allowance(initial, steels[0], speed)
    if steels[1] is not steels[0]:
        allowance = 0.5 * (allowance + lead_allowance(initial, steels[1], speed))
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
    high = np.maximum(total, 2.0)
    wide = np.sqrt(2.0 * (high - 1.0) / high)
    factor = np.where(total <= 2.0, 0.5 * total * (0.9 + 0.4 * error), 0.9 + 0.4 * wide * error)
    least = np.maximum(factor, 1.0)
    contact = np.minimum(least, np.maximum(1.0, total / (alpha * contact_ratio_factor**2)))
    bending = np.minimum(least, np.maximum(1.0, total / (0.25 * alpha + 0.75)))
    return TransverseLoadFactor(as_value(contact), as_value(bending))


# ----------------------------------------------------------------------------------------------------------------------
# The loads of a cylindrical mesh by ISO 6336-1: what it carries, how it is made, and the K factors in their order.
# ----------------------------------------------------------------------------------------------------------------------


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
        factors = min(self.application_factor, self.mesh_load_factor)
        least = np.minimum(np.minimum(self.pinion_torque, np.abs(self.pinion_speed)), np.minimum(self.life, factors))
        if (least > 0.0).all():
            return
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
        amount, usual = quality.tip_relief, as_value(0.0)
    elif quality.relief_rule is ReliefRule.RUN_IN:
        amount, usual = run_in, as_value(0.0)
    else:
        made = relief_for(deflection, mesh.module, run_in)
        amount, usual = made.amount, made.tolerance
    return TipRelief(amount, deflection, usual if tolerance is None else tolerance, single, tolerance is not None)


def moving_masses(mesh: MeshGeometry, steels: Steels, *, duty: MeshDuty, quality: MeshQuality) -> tuple[Value, ...]:
    """Return the masses per face width that a mesh moves: one, or two for each of its gears that is an idler [kg/m].

    Args:
        mesh: The pair.
        steels: Of the two gears.
        duty: With the meshes that move each gear.
        quality: With bores, rims, and the gears beyond idlers.

    Source: ISO 6336-1:2006, clause 6.5.9.
    """
    own = tuple(
        lightness(mesh, gear, steels[gear].density, quality.bodies[gear], meshes=duty.meshes_per_turn[gear])
        for gear in (0, 1)
    )
    masses = list[Value]()
    for gear, neighbour in enumerate(quality.beyond):
        if neighbour is not None:
            row = _beyond(mesh, gear, neighbour.teeth)
            far = lightness(row, 1, neighbour.density, neighbour.body, meshes=1.0)
            masses += idler_masses(own[1 - gear], own[gear], far)
    return tuple(masses) or (as_value(1.0 / (own[0] + own[1])),)


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
        contact_ratio_factor=mesh_contact_ratio_factor(mesh),
    )
    return dynamic, face, transverse


def _deviations(mesh: MeshGeometry, grade: Value) -> tuple[Value, Value, Value]:
    """Greater f_pb of the two gears, f_fα of their module, and f_ma = √(f_Hβ1² + f_Hβ2²) [m]."""
    (first, second), module = (diameter / _MM for diameter in mesh.pitch_diameters), mesh.module / _MM
    scale, root = _TOLERANCE_MICRON * _STEP ** (grade - 5.0), np.sqrt(mesh.face_width / _MM)
    pitch = scale * np.maximum(_pitch(first, module), _pitch(second, module))
    slope = np.hypot(scale * _helix(first, root), scale * _helix(second, root))
    return pitch * np.cos(mesh.transverse_angle), scale * _profile(module), slope
