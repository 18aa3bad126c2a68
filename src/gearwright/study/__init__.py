"""Studies: the same verbs over many designs."""

from gearwright.study.answers.table import Row, Table
from gearwright.study.cases.engine import for_engine
from gearwright.study.running.run import run

__all__ = ["Row", "Table", "for_engine", "run"]
