"""What every moment of a mission asks: phases cut into moments, forces of flight, trim of rotorcraft, thrust and power.

What supplies it is in `plant` and `strategies`; the flight that joins both in the room around it.
"""

from gearwright.mission.moments.course import Course, Moment
from gearwright.mission.moments.forces import Attitude, friction_of, lowest_speed, polar_of, resistance
from gearwright.mission.moments.path import Energy, Node, Path, Paths, speed_by_law
from gearwright.mission.moments.profile import Stretch, edges, laid_out, moments, phase_duration, ramped, stretches_of
from gearwright.mission.moments.thrust import (
    LARGEST_LIFT,
    SQUEEZED_ROUNDS,
    Blades,
    Performance,
    performed,
    thrust_at,
    wanted_of,
    windmilling,
)
from gearwright.mission.moments.trim import trimmed

__all__ = [
    "LARGEST_LIFT",
    "SQUEEZED_ROUNDS",
    "Attitude",
    "Blades",
    "Course",
    "Energy",
    "Moment",
    "Node",
    "Path",
    "Paths",
    "Performance",
    "Stretch",
    "edges",
    "friction_of",
    "laid_out",
    "lowest_speed",
    "moments",
    "performed",
    "phase_duration",
    "polar_of",
    "ramped",
    "resistance",
    "speed_by_law",
    "stretches_of",
    "thrust_at",
    "trimmed",
    "wanted_of",
    "windmilling",
]
