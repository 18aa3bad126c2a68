"""Trim of a helicopter: what its main rotor lifts and drags along, and the tail rotor that holds it straight."""

from __future__ import annotations

import math
from typing import NamedTuple

from gearwright.machines.rotor_power import Disc, Stream, induced_velocity, profile_power, rotor_power
from gearwright.units import GRAVITY

_STILL = 1.0
"""Forward speed over the induced velocity in hover beyond which the wake misses the fuselage [-]."""


class Airframe(NamedTuple):
    """What hangs below a rotor."""

    mass: float
    """[kg]"""
    flat_plate_area: float
    """f: drag of the fuselage over the dynamic pressure [m²]."""
    download: float
    """Of the wake on the fuselage in hover, over the weight [-]."""


class Lift(NamedTuple):
    """What a main rotor does, and where its power goes."""

    thrust: float
    """[N]"""
    loading: float
    """C_T/σ by the tip's speed [-]."""
    tilt: float
    """Of the thrust, forwards from upright [rad]."""
    induced_velocity: float
    """[m/s]"""
    induced: float
    """κ T v [W]."""
    profile: float
    """Drag of the blades [W]."""
    climb: float
    """m g V_c [W]."""
    parasite: float
    """Drag of the fuselage [W]."""
    gain: float
    """Of kinetic energy [W]."""

    @property
    def power(self) -> float:
        """Of the rotor's shaft [W]."""
        return (self.induced + self.profile) + (self.climb + self.parasite + self.gain)


class Antitorque(NamedTuple):
    """What a tail rotor does."""

    thrust: float
    """[N]"""
    power: float
    """[W]"""


def lift(disc: Disc, airframe: Airframe, stream: Stream, gain: float = 0.0) -> Lift:
    """Return what a main rotor does that carries and drags an airframe along.

    Args:
        disc: The rotor.
        airframe: What it carries.
        stream: How both move.
        gain: Of kinetic energy [W].

    Source: momentum and blade elements (`rotor_power`); m g V_c of height, ρ V³ f/2 of the fuselage (Leishman,
        chapter 5); thrust balances weight, download and drag.

    Valid for: steady flight without lift of the fuselage, blades that do not stall.

    Raises:
        DesignError: A descent into the rotor's own wake.
    """
    weight, forward = airframe.mass * GRAVITY, stream.forward
    hover = math.sqrt(weight / (2.0 * stream.density * disc.area))
    lifted = weight * (1.0 + airframe.download * max(1.0 - forward / (_STILL * hover), 0.0))
    drag = 0.5 * stream.density * airframe.flat_plate_area * forward**2
    thrust, tip = math.hypot(lifted, drag), 0.5 * stream.speed * disc.diameter
    velocity = induced_velocity(disc, stream, thrust)
    return Lift(
        thrust=thrust,
        loading=thrust / (stream.density * disc.area * tip**2 * disc.solidity),
        tilt=math.atan2(drag, lifted),
        induced_velocity=velocity,
        induced=disc.induced_factor * thrust * velocity,
        profile=profile_power(disc, stream),
        climb=weight * stream.climb,
        parasite=drag * forward,
        gain=gain,
    )


def antitorque(disc: Disc, stream: Stream, torque: float, arm: float) -> Antitorque:
    """Return what a tail rotor takes that balances the torque of the mast.

    Args:
        disc: The tail rotor.
        stream: How it moves; nothing across its disc.
        torque: Of the mast [N m].
        arm: From the mast to its shaft [m].

    Source: T l = Q; `rotor_power`.
    """
    thrust = abs(torque) / arm
    return Antitorque(thrust, rotor_power(disc, stream, thrust))
