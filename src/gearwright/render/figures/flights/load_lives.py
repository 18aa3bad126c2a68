"""S-N curves of flanks and roots with the spectrum of a flight laid on them, and Miner's part of every class."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gearwright.mission.lives import LoadLife
from gearwright.render.style import theme
from gearwright.render.vector.axes import Axes
from gearwright.render.vector.figure import Figure

SHOWN = 6
"""Flanks and roots that are drawn, the most damaged ones."""
LONGEST = 1e13
"""Load changes at which the axis ends [-]."""
LARGEST = 60.0
"""Area of the disc of a class that does all of the damage [pt²]."""
_KILO = 1e3


@theme.drawn
def load_life_figure(rows: Sequence[LoadLife], flights: float = 1.0) -> Figure:
    """Return a panel for each flank and root: what it bears, what it gets in so many flights, and where it is damaged.

    Args:
        rows: From `load_lives`, the most damaged first; the first few are drawn.
        flights: Of the life that is asked for [-].
    """
    shown = rows[:SHOWN]
    figure, grid = theme.tiles(len(shown), 3, frame=20.0, row=56.0)
    for axes, row in zip(grid.flat, shown, strict=False):
        _draw(axes, row, flights)
    for axes in grid[:, 0]:
        axes.set_ylabel("mesh force [kN]")
    for axes in grid[-1]:
        axes.set_xlabel("load changes [-]")
    figure.shared_key = 3
    return figure


def _draw(axes: Axes, row: LoadLife, flights: float) -> None:
    order = np.argsort(-row.force, kind="stable")
    force, reached = row.force[order] / _KILO, np.cumsum(row.changes[order]) * flights
    bears = (row.borne > 1.0) & (row.borne < LONGEST)
    axes.plot(row.borne[bears][::-1], row.ladder[bears][::-1] / _KILO, color=theme.ORANGE, label="borne: S-N curve")
    axes.step(
        [min(reached[0], 1.0), *reached], [force[0], *force], where="pre", color=theme.BLUE, label="asked: spectrum"
    )
    if row.total > 0.0:
        broken = np.isinf(row.damage[order])
        parts = broken.astype(float) if broken.any() else row.damage[order] / row.total
        axes.scatter(reached, force, np.maximum(LARGEST * parts, 1e-3), color=theme.BLUE, alpha=0.5,
                     label="area: its part of the damage")  # fmt: skip
    part, way = str(row.part), {"pitting": "flank", "bending": "root"}[row.mode]
    axes.set_title(f"{part} {way}: D = {row.total * flights:.2g}", fontsize=8.0)
    axes.set(xscale="log", xlim=(1e2, LONGEST), ylim=(0.0, 1.8 * float(force[0])))
