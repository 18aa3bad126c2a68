"""Gearboxes in REXS, the exchange format of FVA: a writer of sizings, a reader of designs, and the words of both.

The database of REXS itself, with which files are checked, lies with the tests.
"""

from gearwright.exchange.rexs.files import LARGEST, VERSIONS
from gearwright.exchange.rexs.reading import ImportedRexs, Stated, from_rexs
from gearwright.exchange.rexs.writing import RexsFile, to_rexs

__all__ = ["LARGEST", "VERSIONS", "ImportedRexs", "RexsFile", "Stated", "from_rexs", "to_rexs"]
