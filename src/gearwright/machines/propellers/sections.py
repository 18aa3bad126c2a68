"""Lift and drag of a propeller's section at every angle of attack, with camber, thickness and Mach number."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats

LIFT_SLOPE = 0.8147 * 2.0 * math.pi
"""Of a section on a turning blade, part of a thin aerofoil's [1/rad]; fitted to the charts, see the theory page."""
CAMBER_EFFECT = 0.7988
"""Part of its design lift that a section has at no incidence [-]; fitted."""
MOST_LIFT, LEAST_LIFT, CAMBER_STALL = 1.3669, -0.6792, 0.3
"""Lift coefficients of a symmetric section at its stalls, and what a unit of design lift adds to both [-]; fitted."""
STALL_WIDTHS = (0.0070, 0.0369)
"""Angle over which attached flow parts, at the upper and the lower stall [rad]; fitted."""
PLATE_DRAG = 1.25
"""Drag coefficient of a blade across the stream [-]: Viterna's 1.11 + 0.018 A for an aspect ratio A of 8."""
FRICTION = 0.0033
"""Coefficient of skin friction [-]; fitted."""
POLAR = (0.1939, 0.3691)
"""Drag per square of the lift beyond the bucket of least drag, above it and below [-]; fitted."""
LEAST_DRAG = 0.8725
"""Part of its design lift in the middle of that bucket [-]; fitted."""
BUCKET = 0.1480
"""Half the width of the bucket of least drag, as a lift coefficient [-]; fitted."""
PARTED_DRAG = 0.0052
"""Drag that parted flow adds to that of the plate [-]; fitted."""
HIGHEST_MACH = 0.80
"""Where the Prandtl-Glauert factor is held [-]."""
KORN = 0.87
"""Technology factor of Korn's drag divergence, for sections of NACA's 6 series [-]."""
SHEAR_RISE = 20.0
"""Lock's factor of the drag rise [-]."""
_FARTHEST = 60.0
"""Stall widths beyond which flow has parted wholly [-]."""


class SectionLoads(NamedTuple):
    """What the air does to a section."""

    lift: Floats
    """c_l [-]."""
    drag: Floats
    """c_d [-]."""


def section_loads(angle: Floats, design_lift: Floats, thickness: Floats, mach: Floats) -> SectionLoads:
    """Return lift and drag of propeller sections from −180° to 180°.

    Args:
        angle: Of attack, from the chord [rad].
        design_lift: Lift coefficient that the camber is made for [-].
        thickness: Over chord [-].
        mach: Of the section's stream [-].

    Source: attached: a straight lift curve with Prandtl-Glauert, friction and form after Hoerner (1965), 2 c_f
        (1 + 2 t/c + 60 (t/c)⁴), drag rise 20 (M − M_crit)⁴ after Lock with Korn's divergence; parted: Viterna and
        Corrigan (1982), NASA CP-2230. The constants called fitted are fitted to the charts of NASA CR-114399.

    Valid for: blades of several metres.
    """
    squeeze = 1.0 / np.sqrt(1.0 - np.minimum(mach, HIGHEST_MACH) ** 2)
    free = LIFT_SLOPE * np.sin(angle) + CAMBER_EFFECT * design_lift
    upper, lower = (stall + CAMBER_STALL * design_lift for stall in (MOST_LIFT, LEAST_LIFT))
    above, below = (
        (lift / squeeze - CAMBER_EFFECT * design_lift) / LIFT_SLOPE for lift in (upper, lower)
    )  # angles of the stalls
    beyond = np.exp(np.minimum((angle - above) / STALL_WIDTHS[0], _FARTHEST))
    short = np.exp(np.minimum((below - angle) / STALL_WIDTHS[1], _FARTHEST))
    attached = 1.0 / (1.0 + beyond + short)
    parted = beyond * _parted_lift(angle, above, upper) - short * _parted_lift(-angle, -below, -lower)
    offset = free - LEAST_DRAG * design_lift
    distance = np.maximum(np.abs(offset) - BUCKET, 0.0)
    profile = 2.0 * FRICTION * (1.0 + 2.0 * thickness + 60.0 * thickness**4)
    profile = profile + np.where(offset > 0.0, *POLAR) * distance**2 + _drag_rise(squeeze * free, thickness, mach)
    plate = PARTED_DRAG + PLATE_DRAG * np.sin(angle) ** 2
    return SectionLoads(
        lift=attached * (squeeze * free + parted),
        drag=attached * profile + attached * (beyond + short) * plate,
    )


def _parted_lift(angle: Floats, stall: Floats, lift: Floats) -> Floats:
    """Return Viterna's lift beyond a stall; the term that joins it to the stall ends at 90°."""
    share = (lift - PLATE_DRAG * np.sin(stall) * np.cos(stall)) * np.sin(stall) / np.cos(stall) ** 2
    along, across = np.maximum(np.cos(angle), 0.0), np.maximum(np.sin(angle), 0.5 * np.sin(stall))
    return np.asarray(0.5 * PLATE_DRAG * np.sin(2.0 * angle) + share * along**2 / across)


def _drag_rise(lift: Floats, thickness: Floats, mach: Floats) -> Floats:
    """Return 20 (M − M_crit)⁴ with M_crit = κ − t/c − |c_l|/10 − (0.1/80)^(1/3)."""
    critical = KORN - thickness - np.abs(lift) / 10.0 - (0.1 / 80.0) ** (1.0 / 3.0)
    return np.asarray(SHEAR_RISE * np.maximum(mach - critical, 0.0) ** 4)
