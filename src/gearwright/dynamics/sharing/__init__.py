"""How parallel paths share their load: coefficients, solutions of rising cost, errors, planets, tolerances.

The closed form of a train's redundancy is in `equations`.
"""

from gearwright.dynamics.sharing.coefficients import (
    mesh_load_factor,
    share_coefficients,
    tooth_cycle_means,
    tooth_cycle_shares,
)
from gearwright.dynamics.sharing.effects_of_errors import Distribution, clocking_optimum, influences, monte_carlo
from gearwright.dynamics.sharing.elastic import PathShare, elastic_shares, path_shares
from gearwright.dynamics.sharing.error_sources import (
    as_forces,
    drawn_set,
    error_sources,
    peak_shares,
    random_sets,
    with_errors,
)
from gearwright.dynamics.sharing.judged import load_factors, sharing_checks
from gearwright.dynamics.sharing.of_design import (
    SharingProblem,
    SharingStudy,
    SupportSweep,
    parallel_meshes,
    shaft_displacement,
    sharing,
    sharing_problem,
    sharing_study,
    single_error_sharing,
    support_sweep,
)
from gearwright.dynamics.sharing.planet_counts import PlanetCounts, planet_counts
from gearwright.dynamics.sharing.planets import PlanetSharing, PlanetTolerances, planet_sharing
from gearwright.dynamics.sharing.solutions import SIDEBANDS, TRANSIENT, LoadSharing, load_sharing
from gearwright.dynamics.sharing.tolerance_allocation import Allocation, allocate

__all__ = [
    "SIDEBANDS",
    "TRANSIENT",
    "Allocation",
    "Distribution",
    "LoadSharing",
    "PathShare",
    "PlanetCounts",
    "PlanetSharing",
    "PlanetTolerances",
    "SharingProblem",
    "SharingStudy",
    "SupportSweep",
    "allocate",
    "as_forces",
    "clocking_optimum",
    "drawn_set",
    "elastic_shares",
    "error_sources",
    "influences",
    "load_factors",
    "load_sharing",
    "mesh_load_factor",
    "monte_carlo",
    "parallel_meshes",
    "path_shares",
    "peak_shares",
    "planet_counts",
    "planet_sharing",
    "random_sets",
    "shaft_displacement",
    "share_coefficients",
    "sharing",
    "sharing_checks",
    "sharing_problem",
    "sharing_study",
    "single_error_sharing",
    "support_sweep",
    "tooth_cycle_means",
    "tooth_cycle_shares",
    "with_errors",
]
