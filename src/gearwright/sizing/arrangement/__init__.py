"""Where shafts, gears and bearings stand: axes in the cross-section, places along the shafts, the box around them.

What loads them there is for `loads`.
"""

from gearwright.sizing.arrangement.arrange import NO_ANGLES, arrange
from gearwright.sizing.arrangement.envelope import envelope
from gearwright.sizing.arrangement.hands import helix_hand
from gearwright.sizing.arrangement.layout import Moves
from gearwright.sizing.arrangement.roots import root_diameter
from gearwright.sizing.arrangement.seats import axial_forces

__all__ = ["NO_ANGLES", "Moves", "arrange", "axial_forces", "envelope", "helix_hand", "root_diameter"]
