"""Architectures: every train of a few stages that can serve a requirement, sized, ranked, the best closed for one life.

How one given design is sized, closed or judged is for the layers below; pages and commands are above.
"""

from gearwright.enumeration.kinds import KINDS, Kind
from gearwright.enumeration.ranked import CLOSED, STAGES, Ranking, architectures, lighter
from gearwright.enumeration.ranking import Candidate
from gearwright.enumeration.requirement import Requirement, requirement_of
from gearwright.enumeration.trains import Architecture, Place, Seat, trains

__all__ = [
    "CLOSED",
    "KINDS",
    "STAGES",
    "Architecture",
    "Candidate",
    "Kind",
    "Place",
    "Ranking",
    "Requirement",
    "Seat",
    "architectures",
    "lighter",
    "requirement_of",
    "trains",
]
