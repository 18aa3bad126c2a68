"""The choice of tooth numbers: candidates of each stage, the lightest combination, and why there is none.

How large the teeth become is for `stages`.
"""

from gearwright.sizing.teeth.candidates import EQUAL
from gearwright.sizing.teeth.search import CONSIDERED, Chosen, StageTeeth, choose_teeth, stage_teeth
from gearwright.sizing.teeth.stage import refuse_contradictions

__all__ = [
    "CONSIDERED",
    "EQUAL",
    "Chosen",
    "StageTeeth",
    "choose_teeth",
    "refuse_contradictions",
    "stage_teeth",
]
