"""The choice of tooth numbers: candidates of each stage, the lightest combination, and why there is none.

How large the teeth become is for `stages`.
"""

from gearwright.sizing.teeth.masses import made_share
from gearwright.sizing.teeth.refusal import refuse_contradictions
from gearwright.sizing.teeth.search import Chosen, choose_teeth
from gearwright.sizing.teeth.states import EQUAL
from gearwright.sizing.teeth.trying import CONSIDERED, StageTeeth, Trying, stage_teeth

__all__ = [
    "CONSIDERED",
    "EQUAL",
    "Chosen",
    "StageTeeth",
    "Trying",
    "choose_teeth",
    "made_share",
    "refuse_contradictions",
    "stage_teeth",
]
