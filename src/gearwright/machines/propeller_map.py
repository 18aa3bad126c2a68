"""Propeller map of power and thrust coefficients, and the governor that controls the blade pitch."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from gearwright.base import DesignError, Floats, Ints, Problem

# ----------------------------------------------------------------------------------------------------------------------
# A propeller as a map: power and thrust coefficient over advance ratio and blade angle.
# ----------------------------------------------------------------------------------------------------------------------


INSIDE, OUTSIDE = 0, 1
"""Status of a look-up."""
SAME_ANGLE = 1e-6
"""Difference of blade angles that is rounding [rad]."""


class PropellerMap(NamedTuple):
    """C_P and C_T on a grid; a compiled kernel reads the same record."""

    advance_ratio: Floats
    """J = V/(n D), rising, shape (n,) [-]."""
    blade_angle: Floats
    """β, rising, shape (m,) [rad]."""
    power: Floats
    """C_P = P/(ρ n³ D⁵), shape (n, m) [-]; what lies outside `first` and `last` is never read."""
    thrust: Floats
    """C_T = T/(ρ n² D⁴), shape (n, m) [-]."""
    first: Ints
    """Index of the smallest blade angle that is given at each J, shape (n,) [-]."""
    last: Ints
    """Index of the largest one, shape (n,) [-]."""


class MachMap(NamedTuple):
    """A propeller's maps by the Mach number of its tips' rotation, over the same advance ratios and blade angles."""

    tip_mach: Floats
    """π n D over the speed of sound, rising, shape (k,) [-]."""
    maps: tuple[PropellerMap, ...]
    """One for each."""


def map_at(chart: PropellerMap | MachMap, tip_mach: float) -> PropellerMap:
    """Return a propeller's map at a Mach number of its tips.

    Args:
        chart: The map, or maps over the Mach number.
        tip_mach: π n D over the speed of sound [-].

    Source: linear between the maps; below the first one that one, as air hardly feels its compressibility there.

    Raises:
        DesignError: The Mach number is beyond the last map.
    """
    if isinstance(chart, PropellerMap):
        return chart
    known = chart.tip_mach
    if tip_mach > known[-1]:
        message = f"Mach {tip_mach:.3f} at the tips: the map ends at {known[-1]:.3g}; turn slower, or give maps beyond"
        raise DesignError([Problem("propeller.map", message)])
    k = min(max(int(np.searchsorted(known, tip_mach)) - 1, 0), max(len(known) - 2, 0))
    below, above = chart.maps[k], chart.maps[min(k + 1, len(known) - 1)]
    step = known[min(k + 1, len(known) - 1)] - known[k]
    part = max((tip_mach - known[k]) / step, 0.0) if step else 0.0
    return below._replace(
        power=(1.0 - part) * below.power + part * above.power,
        thrust=(1.0 - part) * below.thrust + part * above.thrust,
        first=np.maximum(below.first, above.first),
        last=np.minimum(below.last, above.last),
    )


class Coefficients(NamedTuple):
    """What a map says at one point."""

    power: float
    """C_P [-]."""
    thrust: float
    """C_T [-]."""
    status: int
    """INSIDE, or OUTSIDE: then both numbers are those of the nearest cell's edge and must not be used unseen."""


def look_up(chart: PropellerMap, advance_ratio: float, blade_angle: float) -> Coefficients:
    """Return C_P and C_T by bilinear interpolation, with a status; it raises nothing, for compiled kernels.

    Args:
        chart: The map.
        advance_ratio: J [-].
        blade_angle: β [rad].

    Source: definition of the map; every one of the four corners must be given.
    """
    ratio, angle = chart.advance_ratio, chart.blade_angle
    i = min(max(int(np.searchsorted(ratio, advance_ratio)) - 1, 0), len(ratio) - 2)
    k = min(max(int(np.searchsorted(angle, blade_angle)) - 1, 0), len(angle) - 2)
    low = max(chart.first[i], chart.first[i + 1])
    high = min(chart.last[i], chart.last[i + 1])
    j = min(max(k, int(low)), int(high) - 1)
    u = (advance_ratio - ratio[i]) / (ratio[i + 1] - ratio[i])
    v = (blade_angle - angle[j]) / (angle[j + 1] - angle[j])
    slack = 1e-9  # a point on the edge, but for rounding, is inside
    status = 0 if -slack <= u <= 1.0 + slack and -slack <= v <= 1.0 + slack else 1
    u, v = min(max(u, 0.0), 1.0), min(max(v, 0.0), 1.0)
    a, b, c, d = (1.0 - u) * (1.0 - v), (1.0 - u) * v, u * (1.0 - v), u * v
    cp, ct = chart.power, chart.thrust
    power = a * cp[i, j] + b * cp[i, j + 1] + c * cp[i + 1, j] + d * cp[i + 1, j + 1]
    thrust = a * ct[i, j] + b * ct[i, j + 1] + c * ct[i + 1, j] + d * ct[i + 1, j + 1]
    return Coefficients(power, thrust, status)


def coefficients(chart: PropellerMap, advance_ratio: float, blade_angle: float) -> Coefficients:
    """Return C_P and C_T at a point of the map.

    Args:
        chart: The map.
        advance_ratio: J [-].
        blade_angle: β [rad].

    Source: as `look_up`.

    Raises:
        DesignError: The point lies outside the map; with the point and what is given.
    """
    point = look_up(chart, advance_ratio, blade_angle)
    if point.status != INSIDE:
        raise _outside(chart, advance_ratio, f"blade angle {np.degrees(blade_angle):.4g}°")
    return point


def blade_angles(chart: PropellerMap, advance_ratio: float) -> tuple[float, float]:
    """Return the smallest and the largest blade angle that a map gives [rad].

    Args:
        chart: The map.
        advance_ratio: J [-].

    Raises:
        DesignError: The map does not reach this advance ratio.
    """
    angles, _ = _row(chart, advance_ratio, chart.power)
    return float(angles[0]), float(angles[-1])


def angle_for_power(chart: PropellerMap, advance_ratio: float, power: float) -> float:
    """Return the blade angle at which the propeller takes a power [rad].

    Args:
        chart: The map.
        advance_ratio: J [-].
        power: C_P [-].

    Source: the map's row at J, inverted; exact for `look_up`.

    Raises:
        DesignError: No blade angle of the map does.
    """
    return _inverted(chart, advance_ratio, power, table=chart.power, name="power coefficient")


def angle_for_thrust(chart: PropellerMap, advance_ratio: float, thrust: float) -> float:
    """Return the blade angle at which the propeller gives a thrust [rad].

    Args:
        chart: The map.
        advance_ratio: J [-].
        thrust: C_T [-].

    Source: the map's row at J, inverted; exact for `look_up`.

    Raises:
        DesignError: No blade angle of the map does.
    """
    return _inverted(chart, advance_ratio, thrust, table=chart.thrust, name="thrust coefficient")


def governs(chart: PropellerMap, advance_ratio: float, angle: float) -> bool:
    """Tell whether a coarser pitch takes more power, as a governor needs it.

    Args:
        chart: The map.
        advance_ratio: J [-].
        angle: Blade angle [rad].

    Source: the angle lies on the rise of the map's row at J, between that of least power and the stall of the blades.
    """
    angles, row = _row(chart, advance_ratio, chart.power)
    rise = angles[_rising(row)]
    return bool(rise[0] - SAME_ANGLE <= angle <= rise[-1] + SAME_ANGLE)


def angle_near(chart: PropellerMap, advance_ratio: float, power: float, near: float) -> float:
    """Return the blade angle at which the propeller takes a power, of several the one next to another angle [rad].

    Args:
        chart: The map.
        advance_ratio: J [-].
        power: C_P [-].
        near: Blade angle [rad], such as that of the moment before.

    Source: all crossings of the map's row at J, which has one on either side of the angle of least power.

    Raises:
        DesignError: No blade angle of the map does.
    """
    angles, row = _row(chart, advance_ratio, chart.power)
    over = row - power
    crossed = np.flatnonzero(over[:-1] * over[1:] <= 0.0)
    if not len(crossed):
        raise _outside(chart, advance_ratio, f"power coefficient {power:.4g}, of {row.min():.4g} to {row.max():.4g}")
    steps = row[crossed + 1] - row[crossed]
    parts = np.where(steps == 0.0, 0.0, -over[crossed] / np.where(steps == 0.0, 1.0, steps))
    met = angles[crossed] + parts * (angles[crossed + 1] - angles[crossed])
    return float(met[np.argmin(np.abs(met - near))])


def _inverted(chart: PropellerMap, advance_ratio: float, value: float, *, table: Floats, name: str) -> float:
    angles, row = _row(chart, advance_ratio, table)
    rising = _rising(row)
    stalls = rising.stop < len(row)
    row, angles = row[rising], angles[rising]
    if stalls and value > row[-1]:
        raise _stalled(advance_ratio, f"{name} {value:.4g}", row[-1], angles[-1])
    if not row[0] <= value <= row[-1]:
        raise _outside(chart, advance_ratio, f"{name} {value:.4g}, of {row[0]:.4g} to {row[-1]:.4g}")
    return float(np.interp(value, row, angles))


def _stalled(advance_ratio: float, asked: str, most: float, angle: float) -> DesignError:
    message = (
        f"advance ratio {advance_ratio:.4g}, {asked}: the blades stall at {np.degrees(angle):.4g}°, where they give the"
        f" most, {most:.4g}; ask for less, turn the propeller faster, or take wider or more blades"
    )
    return DesignError([Problem("propeller.map", message)])


def _rising(row: Floats) -> slice:
    """The rise of a row that spans most: beyond its ends the blade stalls, where no governor would find an angle."""
    falls = np.flatnonzero(np.diff(row) <= 0.0)
    starts, ends = np.append(0, falls + 1), np.append(falls + 1, len(row))
    most = int(np.argmax(row[ends - 1] - row[starts]))
    return slice(int(starts[most]), int(ends[most]))


def _row(chart: PropellerMap, advance_ratio: float, table: Floats) -> tuple[Floats, Floats]:
    """Return blade angles and values at an advance ratio between two rows of the map."""
    ratio = chart.advance_ratio
    if not ratio[0] <= advance_ratio <= ratio[-1]:
        raise _outside(chart, advance_ratio, "no blade angle")
    i = min(max(int(np.searchsorted(ratio, advance_ratio)) - 1, 0), len(ratio) - 2)
    shared = slice(max(chart.first[i], chart.first[i + 1]), min(chart.last[i], chart.last[i + 1]) + 1)
    u = (advance_ratio - ratio[i]) / (ratio[i + 1] - ratio[i])
    return chart.blade_angle[shared], (1.0 - u) * table[i, shared] + u * table[i + 1, shared]


def _outside(chart: PropellerMap, advance_ratio: float, detail: str) -> DesignError:
    ratio, angle = chart.advance_ratio, np.degrees(chart.blade_angle)
    message = (
        f"advance ratio {advance_ratio:.4g}, {detail}: outside the map, which spans advance ratios {ratio[0]:.4g} to"
        f" {ratio[-1]:.4g} and blade angles {angle[0]:.4g} to {angle[-1]:.4g}°, not all of them together;"
        " change speed, power or propeller speed, or give a map that covers the point"
    )
    return DesignError([Problem("propeller.map", message)])


# ----------------------------------------------------------------------------------------------------------------------
# A propeller governor: the pitch that holds a propeller speed, by speed error, its integral and an actuator.
# ----------------------------------------------------------------------------------------------------------------------


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
