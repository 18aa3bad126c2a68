"""A propeller governor: the pitch that holds a propeller speed, by speed error, its integral and an actuator."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats


class Governor(NamedTuple):
    """Settings of a governor; a compiled kernel reads the same record."""

    reference: float
    """Blade angle without a speed error β_ref [rad]."""
    proportional: float
    """K_p [rad/(rad/s)]."""
    integral: float
    """K_i [rad/rad]; 0 leaves a speed error that is proportional to the pitch change, as the thesis's governor does."""
    time_constant: float
    """Of the actuator τ [s]; for one of second order 1/ω_0."""
    damping: float
    """ζ of an actuator of second order [-]; 0: one of first order."""
    lower: float
    """Pitch stop in use: flight idle in the air, ground idle on taxi [rad]."""
    upper: float
    """Coarse stop [rad]."""
    rate: float
    """Fastest pitch change [rad/s]."""


class GovernorState(NamedTuple):
    """What a governor remembers."""

    pitch: float
    """Blade angle β [rad]."""
    pitch_rate: float
    """dβ/dt [rad/s]; used by an actuator of second order."""
    error_sum: float
    """Integral of the speed error [rad]."""


def governor_rates(governor: Governor, state: GovernorState, error: float) -> GovernorState:
    """Return the time derivatives of a governor's state; it calls nothing, for compiled kernels.

    Args:
        governor: Its settings.
        state: Now.
        error: ω_set - ω [rad/s].

    Source: actuator τ β̇ = β_c - β, or τ² β̈ + 2 ζ τ β̇ = β_c - β (Pulvirenti 2023, figure 3.23: first and second
        order); rate limit on the actuator; the integral stands still while the command lies beyond a stop.
    """
    asked = governor.reference - governor.proportional * error - governor.integral * state.error_sum
    command = min(max(asked, governor.lower), governor.upper)
    # Winding up: the integral may move the command back between the stops, not further beyond them.
    stuck = (asked > governor.upper and error < 0.0) or (asked < governor.lower and error > 0.0)
    summing = 0.0 if stuck else error
    gap = command - state.pitch
    if governor.damping == 0.0:
        moving = min(max(gap / governor.time_constant, -governor.rate), governor.rate)
        return GovernorState(moving, 0.0, summing)
    square = governor.time_constant * governor.time_constant
    pull = (gap - 2.0 * governor.damping * governor.time_constant * state.pitch_rate) / square
    moving = min(max(state.pitch_rate, -governor.rate), governor.rate)
    at_limit = (state.pitch_rate >= governor.rate and pull > 0.0) or (state.pitch_rate <= -governor.rate and pull < 0.0)
    return GovernorState(moving, 0.0 if at_limit else pull, summing)


class Rotor(NamedTuple):
    """A propeller on its drive train, linear about one operating point."""

    inertia: float
    """Of everything that turns, at the propeller [kg m²]."""
    speed_slope: float
    """d(driving - propeller torque)/dω at constant pitch, negative where the propeller damps [N m s/rad]."""
    pitch_slope: float
    """d(propeller torque)/dβ at constant speed [N m/rad]."""
    pitch: float
    """Blade angle of the operating point [rad]."""


class LimitCycle(NamedTuple):
    """An oscillation that a governor sustains by itself."""

    frequency: float
    """[Hz]"""
    amplitude: float
    """Of the propeller speed, half of its swing [rad/s]."""


def marched(
    rates: Callable[[Floats], Floats], start: tuple[float, ...], *, duration: float, step: float
) -> tuple[Floats, Floats]:
    """Return time and states of a governed propeller, by the Runge-Kutta method of fourth order.

    Args:
        rates: State -> its derivative.
        start: State at time 0.
        duration: [s].
        step: [s].

    Returns:
        Time [s], shape (steps + 1,), and states, shape (steps + 1, of the state).
    """
    count = round(duration / step)
    states = np.zeros((count + 1, len(start)))
    states[0] = start
    for k in range(count):
        state = states[k]
        a = rates(state)
        b = rates(state + 0.5 * step * a)
        c = rates(state + 0.5 * step * b)
        d = rates(state + step * c)
        states[k + 1] = state + step / 6.0 * (a + 2.0 * b + 2.0 * c + d)
    return np.linspace(0.0, duration, count + 1), states


def limit_cycle(time: Floats, speed: Floats) -> LimitCycle | None:
    """Return the oscillation that is left in the second half of a response, or None where it dies out.

    Args:
        time: [s], shape (n,).
        speed: ω - ω_set [rad/s], shape (n,).

    Source: swing of the last quarter against that of the quarter before: an oscillation that has not lost a tenth of
        it, and crosses its mean at least four times, is sustained.
    """
    half, quarter = len(time) // 2, 3 * len(time) // 4
    earlier, later = speed[half:quarter], speed[quarter:]
    swing = float(np.ptp(later))
    centred = later - later.mean()
    crossings = np.flatnonzero(np.diff(np.signbit(centred)))
    if swing < 0.9 * float(np.ptp(earlier)) or len(crossings) < 4 or swing < 1e-6 * max(float(np.ptp(speed)), 1e-12):
        return None
    moments = time[quarter:][crossings]
    return LimitCycle((len(crossings) - 1) / (2.0 * float(moments[-1] - moments[0])), 0.5 * swing)
