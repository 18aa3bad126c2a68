"""What a load case sends through a train: torques and powers with losses, by branch, and what circulates."""

from gearwright.train.flow.along import Loads, along, can_be_along
from gearwright.train.flow.branches import Attachment, Branch, attachments, branches
from gearwright.train.flow.carried import MeshFlow, PowerFlow, shaft_powers
from gearwright.train.flow.case import power_flow, power_flows
from gearwright.train.flow.efficiencies import Efficiency, efficiencies
from gearwright.train.flow.passes import passes
from gearwright.train.flow.recirculation import recirculation
from gearwright.train.flow.torques import Sharing, balance, solve_torques
from gearwright.train.flow.turning import Turning, asked_speeds

__all__ = [
    "Attachment",
    "Branch",
    "Efficiency",
    "Loads",
    "MeshFlow",
    "PowerFlow",
    "Sharing",
    "Turning",
    "along",
    "asked_speeds",
    "attachments",
    "balance",
    "branches",
    "can_be_along",
    "efficiencies",
    "passes",
    "power_flow",
    "power_flows",
    "recirculation",
    "shaft_powers",
    "solve_torques",
]
