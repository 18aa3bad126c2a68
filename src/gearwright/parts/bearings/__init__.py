"""Rolling bearings: what is inside them, ratings, equivalent loads, lives by ISO 281 and ISO/TS 16281.

Which size is taken is for the catalogue and `sizing`.
"""

from gearwright.parts.bearings.contact import (
    Curvature,
    ball_contacts,
    ellipse_ratio,
    load_at_pressure,
    load_deflection_constant,
)
from gearwright.parts.bearings.distribution import RingLoad, load_distribution
from gearwright.parts.bearings.life import (
    basic_life,
    basic_reference_life,
    life_exponent,
    life_time,
    pair_factor,
    reliability_factor,
    system_life,
    weibull_slope,
)
from gearwright.parts.bearings.load import (
    DEEP_GROOVE_STATIC,
    FOUR_POINT,
    FOUR_POINT_STATIC,
    ISO_R281_1962,
    FactorTable,
    LoadFactors,
    deep_groove_factors,
    equivalent_load,
    mean_load,
    static_equivalent_load,
    static_safety,
    taper_factors,
    taper_pair_thrusts,
    taper_static_factors,
)
from gearwright.parts.bearings.modified_life import (
    Cleanliness,
    OilFilter,
    cleanliness_factor,
    contamination_factor,
    life_modification,
    reference_viscosity,
)
from gearwright.parts.bearings.rating import (
    ball_dynamic_factor,
    ball_static_factor,
    dynamic_rating,
    fatigue_load_limit,
    roller_dynamic_factor,
    static_rating,
)
from gearwright.parts.bearings.rolling_bearing import BearingGeometry, BearingKind
from gearwright.parts.bearings.speed import least_load, speed_factor, thermal_reference_speed

__all__ = [
    "DEEP_GROOVE_STATIC",
    "FOUR_POINT",
    "FOUR_POINT_STATIC",
    "ISO_R281_1962",
    "BearingGeometry",
    "BearingKind",
    "Cleanliness",
    "Curvature",
    "FactorTable",
    "LoadFactors",
    "OilFilter",
    "RingLoad",
    "ball_contacts",
    "ball_dynamic_factor",
    "ball_static_factor",
    "basic_life",
    "basic_reference_life",
    "cleanliness_factor",
    "contamination_factor",
    "deep_groove_factors",
    "dynamic_rating",
    "ellipse_ratio",
    "equivalent_load",
    "fatigue_load_limit",
    "least_load",
    "life_exponent",
    "life_modification",
    "life_time",
    "load_at_pressure",
    "load_deflection_constant",
    "load_distribution",
    "mean_load",
    "pair_factor",
    "reference_viscosity",
    "reliability_factor",
    "roller_dynamic_factor",
    "speed_factor",
    "static_equivalent_load",
    "static_rating",
    "static_safety",
    "system_life",
    "taper_factors",
    "taper_pair_thrusts",
    "taper_static_factors",
    "thermal_reference_speed",
    "weibull_slope",
]
