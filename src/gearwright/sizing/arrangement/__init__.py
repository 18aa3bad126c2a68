"""Where shafts, gears and bearings stand: axes in the cross-section, places along the shafts, the box around them.

What loads them there is for `loads`.
"""

from gearwright.sizing.arrangement.axes import axes_of
from gearwright.sizing.arrangement.envelope import envelope
from gearwright.sizing.arrangement.hands import helix_hand
from gearwright.sizing.arrangement.layout import ShaftPlan, plan_of
from gearwright.sizing.arrangement.roots import root_diameter
from gearwright.sizing.arrangement.seats import axial_forces, seats_of

__all__ = ["ShaftPlan", "axes_of", "axial_forces", "envelope", "helix_hand", "plan_of", "root_diameter", "seats_of"]
