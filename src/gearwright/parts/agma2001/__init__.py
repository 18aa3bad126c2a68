"""Rating of cylindrical gears by ANSI/AGMA 2001-D04 with the geometry factors of AGMA 908.

Nothing of ISO lives here.
"""

from gearwright.parts.agma2001.factors import (
    BENDING_CARBURISED,
    BENDING_HB250,
    EXTRA_PRECISION,
    OPEN_GEARING,
    PITTING,
    cycle_factor,
    dynamic_factor_agma,
    hardness_ratio_factor,
    load_distribution_factor,
    reliability_factor,
    size_factor,
)
from gearwright.parts.agma2001.geometry import (
    HobbedPair,
    LoadPlace,
    bending_geometry,
    helical_overlap_factor,
    load_sharing_ratio,
    pitting_geometry_factor,
    stress_correction,
)
from gearwright.parts.agma2001.rating import (
    AgmaGear,
    AgmaLoad,
    AgmaMesh,
    AgmaSteel,
    AgmaStrength,
    agma_rating,
    agma_strength,
    elastic_coefficient,
    rim_factor_agma,
)

__all__ = [
    "BENDING_CARBURISED",
    "BENDING_HB250",
    "EXTRA_PRECISION",
    "OPEN_GEARING",
    "PITTING",
    "AgmaGear",
    "AgmaLoad",
    "AgmaMesh",
    "AgmaSteel",
    "AgmaStrength",
    "HobbedPair",
    "LoadPlace",
    "agma_rating",
    "agma_strength",
    "bending_geometry",
    "cycle_factor",
    "dynamic_factor_agma",
    "elastic_coefficient",
    "hardness_ratio_factor",
    "helical_overlap_factor",
    "load_distribution_factor",
    "load_sharing_ratio",
    "pitting_geometry_factor",
    "reliability_factor",
    "rim_factor_agma",
    "size_factor",
    "stress_correction",
]
