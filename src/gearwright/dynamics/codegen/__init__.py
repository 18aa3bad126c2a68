"""Machine code for one structure of System: assembly written, compiled in memory, called.

What is solved with it is decided in `motion`.
"""

from gearwright.dynamics.codegen.assembler import aligned
from gearwright.dynamics.codegen.clock import clock, waves_of
from gearwright.dynamics.codegen.crests import AFTER, BEFORE, blank_crests, bring_crests, lagrange
from gearwright.dynamics.codegen.native import Compiled, compiled
from gearwright.dynamics.codegen.recurrence import SIDE, Size, recurrence
from gearwright.dynamics.codegen.summary import summarise
from gearwright.dynamics.codegen.topology import Topology, filled, parameter_rows, parameters, topology
from gearwright.dynamics.codegen.writer import drive_width, record_width, table_width, wave_width

__all__ = [
    "AFTER",
    "BEFORE",
    "SIDE",
    "Compiled",
    "Size",
    "Topology",
    "aligned",
    "blank_crests",
    "bring_crests",
    "clock",
    "compiled",
    "drive_width",
    "filled",
    "lagrange",
    "parameter_rows",
    "parameters",
    "record_width",
    "recurrence",
    "summarise",
    "table_width",
    "topology",
    "wave_width",
    "waves_of",
]
