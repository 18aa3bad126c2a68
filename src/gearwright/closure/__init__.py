"""Closure: a design becomes a gearbox that meets everything its checks know, every freedom written out for `review`.

What is checked and how is for the layers below: sizing, dynamics, mission. What is said of the result is for `reviews`.
"""

from gearwright.closure.against import Contradiction, contradictions
from gearwright.closure.as_sized import as_sized
from gearwright.closure.close import close
from gearwright.closure.closed import Closed, Outcome, Round, StageLife, Step, Unmet
from gearwright.closure.flown import OnMission
from gearwright.closure.freedoms import FREEDOMS
from gearwright.closure.proportion import teeth_of
from gearwright.closure.requirements import REQUIREMENTS, Requirement, requirement_of
from gearwright.closure.variants import Tried, Variant, Variants, nearest_variant
from gearwright.closure.wishes import Wishes

__all__ = [
    "FREEDOMS",
    "REQUIREMENTS",
    "Closed",
    "Contradiction",
    "OnMission",
    "Outcome",
    "Requirement",
    "Round",
    "StageLife",
    "Step",
    "Tried",
    "Unmet",
    "Variant",
    "Variants",
    "Wishes",
    "as_sized",
    "close",
    "contradictions",
    "nearest_variant",
    "requirement_of",
    "teeth_of",
]
