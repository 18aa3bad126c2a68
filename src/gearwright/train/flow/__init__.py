"""What a load case sends through a train: torques and powers with losses, by branch, and what circulates."""

from gearwright.train.flow.branches import Attachment, Branch, attachments, branches
from gearwright.train.flow.case import MeshFlow, PowerFlow, power_flow, power_flows
from gearwright.train.flow.recirculation import recirculation
from gearwright.train.flow.statics import Sharing, balance, lossy, solve_torques
from gearwright.train.flow.tooth_losses import turned
from gearwright.train.flow.turning import Turning, asked_speeds

__all__ = [
    "Attachment",
    "Branch",
    "MeshFlow",
    "PowerFlow",
    "Sharing",
    "Turning",
    "asked_speeds",
    "attachments",
    "balance",
    "branches",
    "lossy",
    "power_flow",
    "power_flows",
    "recirculation",
    "solve_torques",
    "turned",
]
