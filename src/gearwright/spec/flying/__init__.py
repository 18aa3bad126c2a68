"""Missions as files: what does not fit together in one, and their reader.

What a mission says is in `spec/missions/mission`; nothing here flies it.
"""

from gearwright.spec.flying.checks import MOST_INTERVALS, mission_problems
from gearwright.spec.flying.reading import is_map_file, map_problems, parse_mission, read_mission

__all__ = ["MOST_INTERVALS", "is_map_file", "map_problems", "mission_problems", "parse_mission", "read_mission"]
