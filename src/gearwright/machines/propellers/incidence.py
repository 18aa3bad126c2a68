"""A propeller whose axis stands at an angle to the stream: loads that bend blades and shaft once a turn."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.machines.propellers.blade import BladeShape
from gearwright.machines.propellers.elements import loads_in

AZIMUTHS = 24
"""Places of a blade around the turn; loads are sines of few orders."""
LARGEST_INCIDENCE = math.radians(30.0)
"""Angle beyond which the stream along the disc is no small part of the blades' speed [rad]."""


class Inclined(NamedTuple):
    """A propeller at incidence; coefficients by ρ n² D⁴, moments by ρ n² D⁵, power by ρ n³ D⁵."""

    thrust: float
    """C_T along the axis [-]."""
    power: float
    """C_P [-]."""
    normal: float
    """C_N: force across the axis, towards the side to which the nose points [-]."""
    yaw: float
    """C_n: moment across the axis by the thrust, which lies towards the blades that go down (nose up) [-]."""
    blade_thrust: Floats
    """C_T of one blade around the turn, from where it stands up [-]."""
    blade_bending: Floats
    """Moment of one blade's thrust about the axis' centre, around the turn [-]."""

    @property
    def once_a_turn(self) -> float:
        """Amplitude of a blade's bending once a turn [-]."""
        turn = np.exp(-2j * math.pi * np.arange(AZIMUTHS) / AZIMUTHS)
        return float(abs(2.0 * np.mean(self.blade_bending * turn)))


def inclined(
    shape: BladeShape, advance_ratio: float, pitch: float, *, incidence: float, tip_mach: float = 0.0
) -> Inclined:
    """Return the loads of a propeller whose axis stands at an angle to the stream.

    Args:
        shape: The blades.
        advance_ratio: J = V/(n D) of the whole stream [-].
        pitch: Blade angle at three quarters of the radius [rad].
        incidence: Angle between axis and stream; positive where the nose points up [rad].
        tip_mach: Of the tip's rotation; 0 leaves compressibility out [-].

    Source: blade elements around the turn: the part V sin α along the disc adds V sin α sin ψ to an element's speed;
        steady sections, and momentum at every place as if the whole ring were loaded so.

    Valid for: incidences to 30° and V sin α well below the speed of the elements; no wing, no nacelle.

    Raises:
        ValueError: Beyond 30°, or where elements of the hub would run backwards.
    """
    if abs(incidence) > LARGEST_INCIDENCE:
        raise ValueError(f"{math.degrees(incidence):.4g}° of incidence: give at most 30°")
    along = advance_ratio / math.pi * math.sin(incidence)
    if abs(along) >= shape.radius[0]:
        raise ValueError("the stream along the disc is faster than the blades' roots turn; less incidence or speed")
    turn = 2.0 * math.pi * np.arange(AZIMUTHS)[:, None] / AZIMUTHS
    turning = shape.radius + along * np.sin(turn)
    axial = np.full_like(turning, advance_ratio / math.pi * math.cos(incidence))
    found = loads_in(shape, axial, turning, pitch=pitch, tip_mach=tip_mach)
    # C_P per element is 2π (r/D) times the force along the turn: D/2 is the unit of the radius.
    across = found.element_power / (math.pi * shape.radius)
    side = np.sin(turn)[:, 0]
    bending = np.sum(found.element_thrust * shape.radius * shape.width, axis=-1) / 2.0
    return Inclined(
        thrust=float(np.mean(found.thrust)),
        power=float(np.mean(found.power)),
        normal=float(np.mean(np.sum(across * shape.width, axis=-1) * side)),
        yaw=float(np.mean(bending * side)),
        blade_thrust=found.thrust / shape.number,
        blade_bending=bending / shape.number,
    )
