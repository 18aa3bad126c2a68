"""The power train: its graph, speeds, torques and powers, and the ratios asked of its stages."""

from gearwright.train.branches import Attachment, Branch, attachments, branches
from gearwright.train.edges import Edge, members_of, willis_ratio, willis_speed
from gearwright.train.flow import MeshFlow, PowerFlow, power_flow, power_flows
from gearwright.train.graph import Damper, Joint, Train, build_train, gear_of, gears_of
from gearwright.train.memory import remembered
from gearwright.train.ranges import speed_range, tooth_ratio_range
from gearwright.train.recirculation import recirculation
from gearwright.train.targets import Targets, targets
from gearwright.train.ties import handed_on, teeth_of, ties_of
from gearwright.train.toothed import EXTERNAL, INTERNAL, Gear, Mesh
from gearwright.train.turning import Turning

__all__ = [
    "EXTERNAL",
    "INTERNAL",
    "Attachment",
    "Branch",
    "Damper",
    "Edge",
    "Gear",
    "Joint",
    "Mesh",
    "MeshFlow",
    "PowerFlow",
    "Targets",
    "Train",
    "Turning",
    "attachments",
    "branches",
    "build_train",
    "gear_of",
    "gears_of",
    "handed_on",
    "members_of",
    "power_flow",
    "power_flows",
    "recirculation",
    "remembered",
    "speed_range",
    "targets",
    "teeth_of",
    "ties_of",
    "tooth_ratio_range",
    "willis_ratio",
    "willis_speed",
]
