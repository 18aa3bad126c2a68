"""The cases of a study, and one case computed.

Which answers they give together is in `answers`, how thousands are run in `running`.
"""

from gearwright.study.cases.engine import for_engine, for_requirement, refuse_no_size
from gearwright.study.cases.evaluate import evaluate, fixed, refuse_unknown_paths, results_of, reviewed, sized, split
from gearwright.study.cases.flights import TOGETHER, fly_together
from gearwright.study.cases.sampling import Case, cases, unit_sample
from gearwright.study.cases.together import LEAST, evaluated, goes_together

__all__ = [
    "LEAST",
    "TOGETHER",
    "Case",
    "cases",
    "evaluate",
    "evaluated",
    "fixed",
    "fly_together",
    "for_engine",
    "for_requirement",
    "goes_together",
    "refuse_no_size",
    "refuse_unknown_paths",
    "results_of",
    "reviewed",
    "sized",
    "split",
    "unit_sample",
]
