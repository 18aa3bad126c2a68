"""Blade angle and thrust of a propeller by the Hamilton Standard method, from its charts."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from gearwright.base import Floats, SolveError
from gearwright.elementwise import Values, plain

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
    if k >= 0 and nodes[k] == x:
        return range(k, k + 1)
    return range(max(k - 1, 0), min(k + 3, len(nodes)))


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
