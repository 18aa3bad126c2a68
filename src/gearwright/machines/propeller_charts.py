"""Charts of propellers: maps of power and thrust coefficients with their governor, and the Hamilton Standard method."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from gearwright.base import DesignError, Floats, Ints, Problem, SolveError
from gearwright.elementwise import Values, plain

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
    rise = angles[_rise(row)]
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
    rising = _rise(row)
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


def _rise(row: Floats) -> slice:
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


# ----------------------------------------------------------------------------------------------------------------------
# Reading the Hamilton Standard charts: factors, four-point interpolation, and what a point leaves or breaks.
# ----------------------------------------------------------------------------------------------------------------------


Rows = tuple[Floats, ...]

STATIC_FADE = 0.5
"""Advance ratio at which the static tip Mach number no longer counts [-]: the next chart's advance ratio."""
_MOST_THRUST = 3.0
"""Upper end of the search for C_T; the charts end at 0.8 for twice the base activity factor."""
_STEP = 1e-3
"""Relative step of C_P in which C_T has to rise [-]."""
BEYOND_FROUDE, FALLING_THRUST = "Froude's limit", "rising thrust"
"""What is left where the charts' factors contradict the momentum of the stream, or C_T falls with C_P."""
_STEEP = 2.0
"""Fall of a lift factor in a table's first cell beyond which several thrusts answer to one chart value [-]."""
SMALL_THRUST = "compressibility at small thrust"
"""Table that is left where there is hardly a thrust: its factor is held, and does not count."""


class Charts(NamedTuple):
    """The charts of NASA CR-114399 as arrays; the first index is the blade count, the second the advance ratio."""

    blade_counts: Floats
    """Shape (4,) [-]."""
    advance_ratio: Floats
    """J of the charts, shape (7,) [-]."""
    blade_angle: Rows
    """β at three quarters of the radius, one row per J [deg]."""
    power: tuple[Rows, ...]
    """C_P over the blade angles, by blade count and J [-]."""
    thrust: tuple[Rows, ...]
    """C_T over the blade angles, by blade count and J [-]."""
    activity_factor: Floats
    """Shape (6,) [-]."""
    activity_power: Floats
    """Factor on C_P at J = 0 and from J = 0.5 on, shape (2, 6) [-]."""
    activity_thrust: Floats
    """Factor on C_T, likewise, shape (2, 6) [-]."""
    number_power: tuple[Floats, Floats]
    """Effective C_P (14,) and the blade-number factor (4, 14) [-]."""
    number_thrust: tuple[Floats, Floats]
    """Effective C_T (14,) and the blade-number factor (4, 14) [-]."""
    lift: Floats
    """Integrated design lift coefficients of the lift tables, shape (6,) [-]."""
    lift_power: tuple[Rows, Rows]
    """C_P and its factor by lift coefficient [-]."""
    lift_thrust: tuple[Rows, Rows]
    """C_T and its factor by lift coefficient [-]."""
    lift_scale: Floats
    """Scale of C_P and of C_T in the lift tables at the charts' J, shape (2, 7) [-]."""
    critical_mach: tuple[Floats, Floats, Floats]
    """J (11,), critical flight Mach number by lift and J (6, 11), static critical tip Mach number by lift (6,) [-]."""
    compressibility: tuple[Floats, Floats, Floats]
    """Excess Mach number (9,), effective C_T (12,) and the thrust factor (9, 12) [-]."""


class Blades(NamedTuple):
    """What the method knows of a propeller."""

    number: int
    """Number of blades, 2 to 8 [-]."""
    activity_factor: float
    """Of one blade, 80 to 200 [-]."""
    design_lift: float
    """Integrated design lift coefficient C_Li, 0.3 to 0.8 [-]."""


def ideal_power(advance_ratio: float, thrust_coefficient: float) -> float:
    """Return the least C_P at which a stream gives a thrust, that of Froude's actuator disc [-].

    Args:
        advance_ratio: J [-].
        thrust_coefficient: C_T, not negative [-].

    Source: Froude (1889): P = T (V/2 + √(V²/4 + T/(2 ρ A))), in coefficients.

    >>> round(ideal_power(0.0, 0.2), 6)  # the static thrust 0.2 asks for 0.2 √(2·0.2/π)
    0.071365
    """
    return thrust_coefficient * (
        advance_ratio / 2.0 + math.sqrt(advance_ratio**2 / 4.0 + 2.0 * thrust_coefficient / math.pi)
    )


@dataclass
class Look:
    """Reads the charts for a propeller by four points and remembers where it was held at an end."""

    charts: Charts
    """The charts."""
    blades: Blades
    """The propeller."""
    held: set[str] = field(default_factory=set)
    """Names of the tables that were left; a table that is flat at its end is not left there."""

    @property
    def counts(self) -> range:
        """The charts' blade counts around this one."""
        return _around(self.charts.blade_counts, self.blades.number)

    def at(self, x: float, table: tuple[Floats, Floats], name: str) -> float:
        """Return y(x): the mean of two parabolas, weighted linearly between the two middle points.

        Args:
            x: Where to read.
            table: x, rising, and y.
            name: What to remember where x lies outside.
        """
        xs, ys = table
        inside = min(max(x, float(xs[0])), float(xs[-1]))
        if inside != x and ys[0 if x < xs[0] else -1] != ys[1 if x < xs[0] else -2]:
            self.held.add(name)
        k = min(max(int(np.searchsorted(xs, inside, side="right")) - 1, 0), len(xs) - 2)
        if k == 0 or k == len(xs) - 2:
            first = 0 if k == 0 else len(xs) - 3
            return float(parabola(inside, xs[first : first + 3], ys[first : first + 3]))
        weight = float((inside - xs[k]) / (xs[k + 1] - xs[k]))
        left = parabola(inside, xs[k - 1 : k + 2], ys[k - 1 : k + 2])
        return float((1.0 - weight) * left + weight * parabola(inside, xs[k : k + 3], ys[k : k + 3]))

    def over(self, nodes: Floats, x: float, values: Sequence[float]) -> float:
        """Return the value at a point from those at the nodes around it.

        Args:
            nodes: Blade counts or advance ratios of the charts [-].
            x: Where to read [-].
            values: At the nodes around x.
        """
        if len(values) == 1:
            return values[0]
        around = _around(nodes, x)
        return self.at(x, (nodes[around.start : around.stop], np.array(values)), "blade count or advance ratio")

    def over_counts(self, values: Sequence[float]) -> float:
        """Return the value of this blade count from those of the charts' blade counts around it.

        Args:
            values: By blade count.
        """
        return self.over(self.charts.blade_counts, self.blades.number, values)

    def incompressible(self, advance_ratio: float, power: float) -> tuple[float, list[float]]:
        """Return the blade angle [deg], and C_T for each of the charts' blade counts around this one.

        Args:
            advance_ratio: J [-].
            power: C_P [-].
        """
        angles, thrusts = zip(*(self._by_count(count, advance_ratio, power) for count in self.counts), strict=True)
        return self.over_counts(angles), list(thrusts)

    def guard(self, advance_ratio: float, power: float, thrust: float) -> None:
        """Remember a point that no propeller has: beyond Froude's limit, or where more power gives less thrust.

        Args:
            advance_ratio: J [-].
            power: C_P [-].
            thrust: C_T without compressibility [-].

        Source: Froude: P ≥ T (V/2 + √(V²/4 + T/(2 ρ A))), in coefficients.
        """
        if power < ideal_power(advance_ratio, thrust):
            self.held.add(BEYOND_FROUDE)
        # What is left on the way to the next point is not remembered.
        beside = Look(self.charts, self.blades)
        above, below = (
            beside.over_counts(beside.incompressible(advance_ratio, power * (1.0 + step))[1])
            for step in (_STEP, -_STEP)
        )
        if not below < thrust < above:
            self.held.add(FALLING_THRUST)

    def _by_count(self, count: int, advance_ratio: float, power: float) -> tuple[float, float]:
        """Return blade angle [deg] and C_T for one of the charts' blade counts."""
        charts = self.charts
        angles, thrusts = [], []
        for j in _around(charts.advance_ratio, advance_ratio):
            # The factor belongs to the chart: one row for standstill, the other for every chart in motion.
            activity = (charts.activity_factor, charts.activity_power[min(j, 1)])
            effective = power * self.at(self.blades.activity_factor, activity, "activity factor")
            number = self.at(effective, (charts.number_power[0], charts.number_power[1][count]), "blade-number power")
            lift = self._by_lift(effective * number * charts.lift_scale[0, j], charts.lift_power, "lift power")
            chart = (charts.power[count][j], charts.blade_angle[j])
            angles.append(self.at(effective * lift, _rising(chart), f"power chart J = {charts.advance_ratio[j]:g}"))
            thrusts.append(self.at(angles[-1], (charts.blade_angle[j], charts.thrust[count][j]), "thrust chart"))
        angle, thrust = (self.over(charts.advance_ratio, advance_ratio, values) for values in (angles, thrusts))
        return angle, self._thrust(count, advance_ratio, thrust)

    def compressibility(self, advance_ratio: float, thrusts: Sequence[float], *, mach: float, tip_mach: float) -> float:
        """Return the thrust factor of the excess over the critical Mach number [-].

        Args:
            advance_ratio: J [-].
            thrusts: C_T without compressibility, for each of the charts' blade counts around this one [-].
            mach: Of the flight [-].
            tip_mach: Of the tips' rotation [-].
        """
        excess = [self._excess(row, advance_ratio, mach, tip_mach) for row in self._lift_rows()]
        if max(excess) <= 0.0:
            return 1.0
        factors = [
            self._squeezed(count, advance_ratio, thrust, excess) if thrust > 0.0 else 1.0
            for count, thrust in zip(self.counts, thrusts, strict=True)
        ]
        return min(self.over_counts(factors), 1.0)

    def _excess(self, row: int, advance_ratio: float, mach: float, tip_mach: float) -> float:
        """Return what the Mach number has over the critical one of a design lift coefficient's table."""
        ratio, flight, static = self.charts.critical_mach
        moving = self.at(advance_ratio, (ratio, flight[row]), "critical Mach number")
        fade = max(1.0 - advance_ratio / STATIC_FADE, 0.0)
        return float(max(mach - moving if advance_ratio > 0.0 else 0.0, fade * (tip_mach - static[row])))

    def _squeezed(self, count: int, advance_ratio: float, thrust: float, excess: Sequence[float]) -> float:
        """Return the compressibility factor for one of the charts' blade counts."""
        effective, scale = thrust * self._activity_thrust(advance_ratio), self._thrust_scale(advance_ratio)
        number = effective * self._number_thrust(count, effective)
        coefficients, lift_factors = self.charts.lift_thrust
        machs, thrusts, table = self.charts.compressibility
        factors = []
        for row, over in zip(self._lift_rows(), excess, strict=True):
            lifted = number * self.at(number * scale, (coefficients[row], lift_factors[row]), "lift thrust")
            name = SMALL_THRUST if lifted < thrusts[0] else "compressibility"
            lines = np.array([self.at(lifted, (thrusts, line), name) for line in table])
            factors.append(self.at(over, (machs, lines), "compressibility") if over > 0.0 else 1.0)
        return self._over_lift(factors)

    def _by_lift(self, x: float, tables: tuple[Rows, Rows], name: str) -> float:
        """Return a lift factor at a coefficient; only the tables of the lift coefficients around are read."""
        return self._over_lift([self.at(x, (tables[0][row], tables[1][row]), name) for row in self._lift_rows()])

    def _lift_rows(self) -> range:
        """The lift tables that count: a node's own, or four that end with the interval's upper one."""
        nodes, lift = self.charts.lift, self.blades.design_lift
        k = int(np.searchsorted(nodes, lift, side="right")) - 1
        if k >= 0 and nodes[k] == lift:
            return range(k, k + 1)
        first = min(max(k - 2, 0), len(nodes) - 4)
        return range(first, first + 4)

    def _over_lift(self, values: Sequence[float]) -> float:
        if len(values) == 1:
            return values[0]
        rows = self._lift_rows()
        return self.at(self.blades.design_lift, (self.charts.lift[rows.start : rows.stop], np.array(values)), "lift")

    def _thrust(self, count: int, advance_ratio: float, chart: float) -> float:
        """Return the C_T whose effective value, with its lift factor, is the chart's."""
        factor, scale = self._activity_thrust(advance_ratio), self._thrust_scale(advance_ratio)

        def excess(thrust: float) -> float:
            # What the search meets on its way is not remembered.
            return thrust * factor * Look(self.charts, self.blades)._lift_thrust(count, scale, thrust * factor) - chart

        if chart <= 0.0:
            self.held.add("positive thrust")
            return chart / factor
        thrust = _root(excess, chart)
        self._lift_thrust(count, scale, thrust * factor)
        return thrust

    def _activity_thrust(self, advance_ratio: float) -> float:
        ends = [
            self.at(self.blades.activity_factor, (self.charts.activity_factor, row), "activity factor")
            for row in self.charts.activity_thrust
        ]
        return ends[0] + (ends[1] - ends[0]) * min(advance_ratio / 0.5, 1.0)

    def _thrust_scale(self, advance_ratio: float) -> float:
        return self.at(advance_ratio, (self.charts.advance_ratio, self.charts.lift_scale[1]), "advance ratio")

    def _number_thrust(self, count: int, effective: float) -> float:
        thrusts, factors = self.charts.number_thrust
        return self.at(effective, (thrusts, factors[count]), "blade-number thrust")

    def _lift_thrust(self, count: int, scale: float, effective: float) -> float:
        x = effective * self._number_thrust(count, effective) * scale
        for row in self._lift_rows():
            coefficients, factors = (table[row] for table in self.charts.lift_thrust)
            if x < coefficients[1] and factors[0] > _STEEP * factors[1]:
                self.held.add("lift thrust")
        return self._by_lift(x, self.charts.lift_thrust, "lift thrust")


def _around(nodes: Floats, x: float) -> range:
    """The nodes that count at a point: itself, or the three or four around it."""
    k = int(np.searchsorted(nodes, x, side="right")) - 1
    return range(k, k + 1) if k >= 0 and nodes[k] == x else range(max(k - 1, 0), min(k + 3, len(nodes)))


def _rising(chart: tuple[Floats, Floats]) -> tuple[Floats, Floats]:
    """The chart from its smallest C_P on: below it the blade angle over C_P is not unique."""
    low = int(np.argmin(chart[0]))
    return chart[0][low:], chart[1][low:]


def parabola(x: Values, xs: Values, ys: Values) -> Values:
    """Return the parabola through three points at a place.

    Args:
        x: Where.
        xs: Of the points.
        ys: Of the points.
    """
    a, b, c = xs
    return plain(
        ys[0] * (x - b) * (x - c) / ((a - b) * (a - c))
        + ys[1] * (x - a) * (x - c) / ((b - a) * (b - c))
        + ys[2] * (x - a) * (x - b) / ((c - a) * (c - b))
    )


def _root(excess: Callable[[float], float], chart: float) -> float:
    from scipy.optimize import brentq

    if excess(_MOST_THRUST) <= 0.0:
        raise SolveError(f"propeller: no thrust coefficient up to {_MOST_THRUST:g} gives the chart's {chart:.4g}")
    return float(brentq(excess, 0.0, _MOST_THRUST, xtol=1e-12))


# ----------------------------------------------------------------------------------------------------------------------
# Blade angle and thrust of a propeller by the Hamilton Standard method, from its charts.
#
# The charts hold for an activity factor of 150 and an integrated design lift coefficient of 0.5; factors carry them to
# other blades. The charts themselves are data and are read by the catalogue.
# ----------------------------------------------------------------------------------------------------------------------


class Performance(NamedTuple):
    """A propeller at one advance ratio and power coefficient."""

    blade_angle: float
    """β at three quarters of the radius [rad]."""
    thrust_coefficient: float
    """C_T with compressibility [-]."""
    compressibility: float
    """Factor on the incompressible C_T [-]."""
    held: tuple[str, ...]
    """Tables that were left and held at their end, and laws that the point breaks; empty for a point to trust."""


def performance(
    charts: Charts, blades: Blades, advance_ratio: float, *, power_coefficient: float, mach: float = 0.0,
    tip_mach: float = 0.0,
) -> Performance:  # fmt: skip
    """Return blade angle and thrust coefficient of a propeller that takes a power.

    Args:
        charts: From the catalogue.
        blades: The propeller.
        advance_ratio: J = V/(n D) [-].
        power_coefficient: C_P = P/(ρ n³ D⁵) [-].
        mach: Flight Mach number [-].
        tip_mach: π n D over the speed of sound [-].

    Source: Worobel and Mayo, NASA CR-114399 (1971). The jump of the critical Mach number between standstill and
        motion is smoothed: the static excess fades out linearly until J = 0.5.

    Valid for: where `held` of the result is empty.

    Raises:
        SolveError: No thrust coefficient answers to the chart's value.
    """
    look = Look(charts, blades)
    if not 0.0 <= advance_ratio <= charts.advance_ratio[-1]:
        look.held.add("advance ratio")
        advance_ratio = min(max(advance_ratio, 0.0), float(charts.advance_ratio[-1]))
    angle, thrusts = look.incompressible(advance_ratio, power_coefficient)
    thrust = look.over_counts(thrusts)
    if not look.held:
        look.guard(advance_ratio, power_coefficient, thrust)
    factor = look.compressibility(advance_ratio, thrusts, mach=mach, tip_mach=tip_mach)
    return Performance(math.radians(angle), float(thrust * factor), float(factor), tuple(sorted(look.held)))


def compressibility(
    charts: Charts, blades: Blades, advance_ratio: float, *, thrust_coefficient: float, mach: float, tip_mach: float
) -> tuple[float, tuple[str, ...]]:
    """Return the factor of the air's compressibility on C_T [-], and the tables that were left.

    Args:
        charts: From the catalogue.
        blades: The propeller.
        advance_ratio: J = V/(n D) [-].
        thrust_coefficient: C_T without compressibility [-].
        mach: Flight Mach number [-].
        tip_mach: π n D over the speed of sound [-].

    Source: Worobel and Mayo, NASA CR-114399 (1971); as in `performance`.

    Valid for: where no table was left.
    """
    look = Look(charts, blades)
    thrusts = [thrust_coefficient] * len(look.counts)
    factor = look.compressibility(advance_ratio, thrusts, mach=mach, tip_mach=tip_mach)
    return float(factor), tuple(sorted(look.held))
