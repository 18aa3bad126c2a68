"""A mission flown by a sized gearbox: Mission x Sizing becomes a Flight."""

from gearwright.mission.flight import Balance, Flight, PhaseSummary, phase_summaries
from gearwright.mission.fly import fly

__all__ = ["Balance", "Flight", "PhaseSummary", "fly", "phase_summaries"]
