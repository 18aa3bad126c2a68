"""Files of other tools, written from what gearwright computes and read into what it designs: REXS.

Solids as GLB are `shape`'s, drawings `render`'s, runs and values `store`'s.
"""

from gearwright.exchange.rexs import VERSIONS, RexsFile, to_rexs

__all__ = ["VERSIONS", "RexsFile", "to_rexs"]
