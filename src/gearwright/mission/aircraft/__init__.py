"""A point mass on its path: phases that an aircraft flies become the intervals of a mission.

What a thrust needs in power, and what that costs, is the flight's; nothing here knows gears.
"""

from gearwright.mission.aircraft.account import PhaseForces, phase_forces
from gearwright.mission.aircraft.paths import paths_of

__all__ = ["PhaseForces", "paths_of", "phase_forces"]
