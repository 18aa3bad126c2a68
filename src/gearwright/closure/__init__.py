"""Closure: a design becomes a gearbox that meets everything its checks know, every freedom written out for `review`.

What is checked and how is for the layers below: sizing, dynamics, mission. What is said of the result is for `reviews`.
"""

from gearwright.closure.arrange import Arranged, arrange, arranged_where_needed
from gearwright.closure.close import (
    Contradiction,
    OnMission,
    Source,
    Tried,
    Variant,
    Variants,
    as_sized,
    best_so_far,
    close,
    contradictions,
    nearest_variant,
)
from gearwright.closure.close_arranged import (
    BearingRound,
    ClosedArrangement,
    as_compared,
    close_arranged,
    closed_as_compared,
    has_open_sizes,
)
from gearwright.closure.eased import Eased, eased
from gearwright.closure.proportion import teeth_of
from gearwright.closure.requirements import (
    FREEDOMS,
    REQUIREMENTS,
    Closed,
    Course,
    Effort,
    Outcome,
    Requirement,
    Round,
    StageLife,
    Step,
    Unmet,
    Wishes,
    requirement_of,
)

__all__ = [
    "FREEDOMS",
    "REQUIREMENTS",
    "Arranged",
    "BearingRound",
    "Closed",
    "ClosedArrangement",
    "Contradiction",
    "Course",
    "Eased",
    "Effort",
    "OnMission",
    "Outcome",
    "Requirement",
    "Round",
    "Source",
    "StageLife",
    "Step",
    "Tried",
    "Unmet",
    "Variant",
    "Variants",
    "Wishes",
    "arrange",
    "arranged_where_needed",
    "as_compared",
    "as_sized",
    "best_so_far",
    "close",
    "close_arranged",
    "closed_as_compared",
    "contradictions",
    "eased",
    "has_open_sizes",
    "nearest_variant",
    "requirement_of",
    "teeth_of",
]
