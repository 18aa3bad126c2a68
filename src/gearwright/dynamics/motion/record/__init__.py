"""What is kept of a run, and the trace that is left: samples, statistics, orders, checkpoints, columns with names.

It takes no step; files of runs are written by `store`.
"""

from gearwright.dynamics.motion.record.marks import TOGETHER, Apart
from gearwright.dynamics.motion.record.recorder import BLOCK, CHECKPOINTS, Outputs, Recorder, summary_of
from gearwright.dynamics.motion.record.taking import FUNCTIONS as TAKE
from gearwright.dynamics.motion.record.taking import RUNAWAY, Taking, take
from gearwright.dynamics.motion.record.trace import (
    Checkpoints,
    Orders,
    Samples,
    Statistics,
    Trace,
    index_of,
    line_numbers,
)

__all__ = [
    "BLOCK",
    "CHECKPOINTS",
    "RUNAWAY",
    "TAKE",
    "TOGETHER",
    "Apart",
    "Checkpoints",
    "Orders",
    "Outputs",
    "Recorder",
    "Samples",
    "Statistics",
    "Taking",
    "Trace",
    "index_of",
    "line_numbers",
    "summary_of",
    "take",
]
