"""What gearboxes weigh by statistics: public mass methods, the refit of real weights, their comparison.

The mass that follows from a design's own parts is `sizing`'s.
"""

from gearwright.weights.asked import engines, mass
from gearwright.weights.comparison import Comparison, StatedMass, compare
from gearwright.weights.engine_check import (
    COLUMNS,
    Check,
    CheckedEngine,
    Verdict,
    check_engine,
    checked_engines,
    gearbox_mass,
)
from gearwright.weights.laws import (
    EXISTING_GEARBOXES,
    mass_afdd00,
    mass_afdd83,
    mass_brown,
    mass_tm215680,
    mass_wate2,
)
from gearwright.weights.method import Coverage, Estimate, Range, estimate
from gearwright.weights.methods import methods
from gearwright.weights.refit import LogLine, bands, log_line, mass_refit, refit
from gearwright.weights.requirement import Requirement, beta, from_beta
from gearwright.weights.scoreboard import Score, corners, left_out_scatter, middle, scores
from gearwright.weights.willis import bracket_epicyclic, bracket_planetary, lightest_planet

__all__ = [
    "COLUMNS",
    "EXISTING_GEARBOXES",
    "Check",
    "CheckedEngine",
    "Comparison",
    "Coverage",
    "Estimate",
    "LogLine",
    "Range",
    "Requirement",
    "Score",
    "StatedMass",
    "Verdict",
    "bands",
    "beta",
    "bracket_epicyclic",
    "bracket_planetary",
    "check_engine",
    "checked_engines",
    "compare",
    "corners",
    "engines",
    "estimate",
    "from_beta",
    "gearbox_mass",
    "left_out_scatter",
    "lightest_planet",
    "log_line",
    "mass",
    "mass_afdd00",
    "mass_afdd83",
    "mass_brown",
    "mass_refit",
    "mass_tm215680",
    "mass_wate2",
    "methods",
    "middle",
    "refit",
    "scores",
]
