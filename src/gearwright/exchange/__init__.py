"""Files of other tools, written from what gearwright computes and read into what it designs: REXS, FMUs, STEP, tables.

Solids as GLB are `shape`'s, drawings `render`'s, runs and values `store`'s.
"""

from importlib import import_module
from typing import TYPE_CHECKING

from gearwright.exchange.rexs import VERSIONS, ImportedRexs, RexsFile, Stated, from_rexs, to_rexs

if TYPE_CHECKING:
    from gearwright.exchange.fmu import FmuFile, fmu_of_system, fmu_of_window, to_fmu

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


def __getattr__(name: str) -> object:
    """Load what writes FMUs on its first use: the dynamics take a second, which files of gearboxes do not need."""
    if name not in ("FmuFile", "fmu_of_system", "fmu_of_window", "to_fmu"):
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value: object = getattr(import_module("gearwright.exchange.fmu"), name)
    return value
