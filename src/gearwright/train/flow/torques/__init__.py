"""One balance of torques: its equations, how equal branches share, which way power runs, what teeth lose.

Load cases, their efficiencies and what circulates are in the room around it.
"""

from gearwright.train.flow.torques.lossy import Lossy, State, lossy, solve_lossless, solve_lossy
from gearwright.train.flow.torques.senses import Losing, states
from gearwright.train.flow.torques.sharing import Sharing, sharing_of
from gearwright.train.flow.torques.statics import Balance, balance, solve_torques, undecided
from gearwright.train.flow.torques.tooth_losses import Laws, lost, lost_parts

__all__ = [
    "Balance",
    "Laws",
    "Losing",
    "Lossy",
    "Sharing",
    "State",
    "balance",
    "lossy",
    "lost",
    "lost_parts",
    "sharing_of",
    "solve_lossless",
    "solve_lossy",
    "solve_torques",
    "states",
    "undecided",
]
