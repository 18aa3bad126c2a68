"""Profile shifts of the gears as they are cut: one rule for contact, stiffness, losses and drawings."""

from __future__ import annotations

from gearwright.sizing.result import GearSizing
from gearwright.spec import Design

_SIGNS = {"pinion": 1.0, "sun": 1.0, "ring": 1.0, "wheel": -1.0, "planet": -1.0}


def profile_shift(design: Design, gear: GearSizing) -> float:
    """Return the profile shift coefficient x of a gear [-].

    Pinions and suns have the +x of their stage, what meshes with them −x, and a ring, whose planets have −x, +x again:
    the sum of every mesh is 0, so that no centre distance changes.

    Args:
        design: With the rules of the stage.
        gear: One of its gears.

    Source: ISO 21771:2007; internal gears count with negative numbers of teeth, so that x_1 + x_2 = 0 holds for them.
    """
    return _SIGNS[gear.role] * design.rules(gear.stage).profile_shift
