"""Sizings as REXS files: components with their numbers, relations and load cases.

Nothing is read or sized here.
"""

from gearwright.exchange.rexs.writing.write import RexsFile, to_rexs

__all__ = ["RexsFile", "to_rexs"]
