"""Studies: the same verbs over many designs."""

from gearwright.study.answers.table import Row, Table
from gearwright.study.cases.engine import for_engine
from gearwright.study.running.run import run
from gearwright.study.split_torque import SplitTorque, split_torque

__all__ = ["Row", "SplitTorque", "Table", "for_engine", "run", "split_torque"]
