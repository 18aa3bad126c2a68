"""REXS files as designs: shafts, gears, stages, bearings and loads.

Nothing is written or sized here; only a file of gearwright's own is held against the sizing of its design.
"""

from gearwright.exchange.rexs.files import LARGEST
from gearwright.exchange.rexs.reading.read import ImportedRexs, from_rexs
from gearwright.exchange.rexs.reading.stated import Stated

__all__ = ["LARGEST", "ImportedRexs", "Stated", "from_rexs"]
