"""The choice of tooth numbers: candidates of each stage, the lightest combination, and why there is none.

How large the teeth become is for `stages`.
"""

from gearwright.sizing.teeth.refusal import refuse_contradictions
from gearwright.sizing.teeth.search import Chosen, choose_teeth
from gearwright.sizing.teeth.states import EQUAL

__all__ = ["EQUAL", "Chosen", "choose_teeth", "refuse_contradictions"]
