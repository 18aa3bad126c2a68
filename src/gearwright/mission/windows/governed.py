"""A window of a flight with its governor: propeller, governor and a rigid drive train, seconds long.

The train's own elasticity is left out: what it does in milliseconds is the matter of the dynamic model.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from gearwright.air import sound_speed
from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem
from gearwright.machines import (
    INSIDE,
    Governor,
    GovernorState,
    LimitCycle,
    PropellerMap,
    Rotor,
    governor_rates,
    limit_cycle,
    look_up,
    map_at,
    marched,
)
from gearwright.mission.consumers import flown_airscrew
from gearwright.mission.flight import Flight
from gearwright.verbs import verb

_NUDGE = 5e-3
"""Part of the speed, and angle in rad, over which slopes of the map are taken [-]; [rad]"""


class Trim(NamedTuple):
    """A propeller in equilibrium at a moment of a flight."""

    chart: PropellerMap
    density: float
    """ρ [kg/m³]."""
    true_airspeed: float
    """V [m/s]."""
    diameter: float
    """D [m]."""
    speed: float
    """ω [rad/s]."""
    pitch: float
    """β [rad]."""
    inertia: float
    """Of everything that turns, at the propeller [kg m²]."""

    def torque(self, speed: float, pitch: float) -> float:
        """Return what the propeller takes from its shaft [N m].

        Args:
            speed: ω [rad/s].
            pitch: β [rad].

        Raises:
            DesignError: The point lies outside the map.
        """
        turns = speed / (2.0 * np.pi)
        coefficients = look_up(self.chart, self.true_airspeed / (turns * self.diameter), pitch)
        if coefficients.status != INSIDE:
            message = f"{turns * 60:.0f} rpm and {np.degrees(pitch):.1f}° lie outside the map in this window"
            raise DesignError(
                [Problem("propeller.map", f"{message}; start from another moment, or with a smaller step")]
            )
        return float(coefficients.power * self.density * turns**2 * self.diameter**5 / (2.0 * np.pi))


@dataclass(frozen=True)
class Window:
    """Histories of a governed propeller, shape (steps + 1,)."""

    time: Floats
    """[s]"""
    speed: Floats
    """Of the propeller [rad/s]."""
    pitch: Floats
    """[rad]"""
    torque: Floats
    """Of the propeller [N m]."""
    limit_cycle: LimitCycle | None
    """What the governor sustains; None where it comes to rest."""

    @property
    def overshoot(self) -> float:
        """Largest torque beyond the last one, as a part of it [-]."""
        return float(self.torque.max() / self.torque[-1] - 1.0)


@verb
def trim_at(flight: Flight, time: float) -> Trim:
    """Return the propeller in equilibrium at a time of a flight.

    Args:
        flight: As flown.
        time: From the start of the mission [s]; the nearest interval counts.

    Raises:
        DesignError: The flight has no propeller map.
    """
    history = flight.history
    if flight.propeller_map is None or history.pitch is None:
        raise DesignError([Problem("propeller_map", "the mission flies by schedules; a governor needs a map")])
    k = int(np.argmin(np.abs(history.time - time)))
    diameter = flight.sizing.design.airscrews[flown_airscrew(flight.sizing)].diameter
    return Trim(
        chart=chart_at(flight, k),
        density=float(history.air_density[k]),
        true_airspeed=float(history.true_airspeed[k]),
        diameter=diameter,
        speed=float(history.propeller_speed[k]),
        pitch=float(history.pitch[k]),
        inertia=flight.inertia,
    )


def chart_at(flight: Flight, interval: int) -> PropellerMap:
    """Return the propeller's map in an interval of a flight: of maps over the Mach number that of its tips there.

    Args:
        flight: As flown, with a map.
        interval: Of its histories.

    Raises:
        DesignError: The Mach number is beyond the last map.
    """
    assert flight.propeller_map is not None  # refused before
    history = flight.history
    diameter = flight.sizing.design.airscrews[flown_airscrew(flight.sizing)].diameter
    sound = sound_speed(float(history.air_temperature[interval]))
    return map_at(flight.propeller_map, 0.5 * float(history.propeller_speed[interval]) * diameter / sound)


@verb
def rotor_at(trim: Trim) -> Rotor:
    """Return the propeller linear about its equilibrium, driven by a constant torque.

    Args:
        trim: The equilibrium.

    Source: central differences of the map.
    """
    ahead, behind = ((1.0 + sign * _NUDGE) * trim.speed for sign in (1.0, -1.0))
    speeding = (trim.torque(ahead, trim.pitch) - trim.torque(behind, trim.pitch)) / (ahead - behind)
    pitching = (
        trim.torque(trim.speed, trim.pitch + _NUDGE) - trim.torque(trim.speed, trim.pitch - _NUDGE)
    ) / (2.0 * _NUDGE)  # fmt: skip
    return Rotor(trim.inertia, -speeding, pitching, trim.pitch)


@verb
def governed_window(
    trim: Trim, governor: Governor, *, duration: float, torque_step: float = 0.0, speed_step: float = 0.0,
    step: float = 2e-3,
) -> Window:  # fmt: skip
    """Return how propeller and governor answer to a step of the driving torque or of the set speed.

    Args:
        trim: The equilibrium before the step.
        governor: Its settings; its reference is the pitch that it has without a speed error.
        duration: [s].
        torque_step: Part by which the driving torque changes, as when a motor is cut [-].
        speed_step: Change of the set speed [rad/s].
        step: Of the Runge-Kutta method of fourth order [s].

    Source: I ω̇ = Q_drive - Q(ω, β) with `governor_rates`; the drive is a torque source, as in Pulvirenti 2023, §3.3.

    Raises:
        DesignError: The window leaves the propeller map.
    """
    drive = trim.torque(trim.speed, trim.pitch) * (1.0 + torque_step)
    target = trim.speed + speed_step

    def rates(state: Floats) -> Floats:
        speed, pitch, pitch_rate, error_sum = (float(value) for value in state)
        moved = governor_rates(governor, GovernorState(pitch, pitch_rate, error_sum), target - speed)
        return np.array([(drive - trim.torque(speed, pitch)) / trim.inertia, *moved])

    start = (trim.speed, trim.pitch, 0.0, _settled_sum(trim, governor))
    time, states = marched(rates, start, duration=duration, step=step)
    torque = np.array([trim.torque(float(speed), float(pitch)) for speed, pitch in states[:, :2]])
    return Window(time, states[:, 0], states[:, 1], torque, limit_cycle(time, states[:, 0]))


def _settled_sum(trim: Trim, governor: Governor) -> float:
    """The integral with which the governor holds the pitch of the equilibrium."""
    return (governor.reference - trim.pitch) / governor.integral if governor.integral else 0.0
