"""What the air does to an aircraft: a parabolic drag polar, and the speed below which no wing bears."""

from __future__ import annotations

import math
from typing import NamedTuple

from gearwright.air.atmosphere import Air


class Polar(NamedTuple):
    """A parabolic drag polar C_D = C_D0 + k C_L²."""

    area: float
    """Reference area S [m²]."""
    zero_lift: float
    """C_D0, with flaps and gear [-]."""
    induced: float
    """k [-]."""


def dynamic_force(polar: Polar, air: Air, speed: float) -> float:
    """Return what a coefficient of 1 bears, q S [N].

    Args:
        polar: With the area.
        air: Where it is flown.
        speed: True airspeed [m/s].

    Source: definition of the coefficients: q = ρ V²/2.
    """
    return 0.5 * air.density * speed**2 * polar.area


def drag_force(polar: Polar, reference: float, lift: float) -> float:
    """Return the drag of a lift [N].

    Args:
        polar: Of the aircraft.
        reference: q S [N]; 0 at rest, where nothing lifts.
        lift: [N].

    Source: D = q S (C_D0 + k C_L²).

    >>> round(drag_force(Polar(27.308, 0.022, 0.0464), 100e3, 40e3))  # 100 kN · (0.022 + 0.0464 · 0.4²)
    2942
    """
    lifts = reference != 0.0  # no branch, so that arrays pass
    return reference * polar.zero_lift + polar.induced * (lifts * lift) ** 2 / (reference + (1.0 - lifts))


def stall_speed(polar: Polar, air: Air, weight: float, highest: float) -> float:
    """Return the true airspeed at which the wing just bears a weight [m/s].

    Args:
        polar: With the area.
        air: Where it is flown.
        weight: [N].
        highest: C_L at the stall [-].

    Source: m g = ρ V²/2 S C_Lmax.
    """
    return math.sqrt(2.0 * weight / (air.density * polar.area * highest))
