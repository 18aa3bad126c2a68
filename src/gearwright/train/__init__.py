"""The power train: its graph, speeds, torques and powers, and the ratios asked of its stages."""

from gearwright.train.algebra import remembered
from gearwright.train.balance import STANDSTILL, Turn, Turning, asked_speeds, holding
from gearwright.train.efficiency import Efficiency, efficiencies
from gearwright.train.graph import EXTERNAL, INTERNAL, Damper, Gear, Joint, Mesh, Train, build_train, gear_of, gears_of
from gearwright.train.kinematics import Edge, handed_on, members_of, teeth_of, ties_of, willis_ratio, willis_speed
from gearwright.train.load_case import (
    Loads,
    along,
    can_be_along,
    is_slight,
    left_alone,
    overruns,
    power_flow,
    power_flows,
)
from gearwright.train.power_flow import (
    Attachment,
    Branch,
    MeshFlow,
    PowerFlow,
    attachments,
    branches,
    passes,
    recirculation,
    shaft_powers,
)
from gearwright.train.ratios import Targets, speed_range, targets, tooth_ratio_range

__all__ = [
    "EXTERNAL",
    "INTERNAL",
    "STANDSTILL",
    "Attachment",
    "Branch",
    "Damper",
    "Edge",
    "Efficiency",
    "Gear",
    "Joint",
    "Loads",
    "Mesh",
    "MeshFlow",
    "PowerFlow",
    "Targets",
    "Train",
    "Turn",
    "Turning",
    "along",
    "asked_speeds",
    "attachments",
    "branches",
    "build_train",
    "can_be_along",
    "efficiencies",
    "gear_of",
    "gears_of",
    "handed_on",
    "holding",
    "is_slight",
    "left_alone",
    "members_of",
    "overruns",
    "passes",
    "power_flow",
    "power_flows",
    "recirculation",
    "remembered",
    "shaft_powers",
    "speed_range",
    "targets",
    "teeth_of",
    "ties_of",
    "tooth_ratio_range",
    "willis_ratio",
    "willis_speed",
]
