"""What follows from a System without going through time: right-hand side, statics, modes, redundancy, energy.

Generated code is in `codegen`, motion in `motion`. `kernel` and `drive_laws`, which numba compiles, are imported by
name where something runs through time: numba takes longer to load than statics to solve.
"""

from gearwright.dynamics.equations.modes import (
    DampedModes,
    Linear,
    Modes,
    damped_modes,
    damped_rates,
    linear,
    modes,
    split_rigid,
    state_matrix,
    steady_forces,
)
from gearwright.dynamics.equations.reference import (
    WORKS,
    Work,
    acceleration,
    dead_zone,
    errors_at,
    line_state,
    speed_factor,
    speed_factors,
    stiffness_at,
)
from gearwright.dynamics.equations.statics import (
    Equilibrium,
    Redundancy,
    line_forces,
    redundancy,
    slow_position,
    statics,
    unbalanced,
)

__all__ = [
    "WORKS",
    "DampedModes",
    "Equilibrium",
    "Linear",
    "Modes",
    "Redundancy",
    "Work",
    "acceleration",
    "damped_modes",
    "damped_rates",
    "dead_zone",
    "errors_at",
    "line_forces",
    "line_state",
    "linear",
    "modes",
    "redundancy",
    "slow_position",
    "speed_factor",
    "speed_factors",
    "split_rigid",
    "state_matrix",
    "statics",
    "steady_forces",
    "stiffness_at",
    "unbalanced",
]
