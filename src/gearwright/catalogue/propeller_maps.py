"""Propeller maps and blade files: supplied data, CSV files, and maps computed from charts or blades."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import pairwise, product
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np

from gearwright.base import (
    Angle,
    DesignError,
    Floats,
    Origin,
    Problem,
    Quantity,
    Ratio,
    Shown,
    SolveError,
    near,
    refuse,
    verb,
)
from gearwright.catalogue.tables import data_text
from gearwright.files import numbers_of, text_of
from gearwright.machines import SMALL_THRUST, Blades, Charts, MachMap, PropellerMap, compressibility, performance
from gearwright.machines.propellers import BladeShape, Feathered, continued, element_map, feathered, generic_blade

# ----------------------------------------------------------------------------------------------------------------------
# Propeller maps as CSV files: read, checked, written.
# ----------------------------------------------------------------------------------------------------------------------


LARGEST_MAP = 20_000_000
"""Largest file of a map that is read [bytes]: a dozen Mach numbers of a fine map."""
TIP_MACH = "tip_mach"
"""Column of a map over the Mach number of the tips' rotation, which a file may leave out."""
COLUMNS = ("advance_ratio", "blade_angle_deg", "power_coefficient", "thrust_coefficient")
"""What a map's CSV file has: every advance ratio with a run of blade angles from one common list."""
_SENSIBLE_MAP: Mapping[str, tuple[float, float]] = {
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
            low, high = _SENSIBLE_MAP[name]
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


# ----------------------------------------------------------------------------------------------------------------------
# The Hamilton Standard charts from their data file, and what they say of a propeller at a blade angle.
# ----------------------------------------------------------------------------------------------------------------------


_CHARTED: tuple[tuple[str, float, float], ...] = (
    ("number", 2, 8), ("activity_factor", 80.0, 200.0), ("design_lift", 0.3, 0.8)
)  # fmt: skip
"""What the charts know of blades."""


def charted_problems(blades: Blades | BladeShape) -> list[Problem]:
    """Return why the charts say nothing of a propeller.

    Args:
        blades: The propeller.
    """
    if not isinstance(blades, Blades):
        return [Problem("by", "charts know no stations of a blade; give activity factor and design lift")]
    return spanned(blades, _CHARTED)


def spanned(blades: Blades | BladeShape, spans: Iterable[tuple[str, float, float]]) -> list[Problem]:
    """Return what of generic blades lies outside its span.

    Args:
        blades: The propeller.
        spans: Name, least and most.
    """
    given = spans if isinstance(blades, Blades) else ()
    values = [(name, getattr(blades, name), low, high) for name, low, high in given]
    return [
        Problem(f"blades.{name}", f"{value:g}: give {low:g} to {high:g}, or a blade file")
        for name, value, low, high in values
        if not low <= value <= high
    ]


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


# ----------------------------------------------------------------------------------------------------------------------
# Propeller maps that come with gearwright, and the air's compressibility on their thrust.
# ----------------------------------------------------------------------------------------------------------------------


MAPS: Mapping[str, Blades] = {
    "6-blades-af115": Blades(6, 115.0, 0.5),
    "4-blades-af114": Blades(4, 114.0, 0.5),
}
"""Shipped maps by name -> blades; activity factor and lift are assumptions for a propeller of the ATR 72's class."""
ALL_STATES: Mapping[str, str] = {f"{name}-all-states": name for name in MAPS}
"""Maps that blade elements carry on to windmilling, feather and reverse -> the shipped map that they carry on."""


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


# ----------------------------------------------------------------------------------------------------------------------
# Blades from a CSV file: chord and angle over the radius, with what a file may say of sections.
# ----------------------------------------------------------------------------------------------------------------------


STATIONS = ("radius_ratio", "chord_ratio", "blade_angle_deg")
"""What every row of a blade file has: r/R, c/R, and the angle of the chord to the plane of turning."""
SECTIONS: Mapping[str, float] = {"design_lift": 0.5, "thickness_ratio": 0.1}
"""What it may have beside them, and what counts where it has not; assumptions of a usual blade."""
_SENSIBLE_BLADE: Mapping[str, tuple[float, float]] = {
    "radius_ratio": (0.02, 1.0),
    "chord_ratio": (0.0, 2.0),
    "blade_angle_deg": (-90.0, 120.0),
    "design_lift": (-1.0, 1.5),
    "thickness_ratio": (0.01, 1.0),
}
"""Column -> range of what a blade can have."""
FEWEST = 5
"""Stations that say how a blade is made, at least."""
OUTERMOST = 0.75
"""Radius ratio that the stations must reach: where the blade angle is told [-]."""
ELEMENTS = 30
"""Elements of equal width into which blades are cut."""
MOST_BLADES = 12


@verb
def read_blades(path: str | Path, number: int) -> BladeShape:
    """Return the blades of a propeller from a CSV file of stations.

    Args:
        path: Of the file: columns radius_ratio, chord_ratio (over the tip radius), blade_angle_deg, and perhaps
            design_lift (0.5 if left out) and thickness_ratio (0.1).
        number: Of blades [-].

    Source: between stations linear; the tip has the last one's angle and, where no station is at 1, its chord.

    Raises:
        DesignError: The file is missing or holds no such blade, with all that is wrong.
    """
    text = text_of(path, "blades")
    head = [word.strip() for word in text.partition("\n")[0].split(",")]
    columns = (*STATIONS, *(name for name in SECTIONS if name in head))
    try:
        rows = numbers_of(text, columns)
    except ValueError as error:
        refuse([Problem("blades", str(error))], str(path))
        raise
    problems = [*_wrong_cells(rows, columns), *_wrong_stations([row[0] for row in rows])]
    if not 1 < number <= MOST_BLADES:
        problems.append(Problem("number", f"{number} blades: give 2 to {MOST_BLADES}"))
    refuse(problems, str(path))
    table = {name: np.array([row[k] for row in rows]) for k, name in enumerate(columns)}
    return _shape(number, table)


def _wrong_cells(rows: list[list[float]], columns: tuple[str, ...]) -> list[Problem]:
    return [
        Problem(f"blades.line {line}", f"{name} {value:g} is not from {low:g} to {high:g}")
        for line, row in enumerate(rows, start=2)
        for name, value in zip(columns, row, strict=True)
        for low, high in (_SENSIBLE_BLADE[name],)
        if not low <= value <= high
    ]


def _wrong_stations(radii: list[float]) -> list[Problem]:
    problems = []
    if len(radii) < FEWEST:
        problems.append(Problem("blades", f"{len(radii)} stations: give at least {FEWEST}"))
    for line, (inner, outer) in enumerate(pairwise(radii), start=3):
        if outer <= inner:
            problems.append(Problem(f"blades.line {line}", f"radius_ratio {outer:g} does not rise beyond {inner:g}"))
    if radii and max(radii) < OUTERMOST:
        problems.append(Problem("blades", f"stations end at {max(radii):g} of the radius; go on to {OUTERMOST:g}"))
    return problems


def _shape(number: int, table: Mapping[str, Floats]) -> BladeShape:
    known = table["radius_ratio"]
    edges = np.linspace(min(float(known[0]), 0.5), 1.0, ELEMENTS + 1)
    radius = 0.5 * (edges[1:] + edges[:-1])

    def along(name: str) -> Floats:
        return np.interp(radius, known, table[name]) if name in table else np.full(ELEMENTS, SECTIONS[name])

    angle = np.radians(table["blade_angle_deg"])
    return BladeShape(
        number=number,
        radius=radius,
        width=np.diff(edges),
        chord=np.maximum(along("chord_ratio"), 1e-4),
        twist=np.interp(radius, known, angle) - float(np.interp(OUTERMOST, known, angle)),
        design_lift=along("design_lift"),
        thickness=along("thickness_ratio"),
        hub=float(edges[0]),
    )


# ----------------------------------------------------------------------------------------------------------------------
# Propeller maps that are made: by the charts, by blade elements, or the charts carried on by elements.
# ----------------------------------------------------------------------------------------------------------------------


STATE_RATIOS = np.array([4.5, 5.0, 5.5, 6.0])
"""Advance ratios of these maps beyond the charts' [-]."""
STATE_ANGLES = np.radians(np.arange(-30.0, 90.5, 3.0))
"""Blade angles of these maps beside the charts' [rad]."""
_THINNED = 2
"""Every how many of a chart's advance ratios and blade angles stand in the map that carries it on."""
RATIOS = tuple(round(0.1 * k, 1) for k in range(41))
"""Advance ratios of a map where none are asked for [-]."""
ANGLES = tuple(math.radians(angle) for angle in range(-30, 91, 2))
"""Blade angles of it [rad]."""
_GENERIC: tuple[tuple[str, float, float], ...] = (
    ("number", 2, 12), ("activity_factor", 50.0, 250.0), ("design_lift", 0.0, 0.9)
)  # fmt: skip
"""What a generic blade is made for."""

_COEFFICIENT = Quantity("number")


@dataclass(frozen=True)
class RatioRow:
    """A made propeller at one advance ratio."""

    tip_mach: Ratio
    """π n D over the speed of sound; 0: without compressibility."""
    advance_ratio: Ratio
    """J = V/(n D)."""
    best_angle: Angle
    """Blade angle of the best efficiency; at standstill that of the most thrust for its power, C_T^1.5/C_P."""
    power_coefficient: Annotated[float, _COEFFICIENT, Origin("P/(ρ n³ D⁵)", "definition")]
    """There."""
    thrust_coefficient: Annotated[float, _COEFFICIENT, Origin("T/(ρ n² D⁴)", "definition")]
    """There."""
    efficiency: Annotated[Ratio, Origin("J C_T/C_P", "definition")]
    """There."""
    windmilling_angle: Annotated[float | None, Quantity("angle")]
    """Blade angle above which the air no longer drives them (C_P = 0); none where they always take power."""
    windmilling_thrust: Annotated[float | None, _COEFFICIENT]
    """C_T at it: the drag of a propeller that turns by itself."""


@dataclass(frozen=True, repr=False)
class MadePropeller(Shown):
    """A propeller map that was made, and of what."""

    by: str
    """``elements`` or ``charts``."""
    blades: BladeShape | None
    """Of the elements; none of the charts."""
    chart: PropellerMap | MachMap
    """The map, or one for each Mach number of the tips."""

    @property
    def maps(self) -> tuple[tuple[float, PropellerMap], ...]:
        """Mach number of the tips and map of each."""
        if isinstance(self.chart, PropellerMap):
            return ((0.0, self.chart),)
        return tuple(zip(self.chart.tip_mach.tolist(), self.chart.maps, strict=True))

    @property
    def feather(self) -> Feathered | None:
        """Where it stands still, and what it drags there; None of charts, and of blades that always turn."""
        return None if self.blades is None else feathered(self.blades)

    @property
    def rows(self) -> tuple[RatioRow, ...]:
        """What it does at every advance ratio."""
        rows = (_row(mach, chart, row) for mach, chart in self.maps for row in range(len(chart.advance_ratio)))
        return tuple(row for row in rows if row is not None)


@verb
def propeller(
    blades: Blades | BladeShape,
    *,
    advance_ratios: Sequence[float] = RATIOS,
    blade_angles: Sequence[float] = ANGLES,
    tip_machs: Sequence[float] = (),
    by: Literal["elements", "charts"] = "elements",
) -> MadePropeller:
    """Return the map of a propeller: C_P and C_T over advance ratio, blade angle and perhaps Mach number of the tips.

    Args:
        blades: Number, activity factor and design lift, for which blades are made, or blades from `read_blades`.
        advance_ratios: J, rising [-].
        blade_angles: At three quarters of the radius, rising [rad].
        tip_machs: Of the tips' rotation, rising; none: without compressibility [-].
        by: Blade elements, in every state of the stream, or the Hamilton Standard charts, where they hold.

    Source: `machines.propellers.loads`; Worobel and Mayo, NASA CR-114399 (1971).

    Raises:
        DesignError: Something is not in order, out of its range, or more than a map may hold; all of it at once.
    """
    refuse(_problems(blades, (advance_ratios, blade_angles, tip_machs), by), "propeller")
    ratios, angles = np.array(advance_ratios, dtype=float), np.array(blade_angles, dtype=float)
    if by == "charts":
        assert isinstance(blades, Blades)  # refused otherwise
        return MadePropeller(by, None, _charted(blades, ratios.tolist(), np.degrees(angles).tolist()))
    shape = generic_blade(blades) if isinstance(blades, Blades) else blades
    maps = tuple(element_map(shape, ratios, angles, float(mach)) for mach in tip_machs or (0.0,))
    chart = MachMap(np.array(tip_machs, dtype=float), maps) if len(tip_machs) else maps[0]
    return MadePropeller(by, shape, chart)


def _charted(blades: Blades, ratios: list[float], angles: list[float]) -> PropellerMap:
    try:
        return map_of(charted_map(blades, ratios, angles), "charts")
    except DesignError as error:
        message = (
            "the charts hold too few of these points for a map; take advance ratios 0 to 5 and blade angles at which"
            ' the propeller pulls, or by = "elements"'
        )
        raise DesignError([Problem("by", message), *error.problems], "propeller") from None


def _problems(blades: Blades | BladeShape, axes: tuple[Sequence[float], ...], by: str) -> list[Problem]:
    problems = charted_problems(blades) if by == "charts" else spanned(blades, _GENERIC)
    limits = (("advance_ratios", 0.0, 20.0), ("blade_angles", -math.pi / 2, math.pi / 2), ("tip_machs", 0.0, 1.0))
    for (name, low, high), axis in zip(limits, axes, strict=True):
        values = np.array(axis, dtype=float)
        if name != "tip_machs" and len(values) < 2:
            problems.append(Problem(name, f"{len(values)} of them: a map needs at least two"))
        if not np.all((values >= low) & (values <= high)):
            problems.append(Problem(name, f"all must be from {low:.4g} to {high:.4g}"))
        if not np.all(np.diff(values) > 0.0):
            problems.append(Problem(name, "each must be larger than the one before"))
    if by == "charts" and len(axes[2]):
        problems.append(Problem("tip_machs", "charts are made without compressibility; flights add it, or by elements"))
    count = len(axes[0]) * len(axes[1]) * max(len(axes[2]), 1)
    if count > MOST_POINTS:
        problems.append(Problem("advance_ratios", f"{count:,} points are more than {MOST_POINTS:,}; take fewer"))
    return problems


def _row(mach: float, chart: PropellerMap, row: int) -> RatioRow | None:
    """Return what stands out at one advance ratio; none where the propeller never pulls."""
    given = slice(int(chart.first[row]), int(chart.last[row]) + 1)
    ratio, angle = float(chart.advance_ratio[row]), chart.blade_angle[given]
    power, thrust = chart.power[row, given], chart.thrust[row, given]
    pulls = (power > 0.0) & (thrust > 0.0)
    if not pulls.any():
        return None
    taken = np.where(pulls, power, 1.0)
    merit = np.where(pulls, (thrust * ratio if ratio > 0.0 else np.maximum(thrust, 0.0) ** 1.5) / taken, -1.0)
    best = int(np.argmax(merit))
    turned = np.flatnonzero((power[:-1] < 0.0) & (power[1:] >= 0.0))
    idle = None
    if len(turned):
        k = int(turned[-1])
        part = float(-power[k] / (power[k + 1] - power[k]))
        idle = [float(table[k] + part * (table[k + 1] - table[k])) for table in (angle, thrust)]
    return RatioRow(
        mach, ratio, float(angle[best]), float(power[best]), float(thrust[best]),
        float(ratio * thrust[best] / power[best]), idle[0] if idle else None, idle[1] if idle else None,
    )  # fmt: skip


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

    Source: `machines.propellers`; the maps of `ALL_STATES` are made so.
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
