"""One step after another: how large, and by which scheme (exact, explicit, adaptive, implicit).

What is kept of them is in `record`; whole runs are in `motion` itself.
"""

from gearwright.dynamics.motion.steps.bounds import damping_bound
from gearwright.dynamics.motion.steps.exact import is_exact
from gearwright.dynamics.motion.steps.pacing import pace_of
from gearwright.dynamics.motion.steps.steppers import (
    ADAPTIVE,
    METHODS,
    Stepper,
    blank_record,
    blank_summary,
    generated_run,
    stepper,
)
from gearwright.dynamics.motion.steps.stepsize import (
    MARGIN,
    RMS_SHARE,
    STABLE,
    Accuracy,
    Pace,
    check_duration,
    check_step,
    default_step,
    excited_step,
    fastest_rate,
    may_take,
    whole_step,
)

__all__ = [
    "ADAPTIVE",
    "MARGIN",
    "METHODS",
    "RMS_SHARE",
    "STABLE",
    "Accuracy",
    "Pace",
    "Stepper",
    "blank_record",
    "blank_summary",
    "check_duration",
    "check_step",
    "damping_bound",
    "default_step",
    "excited_step",
    "fastest_rate",
    "generated_run",
    "is_exact",
    "may_take",
    "pace_of",
    "stepper",
    "whole_step",
]
