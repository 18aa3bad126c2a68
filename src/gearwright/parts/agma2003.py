"""Rating of bevel gears by ANSI/AGMA 2003: rating factors, pitting and bending.

Cones and forces are in `bevel`; K_v, K_R, C_H and C_p, which AGMA 2001 has too, in `agma2001`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum
from typing import Annotated, NamedTuple

from gearwright.base import INCH, POUND_FORCE, DesignError, Origin, Problem, Quantity, refuse
from gearwright.parts.agma2001 import (
    dynamic_factor_agma,
    elastic_coefficient,
    hardness_ratio_factor,
    reliability_factor,
    stress_cycle_curve,
)
from gearwright.parts.agma2003_geometry import (
    SOURCE,
    BevelBendingGeometry,
    MeanSection,
    PittingGeometry,
    bending_geometry,
    pitting_geometry,
)
from gearwright.parts.bevel_geometry import BevelPair
from gearwright.parts.iso6336 import LifeCurve, life_factor

# ----------------------------------------------------------------------------------------------------------------------
# Factors of ANSI/AGMA 2003: sizes, load distribution, lengthwise curvature, temperature, cycles, steels; SI outside.
#
# The dynamic, reliability and hardness ratio factors are those of `agma2001`.
# ----------------------------------------------------------------------------------------------------------------------


_MM = 1e-3
_PSI = POUND_FORCE / INCH**2
STRADDLE, ONE_STRADDLE, OVERHUNG = 1.00, 1.10, 1.25
"""Load distribution modifier K_mb of both, one or no member between bearings [-] (figure 4)."""
CROWNED, UNCROWNED = 1.5, 2.0
"""Crowning factor C_xc of properly crowned teeth and the least one of others [-] (clause 13)."""
WIDEST = 356 * _MM
"""Face width up to which K_m is given [m] (eq. 20)."""
REVERSED = 0.70
"""Part of s_at of teeth that are loaded on both flanks [-] (clause 21)."""
GREATEST_CONTACT, GREATEST_BENDING = 2.0, 2.7
"""C_L up to 1e4 and K_L up to 1e3 cycles [-] (figures 5 and 6)."""
_CONTACT, _BENDING = (3.4822, 0.0602), (6.1514, 0.1192)


def _reached(greatest: float, line: tuple[float, float]) -> float:
    """Return the cycles at which a line c N^−e comes down to the greatest factor [-]."""
    return math.exp(math.log(line[0] / greatest) / line[1])


CONTACT = LifeCurve(
    (_reached(GREATEST_CONTACT, _CONTACT), 1e10), (GREATEST_CONTACT, _CONTACT[0] * 1e10 ** -_CONTACT[1])
)
"""C_L of case-hardened steel (figure 5)."""
BENDING = stress_cycle_curve(_reached(GREATEST_BENDING, _BENDING), _BENDING, (1.3558, 0.0178))
"""K_L of case-hardened steel in general use, the upper edge of the band (figure 6)."""
BENDING_CRITICAL = stress_cycle_curve(_reached(GREATEST_BENDING, _BENDING), _BENDING, (1.6831, 0.0323))
"""K_L in critical service, the lower edge of the band (figure 6)."""


class BevelEdition(Enum):
    """Whose size factor C_s, by the face width from which it stays what it is [m]."""

    B97 = 114.3 * _MM
    """ANSI/AGMA 2003-B97 as Shigley prints it: 1 from 4.5 in."""
    D19 = 79.8 * _MM
    """ANSI/AGMA 2003-D19: 0.83 from 79.8 mm."""


def size_factor_contact(face_width: float, edition: BevelEdition = BevelEdition.D19) -> float:
    """Return the size factor for pitting C_s [-].

    Args:
        face_width: b [m].
        edition: Which says where it ends.

    Source: ANSI/AGMA 2003-D19, eq. 18M, 0.00492 b + 0.4375 from 0.5 at 12.7 mm; B97 as Shigley 9th ed., eq. 15-9.

    >>> round(size_factor_contact(25.4e-3), 4)
    0.5625
    """
    width = min(face_width, edition.value) / INCH
    return max(0.5, 0.125 * width + 0.4375)


def size_factor_bending(module: float) -> float:
    """Return the size factor for bending K_s [-].

    Args:
        module: Outer transverse module m_et [m].

    Source: ANSI/AGMA 2003-D19, eq. 19, 0.4867 + 0.2132/P_d; 0.5 below 1.6 mm.

    >>> round(size_factor_bending(25.4e-3 / 5.6), 4)
    0.5248
    """
    return 0.5 if module < 1.6 * _MM else 0.4867 + 0.2132 * module / INCH


def load_distribution(face_width: float, modifier: float) -> float:
    """Return the load distribution factor K_m [-].

    Args:
        face_width: b [m].
        modifier: K_mb [-].

    Source: ANSI/AGMA 2003-D19, eq. 20, K_mb + 0.0036 F², F in inches, up to 14 in.

    Raises:
        DesignError: A wider face.

    >>> round(load_distribution(25.4e-3, ONE_STRADDLE), 4)
    1.1036
    """
    if face_width > WIDEST:
        message = f"{face_width / _MM:.4g} mm given; {SOURCE}, eq. 20 holds up to {WIDEST / _MM:g} mm"
        raise DesignError([Problem("face_width", message)])
    return modifier + 0.0036 * (face_width / INCH) ** 2


def lengthwise_curvature(spiral_angle: float, cutter_radius: float, cone_distance: float) -> float:
    """Return the lengthwise curvature factor K_x [-].

    Args:
        spiral_angle: β_m [rad].
        cutter_radius: r_c0 [m]; infinite for a large one.
        cone_distance: Mean cone distance R_m [m].

    Source: ANSI/AGMA 2003-D19, eqs 21 to 23: 0.211 (r_c0/R_m)^q + 0.789, q = 0.279/lg sin β_m, from 1 to 1.15; 1 for
        straight teeth.
    """
    if spiral_angle == 0.0:
        return 1.0
    exponent = 0.279 / math.log10(math.sin(spiral_angle))
    raw = 0.789 + 0.211 * math.exp(exponent * math.log(cutter_radius / cone_distance))
    return min(max(raw, 1.0), 1.15)


def temperature_factor(temperature: float) -> float:
    """Return the temperature factor K_T [-].

    Args:
        temperature: Of the gear blanks [°C].

    Source: ANSI/AGMA 2003-D19, clause 18 and eq. 31, (460 + t)/710 with t in °F, 1 up to 250 °F; its metric form,
        (273 + t)/393, is 0.3 % higher.

    >>> round(temperature_factor(148.9), 3)  # 300 °F; Shigley 9th ed., example 15-2: 1.070
    1.07
    """
    return max(1.0, (492.0 + 1.8 * temperature) / 710.0)


class BevelSteel(Enum):
    """Steels with their rows in tables 3 and 5."""

    THROUGH_HARDENED = "through-hardened"
    """Through-hardened, 180 to 400 HB."""
    CARBURISED = "carburised"
    """Carburised and hardened."""
    NITRIDED_4140 = "nitrided-4140"
    """AISI 4140, nitrided."""
    NITRALLOY = "nitralloy-135m"
    """Nitralloy 135M, nitrided."""


@dataclass(frozen=True)
class BevelStrength:
    """Allowable stress numbers of a steel."""

    bending: Annotated[float, Quantity("stress"), Origin("s_at", f"{SOURCE}, table 5 and figure 10")]
    """Allowable bending stress number s_at [Pa]."""
    contact: Annotated[float, Quantity("stress"), Origin("s_ac", f"{SOURCE}, table 3 and figure 9")]
    """Allowable contact stress number s_ac [Pa]."""


_ROWS: dict[tuple[BevelSteel, int], tuple[float, float]] = {
    (BevelSteel.CARBURISED, 1): (30e3, 200e3), (BevelSteel.CARBURISED, 2): (35e3, 225e3),
    (BevelSteel.CARBURISED, 3): (40e3, 250e3), (BevelSteel.NITRIDED_4140, 2): (22e3, 145e3),
    (BevelSteel.NITRALLOY, 2): (24e3, 160e3),
}  # fmt: skip
"""Steel and grade -> s_at and s_ac [psi]."""
_LINES = {1: ((44.0, 2100.0), (341.0, 23620.0)), 2: ((48.0, 5980.0), (363.6, 29560.0))}
"""Grade of through-hardened steel -> slope over HB and intercept of s_at and s_ac [psi]."""


def bevel_strength(steel: BevelSteel, grade: int, hardness: float = 0.0) -> BevelStrength:
    """Return the allowable stress numbers of a steel.

    Args:
        steel: The steel.
        grade: 1 to 3; of nitrided steels 2 [-].
        hardness: HB of a through-hardened gear, 180 to 400 [-].

    Source: ANSI/AGMA 2003-D19, tables 3 and 5, figures 9 and 10, in psi; of through-hardened steel as Shigley 9th ed.,
        eqs 15-22 and 15-23 (the standard's lines in N/mm² lie up to 1 % lower).

    Raises:
        DesignError: A grade that the steel does not have, or a hardness outside 180 to 400 HB.

    >>> round(bevel_strength(BevelSteel.THROUGH_HARDENED, 1, 180.0).bending / 6894.757)  # Shigley, example 15-1
    10020
    """
    lines = steel is BevelSteel.THROUGH_HARDENED
    known = sorted(_LINES if lines else (own for name, own in _ROWS if name is steel))
    problems = []
    if grade not in known:
        problems.append(Problem("grade", f"{grade} given; {steel.value} steel has {' and '.join(map(str, known))}"))
    if lines and not 180.0 <= hardness <= 400.0:
        problems.append(Problem("hardness", f"{hardness:g} HB given; {SOURCE}, figures 9 and 10 have 180 to 400 HB"))
    refuse(problems)
    if lines:
        bending, contact = (slope * hardness + constant for slope, constant in _LINES[grade])
    else:
        bending, contact = _ROWS[steel, grade]
    return BevelStrength(_PSI * bending, _PSI * contact)


# ----------------------------------------------------------------------------------------------------------------------
# What a bevel mesh is asked, how it is made, and the factors of ANSI/AGMA 2003 that both of its gears share.
# ----------------------------------------------------------------------------------------------------------------------


Both = tuple[float, float]
"""Of pinion and wheel."""


@dataclass(frozen=True)
class AgmaBevelDuty:
    """What a bevel mesh carries."""

    torque: float
    """On the pinion, of one mesh T_1 [N m]."""
    speed: float
    """Of the pinion ω_1 [rad/s]."""
    life: float
    """Time under that load [s]."""
    overload: float = 1.0
    """K_o [-]."""
    meshes_per_turn: Both = (1.0, 1.0)
    """Mates that a tooth of each gear meets in a turn [-]."""
    is_reversed: tuple[bool, bool] = (False, False)
    """Which gear is loaded on both flanks."""


@dataclass(frozen=True)
class AgmaBevelMaking:
    """How both gears are made and mounted, and of what."""

    strengths: tuple[BevelStrength, BevelStrength]
    """Allowable stress numbers of pinion and wheel."""
    hardnesses: Both | None = None
    """HB of pinion and wheel where both are through-hardened, for C_H [-]; None: C_H = 1."""
    elastic_modulus: float = 207e9
    """E [Pa]."""
    poisson_ratio: float = 0.3
    """ν [-]."""
    quality: int = 11
    """Transmission accuracy Q_v [-]."""
    mounting: float = ONE_STRADDLE
    """K_mb [-]."""
    crowning: float = CROWNED
    """C_xc [-]."""
    cutter_radius: float = math.inf
    """r_c0 [m]."""
    reliability: float = 0.99
    """Part of the gears that survive [-]."""
    temperature: float = 80.0
    """Of the gear blanks [°C]."""
    is_critical: bool = False
    """K_L by the lower edge of its band."""
    edition: BevelEdition = BevelEdition.D19
    """Whose C_s."""

    @property
    def bending_curve(self) -> LifeCurve:
        """K_L over cycles."""
        return BENDING_CRITICAL if self.is_critical else BENDING


@dataclass(frozen=True)
class AgmaBevelFactors:
    """Load, speed, cycles and the factors on them."""

    tangential_force: Annotated[float, Quantity("force"), Origin("W_t = 2 T_1/d_e1", f"{SOURCE}, clause 6")]
    """At the outer pitch circle W_t [N]."""
    speed: Annotated[float, Quantity("velocity"), Origin("v_et = ω_1 d_e1/2", f"{SOURCE}, eq. 16")]
    """Velocity of the outer pitch circle [m/s]."""
    cycles: Annotated[Both, Quantity("number"), Origin("N = ω L q/(2 π)", f"{SOURCE}, clause 16")]
    """Stress cycles of both gears [-]."""
    overload: Annotated[float, Quantity("ratio"), Origin("K_o", f"{SOURCE}, clause 7")]
    """[-]"""
    dynamic: Annotated[float, Quantity("ratio"), Origin("K_v = ((A + √V)/A)^B", f"{SOURCE}, eqs 13 to 15")]
    """[-]"""
    distribution: Annotated[float, Quantity("ratio"), Origin("K_m = K_mb + 0.0036 F²", f"{SOURCE}, eq. 20")]
    """[-]"""
    size_contact: Annotated[float, Quantity("ratio"), Origin("C_s = 0.125 F + 0.4375", f"{SOURCE}, eq. 18")]
    """[-]"""
    size_bending: Annotated[float, Quantity("ratio"), Origin("K_s = 0.4867 + 0.2132/P_d", f"{SOURCE}, eq. 19")]
    """[-]"""
    crowning: Annotated[float, Quantity("ratio"), Origin("C_xc", f"{SOURCE}, clause 13")]
    """[-]"""
    curvature: Annotated[
        float, Quantity("ratio"), Origin("K_x = 0.211 (r_c0/R_m)^q + 0.789", f"{SOURCE}, eqs 21 to 23")
    ]
    """[-]"""
    elastic: Annotated[float, Quantity("elasticity_factor"), Origin("C_p", f"{SOURCE}, eq. 32")]
    """[√Pa]"""
    contact_cycles: Annotated[Both, Quantity("ratio"), Origin("C_L", f"{SOURCE}, figure 5")]
    """Of both gears [-]."""
    bending_cycles: Annotated[Both, Quantity("ratio"), Origin("K_L", f"{SOURCE}, figure 6")]
    """Of both gears [-]."""
    hardness_ratio: Annotated[Both, Quantity("ratio"), Origin("C_H = 1 + B_1 (z_2/z_1 − 1)", f"{SOURCE}, clause 17")]
    """Of both gears; 1 of the pinion [-]."""
    reversal: Annotated[Both, Quantity("ratio"), Origin("0.7 where both flanks are loaded", f"{SOURCE}, clause 21")]
    """Of both gears [-]."""
    reliability_contact: Annotated[float, Quantity("ratio"), Origin("C_R = √K_R", f"{SOURCE}, clause 19")]
    """[-]"""
    reliability_bending: Annotated[float, Quantity("ratio"), Origin("K_R", f"{SOURCE}, table 2")]
    """[-]"""
    temperature: Annotated[float, Quantity("ratio"), Origin("K_T", f"{SOURCE}, eq. 31")]
    """[-]"""


def bevel_factors(pair: BevelPair, duty: AgmaBevelDuty, making: AgmaBevelMaking) -> AgmaBevelFactors:
    """Return the factors of a bevel mesh.

    Args:
        pair: The pair.
        duty: Torque, speed, life.
        making: Steel, accuracy, mounting.

    Source: ANSI/AGMA 2003-D19, clauses 6 to 20; C_R as the root of K_R, as Shigley 9th ed., eq. 15-20.

    Raises:
        DesignError: A face above 356 mm.
    """
    diameter, ratio = pair.outer_diameters[0], pair.teeth[1] / pair.teeth[0]
    turns, speed = abs(duty.speed) * duty.life / (2.0 * math.pi), 0.5 * abs(duty.speed) * diameter
    cycles = turns * duty.meshes_per_turn[0], turns * duty.meshes_per_turn[1] / ratio
    survival = float(reliability_factor(making.reliability))
    softer = 1.0 if making.hardnesses is None else hardness_ratio_factor(*making.hardnesses, ratio)
    return AgmaBevelFactors(
        tangential_force=2.0 * duty.torque / diameter,
        speed=speed,
        cycles=cycles,
        overload=duty.overload,
        dynamic=float(dynamic_factor_agma(speed, making.quality)),
        distribution=load_distribution(pair.face_width, making.mounting),
        size_contact=size_factor_contact(pair.face_width, making.edition),
        size_bending=size_factor_bending(pair.outer_module),
        crowning=making.crowning,
        curvature=lengthwise_curvature(pair.spiral_angle, making.cutter_radius, pair.mean_cone_distance),
        elastic=elastic_coefficient((making.elastic_modulus,) * 2, (making.poisson_ratio,) * 2),
        contact_cycles=_factors(CONTACT, cycles),
        bending_cycles=_factors(making.bending_curve, cycles),
        hardness_ratio=(1.0, softer),
        reversal=(REVERSED if duty.is_reversed[0] else 1.0, REVERSED if duty.is_reversed[1] else 1.0),
        reliability_contact=math.sqrt(survival),
        reliability_bending=survival,
        temperature=temperature_factor(making.temperature),
    )


def _factors(curve: LifeCurve, cycles: Both) -> Both:
    first, second = (float(life_factor(curve, count)) for count in cycles)
    return first, second


# ----------------------------------------------------------------------------------------------------------------------
# Rating of one bevel pair by ANSI/AGMA 2003 in one call, every factor shown.
# ----------------------------------------------------------------------------------------------------------------------


class BevelGeometry(NamedTuple):
    """The geometry factors of a pair, which its size does not change."""

    pitting: PittingGeometry
    """I and its parts."""
    bending: tuple[BevelBendingGeometry, BevelBendingGeometry]
    """J and its parts of pinion and wheel."""


@dataclass(frozen=True)
class AgmaBevelGear:
    """Stresses, limits and safeties of one gear."""

    bending_stress: Annotated[
        float, Quantity("stress"), Origin("s_t = W_t K_o K_v K_s K_m/(b m_et K_x J)", f"{SOURCE}, eq. 5")
    ]
    """Bending stress number s_t [Pa]."""
    bending_limit: Annotated[
        float, Quantity("stress"), Origin("s_wt = s_at K_L/(K_T K_R); 0.7 of it where reversed", f"{SOURCE}, eq. 6")
    ]
    """Permissible bending stress number with S_F = 1 [Pa]."""
    bending_safety: Annotated[float, Quantity("ratio"), Origin("S_F = s_wt/s_t", f"{SOURCE}, eq. 6")]
    """S_F [-]."""
    contact_stress: Annotated[
        float, Quantity("stress"), Origin("s_c = C_p √(W_t K_o K_v K_m C_s C_xc/(b d_e1 I))", f"{SOURCE}, eq. 1")
    ]
    """Contact stress number s_c [Pa]."""
    contact_limit: Annotated[float, Quantity("stress"), Origin("s_wc = s_ac C_L C_H/(K_T C_R)", f"{SOURCE}, eq. 2")]
    """Permissible contact stress number with S_H = 1 [Pa]."""
    contact_safety: Annotated[float, Quantity("ratio"), Origin("S_H = s_wc/s_c", f"{SOURCE}, eq. 2")]
    """S_H [-]."""


@dataclass(frozen=True)
class AgmaBevelRating:
    """A rated bevel pair: factors, geometry, strengths, stresses and safeties."""

    mesh: AgmaBevelFactors
    """Load, speed, cycles and the factors on them."""
    pitting: PittingGeometry
    """I and its parts."""
    tooth_root: tuple[BevelBendingGeometry, BevelBendingGeometry]
    """J and its parts of both gears."""
    strength: tuple[BevelStrength, BevelStrength]
    """Of both gears."""
    gears: tuple[AgmaBevelGear, AgmaBevelGear]
    """Stresses, limits and safeties of both gears."""


def bevel_geometry(pair: BevelPair) -> BevelGeometry:
    """Return the geometry factors of a pair.

    Args:
        pair: The pair.

    Source: ANSI/AGMA 2003-D19, annex C.

    >>> from gearwright.parts.bevel_geometry import BevelTooth
    >>> tooth = BevelTooth(0.9654, 1.188, edge_radii=(0.142, 0.142))
    >>> found = bevel_geometry(BevelPair((25, 25), 5.08e-3, 27.94e-3, tooth=tooth))  # Shigley 9th ed., example 15-1
    >>> round(found.pitting.factor, 3), round(found.bending[0].factor, 3)  # read from charts there: 0.065 and 0.216
    (0.064, 0.218)
    """
    section = MeanSection(pair)
    return BevelGeometry(pitting_geometry(section), (bending_geometry(section, 0), bending_geometry(section, 1)))


def rate_agma_bevel(
    pair: BevelPair, duty: AgmaBevelDuty, making: AgmaBevelMaking, geometry: BevelGeometry | None = None
) -> AgmaBevelRating:
    """Return the rating of a bevel pair.

    Args:
        pair: The pair.
        duty: Torque, speed, life.
        making: Steel, accuracy, mounting.
        geometry: I and J where they are known, of this pair or of one to scale; left out: by annex C.

    Source: ANSI/AGMA 2003-D19, clauses 5 to 21.
    Valid for: generated straight, Zerol and spiral bevel gears without offset, faces up to 356 mm; beyond 1e10
        cycles, where the figures end, C_L and K_L fall on along their last lines.

    Raises:
        DesignError: Outside of that.
    """
    known = bevel_geometry(pair) if geometry is None else geometry
    return rate_with_factors(pair, bevel_factors(pair, duty, making), known, making.strengths)


def rate_with_factors(
    pair: BevelPair,
    factors: AgmaBevelFactors,
    geometry: BevelGeometry,
    strengths: tuple[BevelStrength, BevelStrength],
) -> AgmaBevelRating:
    """Return the rating of a bevel pair by factors that are known.

    Args:
        pair: The pair.
        factors: Load and the factors on it.
        geometry: I and J.
        strengths: Allowable stress numbers of both gears.

    Source: ANSI/AGMA 2003-D19, eqs 1, 2, 5 and 6.
    """
    load = factors.tangential_force * factors.overload * factors.dynamic * factors.distribution
    area = pair.face_width * pair.outer_diameters[0] * geometry.pitting.factor
    contact = factors.elastic * math.sqrt(load * factors.size_contact * factors.crowning / area)
    gears = []
    for gear, strength in enumerate(strengths):
        root = pair.face_width * pair.outer_module * factors.curvature * geometry.bending[gear].factor
        bending = load * factors.size_bending / root
        most = strength.bending * factors.bending_cycles[gear] * factors.reversal[gear]
        most /= factors.temperature * factors.reliability_bending
        limit = strength.contact * factors.contact_cycles[gear] * factors.hardness_ratio[gear]
        limit /= factors.temperature * factors.reliability_contact
        gears.append(AgmaBevelGear(bending, most, most / bending, contact, limit, limit / contact))
    return AgmaBevelRating(factors, geometry.pitting, geometry.bending, strengths, (gears[0], gears[1]))
