"""Power of a rotor in hover, climb and forward flight: momentum of the stream, and profile drag of the blades."""

from __future__ import annotations

import math
from typing import NamedTuple

from gearwright.errors import DesignError, Problem

ROUNDS = 200
"""Most halvings for the induced velocity [-]."""
ADVANCE_DRAG = 4.65
"""K of 1 + K μ²: profile power of blades that advance and retreat [-]; Leishman, Principles of Helicopter
Aerodynamics, eq. 5.21."""
SETTLING = 0.5
"""Rate of descent over the induced velocity in hover beyond which a slow rotor meets its own wake [-]."""


class Disc(NamedTuple):
    """A rotor as an actuator disc with blades."""

    diameter: float
    """[m]"""
    solidity: float
    """σ, area of the blades over that of the disc [-]."""
    profile_drag: float
    """Mean c_d0 of the blades [-]."""
    induced_factor: float
    """κ over the ideal induced power [-]; below 1 in a duct."""

    @property
    def area(self) -> float:
        """Of the disc [m²]."""
        return 0.25 * math.pi * self.diameter**2


class Stream(NamedTuple):
    """How a rotor moves through the air."""

    density: float
    """[kg/m³]"""
    forward: float
    """In the plane of the disc [m/s]."""
    climb: float
    """Across it [m/s]."""
    speed: float
    """Of the rotor [rad/s]."""


def induced_velocity(disc: Disc, stream: Stream, thrust: float) -> float:
    """Return the velocity that a rotor gives the air in its disc [m/s].

    Args:
        disc: The rotor.
        stream: How it moves.
        thrust: [N].

    Source: Glauert: T = 2 ρ A v √(V² + (V_c + v)²).

    Valid for: hover, climb and forward flight; not for a slow steep descent, which is refused.

    Raises:
        DesignError: A slow descent in the rotor's own wake.

    >>> disc = Disc(10.0, 0.05, 0.01, 1.15)
    >>> round(induced_velocity(disc, Stream(1.225, 0.0, 0.0, 42.5), 17e3), 3)  # √(17 kN/(2 · 1.225 · 78.54))
    9.399
    """
    hover = math.sqrt(thrust / (2.0 * stream.density * disc.area))
    if -stream.climb > SETTLING * hover and stream.forward < 2.0 * hover:
        message = (
            f"sinks {-stream.climb:.3g} m/s at {stream.forward:.3g} m/s, into its own wake of {hover:.3g} m/s; at most"
            f" {SETTLING * hover:.3g} m/s below {2.0 * hover:.3g} m/s: sink slower, or fly faster"
        )
        raise DesignError([Problem("rate_of_climb", message)])
    low, high = 0.0, 2.0 * hover + abs(stream.climb)
    for _ in range(ROUNDS):
        middle = 0.5 * (low + high)
        through = middle * math.hypot(stream.forward, stream.climb + middle)
        low, high = (middle, high) if through < hover**2 else (low, middle)
        if high - low <= 1e-12 * hover:
            break
    return 0.5 * (low + high)


def rotor_power(disc: Disc, stream: Stream, thrust: float) -> float:
    """Return the power of a rotor's shaft for a thrust, without what climbs or holds a fuselage [W].

    Args:
        disc: The rotor.
        stream: How it moves.
        thrust: [N].

    Source: P = κ T v + ρ A V_t³ σ c_d0/8 (1 + 4.65 μ²); Leishman, chapters 2 and 5.

    Valid for: μ up to about 0.35, and blades that do not stall.
    """
    return disc.induced_factor * thrust * induced_velocity(disc, stream, thrust) + profile_power(disc, stream)


def profile_power(disc: Disc, stream: Stream) -> float:
    """Return what the drag of a rotor's blades takes [W].

    Args:
        disc: The rotor.
        stream: How it moves.

    Source: ρ A V_t³ σ c_d0/8 (1 + 4.65 μ²); Leishman, chapter 5.

    Valid for: μ up to about 0.35, and blades that do not stall.
    """
    tip = 0.5 * stream.speed * disc.diameter
    profile = stream.density * disc.area * tip**3 * disc.solidity * disc.profile_drag / 8.0
    advance = stream.forward / tip
    return profile * (1.0 + ADVANCE_DRAG * advance**2)
