"""Running studies of any size: here and now, by workers, on a cluster, with a journal that survives.

A single case is computed in `cases`.
"""

from gearwright.study.journal.journal import Journal, begin, in_memory, opened, recorded, rows_of, status, verify
from gearwright.study.journal.made_with import changes_of, made_with
from gearwright.study.running.cluster import Cluster, commands
from gearwright.study.running.compare import compare
from gearwright.study.running.fly_many import fly_many
from gearwright.study.running.parts import Part, merge, part_of, slurm
from gearwright.study.running.reducing import is_reduced, merge_reduced, reduce_study
from gearwright.study.running.reliable import LimitState, Reliability, reliability
from gearwright.study.running.run import run, table_of
from gearwright.study.running.runner import Progress, Start, refuse_changes, resume, run_study
from gearwright.study.running.search import children, generations
from gearwright.study.running.workers import Compute, local

__all__ = [
    "Cluster",
    "Compute",
    "Journal",
    "LimitState",
    "Part",
    "Progress",
    "Reliability",
    "Start",
    "begin",
    "changes_of",
    "children",
    "commands",
    "compare",
    "fly_many",
    "generations",
    "in_memory",
    "is_reduced",
    "local",
    "made_with",
    "merge",
    "merge_reduced",
    "opened",
    "part_of",
    "recorded",
    "reduce_study",
    "refuse_changes",
    "reliability",
    "resume",
    "rows_of",
    "run",
    "run_study",
    "slurm",
    "status",
    "table_of",
    "verify",
]
