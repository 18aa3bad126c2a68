"""What users write: the design file, its types, its reader and its JSON Schema."""

from gearwright.spec.axis import Axis, axis_values, value_at
from gearwright.spec.design.design import (
    GROUND,
    Clutch,
    Design,
    Drive,
    GearRules,
    Motor,
    Pair,
    Planetary,
    Propeller,
    Turbine,
)
from gearwright.spec.edit import edited, edited_mission, path_problem
from gearwright.spec.lines import key_lines, line_of
from gearwright.spec.mission import (
    NO_MAP,
    BatteryRules,
    BearingLifeRules,
    Mission,
    Phase,
    engine_out,
    mission_problems,
    parse_mission,
    read_mission,
)
from gearwright.spec.read import file_text, parse, placed, read
from gearwright.spec.record import Record, build, keys_of, quantity_of
from gearwright.spec.schema import records, schema
from gearwright.spec.study import (
    MISSION_PATH,
    Flown,
    Simulated,
    Study,
    case_count,
    mission_changed,
    parse_study,
    read_study,
)
from gearwright.spec.windows import GovernorRules, WindowRules

__all__ = [
    "GROUND",
    "MISSION_PATH",
    "NO_MAP",
    "Axis",
    "BatteryRules",
    "BearingLifeRules",
    "Clutch",
    "Design",
    "Drive",
    "Flown",
    "GearRules",
    "GovernorRules",
    "Mission",
    "Motor",
    "Pair",
    "Phase",
    "Planetary",
    "Propeller",
    "Record",
    "Simulated",
    "Study",
    "Turbine",
    "WindowRules",
    "axis_values",
    "build",
    "case_count",
    "edited",
    "edited_mission",
    "engine_out",
    "file_text",
    "key_lines",
    "keys_of",
    "line_of",
    "mission_changed",
    "mission_problems",
    "parse",
    "parse_mission",
    "parse_study",
    "path_problem",
    "placed",
    "quantity_of",
    "read",
    "read_mission",
    "read_study",
    "records",
    "schema",
    "value_at",
]
