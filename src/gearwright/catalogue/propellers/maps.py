"""Propeller maps as CSV files: read, checked, written."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from gearwright.errors import DesignError, Problem
from gearwright.machines import MachMap, PropellerMap
from gearwright.reading import numbers_of, text_of

LARGEST_MAP = 20_000_000
"""Largest file of a map that is read [bytes]: a dozen Mach numbers of a fine map."""
TIP_MACH = "tip_mach"
"""Column of a map over the Mach number of the tips' rotation, which a file may leave out."""
COLUMNS = ("advance_ratio", "blade_angle_deg", "power_coefficient", "thrust_coefficient")
"""What a map's CSV file has: every advance ratio with a run of blade angles from one common list."""
_SENSIBLE: Mapping[str, tuple[float, float]] = {
    TIP_MACH: (0.0, 1.5),
    "advance_ratio": (0.0, 20.0),
    "blade_angle_deg": (-90.0, 90.0),
    "power_coefficient": (-20.0, 20.0),
    "thrust_coefficient": (-20.0, 20.0),
}
"""Column -> range of what a propeller can have, several times beyond every chart."""
_AXES = ("advance ratios", "blade angles")
MOST_POINTS = 250_000
"""Advance ratios times blade angles that a map may have."""


def read_propeller_map(path: str | Path) -> PropellerMap | MachMap:
    """Return a propeller map from a CSV file, or one over the Mach number where the file has a column tip_mach.

    Args:
        path: Of the file, with the columns advance_ratio, blade_angle_deg, power_coefficient, thrust_coefficient.

    Raises:
        DesignError: The file is missing or is no such map; with the line.
    """
    text = text_of(path, "propeller_map", largest=LARGEST_MAP)
    if TIP_MACH not in text.partition("\n")[0].split(","):
        return map_of(text, str(path))
    points = _points(text, str(path), (TIP_MACH, *COLUMNS))
    machs = sorted({point[0] for point in points})
    maps = tuple(
        _map_of([point[1:] for point in points if point[0] == mach], f"{path}: tip Mach {mach:g}") for mach in machs
    )
    for mach, chart in zip(machs, maps, strict=True):
        for axis in (0, 1):
            if not np.array_equal(chart[axis], maps[0][axis]):
                raise _unusable(str(path), f"tip Mach {mach:g} has other {_AXES[axis]} than tip Mach {machs[0]:g}")
    return MachMap(np.array(machs), maps)


def map_of(text: str, source: str) -> PropellerMap:
    """Return the propeller map of a CSV text.

    Args:
        text: Lines of J, β [deg], C_P, C_T under their names, in any order.
        source: Name for messages.

    Raises:
        DesignError: Columns are missing, a number is none, a row has gaps, or fewer than two by two points.
    """
    return _map_of(_points(text, source, COLUMNS), source)


def _map_of(points: list[list[float]], source: str) -> PropellerMap:
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


def _points(text: str, source: str, columns: tuple[str, ...]) -> list[list[float]]:
    try:
        points = numbers_of(text, columns)
    except ValueError as error:
        raise _unusable(source, str(error)) from None
    for line, point in enumerate(points, start=2):
        for value, name in zip(point, columns, strict=True):
            low, high = _SENSIBLE[name]
            if not low <= value <= high:
                raise _unusable(source, f"line {line}: {name} is not from {low:g} to {high:g}")
    return points


def _unusable(source: str, reason: str) -> DesignError:
    return DesignError([Problem("propeller_map", f"{source}: {reason}")])


def map_text(chart: PropellerMap | MachMap) -> str:
    """Return a propeller map as the text of a CSV file, to be read by `read_propeller_map`.

    Args:
        chart: The map, or maps over the Mach number.
    """
    if isinstance(chart, PropellerMap):
        return "\n".join([",".join(COLUMNS), *_lines(chart)]) + "\n"
    lines = [f"{mach:g},{line}" for mach, one in zip(chart.tip_mach, chart.maps, strict=True) for line in _lines(one)]
    return "\n".join([",".join((TIP_MACH, *COLUMNS)), *lines]) + "\n"


def _lines(chart: PropellerMap) -> list[str]:
    return [
        f"{ratio:g},{math.degrees(angle):.6g},{chart.power[row, column]:.6f},{chart.thrust[row, column]:.6f}"
        for row, ratio in enumerate(chart.advance_ratio)
        for column, angle in enumerate(chart.blade_angle)
        if chart.first[row] <= column <= chart.last[row]
    ]
