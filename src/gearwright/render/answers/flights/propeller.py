"""Answer about a made propeller: its blades, every advance ratio, and a point of flight; its rows are the map."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated

from gearwright.catalogue import MadePropeller, PropellerLoads, RatioRow
from gearwright.machines.propellers import activity_factor, integrated_lift
from gearwright.units import Angle, Quantity, Ratio


@dataclass(frozen=True)
class MapPoint:
    """One point of a map."""

    tip_mach: Ratio
    """0: without compressibility."""
    advance_ratio: Ratio
    blade_angle: Angle
    power_coefficient: Annotated[float, Quantity("number")]
    thrust_coefficient: Annotated[float, Quantity("number")]


@dataclass(frozen=True)
class PropellerAnswer:
    """A made propeller."""

    by: str
    """``elements`` or ``charts``."""
    blades: int | None
    """Of the elements; null of the charts."""
    activity_factor: Annotated[float | None, Quantity("number")]
    design_lift: Annotated[float | None, Quantity("number")]
    """Integrated."""
    feather_angle: Annotated[float | None, Quantity("angle")]
    """Blade angle at which it stands still; null of charts."""
    feather_drag: Annotated[float | None, Quantity("number")]
    """Drag there over dynamic pressure and D²."""
    advance_ratios: tuple[RatioRow, ...]
    """What stands out at each."""
    flight: PropellerLoads | None
    """Null where no point of flight is asked for."""
    rows: tuple[MapPoint, ...]
    """The whole map."""


def map_points(made: MadePropeller) -> Iterator[MapPoint]:
    """Yield every point of a map.

    Args:
        made: The map.
    """
    for mach, chart in made.maps:
        for row, ratio in enumerate(chart.advance_ratio):
            for column in range(int(chart.first[row]), int(chart.last[row]) + 1):
                power, thrust = float(chart.power[row, column]), float(chart.thrust[row, column])
                yield MapPoint(mach, float(ratio), float(chart.blade_angle[column]), power, thrust)


def propeller_answer(made: MadePropeller, flight: PropellerLoads | None) -> PropellerAnswer:
    """Return what `gearwright propeller --json` answers.

    Args:
        made: The map.
        flight: Loads at a point of flight, if there is one.
    """
    shape, feather = made.blades, made.feather
    return PropellerAnswer(
        by=made.by,
        blades=shape.number if shape else None,
        activity_factor=activity_factor(shape) if shape else None,
        design_lift=integrated_lift(shape) if shape else None,
        feather_angle=feather.angle if feather else None,
        feather_drag=feather.drag_area if feather else None,
        advance_ratios=made.rows,
        flight=flight,
        rows=tuple(map_points(made)),
    )
