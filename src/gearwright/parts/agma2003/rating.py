"""Rating of one bevel pair by ANSI/AGMA 2003 in one call, every factor shown."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated, NamedTuple

from gearwright.parts.agma2003.bending import BendingGeometry, bending_geometry
from gearwright.parts.agma2003.factors import BevelStrength
from gearwright.parts.agma2003.mesh import AgmaBevelDuty, AgmaBevelFactors, AgmaBevelMaking, bevel_factors
from gearwright.parts.agma2003.pitting import PittingGeometry, pitting_geometry
from gearwright.parts.agma2003.section import SOURCE, MeanSection
from gearwright.parts.bevel import BevelPair
from gearwright.units import Origin, Quantity


class BevelGeometry(NamedTuple):
    """The geometry factors of a pair, which its size does not change."""

    pitting: PittingGeometry
    """I and its parts."""
    bending: tuple[BendingGeometry, BendingGeometry]
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
    tooth_root: tuple[BendingGeometry, BendingGeometry]
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

    >>> from gearwright.parts.bevel import BevelTooth
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
