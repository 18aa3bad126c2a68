"""Files about many designs or missions: studies, the axes that they vary, mixes of missions.

What is computed of them is in `study` and `mission/lives`.
"""

from gearwright.spec.studies.axis import MOST_VALUES, Axis, Value, axis_length, axis_values, value_at
from gearwright.spec.studies.checks import MOST_STEPS, SCATTERED, TRIED_STEPS, case_count, study_problems
from gearwright.spec.studies.mix import Mix, MixFile, parse_mix, read_mix
from gearwright.spec.studies.read import mission_changed, parse_study, read_study
from gearwright.spec.studies.search import Search
from gearwright.spec.studies.study import MISSION_PATH, RELIABILITY, Bound, Flown, Simulated, Study

__all__ = [
    "MISSION_PATH",
    "MOST_STEPS",
    "MOST_VALUES",
    "RELIABILITY",
    "SCATTERED",
    "TRIED_STEPS",
    "Axis",
    "Bound",
    "Flown",
    "Mix",
    "MixFile",
    "Search",
    "Simulated",
    "Study",
    "Value",
    "axis_length",
    "axis_values",
    "case_count",
    "mission_changed",
    "parse_mix",
    "parse_study",
    "read_mix",
    "read_study",
    "study_problems",
    "value_at",
]
