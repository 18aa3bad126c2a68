"""How turbines and motors divide power by named rules, and the share that burns least.

A rule answers interval by interval; the optimal share is planned over all of them before they are flown.
"""

from gearwright.mission.strategies.plan import Plan, Stage, optimal_plan
from gearwright.mission.strategies.planned import has_plan, planned_shares
from gearwright.mission.strategies.rules import Demand, driven, electric_share
from gearwright.mission.strategies.shares import AGREED, Then, shared

__all__ = [
    "AGREED",
    "Demand",
    "Plan",
    "Stage",
    "Then",
    "driven",
    "electric_share",
    "has_plan",
    "optimal_plan",
    "planned_shares",
    "shared",
]
