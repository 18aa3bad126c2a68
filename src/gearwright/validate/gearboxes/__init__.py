"""Whole gearboxes with published masses: each sized from its requirement, and how the sums of parts stand to them.

What they weigh part by part is `sizing.mass`'s; statistics over β are `weights`'s.
"""

from gearwright.validate.gearboxes.designs import design_of
from gearwright.validate.gearboxes.held import Held, Score, fitted, held, left_out, score

__all__ = ["Held", "Score", "design_of", "fitted", "held", "left_out", "score"]
