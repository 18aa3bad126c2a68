"""Rating of cylindrical gears by ANSI/AGMA 2001-D04: rating factors, pitting, bending and yielding.

Nothing of ISO lives here but its arithmetic of S-N curves and damage.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum
from typing import Annotated

import numpy as np

from gearwright.base import FOOT, INCH, POUND_FORCE, DesignError, Origin, Problem, Quantity
from gearwright.parts.agma908 import (
    BendingGeometry,
    HobbedPair,
    bending_geometry,
    pitting_geometry_factor,
)
from gearwright.parts.gears import lewis_form_factor
from gearwright.parts.iso6336 import LifeCurve, Value, as_value, life_factor

# ----------------------------------------------------------------------------------------------------------------------
# Factors of ANSI/AGMA 2001-D04: dynamics, size, load distribution, life, reliability, hardness ratio; SI outside.
#
# The standard's empirical formulas are written in inches, feet per minute and Brinell hardness; they are converted
# here.
# ----------------------------------------------------------------------------------------------------------------------


_SOURCE = "ANSI/AGMA 2001-D04"


@dataclass(frozen=True)
class Mounting:
    """Empirical constants of the mesh alignment factor C_ma = A + B F + C F², F in inches."""

    constant: float
    """A [-]."""
    linear: float
    """B [1/in]."""
    square: float
    """C [1/in²]."""


OPEN_GEARING = Mounting(0.247, 0.0167, -0.765e-4)
"""Open gearing (AGMA 2001-D04, table 2)."""
COMMERCIAL = Mounting(0.127, 0.0158, -1.093e-4)
"""Commercial enclosed units; Shigley, table 14-9, prints −0.930e-4."""
PRECISION = Mounting(0.0675, 0.0128, -0.926e-4)
"""Precision enclosed units."""
EXTRA_PRECISION = Mounting(0.0380, 0.0102, -0.822e-4)
"""Extra-precision enclosed units; Shigley prints 0.00360."""


Line = tuple[float, float]
"""c and e of c N^−e [-]."""


def stress_cycle_curve(start: float, low: Line, high: Line) -> LifeCurve:
    """Return a stress cycle factor Y_N or Z_N over cycles: two lines that meet where they cross.

    Args:
        start: Cycles at which the figure begins; fewer bear no more [-].
        low: c and e of the line from there on [-].
        high: c and e of the line beyond the crossing, which goes on [-].

    Source: AGMA 2001-D04, figures 17 and 18, whose corners, 3e6 and 1e7 cycles, are rounded crossings.

    >>> round(stress_cycle_curve(1e4, (2.466, 0.056), (1.4488, 0.023)).cycles[1], -5)
    10000000.0
    """
    (c_1, e_1), (c_2, e_2) = low, high
    crossing = math.exp(math.log(c_1 / c_2) / (e_1 - e_2))
    return LifeCurve((start, crossing, _LAST), (c_1 * start**-e_1, c_2 * crossing**-e_2, c_2 * _LAST**-e_2))


_LAST = 1e10
"""Cycles at which the figures end [-]."""
_BENDING_HIGH = (1.3558, 0.0178)
BENDING_HB160 = stress_cycle_curve(1e3, (2.3194, 0.0538), _BENDING_HIGH)
"""Y_N of steels around 160 HB (AGMA 2001-D04, figure 17)."""
BENDING_HB250 = stress_cycle_curve(1e3, (4.9404, 0.1045), _BENDING_HIGH)
"""Y_N around 250 HB."""
BENDING_HB400 = stress_cycle_curve(1e3, (9.4518, 0.148), _BENDING_HIGH)
"""Y_N around 400 HB."""
BENDING_CARBURISED = stress_cycle_curve(1e3, (6.1514, 0.1192), _BENDING_HIGH)
"""Y_N of carburised cases."""
BENDING_NITRIDED = stress_cycle_curve(1e3, (3.517, 0.0817), _BENDING_HIGH)
"""Y_N of nitrided cases."""
PITTING = stress_cycle_curve(1e4, (2.466, 0.056), (1.4488, 0.023))
"""Z_N of steels other than nitrided (figure 18)."""
PITTING_NITRIDED = stress_cycle_curve(1e4, (1.249, 0.0138), (1.4488, 0.023))
"""Z_N of nitrided steels."""


def dynamic_factor_agma(speed: Value, quality: Value) -> Value:
    """Return the dynamic factor K_v.

    Args:
        speed: Pitch-line velocity v_t [m/s].
        quality: Transmission accuracy Q_v, 5 to 11 [-].

    Source: AGMA 2001-C95/-D04 as Shigley 9th ed., eqs 14-27 and 14-28: ((A + √V)/A)^B, V in ft/min,
        A = 50 + 56 (1 − B), B = 0.25 (12 − Q_v)^(2/3).
    Valid for: V up to (A + Q_v − 3)².

    >>> round(float(dynamic_factor_agma(801.1 * 0.3048 / 60.0, 6.0)), 3)
    1.377
    """
    exponent = 0.25 * (12.0 - quality) ** (2.0 / 3.0)
    base = 50.0 + 56.0 * (1.0 - exponent)
    return as_value(((base + np.sqrt(speed * 60.0 / FOOT)) / base) ** exponent)


def size_factor(face_width: Value, module: Value, form_factor: Value) -> Value:
    """Return the size factor K_s, at least 1.

    Args:
        face_width: F [m].
        module: Transverse module m_t = 25.4 mm/P [m].
        form_factor: Lewis form factor Y [-].

    Source: Shigley 9th ed., section 14-10, 1.192 (F √Y/P)^0.0535, lengths in inches.

    >>> round(float(size_factor(1.5 * 0.0254, 0.00254, 0.303)), 3)
    1.043
    """
    size = face_width / INCH * np.sqrt(form_factor) * module / INCH
    return as_value(np.maximum(1.0, 1.192 * size**0.0535))


def load_distribution_factor(
    face_width: Value,
    pinion_diameter: Value,
    *,
    mounting: Mounting = COMMERCIAL,
    crowning: float = 1.0,
    offset: float = 1.0,
    adjustment: float = 1.0,
) -> Value:
    """Return the load distribution factor K_m = 1 + C_mc (C_pf C_pm + C_ma C_e).

    Args:
        face_width: F [m].
        pinion_diameter: d [m].
        mounting: Constants of C_ma.
        crowning: C_mc, 1 uncrowned, 0.8 crowned [-].
        offset: C_pm, 1 with the pinion within a sixth of the span from its middle, else 1.1 [-].
        adjustment: C_e, 0.8 when adjusted at assembly or lapped, else 1 [-].

    Source: AGMA 2001-D04, clause 15.3; F/d ≤ 2, F ≤ 40 in.

    >>> round(float(load_distribution_factor(1.5 * 0.0254, 1.7 * 0.0254)), 2)
    1.22
    """
    width = np.asarray(face_width / INCH)
    slender = np.maximum(0.05, np.asarray(face_width / pinion_diameter) / 10.0)
    wide = -0.1109 + 0.0207 * width - 0.000228 * width**2
    proportion = slender + np.select([width <= 1.0, width <= 17.0], [-0.025, -0.0375 + 0.0125 * width], wide)
    alignment = mounting.constant + mounting.linear * width + mounting.square * width**2
    return as_value(1.0 + crowning * (proportion * offset + alignment * adjustment))


def reliability_factor(reliability: Value) -> Value:
    """Return the reliability factor K_R.

    Args:
        reliability: R, 0.5 to 0.9999 [-].

    Source: AGMA 2001-D04, table 11: 0.70 at 0.5, 0.85 at 0.9, 1 at 0.99, 1.25 at 0.999, 1.5 at 0.9999; between its rows
        straight over the logarithm of 1 − R.

    >>> round(float(reliability_factor(0.9)), 3)
    0.85
    """
    rows = -np.log10([0.5, 0.1, 0.01, 0.001, 0.0001])
    return as_value(np.interp(-np.log10(1.0 - np.asarray(reliability)), rows, [0.70, 0.85, 1.0, 1.25, 1.5]))


def hardness_ratio_factor(pinion: float, wheel: float, ratio: float) -> float:
    """Return the hardness ratio factor C_H of the gear against a harder through-hardened pinion.

    Args:
        pinion: HB of the pinion [-].
        wheel: HB of the gear [-].
        ratio: m_G = N_G/N_P [-].

    Source: AGMA 2001-D04, clause 14.1: 1 + A (m_G − 1), A = 0.00898 HB_P/HB_G − 0.00829 for HB_P/HB_G from 1.2 to 1.7,
        0 below, 0.00698 above.

    >>> round(hardness_ratio_factor(240.0, 200.0, 52.0 / 17.0), 3)
    1.005
    """
    harder = pinion / wheel
    if harder < 1.2 - 1e-12:
        return 1.0
    slope = 0.00698 if harder > 1.7 else 0.00898 * harder - 0.00829
    return 1.0 + slope * (ratio - 1.0)


# ----------------------------------------------------------------------------------------------------------------------
# Hardness ratio factor C_H of ANSI/AGMA 2001-D04: a harder pinion works the flanks of its gear.
# ----------------------------------------------------------------------------------------------------------------------


_MICROINCH = 1e-6 * INCH
SOFTEST, HARDEST = 180.0, 400.0
"""Brinell hardness of gears that a surface-hardened pinion works [-]."""


@dataclass(frozen=True)
class Hardnesses:
    """Of two different steels of a mesh."""

    pinion: float
    """HB of a through-hardened pinion [-]."""
    wheel: float
    """HB of the gear [-]."""
    hard_pinion: bool = False
    """The pinion is surface-hardened, 48 HRC or more."""
    hard_wheel: bool = False
    """The gear is surface-hardened, too: nothing works it."""
    roughness: float = 0.0
    """R_a of the pinion's flanks [m]; a surface-hardened pinion works the gear the more the smoother it is."""


def hardened_pinion_factor(wheel: float, roughness: float) -> float:
    """Return C_H of a through-hardened gear against a surface-hardened pinion.

    Args:
        wheel: HB of the gear [-].
        roughness: R_a of the pinion's flanks [m].

    Source: AGMA 2001-D04, clause 14.2, as Shigley 9th ed., eq. 14-37: 1 + 0.00075 e^(−0.0112 f_p) (450 − HB), f_p in
        microinches.
    Valid for: 180 to 400 HB.

    >>> round(hardened_pinion_factor(300.0, 16e-6 * 0.0254), 3)  # 1 + 0.00075 e^-0.1792 150
    1.094
    """
    hardness = min(max(wheel, SOFTEST), HARDEST)
    return 1.0 + 0.00075 * float(np.exp(-0.0112 * roughness / _MICROINCH)) * (450.0 - hardness)


def hardness_ratio_of(hardnesses: Hardnesses | None, ratio: Value) -> Value:
    """Return C_H of the gear of a mesh [-]; 1 where both gears are of one steel.

    Args:
        hardnesses: Of both gears; None: of one steel.
        ratio: m_G = N_G/N_P [-].

    Source: AGMA 2001-D04, clauses 14.1 and 14.2.
    """
    if hardnesses is None or hardnesses.hard_wheel:
        return 1.0
    if hardnesses.hard_pinion:
        return hardened_pinion_factor(hardnesses.wheel, hardnesses.roughness)
    slope = hardness_ratio_factor(hardnesses.pinion, hardnesses.wheel, 2.0) - 1.0
    return as_value(1.0 + slope * (np.asarray(ratio) - 1.0))


# ----------------------------------------------------------------------------------------------------------------------
# Bending and pitting of spur and helical gears by ANSI/AGMA 2001-D04, with J and I of AGMA 908.
# ----------------------------------------------------------------------------------------------------------------------


_PSI = POUND_FORCE / INCH**2


class AgmaSteel(Enum):
    """Steels with their strength rows: bending and contact, slope [psi/HB] and intercept [psi] of grades 1 to 3."""

    THROUGH_HARDENED = "through-hardened"
    """Through-hardened steel, 180 to 400 HB."""
    CARBURISED = "carburised"
    """Carburised and hardened, 58 to 64 HRC."""
    NITRIDED_4140 = "nitrided-4140"
    """Nitrided through-hardened 4140/4340; bending by core hardness, 84.5 HR15N case."""


_ROWS: dict[AgmaSteel, tuple[tuple[tuple[float, float], tuple[float, float]], ...]] = {
    AgmaSteel.THROUGH_HARDENED: (((77.3, 12800.0), (322.0, 29100.0)), ((102.0, 16400.0), (349.0, 34300.0))),
    AgmaSteel.CARBURISED: (
        ((0.0, 55000.0), (0.0, 180000.0)),
        ((0.0, 65000.0), (0.0, 225000.0)),
        ((0.0, 75000.0), (0.0, 275000.0)),
    ),
    AgmaSteel.NITRIDED_4140: (((82.3, 12150.0), (0.0, 155000.0)), ((108.6, 15890.0), (0.0, 168000.0))),
}


@dataclass(frozen=True)
class AgmaStrength:
    """Allowable stress numbers of a steel."""

    bending: Annotated[float, Quantity("stress"), Origin("s_at", f"{_SOURCE}, table 4")]
    """Allowable bending stress number s_at at 1e7 cycles and 99 % reliability [Pa]."""
    contact: Annotated[float, Quantity("stress"), Origin("s_ac", f"{_SOURCE}, table 3")]
    """Allowable contact stress number s_ac [Pa]."""


@dataclass(frozen=True)
class AgmaLoad:
    """The load of a mesh with the factors that raise it."""

    tangential_force: Value
    """W_t [N]."""
    overload: Value = 1.0
    """K_o [-]."""
    dynamic: Value = 1.0
    """K_v [-]."""
    distribution: Value = 1.0
    """K_m [-]."""

    @property
    def raised(self) -> Value:
        """W_t K_o K_v K_m [N]."""
        return self.tangential_force * self.overload * self.dynamic * self.distribution


@dataclass(frozen=True)
class AgmaRating:
    """Stresses, limits and safeties of one gear."""

    bending_stress: Annotated[
        Value, Quantity("stress"), Origin("s_t = W_t K_o K_v K_s K_m K_B/(F m J)", f"{_SOURCE}, eq. 10")
    ]
    """Bending stress number s_t [Pa]."""
    bending_limit: Annotated[Value, Quantity("stress"), Origin("s_at Y_N/(K_T K_R)", f"{_SOURCE}, eq. 13")]
    """Allowable bending stress before the safety factor [Pa]."""
    bending_safety: Annotated[Value, Quantity("ratio"), Origin("S_F", f"{_SOURCE}, eq. 13")]
    """S_F [-]."""
    contact_stress: Annotated[
        Value, Quantity("stress"), Origin("s_c = C_p √(W_t K_o K_v K_s K_m C_f/(d F I))", f"{_SOURCE}, eq. 1")
    ]
    """Contact stress number s_c [Pa]."""
    contact_limit: Annotated[Value, Quantity("stress"), Origin("s_ac Z_N C_H/(K_T K_R)", f"{_SOURCE}, eq. 4")]
    """Allowable contact stress before the safety factor [Pa]."""
    contact_safety: Annotated[Value, Quantity("ratio"), Origin("S_H", f"{_SOURCE}, eq. 4")]
    """S_H [-]."""


@dataclass(frozen=True)
class AgmaGear:
    """What the rating needs of one gear."""

    bending_factor: Value
    """J [-]."""
    strength: AgmaStrength
    """Allowable stress numbers."""
    size: Value = 1.0
    """K_s [-]."""
    rim: Value = 1.0
    """K_B [-]."""
    bending_cycles: Value = 1.0
    """Y_N [-]."""
    contact_cycles: Value = 1.0
    """Z_N [-]."""
    hardness_ratio: Value = 1.0
    """C_H [-], 1 for the pinion."""


@dataclass(frozen=True)
class AgmaMesh:
    """What the rating needs of the two gears together."""

    face_width: Value
    """Net face width F [m]."""
    module: Value
    """Transverse module m_t [m]."""
    pinion_diameter: Value
    """Operating pitch diameter of the pinion d [m]."""
    pitting_factor: Value
    """I [-]."""
    elastic_coefficient: float
    """C_p [√Pa]."""


def agma_strength(steel: AgmaSteel, grade: int, hardness: float = 0.0) -> AgmaStrength:
    """Return the allowable stress numbers of a steel.

    Args:
        steel: The steel.
        grade: 1, 2 or 3 [-].
        hardness: Brinell hardness of a through-hardened gear, or core hardness of a nitrided one [HB].

    Source: ANSI/AGMA 2001-D04, tables 3 and 4, figures 8 to 10.

    Raises:
        DesignError: a grade that the steel does not have, or a hardness outside 180 to 400 HB.

    >>> round(agma_strength(AgmaSteel.THROUGH_HARDENED, 1, 240.0).bending / 6894.757)
    31352
    """
    rows = _ROWS[steel]
    if not 1 <= grade <= len(rows):
        raise DesignError([Problem("grade", f"{grade} given; {steel.value} steel has grades 1 to {len(rows)}")])
    bending, contact = rows[grade - 1]
    if (bending[0] or contact[0]) and not 180.0 <= hardness <= 400.0:
        message = f"{hardness:g} HB given for {steel.value} steel; AGMA 2001-D04 covers 180 to 400 HB"
        raise DesignError([Problem("hardness", message)])
    return AgmaStrength(_PSI * (bending[0] * hardness + bending[1]), _PSI * (contact[0] * hardness + contact[1]))


def rim_factor_agma(backup_ratio: Value) -> Value:
    """Return the rim thickness factor K_B.

    Args:
        backup_ratio: Rim thickness below the root over the whole depth m_B [-].

    Source: ANSI/AGMA 2001-D04, annex B: 1.6 ln(2.242/m_B) below 1.2.
    """
    return as_value(np.maximum(1.0, 1.6 * np.log(2.242 / backup_ratio)))


def elastic_coefficient(elastic_moduli: tuple[float, float], poisson_ratios: tuple[float, float]) -> float:
    """Return the elastic coefficient C_p [√Pa].

    Args:
        elastic_moduli: E of pinion and gear [Pa].
        poisson_ratios: ν of pinion and gear [-].

    Source: ANSI/AGMA 2001-D04, eq. 31, √(1/(π Σ (1 − ν²)/E)).

    >>> round(elastic_coefficient((30e6, 30e6), (0.3, 0.3)))
    2291
    """
    compliance = sum((1.0 - nu**2) / e for e, nu in zip(elastic_moduli, poisson_ratios, strict=True))
    return float(np.sqrt(1.0 / (np.pi * compliance)))


def agma_rating(
    load: AgmaLoad, gear: AgmaGear, mesh: AgmaMesh, *, reliability: Value = 1.0, temperature: Value = 1.0
) -> AgmaRating:
    """Return the stresses and safeties of one gear.

    Args:
        load: W_t and its factors.
        gear: J, strengths and factors of the gear.
        mesh: Sizes, I and C_p of the pair.
        reliability: K_R [-].
        temperature: K_T [-].

    Source: ANSI/AGMA 2001-D04, clauses 5; with C_f = 1.
    """
    force = load.raised * gear.size
    bending = force * gear.rim / (mesh.face_width * mesh.module * gear.bending_factor)
    area = mesh.pinion_diameter * mesh.face_width * mesh.pitting_factor
    contact = mesh.elastic_coefficient * np.sqrt(force / area)
    scale = reliability * temperature
    bending_limit = gear.strength.bending * gear.bending_cycles / scale
    contact_limit = gear.strength.contact * gear.contact_cycles * gear.hardness_ratio / scale
    return AgmaRating(bending, bending_limit, bending_limit / bending, contact, contact_limit, contact_limit / contact)


# ----------------------------------------------------------------------------------------------------------------------
# Yielding at momentary overloads by ANSI/AGMA 2001-D04, clause 16.4.
# ----------------------------------------------------------------------------------------------------------------------


INDUSTRIAL, CONSERVATIVE = 0.75, 0.50
"""Yield strength factor K_y [-]."""


def allowable_yield(hardness: float) -> float:
    """Return the allowable yield strength number s_ay of a through-hardened steel [Pa].

    Args:
        hardness: HB of the gear, or of the core under a hard case [-].

    Source: ANSI/AGMA 2001-D04, clause 16.4: 482 HB − 32800 psi (AGMA 2101: 3.324 HB − 226 N/mm²).

    >>> round(allowable_yield(300.0) / 1e6)
    771
    """
    return _PSI * (482.0 * hardness - 32800.0)


def overload_distribution(face_width: Value) -> Value:
    """Return the load distribution factor of overloads K_my of straddle-mounted gears [-].

    Args:
        face_width: F [m].

    Source: ANSI/AGMA 2001-D04, clause 16.4: 1.07 + 0.0144 F, in inches.

    >>> round(float(overload_distribution(2.0 * 0.0254)), 4)
    1.0988
    """
    return as_value(1.07 + 0.0144 * face_width / INCH)


def yield_safety(
    force: Value, geometry: BendingGeometry, strength: float, *, face_width: Value, module: Value, factor: float
) -> Value:
    """Return by how much the root of a gear stays below yielding under its largest load [-]; 1 is just enough.

    Args:
        force: W_max [N].
        geometry: J and K_f.
        strength: s_ay [Pa].
        face_width: F [m].
        module: Transverse module m_t [m].
        factor: K_y [-].

    Source: ANSI/AGMA 2001-D04, clause 16.4: s_ay K_y ≥ W_max K_my/(F m_t J K_f).
    """
    stress = force * overload_distribution(face_width) / (face_width * module)
    return as_value(strength * factor * geometry.factor * geometry.stress_correction / stress)


# ----------------------------------------------------------------------------------------------------------------------
# Rating of one external cylindrical mesh by ANSI/AGMA 2001-D04 in one call, every factor shown.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class AgmaDuty:
    """What a mesh carries."""

    torque: Value
    """On the pinion, of one mesh [N m]."""
    speed: Value
    """Of the pinion against the carrier [rad/s]."""
    life: Value
    """Time under that load [s]."""
    overload: float = 1.0
    """K_o [-]."""
    meshes_per_turn: tuple[float, float] = (1.0, 1.0)
    """Mates that a tooth of each gear meets in a turn [-]."""


@dataclass(frozen=True)
class AgmaWheel:
    """A steel of the gear that is another than the pinion's."""

    strength: AgmaStrength
    """Allowable stress numbers."""
    bending_curve: LifeCurve
    """Y_N over cycles."""
    contact_curve: LifeCurve
    """Z_N over cycles."""
    hardnesses: Hardnesses
    """Of both gears, for C_H."""


@dataclass(frozen=True)
class AgmaMaking:
    """How both gears are made and mounted, and of what."""

    strength: AgmaStrength
    """Allowable stress numbers."""
    bending_curve: LifeCurve
    """Y_N over cycles."""
    contact_curve: LifeCurve
    """Z_N over cycles."""
    elastic_modulus: float
    """E [Pa]."""
    poisson_ratio: float
    """ν [-]."""
    quality: int = 11
    """Transmission accuracy Q_v [-]."""
    mounting: Mounting = COMMERCIAL
    """Constants of C_ma."""
    crowning: float = 1.0
    """C_mc [-]."""
    adjustment: float = 1.0
    """C_e [-]."""
    reliability: float = 0.99
    """Part of the gears that survive [-]."""
    temperature: float = 1.0
    """K_T [-]."""
    wheel: AgmaWheel | None = None
    """Steel of the gear where it is another than the pinion's."""
    rims: tuple[Value, Value] = (1.0, 1.0)
    """K_B of pinion and gear [-]."""

    def strength_of(self, gear: int) -> AgmaStrength:
        """Return the allowable stress numbers of one gear.

        Args:
            gear: 0 for the pinion, 1 for the gear.
        """
        return self.strength if gear == 0 or self.wheel is None else self.wheel.strength

    def curves_of(self, gear: int) -> tuple[LifeCurve, LifeCurve]:
        """Return Z_N and Y_N of one gear over cycles.

        Args:
            gear: 0 for the pinion, 1 for the gear.
        """
        own: AgmaMaking | AgmaWheel = self if gear == 0 or self.wheel is None else self.wheel
        return own.contact_curve, own.bending_curve


@dataclass(frozen=True)
class AgmaPairRating:
    """A rated mesh: loads, factors, stresses, safeties."""

    tangential_force: Annotated[Value, Quantity("force"), Origin("W_t = 2 T/d", f"{_SOURCE}, clause 7")]
    """Of one mesh, K_γ included [N]."""
    speed: Annotated[Value, Quantity("velocity"), Origin("v_t = ω d/2", f"{_SOURCE}, clause 7")]
    """Pitch-line velocity [m/s]."""
    cycles: Annotated[tuple[Value, Value], Quantity("number"), Origin("n = ω L q/(2 π)", f"{_SOURCE}, clause 17")]
    """Stress cycles of both gears [-]."""
    overload: Annotated[Value, Quantity("ratio"), Origin("K_o", f"{_SOURCE}, clause 9")]
    """[-]"""
    dynamic: Annotated[
        Value, Quantity("ratio"), Origin("K_v = ((A + √V)/A)^B", f"{_SOURCE}, clause 8; Shigley, eq. 14-27")
    ]
    """[-]"""
    distribution: Annotated[
        Value, Quantity("ratio"), Origin("K_m = 1 + C_mc (C_pf C_pm + C_ma C_e)", f"{_SOURCE}, clause 15.3")
    ]
    """[-]"""
    size: Annotated[
        tuple[Value, Value], Quantity("ratio"), Origin("K_s = 1.192 (F √Y m_t)^0.0535", "Shigley, section 14-10")
    ]
    """Of both gears [-]."""
    elastic: Annotated[float, Quantity("elasticity_factor"), Origin("C_p", f"{_SOURCE}, eq. 31")]
    """[√Pa]"""
    pitting_geometry: Annotated[Value, Quantity("ratio"), Origin("I", "AGMA 908-B89, clause 4")]
    """[-]"""
    tooth_root: tuple[BendingGeometry, BendingGeometry]
    """J and its parts of both gears."""
    bending_cycles: Annotated[tuple[Value, Value], Quantity("ratio"), Origin("Y_N", f"{_SOURCE}, clause 17")]
    """Of both gears [-]."""
    contact_cycles: Annotated[tuple[Value, Value], Quantity("ratio"), Origin("Z_N", f"{_SOURCE}, clause 17")]
    """Of both gears [-]."""
    reliability: Annotated[Value, Quantity("ratio"), Origin("K_R", f"{_SOURCE}, table 11")]
    """[-]"""
    temperature: Annotated[float, Quantity("ratio"), Origin("K_T", f"{_SOURCE}, clause 19")]
    """[-]"""
    strength: AgmaStrength
    """Of both gears, or of the pinion."""
    gears: tuple[AgmaRating, AgmaRating]
    """Stresses, limits and safeties of both gears."""
    rims: Annotated[tuple[Value, Value], Quantity("ratio"), Origin("K_B = 1.6 ln(2.242/m_B)", f"{_SOURCE}, annex B")]
    """Rim thickness factors of both gears [-]."""
    hardness_ratio: Annotated[Value, Quantity("ratio"), Origin("C_H", f"{_SOURCE}, clause 14")]
    """Hardness ratio factor of the gear [-]."""
    wheel_strength: AgmaStrength | None
    """Of the gear where its steel is another."""


def rate_agma(pair: HobbedPair, module: Value, duty: AgmaDuty, making: AgmaMaking) -> AgmaPairRating:
    """Return the rating of one mesh or of an array of them.

    Args:
        pair: In normal modules, pinion first.
        module: m_n [m].
        duty: Torque, speed, life.
        making: Steel, accuracy, mounting.

    Source: ANSI/AGMA 2001-D04, clauses 5 to 20, with I and J of AGMA 908-B89; C_f = 1.
    Valid for: external gears on the standard centre distance.
    """
    width, transverse = pair.face_width * module, module / np.cos(pair.helix_angle)
    diameter = 2.0 * pair.radii[0] * module
    force, speed = 2.0 * duty.torque / diameter, 0.5 * np.abs(duty.speed) * diameter
    turns = np.abs(duty.speed) * duty.life / (2.0 * np.pi)
    ratio = pair.teeth[1] / pair.teeth[0]
    cycles = turns * duty.meshes_per_turn[0], turns * duty.meshes_per_turn[1] / ratio
    load = AgmaLoad(
        force,
        duty.overload,
        dynamic_factor_agma(speed, making.quality),
        load_distribution_factor(
            width, diameter, mounting=making.mounting, crowning=making.crowning, adjustment=making.adjustment
        ),
    )
    elastic = elastic_coefficient((making.elastic_modulus,) * 2, (making.poisson_ratio,) * 2)
    mesh = AgmaMesh(width, transverse, diameter, pitting_geometry_factor(pair), elastic)
    bodies = [_body(pair, gear, cycles[gear], making=making, width=width, transverse=transverse) for gear in (0, 1)]
    survival = reliability_factor(making.reliability)
    first, second = (
        agma_rating(load, body, mesh, reliability=survival, temperature=making.temperature) for body, _ in bodies
    )
    (one, j_one), (other, j_other) = bodies
    return AgmaPairRating(
        tangential_force=force,
        speed=speed,
        cycles=cycles,
        overload=duty.overload,
        dynamic=load.dynamic,
        distribution=load.distribution,
        size=(one.size, other.size),
        elastic=elastic,
        pitting_geometry=mesh.pitting_factor,
        tooth_root=(j_one, j_other),
        bending_cycles=(one.bending_cycles, other.bending_cycles),
        contact_cycles=(one.contact_cycles, other.contact_cycles),
        reliability=survival,
        temperature=making.temperature,
        strength=making.strength,
        gears=(first, second),
        rims=making.rims,
        hardness_ratio=other.hardness_ratio,
        wheel_strength=None if making.wheel is None else making.wheel.strength,
    )


def _body(
    pair: HobbedPair, gear: int, cycles: Value, *, making: AgmaMaking, width: Value, transverse: Value
) -> tuple[AgmaGear, BendingGeometry]:
    """Return what the rating needs of one gear, and its J with parts."""
    geometry = bending_geometry(pair, gear)
    contact_curve, bending_curve = making.curves_of(gear)
    harder = making.wheel.hardnesses if gear == 1 and making.wheel is not None else None
    body = AgmaGear(
        bending_factor=geometry.factor,
        strength=making.strength_of(gear),
        size=size_factor(width, transverse, lewis_form_factor(pair.virtual_teeth[gear])),
        rim=making.rims[gear],
        bending_cycles=life_factor(bending_curve, cycles),
        contact_cycles=life_factor(contact_curve, cycles),
        hardness_ratio=hardness_ratio_of(harder, pair.teeth[1] / pair.teeth[0]),
    )
    return body, geometry


def greatest_velocity(quality: float) -> float:
    """Return the pitch-line velocity up to which the curve of K_v holds [m/s].

    Args:
        quality: Transmission accuracy Q_v, 5 to 11 [-].

    Source: ANSI/AGMA 2001-D04, clause 8, as Shigley 9th ed., eq. 14-29: (A + Q_v − 3)² in ft/min.

    >>> round(greatest_velocity(11), 1)
    50.8
    """
    base = 50.0 + 56.0 * (1.0 - 0.25 * (12.0 - quality) ** (2.0 / 3.0))
    return float((base + quality - 3.0) ** 2 * FOOT / 60.0)
