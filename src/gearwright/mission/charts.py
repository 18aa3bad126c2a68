"""Propeller maps over arrays of points: coefficients, blade angles, and the factor of compressibility."""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from gearwright.base import Bools, DesignError, Floats, Ints
from gearwright.catalogue.propeller_maps import ALL_STATES, MAPS, hamilton_standard_charts
from gearwright.machines import Blades, Charts, MachMap, PropellerMap, map_at
from gearwright.machines.propeller_charts import SAME_ANGLE, STATIC_FADE, Look, parabola

# ----------------------------------------------------------------------------------------------------------------------
# Propeller maps over arrays of points: coefficients, blade angles, and the factor of compressibility.
# ----------------------------------------------------------------------------------------------------------------------


_CHART_SLACK = 1e-9
"""A point on the edge of a map, but for rounding, is inside, as in `look_up` [-]."""


class Read(NamedTuple):
    """What is read of a chart at many points."""

    value: Floats
    """Shape (n,)."""
    outside: Bools
    """Where the chart does not reach, shape (n,)."""


class _Cell(NamedTuple):
    """Two rows of a map around points."""

    below: Ints
    """Row at the next smaller advance ratio, shape (n,)."""
    part: Floats
    """How far to the next one [-]."""
    low: Ints
    """First blade angle that both rows give."""
    high: Ints
    """Last one."""
    outside: Bools


def _cell(chart: PropellerMap, ratio: Floats) -> _Cell:
    known = chart.advance_ratio
    below = np.clip(np.searchsorted(known, ratio) - 1, 0, len(known) - 2)
    part = (ratio - known[below]) / (known[below + 1] - known[below])
    low = np.maximum(chart.first[below], chart.first[below + 1])
    high = np.minimum(chart.last[below], chart.last[below + 1])
    return _Cell(below, part, low, high, (ratio < known[0]) | (ratio > known[-1]))


def at_tips(
    chart: PropellerMap | MachMap, tip_mach: Floats, law: Callable[..., tuple[Any, ...]], *columns: Floats
) -> tuple[Any, ...]:
    """Return what a law reads of a map, or of the map at every Mach number of the tips.

    Args:
        chart: The map, or maps over the Mach number.
        tip_mach: Of the tips' rotation, shape (n,) [-].
        law: Of a map and columns; its last value tells what is outside.
        columns: Shape (n,) each.
    """
    if isinstance(chart, PropellerMap):
        return law(chart, *columns)
    known = [(tip_mach == tip, float(tip)) for tip in np.unique(tip_mach)]
    found: tuple[Any, ...] = ()
    beyond = np.zeros(len(tip_mach), bool)
    for lanes, tip in known:
        try:
            own = map_at(chart, tip)
        except DesignError:
            own, beyond[lanes] = chart.maps[-1], True
        values = law(own, *(column[lanes] for column in columns))
        found = found or tuple(np.zeros(len(tip_mach), value.dtype) for value in values)
        for column, value in zip(found, values, strict=True):
            column[lanes] = value
    return (*found[:-1], found[-1] | beyond)


def power_and_thrust(chart: PropellerMap, ratio: Floats, angle: Floats) -> tuple[Floats, Floats, Bools]:
    """Return C_P and C_T at many points of a map, and where it does not reach; each of shape (n,).

    Args:
        chart: The map.
        ratio: Advance ratios J, shape (n,) [-].
        angle: Blade angles β, shape (n,) [rad].

    Source: `look_up`.
    """
    cell, angles = _cell(chart, ratio), chart.blade_angle
    k = np.clip(np.searchsorted(angles, angle) - 1, 0, len(angles) - 2)
    j, i = np.minimum(np.maximum(k, cell.low), cell.high - 1), cell.below
    u, v = cell.part, (angle - angles[j]) / (angles[j + 1] - angles[j])
    outside = ~((u >= -_CHART_SLACK) & (u <= 1.0 + _CHART_SLACK) & (v >= -_CHART_SLACK) & (v <= 1.0 + _CHART_SLACK))
    u, v = np.clip(u, 0.0, 1.0), np.clip(v, 0.0, 1.0)
    weights = ((1.0 - u) * (1.0 - v), (1.0 - u) * v, u * (1.0 - v), u * v)
    corners = ((i, j), (i, j + 1), (i + 1, j), (i + 1, j + 1))
    power, thrust = (
        sum((weight * table[corner] for weight, corner in zip(weights, corners, strict=True)), np.zeros(len(ratio)))
        for table in (chart.power, chart.thrust)
    )
    return power, thrust, outside


def angle_along(chart: PropellerMap, ratio: Floats, wanted: Floats, table: Floats) -> Read:
    """Return the blade angles at which a propeller has a coefficient [rad].

    Args:
        chart: The map.
        ratio: Advance ratios J, shape (n,) [-].
        wanted: Coefficients, shape (n,) [-].
        table: Of the map: `power` or `thrust`.

    Source: `angle_for_power`: the rise of the row at J that spans most, inverted.
    """
    cell, angles = _cell(chart, ratio), chart.blade_angle
    start, end = _rises(chart, table, cell)

    def value(k: Ints) -> Floats:
        return np.asarray((1.0 - cell.part) * table[cell.below, k] + cell.part * table[cell.below + 1, k])

    above, beyond = start, end + 1
    for _ in range(int(table.shape[1]).bit_length()):  # the first angle of the rise at which there is more
        middle = np.minimum((above + beyond) // 2, end)
        less, going = value(middle) <= wanted, above < beyond
        above, beyond = np.where(less & going, middle + 1, above), np.where(less | ~going, beyond, middle)
    k = start + np.clip(above - start - 1, 0, np.maximum(end - start - 1, 0))
    after, low = np.minimum(k + 1, table.shape[1] - 1), value(k)
    with np.errstate(invalid="ignore", divide="ignore"):
        slope = (angles[after] - angles[k]) / (value(after) - low)
    outside = cell.outside | ~((value(start) <= wanted) & (wanted <= value(end))) | (end <= start)
    return Read(np.where(outside, angles[start], slope * (wanted - low) + angles[k]), outside)


def governs_along(chart: PropellerMap, ratio: Floats, angle: Floats) -> Bools:
    """Tell where a coarser pitch takes more power.

    Args:
        chart: The map.
        ratio: Advance ratios J, shape (n,) [-].
        angle: Blade angles, shape (n,) [rad].

    Source: `governs`.
    """
    start, end = _rises(chart, chart.power, _cell(chart, ratio))
    least, most = chart.blade_angle[start], chart.blade_angle[end]
    return np.asarray((least - SAME_ANGLE <= angle) & (angle <= most + SAME_ANGLE))


def _rises(chart: PropellerMap, table: Floats, cell: _Cell) -> tuple[Ints, Ints]:
    """Return first and last angle of the rise that spans most, of the rows at points between two rows of a map.

    Where both rows rise at the same angles and most in the same rise, so do all between them.
    """
    nodes = _cell(chart, chart.advance_ratio[1:])
    ends = [_rise(row, nodes.low, nodes.high) for row in (table[:-1], table[1:])]
    alike = (ends[0][0] == ends[1][0]) & (ends[0][1] == ends[1][1]) & (ends[0][2] == ends[1][2]).all(axis=1)
    start, end = ends[0][0][cell.below], ends[0][1][cell.below]
    others = np.flatnonzero(~alike[cell.below])
    if len(others):
        below, u = cell.below[others], cell.part[others, None]
        row = (1.0 - u) * table[below] + u * table[below + 1]
        start[others], end[others], _ = _rise(row, cell.low[others], cell.high[others])
    return start, end


def _rise(row: Floats, low: Ints, high: Ints) -> tuple[Ints, Ints, Bools]:
    """Return first and last angle of the rise that spans most, and where rises start, of many rows."""
    place = np.arange(row.shape[1])
    given = (place >= low[:, None]) & (place <= high[:, None])
    starts = np.ones_like(given)
    starts[:, 1:] = ~(given[:, 1:] & given[:, :-1] & (row[:, 1:] > row[:, :-1]))
    first = np.maximum.accumulate(np.where(starts, place, 0), axis=1)
    end = np.argmax(np.where(given, row - np.take_along_axis(row, first, axis=1), -1.0), axis=1)
    return first[np.arange(len(row)), end], end, starts


def squeezed_along(name: str, ratio: Floats, thrust: Floats, *, mach: Floats, tip_mach: Floats) -> Read:
    """Return the factors of compressibility on the thrust of a map [-].

    Args:
        name: Of the map.
        ratio: Advance ratios J, shape (n,) [-].
        thrust: C_T without compressibility, shape (n,) [-].
        mach: Of the flight, shape (n,) [-].
        tip_mach: Of the tips' rotation, shape (n,) [-].

    Source: `compressed`.
    """
    blades, charts = MAPS.get(ALL_STATES.get(name, name)), hamilton_standard_charts()
    factor, outside = np.ones(len(ratio)), np.zeros(len(ratio), bool)
    if blades is None:
        return Read(factor, outside)
    look = Look(charts, blades)
    reach = (ratio >= 0.0) & (ratio <= charts.advance_ratio[-1])
    held = np.clip(ratio, 0.0, charts.advance_ratio[-1])
    machs = [_excess(charts, row, held, (mach, tip_mach)) for row in look._lift_rows()]
    counts = (thrust > 0.0) & (np.max([over.value for over in machs], axis=0) > 0.0)
    outside |= (thrust > 0.0) & (~reach | np.any([over.outside for over in machs], axis=0))
    if counts.any():
        over = [excess.value[counts] for excess in machs]
        found = _factor(charts, blades, held[counts], (thrust[counts], over))
        factor[counts], outside[counts] = found.value, outside[counts] | found.outside
    return Read(factor, outside)


def _excess(charts: Charts, row: int, ratio: Floats, machs: tuple[Floats, Floats]) -> Read:
    known, flight, static = charts.critical_mach
    moving, (mach, tip) = _at(ratio, known, flight[row]), machs
    fade = np.maximum(1.0 - ratio / STATIC_FADE, 0.0)
    over = np.maximum(np.where(ratio > 0.0, mach - moving.value, 0.0), fade * (tip - static[row]))
    return Read(over, moving.outside)


def _factor(charts: Charts, blades: Blades, ratio: Floats, squeezed: tuple[Floats, list[Floats]]) -> Read:
    """Return the factors where there is an excess of Mach number."""
    look, (thrust, excess) = Look(charts, blades), squeezed
    ends = [look.at(blades.activity_factor, (charts.activity_factor, row), "") for row in charts.activity_thrust]
    activity = ends[0] + (ends[1] - ends[0]) * np.minimum(ratio / 0.5, 1.0)
    scale = _at(ratio, charts.advance_ratio, charts.lift_scale[1])
    outside, factors = scale.outside, []
    machs, thrusts, table = charts.compressibility
    for count in look.counts:
        number = _at(thrust * activity, charts.number_thrust[0], charts.number_thrust[1][count])
        effective, by_lift = thrust * activity * number.value, []
        outside = outside | number.outside
        for row, over in zip(look._lift_rows(), excess, strict=True):
            lift = _at(effective * scale.value, charts.lift_thrust[0][row], charts.lift_thrust[1][row])
            lifted = effective * lift.value
            lines = [_at(lifted, thrusts, line) for line in table]
            large = lifted >= thrusts[0]
            left = np.any([line.outside for line in lines], axis=0)
            found = _at(over, machs, np.stack([line.value for line in lines], axis=1))
            outside = outside | lift.outside | (large & left) | ((over > 0.0) & found.outside)
            by_lift.append(np.where(over > 0.0, found.value, 1.0))
        factors.append(_over(charts.lift, blades.design_lift, by_lift, look._lift_rows()))
    return Read(np.minimum(_over(charts.blade_counts, blades.number, factors, look.counts), 1.0), outside)


def _over(nodes: Floats, x: float, values: list[Floats], around: range) -> Floats:
    """Return values between those at the nodes around a point."""
    if len(values) == 1:
        return values[0]
    return _at(np.full(len(values[0]), x), nodes[around.start : around.stop], np.stack(values, axis=1)).value


def _at(x: Floats, xs: Floats, ys: Floats) -> Read:
    """Return y(x) as `Look.at` does; ys has shape (m,), or (n, m) where it differs from point to point."""
    table = np.broadcast_to(ys, (len(x), len(xs)))
    inside = np.clip(x, xs[0], xs[-1])
    flat = np.where(x < xs[0], table[:, 0] == table[:, 1], table[:, -1] == table[:, -2])
    k = np.clip(np.searchsorted(xs, inside, side="right") - 1, 0, len(xs) - 2)
    edge = (k == 0) | (k == len(xs) - 2)
    first = np.where(k == 0, 0, np.where(edge, len(xs) - 3, k - 1))
    weight = np.where(edge, 0.0, (inside - xs[k]) / (xs[k + 1] - xs[k]))
    left, right = (_through(inside, xs, table, start) for start in (first, np.where(edge, first, k)))
    return Read((1.0 - weight) * left + weight * right, (inside != x) & ~flat)


def _through(x: Floats, xs: Floats, table: Floats, first: Ints) -> Floats:
    lanes = np.arange(len(x))
    nodes = [xs[first + place] for place in range(3)]
    return np.asarray(parabola(x, nodes, [table[lanes, first + place] for place in range(3)]))
