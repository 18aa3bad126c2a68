"""Studies: the same verbs over many designs."""

from gearwright.study.engine import for_engine
from gearwright.study.run import run
from gearwright.study.table import Row, Table

__all__ = ["Row", "Table", "for_engine", "run"]
