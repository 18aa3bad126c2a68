"""Propeller maps that are made: by the charts, by blade elements, or the charts carried on by elements."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Annotated, Literal

import numpy as np

from gearwright.catalogue.propellers.charts import charted_point, charted_problems, spanned
from gearwright.catalogue.propellers.maps import COLUMNS, MOST_POINTS, map_of
from gearwright.catalogue.propellers.shipped import MAPS, propeller_map
from gearwright.errors import DesignError, Problem, refuse
from gearwright.machines import Blades, MachMap, PropellerMap
from gearwright.machines.propellers import BladeShape, Feathered, continued, element_map, feathered, generic_blade
from gearwright.showing import Shown
from gearwright.units import Angle, Origin, Quantity, Ratio
from gearwright.verbs import verb

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
