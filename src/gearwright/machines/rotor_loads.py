"""Loads of helicopter rotors on their masts: thrust by load factor, hub moment by the kind of hub, H-force.

Every function takes numbers or arrays of cases, and returns the like.
"""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from gearwright.base import Floats

HOVER_SHARE = 0.7 ** (2.0 / 3.0)
"""Thrust of a hovering rotor over that of an ideal disc [-]: figure of merit 0.7."""
HUBS = {"teetering": 0.01, "articulated": 0.03, "hingeless": 0.06}
"""Kind of hub -> hub moment of usual flight over thrust times radius [-]; estimates. Articulated: hinges at 4 % of the
radius; teetering: the spring of the flapping hinge alone."""
LIMIT_MOMENT = 2.0
"""Hub moment as a limit load over that of usual flight [-], an estimate."""
ACROSS = 0.1
"""H-force over thrust [-], an estimate."""
LIMIT_FACTOR = 3.5
"""Thrust over weight as a limit load [-]; CS-27.337 and CS-29.337."""
USUAL_FACTOR, TIRING_FACTOR = 1.0, 1.2
"""Thrust over weight in usual flight, and in the manoeuvres that the mast bears without end [-]."""
TORQUE_LIMIT = 1.25
"""Limit torque over the mean, of turbines [-]; CS-27.361 and CS-29.361."""
TAIL_SHARE, TAIL_PEAK = 0.10, 0.25
"""Power of a tail rotor over the engine's in hover, and at its peak in a yaw manoeuvre [-]; estimates."""
Hub = Literal["teetering", "articulated", "hingeless"]


def hub_moment(
    blades: ArrayLike, blade_moment: ArrayLike, offset: ArrayLike, *, speed: ArrayLike, flapping: ArrayLike
) -> Floats:
    """Return the moment with which flapping blades bend the mast of an articulated rotor [N m].

    Args:
        blades: How many [-].
        blade_moment: First moment of mass of one about its flapping hinge [kg m].
        offset: Of the hinge from the axis [m].
        speed: [rad/s].
        flapping: First harmonic of the flapping angle against the mast [rad].

    Source: M = (B/2) m_β e Ω² β₁; Leishman, Principles of Helicopter Aerodynamics, ch. 4.

    >>> round(float(hub_moment(3, 30.0, 0.2, speed=42.5, flapping=0.02)))
    325
    """
    count, mass, arm, turning, angle = (
        np.asarray(one, float) for one in (blades, blade_moment, offset, speed, flapping)
    )
    return np.asarray(0.5 * count * mass * arm * turning**2 * angle)


def usual_hub_moment(hub: Hub, thrust: ArrayLike, diameter: ArrayLike) -> Floats:
    """Return the hub moment of usual flight where nothing of the blades is known [N m].

    Args:
        hub: Its kind.
        thrust: [N].
        diameter: [m].

    Source: 0.01, 0.03 and 0.06 T R of teetering, articulated and hingeless hubs; estimates.

    >>> round(float(usual_hub_moment("articulated", 18.5e3, 10.0)))  # the EC120B's, which assumes 1400
    2775
    """
    return np.asarray(HUBS[hub] * np.asarray(thrust, float) * 0.5 * np.asarray(diameter, float))


def tail_thrust_rise(share: float = TAIL_SHARE, peak: float = TAIL_PEAK) -> float:
    """Return the thrust of a tail rotor at its peak over that in hover [-].

    Args:
        share: Power in hover over the engine's [-].
        peak: Power at its peak over the engine's [-].

    Source: momentum theory, T ~ P^(2/3).

    >>> round(tail_thrust_rise(), 2)
    1.84
    """
    return float((peak / share) ** (2.0 / 3.0))
