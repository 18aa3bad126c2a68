"""Where shafts, gears and bearings stand: axes in the cross-section, places along the shafts, the box around them.

What loads them there is for `loads`.
"""

from gearwright.sizing.arrangement.arrange import NO_ANGLES, arrange, axles_in
from gearwright.sizing.arrangement.axle import Axle
from gearwright.sizing.arrangement.envelope import envelope
from gearwright.sizing.arrangement.hands import helix_hand
from gearwright.sizing.arrangement.layout import Moves
from gearwright.sizing.arrangement.ordering import Way, best_way
from gearwright.sizing.arrangement.seats import axial_forces
from gearwright.sizing.arrangement.sets import PLATE_GAP, set_length, slots

__all__ = [
    "NO_ANGLES",
    "PLATE_GAP",
    "Axle",
    "Moves",
    "Way",
    "arrange",
    "axial_forces",
    "axles_in",
    "best_way",
    "envelope",
    "helix_hand",
    "set_length",
    "slots",
]
