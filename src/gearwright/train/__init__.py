"""The power train: its graph, speeds, torques and powers, and the ratios asked of its stages."""

from gearwright.train.algebra import remembered
from gearwright.train.flow import (
    Attachment,
    Branch,
    Efficiency,
    MeshFlow,
    PowerFlow,
    Turning,
    attachments,
    branches,
    efficiencies,
    power_flow,
    power_flows,
    recirculation,
    shaft_powers,
)
from gearwright.train.graph import EXTERNAL, INTERNAL, Damper, Gear, Joint, Mesh, Train, build_train, gear_of, gears_of
from gearwright.train.kinematics import Edge, handed_on, members_of, teeth_of, ties_of, willis_ratio, willis_speed
from gearwright.train.ratios import Targets, speed_range, targets, tooth_ratio_range

__all__ = [
    "EXTERNAL",
    "INTERNAL",
    "Attachment",
    "Branch",
    "Damper",
    "Edge",
    "Efficiency",
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
    "efficiencies",
    "gear_of",
    "gears_of",
    "handed_on",
    "members_of",
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
