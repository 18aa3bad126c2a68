"""Loads of propellers on their shafts: thrust, once-per-turn moment and side force, gyroscopic moment, weight.

Every function takes numbers or arrays of cases, and returns the like.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from gearwright.base import Floats

# ----------------------------------------------------------------------------------------------------------------------
# Thrust by the power: of a propeller at rest against the actuator disc's, in flight by its efficiency.
# ----------------------------------------------------------------------------------------------------------------------


SEA_LEVEL = 1.225
"""Density of air [kg/m³]."""
STATIC_SHARE = 0.72
"""Static thrust over that of an ideal actuator disc [-]: figure of merit 0.61 to the power of 2/3."""


def static_thrust(
    power: ArrayLike, diameter: ArrayLike, *, density: ArrayLike = SEA_LEVEL, share: ArrayLike = STATIC_SHARE
) -> Floats:
    """Return the thrust of a propeller or a rotor at rest [N].

    Args:
        power: At its shaft [W].
        diameter: [m].
        density: Of the air [kg/m³].
        share: Of the ideal thrust, M^(2/3) of a figure of merit M [-].

    Source: momentum theory: T = M^(2/3) (2 ρ A P²)^(1/3).

    >>> round(float(static_thrust(2051e3, 3.93)) / 1e3, 1)
    36.0
    """
    area = 0.25 * math.pi * np.asarray(diameter, float) ** 2
    ideal = np.cbrt(2.0 * np.asarray(density, float) * area * np.asarray(power, float) ** 2)
    return np.asarray(share * ideal)


def disc_velocity(power: ArrayLike, diameter: ArrayLike, *, density: ArrayLike = SEA_LEVEL) -> Floats:
    """Return the velocity that scales a propeller's flight speeds [m/s].

    Args:
        power: At its shaft [W].
        diameter: [m].
        density: Of the air [kg/m³].

    Source: velocity induced by an ideal disc at rest: (P/(2 ρ A))^(1/3).

    >>> round(float(disc_velocity(2051e3, 3.93)), 1)
    41.0
    """
    area = 0.25 * math.pi * np.asarray(diameter, float) ** 2
    return np.asarray(np.cbrt(np.asarray(power, float) / (2.0 * np.asarray(density, float) * area)))


def flight_thrust(power: ArrayLike, airspeed: ArrayLike, efficiency: ArrayLike) -> Floats:
    """Return the thrust of a propeller in flight [N].

    Args:
        power: At its shaft [W].
        airspeed: [m/s].
        efficiency: T V/P [-].

    Source: T = η P/V.

    >>> round(float(flight_thrust(2051e3, 87.5, 0.8)) / 1e3, 2)
    18.75
    """
    return np.asarray(np.asarray(efficiency, float) * np.asarray(power, float) / np.asarray(airspeed, float))


# ----------------------------------------------------------------------------------------------------------------------
# Incidence of the propeller's axis: moment and side force once per turn (1P).
#
# A blade at azimuth ψ sees w sin ψ more in the disc's plane, w = V sin α, and bears dL = ρ c (c_l U + a V/2) w sin ψ dr
# more. Of three blades or more the sum does not pulsate: a moment M about the axis across the stream, and a force Y in
# the disc's plane that stands in space, so that they bend the turning shaft once a turn. Chord and lift coefficient are
# constant along the blade; U = Ω r, tan φ = V/U. With x = r/R and λ = V/(Ω R) the integrals are closed:
# ∫x³/s = s³/3 − λ² s, ∫x²/s = (x s − λ² ln(x + s))/2, ∫x/s = s, ∫1/s = ln(x + s), ∫x s = s³/3, s = √(x² + λ²).
# ----------------------------------------------------------------------------------------------------------------------


FIN_RATIO = 8.0
"""Aspect ratio of the fin that a yawed propeller acts like [-]; Ribner 1943, NACA Report 819."""
FIN_SLOPE = 2.0 * math.pi * FIN_RATIO / (FIN_RATIO + 2.0)
"""Lift over angle of that fin [1/rad]."""
SOLIDITY = 0.15
"""Area of the blades over the disc's, of turboprops with six blades [-]; an estimate."""
ROOT = 0.25
"""Radius from which blades bear lift over the tip's [-]."""


class OncePerTurn(NamedTuple):
    """What incidence puts on a propeller's shaft."""

    moment: Floats
    """M_1P at the hub, which bends the shaft once a turn [N m]."""
    force: Floats
    """Y in the plane of the disc [N]."""
    lift_coefficient: Floats
    """c_l of the blades that gives the thrust [-]."""


def once_per_turn(
    thrust: ArrayLike,
    airspeed: ArrayLike,
    incidence: ArrayLike,
    *,
    diameter: ArrayLike,
    speed: ArrayLike,
    solidity: ArrayLike = SOLIDITY,
    density: ArrayLike = SEA_LEVEL,
) -> OncePerTurn:
    """Return the steady moment and side force of a propeller of three blades or more at incidence.

    Args:
        thrust: [N].
        airspeed: V [m/s].
        incidence: α between the stream and the axis [rad].
        diameter: [m].
        speed: Ω [rad/s].
        solidity: σ, blades over disc [-]; c = σ π R/B.
        density: Of the air [kg/m³].

    Source: blade elements with the lift slope of Ribner's fin, 2π · 8/(8 + 2) (NACA Reports 819 and 820, 1945).

    Valid for: incidence to about 20°; no upwash of a wing; within 30 %, an estimate.

    >>> found = once_per_turn(18752.0, 87.5, math.radians(6.0), diameter=3.93, speed=1212 * math.pi / 30)
    >>> round(float(found.moment)), round(float(found.force)), round(float(found.lift_coefficient), 2)
    (2865, 1281, 0.73)
    """
    pull, flow, angle, across, omega, filled, air = (
        np.asarray(one, float) for one in (thrust, airspeed, incidence, diameter, speed, solidity, density)
    )
    radius = 0.5 * across
    tip, chords = omega * radius, filled * math.pi * radius  # Ω R, and B c
    inflow = flow / tip
    outer, inner = np.hypot(1.0, inflow), np.hypot(ROOT, inflow)
    cubes, roots = (outer**3 - inner**3) / 3.0, outer - inner
    logs = np.log((1.0 + outer) / (ROOT + inner))
    lift = pull / (0.5 * air * chords * tip**2 * radius * cubes)
    turning, sliding = lift * tip, 0.5 * FIN_SLOPE * flow
    common = 0.5 * air * chords * flow * np.sin(angle) * radius
    squares = 0.5 * (outer - ROOT * inner - inflow**2 * logs)
    moment = common * radius * (turning * (cubes - inflow**2 * roots) + sliding * squares)
    force = common * inflow * (turning * roots + sliding * logs)
    return OncePerTurn(np.abs(moment), np.abs(force), lift)


EXCITATION_SPEED = 348.0 * 1852.0 / 3600.0
"""Equivalent airspeed at which an excitation factor is the incidence in degrees [m/s]: 348 knots."""
FATIGUE_FACTOR = 3.0
"""Excitation factor that the shaft bears without end [-]; 4.5 is an envelope of commuter aircraft."""
STEEPEST = math.radians(20.0)
"""Largest incidence that a factor is turned into [rad]: blades stall beyond it."""


def excitation_factor(incidence: ArrayLike, airspeed: ArrayLike) -> Floats:
    """Return the excitation factor EF of a propeller [-].

    Args:
        incidence: [rad].
        airspeed: Equivalent airspeed [m/s].

    Source: Hamilton Standard: EF = α[°] (V_EAS/348 kt)²; α q of an aircraft hardly changes with its speed.

    >>> round(float(excitation_factor(math.radians(6.0), 87.5)), 2)
    1.43
    """
    return np.asarray(np.degrees(incidence) * (np.asarray(airspeed, float) / EXCITATION_SPEED) ** 2)


def incidence_of(factor: ArrayLike, airspeed: ArrayLike) -> Floats:
    """Return the incidence of an excitation factor, at most `STEEPEST` [rad].

    Args:
        factor: EF [-].
        airspeed: Equivalent airspeed [m/s].

    >>> round(math.degrees(float(incidence_of(3.0, 87.5))), 1)
    12.6
    """
    angle = np.radians(np.asarray(factor, float) * (EXCITATION_SPEED / np.asarray(airspeed, float)) ** 2)
    return np.asarray(np.minimum(angle, STEEPEST))


# ----------------------------------------------------------------------------------------------------------------------
# Loads by mass: gyroscopic moment of a turning propeller that is turned, its weight; torque peaks.
# ----------------------------------------------------------------------------------------------------------------------


TURNING = {"cs25": (0.3, 0.3), "cs23": (1.0, 2.5)}
"""Certification -> pitch and yaw rate of limit manoeuvres [rad/s]: CS-25.371, whose manoeuvres reach about 0.3 (an
estimate), and CS-23.371 before amendment 5, with its text."""
WITH_TURNING = 2.5
"""Load factor beside these rates [-]; CS-23.371."""
LIMIT_FACTOR = 3.5
"""Load factor of weight as a limit load [-]."""
TORQUE_LIMIT, TORQUE_STOP = 1.25, 1.6
"""Limit torque of turboprops over the mean, and that of a sudden stop or a malfunction [-]; CS-25.361."""
ULTIMATE = 1.5
"""Ultimate over limit load [-]; CS-25.303, CS-29.303."""


def gyroscopic_moment(inertia: ArrayLike, speed: ArrayLike, rate: ArrayLike) -> Floats:
    """Return the moment with which a turning propeller resists being turned [N m].

    Args:
        inertia: Polar inertia [kg m²].
        speed: Ω [rad/s].
        rate: Of pitch or yaw across its axis [rad/s].

    Source: M = I Ω ω; of three blades or more, else it pulsates to twice that.

    >>> round(float(gyroscopic_moment(46.8, 1212 * math.pi / 30, 2.5)) / 1e3, 1)
    14.8
    """
    return np.asarray(np.asarray(inertia, float) * np.abs(speed) * np.abs(rate))


GYRATION = 0.38
"""Radius of gyration of a composite blade over the propeller's radius [-], an estimate."""
BLADES_SHARE = 0.5
"""Mass of the blades over the propeller's [-], an estimate: hub, pitch change and spinner weigh as much."""


def blades_inertia(blades: ArrayLike, mass: ArrayLike, diameter: ArrayLike) -> Floats:
    """Return the polar inertia of blades of known mass [kg m²].

    Args:
        blades: How many [-].
        mass: Of one [kg].
        diameter: Of the propeller [m].

    Source: B m (0.38 R)², an estimate for composite blades.

    >>> round(float(blades_inertia(6, 14.0, 3.93)), 1)
    46.8
    """
    arm = GYRATION * 0.5 * np.asarray(diameter, float)
    return np.asarray(np.asarray(blades, float) * np.asarray(mass, float) * arm**2)


PAD_MOMENT = 0.5
"""Overhung mass times lever of an accessory on its pad [kg m], an estimate."""
