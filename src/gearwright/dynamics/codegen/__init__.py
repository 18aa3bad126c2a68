"""Machine code for one structure of System: assembly written, compiled in memory, called.

What is solved with it is decided in `motion`.
"""

from gearwright.dynamics.codegen.assembler import address, aligned
from gearwright.dynamics.codegen.clock import FUNCTIONS as CLOCK
from gearwright.dynamics.codegen.clock import Clocked, clock, clocked, set_clock, unturned, waves_of
from gearwright.dynamics.codegen.crests import AFTER, BEFORE, blank_crests, bring_crests, crests_code, lagrange
from gearwright.dynamics.codegen.emit import CHUNK, SINGLE
from gearwright.dynamics.codegen.march import BLOCK
from gearwright.dynamics.codegen.native import Compiled, compiled
from gearwright.dynamics.codegen.recurrence import SIDE, Size, recurrence
from gearwright.dynamics.codegen.summary import summarise, summary_code
from gearwright.dynamics.codegen.topology import Topology, filled, parameter_rows, parameters, topology
from gearwright.dynamics.codegen.writer import drive_width, record_width, table_width, wave_width

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
