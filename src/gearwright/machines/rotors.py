"""Power and trim of helicopter rotors in hover, climb and forward flight, and inertia of rotors."""

from __future__ import annotations

import math
from typing import NamedTuple

from gearwright.base import GRAVITY, DesignError, Problem

# ----------------------------------------------------------------------------------------------------------------------
# Power of a rotor in hover, climb and forward flight: momentum of the stream, and profile drag of the blades.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Trim of a helicopter: what its main rotor lifts and drags along, and the tail rotor that holds it straight.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Inertia estimates of the rotors at the ends of a train, for designs that do not give them.
# ----------------------------------------------------------------------------------------------------------------------


RIM_SPEED = 350.0
"""Rim speed that sets a power turbine's diameter where none is given [m/s]; an assumption."""
DISC_THICKNESS_RATIO = 0.05
DISC_DENSITY = 8200.0
"""Nickel alloy [kg/m³]."""
BLADE_CHORD_RATIO = 0.08
"""Mean chord over propeller diameter, as of an activity factor near 110."""
BLADE_THICKNESS_RATIO = 0.06
BLADE_FILL = 0.7
"""Section area over chord times thickness."""
BLADE_DENSITY = 1500.0
"""Mean density of a composite blade [kg/m³]."""


def turbine_diameter(speed: float) -> float:
    """Return the disc diameter of a power turbine [m].

    Args:
        speed: Rated speed [rad/s].

    Source: rim speed of 350 m/s; an estimate.
    """
    return 2.0 * RIM_SPEED / speed


def turbine_inertia(diameter: float) -> float:
    """Return the polar inertia of a power turbine's disc [kg m²].

    Args:
        diameter: Disc diameter [m].

    Source: solid nickel disc, thickness 5 % of the diameter, m d²/8 (Pulvirenti 2023, appendix, prints 0.5 m d²).
    """
    mass = math.pi / 4.0 * diameter**2 * DISC_THICKNESS_RATIO * diameter * DISC_DENSITY
    return mass * diameter**2 / 8.0


def blade_mass(diameter: float) -> float:
    """Return the mass of one blade of a propeller [kg].

    Args:
        diameter: Of the propeller [m].

    Source: uniform composite bar; an estimate.

    >>> round(blade_mass(3.93), 2)
    12.24
    """
    section = BLADE_FILL * BLADE_CHORD_RATIO * BLADE_THICKNESS_RATIO * BLADE_CHORD_RATIO * diameter**2
    return section * diameter / 2.0 * BLADE_DENSITY


def propeller_inertia(diameter: float, blades: int) -> float:
    """Return the polar inertia of a propeller [kg m²].

    Args:
        diameter: [m].
        blades: Number of blades [-].

    Source: uniform composite bars, B m R²/3; an estimate (12 kg a blade at 3.93 m).

    >>> round(propeller_inertia(3.93, 6), 1)  # 6 · 12.24 kg · (1.965 m)² / 3
    94.5
    """
    return blades * blade_mass(diameter) * (diameter / 2.0) ** 2 / 3.0
