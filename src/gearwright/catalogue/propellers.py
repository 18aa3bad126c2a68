"""Propeller charts and maps: the Hamilton Standard charts, maps made from them, and a reader of the user's own."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping
from functools import cache
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np

from gearwright.catalogue.tables import data_text
from gearwright.errors import DesignError, Problem, SolveError, near
from gearwright.machines import SMALL_THRUST, Blades, Charts, PropellerMap, compressibility, performance
from gearwright.machines.propellers import continued, generic_blade
from gearwright.reading import numbers_of, text_of

MAPS: Mapping[str, Blades] = {
    "6-blades-af115": Blades(6, 115.0, 0.5),
    "4-blades-af114": Blades(4, 114.0, 0.5),
}
"""Shipped maps by name -> blades; activity factor and lift are assumptions for a propeller of the ATR 72's class."""
ALL_STATES: Mapping[str, str] = {f"{name}-all-states": name for name in MAPS}
"""Maps that blade elements carry on to windmilling, feather and reverse -> the shipped map that they carry on."""
STATE_RATIOS = np.array([4.5, 5.0, 5.5, 6.0])
"""Advance ratios of these maps beyond the charts' [-]."""
STATE_ANGLES = np.radians(np.arange(-30.0, 90.5, 3.0))
"""Blade angles of these maps beside the charts' [rad]."""
_THINNED = 2
"""Every how many of a chart's advance ratios and blade angles stand in the map that carries it on."""
COLUMNS = ("advance_ratio", "blade_angle_deg", "power_coefficient", "thrust_coefficient")
"""What a map's CSV file has: every advance ratio with a run of blade angles from one common list."""
_SENSIBLE: Mapping[str, tuple[float, float]] = {
    "advance_ratio": (0.0, 20.0),
    "blade_angle_deg": (-90.0, 90.0),
    "power_coefficient": (-20.0, 20.0),
    "thrust_coefficient": (-20.0, 20.0),
}
"""Column -> range of what a propeller can have, several times beyond every chart."""
MOST_POINTS = 250_000
"""Advance ratios times blade angles that a map may have."""


@cache
def hamilton_standard_charts() -> Charts:
    """Return the charts of NASA CR-114399, with two misprints read as their file says."""
    raw = json.loads(data_text("hamilton_standard.json"))
    for correction in raw["corrections"]:
        *path, last = correction["place"]
        table = raw
        for part in path:
            table = table[part]
        table[last] = correction["read_as"]
    return _charts(raw)


def _charts(raw: Mapping[str, Any]) -> Charts:
    number, lift, squeeze, activity = raw["blade_number"], raw["lift"], raw["compressibility"], raw["activity_factor"]
    return Charts(
        blade_counts=np.array(raw["blade_counts"], dtype=float),
        advance_ratio=np.array(raw["advance_ratio"], dtype=float),
        blade_angle=_rows(raw["blade_angle_deg"]),
        power=tuple(_rows(rows) for rows in raw["power_coefficient"]),
        thrust=tuple(_rows(rows) for rows in raw["thrust_coefficient"]),
        activity_factor=np.array(activity["activity_factor"]),
        activity_power=np.array(activity["power_at_J0_and_J_half_and_above"]),
        activity_thrust=np.array(activity["thrust_at_J0_and_J_half_and_above"]),
        number_power=(
            np.array(number["effective_power_coefficient"]),
            np.array(number["power_factor_by_blade_count"]),
        ),
        number_thrust=(
            np.array(number["effective_thrust_coefficient"]),
            np.array(number["thrust_factor_by_blade_count"]),
        ),
        lift=np.array(lift["integrated_design_lift"]),
        lift_power=(_rows(lift["power_coefficient"]), _rows(lift["power_factor"])),
        lift_thrust=(_rows(lift["thrust_coefficient"]), _rows(lift["thrust_factor"])),
        lift_scale=np.array([lift["power_scale_by_advance_ratio"], lift["thrust_scale_by_advance_ratio"]]),
        critical_mach=(
            np.array(squeeze["advance_ratio"]),
            np.array(squeeze["critical_flight_mach_by_lift"]),
            np.array(squeeze["critical_tip_mach_static_by_lift"]),
        ),
        compressibility=(
            np.array(squeeze["excess_mach"]),
            np.array(squeeze["effective_thrust_coefficient"]),
            np.array(squeeze["factor"]),
        ),
    )


def _rows(lists: Iterable[list[float]]) -> tuple[np.ndarray[Any, np.dtype[np.float64]], ...]:
    return tuple(np.array(row, dtype=float) for row in lists)


@cache
def propeller_map(name: str) -> PropellerMap:
    """Return a shipped propeller map.

    Args:
        name: Such as ``6-blades-af115``, which ends with the charts at positive thrust, or
            ``6-blades-af115-all-states``, which blade elements carry on.

    Raises:
        DesignError: There is none of this name; with the nearest one.
    """
    known = [*MAPS, *ALL_STATES]
    if name not in known:
        raise DesignError([Problem("propeller_map", f"there is no shipped map {name!r}; {near(name, known)}")])
    return map_of(data_text(f"propeller_{name}.csv"), name)


def compressed(name: str, advance_ratio: float, thrust_coefficient: float, *, mach: float, tip_mach: float) -> float:
    """Return the factor of the air's compressibility on the thrust of a propeller map [-].

    Args:
        name: Of a shipped map; a map of the user's own stays as it is: 1.
        advance_ratio: J [-].
        thrust_coefficient: C_T of the map [-].
        mach: Flight Mach number [-].
        tip_mach: π n D over the speed of sound [-].

    Source: Worobel and Mayo, NASA CR-114399 (1971).

    Raises:
        DesignError: The charts do not hold the Mach number.
    """
    name = ALL_STATES.get(name, name)
    if name not in MAPS or thrust_coefficient <= 0.0:
        return 1.0
    factor, left = compressibility(
        hamilton_standard_charts(),
        MAPS[name],
        advance_ratio,
        thrust_coefficient=thrust_coefficient,
        mach=mach,
        tip_mach=tip_mach,
    )
    outside = [table for table in left if table != SMALL_THRUST]
    if outside:
        message = (
            f"Mach {mach:.3f}, {tip_mach:.3f} at the tips, at advance ratio {advance_ratio:.3g} lies outside the charts"
            f" ({', '.join(outside)}); fly slower, turn slower, or give a map of your own"
        )
        raise DesignError([Problem("propeller.map", message)])
    return factor


def read_propeller_map(path: str | Path) -> PropellerMap:
    """Return a propeller map from a CSV file.

    Args:
        path: Of the file, with the columns advance_ratio, blade_angle_deg, power_coefficient, thrust_coefficient.

    Raises:
        DesignError: The file is missing or is no such map; with the line.
    """
    return map_of(text_of(path, "propeller_map"), str(path))


def map_of(text: str, source: str) -> PropellerMap:
    """Return the propeller map of a CSV text.

    Args:
        text: Lines of J, β [deg], C_P, C_T under their names, in any order.
        source: Name for messages.

    Raises:
        DesignError: Columns are missing, a number is none, a row has gaps, or fewer than two by two points.
    """
    points = _points(text, source)
    ratios = np.array(sorted({point[0] for point in points}))
    angles = np.array(sorted({point[1] for point in points}))
    if len(ratios) < 2 or len(angles) < 2:
        raise _unusable(source, "it needs at least two advance ratios and two blade angles")
    shape = (len(ratios), len(angles))
    if len(ratios) * len(angles) > MOST_POINTS:
        count = f"{len(ratios):,} advance ratios by {len(angles):,} blade angles"
        raise _unusable(source, f"{count} are more than {MOST_POINTS:,} points; take fewer from one common list")
    power, thrust, known = np.zeros(shape), np.zeros(shape), np.zeros(shape, dtype=bool)
    for ratio, angle, *values in points:
        cell = (int(np.searchsorted(ratios, ratio)), int(np.searchsorted(angles, angle)))
        if known[cell]:
            raise _unusable(source, f"advance ratio {ratio:g}, blade angle {angle:g}° is given twice")
        (power[cell], thrust[cell]), known[cell] = values, True
    first, last = known.argmax(axis=1), shape[1] - 1 - known[:, ::-1].argmax(axis=1)
    for k, ratio in enumerate(ratios):
        if known[k].sum() != last[k] - first[k] + 1:
            raise _unusable(source, f"advance ratio {ratio:g} has a gap between its blade angles")
        if k and min(last[k], last[k - 1]) <= max(first[k], first[k - 1]):
            raise _unusable(source, f"advance ratio {ratio:g} shares less than two blade angles with the one before")
    return PropellerMap(ratios, np.radians(angles), power, thrust, first, last)


def _points(text: str, source: str) -> list[list[float]]:
    try:
        points = numbers_of(text, COLUMNS)
    except ValueError as error:
        raise _unusable(source, str(error)) from None
    for line, point in enumerate(points, start=2):
        for value, name in zip(point, COLUMNS, strict=True):
            low, high = _SENSIBLE[name]
            if not low <= value <= high:
                raise _unusable(source, f"line {line}: {name} is not from {low:g} to {high:g}")
    return points


def _unusable(source: str, reason: str) -> DesignError:
    return DesignError([Problem("propeller_map", f"{source}: {reason}")])


def charted_point(blades: Blades, advance_ratio: float, blade_angle: float) -> tuple[float, float] | None:
    """Return C_P and C_T by the Hamilton Standard method at a blade angle, without compressibility.

    Args:
        blades: The propeller.
        advance_ratio: J [-].
        blade_angle: β at three quarters of the radius [rad].

    Returns:
        C_P and C_T [-], or None where the charts do not hold the point.
    """
    from scipy.optimize import brentq

    charts = hamilton_standard_charts()

    def excess(power: float) -> float:
        return performance(charts, blades, advance_ratio, power_coefficient=power).blade_angle - blade_angle

    low, high = 0.005, 3.0
    try:
        if excess(low) > 0.0 or excess(high) < 0.0:
            return None
        power = float(brentq(excess, low, high, xtol=1e-10))
        point = performance(charts, blades, advance_ratio, power_coefficient=power)
    except SolveError:
        return None
    if point.held or point.thrust_coefficient <= 0.0 or abs(excess(power)) > 1e-7:
        return None
    return power, point.thrust_coefficient


def charted_map(blades: Blades, advance_ratios: Iterable[float], blade_angles: Iterable[float]) -> str:
    """Return a propeller map by the Hamilton Standard method as the text of a CSV file.

    Args:
        blades: The propeller.
        advance_ratios: J [-].
        blade_angles: β at three quarters of the radius [deg].

    Source: Worobel and Mayo, NASA CR-114399 (1971); points that the charts do not hold are left out.
    """
    lines = [
        f"{ratio:g},{angle:g},{point[0]:.6f},{point[1]:.6f}"
        for ratio, angle in product(advance_ratios, blade_angles)
        if (point := charted_point(blades, ratio, math.radians(angle))) is not None
    ]
    return "\n".join([",".join(COLUMNS), *lines]) + "\n"


def carried_on(name: str) -> PropellerMap:
    """Return a shipped map in every state: every second of its points, carried on by a generic blade's elements.

    Args:
        name: Of a map that ends with the charts, such as ``6-blades-af115``.

    Source: `machines.propellers.continued`; the maps of `ALL_STATES` are made so.
    """
    chart, step = propeller_map(name), _THINNED
    first = -(-chart.first // step)
    thin = PropellerMap(
        chart.advance_ratio[::step],
        chart.blade_angle[::step],
        chart.power[::step, ::step],
        chart.thrust[::step, ::step],
        first[::step],
        (chart.last // step)[::step],
    )
    return continued(thin, generic_blade(MAPS[name]), STATE_RATIOS, STATE_ANGLES)


def map_text(chart: PropellerMap) -> str:
    """Return a propeller map as the text of a CSV file, to be read by `map_of`.

    Args:
        chart: The map.
    """
    lines = [
        f"{ratio:g},{math.degrees(angle):.6g},{chart.power[row, column]:.6f},{chart.thrust[row, column]:.6f}"
        for row, ratio in enumerate(chart.advance_ratio)
        for column, angle in enumerate(chart.blade_angle)
        if chart.first[row] <= column <= chart.last[row]
    ]
    return "\n".join([",".join(COLUMNS), *lines]) + "\n"
