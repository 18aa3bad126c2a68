"""Bending and pitting of spur and helical gears by ANSI/AGMA 2001-D04, with J and I of AGMA 908."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import Annotated

import numpy as np

from gearwright.errors import DesignError, Problem
from gearwright.parts.iso6336 import Value, as_value
from gearwright.units import INCH, POUND_FORCE, Origin, Quantity

_SOURCE = "ANSI/AGMA 2001-D04"
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
