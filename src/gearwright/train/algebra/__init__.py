"""What matrices of a train give: their null spaces, and results remembered by matrix. It knows no train."""

from gearwright.train.algebra.memory import remembered
from gearwright.train.algebra.null_space import RANK_TOLERANCE, null_space, row_and_null_space

__all__ = [
    "RANK_TOLERANCE",
    "null_space",
    "remembered",
    "row_and_null_space",
]
