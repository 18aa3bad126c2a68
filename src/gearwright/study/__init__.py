"""Studies: the same verbs over many designs."""

from gearwright.study.answers import Row, Table
from gearwright.study.cases import for_engine
from gearwright.study.running import run

__all__ = ["Row", "Table", "for_engine", "run"]
