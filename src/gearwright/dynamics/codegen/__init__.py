"""Machine code for one structure of System: assembly written, compiled in memory, called.

What is solved with it is decided in `motion`.
"""

from gearwright.dynamics.codegen.assembler import CHUNK, SINGLE, address, aligned
from gearwright.dynamics.codegen.excitation import (
    FUNCTIONS as CLOCK,
    Clocked,
    clock,
    clocked,
    set_clock,
    unturned,
    waves_of,
)
from gearwright.dynamics.codegen.generate import BLOCK, Compiled, compiled
from gearwright.dynamics.codegen.rows import (
    AFTER,
    BEFORE,
    SIDE,
    Size,
    blank_crests,
    bring_crests,
    crests_code,
    lagrange,
    recurrence,
    summarise,
    summary_code,
)
from gearwright.dynamics.codegen.topology import (
    Topology,
    drive_width,
    filled,
    parameter_rows,
    parameters,
    record_width,
    table_width,
    topology,
    wave_width,
)

__all__ = [
    "AFTER",
    "BEFORE",
    "BLOCK",
    "CHUNK",
    "CLOCK",
    "SIDE",
    "SINGLE",
    "Clocked",
    "Compiled",
    "Size",
    "Topology",
    "address",
    "aligned",
    "blank_crests",
    "bring_crests",
    "clock",
    "clocked",
    "compiled",
    "crests_code",
    "drive_width",
    "filled",
    "lagrange",
    "parameter_rows",
    "parameters",
    "record_width",
    "recurrence",
    "set_clock",
    "summarise",
    "summary_code",
    "table_width",
    "topology",
    "unturned",
    "wave_width",
    "waves_of",
]
