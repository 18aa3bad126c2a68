"""The shape of a propeller's blades, as given or made for an activity factor and a design lift."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.machines.chart_reading import Blades
from gearwright.machines.propellers.sections import SectionLoads, section_loads

Polar = Callable[[Floats, Floats, Floats, Floats], SectionLoads]

REFERENCE = 0.75
"""Radius ratio at which a blade angle is told [-]."""
HUB = 0.18
"""Radius ratio at which a generic blade begins [-]; an assumption."""
ELEMENTS = 24
"""Elements of a generic blade."""
TWIST_RATIO = 2.3650
"""Advance ratio whose helix a generic blade's twist follows [-]; fitted to the charts, see theory page."""
UNTWIST = 0.0982
"""Angle by which the tip is coarser than that helix says, per radius [rad]; fitted."""

WIDEST = 0.7336
"""Radius ratio at which a generic blade is widest [-]; fitted."""


class BladeShape(NamedTuple):
    """The blades of a propeller, element by element from the hub out."""

    number: int
    """Number of blades [-]."""
    radius: Floats
    """Middle of the elements over the tip radius [-]."""
    width: Floats
    """Of the elements over the tip radius [-]."""
    chord: Floats
    """Over the tip radius [-]."""
    twist: Floats
    """Blade angle less that at three quarters of the radius [rad]."""
    design_lift: Floats
    """Design lift coefficient of the sections [-]."""
    thickness: Floats
    """Over chord [-]."""
    hub: float = HUB
    """Radius ratio at which the blades begin [-]."""
    polar: Polar = section_loads
    """Lift and drag of the sections over angle [rad], design lift, thickness and Mach number."""
    losses: bool = True
    """Whether tip and hub lose lift (Prandtl)."""


def generic_blade(blades: Blades) -> BladeShape:
    """Return blades that nobody measured, with an activity factor and a design lift.

    Args:
        blades: Number, activity factor, design lift.

    Source: stated here: from 0.18 R, a chord that is widest at 0.73 R and rounds to the tip, scaled to the activity
        factor; twist of a helix of advance ratio 2.4, less 0.10 rad a radius; design lift constant along the blade;
        thickness ratio from 0.24 at the hub to 0.05 at the tip.
    """
    edges = np.linspace(HUB, 1.0, ELEMENTS + 1)
    radius, width = 0.5 * (edges[1:] + edges[:-1]), np.diff(edges)
    outline = np.sqrt(1.0 - np.clip((radius - WIDEST) / (1.02 - WIDEST), -0.8, 1.0) ** 2)
    shape = BladeShape(
        number=blades.number,
        radius=radius,
        width=width,
        chord=outline,
        twist=np.arctan(TWIST_RATIO / (math.pi * radius))
        - math.atan(TWIST_RATIO / (math.pi * REFERENCE))
        + UNTWIST * (radius - REFERENCE),
        design_lift=np.full(ELEMENTS, blades.design_lift / (1.0 - HUB**4)),
        thickness=0.05 + 0.19 * ((1.0 - radius) / (1.0 - HUB)) ** 2,
    )
    return shape._replace(chord=outline * blades.activity_factor / activity_factor(shape))


def activity_factor(shape: BladeShape) -> float:
    """Return the activity factor of one blade, 100 000/16 ∫ (c/D) x³ dx [-].

    Args:
        shape: The blades.

    Source: definition, as in NASA CR-114399.
    """
    return float(1e5 / 16.0 * np.sum(0.5 * shape.chord * shape.radius**3 * shape.width))


def integrated_lift(shape: BladeShape) -> float:
    """Return the integrated design lift coefficient of a blade, 4 ∫ c_l,i x³ dx [-].

    Args:
        shape: The blades.

    Source: definition, as in NASA CR-114399.
    """
    return float(4.0 * np.sum(shape.design_lift * shape.radius**3 * shape.width))
