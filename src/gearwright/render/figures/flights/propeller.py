"""Figure of a propeller map: C_P, C_T and efficiency over the advance ratio, a curve for each blade angle."""

from __future__ import annotations

import math

import numpy as np

from gearwright.arrays import Floats
from gearwright.machines import PropellerMap
from gearwright.render.style import theme
from gearwright.render.vector.axes import Axes
from gearwright.render.vector.figure import Figure
from gearwright.render.vector.marks import Curve

MOST_CURVES = 14
"""Blade angles that are drawn, at most, of those at which the propeller pulls somewhere."""
_FLOOR = -0.15
"""Lowest coefficient that is drawn, over the highest [-]."""


@theme.drawn
def propeller_figure(chart: PropellerMap, title: str) -> Figure:
    """Return C_P, C_T and efficiency over the advance ratio.

    Args:
        chart: The map.
        title: Of the figure.
    """
    figure = theme.sheet(theme.WIDTH, 165.0)
    power, thrust, efficiency = figure.grid(3, 1, share_x=True)[:, 0]
    columns = _pulling(chart)
    rises = np.gradient(chart.thrust, axis=1)
    for place, column in enumerate(columns):
        rows = (chart.first <= column) & (column <= chart.last)
        ratio, taken, given = chart.advance_ratio[rows], chart.power[rows, column], chart.thrust[rows, column]
        stalled = (rises[rows, column] <= 0.0) & (given > 0.0)
        taken, given = np.where(stalled, np.nan, taken), np.where(stalled, np.nan, given)
        pulls = (taken > 0.0) & (given > 0.0)
        colour = theme.CYCLE[place % len(theme.CYCLE)]
        name = f"{math.degrees(chart.blade_angle[column]):.3g}°"
        for axes, values in ((power, taken), (thrust, given)):
            axes.plot(ratio, values, color=colour, lw=0.9)
        part = np.where(pulls, ratio * given / np.where(pulls, taken, 1.0), np.nan)
        efficiency.plot(ratio, part, color=colour, lw=0.9)
        _named(efficiency, ratio, part, name)
    for axes, label in ((power, "power coefficient C_P"), (thrust, "thrust coefficient C_T")):
        highest = max((float(np.nanmax(values)) for values in _shown(axes)), default=1.0)
        axes.set(ylabel=label, ylim=(_FLOOR * highest, 1.05 * highest))
        axes.axhline(0.0, color=theme.MUTED, lw=0.6)
    efficiency.set(ylabel="efficiency", ylim=(0.0, 1.0), xlabel="advance ratio J")
    power.set_title(f"{title}, blades that are not stalled")
    return figure


def _shown(axes: Axes) -> list[Floats]:
    curves = [curve.y for curve in axes.of(Curve)]
    return [values for values in curves if not np.isnan(values).all()]


def _pulling(chart: PropellerMap) -> list[int]:
    pulls = np.flatnonzero(((chart.thrust > 0.0) & (chart.power > 0.0)).any(axis=0))
    return [int(k) for k in pulls[:: -(-len(pulls) // MOST_CURVES)]]


def _named(axes: Axes, ratio: Floats, values: Floats, name: str) -> None:
    """Write the blade angle where its curve is highest."""
    if np.isnan(values).all():
        return
    top = int(np.nanargmax(values))
    axes.annotate(name, (ratio[top], values[top]), (2, 1), fontsize=6.0, color=theme.INK)
