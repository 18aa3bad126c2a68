"""Where shafts leave the housing, and the radial seal that each of these places gets, or why it gets none.

Covers and the places of seals in them are sized with what holds bearings, in the room of shafts.
"""

from gearwright.sizing.sealing.exits import LIP_WARMER, Exit, exits_of
from gearwright.sizing.sealing.leaving import NEAR, Leaving, leaving_of

__all__ = ["LIP_WARMER", "NEAR", "Exit", "Leaving", "exits_of", "leaving_of"]
