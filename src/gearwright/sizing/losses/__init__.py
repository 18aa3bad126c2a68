"""Power lost in a sized gearbox by origin: teeth, bearings, gears in mist or oil, seals; by formulas of one's choice.

The formulas are `parts.losses`'s; what losses do to the torques of a case is `train.flow`'s.
"""

from gearwright.sizing.losses.balance import ORIGINS, Loss, LossBalance, largest_heat, loss_balance, lost_power
from gearwright.sizing.losses.bodies import BodyLoss, gear_losses, seal_losses
from gearwright.sizing.losses.oil import UNTOLD, Flank, Oil, dipping, oil_of_design
from gearwright.sizing.losses.seats import SeatLoss, bearing_losses
from gearwright.sizing.losses.teeth import Teeth, mesh_loss_parts, teeth_of

__all__ = [
    "ORIGINS",
    "UNTOLD",
    "BodyLoss",
    "Flank",
    "Loss",
    "LossBalance",
    "Oil",
    "SeatLoss",
    "Teeth",
    "bearing_losses",
    "dipping",
    "gear_losses",
    "largest_heat",
    "loss_balance",
    "lost_power",
    "mesh_loss_parts",
    "oil_of_design",
    "seal_losses",
    "teeth_of",
]
