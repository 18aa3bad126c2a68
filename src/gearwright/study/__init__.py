"""Studies: the same verbs over many designs."""

from gearwright.study.answers.table import Row, Table
from gearwright.study.cases.engine import for_engine, for_requirement
from gearwright.study.running.compare import compare
from gearwright.study.running.equal_life import EqualLife, equal_life
from gearwright.study.running.fly_many import fly_many
from gearwright.study.running.run import run
from gearwright.verbs import callable_layer

__all__ = ["EqualLife", "Row", "Table", "compare", "equal_life", "fly_many", "for_engine", "for_requirement", "run"]

callable_layer(__name__, run)
