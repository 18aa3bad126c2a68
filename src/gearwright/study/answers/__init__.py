"""What the rows of a study say: table, Pareto front, verdict, sensitivities, export.

How rows come about is in `cases` and `running`.
"""

from gearwright.study.answers.blocks import (
    NUMBER,
    OTHER,
    REAL,
    WHOLE,
    Block,
    Blocks,
    Shape,
    block_of_columns,
    blocks_of,
)
from gearwright.study.answers.export import columns, refuse_export, write_table
from gearwright.study.answers.pareto import (
    FAILED,
    Limit,
    crowding,
    front_table,
    left_of,
    limits_of,
    non_dominated,
    pareto_front,
    ranks,
    violations,
    wanted,
)
from gearwright.study.answers.reduced import Reduced, as_plain, from_plain
from gearwright.study.answers.sensitivity import Influence, sensitivity, varies
from gearwright.study.answers.table import Row, Table, kind_of, quantiles
from gearwright.study.answers.verdict import Standing, Verdict, bound, confidence, kept, scenarios, verdict

__all__ = [
    "FAILED",
    "NUMBER",
    "OTHER",
    "REAL",
    "WHOLE",
    "Block",
    "Blocks",
    "Influence",
    "Limit",
    "Reduced",
    "Row",
    "Shape",
    "Standing",
    "Table",
    "Verdict",
    "as_plain",
    "block_of_columns",
    "blocks_of",
    "bound",
    "columns",
    "confidence",
    "crowding",
    "from_plain",
    "front_table",
    "kept",
    "kind_of",
    "left_of",
    "limits_of",
    "non_dominated",
    "pareto_front",
    "quantiles",
    "ranks",
    "refuse_export",
    "scenarios",
    "sensitivity",
    "varies",
    "verdict",
    "violations",
    "wanted",
    "write_table",
]
