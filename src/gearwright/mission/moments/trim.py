"""Trim of a helicopter: what main and tail rotor take at a weight, a speed and a rate of climb."""

from __future__ import annotations

import math
from typing import NamedTuple

from gearwright.errors import DesignError, Problem
from gearwright.machines.rotor_power import Disc, Stream
from gearwright.machines.rotor_trim import Airframe, antitorque, lift
from gearwright.mission.moments.course import Moment
from gearwright.spec import Mission, Rotorcraft


class Trim(NamedTuple):
    """What the rotors take."""

    main: float
    """Power of the main rotor's shaft [W]."""
    tail: float | None
    """Of the tail rotor's [W]; None where the mission says nothing of it."""
    thrust: float
    """Of the main rotor [N]."""


def trimmed(craft: Rotorcraft, mission: Mission, moment: Moment, *, diameter: float, burnt: float) -> Trim:
    """Return what main and tail rotor take in an interval.

    Args:
        craft: The helicopter.
        mission: Of it.
        moment: Where it is flown; the propeller's speed is that of the main rotor.
        diameter: Of the main rotor [m].
        burnt: Fuel so far [kg].

    Source: `lift` and `antitorque`.

    Raises:
        DesignError: Blades that stall, or a descent into the rotor's own wake.
    """
    disc = Disc(diameter, craft.solidity, craft.profile_drag, craft.induced_factor)
    speed, climb, mass = moment.propeller_speed, moment.climb, craft.mass - burnt
    forward = math.sqrt(max(moment.true_airspeed**2 - climb**2, 0.0)) if moment.true_airspeed > abs(climb) else 0.0
    carried = Airframe(mass, craft.flat_plate_area, craft.download)
    stream = Stream(moment.air.density, forward, climb, speed)
    found = lift(disc, carried, stream, mass * moment.acceleration * moment.true_airspeed)
    if found.loading > craft.highest_loading:
        message = (
            f"blades bear C_T/σ {found.loading:.3g} at {moment.altitude:.0f} m, and stall beyond"
            f" {craft.highest_loading:.3g}; be lighter, fly lower, or turn the rotor faster"
        )
        raise DesignError([Problem("rotorcraft", message)])
    return Trim(found.power, _tail(craft, mission, moment, (found.power, forward)), found.thrust)


def _tail(craft: Rotorcraft, mission: Mission, moment: Moment, main: tuple[float, float]) -> float | None:
    """Return the power of the tail rotor [W]; `main` is the main rotor's power [W] and the forward speed [m/s]."""
    tail, (power, forward) = craft.tail, main
    if tail is None:
        return None
    first = next(iter(mission.phases.values())).propeller_speed
    disc = Disc(tail.diameter, tail.solidity, tail.profile_drag, tail.induced_factor)
    stream = Stream(moment.air.density, forward, 0.0, tail.speed * moment.propeller_speed / first)
    return antitorque(disc, stream, power / moment.propeller_speed, tail.arm).power
