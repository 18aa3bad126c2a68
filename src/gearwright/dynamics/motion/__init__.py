"""Systems in time: steps and their size, recording, one run or many side by side, and the trace that is left.

Spectra, steady states and maps over speed are in `vibration`.
"""

from gearwright.dynamics.motion.accuracy import (
    GIVEN,
    PARTING,
    SMOOTH,
    Error,
    Forces,
    errors_of,
    shortfall,
)
from gearwright.dynamics.motion.ensemble import Ensemble, ends_of, simulate_many
from gearwright.dynamics.motion.marching import followed, stored_energy, with_profile
from gearwright.dynamics.motion.record import (
    BLOCK,
    CHECKPOINTS,
    Checkpoints,
    Orders,
    Outputs,
    Samples,
    Statistics,
    Trace,
    index_of,
    line_numbers,
    summary_of,
)
from gearwright.dynamics.motion.simulate import (
    UNDAMPED,
    check_shared_load,
    endless,
    equilibrium,
    replay,
    simulate,
    slack_lines,
)
from gearwright.dynamics.motion.steps import (
    STABLE,
    Accuracy,
    blank_record,
    blank_summary,
    check_step,
    default_step,
    fastest_rate,
    stepper,
)

__all__ = [
    "BLOCK",
    "CHECKPOINTS",
    "GIVEN",
    "PARTING",
    "SMOOTH",
    "STABLE",
    "UNDAMPED",
    "Accuracy",
    "Checkpoints",
    "Ensemble",
    "Error",
    "Forces",
    "Orders",
    "Outputs",
    "Samples",
    "Statistics",
    "Trace",
    "blank_record",
    "blank_summary",
    "check_shared_load",
    "check_step",
    "default_step",
    "endless",
    "ends_of",
    "equilibrium",
    "errors_of",
    "fastest_rate",
    "followed",
    "index_of",
    "line_numbers",
    "replay",
    "shortfall",
    "simulate",
    "simulate_many",
    "slack_lines",
    "stepper",
    "stored_energy",
    "summary_of",
    "with_profile",
]
