"""Files of other tools, written from what gearwright computes and read into what it designs: REXS, FMUs, STEP, tables.

Solids as GLB are `shape`'s, drawings `render`'s, runs and values `store`'s.
"""

from gearwright.exchange.fmu import FmuFile, fmu_of_system, fmu_of_window, to_fmu
from gearwright.exchange.rexs import VERSIONS, ImportedRexs, RexsFile, Stated, from_rexs, to_rexs

__all__ = [
    "VERSIONS",
    "FmuFile",
    "ImportedRexs",
    "RexsFile",
    "Stated",
    "fmu_of_system",
    "fmu_of_window",
    "from_rexs",
    "to_fmu",
    "to_rexs",
]
