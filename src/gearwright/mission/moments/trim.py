"""Trim of a helicopter: what main and tail rotor take at a weight, a speed and a rate of climb."""

from __future__ import annotations

import math
from typing import NamedTuple

from gearwright.errors import DesignError, Problem
from gearwright.machines.rotor_power import Disc, Stream, rotor_power
from gearwright.mission.moments.course import Moment
from gearwright.spec import Mission, Rotorcraft
from gearwright.units import GRAVITY

_STILL = 1.0
"""Forward speed over the induced velocity in hover beyond which the wake misses the fuselage [-]."""


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

    Source: momentum and blade elements (`rotor_power`); m g V_c of height, ρ V³ f/2 of the fuselage; the tail rotor's
        thrust times its arm is the torque of the mast.

    Raises:
        DesignError: Blades that stall, or a descent into the rotor's own wake.
    """
    disc = Disc(diameter, craft.solidity, craft.profile_drag, craft.induced_factor)
    density, speed, climb = moment.air.density, moment.propeller_speed, moment.climb
    forward = math.sqrt(max(moment.true_airspeed**2 - climb**2, 0.0)) if moment.true_airspeed > abs(climb) else 0.0
    weight = (craft.mass - burnt) * GRAVITY
    hover = math.sqrt(weight / (2.0 * density * disc.area))
    lifted = weight * (1.0 + craft.download * max(1.0 - forward / (_STILL * hover), 0.0))
    drag = 0.5 * density * craft.flat_plate_area * forward**2
    thrust = math.hypot(lifted, drag)
    _refuse_stall(craft, disc, moment, thrust)
    power = rotor_power(disc, Stream(density, forward, climb, speed), thrust)
    power += weight * climb + drag * forward + (craft.mass - burnt) * moment.acceleration * moment.true_airspeed
    return Trim(power, _tail(craft, mission, moment, (power, forward)), thrust)


def _tail(craft: Rotorcraft, mission: Mission, moment: Moment, main: tuple[float, float]) -> float | None:
    """Return the power of the tail rotor [W]; `main` is the main rotor's power [W] and the forward speed [m/s]."""
    tail, (power, forward) = craft.tail, main
    if tail is None:
        return None
    first = next(iter(mission.phases.values())).propeller_speed
    disc = Disc(tail.diameter, tail.solidity, tail.profile_drag, tail.induced_factor)
    stream = Stream(moment.air.density, forward, 0.0, tail.speed * moment.propeller_speed / first)
    return rotor_power(disc, stream, abs(power) / moment.propeller_speed / tail.arm)


def _refuse_stall(craft: Rotorcraft, disc: Disc, moment: Moment, thrust: float) -> None:
    tip = 0.5 * moment.propeller_speed * disc.diameter
    loading = thrust / (moment.air.density * disc.area * tip**2 * disc.solidity)
    if loading > craft.highest_loading:
        message = (
            f"blades bear C_T/σ {loading:.3g} at {moment.altitude:.0f} m, and stall beyond {craft.highest_loading:.3g};"
            " be lighter, fly lower, or turn the rotor faster"
        )
        raise DesignError([Problem("rotorcraft", message)])
