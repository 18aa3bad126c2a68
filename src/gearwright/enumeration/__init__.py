"""Architectures: every train of a few stages that can serve a requirement, sized, ranked, the best closed for one life.

How one given design is sized, closed or judged is for the layers below; pages and commands are above.
"""

from gearwright.enumeration.ranking import CLOSED, STAGES, Candidate, Effort, Ranking, architectures
from gearwright.enumeration.trains import KINDS, Architecture, Kind, Place, Requirement, Seat, requirement_of, trains

__all__ = [
    "CLOSED",
    "KINDS",
    "STAGES",
    "Architecture",
    "Candidate",
    "Effort",
    "Kind",
    "Place",
    "Ranking",
    "Requirement",
    "Seat",
    "architectures",
    "requirement_of",
    "trains",
]
