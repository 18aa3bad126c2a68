"""How likely it is that a limit is broken, in standard normal space: first order, importance and subset sampling.

Only numbers: which case a point is, and which limit a column, is for `running`.
"""

from gearwright.study.reliability.estimate import Estimate, Point, chance_beyond, index_of, interval_of
from gearwright.study.reliability.first_order import first_order
from gearwright.study.reliability.importance import importance
from gearwright.study.reliability.samples import from_samples
from gearwright.study.reliability.subset import subset

__all__ = [
    "Estimate",
    "Point",
    "chance_beyond",
    "first_order",
    "from_samples",
    "importance",
    "index_of",
    "interval_of",
    "subset",
]
