"""Rating of bevel gears by ANSI/AGMA 2003, with the geometry factors I and J of its annex C.

Cones and forces are in `bevel`; K_v, K_R, C_H and C_p, which AGMA 2001 has too, in `agma2001`.
"""

from gearwright.parts.agma2003.bending import BendingGeometry, bending_geometry
from gearwright.parts.agma2003.factors import (
    BENDING,
    BENDING_CRITICAL,
    CONTACT,
    CROWNED,
    ONE_STRADDLE,
    OVERHUNG,
    STRADDLE,
    UNCROWNED,
    BevelEdition,
    BevelSteel,
    BevelStrength,
    bevel_strength,
    lengthwise_curvature,
    load_distribution,
    size_factor_bending,
    size_factor_contact,
    temperature_factor,
)
from gearwright.parts.agma2003.mesh import AgmaBevelDuty, AgmaBevelFactors, AgmaBevelMaking, bevel_factors
from gearwright.parts.agma2003.pitting import PittingGeometry, pitting_geometry
from gearwright.parts.agma2003.rating import (
    AgmaBevelGear,
    AgmaBevelRating,
    BevelGeometry,
    bevel_geometry,
    rate_agma_bevel,
    rate_with_factors,
)
from gearwright.parts.agma2003.section import MeanSection

__all__ = [
    "BENDING",
    "BENDING_CRITICAL",
    "CONTACT",
    "CROWNED",
    "ONE_STRADDLE",
    "OVERHUNG",
    "STRADDLE",
    "UNCROWNED",
    "AgmaBevelDuty",
    "AgmaBevelFactors",
    "AgmaBevelGear",
    "AgmaBevelMaking",
    "AgmaBevelRating",
    "BendingGeometry",
    "BevelEdition",
    "BevelGeometry",
    "BevelSteel",
    "BevelStrength",
    "MeanSection",
    "PittingGeometry",
    "bending_geometry",
    "bevel_factors",
    "bevel_geometry",
    "bevel_strength",
    "lengthwise_curvature",
    "load_distribution",
    "pitting_geometry",
    "rate_agma_bevel",
    "rate_with_factors",
    "size_factor_bending",
    "size_factor_contact",
    "temperature_factor",
]
