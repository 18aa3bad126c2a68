"""Where shafts, gears and bearings stand: axes in the cross-section, places along the shafts, the box around them.

What loads them there is for `loads`.
"""

from gearwright.sizing.arrangement.arrange import arrange
from gearwright.sizing.arrangement.envelope import envelope
from gearwright.sizing.arrangement.hands import helix_hand
from gearwright.sizing.arrangement.roots import root_diameter
from gearwright.sizing.arrangement.seats import axial_forces

__all__ = ["arrange", "axial_forces", "envelope", "helix_hand", "root_diameter"]
