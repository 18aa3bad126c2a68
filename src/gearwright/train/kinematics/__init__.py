"""How a train turns: the speeds that its teeth give, and stages as ratios of speeds. What drives it is for `flow`."""

from gearwright.train.kinematics.edges import (
    Edge,
    asked_tooth_ratio,
    edge_of,
    given_tooth_ratio,
    members_of,
    willis_ratio,
    willis_speed,
)
from gearwright.train.kinematics.speeds import Yielded, motions_of, rows, solve_speeds
from gearwright.train.kinematics.ties import handed_on, teeth_of, ties_of

__all__ = [
    "Edge",
    "Yielded",
    "asked_tooth_ratio",
    "edge_of",
    "given_tooth_ratio",
    "handed_on",
    "members_of",
    "motions_of",
    "rows",
    "solve_speeds",
    "teeth_of",
    "ties_of",
    "willis_ratio",
    "willis_speed",
]
